// SPDX-License-Identifier: GPL-3.0-or-later
// The first table: what was verified, to how many digits, by which truth, at which cost; and what was not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "contact/text.hpp"
#include "io/duration.hpp"
#include "verification/report/bearing_tables.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

std::string how_many(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string section_link(const char* section, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", section, escaped(text));
}

/// Least and largest of the values that are known.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return;
    low = std::min(low, *value);
    high = std::max(high, *value);
  }
  [[nodiscard]] bool any() const { return low <= high; }
  [[nodiscard]] std::string text(int digits) const {
    const std::string first = plain(low, digits), last = plain(high, digits);
    return first == last ? first : first + " to " + last;
  }
};

std::string time_of(const std::optional<double>& wall_s) { return wall_s ? duration(*wall_s) : ""; }

/// For times of single solves: "0.24 ms to 2.8 s each".
std::string milliseconds_of(const Extent& wall_s) {
  if (!wall_s.any()) return "";
  const auto text = [](double s) { return s < 1 ? plain(1e3 * s, 2) + " ms" : plain(s, 2) + " s"; };
  return fmt::format("{} to {} each", text(wall_s.low), text(wall_s.high));
}

std::size_t number_with(const std::vector<View>& list, const std::string& key, const std::string& value) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](const View& one) { return one.text(key) == value; }));
}

Verified absent_part(const char* section, const std::string& what) {
  return {.what = section_link(section, what), .digits = "", .truth = "", .cost = "", .open = {"not in this folder"}};
}

Verified claims_verified(const View& results) {
  const auto claims = results.list("claims"), skipped = results.list("skipped");
  const View summary = results["summary"];
  Verified row{.what = section_link("claims", how_many(claims.size(), "claim", "claims") + " of the suite")};
  Extent margins;
  for (const View& claim : claims)
    if (stands(claim) && claim["tolerance"].number("value").value_or(0) > 0) margins.add(claim.number("margin"));
  row.digits = margins.any() ? "each its own tolerance; the tightest has " + plain(100 * margins.low, 2) + " % left"
                             : "each its own tolerance";
  row.truth = "exact solutions, invariants, orders, the other solver, printed digits";
  row.cost = time_of(summary.number("wall_s"));
  if (!skipped.empty()) row.open.push_back(std::to_string(skipped.size()) + " skipped");
  if (summary.flag("quick").value_or(false)) row.open.push_back("slow topics, left out by --quick");
  if (const auto selection = summary.text("selection"); !selection.empty())
    row.open.push_back("all but <code>" + escaped(selection) + "</code>");
  const auto accepted = static_cast<std::size_t>(std::count_if(claims.begin(), claims.end(), [](const View& claim) {
    return claim.text("verdict") == "inconclusive" && stands(claim);
  }));
  if (accepted > 0) row.open.push_back(std::to_string(accepted) + " inconclusive, accepted with a reason");
  return row;
}

