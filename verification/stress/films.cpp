// SPDX-License-Identifier: GPL-3.0-or-later
// (k) Both films at random contacts of the box: `fast` against `reference`, and the errors that `fast` states.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/text.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

/// A thousandth of the smallest tolerance of `fast`, whose stated errors are often far below what was asked for.
constexpr double truth_asked = 1e-8, time_limit_s = 60, truth_time_limit_s = 240;
constexpr int whole = 1000, quick_contacts = 6;
constexpr unsigned seed = 20261128;  // no rule of `fast` was calibrated on its contacts
constexpr double nearest_cut = -2.5, farthest_cut = -10, lightest_cut_M = 2, share_of_cut = 0.4;

/// A contact of the box (docs/fast-solver.md) with p_H <= 4 GPa.
BoxContact drawn_contact(Draw& draw) {
  BoxContact contact;
  do {
    contact = {.moes = draw.point(), .roelands = draw.uniform(0, 1) < 0.5};
    const double cut = Draw::digits(draw.uniform(farthest_cut, nearest_cut), 4);
    if (draw.uniform(0, 1) < share_of_cut && contact.moes.M >= lightest_cut_M) contact.inlet = TruncatedAt{cut};
  } while (hertz_pressure_Pa(contact.problem().groups) > highest_pressure_Pa);
  return contact;
}

std::string inlet_of(const FilmPoint& point) {
  const auto* cut = std::get_if<TruncatedAt>(&point.contact.inlet);
  return cut ? plain(cut->x) : "flooded";
}

std::string name_of(const FilmPoint& point) {
  return fmt::format("{}, inlet {}, to {}", point.contact.name(), inlet_of(point), plain(point.asked));
}

void solve_point(FilmPoint& point, const Ended& truth, double truth_s) {
  const Solution found =
      default_solver().solve(point.contact.problem(), {.tolerance = point.asked, .time_limit_s = time_limit_s});
  const Ended at = ended(found);
  point.status = at.status;
  point.truth_status = truth.status;
  point.nodes = found.record.cost.nodes;
  point.wall_s = at.wall_s;
  point.truth_s = truth_s;
  point.late = out_of_time(at.status, at.wall_s, time_limit_s);
  if (!at.has_films() || !truth.has_films()) return;
  for (std::size_t k = 0; k < point.films.size(); ++k)
    point.films[k] = {std::abs(*at.film[k] / *truth.film[k] - 1), *at.error[k], *truth.error[k]};
}

}  // namespace

std::vector<FilmPoint> run_films(const Scope& scope) {
  Draw draw(seed);
  constexpr std::size_t tolerances = std::size(film_tolerances);
  const std::size_t contacts = scope.quick ? quick_contacts : whole;
  std::vector<FilmPoint> points;
  for (std::size_t k = 0; k < contacts; ++k) {
    points.insert(points.end(), tolerances, {.contact = drawn_contact(draw)});
    for (std::size_t i = 0; i < tolerances; ++i) points[tolerances * k + i].asked = film_tolerances[i];
  }
  scope.show(fmt::format("{} contacts", contacts));
  in_threads(contacts, scope.threads, [&](std::size_t k) {
    FilmPoint* const of_contact = &points[tolerances * k];
    const Ended truth = ended(certified_solver().solve(of_contact->contact.problem(),
                                                       {.tolerance = truth_asked, .time_limit_s = truth_time_limit_s}));
    for (std::size_t i = 0; i < tolerances; ++i) solve_point(of_contact[i], truth, truth.wall_s);
  });
  return points;
}

namespace {

const std::vector<Column> film_columns = columns_of(
    "laws | M | L | inlet | tolerance | status | reference status | intervals | smallest film: difference | stated | "
    "of reference | central film: difference | stated | of reference | time [s] | reference time [s]");

std::vector<Cell> cells_of(const FilmPoint& point) {
  std::vector<Cell> cells{law_name(point.contact.roelands),
                          point.contact.moes.M,
                          point.contact.moes.L,
                          inlet_of(point),
                          point.asked,
                          to_string(point.status),
                          to_string(point.truth_status),
                          point.nodes};
  for (const auto& [differ, stated, truth_error] : point.films)
    for (const double number : {differ, stated, truth_error}) cells.emplace_back(number);
  cells.emplace_back(point.wall_s);
  cells.emplace_back(point.truth_s);
  return cells;
}

Part empty_part() {
  Part part{.id = "k",
            .name = "films",
            .question = "Does fast know both films to 1e-3, 1e-4 and 1e-5 at random contacts, and do its errors hold?"};
  part.tolerance = Tolerance::required(0.01, "share of stated errors that do not hold: at most 1 in 100");
  part.settings = {{"tolerance", film_tolerances},          {"reference_tolerance", truth_asked},
                   {"time_limit_s", time_limit_s},          {"seed", seed},
                   {"M", {box_lightest_M, box_heaviest_M}}, {"L", {0, box_largest_L}}};
  part.table.columns = columns_of(error_count_columns);
  part.points = Table{.columns = film_columns};
  return part;
}

}  // namespace

Part judge_films(const std::vector<FilmPoint>& points) {
  Part part = empty_part();
  Tally tally;
  std::string missed;
  for (const FilmPoint& point : points) {
    part.points->rows.push_back(cells_of(point));
    tally.add(holds_in_time(point.status == StopReason::converged, point.late),
              fmt::format("{}: fast {}", name_of(point), to_string(point.status)));
  }
  for (const double asked : film_tolerances) {
    std::size_t contacts = 0;
    ErrorCount counts[std::size(judged_films)] = {{.asked = asked}, {.asked = asked}};
    for (const FilmPoint& point : points) {
      if (point.asked != asked) continue;
      ++contacts;
      for (std::size_t k = 0; k < point.films.size(); ++k)
        if (counts[k].add(point.films[k]) == StatedError::missed)
          missed += fmt::format("; {} of {}: {} stated errors off", to_string(judged_films[k]), name_of(point),
                                plain(point.films[k].differ / point.films[k].stated, 3));
    }
    part.summary += fmt::format("to {}: ", plain(asked));
    for (std::size_t k = 0; k < std::size(judged_films); ++k) {
      const std::string film(to_string(judged_films[k]));
      judge_share(counts[k], contacts, *part.tolerance, fmt::format("{}, to {}", film, plain(asked)), tally);
      part.table.rows.push_back(counts[k].cells(film, contacts));
      part.summary += fmt::format("{} {} of {}{}", film, counts[k].held, counts[k].judged, k == 0 ? ", " : "; ");
    }
  }
  tally.close(part);
  part.summary = "stated errors hold: " + part.summary + fmt::format("{} solves", points.size()) + missed;
  return part;
}

}  // namespace ehd::verification::stress
