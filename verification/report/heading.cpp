// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heading.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "contact/text.hpp"
#include "verification/report/shapes.hpp"
#include "verification/report/svg.hpp"

namespace ehd::report {

namespace {

constexpr double heading_font = 12, heading_left = 8, heading_step = 16;  // pixels

/// Hundredths of the type size that the characters from ' ' to '~' take in DejaVu Sans Bold, rounded up.
constexpr std::array<int, 95> bold_widths{
    35, 46, 53, 84, 70, 101, 88, 31,  46,  46, 53, 84, 38, 42, 38, 37, 70, 70, 70, 70, 70, 70,  70, 70,
    70, 70, 40, 40, 84, 84,  84, 59,  100, 78, 77, 74, 84, 69, 69, 83, 84, 38, 38, 78, 64, 100, 84, 86,
    74, 86, 78, 73, 69, 82,  78, 111, 78,  73, 73, 46, 37, 46, 84, 50, 50, 68, 72, 60, 72, 68,  44, 72,
    72, 35, 35, 67, 35, 105, 72, 69,  72,  72, 50, 60, 48, 72, 66, 93, 65, 66, 59, 72, 37, 72,  84,
};
constexpr int other_width = 110;  // the letters of all but a few languages

/// Pieces of markup that stay whole: a character, or all that stands in italics, below or above the line.
std::vector<std::string> pieces_of(const std::string& markup) {
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < markup.size();) {
    const char c = markup[at];
    std::size_t end = at + std::max<std::size_t>(1, utf8_length(std::string_view(markup).substr(at)));
    if (c == '\\') {
      end = at + 2;
    } else if (c == '*') {
      end = markup.find('*', at + 1);
      end += end == std::string::npos ? 0 : 1;
    } else if ((c == '_' || c == '^') && end < markup.size() && markup[end] == '{') {
      end = markup.find('}', at);
      end += end == std::string::npos ? 0 : 1;
    }
    end = std::min(end, markup.size());
    pieces.push_back(markup.substr(at, end - at));
    at = end;
  }
  return pieces;
}

/// Broken after the comma, semicolon or colon that leaves the shortest lines, if both fit.
std::optional<std::vector<std::string>> two_clauses(const std::vector<std::string>& pieces, double width) {
  std::optional<std::vector<std::string>> best;
  double widest = width;
  std::string first;
  for (std::size_t k = 0; k + 2 < pieces.size(); ++k) {
    first += pieces[k];
    if ((pieces[k] != "," && pieces[k] != ";" && pieces[k] != ":") || pieces[k + 1] != " ") continue;
    std::string second;
    for (std::size_t i = k + 2; i < pieces.size(); ++i) second += pieces[i];
    const double longer = std::max(heading_width(first), heading_width(second));
    if (!(longer <= widest)) continue;
    widest = longer;
    best = {first, second};
  }
  return best;
}

}  // namespace

double heading_width(std::string_view markup) {
  const std::string text = markup_to_text(markup);
  int hundredths = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(rest));
    const auto place = static_cast<std::size_t>(static_cast<unsigned char>(rest.front()) - ' ');
    hundredths += length == 1 && place < bold_widths.size() ? bold_widths[place] : other_width;
    rest.remove_prefix(length);
  }
  return heading_font / 100 * hundredths;
}

std::vector<std::string> heading_lines(const std::string& markup, double width) {
  if (markup.empty()) return {};
  if (heading_width(markup) <= width) return {markup};
  const std::vector<std::string> pieces = pieces_of(markup);
  if (auto lines = two_clauses(pieces, width)) return *lines;
  std::vector<std::string> lines;
  std::string line, word;  // the word after the line: it may not fit
  const auto end_line = [&] {
    if (!line.empty()) lines.push_back(line);
    line.clear();
  };
  const auto end_word = [&] {
    line += (line.empty() || word.empty() ? "" : " ") + word;
    word.clear();
  };
  for (const std::string& piece : pieces) {
    if (piece == " ") {
      end_word();
      continue;
    }
    if (!line.empty() && heading_width(line + " " + word + piece) > width) end_line();
    if (!word.empty() && heading_width(word + piece) > width) {
      end_word();
      end_line();
    }
    word += piece;
  }
  end_word();
  end_line();
  return lines;
}

Heading heading_of(const std::string& markup, double width, double baseline) {
  Heading heading;
  for (const std::string& line : heading_lines(markup, width - 2 * heading_left)) {
    if (!heading.svg.empty()) heading.more += heading_step;
    heading.svg += text_svg({heading_left, baseline + heading.more}, line, "start", "head");
  }
  return heading;
}

}  // namespace ehd::report
