// SPDX-License-Identifier: GPL-3.0-or-later
// What the films of several runs of one case are compared with, where nobody has measured a truth beforehand.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/array.hpp"
#include "verification/bench/work_rows.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification {

/// A run to be judged. Films stand in the order of judged_films.
struct JudgedRun {
  double tolerance = 0;
  ContactRun run;
  AchievedError films[2] = {};
};

/// One truth for both films: the case's own digits, or one solution.
struct FilmTruth {
  double value[2] = {};                  ///< Hertz units
  double error[2] = {};                  ///< relative: the digits' uncertainty, or what the solution states
  std::string words[2] = {};             ///< which it is
  std::string solver = {};               ///< of the solution; empty for digits
  Array X = {};                          ///< its nodes
  bool is(const ContactRun& run) const;  ///< the run is this solution: the same solver on the same nodes
};

/// The case's own digits where it has some of both films; of several, those with the smallest uncertainty. Else the
/// solution that states the smallest error, among the runs and `one_more` (called in this case alone). Absent where
/// there is neither.
[[nodiscard]] std::optional<FilmTruth> film_truth(const Case& contact_case, const std::vector<JudgedRun>& runs,
                                                  const std::function<JudgedRun()>& one_more);

/// Fills in the achieved errors of a run. A run that is the truth itself has no achieved error.
void judge(JudgedRun& run, const FilmTruth& truth);

}  // namespace ehd::verification
