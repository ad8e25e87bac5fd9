// SPDX-License-Identifier: GPL-3.0-or-later
// The law of one raceway for another program: as CSV, JSON, C99, and a function of MATLAB and Octave.
#pragma once

#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/law_export.hpp"

namespace ehd {

/// A sentence or two a line: case, datum, speed, oil, range, and the errors of law and table. For a human, and for the
/// comments of the files.
[[nodiscard]] std::vector<std::string> law_export_words(const LawExport& law);

/// Comment lines that begin with #, a header line, and a line for each knot.
[[nodiscard]] std::string law_export_csv(const LawExport& law);
/// {"schema": "ehd-law-1", "provenance", "case", "version", "title", "raceway", "law", "datum_x0_m", "contact",
/// "lubricant", "range_N", "balance_N", "errors", "knots"}.
[[nodiscard]] Json to_json(const LawExport& law);

/// C99, data and evaluator; needs math.h alone.
[[nodiscard]] std::string law_export_c(const LawExport& law);
/// A function file, NAME.m, of MATLAB (R2016b on) and Octave.
[[nodiscard]] std::string law_export_matlab(const LawExport& law);
/// "ehd_na4908_inner": the beginning of the names in C, and with "_law" the function of MATLAB.
[[nodiscard]] std::string law_export_prefix(const LawExport& law);

}  // namespace ehd
