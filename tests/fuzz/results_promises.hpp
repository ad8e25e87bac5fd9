// SPDX-License-Identifier: GPL-3.0-or-later
// What the report promises of ANY results.json: a refusal in one line, or a page that runs no script but its own.
#pragma once

#include <string>
#include <string_view>

#include "contact/text.hpp"
#include "tests/files.hpp"
#include "verification/report/report.hpp"

namespace ehd::verification::promises {

inline std::string results_broken(std::string_view bytes) {
  static const test::Folder folder;
  (void)folder.write("results.json", bytes);
  std::string page;
  try {
    page = report::report_html(report::read_documents(folder.path()));
  } catch (const report::ReportError& refusal) {
    constexpr std::size_t longest_message = 1000;
    const std::string message = refusal.what();
    if (one_line(message) != message) return "the refusal is not one line of printable text: " + one_line(message);
    return message.size() > longest_message ? "the refusal is longer than a screen" : "";
  }
  std::size_t scripts = 0;
  for (std::size_t at = page.find("<script"); at != std::string::npos; at = page.find("<script", at + 1)) ++scripts;
  if (scripts != 1) return "the page has " + std::to_string(scripts) + " scripts";
  if (!page.ends_with("</html>\n")) return "the page is cut";
  return "";
}

}  // namespace ehd::verification::promises
