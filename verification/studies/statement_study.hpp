// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper's statements (a)..(d) depend on. The paper leaves choices open: one at a time is changed, and the
// statements are judged again. Films do not depend on the datum, so another datum costs no contact solve.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

/// The choices that the paper leaves open, in the order of the rows that change them.
inline constexpr std::array<std::string_view, 10> open_choices{"viscosity",     "alpha",     "density", "K_Hertz",
                                                               "fit direction", "fit range", "datum",   "rotating ring",
                                                               "unloading",     "length"};

/// One choice changed, and the statements judged with it.
struct StudyRow {
  std::string factor;  ///< "as the case", one of open_choices, or "two choices"
  std::string value;   ///< with its unit
  bearing::Law law = bearing::Law::ehd_linear;
  std::vector<PaperStatement> statements;  ///< empty where a balance is missing
  std::string why;                         ///< why a balance is missing
  std::optional<DatumScan> scan = {};      ///< of the rows that do not change the datum
};

/// `cases`: one bearing at three or more clearances (differ_only_in_clearance) with a lubricant. For both EHD laws:
/// the case as it is; viscosity over a decade about its own, at the same alpha; alpha from half to 1.75 times its own;
/// every other density law; every other dry law in the place of `hertz`; the line fitted to delta over f;
/// the fit from .3, 1, 2 and 4 kN (scaled to the case's own range) to its end; Palmgren met at a fifth, half and 1.2 of
/// the fit's end, Lundberg, x_0 = R_i/4, R_i and 20 mm; the other ring turning; ehd-linear cut at delta = 0; lengths of
/// .122 and .018 m at the same load. Last, two choices at once where one alone changes little: a thick oil, or another
/// length, with a short x_0. `progress` hears after each row how many there are, and will be.
[[nodiscard]] std::vector<StudyRow> study_statements(
    const std::vector<Case>& cases, ContactMemory& memory,
    const std::function<void(std::size_t done, std::size_t all)>& progress = {});

/// In how many of a law's rows with one choice changed a statement holds.
struct StudySummary {
  bearing::Law law = bearing::Law::ehd_linear;
  char letter = 'a';
  int holds = 0, of = 0;
  std::string exceptions = {};    ///< the minority: the rows in which it fails, or those in which it holds
  std::string at_top_alone = {};  ///< the rows in which it holds at psi = 0 alone
};
[[nodiscard]] std::vector<StudySummary> summarise(const std::vector<StudyRow>& rows);

[[nodiscard]] Json to_json(const std::vector<StudyRow>& rows);
[[nodiscard]] std::string human_study(const std::vector<StudyRow>& rows);

}  // namespace ehd::verification
