// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd stress`: a table and a verdict for each part.
#include "verification/report/report.hpp"

namespace ehd::report {

void add_stress(Page& page, const View& stress) {
  page.section("stress", "Stability under stress");
  if (!stress.exists()) {
    page.absent("Stress tables (stress.json) are", "ehd stress --output DIR");
    return;
  }
  const auto parts = stress.list("parts");
  Table overview;
  overview.columns = {"part", "what", "question", "verdict", "in numbers", "time [s]"};
  for (const View& part : parts)
    overview.rows.push_back({{"(" + escaped(part.text("id")) + ")", ""},
                             words(part.text("name")),
                             {escaped(part.text("question")), "wide"},
                             verdict_cell(part.text("verdict")),
                             {escaped(part.text("summary")), "wide"},
                             number_cell(part.number("wall_s"), 3)});
  page.add(overview);
  for (const View& part : parts) {
    const auto rows = part.list("rows"), failures = part.list("failures");
    page.heading("(" + escaped(part.text("id")) + ") " + escaped(part.text("name")) + ": " +
                 escaped(part.text("verdict")));
    page.paragraph(escaped(part.text("question")) + " " + escaped(part.text("summary")));
    if (const View tolerance = part["tolerance"]; tolerance.exists()) {
      std::string text = "Tolerance " + tolerance.cell("value", 3) + ", " + tolerance.text("basis");
      if (const auto reason = tolerance.text("reason"); !reason.empty()) text += ": " + reason;
      page.paragraph(escaped(text) + ".");
    }
    for (const View& failure : failures)
      page.add("<div class=\"claim\"><p>" + escaped(failure.text()) + "</p></div>\n");
    Table table;
    table.first_is_heading = false;
    for (const View& column : part.list("columns"))
      table.columns.push_back(escaped(column.text("name")) +
                              (column.text("unit").empty() ? "" : " [" + escaped(column.text("unit")) + "]"));
    for (const View& row : rows) {
      std::vector<TableCell> cells;
      for (const View& cell : row.list()) {
        constexpr int digits = 5;
        const std::string text = cell.cell(digits);
        const bool number = !text.empty() && text.find_first_not_of("0123456789.-+e") == std::string::npos;
        cells.push_back({escaped(text), number ? "number" : slug(text)});
      }
      table.rows.push_back(std::move(cells));
    }
    constexpr std::size_t short_table = 40;
    if (rows.size() > short_table)
      page.add_folded(std::to_string(rows.size()) + " rows", table);
    else if (!rows.empty())
      page.add(table);
  }
}

}  // namespace ehd::report
