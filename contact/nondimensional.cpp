// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/nondimensional.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "contact/hertz.hpp"

namespace ehd {

using std::numbers::pi;

Groups groups_from(const MoesGroups& moes) {
  return {.M = moes.M,
          .L = moes.L,
          .lambda = 3 * pi * pi / (8 * moes.M * moes.M),
          .alpha_p_H = moes.L * std::sqrt(moes.M / (2 * pi))};
}

Groups groups_from(const HertzGroups& hertz) {
  const double M = std::sqrt(3 * pi * pi / (8 * hertz.lambda));
  return {.M = M,
          .L = hertz.alpha_p_H * std::sqrt(2 * pi / M),
          .lambda = hertz.lambda,
          .alpha_p_H = hertz.alpha_p_H};
}

double moes_film_per_hertz_film(double M) { return 8 * M / pi; }

MoesGroups moes_from(const DowsonGroups& groups) {
  const double U_s = 2 * groups.U_mean;
  return {.M = groups.W / std::sqrt(U_s), .L = groups.G * std::pow(U_s, 0.25)};
}

DowsonGroups dowson_from(const MoesGroups& moes, double G) {
  const double U_s = std::pow(moes.L / G, 4);
  return {.W = moes.M * std::sqrt(U_s), .U_mean = U_s / 2, .G = G};
}

std::optional<double> Scales::film_m_per_hertz_film() const {
  if (!half_width_m || !reduced_radius_m) return std::nullopt;
  return *half_width_m * (*half_width_m / *reduced_radius_m);
}

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// alpha and z in SI with Roelands' relation alpha = z (ln eta_0 + 9.67)/p_0 where one is left out.
struct RoelandsInSI {
  double alpha_per_Pa, z;
};

RoelandsInSI roelands_in_SI(const Lubricant& lubricant, std::optional<double> viscosity_Pa_s,
                            std::vector<std::string>& notes) {
  const double span = viscosity_Pa_s ? std::log(*viscosity_Pa_s) + 9.67 : 0;
  const auto need_span = [&](const char* missing) {
    if (!viscosity_Pa_s)
      throw StatementError(std::string("lubricant.") + missing,
                           "is missing; roelands needs both alpha_per_Pa and z where the viscosity eta_0 is unknown");
    if (!(span > 0))
      throw StatementError(std::string("lubricant.") + missing,
                           "cannot follow from alpha = z (ln eta_0 + 9.67)/p_0, which needs eta_0 > 6.3e-5 Pa s; "
                           "state both alpha_per_Pa and z");
  };
  if (lubricant.alpha_per_Pa && lubricant.z) {
    if (viscosity_Pa_s && span > 0) {
      const double implied = *lubricant.z * span / lubricant.p0_Pa;
      const double off = *lubricant.alpha_per_Pa / implied - 1;
      if (std::abs(off) > 1e-6)
        notes.push_back("alpha_per_Pa and z are used as given; alpha is " + number(100 * off) +
                        " % off alpha = z (ln eta_0 + 9.67)/p_0 = " + number(implied) + " 1/Pa");
    }
    return {*lubricant.alpha_per_Pa, *lubricant.z};
  }
  if (lubricant.z) {
    need_span("alpha_per_Pa");
    return {*lubricant.z * span / lubricant.p0_Pa, *lubricant.z};
  }
  if (lubricant.alpha_per_Pa) {
    need_span("z");
    const double z = *lubricant.alpha_per_Pa * lubricant.p0_Pa / span;
    if (!(z > 0))
      throw StatementError("lubricant.alpha_per_Pa", "makes z = " + number(z) + " by alpha = z (ln eta_0 + 9.67)/p_0; " +
                                                         "roelands needs alpha_per_Pa > 0");
    return {*lubricant.alpha_per_Pa, z};
  }
  throw StatementError("lubricant.alpha_per_Pa", "is missing; roelands needs alpha_per_Pa, z or both");
}

void require_in_range(const Groups& groups) {
  if (!(groups.M >= smallest_M && groups.M <= largest_M))
    throw StatementError("M", "M = " + number(groups.M) + " is out of range; allowed is 1e-3 to 1e6");
  if (!(groups.L >= 0 && groups.L <= largest_L))
    throw StatementError("L", "L = " + number(groups.L) + " is out of range; allowed is 0 to 100");
}

}  // namespace

