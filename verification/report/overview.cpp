// SPDX-License-Identifier: GPL-3.0-or-later
// The first table: what was verified, to how many digits, by which truth, at which cost; and what was not.
#include "verification/report/overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/text.hpp"
#include "io/duration.hpp"

namespace ehd::report {

std::string digits_in(const Extent& digits, bool with_word) {
  const std::string worst = digits_text(digits.low), best = digits_text(digits.high);
  const std::string first = worst + (with_word ? " digits" : "");
  return worst == best ? first : fmt::format("{} at worst, {} at best", first, best);
}

std::string how_many(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string section_link(const char* section, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", section, escaped(text));
}

Verified absent_part(const char* section, const std::string& what) {
  return {.what = section_link(section, what), .digits = "", .truth = "", .cost = "", .open = {"not in this folder"}};
}

std::string cost_of(const View& figures, const char* part) {
  for (const View& time : figures.list("times"))
    if (time.text("name") == part) return duration(time.number("wall_s").value_or(0)) + " in one thread";
  return "not recorded";
}

namespace {

constexpr const char* quick_option = "<code class=\"name\">--quick</code>";
constexpr double close_formula = 0.05;  // a deviation that the maps call good
/// Both films that every solver is judged by.
constexpr const char* both_films = "<i>H</i><sub>min</sub> and <i>H</i><sub>cen</sub>";

std::string time_of(const std::optional<double>& wall_s) { return wall_s ? duration(*wall_s) : ""; }

/// For times of single solves: "0.24 ms to 2.8 s each".
std::string computing_times(const Extent& wall_s) {
  if (!wall_s.any()) return "";
  return fmt::format("{} to {} each", computing_time(wall_s.low, 2), computing_time(wall_s.high, 2));
}

std::size_t number_with(const std::vector<View>& list, const std::string& key, const std::string& value) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](const View& one) { return one.text(key) == value; }));
}

Verified claims_verified(const View& results) {
  const auto claims = results.list("claims"), skipped = results.list("skipped");
  const View summary = results["summary"];
  Verified row{.what = section_link("ladder", how_many(claims.size(), "claim", "claims") + " of the suite")};
  Extent margins;
  for (const View& claim : claims)
    if (stands(claim) && claim["tolerance"].number("value").value_or(0) > 0) margins.add(claim.number("margin"));
  row.digits = "no common number: each claim has its own tolerance";
  if (margins.any()) row.digits += fmt::format(", of which the tightest has {} left", percent(margins.low, 2));
  row.truth = "exact solutions, invariants, declared orders, the other solver, published digits";
  row.cost = time_of(summary.number("wall_s"));
  if (!skipped.empty())
    row.open.push_back(fmt::format("{} skipped, each with its reason in the section", skipped.size()));
  if (const double not_run = summary.number("not_run").value_or(0); not_run > 0)
    row.wrong.push_back(fmt::format("{}: {} {} not run to the end", section_link("ladder", "claims"), plain(not_run),
                                    not_run == 1 ? "topic was" : "topics were"));
  if (summary.flag("quick").value_or(false))
    row.open.push_back(std::string("slow topics, left out by ") + quick_option);
  if (const auto selection = summary.text("selection"); !selection.empty())
    row.open.push_back("all but <code>" + escaped(selection) + "</code>");
  const auto accepted = static_cast<std::size_t>(std::count_if(claims.begin(), claims.end(), [](const View& claim) {
    return claim.text("verdict") == "inconclusive" && stands(claim);
  }));
  if (accepted > 0) row.open.push_back(fmt::format("{} inconclusive, accepted with a reason", accepted));
  return row;
}

