// SPDX-License-Identifier: GPL-3.0-or-later
// Work against precision: what each solver takes for the error that it achieves, held against a truth that is known
// at least ten times better.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

// -- rows -------------------------------------------------------------------------------------------------------

/// What is judged: the films, and the pressure as a function (L2, relative, over the interval that both cover).
enum class Judged { film_minimum, film_central, pressure };
inline constexpr Judged all_judged[] = {Judged::film_minimum, Judged::film_central, Judged::pressure};
[[nodiscard]] std::string_view to_string(Judged judged);  ///< "film.minimum", "film.central", "pressure"

/// The true error lies between |achieved - truth| and achieved + truth.
struct AchievedError {
  std::optional<double> reported = {};  ///< by the solver; none of the pressure
  std::optional<double> achieved = {};  ///< against the truth, relative
  double truth = 0;                     ///< stated error of the truth, relative
  /// Known to be at most `level`.
  [[nodiscard]] bool within(double level) const { return achieved && *achieved + truth <= level; }
};

enum class Covered {
  yes,
  no,
  undecided
};  ///< undecided: nothing is reported or judged, or the truth is not known well enough
[[nodiscard]] Covered covered(const AchievedError& error);

/// A solver, with what is asked of it.
struct Setting {
  std::string solver;
  std::optional<double> tolerance = {};
  std::optional<int> nodes = {};
  [[nodiscard]] std::string text() const;  ///< "1e-3", "n = 1024"
};

struct WorkRow {
  std::string case_id;
  Setting setting;
  std::optional<StopReason> status = {};     ///< none: not run
  std::string reason = {};                   ///< where it did not run, or did not end as converged
  std::vector<double> wall_s = {};           ///< of each cold solve
  Cost cost = {};                            ///< of the first
  std::array<AchievedError, 3> errors = {};  ///< by Judged
  [[nodiscard]] bool converged() const { return status == StopReason::converged; }
  [[nodiscard]] const AchievedError& error(Judged judged) const { return errors[static_cast<std::size_t>(judged)]; }
  [[nodiscard]] AchievedError& error(Judged judged) { return errors[static_cast<std::size_t>(judged)]; }
};

/// What a case is judged by.
struct Truth {
  std::string case_id;
  std::string title;
  double tolerance = 0;                   ///< asked of `reference`
  std::optional<StopReason> status = {};  ///< none: no usable solution
  std::string reason = {};
  std::array<double, 2> value = {};  ///< films, Hertz units
  std::array<double, 3> error = {};  ///< by Judged, relative: films as stated; pressure from two runs (see solve_truth)
  double wall_s = 0;
  std::array<std::optional<double>, 2> from_digits =
      {};  ///< |value - the case's own digits|, relative, where it has some
  std::array<double, 2> digits_uncertainty = {};
};

// -- what follows from the rows ---------------------------------------------------------------------------------

/// The quickest converged row of a solver at a case whose error is known to be at most `level`; null where none is.
[[nodiscard]] const WorkRow* quickest(const std::vector<WorkRow>& rows, const std::string& case_id,
                                      const std::string& solver, Judged judged, double level);

/// Time of one solver over that of another at one error level.
struct Ratio {
  double level = 0;
  double value = 0;
};
/// Where both have a row, by falling level.
[[nodiscard]] std::vector<Ratio> ratios(const std::vector<WorkRow>& rows, const std::string& case_id,
                                        const std::string& solver, const std::string& over, Judged judged,
                                        const std::vector<double>& levels);

/// The first two levels between which the ratio goes through 1; ratios between 0.8 and 1.25 are ties and do not count.
struct Crossover {
  double looser = 0, tighter = 0;
  bool rises = false;  ///< the solver below the line (`over`) is ahead at the tighter level
};
[[nodiscard]] std::optional<Crossover> crossover(const std::vector<Ratio>& by_level);

/// Errors reported against achieved: of every row of one solver that reports one, whether it met its tolerance or not.
struct Coverage {
  std::string solver;
  int yes = 0, no = 0, undecided = 0;
  std::optional<double> median_excess = {};  ///< reported over achieved, of the decided ones
  std::optional<double> worst_excess = {};   ///< the smallest
};
[[nodiscard]] Coverage coverage(const std::vector<WorkRow>& rows, const std::string& solver, Judged judged);

// -- the run ----------------------------------------------------------------------------------------------------

struct WorkPrecisionRequest {
  std::vector<Case> cases;  ///< lubricated contacts, see contacts_named
  std::vector<const RegisteredSolver*> solvers;
  bool quick = false;        ///< fewer tolerances and grids
  double time_limit_s = 30;  ///< for each solve
  Repetition repetition = {};
  std::function<void(const std::string&)> progress = {};
};

/// The cases of a full run, and of a quick one.
[[nodiscard]] std::vector<std::string> work_precision_cases(bool quick);
/// What is asked of a solver: tolerances, then grids.
[[nodiscard]] std::vector<Setting> settings_of(const RegisteredSolver& solver, bool quick);
/// The error levels at which times are compared, falling.
[[nodiscard]] std::vector<double> error_levels(Judged judged);

struct WorkPrecisionResult {
  std::vector<Truth> truths;
  std::vector<WorkRow> rows;
  std::vector<std::string> solvers;
  /// CPU time over wall time of the whole run, which is one thread: well below 1, others were at work and the times are
  /// too long by an unknown factor.
  double cpu_share = 1;
  [[nodiscard]] bool anything_judged() const;
};

/// Reads cases by id or file; throws CaseError for one that cannot be read or is no lubricated contact.
[[nodiscard]] std::vector<Case> contacts_named(const std::vector<std::string>& names);

/// One thread, and the rows of a case take
/// turns, so that a machine that slows down does so for all of them.
[[nodiscard]] WorkPrecisionResult run_work_precision(const WorkPrecisionRequest& request);

[[nodiscard]] Json to_json(const WorkPrecisionResult& result);
[[nodiscard]] std::string work_precision_csv(const WorkPrecisionResult& result);
[[nodiscard]] std::string human_table(const WorkPrecisionResult& result);

}  // namespace ehd::verification
