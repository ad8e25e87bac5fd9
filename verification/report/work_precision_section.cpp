// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd bench`: time against achieved error, in the manner of the SciML benchmarks (error to the right,
// time upwards, both logarithmic, a line a solver, failures as rows), and ratios of times at equal error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

struct Quantity {
  const char* key;
  const char* label;
};
constexpr Quantity quantities[] = {
    {"film.minimum", "error of *H*_{min}"}, {"film.central", "error of *H*_{cen}"}, {"pressure", "error of *P* (L2)"}};

constexpr double milli_s = 1e-3;  // [s]

/// The same times in c, the time of one convolution in that run, on the right.
void add_yardstick(Panel& panel, const View& bench) {
  const double c_ms = bench["work_precision"].number("c_s").value_or(0) / milli_s;
  if (!(c_ms > 0)) return;
  std::vector<double> times;
  for (const Series& series : panel.series) times.insert(times.end(), series.y.begin(), series.y.end());
  const Range range = range_of(times, Scale::logarithmic);
  panel.y.low = range.low;
  panel.y.high = range.high;
  panel.right =
      Axis{.label = "time [*c*]", .scale = Scale::logarithmic, .low = range.low / c_ms, .high = range.high / c_ms};
}

/// Time over achieved error of one case and quantity. Each run by tolerance or by grid is a mark; a line a solver joins
/// the runs that no other run of the solver beats in both time and error.
Panel precision_panel(const View& bench, const std::vector<View>& rows, const std::string& id, const Quantity& quantity,
                      std::size_t& failed) {
  Panel panel;
  panel.x = {.label = quantity.label + std::string(", relative"), .scale = Scale::logarithmic};
  panel.y = {.label = "time [ms]", .scale = Scale::logarithmic};
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
      runs.push_back({std::max({*achieved, bound ? truth : 0.0, 1e-16}), *time / milli_s, bound});
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
  add_yardstick(panel, bench);
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
  if (!table.rows.empty()) page.add_folded(fmt::format("{} not converged, or not run", table.rows.size()), table);
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
  page.begin_fold("Ratios of times over the error");
  page.begin_figures();
  for (const std::string& name : names) {
    for (const Quantity& quantity : quantities) {
      Figure figure{
          .id = fmt::format("fig-ratio-{}-{}", name, quantity.key),
          .title = fmt::format("Ratio of times {} at equal error of {}", name, quantity.key),
          .description =
              "Time of the first solver over that of the second, over the error that both achieve; a curve a case."};
      Panel panel;
      panel.title = literal(fmt::format("{}, {}", name, quantity.key));
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
  page.end_fold();

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
  double missed = 0;
  table.columns = {"solver", "quantity", "covered", "missed", "undecided", "reported/achieved, median", "smallest"};
  for (const View& one : coverage) {
    const auto own = one.number("missed");
    missed += own.value_or(0);
    table.rows.push_back({words(one.text("solver")),
                          words(one.text("quantity")),
                          integer_cell(one.number("covered")),
                          {integer_cell(own).html, own.value_or(0) > 0 ? "number fail" : "number"},
                          integer_cell(one.number("undecided")),
                          number_cell(one.number("median_excess"), 3),
                          number_cell(one.number("smallest_excess"), 3)});
  }
  page.add_folded(fmt::format("Errors stated against errors achieved: {} missed", plain(missed)), table);
}

/// The three figures of a case, HTML.
std::string case_figures(Page& page, const View& bench, const std::vector<View>& rows, const View& truth) {
  std::string html;
  const std::string id = truth.text("case");
  for (const Quantity& quantity : quantities) {
    std::size_t failed = 0;
    Figure figure{
        .id = fmt::format("fig-work-{}-{}", id, quantity.key),
        .title = fmt::format("Work and precision: {}, {}", id, quantity.key),
        .description = "Time of a solve over its achieved relative error, a curve a solver, both axes logarithmic."};
    figure.width = 360;  // three side by side
    Panel panel = precision_panel(bench, rows, id, quantity, failed);
    if (panel.series.empty()) continue;
    panel.title = literal(fmt::format("{}, {}", id, quantity.key));
    figure.panels.push_back(std::move(panel));
    std::string caption =
        fmt::format("<b>{}</b>, {}; truth: {}", escaped(id), escaped(quantity.key), escaped(truth.text("solver")));
    if (const auto error = truth[quantity.key].number("error"))
      caption += ", to " + markup_to_html(number_markup(*error, 2));
    if (failed > 0)
      caption += fmt::format("; {}{} not drawn", failed,
                             failed == 1 ? " run did not converge or was not run, and is"
                                         : " runs did not converge or were not run, and are");
    html += page.figure_html(std::move(figure), caption + ".");
  }
  return html;
}

/// Time of the quickest run of a solver that keeps the error of the smallest film below the level.
std::optional<double> quickest(const View& result, const std::string& id, const std::string& solver, double level) {
  constexpr double same = 1e-6;
  for (const View& entry : result.list("at_equal_error")) {
    if (entry.text("case") != id || entry.text("quantity") != "film.minimum" ||
        !(std::abs(entry.number("level").value_or(0) / level - 1) < same))
      continue;
    for (const View& one : entry.list("quickest"))
      if (one.text("solver") == solver) return one.number("wall_s");
  }
  return std::nullopt;
}

/// A row a case; its figures are below it.
void add_cases(Page& page, const View& bench, const std::vector<View>& rows) {
  constexpr double levels[] = {1e-3, 1e-5};
  const View result = bench["work_precision"];
  const auto solvers = result.list("solvers");
  Table table;
  table.caption =
      "Quickest run of each solver with an error of <i>H</i><sub>min</sub> of at most 10<sup>\u22123</sup>, and of at "
      "most 10<sup>\u22125</sup> [ms]; the name opens the case's figures";
  table.columns = {"case"};
  for (const View& solver : solvers) table.columns.push_back("<code>" + escaped(solver.text()) + "</code>");
  for (const View& truth : result.list("truths")) {
    const std::string id = truth.text("case"), figures = case_figures(page, bench, rows, truth);
    const Opener opener = page.opener("work-of-" + id, escaped(id), "Figures of " + escaped(id),
                                      "<div class=\"figures trio\">" + figures + "</div>");
    std::vector<TableCell> row{{opener.link, "name"}};
    for (const View& solver : solvers) {
      std::string times;
      for (const double level : levels) {
        const auto time = quickest(result, id, solver.text(), level);
        times += (times.empty() ? "" : ", ") + (time ? milliseconds_in_full(*time, 2) : "\u2013");
      }
      row.push_back({times, "number"});
    }
    table.rows.push_back(std::move(row));
    table.below.push_back(opener.fold);
  }
  page.add(table);
}

}  // namespace

void add_work_precision(Page& page, const View& bench) {
  page.section("work-precision", "Work and precision", "Work");
  if (!bench.exists()) {
    page.absent("Times against achieved errors (bench.json) are", "ehd bench --output DIR");
    return;
  }
  const View result = bench["work_precision"];
  if (result.exists()) {
    std::string note =
        "Each mark is a cold solve, asked for a tolerance or given a grid: its time, and the error that it achieves. "
        "Lower left is better. The line of a solver joins the runs that none of its other runs beats in both time and "
        "error. The truth is at least ten times more accurate than a filled mark; of a hollow mark only a bound of the "
        "error is known.";
    if (const auto share = result.number("cpu_share"))
      note += " The process had " + percent_cell(share).html + " of a core.";
    if (const auto c = result.number("c_s"))
      note += " <i>c</i> = " + markup_to_html(number_markup(*c * micro, 3)) +
              " \u00b5s, the time of one convolution on 512 intervals in the same run.";
    page.paragraph(note);
    const auto rows = result.list("rows");
    add_cases(page, bench, rows);
    add_failed(page, rows);
    add_ratios(page, result);
    add_coverage(page, result);
  } else {
    page.absent("Work against precision is", "ehd bench --part work-precision --output DIR");
  }
  add_answer_cost(page, bench);
  add_scaling(page, bench);
  add_response_cost(page, bench);
}

}  // namespace ehd::report
