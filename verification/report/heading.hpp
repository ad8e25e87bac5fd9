// SPDX-License-Identifier: GPL-3.0-or-later
// Headings of figures: bold, in as many lines as the figure's width asks for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ehd::report {

/// The width in pixels of a heading in DejaVu Sans Bold at 12 pixels, rounded up. Of the types that may draw a heading
/// this one is the widest; a bare Debian has no other one. Markup.
[[nodiscard]] double heading_width(std::string_view markup);

/// The lines of a heading, each at most `width` pixels wide. A heading for which two lines are enough is broken after
/// a comma, semicolon or colon, if it has one in the right place; else lines are broken between words, and a word that
/// is wider than a line is broken inside. Symbols in italics, below or above the line stay whole. Markup.
[[nodiscard]] std::vector<std::string> heading_lines(const std::string& markup, double width);

/// A heading at the left of a figure.
struct Heading {
  std::string svg;
  double more = 0;  ///< pixels that its lines after the first take
};
/// `width`: of the figure; `baseline`: of the first line.
[[nodiscard]] Heading heading_of(const std::string& markup, double width, double baseline);

}  // namespace ehd::report
