// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd stress`: a table and a verdict for each part.
#include <fmt/format.h>

#include <cstdlib>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

/// The rows of a part, as its columns name them.
Table rows_of(const View& part) {
  Table table;
  table.first_is_heading = false;
  for (const View& column : part.list("columns"))
    table.columns.push_back(escaped(column.text("name")) +
                            (column.text("unit").empty() ? "" : " [" + escaped(column.text("unit")) + "]"));
  for (const View& row : part.list("rows")) {
    std::vector<TableCell> cells;
    for (const View& cell : row.list()) {
      constexpr int digits = 5;
      const std::string text = cell.cell(digits);
      const bool number = !text.empty() && text.find_first_not_of("0123456789.-+e") == std::string::npos;
      // A number, or a text that is one.
      char* end = nullptr;
      const double value = number ? std::strtod(text.c_str(), &end) : 0;
      const bool whole = number && *end == '\0';
      cells.push_back(whole ? number_cell(value, digits) : TableCell{escaped(text), number ? "number" : slug(text)});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Tolerance, failures and rows of a part.
std::string details_of(const View& part) {
  std::string text;
  if (const View tolerance = part["tolerance"]; tolerance.exists()) {
    const std::string reason = tolerance.text("reason");
    text += "<p>" +
            escaped(fmt::format("Tolerance {}, {}{}", tolerance.cell("value", 3), tolerance.text("basis"),
                                reason.empty() ? "" : ": " + reason)) +
            ".</p>\n";
  }
  for (const View& failure : part.list("failures"))
    text += "<div class=\"claim\"><p>" + escaped(failure.text()) + "</p></div>\n";
  const Table table = rows_of(part);
  return table.rows.empty() ? text : text + html(table);
}

}  // namespace

void add_stress(Page& page, const View& stress) {
  page.section("stress", "Stability under stress", "Stress");
  if (!stress.exists()) {
    page.absent("Stress tables (stress.json) are", "ehd stress --output DIR");
    return;
  }
  page.paragraph("The name of a part opens its rows.");
  Table table;
  table.columns = {"part", "question", "verdict", "in numbers", "time [s]"};
  for (const View& part : stress.list("parts")) {
    const std::string name = fmt::format("({}) {}", escaped(part.text("id")), escaped(part.text("name")));
    const Opener opener = page.opener("stress-" + part.text("id"), name, "Rows of " + name, details_of(part));
    table.rows.push_back({{opener.link, ""},
                          {escaped(part.text("question")), "wide"},
                          verdict_cell(part.text("verdict")),
                          {escaped(part.text("summary")), "wide"},
                          number_cell(part.number("wall_s"), 3)});
    table.below.push_back(opener.fold);
  }
  page.add(table);
}

}  // namespace ehd::report
