// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's statements (a) to (d) about its figures, judged with computed numbers.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workflow/bearing_run.hpp"

namespace ehd::verification {

/// The same bearing at one clearance with the dry law and an EHD law.
struct ClearanceComparison {
  double clearance_m = 0;
  BearingResult dry, film;
};

/// Inner force and displacement of the roller nearest to psi = 0.
[[nodiscard]] double top_force_N(const BearingResult& result);
[[nodiscard]] double top_approach_m(const BearingResult& result);

/// A statement of the paper beside the computed numbers.
struct PaperStatement {
  char letter = 'a';
  std::string statement;  ///< as judged here, in one sentence
  bool holds = false;
  std::string numbers;
  std::vector<std::pair<std::string, bool>> parts = {};  ///< where a statement says two things
  /// Relative changes (EHD against dry) at psi = 0: "change" of (a), "least" and "most" of (b), "middle" and "largest"
  /// clearance of (c). "apart" of (a): the largest change of any roller's load over the largest dry load.
  std::vector<std::pair<std::string, double>> values = {};
};

/// Readings of words: "EHD is close to Hertz" (c) is within this fraction of the roller load at psi = 0, and
/// "considerably smaller" (b) is smaller by at least the second. The numbers stand beside every verdict.
inline constexpr double close_load = 0.02, considerably = 0.10;
/// "Similar" (a): no roller's load changes by more than this fraction of the largest dry load. The paper gives no
/// number; a reader of the figure would not call curves similar that are further apart than a fifth of its scale.
inline constexpr double similar_load = 0.20;

/// (a)..(d) from at least three clearances of one bearing; absent where a balance is missing.
[[nodiscard]] std::vector<PaperStatement> judge_paper_statements(std::vector<ClearanceComparison> clearances);

/// The statements under one datum. Films do not depend on the datum, so no contact is solved for it.
struct DatumRow {
  std::string datum;
  std::vector<ClearanceComparison> clearances;
  std::vector<PaperStatement> statements;
};
/// `law`: ehd-linear or ehd. The named data: palmgren, lundberg, x0 = 20, 2.5, 1 and 0.5 mm.
[[nodiscard]] std::vector<DatumRow> compare_data(const std::vector<Case>& cases, bearing::Law law,
                                                 ContactMemory& memory, bearing::Form form = bearing::Form::plane);

/// The lengths x_0 for which the statements hold, scanned from `lowest_m` to `highest_m` in steps of a factor `step`,
/// each end refined by bisection until it is known to a factor `precision`: lists of closed ranges, empty where there
/// is none. What is narrower than a step may be missed. No scan (half_width_m = 0) where the dry law has no balance or
/// no load.
struct DatumScan {
  double half_width_m = 0;  ///< of the heaviest dry contact; below about half of it there is no law
  double lowest_m = 0, highest_m = 0, step = 0, precision = 0;
  using Ranges = std::vector<std::pair<double, double>>;
  Ranges balanced_m;  ///< where the law has a balance at every clearance
  Ranges a_m, b_m, c_m, d_m;
  Ranges a_similar_m, a_lower_m;   ///< the two halves of (a)
  Ranges c_close_m, c_opposite_m;  ///< the two halves of (c)
  Ranges abc_m;                    ///< (a), (b) and (c)
  Ranges all_hold_m;               ///< (a) to (d)
  Ranges sign_of_a_m;              ///< (b), (c), (d) and the second half of (a): its threshold is this project's
  /// Least and largest of what "similar" is judged by over the lengths judged in sign_of_a_m: what its threshold
  /// decides.
  std::optional<std::pair<double, double>> apart_there = {};
  Ranges all_hold_mildly_m;  ///< (a) to (d), "close" in (c) read as closer than at the other two clearances
};
/// "0.15 to 0.61 mm", with a word where an end is the scan's own or the law's; "nowhere".
[[nodiscard]] std::string words_of(const DatumScan& scan, const DatumScan::Ranges& ranges, int digits = 3);
[[nodiscard]] DatumScan scan_datum(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory,
                                   bearing::Form form = bearing::Form::plane);

/// True where the cases are one bearing at different clearances.
[[nodiscard]] bool differ_only_in_clearance(const std::vector<Case>& cases);

[[nodiscard]] std::string human_statements(const std::vector<PaperStatement>& statements);
[[nodiscard]] std::string human_data(const std::vector<DatumRow>& rows, const DatumScan& scan);

}  // namespace ehd::verification
