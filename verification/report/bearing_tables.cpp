// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/bearing_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

void add_statements(Page& page, const std::vector<View>& statements) {
  page.heading("The paper's statements");
  if (statements.empty()) {
    page.absent("The paper's statements with their verdicts are", "ehd verify --output DIR");
    return;
  }
  Table table;
  table.columns = {"letter", "law", "statement", "verdict", "in numbers"};
  std::size_t false_ones = 0;
  for (const View& one : statements) {
    const auto holds = one.flag("holds");
    false_ones += holds.value_or(true) ? 0 : 1;
    const bool at_top_alone = !holds.value_or(true) && one.flag("holds_at_psi_0").value_or(false);
    // A statement that does not hold is a result, not a failure of the program.
    table.rows.push_back({{"(" + escaped(one.text("letter")) + ")", ""},
                          words(one.text("law")),
                          {escaped(one.text("statement")), "wide"},
                          {holds ? (*holds         ? "holds"
                                    : at_top_alone ? "<b>does not hold</b>; at <i>\u03c8</i> = 0 alone it does"
                                                   : "<b>does not hold</b>")
                                 : "",
                           ""},
                          {escaped(one.text("numbers")), "wide"}});
  }
  page.begin_fold(fmt::format("{} statements with their numbers: {} hold as computed, {} not", statements.size(),
                              statements.size() - false_ones, false_ones),
                  "statements");
  page.add(table);
  page.end_fold();
}

std::optional<BearingErrors> errors_of_balance(const View& law) {
  const View errors = law["errors"];
  const auto displacement_m = errors.number("displacement_m"), largest_force_N = errors.number("largest_force_N");
  if (!displacement_m || !largest_force_N) return std::nullopt;
  return BearingErrors{.displacement_m = *displacement_m,
                       .largest_force_N = *largest_force_N,
                       .any_force_N = errors.number("any_force_N").value_or(0),
                       .smallest_film = errors.number("smallest_film_relative")};
}

void add_budgets(Page& page, const std::vector<View>& bearings) {
  if (bearings.empty()) return;  // the section has said so
  Table table;
  table.caption = "Error budget: what may move a balance (bounds of first order, or differences of two balances)";
  table.columns = {"case",
                   "law",
                   "source",
                   "of",
                   "kind",
                   "ring displacement [\u00b5m]",
                   "largest force [N]",
                   "any force [N]",
                   "thinnest film [%]"};
  for (const View& bearing : bearings)
    for (const View& law : bearing.list("laws"))
      for (const View& row : law.list("error_budget"))
        table.rows.push_back({words(bearing.text("id")), words(law.text("law")), words(row.text("source")),
                              words(row.text("of")), words(row.text("kind")),
                              number_cell(scaled(row.number("displacement_m"), micro), 2),
                              number_cell(row.number("largest_force_N"), 3), number_cell(row.number("any_force_N"), 3),
                              number_cell(scaled(row.number("smallest_film_relative"), 100), 2)});
  page.heading("Error budget");
  if (table.rows.empty()) {
    page.absent("Error budgets are", "ehd verify --output DIR");
    return;
  }
  page.add_folded(fmt::format("Every source of error, bearing by bearing: {} rows", table.rows.size()), table);
}

