// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd bench`: time against achieved error, ratios at equal error, scaling, batches.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

struct Quantity {
  const char* key;
  const char* label;
};
constexpr Quantity quantities[] = {
    {"film.minimum", "error of *H*_{min}"}, {"film.central", "error of *H*_{cen}"}, {"pressure", "error of *P* (L2)"}};

/// Time over achieved error of one case and quantity. Each run by tolerance or by grid is a mark; a line a solver joins
/// the runs that no other run of the solver beats in both time and error.
Panel precision_panel(const View& bench, const std::vector<View>& rows, const std::string& id, const Quantity& quantity,
                      std::size_t& failed) {
  Panel panel;
  panel.x = {.label = quantity.label + std::string(", relative"), .scale = Scale::logarithmic};
  panel.y = {.label = "time [s]", .scale = Scale::logarithmic};
  for (const View& named : bench["work_precision"].list("solvers")) {
    const std::string solver = named.text();
    struct WorkRun {
      double error, time;
      bool bound;
    };
    std::vector<WorkRun> runs;
    for (const View& row : rows) {
      if (row.text("case") != id || row.text("solver") != solver) continue;
      const auto achieved = row[quantity.key].number("achieved"), time = row["cost"].number("wall_s");
      if (row.text("status") != "converged") {
        ++failed;
        continue;
      }
      if (!achieved || !time || !(*time > 0)) continue;
      // An achieved error that is only a bound is drawn hollow, not below the error of the truth.
      const double truth = row[quantity.key].number("truth_error").value_or(0);
      const bool bound = row[quantity.key].flag("bound_only").value_or(false);
      runs.push_back({std::max({*achieved, bound ? truth : 0.0, 1e-16}), *time, bound});
    }
    std::sort(runs.begin(), runs.end(), [](const WorkRun& a, const WorkRun& b) { return a.error > b.error; });
    const Look look = look_of_solver(bench, solver);
    Series line{.line = look.line, .marker = Marker::none, .colour = look.colour, .of = literal(solver)};
    Series marks{.name = literal(solver),
                 .line = Line::none,
                 .marker = look.marker,
                 .colour = look.colour,
                 .key_line = look.line};
    for (std::size_t i = 0; i < runs.size(); ++i) {
      marks.x.push_back(runs[i].error);
      marks.y.push_back(runs[i].time);
      marks.hollow_at.push_back(runs[i].bound);
      const bool undercut = std::any_of(runs.begin() + static_cast<std::ptrdiff_t>(i) + 1, runs.end(),
                                        [&](const WorkRun& other) { return other.time <= runs[i].time; });
      if (undercut) continue;
      line.x.push_back(runs[i].error);
      line.y.push_back(runs[i].time);
    }
    if (marks.x.empty()) continue;
    panel.series.push_back(std::move(line));
    panel.series.push_back(std::move(marks));
  }
  return panel;
}

void add_failed(Page& page, const std::vector<View>& rows) {
  Table table;
  table.columns = {"case", "solver", "asked", "status", "reason"};
  for (const View& row : rows) {
    if (row.text("status") == "converged") continue;
    const std::string asked = row.has("nodes") ? "n = " + row.cell("nodes") : row.cell("tolerance", 3);
    table.rows.push_back({words(row.text("case")),
                          words(row.text("solver")),
                          words(asked),
                          verdict_cell(row.text("status")),
                          {escaped(row.text("reason")), "wide"}});
  }
  if (!table.rows.empty()) page.add_folded(std::to_string(table.rows.size()) + " not converged, or not run", table);
}

