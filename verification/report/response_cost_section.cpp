// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd bench`, continued: what a frequency of a contact costs, and a bearing's motion beside its
// balance.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

/// Above the cost of a frequency, below the error that it achieves, over L; a curve for each load and tolerance. The
/// certified solver has no achieved error and is left to the table.
Figure cost_figure(const std::vector<View>& rows) {
  Figure figure{.id = "fig-response-cost",
                .title = "Cost of a frequency over L",
                .description = "Cost of one frequency in convolutions, and its achieved error, over L."};
  Panel cost{.x = {.label = "lubricant group *L*"},
             .y = {.label = "time of a frequency [*c*]", .scale = Scale::logarithmic}},
      achieved{.x = {.label = "lubricant group *L*"},
               .y = {.label = "achieved error of *\u03ba*", .scale = Scale::logarithmic}};
  cost.x.silent = true;
  std::map<std::string, std::size_t> curves;
  for (const View& row : rows) {
    const auto time = row.number("frequency_s"), c = row.number("c_s"), error = row.number("achieved");
    const auto L = row.number("L");
    if (!L || !time || !c || !error || !(*time > 0) || !(*error > 0)) continue;
    const std::string name = fmt::format("M = {}, to {}", row.cell("M"), row.cell("tolerance", 2));
    const auto [at, added] = curves.try_emplace(name, cost.series.size());
    if (added) {
      const Look look = look_of_curve(at->second);
      Series curve{.name = literal(name), .line = look.line, .marker = look.marker, .colour = look.colour};
      cost.series.push_back(curve);
      curve.of = std::exchange(curve.name, "");
      achieved.series.push_back(std::move(curve));
    }
    cost.series[at->second].x.push_back(*L);
    cost.series[at->second].y.push_back(*time / *c);
    achieved.series[at->second].x.push_back(*L);
    achieved.series[at->second].y.push_back(*error);
  }
  figure.panels = {std::move(cost), std::move(achieved)};
  return figure;
}

/// Without a line the panel shows no more than the table.
bool shows_a_line(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& one) { return one.x.size() > 1; });
}

Table frequency_table(const std::vector<View>& rows) {
  Table table;
  table.columns = {"solver",    "<i>M</i>",         "<i>L</i>",   "tolerance", "intervals", "steady [ms]",
                   "slow [ms]", "a frequency [ms]", "[<i>c</i>]", "stated",    "achieved",  "status"};
  for (const View& row : rows) {
    const auto time = row.number("frequency_s"), c = row.number("c_s");
    table.rows.push_back({words(row.text("solver")), number_cell(row.number("M")), number_cell(row.number("L")),
                          number_cell(row.number("tolerance"), 2), integer_cell(row.number("nodes")),
                          milliseconds_cell(row.number("steady_s")), milliseconds_cell(row.number("slow_s")),
                          milliseconds_cell(time), number_cell(time && c ? std::optional(*time / *c) : std::nullopt, 3),
                          number_cell(row.number("stated"), 2), number_cell(row.number("achieved"), 2),
                          verdict_cell(row.text("status"))});
  }
  return table;
}

}  // namespace

void add_response_cost(Page& page, const View& bench) {
  page.heading("Motion");
  const View result = bench["response"];
  if (!result.exists()) {
    page.absent("The cost of stiffness and damping is", "ehd bench --part response --output DIR");
    return;
  }
  const auto rows = result.list("frequencies");
  Figure figure = cost_figure(rows);
  if (shows_a_line(figure.panels.front())) {
    page.begin_fold("Cost of a frequency beyond the steady state, and the error that it achieves");
    page.begin_figures();
    page.figure(std::move(figure),
                "Processor time of one more frequency, in <i>c</i>, and the largest error of <i>\u03ba</i> against the "
                "certified solver; Roelands, flooded.");
    page.end_figures();
    page.end_fold();
  }
  page.add_folded("All costs as a table", frequency_table(rows));
  Table table;
  table.caption = "Stiffness and damping of a bearing, law ehd, beside its balance: processor time";
  table.columns = {"bearing", "contact solves", "responses", "balance [ms]", "with motion [ms]", "ratio"};
  for (const View& row : result.list("bearings")) {
    const auto balance = row.number("balance_s"), dynamic = row.number("dynamic_s");
    table.rows.push_back({words(row.text("bearing")), integer_cell(row.number("contact_solves")),
                          integer_cell(row.number("responses")), milliseconds_cell(balance), milliseconds_cell(dynamic),
                          number_cell(balance && dynamic ? std::optional(*dynamic / *balance) : std::nullopt, 3)});
  }
  page.add(table);
}

}  // namespace ehd::report