Verified cases_verified(const View& results) {
  const auto cases = results["figures"].list("cases");
  if (cases.empty()) return absent_part("contacts", "Films of the cases");
  Extent digits, times;
  std::size_t open = 0, beyond = 0;
  std::string truth, solver;
  for (const View& one : cases) {
    const auto solvers = one.list("solvers");
    if (solvers.empty()) continue;
    truth = solvers.front().text("solver");
    solver = solvers.back().text("solver");
    times.add(solvers.back().number("wall_s"));
    if (number_with(solvers, "status", "converged") < solvers.size()) ++open;
    const View difference = one["difference"];
    std::optional<double> found;
    for (const char* film : {"film_minimum", "film_central"})
      if (const auto value = difference.number(film)) found = std::max(found.value_or(0), std::abs(*value));
    digits.add(digits_of(found));
    if (const auto allowed = difference.number("stated"); found && allowed && *found > *allowed) ++beyond;
  }
  Verified row{.what = fmt::format("{}: films by <code>{}</code>",
                                   section_link("contacts", how_many(cases.size(), "case", "cases")), escaped(solver)),
               .digits = digits.any() ? digits.text(2) + " digits" : "",
               .truth = "<code>" + escaped(truth) + "</code>, another discretisation of the same equations",
               .cost = milliseconds_of(times)};
  if (open > 0) row.open.push_back(how_many(open, "case", "cases") + " without two converged solves");
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
      if (const auto error = point.number("error"); error && *error > 0) errors.add(digits_of(error));
  }
  Verified row{.what = section_link("convergence", how_many(studies.size(), "grid study", "grid studies")),
               .truth = "manufactured solutions; <code>reference</code> to more digits"};
  if (errors.any()) row.digits = "errors fall to " + plain(errors.high, 2) + " digits";
  if (off.any())
    row.digits += (row.digits.empty() ? "" : "; ") + ("orders within " + plain(off.high, 2) + " of the declared");
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
    for (const char* film : {"film.minimum", "film.central"}) digits.add(digits_of(row[film].number("achieved")));
    times.add(row["cost"].number("wall_s"));
  }
  for (const View& one : truths) truth.add(digits_of(one["film.minimum"].number("error")));
  Verified row{
      .what = section_link("work-precision", how_many(rows.size(), "run", "runs") + " of the benchmark, on " +
                                                 how_many(truths.size(), "case", "cases")),
      .digits = digits.any() ? digits.text(2) + " digits" : "",
      .truth = truth.any() ? "<code>reference</code>, to " + truth.text(3) + " digits" : "<code>reference</code>",
      .cost = milliseconds_of(times)};
  if (const auto open = rows.size() - number_with(rows, "status", "converged"); open > 0)
    row.open.push_back(how_many(open, "run", "runs") + " not converged, or not run");
  double undecided = 0;
  for (const View& one : coverage) {
    undecided += one.number("undecided").value_or(0);
    if (const double missed = one.number("missed").value_or(0); missed > 0)
      row.wrong.push_back(fmt::format("{}: {} stated errors of {} do not cover the true one ({})",
                                      section_link("work-precision", "benchmark"), plain(missed),
                                      escaped(one.text("solver")), escaped(one.text("quantity"))));
  }
  if (undecided > 0) row.open.push_back(plain(undecided) + " stated errors that the truth cannot judge");
  constexpr double enough = 0.9;  // of a core; docs/bench.md
  if (const auto share = result.number("cpu_share"); share && *share < enough)
    row.open.push_back("the times: other processes took " + plain(100 * (1 - *share), 2) + " % of the core");
  const auto batch = bench.list("batch");
  if (std::any_of(batch.begin(), batch.end(), [](const View& one) { return !one.flag("same_results").value_or(true); }))
    row.wrong.push_back(section_link("work-precision", "benchmark") + ": results depend on the number of threads");
  return row;
}

Verified maps_verified(const View& results) {
  const View maps = results["figures"]["maps"];
  const auto points = maps.list("points");
  if (points.empty()) return absent_part("maps", "Maps over M and L");
  Extent certified, achieved, times;
  std::size_t tests = 0, open = 0;
  for (const View& point : points) {
    for (const char* film : {"film_minimum_error", "film_central_error"}) certified.add(digits_of(point.number(film)));
    const View fast = point["fast"];
    for (const char* film : {"deviation_minimum", "deviation_central"}) achieved.add(digits_of(fast.number(film)));
    times.add(fast.number("wall_s"));
    if (point.flag("numerical_test").value_or(false)) ++tests;
    if (fast.exists() && fast.text("status") != "converged") ++open;
  }
  Verified row{.what = section_link("maps", how_many(points.size(), "point", "points") + " over M and L")};
  if (certified.any()) row.digits = "certified: " + certified.text(2) + " digits";
  if (achieved.any()) row.digits += "; <code>fast</code> has " + achieved.text(2);
  row.truth = "<code>reference</code>, recorded in the atlas";
  row.cost = milliseconds_of(times);
  if (tests > 0) row.open.push_back(how_many(tests, "point", "points") + " above 4 GPa, a numerical test only");
  if (open > 0) row.open.push_back("at " + how_many(open, "point", "points") + " <code>fast</code> did not converge");
  row.open.push_back("film formulas: published fits, for comparison only");
  return row;
}

