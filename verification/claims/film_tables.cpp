// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 8: the errors that a table of films states, against solves at random contacts that the table has not seen: most
// by the default solver to a thirtieth of the table's tolerance, some by the certified one.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/batch.hpp"
#include "workflow/film_table_build.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

struct JudgedTable {
  bool roelands;
  FilmRange range;
  double tolerance;
  bool slow;
};
constexpr JudgedTable judged_tables[] = {{true, {.M_low = 2, .M_high = 1000, .L_low = 2.5, .L_high = 20}, 1e-3, false},
                                         {true, {.M_low = 2, .M_high = 1000, .L_low = 2.5, .L_high = 20}, 1e-4, true},
                                         {false, {.M_low = 5, .M_high = 300, .L_low = 3, .L_high = 12}, 1e-4, true}};
constexpr unsigned table_seed = 20261122;
constexpr std::size_t table_points = 200, certified_points = 5;
/// A truth to this share of the table's tolerance leaves a few percent of the stated error undecided.
constexpr double table_truth_share = 1.0 / 30;
constexpr double certified_tolerance = 1e-7;

std::string table_name(const JudgedTable& judged) {
  return fmt::format("{}/{}", judged.roelands ? "roelands" : "barus", plain(judged.tolerance));
}

/// By how much a table misses truths: difference over stated error, and the truth's error over it at that point.
struct TableMiss {
  double worst = 0, truth = 0;
  MoesGroups at = {};

  void add(double difference, double stated, double truth_error, const MoesGroups& where) {
    const double ratio = difference / stated;
    if (ratio <= worst) return;
    worst = ratio;
    truth = truth_error / stated;
    at = where;
  }
};

void add_misses(const FilmTable& table, const MoesGroups& at, const Solution& solution, ByFilm<TableMiss>& misses) {
  const auto films = films_at(table, at);
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const Reading* seen = reading(solution, table_films[k]);
    const double value = value_of(seen);
    const double unit = table_error_unit(table_films[k], value);
    const double truth_error = error_of(seen) / (has_absolute_error(table_films[k]) ? unit : 1);
    misses[k].add(films ? std::abs((*films)[k].value - value) / unit : nothing, films ? (*films)[k].error : nothing,
                  truth_error, at);
  }
}

Claim covers(const JudgedTable& judged, const FilmTable& table, std::size_t k, const TableMiss& miss,
             const std::string& by, std::size_t points) {
  const std::string film(to_string(table_films[k]));
  return claim({.id = fmt::format("film-table/{}/{}/{}", table_name(judged), by, film),
                .rung = 8,
                .statement = fmt::format("the error of {} that the table of {} states covers {} random solves by {}",
                                         film, table_name(judged), points, by),
                .solver = by},
               miss.worst, miss.truth, Tolerance::required(1, "the table states this error"),
               fmt::format("stated {}, found {}; largest at M = {}, L = {}", plain(table.errors[k].stated, 2),
                           plain(table.errors[k].found, 2), plain(miss.at.M), plain(miss.at.L)));
}

Findings judge_table(const JudgedTable& judged) {
  const TableOil of{.lubricant = oil(judged.roelands)};
  const FilmTableRequest request{.range = judged.range, .tolerance = judged.tolerance};
  const FilmTable table = build_film_table(of, request, film_solves(of, request.tolerance, 1, 60));
  Findings found;
  found.claims.push_back(claim_fact(
      {.id = "film-table/" + table_name(judged) + "/built",
       .rung = 8,
       .statement = fmt::format("a table of films over M {} to {}, L {} to {} meets {}", plain(judged.range.M_low),
                                plain(judged.range.M_high), plain(judged.range.L_low), plain(judged.range.L_high),
                                plain(judged.tolerance)),
       .solver = table.solver},
      table.status == StopReason::converged, "of the table",
      fmt::format("{} solves, {} held-out ones{}", table.solves, table.held_out,
                  table.reason.empty() ? "" : "; " + table.reason)));
  if (table.panels.empty()) return found;

  Draw draw(table_seed);
  std::vector<MoesGroups> points;
  std::vector<Problem> problems;
  while (points.size() < table_points) {
    points.push_back({draw.logarithmic(judged.range.M_low, judged.range.M_high),
                      draw.uniform(judged.range.L_low, judged.range.L_high)});
    problems.push_back(problem_of(of, points.back()));
  }
  ByFilm<TableMiss> of_fast = {}, of_certified = {};
  const auto solved =
      solve_all(default_solver(), problems, {.tolerance = table_truth_share * judged.tolerance, .time_limit_s = 60}, 1);
  for (std::size_t i = 0; i < points.size(); ++i) add_misses(table, points[i], solved[i], of_fast);
  for (std::size_t i = 0; i < certified_points; ++i)
    add_misses(table, points[i],
               certified_solver().solve(problems[i], {.tolerance = certified_tolerance, .time_limit_s = 60}),
               of_certified);
  for (std::size_t k = 0; k < table_film_count; ++k) {
    found.claims.push_back(covers(judged, table, k, of_fast[k], default_solver().name, table_points));
    found.claims.push_back(covers(judged, table, k, of_certified[k], certified_solver().name, certified_points));
  }
  return found;
}

}  // namespace

std::vector<Topic> film_table_topics() {
  std::vector<Topic> topics;
  for (const JudgedTable& judged : judged_tables)
    topics.push_back({.name = "film table, " + table_name(judged),
                      .rungs = {8},
                      .slow = judged.slow,
                      .judge = [&judged] { return judge_table(judged); },
                      .expected_s = judged.slow ? 15.0 : 5.0});
  return topics;
}

}  // namespace ehd::verification
