// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions on adapted meshes, as the solver makes them, and what is read off them.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/observables.hpp"
#include "reference/hp/homotopy.hpp"
#include "tests/check.hpp"

namespace ehd::testing {

/// Iterations bound a solve. The time is for a slow and busy machine with the sanitizers in the build.
inline reference::hp::Meter generous() {
  return {.iterations_left = 5000, .end = std::chrono::steady_clock::now() + std::chrono::minutes(10)};
}

/// Graded for a film of about `film`, in Hertz units.
inline reference::hp::Mesh mesh_about(double inlet, double exit, double film, int degree) {
  const double length = std::max(1.0, std::sqrt(2 * film));
  return reference::hp::seeded_mesh({.inlet = inlet,
                                     .exit = exit,
                                     .length = length,
                                     .inlet_zone = length * std::pow(std::min(film, 1.0), 2.0 / 3),
                                     .degree = degree});
}

/// The coarse solution at a floor, from a Hertz start of the given film. Required to exist.
inline reference::hp::Resolved coarse_top(const Problem& problem, double film, double floor, double start_film) {
  using namespace reference::hp;
  const auto* cut = std::get_if<TruncatedAt>(&problem.inlet);
  const double exit = 1 + 0.45 * std::pow(film, 2.0 / 3);
  Resolved guess{.equations = std::make_shared<const Collocation<double>>(
                     problem, mesh_about(cut ? cut->x : -800, exit, film, 8), Points::left_radau),
                 .run = {},
                 .floor = floor};
  guess.run.state = hertz_start(*guess.equations, exit, start_film);
  Meter meter = generous();
  auto top = resolved(problem, guess, Resolution{}, {.newton = {.iterations = 40, .step = 1e-4}}, meter);
  BOOST_REQUIRE(top.has_value());
  return *top;
}

/// Down to the physics, and there on a mesh of the degree that resolves films to `tolerance`.
inline reference::hp::Resolved physics(const Problem& problem, double film, int degree, double tolerance,
                                       double spike = 1e-3) {
  using namespace reference::hp;
  Meter meter = generous();
  const Resolution resolution{.film = tolerance, .spike = spike, .defect = 1e-2};
  const auto coarse = descent(problem, coarse_top(problem, film, 1e-2, film), Resolution{},
                              {.settled = 0.2 * tolerance, .newton = {.iterations = 25, .step = 1e-4}}, meter);
  const HomotopyLimits limits{.newton = {.iterations = 20, .step = 1e-11}};
  for (auto from = coarse.rbegin(); from != coarse.rend(); ++from) {
    const auto start = moved_to(problem, *from, with_degree(from->equations->mesh(), degree), Points::left_radau);
    const auto top = resolved(problem, start, resolution, limits, meter);
    if (!top) continue;
    const auto floors = descent(problem, *top, resolution, limits, meter);
    if (floors.back().floor == 0) return floors.back();
  }
  BOOST_REQUIRE_MESSAGE(false, "no floor leads down to the physics");
  return coarse.back();
}

}  // namespace ehd::testing