Nondimensional nondimensionalise(const Statement& statement, const Lubricant& lubricant, const Inlet& inlet) {
  Nondimensional result;
  const auto* si = std::get_if<Conditions>(&statement);
  const auto* moes = std::get_if<MoesGroups>(&statement);
  const auto* hertz = std::get_if<HertzGroups>(&statement);

  // 1. The lubricant's pressure coefficient, in SI where it is stated there.
  const bool is_roelands = lubricant.viscosity == ViscosityLaw::roelands;
  std::optional<double> alpha_per_Pa = lubricant.alpha_per_Pa;
  double z = lubricant.z.value_or(0);
  if (lubricant.viscosity == ViscosityLaw::isoviscous && si) alpha_per_Pa = 0;
  if (is_roelands && si) {
    const auto law = roelands_in_SI(lubricant, si->viscosity_Pa_s, result.notes);
    alpha_per_Pa = law.alpha_per_Pa;
    z = law.z;
  }

  // 2. The groups, and the Hertz pressure in Pa where anything fixes it.
  std::optional<double> hertz_pressure_Pa;
  Groups& groups = result.problem.groups;
  if (moes) {
    groups = groups_from(*moes);
  } else if (hertz) {
    groups = groups_from(*hertz);
  } else {
    if (!si->speed_sum_m_per_s || !si->viscosity_Pa_s)
      throw StatementError(si->speed_sum_m_per_s ? "conditions.viscosity_Pa_s" : "conditions.speed_sum_m_per_s",
                           "is missing; a lubricated contact needs it");
    if (!alpha_per_Pa) throw StatementError("lubricant.alpha_per_Pa", "is missing; barus needs it");
    const double ER = si->reduced_modulus_Pa * si->reduced_radius_m;
    const DowsonGroups dowson{.W = si->load_N_per_m / ER,
                              .U_mean = *si->viscosity_Pa_s * *si->speed_sum_m_per_s / 2 / ER,
                              .G = *alpha_per_Pa * si->reduced_modulus_Pa};
    groups = groups_from(moes_from(dowson));
    hertz_pressure_Pa = hertz::pressure_Pa(*si);
    result.scales = Scales{.hertz_pressure_Pa = *hertz_pressure_Pa,
                           .half_width_m = hertz::half_width_m(*si),
                           .reduced_radius_m = si->reduced_radius_m,
                           .dowson = dowson};
    // An isoviscous solve has L = 0, but a stated alpha still gives G.
    result.scales->dowson->G = lubricant.alpha_per_Pa.value_or(*alpha_per_Pa) * si->reduced_modulus_Pa;
  }
  require_in_range(groups);
  result.problem.inlet = inlet;

  // 3. L = 0: the piezoviscous effect vanishes with p_H.
  if (groups.alpha_p_H == 0) {
    const bool trivial =
        lubricant.viscosity == ViscosityLaw::isoviscous && lubricant.density == DensityLaw::incompressible;
    if (si) {  // a known p_H: only the viscosity is trivial
      result.problem.viscosity = Isoviscous{};
    } else {
      if (!trivial) result.notes.push_back("L = 0 is solved isoviscous and incompressible: with it p_H -> 0");
      result.problem.viscosity = Isoviscous{};
      result.problem.density = Incompressible{};
      return result;
    }
  } else if (lubricant.viscosity == ViscosityLaw::isoviscous) {
    throw StatementError("lubricant.viscosity",
                         "isoviscous contradicts L > 0; allowed is barus or roelands, or L = 0");
  }

  // 4. p_H from alpha where groups alone are stated: p_H = alpha p_H/alpha.
  if (!hertz_pressure_Pa && alpha_per_Pa && *alpha_per_Pa > 0) {
    hertz_pressure_Pa = groups.alpha_p_H / *alpha_per_Pa;
    result.scales = Scales{.hertz_pressure_Pa = *hertz_pressure_Pa};
  }

  // 5. Laws in units of p_H.
  const auto need_pressure = [&](const char* key, std::string_view law) {
    if (!hertz_pressure_Pa)
      throw StatementError(key, std::string(law) +
                                    " needs pressures in Pa, and p_H is unknown; state lubricant.alpha_per_Pa, "
                                    "or the contact as [conditions]");
  };
  if (groups.alpha_p_H > 0) {
    if (is_roelands) {
      need_pressure("lubricant.viscosity", "roelands");
      if (!lubricant.z && !si)
        throw StatementError("lubricant.z", "is missing; roelands needs it where eta_0 is unknown");
      if (!(z > 0)) throw StatementError("lubricant.z", "z = " + number(z) + "; roelands needs z > 0");
      if (!(lubricant.p0_Pa > 0))
        throw StatementError("lubricant.p0_Pa", "p_0 = " + number(lubricant.p0_Pa) + " Pa; roelands needs p_0 > 0");
      if (!std::isfinite(lubricant.p0_Pa / *hertz_pressure_Pa))
        throw StatementError("L", "L = " + number(groups.L) + " is too small for roelands; L = 0 is its limit");
      result.problem.viscosity =
          Roelands{.alpha = groups.alpha_p_H, .p0 = lubricant.p0_Pa / *hertz_pressure_Pa, .z = z};
    } else {
      result.problem.viscosity = Barus{groups.alpha_p_H};
    }
  }
  if (lubricant.density != DensityLaw::incompressible) {
    need_pressure("lubricant.density", to_string(lubricant.density));
    const DowsonHigginson law = lubricant.density == DensityLaw::dowson_higginson
                                    ? dowson_higginson_per_Pa()
                                    : dowson_higginson_1977_per_Pa();
    result.problem.density = in_units_of(law, *hertz_pressure_Pa);
  }
  if (hertz_pressure_Pa && *hertz_pressure_Pa > 4e9)
    result.notes.push_back("p_H = " + number(*hertz_pressure_Pa / 1e9) +
                           " GPa is above 4 GPa: a numerical test, physically not steel");
  return result;
}

}  // namespace ehd
