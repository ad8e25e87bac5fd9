// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's statements (a) to (d) about its figures, judged with computed numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workflow/bearing_run.hpp"

namespace ehd::verification {

/// The laws with films: each is compared with Hertz' dry law.
[[nodiscard]] std::vector<bearing::Law> film_laws();

/// The balance by a law; nullptr where the results have none.
[[nodiscard]] const BearingResult* balance_by(bearing::Law law, const std::vector<BearingResult>& results);

/// The same bearing at one clearance with the dry law and an EHD law.
struct ClearanceComparison {
  double clearance_m = 0;
  BearingResult dry, film;
};

/// Inner force and displacement of the roller nearest to psi = 0.
[[nodiscard]] double top_force_N(const BearingResult& result);
[[nodiscard]] double top_approach_m(const BearingResult& result);

/// A statement of the paper beside the computed numbers. The paper speaks of distributions over psi: `holds` is judged
/// by every roller. The roller at psi = 0 alone is judged beside it.
struct PaperStatement {
  char letter = 'a';
  std::string statement = {};  ///< as judged here, in one sentence
  bool holds = false;
  std::optional<bool> holds_at_top =
      {};  ///< by the roller at psi = 0 alone; absent for (d), which is about two rollers
  std::string numbers = {};
  std::vector<std::pair<std::string, bool>> parts = {};  ///< where a statement says two things
  /// Relative changes, EHD against dry, at psi = 0: "change" of (a), "least" and "most" of (b), "middle" and "largest"
  /// clearance of (c).
  /// Of whole distributions:
  /// "apart" of (a) and (c): the largest change of any roller's load over the largest dry load; (c) at the middle
  ///   clearance.
  /// "loaded" of (b): delta_i of each roller that the dry law loads is smaller by at least this.
  /// "outside_m": delta_i of the other rollers is larger by at most this [m].
  std::vector<std::pair<std::string, double>> values = {};

  /// By name; absent where the statement has none of that name.
  [[nodiscard]] std::optional<bool> part(std::string_view name) const;
  [[nodiscard]] std::optional<double> value(std::string_view name) const;
};
inline constexpr char statement_letters[] = {'a', 'b', 'c', 'd'};
/// By letter; nullptr where it was not judged.
[[nodiscard]] const PaperStatement* find_statement(const std::vector<PaperStatement>& statements, char letter);

/// The paper's words as numbers. "EHD is close to Hertz" (c): the roller load at psi = 0 changes by at most this
/// fraction, and no roller's load by more than this fraction of the largest dry load. "Considerably smaller" (b):
/// smaller by at least this fraction, at psi = 0 and at every roller that the dry law loads.
inline constexpr double close_load = 0.02, considerably = 0.10;
/// "Similar" (a): no roller's load changes by more than this fraction of the largest dry load. The paper gives no
/// number. Curves further apart than a fifth of the figure's scale would not look similar.
inline constexpr double similar_load = 0.20;

/// (a)..(d) from at least three clearances of one bearing; empty where a balance is missing.
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

/// "holds", "does not hold", "does not hold; at psi = 0 alone it does".
[[nodiscard]] std::string verdict_of(const PaperStatement& statement);
/// The same for a cell of a table: "holds", "no", "at 0".
[[nodiscard]] std::string cell_of(const PaperStatement& statement);

/// The lengths x_0 for which the statements hold, as lists of closed ranges. x_0 is scanned from `lowest_m` to
/// `highest_m` in steps of a factor `step`, and each end of a range is found by bisection to a factor `precision`.
/// Ranges narrower than a step may be missed. No scan (half_width_m = 0) where the dry law has no balance or no load.
struct DatumScan {
  double half_width_m = 0;  ///< of the heaviest dry contact; below about half of it there is no law
  double lowest_m = 0, highest_m = 0, step = 0, precision = 0;
  using Ranges = std::vector<std::pair<double, double>>;
  Ranges balanced_m;  ///< where the law has a balance at every clearance
  Ranges a_m, b_m, c_m, d_m;
  Ranges b_at_top_m, c_at_top_m;   ///< judged at psi = 0 alone
  Ranges a_similar_m, a_lower_m;   ///< the two halves of (a)
  Ranges c_close_m, c_opposite_m;  ///< the two halves of (c), the first one at psi = 0 alone
  Ranges abc_m;                    ///< (a), (b) and (c)
  Ranges all_hold_m;               ///< (a) to (d)
  Ranges at_top_m;                 ///< (a) to (d), each judged at psi = 0 alone
  /// Least and largest "apart" of (a) at the judged lengths in at_top_m, to compare with `similar_load`.
  std::optional<std::pair<double, double>> apart_there = {};
  /// (a) to (d); (b) at psi = 0, and "close" in (c) read as closer there than at the other two clearances.
  Ranges all_hold_mildly_m;
};
/// "0.15 to 0.61 mm", with a note where the scan ends or the law has no balance beyond; "nowhere".
[[nodiscard]] std::string words_of(const DatumScan& scan, const DatumScan::Ranges& ranges, int digits = 3);
[[nodiscard]] DatumScan scan_datum(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory,
                                   bearing::Form form = bearing::Form::plane,
                                   bearing::Law dry_law = bearing::Law::hertz);

/// True where the case names the paper as its source.
[[nodiscard]] bool is_of_the_paper(const Case& one);
/// True where the cases are one bearing at different clearances.
[[nodiscard]] bool differ_only_in_clearance(const std::vector<Case>& cases);

[[nodiscard]] std::string human_statements(const std::vector<PaperStatement>& statements);
[[nodiscard]] std::string human_data(const std::vector<DatumRow>& rows, const DatumScan& scan);

}  // namespace ehd::verification
