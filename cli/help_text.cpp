// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/help_text.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "io/tables.hpp"

namespace ehd::cli {

namespace {

/// Names in lists begin here.
constexpr std::size_t name_column = 2;

bool is_too_wide(const std::string& line) { return line.size() > widest_table; }

/// "Usage: ", "Parts: ", "Exit code: ": one word and a colon, with a capital; or two.
bool begins_paragraph(const std::string& line) {
  const auto colon = line.find(':'), ends = line.find_first_of(" .,(");
  return line.starts_with("Exit code:") || (colon < ends && line.front() >= 'A' && line.front() <= 'Z');
}

/// Where the second column of a list begins: after the first gap of two blanks, which may begin the line. 0 without
/// one.
std::size_t second_column(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  if (first > name_column) return std::min(first, line.size());
  const auto gap = line.find("  ", first);
  return gap == std::string::npos ? 0 : std::min(line.find_first_not_of(' ', gap), line.size());
}

std::string page_of(const std::vector<std::string>& paragraph) {
  std::string whole, all;
  for (const std::string& line : paragraph) {
    whole += line + "\n";
    all += (all.empty() ? "" : " ") + line;
  }
  return std::any_of(paragraph.begin(), paragraph.end(), is_too_wide) ? wrapped(all, "") : whole;
}

}  // namespace

std::string help_page(const std::string& text) {
  std::string page;
  std::vector<std::string> paragraph;
  const auto end_paragraph = [&] {
    page += page_of(paragraph);
    paragraph.clear();
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool listed = line.empty() || line.front() == ' ';
    if (listed || begins_paragraph(line)) end_paragraph();
    if (!listed)
      paragraph.push_back(line);
    else
      page += second_column(line) > 0 ? wrapped(line, std::string(second_column(line), ' ')) : line + "\n";
  }
  end_paragraph();
  return page;
}

}  // namespace ehd::cli
