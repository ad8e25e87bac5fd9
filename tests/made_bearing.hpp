// SPDX-License-Identifier: GPL-3.0-or-later
// A needle bearing and contacts in closed form. They test the composition of bearing and films without a solver.
#pragma once

#include <cmath>

#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::made {

inline Case needle_bearing(double clearance_m) {
  Case one;
  one.id = "needle";
  one.version = 3;
  one.places = {{"operation.speed_rpm", {7}}, {"operation", {5}}, {"", {1}}};
  one.file = "needle.toml";
  BearingCase body;
  body.geometry = {.rollers = 22,
                   .pitch_diameter_m = 0.053,
                   .roller_diameter_m = 0.005,
                   .length_m = 0.122,
                   .clearance_m = clearance_m,
                   .density_kg_per_m3 = 7850};
  body.operation = {.inner_speed_rpm = 5000, .outer_speed_rpm = 0, .radial_load_N = 50e3};
  body.modulus_Pa = 2.06e11;
  body.poisson = 0.3;
  Lubricant oil;
  oil.viscosity = ViscosityLaw::roelands;
  oil.density = DensityLaw::dowson_higginson;
  oil.alpha_per_Pa = 2e-8;
  body.lubricant = BearingLubricant{.lubricant = oil, .viscosity_Pa_s = 0.02};
  body.fit = {.load_N = std::pair{2000.0, 12000.0}, .points = 6};
  one.body = body;
  return one;
}

/// A contact whose films are powers of M, so that every number of the composition has a closed form. Its offset film
/// is stated to `stated`, relative, and is wrong by `share` of that.
inline Solution contact(const Problem& problem, double stated = 1e-6, double share = 0) {
  const double M = problem.groups.M;
  const double martin = 2.4474842468 / M / moes_film_per_hertz_film(M), stiffening = 1 + std::pow(M / 0.25, 1.5);
  const double film = martin * std::pow(stiffening, 0.58);
  Solution solution;
  solution.record.status = StopReason::converged;
  solution.observables[Quantity::film_minimum] = {.value = martin * std::pow(stiffening, 0.56), .error = 1e-6};
  solution.observables[Quantity::film_offset] = {.value = hertz::dry_offset() + film * (1 + share * stated),
                                                 .error = stated * film};
  return solution;
}

}  // namespace ehd::verification::made