void add_study(Page& page, const View& study) {
  page.heading("On what the statements depend");
  const std::vector<View> rows = study.list("rows");
  if (rows.empty()) {
    page.absent("The study of the statements is", "ehd verify --output DIR");
    return;
  }
  Table summary;
  summary.caption = "Statements over the choices that the paper leaves open";
  summary.columns = {"statement", "law", "holds in", "where not, or where alone", "at <i>\u03c8</i> = 0 alone also"};
  for (const View& one : study.list("summary"))
    summary.rows.push_back(
        {{"(" + escaped(one.text("letter")) + ")", ""},
         words(one.text("law")),
         words(fmt::format("{} of {}", plain(one.number("holds").value_or(0)), plain(one.number("of").value_or(0)))),
         {escaped(one.text("exceptions")), "wide"},
         {escaped(one.text("at_psi_0_alone")), "wide"}});
  page.add_folded("Each statement, law by law", summary);
  Table table;
  table.caption =
      "One choice changed at a time; changes are EHD against dry at <i>\u03c8</i> = 0; \"apart\" is the largest change "
      "of "
      "any roller's force over the largest dry force";
  table.columns = {"changed",
                   "to",
                   "law",
                   "(a)",
                   "force, apart [%]",
                   "(b)",
                   "displacement [%]",
                   "(c)",
                   "middle (apart), largest clearance [%]",
                   "(d)",
                   "<i>x</i><sub>0</sub> [mm] for (a) to (d)"};
  for (const View& row : rows) {
    std::map<std::string, View> by_letter;
    for (const View& one : row.list("statements")) by_letter[one.text("letter")] = one;
    const auto holds = [&](const char* letter) {
      const auto flag = by_letter[letter].flag("holds");
      const bool at_top_alone = by_letter[letter].flag("holds_at_psi_0").value_or(false);
      return TableCell{flag ? (*flag ? "holds" : at_top_alone ? "<b>at 0</b>" : "<b>no</b>") : "", ""};
    };
    const auto percent = [&](const char* letter, const char* name) {
      const auto value = by_letter[letter]["values"].number(name);
      return value ? number_cell(scaled(value, 100), 2).html : std::string("\u2013");
    };
    const auto ready = [](const std::string& html) { return TableCell{html, ""}; };
    std::string ranges;
    for (const View& range : row.list("x0_all_hold_m")) {
      const std::vector<double> ends = range.numbers();
      if (ends.size() != 2) continue;
      ranges +=
          fmt::format("{}{} to {}", ranges.empty() ? "" : ", ", plain(milli * ends[0], 2), plain(milli * ends[1], 2));
    }
    if (ranges.empty() && row.has("x0_all_hold_m")) ranges = "nowhere";
    table.rows.push_back(
        {words(row.text("factor")), words(row.text("value")), words(row.text("law")), holds("a"),
         ready(fmt::format("{}, {}", percent("a", "change"), percent("a", "apart"))), holds("b"),
         ready(fmt::format("{} to {}", percent("b", "least"), percent("b", "most"))), holds("c"),
         ready(fmt::format("{} ({}), {}", percent("c", "middle"), percent("c", "apart"), percent("c", "largest"))),
         holds("d"), words(ranges)});
  }
  page.add_folded(fmt::format("Every choice: {} rows", table.rows.size()), table);
}

void add_force_laws(Page& page, const std::vector<View>& laws) {
  page.heading("Contact force laws <i>f</i>(<i>\u03b4</i>)");
  if (laws.empty()) {
    page.absent("Contact force laws are", "ehd verify --output DIR");
    return;
  }
  std::vector<std::pair<std::string, std::string>> contacts;  // case, raceway
  for (const View& one : laws) {
    const std::pair name{one.text("id"), one.text("raceway")};
    if (std::find(contacts.begin(), contacts.end(), name) == contacts.end()) contacts.push_back(name);
  }
  page.begin_fold(fmt::format("Force and smallest film over displacement: {} contacts", contacts.size()));
  page.begin_figures();
  for (const auto& [id, raceway] : contacts) {
    Figure figure{.id = fmt::format("fig-law-{}-{}", id, raceway),
                  .title = fmt::format("Contact force laws of {}, {} raceway", id, raceway),
                  .description = "Contact force over displacement, a curve a law; below, the minimum film."};
    Panel force, film;
    force.title = literal(fmt::format("{}, {} raceway", id, raceway));
    force.height = 200;
    film.height = 110;
    force.y = {.label = "contact force *f* [kN]", .low = 0};
    film.y = {.label = "*h*_{min} [\u00b5m]", .scale = Scale::logarithmic};
    for (const View& one : laws) {
      if (one.text("id") != id || one.text("raceway") != raceway) continue;
      const Look look = look_of_law(one.text("law"));
      const auto displacement = scaled(one.numbers("displacement_m"), micro);
      force.series.push_back({.name = literal(one.text("law")),
                              .x = displacement,
                              .y = scaled(one.numbers("force_N"), kilo),
                              .line = look.line,
                              .colour = look.colour});
      if (one.has("film_minimum_m"))
        film.series.push_back({.x = displacement,
                               .y = scaled(one.numbers("film_minimum_m"), micro),
                               .line = look.line,
                               .colour = look.colour,
                               .of = literal(one.text("law"))});
    }
    std::vector<double> all;
    for (const Series& series : force.series) all.insert(all.end(), series.x.begin(), series.x.end());
    const Range range = range_of(all, Scale::linear);
    force.x.low = film.x.low = range.low;
    force.x.high = film.x.high = range.high;
    force.x.label = film.x.label = "displacement *\u03b4* [\u00b5m]";
    force.x.silent = !film.series.empty();
    figure.panels.push_back(std::move(force));
    if (!film.series.empty()) figure.panels.push_back(std::move(film));
    page.figure(std::move(figure),
                fmt::format("<b>{}</b>, {} raceway: contact force over displacement{}", escaped(id), escaped(raceway),
                            figure.panels.size() > 1 ? ", and the minimum film below." : "."));
  }
  page.end_figures();
  page.end_fold();
}

}  // namespace ehd::report