void add_ratios(Page& page, const View& result) {
  const auto equal = result.list("at_equal_error");
  std::vector<std::string> cases, names;
  for (const View& entry : equal) {
    if (std::find(cases.begin(), cases.end(), entry.text("case")) == cases.end()) cases.push_back(entry.text("case"));
    for (const auto& [name, ratio] : entry["ratios"].members()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  if (names.empty()) return;
  page.heading("Times at equal achieved error");
  page.begin_figures();
  for (const std::string& name : names) {
    for (const Quantity& quantity : quantities) {
      Figure figure{
          .id = "fig-ratio-" + name + "-" + quantity.key,
          .title = "Ratio of times " + name + " at equal error of " + quantity.key,
          .description =
              "Time of the first solver over that of the second, over the error that both achieve; a curve a case."};
      Panel panel;
      panel.title = literal(name);
      panel.x = {.label = quantity.label + std::string(" achieved by both"), .scale = Scale::logarithmic};
      panel.y = {.label = "ratio of times", .scale = Scale::logarithmic};
      for (std::size_t k = 0; k < cases.size(); ++k) {
        const Look look = look_of_curve(k);
        Series series{.name = literal(cases[k]), .line = look.line, .marker = look.marker, .colour = look.colour};
        for (const View& entry : equal) {
          if (entry.text("case") != cases[k] || entry.text("quantity") != quantity.key) continue;
          const auto ratio = entry["ratios"].number(name), level = entry.number("level");
          if (!ratio || !level) continue;
          series.x.push_back(*level);
          series.y.push_back(*ratio);
        }
        if (!series.x.empty()) panel.series.push_back(std::move(series));
      }
      if (panel.series.empty()) continue;
      panel.rules.push_back({1, "equal"});
      figure.panels.push_back(std::move(panel));
      page.figure(std::move(figure), "Time of the quickest run that achieves the error: <b>" + escaped(name) +
                                         "</b>; above 1 the second solver is ahead.");
    }
  }
  page.end_figures();

  Table table;
  table.caption = "Ratios of times at equal achieved error";
  table.columns = {"case", "quantity", "error"};
  for (const auto& name : names) table.columns.push_back(escaped(name));
  for (const View& entry : equal) {
    if (!entry.has("ratios")) continue;
    std::vector<TableCell> row{words(entry.text("case")), words(entry.text("quantity")),
                               number_cell(entry.number("level"), 3)};
    for (const auto& name : names) row.push_back(number_cell(entry["ratios"].number(name), 3));
    table.rows.push_back(std::move(row));
  }
  page.add_folded("All ratios as a table", table);
}

void add_coverage(Page& page, const View& result) {
  const auto coverage = result.list("coverage");
  if (coverage.empty()) return;
  Table table;
  table.caption = "Errors reported against errors achieved";
  table.columns = {"solver", "quantity", "covered", "missed", "undecided", "reported/achieved, median", "smallest"};
  for (const View& one : coverage) {
    const auto missed = one.number("missed");
    table.rows.push_back({words(one.text("solver")),
                          words(one.text("quantity")),
                          integer_cell(one.number("covered")),
                          {integer_cell(missed).html, missed.value_or(0) > 0 ? "number fail" : "number"},
                          integer_cell(one.number("undecided")),
                          number_cell(one.number("median_excess"), 3),
                          number_cell(one.number("smallest_excess"), 3)});
  }
  page.add(table);
}

void add_scaling(Page& page, const View& bench) {
  const auto rows = bench.list("scaling");
  if (rows.empty()) {
    page.absent("Scaling is", "ehd bench --part scaling --output DIR");
    return;
  }
  page.heading("Scaling");
  struct Shown {
    const char* key;
    const char* label;
    const char* what;
    double factor;
  };
  constexpr Shown shown[] = {{"wall_s", "time [s]", "Time of a cold solve", 1},
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
      const std::string name = row.text("solver") + ", M = " + row.cell("M") + ", L = " + row.cell("L");
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

void add_work_precision(Page& page, const View& bench) {
  page.section("work-precision", "Work and precision");
  if (!bench.exists()) {
    page.absent("Times against achieved errors (bench.json) are", "ehd bench --output DIR");
    return;
  }
  const View result = bench["work_precision"];
  if (result.exists()) {
    std::string note =
        "Time of a cold solve over the error that it achieves against a truth at least ten times better; lower left is "
        "better. Every mark is a run, by "
        "tolerance or by grid; the line joins the runs that no other run of the same solver beats in both. Hollow: the "
        "error is a bound, the truth is known no better.";
    if (const auto share = result.number("cpu_share"))
      note += " The process had " + markup_to_html(number_markup(100 * *share, 3)) + "\u2009% of a core.";
    page.paragraph(note);
    const auto rows = result.list("rows");
    page.begin_figures();
    for (const View& truth : result.list("truths")) {
      for (const Quantity& quantity : quantities) {
        std::size_t failed = 0;
        Figure figure{.id = "fig-work-" + truth.text("case") + "-" + quantity.key,
                      .title = "Work and precision: " + truth.text("case") + ", " + quantity.key,
                      .description =
                          "Time of a solve over its achieved relative error, a curve a solver, both axes logarithmic."};
        Panel panel = precision_panel(bench, rows, truth.text("case"), quantity, failed);
        if (panel.series.empty()) continue;
        panel.title = literal(truth.text("case"));
        figure.panels.push_back(std::move(panel));
        page.figure(
            std::move(figure),
            "<b>" + escaped(truth.text("case")) + "</b>, " + escaped(quantity.key) +
                "; truth: " + escaped(truth.text("solver")) +
                (truth[quantity.key].has("error")
                     ? ", to " + markup_to_html(number_markup(*truth[quantity.key].number("error"), 2))
                     : "") +
                (failed > 0 ? "; " + std::to_string(failed) +
                                  (failed == 1 ? " run did not converge and is" : " runs did not converge and are") +
                                  " not drawn"
                            : "") +
                ".");
      }
    }
    page.end_figures();
    add_failed(page, rows);
    add_ratios(page, result);
    add_coverage(page, result);
  } else {
    page.absent("Work against precision is", "ehd bench --part work-precision --output DIR");
  }
  add_scaling(page, bench);
  add_batch(page, bench.list("batch"));
}

}  // namespace ehd::report
