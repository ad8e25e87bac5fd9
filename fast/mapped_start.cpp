// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_start.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

#include "fast/extrapolation.hpp"
#include "fast/mapped_judgement.hpp"

namespace ehd::fast {

namespace {

/// Newton's target for a solution that only serves to make a map. The residual decides: with a jump in the first
/// iterate (steep_fall) the films are good before the spike stands at its place.
constexpr Target for_maps{.residual = 1e-3, .film_error = 1e-2, .film_residual = 1e-3};
/// Full care begins below the first tolerance for the smallest film, below the second for the central film, which
/// depends little on the map. At 3,100 contacts asked for 1e-3 (H_min) and 1e-4 to 2e-5 (H_cen) full care took 1.5
/// times the time.
constexpr double loose_tolerance = 3e-4, loose_central_tolerance = 5e-5;
/// Least care is enough from this tolerance of both films on, or up to this L.
constexpr double loosest_tolerance = 10 * loose_tolerance, least_care_L = 10;
/// Here the spike stands near X = 0, and even the central film alone needs more maps than the first: with it alone, of
/// 300 contacts (Barus) 6 of 1045 errors of four grids missed, at most 4 times.
constexpr double least_centre_M = 1, largest_centre_M = 2.5, least_centre_L = 9;
/// Intervals of the grids whose solutions make the next map, after the first. Measured on 464 problems: without any,
/// 1e-2 takes 40 % less time and its error bars hold; at 1e-3 that misses bars where a narrow spike stands (1.2 % of
/// 3000 films, L > 12), so one is made there; three make H_min at n = 512 three times better.
constexpr int map_grids[] = {64, 128, 128};
/// A neighbour's solution is near where less than this share of the load has moved. Neighbours 2 and 10 % away in M and
/// L moved 1 to 24 % at 139 of 140 points (M of .2..1000, L of 2.5..20, both law sets); nine in ten of the random
/// pressures of `ehd stress --part b` move more than 30 %, and a map made from such a pressure has to be made again.
constexpr double near_share = 0.25;

std::span<const int> grids_for_maps(Care care) {
  return std::span(map_grids).first(care == Care::least ? 0 : care == Care::little ? 1 : 3);
}

/// Of solutions that only make a map. The smaller tables save 2 to 9 % of the time of a solve (950 contacts up to M =
/// 5000, L = 30, 1e-3 to 1e-5). Beyond the calibrated range films are thinner, and Newton would take 1.5 times the
/// steps.
Tables tables_of_maps(const Run& run) { return is_calibrated(run.problem.groups) ? Tables::of_maps : run.tables; }

/// Levels the spike: behind the first maximum the pressure never rises. A neighbour's spike stands beside the place of
/// the new one, and Newton moves it by a node a step, while a new one grows where it belongs. Newton steps of 11
/// contacts from a neighbour 5 % away in M and 3 % in L, to 1e-4: 351 with its spike, 320 without; from nothing 355.
void level_spike(Array& P) {
  const Eigen::Index exit = P.size() - 1;
  Eigen::Index top = 1;
  while (top + 1 < exit && P[top + 1] >= P[top]) ++top;
  for (Eigen::Index i = top + 1; i < exit; ++i) P[i] = std::min(P[i], P[i - 1]);
}

/// run.state, which began as `before`, has moved less than a near neighbour's solution does.
bool was_near(const Run& run, const State& before) {
  const Grid& grid = run.workspace.grids.of(static_cast<int>(before.P.size()) - 1);
  const double length = run.state.exit - run.setting.inlet;
  const double moved = (grid.slope * (run.state.P - before.P).abs()).sum() / grid.n * length;
  return moved < near_share * std::numbers::pi / 2;
}

}  // namespace

// Beyond the calibrated range every map is made with full care: the grids of a map made with less may miss the spike,
// or end above the tolerance. Of 60 contacts (M = 5e3..1e6, L = 0.5..100, both laws) four did so at 3e-3, and three
// films missed their error; with full care none. Asked for H_cen alone to 1e-6, seven did so; with full care one.
Care care_for(const Request& request, const Groups& groups) {
  const double M = groups.M, L = groups.L;
  const FilmTolerances& asked = request.tolerance;
  if (!is_calibrated(groups)) return Care::full;
  const bool spike_near_centre = M > least_centre_M && M < largest_centre_M && L > least_centre_L;
  if (!request.nodes && !asked.minimum && asked.central && L <= mild_L && !spike_near_centre) return Care::least;
  constexpr double any_error = std::numeric_limits<double>::infinity();
  if (request.nodes || asked.minimum.value_or(any_error) < loose_tolerance ||
      asked.central.value_or(any_error) < loose_central_tolerance)
    return Care::full;
  return asked.tightest() >= loosest_tolerance || L <= least_care_L ? Care::least : Care::little;
}

MapFit map_fit(const Recipe& recipe, Care care) {
  if (!recipe.remaps || care == Care::least) return MapFit::first;
  return care == Care::full ? MapFit::settled : MapFit::again;
}

Attempt solve_on(Run& run, double film, const Target& target) {
  const State begin = run.state;
  Attempt attempt = newton_on(run, run.state, target);
  if (attempt.succeeded || run.limit_reached) return attempt;
  run.state = begin;
  Grid& grid = run.workspace.grids.of(static_cast<int>(begin.P.size()) - 1);
  run.state.offset = offset_for(film, run.setting, run.state, grid);
  attempt = newton_on(run, run.state, target);
  if (attempt.succeeded || run.limit_reached) return attempt;
  run.state = begin;
  return lower_floor(run, run.state, target);
}

std::optional<Known> start(Run& run, const Recipe& recipe, const Solution* from, Care care) {
  const Tables of_maps = tables_of_maps(run);
  auto grids = recipe.remaps ? grids_for_maps(care) : std::span<const int>();
  // At loose tolerances a neighbour's solution costs more steps than a start from nothing: 634 against 546 at 24
  // problems, 2 and 10 % away in M and L. At tighter ones it saves a tenth.
  if (from && care == Care::full) {
    const Known known = known_of(from->fields);
    const InletTail tail = run.setting.with_tail ? first_tail(run.setting, run.lengths.film) : InletTail{};
    run.state = on_new_map(run, known, tail, recipe.map, of_maps, 2 * recipe.fineness * first_mapped_nodes);
    const State before = run.state;
    level_spike(run.state.P);
    run.state.offset =
        offset_for(known.film, run.setting, run.state, grid_of(run, 2 * recipe.fineness * first_mapped_nodes));
    if (!solve_on(run, known.film, for_maps).succeeded) return std::nullopt;
    if (was_near(run, before)) grids = {};
  } else {
    use_first_map(run, recipe.map, recipe.remaps ? of_maps : run.tables);
    if (!cold_start(run, grid_of(run, recipe.fineness * recipe.first), for_maps).succeeded) return std::nullopt;
  }
  for (const int n : grids) {
    const Known known = known_now(run);
    run.state = on_new_map(run, known, run.state.tail, recipe.map, of_maps, recipe.fineness * n);
    if (!solve_on(run, known.film, for_maps).succeeded) return std::nullopt;
  }
  Known known = known_now(run);
  if (recipe.remaps)
    run.state = on_new_map(run, known, run.state.tail, recipe.map, run.tables, recipe.fineness * first_mapped_nodes);
  return known;
}

}  // namespace ehd::fast