Verified cases_verified(const View& results) {
  const auto cases = results["figures"].list("cases");
  if (cases.empty()) return absent_part("contacts", "Films of the cases");
  Extent digits, times;
  std::size_t open = 0, beyond = 0, unknown = 0;
  std::string truth, solver;
  for (const View& one : cases) {
    const auto solvers = one.list("solvers");
    if (solvers.empty()) continue;
    truth = solvers.front().text("solver");
    solver = solvers.back().text("solver");
    times.add(solvers.back().number("wall_s"));
    const bool converged = number_with(solvers, "status", "converged") == solvers.size();
    if (!converged) ++open;
    const auto certain = certain_error(one);
    digits.add(digits_of(certain));
    if (converged && !certain) ++unknown;
    const View difference = one["difference"];
    std::optional<double> found;
    for (const char* film : {"film_minimum", "film_central"})
      if (const auto value = difference.number(film)) found = std::max(found.value_or(0), std::abs(*value));
    if (const auto allowed = difference.number("stated"); found && allowed && *found > *allowed) ++beyond;
  }
  Verified row{.what = fmt::format("{}: {} by <code>{}</code>",
                                   section_link("contacts", how_many(cases.size(), "case", "cases")), both_films,
                                   escaped(solver)),
               .digits = digits.any() ? digits_in(digits) : "",
               .truth = "<code>" + escaped(truth) +
                        "</code>, another discretisation of the same equations; the error that it states is counted",
               .cost = computing_times(times)};
  if (open > 0) row.open.push_back(how_many(open, "case", "cases") + " without two converged solves");
  if (unknown > 0) row.open.push_back("films of " + how_many(unknown, "case", "cases") + ": no error is known");
  row.open.push_back("the curves of pressure and film: their difference is shown, not judged");
  if (beyond > 0)
    row.wrong.push_back(fmt::format("{}: in {} the films differ by more than both solvers state",
                                    section_link("contacts", "cases"), beyond));
  return row;
}

Verified convergence_verified(const View& results) {
  const auto studies = results["figures"].list("convergence");
  if (studies.empty()) return absent_part("convergence", "Orders of convergence");
  Extent off, errors;
  std::size_t fitted = 0;
  for (const View& study : studies) {
    if (const auto declared = study.number("declared_order"), order = study.number("fitted_order"); declared && order) {
      off.add(std::abs(*order - *declared));
      ++fitted;
    }
    for (const View& point : study.list("points"))
      if (const auto error = point.number("error"); error && *error > 0)
        errors.add(digits_of(*error + point.number("uncertainty").value_or(0)));
  }
  Verified row{.what = section_link("convergence", how_many(studies.size(), "grid study", "grid studies")) +
                       ": the orders of the schemes",
               .truth = "manufactured solutions; <code>reference</code> to more digits",
               .cost = cost_of(results["figures"], "convergence")};
  if (off.any())
    row.digits = fmt::format("the {} fitted {} within {} of the declared", fitted,
                             fitted == 1 ? "order is" : "orders are", rounded_up(off.high, 2));
  if (errors.any())
    row.digits += (row.digits.empty() ? "" : "; ") + ("the smallest error has " + digits_text(errors.high) + " digits");
  if (fitted < studies.size())
    row.open.push_back(how_many(studies.size() - fitted, "study", "studies") + " without a declared or a fitted order");
  return row;
}

Verified work_verified(const View& bench) {
  const View result = bench["work_precision"];
  if (!result.exists()) return absent_part("work-precision", "Time against achieved error");
  const auto rows = result.list("rows"), coverage = result.list("coverage"), truths = result.list("truths");
  Extent digits, times, truth;
  for (const View& row : rows) {
    for (const char* film : {"film.minimum", "film.central"})
      if (const auto achieved = row[film].number("achieved"))
        digits.add(digits_of(*achieved + row[film].number("truth_error").value_or(0)));
    times.add(row["cost"].number("wall_s"));
  }
  for (const View& one : truths) truth.add(digits_of(one["film.minimum"].number("error")));
  Verified row{.what = section_link("work-precision", how_many(rows.size(), "run", "runs") + " of the benchmark, on " +
                                                          how_many(truths.size(), "case", "cases")) +
                       ": " + both_films,
               .digits = digits.any() ? digits_in(digits) + ", as they were asked for" : "",
               .truth = truth.any() ? "<code>reference</code>, to " + digits_in(truth) : "<code>reference</code>",
               .cost = computing_times(times)};
  if (const auto open = rows.size() - number_with(rows, "status", "converged"); open > 0)
    row.open.push_back(how_many(open, "run", "runs") + " not converged, or not run");
  if (bench["settings"].flag("quick").value_or(false))
    row.open.push_back(std::string("all but a short set, by ") + quick_option);
  double covered = 0, undecided = 0;
  for (const View& one : coverage) {
    covered += one.number("covered").value_or(0);
    undecided += one.number("undecided").value_or(0);
    if (const double missed = one.number("missed").value_or(0); missed > 0)
      row.wrong.push_back(fmt::format("{}: {} stated errors of {} do not cover the true one ({})",
                                      section_link("work-precision", "benchmark"), plain(missed),
                                      escaped(one.text("solver")), escaped(one.text("quantity"))));
  }
  if (covered > 0 && row.wrong.empty())
    row.digits += fmt::format("{}all {} stated errors that could be judged cover the true one",
                              row.digits.empty() ? "" : "; ", plain(covered));
  if (const auto left_out = bench["settings"].list("left_out"); !left_out.empty()) {
    std::string names;
    for (const View& part : left_out) names += (names.empty() ? "" : ", ") + escaped(part.text());
    row.open.push_back("the run was stopped; left out: " + names);
  }
  if (undecided > 0) row.open.push_back(fmt::format("{} stated errors that the truth cannot judge", plain(undecided)));
  constexpr double enough = 0.9;  // of a core; docs/bench.md
  if (const auto share = result.number("cpu_share"); share && *share < enough)
    row.open.push_back(fmt::format("the times: other processes took {} of the core", percent(1 - *share, 2)));
  return row;
}

