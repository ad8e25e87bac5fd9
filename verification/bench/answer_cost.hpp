// SPDX-License-Identifier: GPL-3.0-or-later
// What the answers that users ask for cost: films to a tolerance, many contacts, a bearing, the whole process. In ms,
// and in c, the time of one padded convolution of 512 intervals in the same run, since machines differ.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// One answer, asked of one or many contacts.
struct AnswerCost {
  std::string asked;              ///< "H_cen alone to 1e-6"
  std::string of;                 ///< which contacts: "box, L <= 15"
  std::vector<double> seconds;    ///< processor time of each contact, bearing or process; of a later solve
  std::size_t not_converged = 0;  ///< of them
  long solves = 0;                ///< contact solves behind it
  double c_s = 0;                 ///< one padded convolution of 512 intervals, timed beside
  std::string why = {};           ///< where nothing was measured
};

struct AnswerCostRequest {
  const RegisteredSolver* solver = nullptr;  ///< the box and the many contacts; a bearing and a process use the default
  bool quick = false;                        ///< a few contacts of each
  double time_limit_s = 30;
  Repetition repetition = {.least = 3, .least_s = 0.005, .enough_s = 0.5, .most = 200};
  std::string program = {};  ///< path of `ehd` for the whole process; empty: not asked
  std::function<void(const std::string&)> progress = {};
};

/// The box has both law sets, M 0.05 ... 5000, L 0 ... 30, cut and flooded; the many contacts M 0.5 ... 1000, L 0 ...
/// 20, Roelands, flooded; the bearing is NA4908 with three clearances and its usual laws. Throws CaseError where the
/// bearing's files are missing.
[[nodiscard]] std::vector<AnswerCost> run_answer_costs(const AnswerCostRequest& request);

[[nodiscard]] Json to_json(const std::vector<AnswerCost>& rows);
[[nodiscard]] std::string human_table(const std::vector<AnswerCost>& rows);

}  // namespace ehd::verification
