// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of ehd stress: what each measures (run_…) and how that is judged (judge_…). Measuring and judging are apart so
// that a verdict can be shown to fail on rows that are wrong.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/solver.hpp"
#include "verification/registry.hpp"
#include "verification/stress/stress.hpp"

namespace ehd::verification::stress {

/// What is kept of a solve: the two films (Hertz units) that a tolerance is about, with their stated relative errors.
struct Ended {
  StopReason status = StopReason::diverged;
  std::string reason = {};
  long iterations = 0;
  double wall_s = 0;
  bool finite = true;  ///< every reading, place, error and node value
  std::optional<double> film[2] = {}, error[2] = {};
  [[nodiscard]] bool has_films() const { return film[0] && film[1] && error[0] && error[1]; }
};
inline constexpr Quantity films[] = {Quantity::film_minimum, Quantity::film_central};
[[nodiscard]] Ended ended(const Solution& solution);
/// Largest difference of the two films over the sum of their stated errors; NaN where a film or an error is missing.
[[nodiscard]] double over_stated_errors(const Ended& one, const Ended& other);
/// p_H of a contact stated by groups, with the alpha of oil(); 0 at L = 0.
[[nodiscard]] double hertz_pressure_Pa(const Groups& groups);
inline constexpr double highest_pressure_Pa = 4e9;  ///< above, a contact is a numerical test
[[nodiscard]] std::string law_name(bool roelands);
/// "M = 20, L = 10, Roelands"
[[nodiscard]] std::string contact_name(const MoesGroups& moes, bool roelands);
/// Numbers that do not depend on the library, unlike std::uniform_real_distribution.
class Draw {
 public:
  explicit Draw(unsigned seed);
  ~Draw();
  Draw(const Draw&) = delete;
  Draw& operator=(const Draw&) = delete;
  [[nodiscard]] double uniform(double from, double to);
  [[nodiscard]] double logarithmic(double from, double to);
  /// 0 … count - 1
  [[nodiscard]] int index(int count);

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

// (a) -- the box of loads and materials, by both solvers -----------------------------------------------------------
struct BoxPoint {
  bool roelands = false;
  double M = 0, L = 0, p_H_Pa = 0;
  Ended reference = {}, fast = {};
};
[[nodiscard]] std::vector<BoxPoint> run_box(const Scope& scope);
[[nodiscard]] Part judge_box(const std::vector<BoxPoint>& points);

// (h) -- the same bits again --------------------------------------------------------------------------------------
struct RepeatRow {
  std::string solver = {}, request = {};
  long contacts = 0, converged = 0;
  long same_again = 0;        ///< a second run in one thread
  long same_in_two = 0;       ///< two threads
  long same_in_process = 0;   ///< another process
};
[[nodiscard]] std::vector<RepeatRow> run_repeats(const Scope& scope);
[[nodiscard]] Part judge_repeats(const std::vector<RepeatRow>& rows);

}  // namespace ehd::verification::stress
