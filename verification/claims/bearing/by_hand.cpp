// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/bearing/by_hand.hpp"

#include <cmath>
#include <numbers>

#include "contact/nondimensional.hpp"
#include "verification/solution_memory.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

ByHand by_hand(const BearingCase& body, bool inner) {
  const auto& g = body.geometry;
  const double raceway =
      inner ? (g.pitch_diameter_m - g.roller_diameter_m) / 2 : (g.pitch_diameter_m + g.roller_diameter_m) / 2;
  const double w_inner = body.operation.inner_speed_rpm * pi / 30, w_outer = body.operation.outer_speed_rpm * pi / 30;
  // The cage moves with the centre of a roller, half way between two points that move with the rings.
  const double inner_surface = w_inner * (g.pitch_diameter_m - g.roller_diameter_m) / 2;
  const double outer_surface = w_outer * (g.pitch_diameter_m + g.roller_diameter_m) / 2;
  const double cage = (inner_surface + outer_surface) / g.pitch_diameter_m;
  const double ring = inner ? w_inner : w_outer, roller = g.roller_diameter_m / 2;
  return {.radius_m = inner ? roller * raceway / (raceway + roller) : roller * raceway / (raceway - roller),
          .modulus_Pa = body.modulus_Pa / (1 - body.poisson * body.poisson),
          .sum_speed_m_per_s = 2 * std::abs(ring - cage) * raceway,
          .length_m = g.length_m};
}

double scale_m(const ByHand& contact, double force_N) {
  return 4 * force_N / contact.length_m / (pi * contact.modulus_Pa);
}
double half_width_m(const ByHand& contact, double force_N) {
  return std::sqrt(8 * force_N / contact.length_m * contact.radius_m / (pi * contact.modulus_Pa));
}

double dry_m(const ByHand& contact, double force_N, double datum_m) {
  return scale_m(contact, force_N) * (std::log(2 * datum_m / half_width_m(contact, force_N)) + 0.5);
}

namespace {

/// Int H^3 exp(-ln eta)/lambda P'^2 dX with cells of `every` intervals: of P' the difference, of the fluidity the
/// logarithmic mean, which is right where ln eta is linear.
double dissipation_in_cells(const Fields& fields, double lambda, Eigen::Index every) {
  double sum = 0;
  for (Eigen::Index i = 0; i + every < fields.X.size(); i += every) {
    const Eigen::Index j = i + every;
    const double film = (fields.H[i] + fields.H[j]) / 2, rise = fields.P[j] - fields.P[i];
    const double thin = std::exp(-fields.log_viscosity[i]), thick = std::exp(-fields.log_viscosity[j]);
    const double drop = fields.log_viscosity[j] - fields.log_viscosity[i];
    const double fluidity = std::abs(drop) < 1e-6 ? (thin + thick) / 2 : (thin - thick) / drop;
    sum += film * film * film * fluidity / lambda * rise * rise / (fields.X[j] - fields.X[i]);
  }
  return sum;
}

}  // namespace

SolvedByHand solved_by_hand(const BearingCase& body, bool inner, double force_N) {
  const ByHand contact = by_hand(body, inner);
  const Conditions conditions{.load_N_per_m = force_N / contact.length_m,
                              .reduced_radius_m = contact.radius_m,
                              .reduced_modulus_Pa = contact.modulus_Pa,
                              .speed_sum_m_per_s = contact.sum_speed_m_per_s,
                              .viscosity_Pa_s = body.lubricant->viscosity_Pa_s};
  const Problem problem = nondimensionalise(conditions, body.lubricant->lubricant, Flooded{}).problem;
  const Solution solution = remembered(certified_solver().name).solve(problem, {.tolerance = 1e-6});
  if (!converged(solution)) return {nothing, nothing, nothing, nothing, nothing};
  const double b = half_width_m(contact, force_N), unit = b * b / contact.radius_m;
  constexpr double dry_offset = -0.25 - std::numbers::ln2 / 2;
  // T* = F_t R/(p_H b^2). The power u_m Int h p' dx is that of Int H P' dX times u_m p_H b^2/R.
  const double pressure_Pa = 2 * force_N / contact.length_m / (pi * b), rolling_unit = pressure_Pa * unit;
  const double lambda = problem.groups.lambda;
  const double dissipation = dissipation_in_cells(solution.fields, lambda, 1),
               coarse = dissipation_in_cells(solution.fields, lambda, 2);
  return {.offset_film_m = unit * (solution.observables.at(Quantity::film_offset).value - dry_offset),
          .film_minimum_m = unit * solution.observables.at(Quantity::film_minimum).value,
          .rolling_force_N_per_m = rolling_unit * solution.observables.at(Quantity::rolling_force).value,
          .dissipation_W_per_m = rolling_unit * contact.sum_speed_m_per_s / 2 * dissipation,
          .dissipation_error = std::abs(coarse / dissipation - 1)};
}

Sentence sentence(const std::string& id, const std::string& statement) {
  return {.id = "bearing/" + id, .rung = 11, .statement = statement};
}

Tolerance film_tolerance() {
  return Tolerance::required(1e-3, "ten times the 1e-4 that a bearing asks of its contacts");
}

}  // namespace ehd::verification::bearing_parts
