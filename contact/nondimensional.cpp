// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/nondimensional.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/hertz.hpp"
#include "contact/oil_laws.hpp"
#include "contact/overloaded.hpp"
#include "contact/text.hpp"

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
  return {.M = M, .L = hertz.alpha_p_H * std::sqrt(2 * pi / M), .lambda = hertz.lambda, .alpha_p_H = hertz.alpha_p_H};
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

/// alpha and z that differ by more than this from Roelands' relation get a note.
constexpr double exact_relation = 1e-6;

/// alpha and z as stated in SI, each where it is known.
struct StatedOil {
  std::optional<double> alpha_per_Pa;
  double z = 0;
};

/// Roelands' alpha and z. Where one of the two is left out, alpha = z (ln eta_0 + 9.67)/p_0 supplies it.
StatedOil roelands_in_SI(const Lubricant& lubricant, std::optional<double> viscosity_Pa_s,
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
      if (std::abs(off) > exact_relation)
        notes.push_back(fmt::format(
            "alpha_per_Pa and z are used as given; alpha is {} % off alpha = z (ln eta_0 + 9.67)/p_0 = {} 1/Pa",
            plain(100 * off), plain(implied)));
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
      throw StatementError("lubricant.alpha_per_Pa", "makes z = " + plain(z) + " by alpha = z (ln eta_0 + 9.67)/p_0; " +
                                                         "allowed is a number above 0, or viscosity = \"isoviscous\"");
    return {*lubricant.alpha_per_Pa, z};
  }
  throw StatementError("lubricant.alpha_per_Pa", "is missing; roelands needs alpha_per_Pa, z or both");
}

void require_in_range(const Groups& groups) {
  if (!(groups.M >= smallest_M && groups.M <= largest_M))
    throw StatementError("M", "M = " + plain(groups.M) +
                                  " is out of range; allowed is 1e-3 to 1e6; M = w/(E' R) (eta_0 u_s/(E' R))^(-1/2)");
  if (!(groups.L >= 0 && groups.L <= largest_L))
    throw StatementError(
        "L", "L = " + plain(groups.L) + " is out of range; allowed is 0 to 100; L = alpha E' (eta_0 u_s/(E' R))^(1/4)");
}

/// Stated numbers of the oil that the viscosity law does not read.
void note_unread(const Lubricant& lubricant, std::vector<std::string>& notes) {
  const ViscosityLawRow& law = row_of(lubricant.viscosity);
  const auto unread = [&](const char* key, double value, const char* unit) {
    notes.push_back(fmt::format("{} = {}{} has no effect: the viscosity law {} does not read it", key, plain(value),
                                unit, law.name));
  };
  if (lubricant.z && !law.keys.z) unread("z", *lubricant.z, "");
  if (lubricant.p0_Pa != roelands_pressure_Pa && !law.keys.p0_Pa) unread("p0_Pa", lubricant.p0_Pa, " Pa");
}

StatedOil oil_of(const Statement& statement, const Lubricant& lubricant, std::vector<std::string>& notes) {
  const LawKeys keys = row_of(lubricant.viscosity).keys;
  const auto* si = std::get_if<Conditions>(&statement);
  if (si && keys.z) return roelands_in_SI(lubricant, si->viscosity_Pa_s, notes);
  StatedOil oil{.alpha_per_Pa = lubricant.alpha_per_Pa, .z = lubricant.z.value_or(0)};
  if (si && !keys.alpha_per_Pa) oil.alpha_per_Pa = 0;
  return oil;
}

/// The groups of a statement, and the scales in SI where the statement fixes them.
struct Scaled {
  Groups groups;
  std::optional<Scales> scales;
};

Scaled scaled(const Conditions& si, const Lubricant& lubricant, const StatedOil& oil) {
  if (!si.speed_sum_m_per_s || !si.viscosity_Pa_s)
    throw StatementError(si.speed_sum_m_per_s ? "conditions.viscosity_Pa_s" : "conditions.speed_sum_m_per_s",
                         "is missing; a lubricated contact needs it");
  if (!oil.alpha_per_Pa)
    throw StatementError("lubricant.alpha_per_Pa",
                         "is missing; " + std::string(to_string(lubricant.viscosity)) + " needs it");
  const double ER = si.reduced_modulus_Pa * si.reduced_radius_m;
  const DowsonGroups dowson{.W = si.load_N_per_m / ER,
                            .U_mean = *si.viscosity_Pa_s * *si.speed_sum_m_per_s / 2 / ER,
                            .G = *oil.alpha_per_Pa * si.reduced_modulus_Pa};
  Scales scales{.hertz_pressure_Pa = hertz::pressure_Pa(si),
                .half_width_m = hertz::half_width_m(si),
                .reduced_radius_m = si.reduced_radius_m,
                .dowson = dowson};
  // An isoviscous solve has L = 0, but a stated alpha still gives G.
  scales.dowson->G = lubricant.alpha_per_Pa.value_or(*oil.alpha_per_Pa) * si.reduced_modulus_Pa;
  return {.groups = groups_from(moes_from(dowson)), .scales = scales};
}

