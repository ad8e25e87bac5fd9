// SPDX-License-Identifier: GPL-3.0-or-later
// What motion costs beyond the steady state: a frequency of a contact beside the error that it achieves, and the
// stiffness and damping of a bearing beside its balance. In ms, and in c, the time of one padded convolution of 512
// intervals in the same run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/bench/timing.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// One solver and tolerance at one contact. Times are processor time of later solves.
struct FrequencyCost {
  std::string solver;
  BoxContact contact;
  double tolerance = 0;
  StopReason status = StopReason::diverged;
  double steady_s = 0;     ///< the solver's steady solve to the same tolerance
  double slow_s = 0;       ///< its response without a frequency: steady states, kappa_0 and kappa_1
  double frequency_s = 0;  ///< each further frequency
  double c_s = 0;          ///< one padded convolution of 512 intervals, timed beside
  int nodes = 0;           ///< of the finest grid
  double stated = 0;       ///< largest stated error of kappa at the frequencies, relative
  /// Largest error of kappa at the frequencies against the certified solver, relative; absent for that solver itself.
  std::optional<double> achieved = {};
};

/// The law ehd of a bearing at 0 Hz, from the case to its result.
struct DynamicBearingCost {
  std::string bearing;
  double balance_s = 0, dynamic_s = 0;  ///< without and with stiffness and damping
  long contact_solves = 0, responses = 0;
  double c_s = 0;
};

struct ResponseCost {
  std::vector<FrequencyCost> frequencies;
  std::vector<DynamicBearingCost> bearings;
};

struct ResponseCostRequest {
  bool quick = false;  ///< one contact, one bearing
  double time_limit_s = 30;
  Repetition repetition = {.least = 3, .least_s = 0.02, .enough_s = 0.3, .most = 50};
  std::function<void(const std::string&)> progress = {};
};

/// Roelands with Dowson and Higginson's density, flooded: M = 20 and 200, L = 2.5 ... 20. Every solver that has a
/// response. Throws CaseError where a bearing's file is missing.
[[nodiscard]] ResponseCost run_response_costs(const ResponseCostRequest& request);

[[nodiscard]] Json to_json(const ResponseCost& cost);
[[nodiscard]] std::string human_table(const ResponseCost& cost);

}  // namespace ehd::verification