/// What the benchmark has beside work and precision.
Verified costs_verified(const View& bench) {
  const auto scaling = bench.list("scaling"), batch = bench.list("batch"), costs = bench.list("cost"),
             frequencies = bench["response"].list("frequencies");
  if (scaling.empty() && batch.empty() && costs.empty() && frequencies.empty())
    return absent_part("work-precision", "Scaling, threads, cost of answers and of motion");
  Verified row{.what = section_link("work-precision", "Scaling, threads, cost of answers and of motion")};
  const auto same = static_cast<std::size_t>(std::count_if(
      batch.begin(), batch.end(), [](const View& one) { return one.flag("same_results").value_or(true); }));
  if (!batch.empty()) {
    row.digits = fmt::format("{} of {} have the same results bit for bit in any number of threads", same,
                             how_many(batch.size(), "batch", "batches"));
    row.truth = "the same contacts in one thread";
  }
  Extent motion, times;
  for (const View& one : frequencies) motion.add(digits_of(one.number("achieved")));
  if (motion.any()) {
    row.digits += (row.digits.empty() ? "" : "; ") + ("<i>\u03ba</i> in motion: " + digits_in(motion));
    row.truth += (row.truth.empty() ? "" : "; ") + std::string("<i>\u03ba</i>: the certified solver");
  }
  for (const View& one : scaling) times.add(one.number("wall_s"));
  for (const View& one : costs) times.add(one.number("mean_s"));
  row.cost = computing_times(times);
  row.open.push_back("times: of one machine, shown and not judged");
  if (same < batch.size())
    row.wrong.push_back(section_link("work-precision", "benchmark") + ": results depend on the number of threads");
  return row;
}

Verified maps_verified(const View& results) {
  const auto points = results["figures"]["maps"].list("points");
  if (points.empty()) return absent_part("maps", "Maps over M and L");
  Extent certified, achieved, times;
  std::size_t tests = 0, by_fast = 0, open = 0;
  for (const View& point : points) {
    const View fast = point["fast"];
    for (const std::string film : {"minimum", "central"}) {
      const auto error = point.number("film_" + film + "_error"), deviation = fast.number("deviation_" + film);
      certified.add(digits_of(error));
      if (error && deviation) achieved.add(digits_of(std::abs(*deviation) + *error));
    }
    times.add(fast.number("wall_s"));
    if (point.flag("numerical_test").value_or(false)) ++tests;
    if (fast.exists()) ++by_fast;
    if (fast.exists() && fast.text("status") != "converged") ++open;
  }
  Verified row{
      .what = section_link("maps", how_many(points.size(), "point", "points") + " over M and L") + ": " + both_films,
      .cost = computing_times(times)};
  if (certified.any()) {
    row.digits = "<code>reference</code>: " + digits_in(certified);
    row.truth =
        "<code>reference</code>: the error that it states, as the atlas has it; claims of rung 8 judge such errors";
  }
  if (achieved.any()) {
    row.digits += (row.digits.empty() ? "" : "; ") + ("<code>fast</code>: " + digits_in(achieved, false));
    row.truth += (row.truth.empty() ? "" : "; ") + std::string("<code>fast</code>: <code>reference</code>");
  }
  if (tests > 0) row.open.push_back(how_many(tests, "point", "points") + " above 4 GPa, a numerical test only");
  if (by_fast < points.size())
    row.open.push_back(fmt::format("<code>fast</code> at {}, where it was not run",
                                   how_many(points.size() - by_fast, "point", "points")));
  if (open > 0) row.open.push_back("at " + how_many(open, "point", "points") + " <code>fast</code> did not converge");
  return row;
}