Scaled scaled(const Statement& statement, const Lubricant& lubricant, const StatedOil& oil) {
  return std::visit(Overloaded{[](const MoesGroups& moes) -> Scaled {
                                 return {groups_from(moes), std::nullopt};
                               },
                               [](const HertzGroups& hertz) -> Scaled {
                                 return {groups_from(hertz), std::nullopt};
                               },
                               [&](const Conditions& si) { return scaled(si, lubricant, oil); }},
                    statement);
}

/// p_H in Pa, which the law `name` needs; `key` is the case's key that asks for the law.
double known_hertz_pressure_Pa(const std::optional<Scales>& scales, const char* key, std::string_view name) {
  if (!scales)
    throw StatementError(key, std::string(name) +
                                  " needs pressures in Pa, and p_H is unknown; state lubricant.alpha_per_Pa, "
                                  "or the contact as [conditions]");
  return scales->hertz_pressure_Pa;
}

/// The viscosity law in units of p_H; alpha p_H > 0.
Viscosity viscosity_of(const Lubricant& lubricant, const StatedOil& oil, bool in_SI, const Groups& groups,
                       const std::optional<Scales>& scales) {
  const ViscosityLawRow& law = row_of(lubricant.viscosity);
  LawInputs inputs{.alpha = groups.alpha_p_H};
  if (law.keys.p0_Pa) {
    const double hertz_pressure_Pa = known_hertz_pressure_Pa(scales, "lubricant.viscosity", law.name);
    const std::string name(law.name);
    if (!lubricant.z && !in_SI)
      throw StatementError("lubricant.z", "is missing; " + name + " needs it where eta_0 is unknown");
    if (!(oil.z > 0)) throw StatementError("lubricant.z", fmt::format("z = {}; {} needs z > 0", plain(oil.z), name));
    if (!(lubricant.p0_Pa > 0))
      throw StatementError("lubricant.p0_Pa",
                           fmt::format("p_0 = {} Pa; {} needs p_0 > 0", plain(lubricant.p0_Pa), name));
    if (!std::isfinite(lubricant.p0_Pa / hertz_pressure_Pa))
      throw StatementError("L", fmt::format("L = {} is too small for {}; L = 0 is its limit", plain(groups.L), name));
    inputs.p0 = lubricant.p0_Pa / hertz_pressure_Pa;
    inputs.z = oil.z;
  }
  return law.from(inputs);
}

/// The density law in units of p_H.
Density density_of(const Lubricant& lubricant, const std::optional<Scales>& scales) {
  const DensityLawRow& law = row_of(lubricant.density);
  if (is_trivial(law.per_Pa)) return law.per_Pa;
  const double hertz_pressure_Pa = known_hertz_pressure_Pa(scales, "lubricant.density", law.name);
  return in_units_of(law.per_Pa, hertz_pressure_Pa);
}

}  // namespace

Nondimensional nondimensionalise(const Statement& statement, const Lubricant& lubricant, const Inlet& inlet) {
  Nondimensional result;
  const bool in_SI = std::holds_alternative<Conditions>(statement);

  // 1. alpha and z in SI, then the groups, and the scales where the statement fixes them.
  note_unread(lubricant, result.notes);
  const StatedOil oil = oil_of(statement, lubricant, result.notes);
  const auto [groups, stated_scales] = scaled(statement, lubricant, oil);
  require_in_range(groups);
  result.scales = stated_scales;
  result.problem.groups = groups;
  result.problem.inlet = inlet;

  // 2. L = 0: the piezoviscous effect vanishes with p_H. Only conditions in SI keep p_H, and with it the density.
  const bool piezoviscous = row_of(lubricant.viscosity).keys.alpha_per_Pa;
  const bool compressible = lubricant.density != DensityLaw::incompressible;
  if (groups.alpha_p_H == 0 && !in_SI) {
    if (piezoviscous || compressible)
      result.notes.push_back("L = 0 is solved isoviscous and incompressible, because p_H -> 0");
    return result;
  }
  if (groups.alpha_p_H != 0 && !piezoviscous)
    throw StatementError("lubricant.viscosity", fmt::format("{} contradicts L > 0; allowed is {}, or L = 0",
                                                            to_string(lubricant.viscosity), piezoviscous_names()));

  // 3. p_H from alpha where groups alone are stated: p_H = alpha p_H/alpha.
  if (!result.scales && oil.alpha_per_Pa && *oil.alpha_per_Pa > 0)
    result.scales = Scales{.hertz_pressure_Pa = groups.alpha_p_H / *oil.alpha_per_Pa};

  // 4. Laws in units of p_H.
  if (groups.alpha_p_H > 0) result.problem.viscosity = viscosity_of(lubricant, oil, in_SI, groups, result.scales);
  result.problem.density = density_of(lubricant, result.scales);
  return result;
}

}  // namespace ehd
