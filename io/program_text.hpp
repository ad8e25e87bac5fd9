// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as programs read them back, and parts of tables that are written as a program's source.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ehd {

/// The shortest text that tells a number from every other: 0.1, 2, 1e+06.
[[nodiscard]] std::string shortest(double value);
/// A double as C and MATLAB read it back exactly: 0.1, 2.0, 1e-07.
[[nodiscard]] std::string exact_number(double value);
/// "{0.1, 2.0}".
[[nodiscard]] std::string braced(const std::vector<double>& values);
/// Each byte that is no letter or digit becomes an underscore: "own_moes_20_10".
[[nodiscard]] std::string identifier(std::string_view text);
/// A line for a C comment: blanks part what would end the comment or seem to begin another.
[[nodiscard]] std::string in_c_comment(const std::string& text);
/// Every PREFIX replaced.
[[nodiscard]] std::string with_prefix(std::string text, const std::string& prefix);
/// Where a file comes from: "ehd 0.1.0, commit 0123abc, 2026-01-31T12:00:00Z".
[[nodiscard]] std::string made_by();

}  // namespace ehd
