// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/discretiser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/observables.hpp"
#include "reference/lengths.hpp"

namespace ehd::reference::hp {

namespace {

/// X_a of a flooded domain in units of l, with the tail before it; docs/certified-solver.md, section 5.
constexpr double flooded_inlet = -800;

/// The second discretisation: this much more degree, breakpoints shifted by this part of an element, a flooded domain
/// that begins at this part of X_a. Gauss points instead of left Radau were tried: their odd-even mode makes meshes
/// five times finer where the fluidity vanishes.
constexpr int second_degree = 3;
constexpr double second_shift = 0.37, second_inlet_part = 0.5;

/// Where the start tries: floors of the fluidity, films over the expected one.
constexpr double start_floors[] = {1e-2, 3e-2, 1e-1, 3e-1, 1.0};
/// Expected films above this one try the rigid gap's pressure before Hertz'.
constexpr double thick_film = 0.5;

/// A film that would still move by this part of the tolerance has settled.
constexpr double settled_part = 0.2;
/// Resolution of a spike whose height is read.
constexpr double finest_spike = 1e-8;

/// Newton's method: iterations, and the step at which it ends.
constexpr NewtonLimits start_newton{.iterations = 40, .step = 1e-4};
constexpr NewtonLimits coarse_newton{.iterations = 25, .step = 1e-4};
constexpr NewtonLimits scheme_newton{.iterations = 20, .step = 1e-9};
// No finer mesh follows here, so that all iterations may be used.
constexpr NewtonLimits given_mesh_newton{.iterations = 30, .patience = 30, .step = 1e-9};

/// The mesh of a given number of intervals is laid out to these errors.
constexpr Resolution layout_resolution{.film = 1e-8, .spike = 1e-3};

/// The degree of a mesh of at least so many intervals. Few intervals do better with low degrees, as many elements can
/// then follow the solution.
struct DegreeFrom {
  int intervals, degree;
};
constexpr DegreeFrom degrees[] = {{400, 12}, {160, 8}, {80, 6}};
constexpr int lowest_degree = 4;

int degree_for(int intervals) {
  for (const DegreeFrom& from : degrees)
    if (intervals >= from.intervals) return from.degree;
  return lowest_degree;
}

/// Rounding of a film in units of the machine's epsilon and of the terms that H is a difference of.
constexpr double rounding_units = 10;

/// Where a floor stays under the fluidity, the limits of the second discretisation for films and pressure are those of
/// the first one times this. With the same limits both had the same error at the steep layer: at (110.2, 25.69), Barus,
/// alpha 1.1e-8, cut at -4, asked for 4e-5, their films differed by 6e-7, and both were off by 1.4e-5.
constexpr double second_limits = 0.1;

Resolution finer(Resolution resolution) {
  resolution.film *= second_limits;
  resolution.spike *= second_limits;
  return resolution;
}

/// The second discretisation that goes with a scheme.
Scheme second_to(const Scheme& scheme) {
  return {.points = Points::left_radau,
          .degree = scheme.degree + second_degree,
          .shift = second_shift,
          .inlet_part = second_inlet_part};
}

}  // namespace

Discretiser::Discretiser(const Problem& problem, const Meter& meter)
    : problem_(problem), wanted_(problem.wanted), meter_(meter) {
  wanted_.insert({Quantity::film_minimum, Quantity::film_central});
  film_ = expected_film({problem.groups.M, problem.groups.L});
  length_ = contact_length(film_);
  inlet_zone_ = length_ * inlet_zone(film_);
  const auto* truncated = std::get_if<TruncatedAt>(&problem.inlet);
  flooded_ = !truncated;
  inlet_ = truncated ? truncated->x : flooded_inlet * length_;
}

std::optional<Resolved> Discretiser::start() {
  const double exit =
      std::max(1 + exit_per_inlet_zone * inlet_zone_ / length_, exit_per_film_length * std::sqrt(2 * film_));
  const Mesh mesh = seeded_mesh({.inlet = inlet_, .exit = exit, .length = length_, .inlet_zone = inlet_zone_});
  const auto equations = std::make_shared<const Collocation<double>>(problem_, mesh, Points::left_radau);
  const HomotopyLimits limits{.newton = start_newton};
  for (const double floor : start_floors) {
    for (const double factor : start_films) {
      for (const bool rigid : {film_ > thick_film, film_ <= thick_film}) {
        Resolved guess{.equations = equations, .run = {}, .floor = floor};
        guess.run.state =
            rigid ? martin_start(*equations, exit, factor * film_) : hertz_start(*equations, exit, factor * film_);
        if (auto solved = resolved(problem_, guess, Resolution{}, limits, meter_)) return solved;
      }
      if (meter_.spent()) return std::nullopt;
    }
  }
  return std::nullopt;
}

std::vector<Resolved> Discretiser::coarse_descent(const Resolved& top, double tolerance) {
  return descent(problem_, top, Resolution{}, {.settled = settled_part * tolerance, .newton = coarse_newton}, meter_);
}

/// Solves by the scheme at one floor. The first mesh is made from the mesh of `from`.
std::optional<Resolved> Discretiser::on_mesh_of(const Resolved& from, const Scheme& scheme,
                                                const Resolution& resolution, const HomotopyLimits& limits) {
  Mesh mesh = with_degree(from.equations->mesh(), scheme.degree);
  if (scheme.shift > 0) mesh = shifted(std::move(mesh), scheme.shift);
  if (flooded_ && scheme.inlet_part < 1)
    mesh = cut_at(std::move(mesh), scheme.inlet_part * inlet_, from.run.state.exit);
  return resolved(problem_, moved_to(problem_, from, std::move(mesh), scheme.points), resolution, limits, meter_);
}

/// Newton's method on a mesh that stays as it is.
std::optional<Resolved> Discretiser::as_it_is(const Resolved& start, const HomotopyLimits& limits) {
  Resolved done = start;
  done.run = newton(*start.equations, start.run.state, start.floor, limits.newton, meter_);
  if (!done.run.solved) return std::nullopt;
  return done;
}

/// What can be read off the last floor. Where the resolution is fine and there is a spike, the spike is resolved first.
Discretised Discretiser::observed(std::vector<Resolved> floors, Resolution resolution, const HomotopyLimits& limits) {
  Discretised done;
  done.floors = std::move(floors);
  done.fields = fields_of(problem_, done.last());
  done.seen = observe(done.fields, wanted_);
  if (done.last().floor == 0 && done.seen.contains(Quantity::pressure_spike) && resolution.film <= fine_tolerance) {
    resolution.spike = finest_spike;
    if (auto solved = resolved(problem_, done.last(), resolution, limits, meter_)) {
      done.floors.back() = std::move(*solved);
      done.fields = fields_of(problem_, done.last());
      done.seen = observe(done.fields, wanted_);
    }
  }
  return done;
}

std::optional<Discretised> Discretiser::discretised(const std::vector<Resolved>& floors, const Scheme& scheme,
                                                    const Resolution& resolution, double tolerance) {
  const HomotopyLimits limits{.settled = settled_part * tolerance, .newton = scheme_newton};
  for (auto from = floors.rbegin(); from != floors.rend() && !meter_.spent(); ++from) {
    const auto top = on_mesh_of(*from, scheme, resolution, limits);
    if (!top) continue;
    Discretised done = observed(descent(problem_, *top, resolution, limits, meter_, floors), resolution, limits);
    // An extrapolation needs two floors, and a third one to judge it. Where they are missing, higher floors are solved.
    for (auto above = from; done.last().floor > 0 && floors_apart(done.floors).size() < 3 && above != floors.rend();
         ++above) {
      if (above->floor < floor_ratio * done.floors.front().floor) continue;
      if (auto solved = on_mesh_of(*above, scheme, resolution, limits))
        done.floors.insert(done.floors.begin(), std::move(*solved));
    }
    carry_to_zero(problem_, wanted_, done);
    return done;
  }
  return std::nullopt;
}

std::optional<DiscretisedTwice> Discretiser::discretised_twice(const std::vector<Resolved>& coarse,
                                                               const Scheme& scheme, const Resolution& resolution,
                                                               double tolerance) {
  auto first = discretised(coarse, scheme, resolution, tolerance);
  if (!first) return std::nullopt;
  const Resolution closer = first->last().floor > 0 ? finer(resolution) : resolution;
  auto second = discretised(first->floors, second_to(scheme), closer, tolerance);
  if (!second) second = discretised(coarse, second_to(scheme), closer, tolerance);
  if (!second) return std::nullopt;
  return DiscretisedTwice{std::move(*first), std::move(*second)};
}

std::optional<Discretised> Discretiser::laid_out(const Discretised& guide, const std::vector<Resolved>& coarse,
                                                 int intervals) {
  std::vector<Resolved> floors = coarse;
  floors.insert(floors.end(), guide.floors.begin(), guide.floors.end());
  const HomotopyLimits limits{.newton = given_mesh_newton};
  for (auto from = floors.rbegin(); from != floors.rend() && !meter_.spent(); ++from) {
    const auto excess = excess_of(*from->equations, from->run, problem_, layout_resolution);
    const int elements = intervals / degree_for(intervals);
    Mesh mesh =
        with_intervals(with_elements(from->equations->mesh(), excess, elements, limits.shortest_element), intervals);
    Resolved start = moved_to(problem_, *from, std::move(mesh), Points::left_radau);
    start.floor = 0;
    if (auto solved = as_it_is(start, limits)) return observed({std::move(*solved)}, {}, limits);
  }
  return std::nullopt;
}

std::optional<Discretised> Discretiser::second_opinion(const Discretised& first) {
  const HomotopyLimits limits{.newton = given_mesh_newton};
  const Scheme other = second_to({});
  Mesh mesh = shifted(first.last().equations->mesh(), other.shift);
  for (int& degree : mesh.degrees) degree = (3 * degree + 1) / 2;
  if (flooded_) mesh = cut_at(std::move(mesh), other.inlet_part * inlet_, first.last().run.state.exit);
  auto solved = as_it_is(moved_to(problem_, first.last(), std::move(mesh), Points::left_radau), limits);
  if (!solved) return std::nullopt;
  return observed({std::move(*solved)}, {}, limits);
}

double Discretiser::rounding_of(double film) const {
  return rounding_units * std::numeric_limits<double>::epsilon() * (1 + length_ * length_ / 2) / film;
}

}  // namespace ehd::reference::hp
