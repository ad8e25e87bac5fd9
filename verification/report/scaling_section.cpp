// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd bench`, continued: cost over the size of the grid, and many contacts in threads.
#include <fmt/format.h>

#include <map>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

void add_curves_of_size(Page& page, const View& bench, const std::vector<View>& rows) {
  struct Shown {
    const char* key;
    const char* label;
    const char* what;
    double factor;
  };
  constexpr Shown shown[] = {{"wall_s", "time [ms]", "Time of a cold solve", 1e3},
                             {"ns_per_n_log2_n", "time / (*n* log_{2}*n*) [ns]",
                              "Time over n log2 n: level where the cost is that of a transform", 1},
                             {"time_per_unit", "time per work unit / one convolution",
                              "Time of a work unit in padded convolutions of that size", 1},
                             {"peak_bytes", "peak memory [MB]", "Peak memory", 1e-6}};
  page.begin_figures();
  for (const Shown& one : shown) {
    Figure figure{.id = std::string("fig-scaling-") + one.key,
                  .title = std::string(one.what) + " over the number of intervals",
                  .description = one.what};
    Panel panel;
    panel.x = {.label = "intervals *n*", .scale = Scale::logarithmic};
    panel.y = {.label = one.label, .scale = Scale::logarithmic};
    std::map<std::string, std::size_t> at;
    std::map<std::string, int> of_solver;
    for (const View& row : rows) {
      const auto n = row.number("nodes_asked"), value = row.number(one.key);
      if (!n || !value || row.text("status") != "converged") continue;
      const std::string name = fmt::format("{}, M = {}, L = {}", row.text("solver"), row.cell("M"), row.cell("L"));
      if (!at.contains(name)) {
        Look look = look_of_solver(bench, row.text("solver"));
        if (of_solver[row.text("solver")]++ > 0) look.line = Line::solid;
        at[name] = panel.series.size();
        panel.series.push_back({.name = literal(name),
                                .line = look.line,
                                .marker = look.marker,
                                .colour = look.colour,
                                .hollow = look.line == Line::solid});
      }
      panel.series[at[name]].x.push_back(*n);
      panel.series[at[name]].y.push_back(*value * one.factor);
    }
    if (panel.series.empty()) continue;
    figure.panels.push_back(std::move(panel));
    page.figure(std::move(figure), escaped(one.what) + ".");
  }
  page.end_figures();
}

void add_batch(Page& page, const std::vector<View>& rows) {
  if (rows.empty()) return;
  Table table;
  table.caption = "Many contacts, one solve a thread";
  table.columns = {"solver", "tolerance", "contacts", "converged", "threads", "time [s]", "speed-up", "same results"};
  for (const View& row : rows)
    table.rows.push_back({words(row.text("solver")),
                          number_cell(row.number("tolerance"), 3),
                          integer_cell(row.number("problems")),
                          integer_cell(row.number("converged")),
                          integer_cell(row.number("threads")),
                          number_cell(row.number("wall_s"), 3),
                          number_cell(row.number("speed_up"), 3),
                          {row.flag("same_results").value_or(false) ? "bit for bit" : "<b>differ</b>",
                           row.flag("same_results").value_or(false) ? "" : "fail"}});
  page.add(table);
}

}  // namespace

void add_scaling(Page& page, const View& bench) {
  page.heading("Scaling");
  const auto rows = bench.list("scaling");
  if (rows.empty()) {
    page.absent("Scaling is", "ehd bench --part scaling --output DIR");
  } else {
    page.begin_fold("Time, time a work unit and memory over the number of intervals");
    add_curves_of_size(page, bench, rows);
    page.end_fold();
  }
  add_batch(page, bench.list("batch"));
}

}  // namespace ehd::report
