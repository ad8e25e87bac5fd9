// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity and density of the lubricant as functions of pressure.
//
// Every law returns ln(eta/eta_0), never eta: Barus at (M, L) = (5000, 30) reaches e^846. A law is written for
// pressures in some unit; the unit is 1 Pa in a case file and the Hertz pressure p_H inside a Problem
// (in_units_of). Below zero pressure, where iterates may stray, each law continues along its tangent at zero.
#pragma once

#include <string_view>
#include <variant>

#include "contact/array.hpp"

namespace ehd {

/// eta = eta_0.
struct Isoviscous {};

/// ln(eta/eta_0) = alpha p. alpha: 1/pressure.
struct Barus {
  double alpha = 0;
};

/// ln(eta/eta_0) = (alpha p_0/z) ((1 + p/p_0)^z - 1). alpha: 1/pressure; p_0: pressure; z: 1.
struct Roelands {
  double alpha = 0;
  double p0 = 0;
  double z = 0;
};

using Viscosity = std::variant<Isoviscous, Barus, Roelands>;

/// rho = rho_0.
struct Incompressible {};

/// rho/rho_0 = 1 + a p/(1 + c p); a, c: 1/pressure. Both printed Dowson-Higginson forms are of this shape.
struct DowsonHigginson {
  double a = 0;
  double c = 0;
};

using Density = std::variant<Incompressible, DowsonHigginson>;

/// (5.9e8 + 1.34 p)/(5.9e8 + p), p in Pa; limit 1.340.
[[nodiscard]] DowsonHigginson dowson_higginson_per_Pa();
/// 1 + 0.6e-9 p/(1 + 1.7e-9 p), p in Pa; limit 1.353: NOT the same law.
[[nodiscard]] DowsonHigginson dowson_higginson_1977_per_Pa();

/// The same law for pressures measured in `unit` (itself in the law's present unit).
[[nodiscard]] Viscosity in_units_of(const Viscosity& law, double unit);
[[nodiscard]] Density in_units_of(const Density& law, double unit);

/// True where the law needs an exponential, a power or a division at each node; what is trivial is not evaluated.
[[nodiscard]] inline bool is_trivial(const Viscosity& law) { return std::holds_alternative<Isoviscous>(law); }
[[nodiscard]] inline bool is_trivial(const Density& law) { return std::holds_alternative<Incompressible>(law); }

/// Slope of ln(eta/eta_0) at zero pressure.
[[nodiscard]] double ambient_slope(const Viscosity& law);

[[nodiscard]] std::string_view name(const Viscosity& law);
[[nodiscard]] std::string_view name(const Density& law);

/// A law on a field: its value (ln(eta/eta_0), or rho/rho_0) and the derivative to pressure, node by node.
template <class Scalar>
struct LawValues {
  ArrayOf<Scalar> value;
  ArrayOf<Scalar> slope;
};

/// ln(eta/eta_0) and its derivative. Storage of `out` is reused.
template <class Scalar>
void evaluate(const Viscosity& law, const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) {
  const auto nodes = pressure.size();
  out.value.resize(nodes);
  out.slope.resize(nodes);
  if (const auto* barus = std::get_if<Barus>(&law)) {
    out.value = Scalar(barus->alpha) * pressure;
    out.slope.setConstant(Scalar(barus->alpha));
  } else if (const auto* roelands = std::get_if<Roelands>(&law)) {
    const Scalar alpha(roelands->alpha), p0(roelands->p0), z(roelands->z), zero(0), one(1);
    const Scalar scale = alpha * p0 / z;
    out.slope = one + pressure.max(zero) / p0;
    out.value = (z * out.slope.log()).exp();                            // (1 + p/p_0)^z
    out.slope = alpha * out.value / out.slope;                          // alpha (1 + p/p_0)^(z-1)
    out.value = scale * (out.value - one) + alpha * pressure.min(zero);  // tangent below zero
  } else {
    out.value.setZero();
    out.slope.setZero();
  }
}

/// rho/rho_0 and its derivative. Storage of `out` is reused.
template <class Scalar>
void evaluate(const Density& law, const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) {
  const auto nodes = pressure.size();
  out.value.resize(nodes);
  out.slope.resize(nodes);
  if (const auto* dh = std::get_if<DowsonHigginson>(&law)) {
    const Scalar a(dh->a), c(dh->c), zero(0), one(1);
    out.slope = (one + c * pressure.max(zero)).inverse();
    out.value = one + a * pressure.max(zero) * out.slope + a * pressure.min(zero);
    out.slope = a * out.slope.square();
  } else {
    out.value.setOnes();
    out.slope.setZero();
  }
}

template <class Law, class Scalar>
[[nodiscard]] LawValues<Scalar> evaluate(const Law& law, const ArrayOf<Scalar>& pressure) {
  LawValues<Scalar> out;
  evaluate(law, pressure, out);
  return out;
}

}  // namespace ehd