/// What the maps compare with the certified films, without a verdict.
Verified comparisons_verified(const View& results) {
  const auto points = results["figures"]["maps"].list("points");
  std::set<std::string> formulas;
  std::size_t near = 0, all = 0, cut = 0;
  for (const View& point : points) {
    if (point.has("inlet_cost_minimum") || point.has("inlet_cost_central")) ++cut;
    if (point.flag("numerical_test").value_or(false)) continue;
    for (const View& one : point.list("formulas")) {
      const auto deviation = one.number("deviation");
      if (!deviation || !std::isfinite(*deviation)) continue;
      formulas.insert(one.text("name") + one.text("quantity"));
      ++all;
      if (std::abs(*deviation) <= close_formula) ++near;
    }
  }
  if (formulas.empty() && cut == 0) return absent_part("maps", "Film formulas, and the cost of a cut inlet");
  Verified row{.what = section_link("maps", how_many(formulas.size(), "film formula", "film formulas") +
                                                ", and the cost of a cut inlet"),
               .truth = "the certified films of the maps",
               .cost = "none: it compares the films of the maps"};
  if (all > 0)
    row.digits = fmt::format("{} of {} values of formulas below 4 GPa within 5 % of the certified film", near, all);
  row.open.push_back("the formulas are published fits, for comparison only: nothing is judged");
  return row;
}

Verified stress_verified(const View& stress) {
  const auto parts = stress.list("parts");
  if (parts.empty()) return absent_part("stress", "Stability under stress");
  Verified row{.what = section_link("stress", how_many(parts.size(), "part", "parts") + " of the stress"),
               .digits = fmt::format("no common number: {} of {}, each with its own tolerance",
                                     number_with(parts, "verdict", "pass"),
                                     parts.size() == 1 ? "1 part passes" : fmt::format("{} parts pass", parts.size())),
               .truth = "the other solver, 34 digits, repeated and disturbed runs",
               .cost = time_of(stress.number("wall_s"))};
  if (std::any_of(parts.begin(), parts.end(),
                  [](const View& part) { return part["settings"].flag("quick").value_or(false); }))
    row.open.push_back(std::string("all but a small form of each part, by ") + quick_option);
  for (const View& part : parts)
    if (const std::string verdict = part.text("verdict"); verdict != "pass")
      row.wrong.push_back(section_link("stress", fmt::format("stress ({}) {}", part.text("id"), part.text("name"))) +
                          ": " + escaped(verdict));
  return row;
}

/// Files of one run or of several.
Verified origin_verified(const View& results, const View& bench, const View& stress) {
  Verified row{.what = section_link("origin", "Provenance of the numbers"),
               .truth = "version, commit, compiler and machine stand in each file"};
  const View suite = results["provenance"];
  for (const auto& [name, file] :
       {std::pair<const char*, View>{"results.json", results}, {"bench.json", bench}, {"stress.json", stress}}) {
    const View provenance = file["provenance"];
    if (!provenance.exists()) continue;
    if (provenance.flag("dirty").value_or(false))
      row.open.push_back(std::string(name) + ": made with changes that no commit has");
    if (provenance.text("commit") != suite.text("commit"))
      row.open.push_back(std::string(name) + ": of another commit than results.json");
  }
  return row;
}

}  // namespace

std::vector<Verified> everything_verified(const View& results, const View& bench, const View& stress) {
  const View figures = results["figures"];
  return {claims_verified(results),      cases_verified(results),      convergence_verified(results),
          work_verified(bench),          costs_verified(bench),        maps_verified(results),
          comparisons_verified(results), stress_verified(stress),      bearing_verified(figures),
          dynamics_verified(figures),    statements_verified(figures), origin_verified(results, bench, stress)};
}

}  // namespace ehd::report
