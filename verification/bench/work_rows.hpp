// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the work-precision benchmark, and what follows from them: the quickest run at an error, ratios of times,
// crossovers, and how many achieved errors the reported ones cover.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/enum_words.hpp"
#include "contact/solution.hpp"
#include "verification/bench/setting.hpp"

namespace ehd::verification {

/// From this many times the error of the truth on, an achieved error is a number; below, it is a bound.
inline constexpr double truth_margin = 10;
/// Two solvers whose times are divided at equal error.
struct ComparedSolvers {
  std::string solver, over;
  [[nodiscard]] std::string name() const { return solver + "/" + over; }
};
/// The certified solver and every other FFT solver, each over the default solver.
[[nodiscard]] std::vector<ComparedSolvers> compared_solvers();

/// Judged are the films, and the pressure as a function (L2, relative, over the interval that both cover).
enum class Judged { film_minimum, film_central, pressure };
inline constexpr auto all_judged = all_words<Judged>;
[[nodiscard]] std::string_view to_string(Judged judged);  ///< "film.minimum", "film.central", "pressure"

/// The true error lies between |achieved - truth| and achieved + truth.
struct AchievedError {
  std::optional<double> reported = {};  ///< by the solver; none of the pressure
  std::optional<double> achieved = {};  ///< against the truth, relative
  double truth = 0;                     ///< error that the truth states, relative
  /// The error is at most `level`, even with the error of the truth.
  [[nodiscard]] bool within(double level) const { return achieved && *achieved + truth <= level; }
  /// The error is above `level`, whatever the error of the truth.
  [[nodiscard]] bool beyond(double level) const { return achieved && *achieved - truth > level; }
  /// The achieved error as a number, where the truth is known well enough; else its upper bound.
  [[nodiscard]] std::optional<double> known() const {
    return achieved && *achieved >= truth_margin * truth ? achieved : std::nullopt;
  }
  [[nodiscard]] std::optional<double> bound() const {
    return achieved && !known() ? std::optional(*achieved + truth) : std::nullopt;
  }
  [[nodiscard]] std::string words() const;  ///< "2.1e-6", "<6.7e-6", "-"
};

/// undecided: nothing is reported or judged, or the truth is not known well enough.
enum class Covered { yes, no, undecided };
[[nodiscard]] Covered covered(const AchievedError& error);

struct WorkRow {
  std::string case_id;
  Setting setting;
  std::optional<StopReason> status = {};     ///< none: not run
  std::string reason = {};                   ///< why it did not run, or did not converge
  std::vector<double> wall_s = {};           ///< of each cold solve
  Cost cost = {};                            ///< of the first
  std::array<AchievedError, 3> errors = {};  ///< by Judged
  [[nodiscard]] bool converged() const { return status == StopReason::converged; }
  [[nodiscard]] const AchievedError& error(Judged judged) const { return errors[static_cast<std::size_t>(judged)]; }
  [[nodiscard]] AchievedError& error(Judged judged) { return errors[static_cast<std::size_t>(judged)]; }
};

/// The solution that the runs of a case are judged by.
struct Truth {
  std::string case_id;
  std::string solver;
  double tolerance = 0;                   ///< asked of the solver
  std::optional<StopReason> status = {};  ///< none: no usable solution
  std::string reason = {};
  std::array<double, 2> value = {};  ///< films, Hertz units
  std::array<double, 3> error = {};  ///< by Judged, relative: films as stated; pressure from two runs (see solve_truth)
  double wall_s = 0;
  /// |value - the case's own digits|, relative, where the case has some.
  std::array<std::optional<double>, 2> from_digits = {};
  std::array<double, 2> digits_uncertainty = {};
};

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
  bool rises = false;  ///< `over`, whose time divides, is ahead at the tighter level
};
[[nodiscard]] std::optional<Crossover> crossover(const std::vector<Ratio>& by_level);

/// Errors reported against errors achieved, of all rows of one solver that report an error, converged or not.
struct Coverage {
  std::string solver;
  int yes = 0, no = 0, undecided = 0;
  std::optional<double> median_excess = {};  ///< reported over achieved, of the decided ones
  std::optional<double> worst_excess = {};   ///< the smallest
};
[[nodiscard]] Coverage coverage(const std::vector<WorkRow>& rows, const std::string& solver, Judged judged);

}  // namespace ehd::verification