Verified stress_verified(const View& stress) {
  const auto parts = stress.list("parts");
  if (parts.empty()) return absent_part("stress", "Stability under stress");
  Verified row{.what = section_link("stress", how_many(parts.size(), "part", "parts") + " of the stress"),
               .digits = how_many(number_with(parts, "verdict", "pass"), "passes", "pass") + " of " +
                         std::to_string(parts.size()),
               .truth = "the other solver, 34 digits, repeated and disturbed runs",
               .cost = time_of(stress.number("wall_s"))};
  for (const View& part : parts)
    if (const std::string verdict = part.text("verdict"); verdict != "pass")
      row.wrong.push_back(section_link("stress", fmt::format("stress ({}) {}", part.text("id"), part.text("name"))) +
                          ": " + escaped(verdict));
  return row;
}

Verified bearing_verified(const View& figures) {
  const auto bearings = figures.list("bearing");
  if (bearings.empty()) return absent_part("bearing", "Load distributions");
  Extent digits;
  std::set<std::string> laws;
  std::size_t open = 0;
  for (const View& bearing : bearings) {
    for (const View& law : bearing.list("laws")) {
      laws.insert(law.text("law"));
      if (!law.text("status").empty() && law.text("status") != "converged") ++open;
      const auto errors = errors_of_balance(law);
      if (const auto displacement = law.number("displacement_m"); errors && displacement && *displacement != 0)
        digits.add(digits_of(errors->displacement_m / std::abs(*displacement)));
    }
  }
  Verified row{.what = section_link("bearing", how_many(bearings.size(), "bearing", "bearings") + " under " +
                                                   how_many(laws.size(), "law", "laws")),
               .digits = digits.any() ? "displacement: " + digits.text(2) + " digits" : "",
               .truth = "balance, symmetry and energy; the error budget of each law"};
  const auto statements = figures.list("statements");
  const auto false_ones = static_cast<std::size_t>(std::count_if(
      statements.begin(), statements.end(), [](const View& one) { return !one.flag("holds").value_or(true); }));
  if (false_ones > 0)
    row.open.push_back(
        fmt::format("{} of {} statements of the paper do not hold as computed", false_ones, statements.size()));
  if (open > 0) row.open.push_back(how_many(open, "balance", "balances") + " not converged");
  row.open.push_back("the datum <i>x</i><sub>0</sub>: a choice, its effect is in the budget");
  return row;
}

Verified dynamics_verified(const View& figures) {
  const auto bearings = figures.list("dynamics");
  if (bearings.empty()) return absent_part("bearing", "Bearings in small motion");
  Verified row{.what = section_link("bearing", how_many(bearings.size(), "bearing", "bearings") + " in small motion"),
               .truth = "claims of the rungs 6, 8 and 9: derivatives, causality, small steps in time, limits"};
  for (const char* quantity : {"stiffness", "damping"}) {
    Extent digits;
    for (const View& bearing : bearings)
      for (const double error : bearing["ring"].numbers(quantity + std::string("_error"))) digits.add(digits_of(error));
    if (digits.any()) row.digits += (row.digits.empty() ? "" : "; ") + (quantity + (": " + digits.text(2)) + " digits");
  }
  if (row.digits.empty()) row.open.push_back("errors of stiffness and damping: not in this folder");
  return row;
}

}  // namespace

std::vector<Verified> everything_verified(const View& results, const View& bench, const View& stress) {
  const View figures = results["figures"];
  return {claims_verified(results), cases_verified(results), convergence_verified(results), work_verified(bench),
          maps_verified(results),   stress_verified(stress), bearing_verified(figures),     dynamics_verified(figures)};
}

}  // namespace ehd::report
