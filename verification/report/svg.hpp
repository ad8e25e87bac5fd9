// SPDX-License-Identifier: GPL-3.0-or-later
// Text for SVG and HTML: escaping, numbers as coordinates, and a small markup for symbols.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ehd::report {

/// For text and for attributes in double quotes, of HTML and of XML: & < > " ' as entities; invalid UTF-8 becomes
/// U+FFFD, control characters that XML forbids become a space.
[[nodiscard]] std::string escaped(std::string_view text);

/// A coordinate, to a hundredth of a pixel: "12.5". Throws std::logic_error where it is not finite: a plot leaves such
/// points out before it draws.
[[nodiscard]] std::string pixels(double value);

/// The hyphens of a number become true minus signs.
[[nodiscard]] std::string with_minus_sign(const std::string& number);
/// A number as people read it: `digits` significant ones, a true minus sign, below 0.001 and where it is large a power
/// of ten: 2.5 10^{-5} (markup).
[[nodiscard]] std::string number_markup(double value, int digits = 4);

/// The markup of labels: *P* in italics, _{H} and ^{-3} below and above the line; a backslash before * _ ^ \ keeps the
/// character. Text from a file goes through literal() first.
[[nodiscard]] std::string literal(std::string_view text);
[[nodiscard]] std::string markup_to_svg(std::string_view markup);   ///< content of a <text>
[[nodiscard]] std::string markup_to_html(std::string_view markup);  ///< <i>, <sub>, <sup>
[[nodiscard]] std::string markup_to_text(std::string_view markup);  ///< for titles and read-outs, not escaped

/// The width of a label in a sans-serif type of that size, within about 10 %, so that legend entries do not overlap.
[[nodiscard]] double text_width(std::string_view markup, double size);

/// Where a picture stands: in the page, with the page's style sheet and read-out; or in a file of its own, white, with
/// its style inside.
enum class Place { page, file };

/// A whole picture: the <svg> element around `content`, with title and description for those who cannot see it. In
/// a file of its own it carries its style (literal colours: not every program knows CSS variables).
struct Picture {
  std::string id;
  std::string title, description;      ///< plain text
  double width = 0, height = 0;        ///< pixels at full size
  std::vector<std::string> axes = {};  ///< markup; columns of the data that the page saves, where no frame names them
};
[[nodiscard]] std::string picture(const Picture& frame, const std::string& content, Place place);

/// CSS rules of pictures, in CSS variables; the page puts them into its style sheet.
[[nodiscard]] std::string picture_style();
/// The variables: light, and dark.
[[nodiscard]] std::string light_colours();
[[nodiscard]] std::string dark_colours();

}  // namespace ehd::report
