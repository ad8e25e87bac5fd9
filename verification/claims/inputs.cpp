// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 0: the same physics in other units, and in other groups, gives the same dimensionless problem.
#include <cmath>

#include "contact/nondimensional.hpp"
#include "contact/scalings.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"

namespace ehd::verification {

namespace {

Conditions steel() {
  return {.load_N_per_m = 1.7e5,
          .reduced_radius_m = 0.9e-2,
          .reduced_modulus_Pa = 2.27e11,
          .speed_sum_m_per_s = 2.3,
          .viscosity_Pa_s = 0.031};
}

Lubricant mineral_oil() {
  return {.viscosity = ViscosityLaw::roelands,
          .density = DensityLaw::incompressible,  // the density laws' constants are in Pa, whatever the units
          .alpha_per_Pa = 2.1e-8,
          .z = 0.63,
          .p0_Pa = 1.96e8};
}

double apart(double a, double b) { return std::abs(a - b) / std::abs(b); }

double apart(const Problem& a, const Problem& b) {
  const auto& one = std::get<Roelands>(a.viscosity);
  const auto& two = std::get<Roelands>(b.viscosity);
  return worse(apart(a.groups.M, b.groups.M), apart(a.groups.L, b.groups.L), apart(a.groups.lambda, b.groups.lambda),
               apart(a.groups.alpha_p_H, b.groups.alpha_p_H), apart(one.alpha, two.alpha), apart(one.p0, two.p0),
               apart(one.z, two.z));
}

/// The conversion of numbers from SI to groups and back, beside the groups of the problem.
Claim scalings_claim(const Groups& groups) {
  const std::vector<GivenNumber> in_SI{{"load_N_per_m", steel().load_N_per_m},
                                       {"reduced_radius_m", steel().reduced_radius_m},
                                       {"reduced_modulus_Pa", steel().reduced_modulus_Pa},
                                       {"speed_sum_m_per_s", *steel().speed_sum_m_per_s},
                                       {"viscosity_Pa_s", *steel().viscosity_Pa_s},
                                       {"alpha_per_Pa", *mineral_oil().alpha_per_Pa}};
  const auto value = [](const std::vector<GivenNumber>& given, std::string_view name) {
    const auto values = in_all_scalings(given);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (scaled_numbers()[i].name == name) return values[i].value_or(nothing);
    return nothing;
  };
  std::vector<GivenNumber> back{{"M", groups.M}, {"L", groups.L}};
  for (const std::size_t i : {1U, 2U, 4U, 5U}) back.push_back(in_SI[i]);
  const DowsonGroups dowson{.W = value(in_SI, "W"), .U_mean = value(in_SI, "U_mean"), .G = value(in_SI, "G")};
  return claim({.id = "inputs/scalings",
                .rung = 0,
                .statement = "a contact converted from SI has the problem's groups, and converted back its load"},
               worse(apart(value(in_SI, "M"), groups.M), apart(value(in_SI, "L"), groups.L),
                     apart(value(in_SI, "lambda"), groups.lambda), apart(value(in_SI, "alpha_p_H"), groups.alpha_p_H),
                     apart(moes_from(dowson).M, groups.M), apart(moes_from(dowson).L, groups.L),
                     apart(value(back, "load_N_per_m"), steel().load_N_per_m)),
               0, Tolerance::round_off(64, 30));  // through logarithms, whose size is up to 30
}

Findings judge_inputs() {
  Findings found;
  const Problem in_SI = nondimensionalise(steel(), mineral_oil(), Flooded{}).problem;

  // inch, pound-force, minute
  const double length = 0.0254, force = 4.4482216152605, time = 60, pressure = force / (length * length);
  Conditions conditions = steel();
  conditions.load_N_per_m /= force / length;
  conditions.reduced_radius_m /= length;
  conditions.reduced_modulus_Pa /= pressure;
  *conditions.speed_sum_m_per_s /= length / time;
  *conditions.viscosity_Pa_s /= pressure * time;
  Lubricant lubricant = mineral_oil();
  *lubricant.alpha_per_Pa *= pressure;
  lubricant.p0_Pa /= pressure;
  found.claims.push_back(
      claim({.id = "inputs/units",
             .rung = 0,
             .statement = "a contact in inches, pounds and minutes is the same dimensionless problem"},
            apart(nondimensionalise(conditions, lubricant, Flooded{}).problem, in_SI), 0, rounding()));

  const MoesGroups moes{.M = in_SI.groups.M, .L = in_SI.groups.L};
  const HertzGroups hertz{.lambda = in_SI.groups.lambda, .alpha_p_H = in_SI.groups.alpha_p_H};
  for (const Statement& statement : {Statement{moes}, Statement{hertz}}) {
    const bool is_moes = std::holds_alternative<MoesGroups>(statement);
    found.claims.push_back(
        claim({.id = is_moes ? "inputs/moes" : "inputs/hertz",
               .rung = 0,
               .statement = std::string("a contact stated by ") + (is_moes ? "M and L" : "lambda and alpha p_H") +
                            " is the same dimensionless problem as in SI"},
              apart(nondimensionalise(statement, mineral_oil(), Flooded{}).problem, in_SI), 0, rounding()));
  }

  const DowsonGroups mean{.W = steel().load_N_per_m / (steel().reduced_modulus_Pa * steel().reduced_radius_m),
                          .U_mean = *steel().viscosity_Pa_s * (*steel().speed_sum_m_per_s / 2) /
                                    (steel().reduced_modulus_Pa * steel().reduced_radius_m),
                          .G = *mineral_oil().alpha_per_Pa * steel().reduced_modulus_Pa};
  const MoesGroups from_mean = moes_from(mean);
  found.claims.push_back(
      claim({.id = "inputs/mean-speed",
             .rung = 0,
             .statement = "Dowson's groups with the mean speed and Moes' with the sum are one contact"},
            worse(apart(from_mean.M, moes.M), apart(from_mean.L, moes.L)), 0, rounding()));

  found.claims.push_back(scalings_claim(in_SI.groups));
  return found;
}

}  // namespace

std::vector<Topic> input_topics() { return {{.name = "inputs", .rungs = {0}, .judge = judge_inputs}}; }

}  // namespace ehd::verification
