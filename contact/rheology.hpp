// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity and density of the lubricant as functions of pressure.
//
// A law is one struct. The concepts ViscosityFormula and DensityFormula list what each law must answer. A law that
// leaves out one answer does not compile, and no function below has a default for unknown laws.
//
// Every viscosity law returns ln(eta/eta_0), never eta: Barus at (M, L) = (5000, 30) reaches e^846. A law is written
// for pressures in some unit. The unit is 1 Pa in a case file and the Hertz pressure p_H inside a Problem
// (in_units_of). Iterates may stray below zero pressure. There each law continues along its tangent at zero.
#pragma once

#include <concepts>
#include <string_view>
#include <variant>
#include <vector>

#include "contact/array.hpp"

namespace ehd {

/// A law on a field: its value (ln(eta/eta_0), or rho/rho_0) and the derivative to pressure, node by node.
template <class Scalar>
struct LawValues {
  ArrayOf<Scalar> value;
  ArrayOf<Scalar> slope;
};

/// A number of a law. The name is that of ehd cases --json, where pressures are in units of p_H.
struct LawParameter {
  std::string_view name;
  double value;
};

/// The keys of a case's [lubricant] that a viscosity law reads. z is Roelands' exponent: a law that reads z gets alpha
/// from z, or z from alpha, where the case states one of them and eta_0.
struct LawKeys {
  bool alpha_per_Pa = false;
  bool z = false;
  bool p0_Pa = false;
};

/// The values of these keys for pressures in one common unit.
struct LawInputs {
  double alpha = 0;  ///< 1/pressure
  double p0 = 0;     ///< pressure
  double z = 0;
};

// ---- viscosity laws ------------------------------------------------------------------------------------------------

/// eta = eta_0.
struct Isoviscous {
  static constexpr std::string_view name = "isoviscous";
  static constexpr std::string_view formula = "ln(eta/eta_0) = 0";
  static constexpr LawKeys keys{};
  static constexpr bool trivial = true;

  [[nodiscard]] static Isoviscous from(const LawInputs& /*inputs*/) { return {}; }
  [[nodiscard]] Isoviscous in_units_of(double /*unit*/) const { return {}; }
  [[nodiscard]] double ambient_slope() const { return 0; }
  [[nodiscard]] std::vector<LawParameter> parameters() const { return {}; }

  template <class Scalar>
  void evaluate(const ArrayOf<Scalar>& /*pressure*/, LawValues<Scalar>& out) const {
    out.value.setZero();
    out.slope.setZero();
  }
};

/// ln(eta/eta_0) = alpha p. alpha: 1/pressure.
struct Barus {
  static constexpr std::string_view name = "barus";
  static constexpr std::string_view formula = "ln(eta/eta_0) = alpha_p_H P";
  static constexpr LawKeys keys{.alpha_per_Pa = true};
  static constexpr bool trivial = false;

  double alpha = 0;

  [[nodiscard]] static Barus from(const LawInputs& inputs) { return {inputs.alpha}; }
  [[nodiscard]] Barus in_units_of(double unit) const { return {alpha * unit}; }
  [[nodiscard]] double ambient_slope() const { return alpha; }
  [[nodiscard]] std::vector<LawParameter> parameters() const {
    const auto& [own_alpha] = *this;  // names every member: a further one does not compile here
    return {{"alpha_p_H", own_alpha}};
  }

  template <class Scalar>
  void evaluate(const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) const {
    out.value = Scalar(alpha) * pressure;
    out.slope.setConstant(Scalar(alpha));
  }
};

/// ln(eta/eta_0) = (alpha p_0/z) ((1 + p/p_0)^z - 1). alpha: 1/pressure; p_0: pressure; z: 1.
struct Roelands {
  static constexpr std::string_view name = "roelands";
  static constexpr std::string_view formula = "ln(eta/eta_0) = (alpha_p_H p0_over_p_H/z) ((1 + P/p0_over_p_H)^z - 1)";
  static constexpr LawKeys keys{.alpha_per_Pa = true, .z = true, .p0_Pa = true};
  static constexpr bool trivial = false;

  double alpha = 0;
  double p0 = 0;
  double z = 0;

  [[nodiscard]] static Roelands from(const LawInputs& inputs) {
    return {.alpha = inputs.alpha, .p0 = inputs.p0, .z = inputs.z};
  }
  [[nodiscard]] Roelands in_units_of(double unit) const { return {.alpha = alpha * unit, .p0 = p0 / unit, .z = z}; }
  [[nodiscard]] double ambient_slope() const { return alpha; }
  [[nodiscard]] std::vector<LawParameter> parameters() const {
    const auto& [own_alpha, own_p0, own_z] = *this;  // names every member: a further one does not compile here
    return {{"alpha_p_H", own_alpha}, {"p0_over_p_H", own_p0}, {"z", own_z}};
  }

  template <class Scalar>
  void evaluate(const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) const {
    const Scalar a(alpha), p_0(p0), exponent(z), zero(0), one(1);
    const Scalar scale = a * p_0 / exponent;
    out.slope = one + pressure.max(zero) / p_0;
    out.value = (exponent * out.slope.log()).exp();                  // (1 + p/p_0)^z
    out.slope = a * out.value / out.slope;                           // alpha (1 + p/p_0)^(z-1)
    out.value = scale * (out.value - one) + a * pressure.min(zero);  // tangent below zero
  }
};

using Viscosity = std::variant<Isoviscous, Barus, Roelands>;

// ---- density laws --------------------------------------------------------------------------------------------------

/// rho = rho_0.
struct Incompressible {
  static constexpr std::string_view name = "incompressible";
  static constexpr std::string_view formula = "rho/rho_0 = 1";
  static constexpr bool trivial = true;

  [[nodiscard]] Incompressible in_units_of(double /*unit*/) const { return {}; }
  [[nodiscard]] std::vector<LawParameter> parameters() const { return {}; }

  template <class Scalar>
  void evaluate(const ArrayOf<Scalar>& /*pressure*/, LawValues<Scalar>& out) const {
    out.value.setOnes();
    out.slope.setZero();
  }
};

/// rho/rho_0 = 1 + a p/(1 + c p); a, c: 1/pressure. Both printed Dowson-Higginson forms are of this shape.
struct DowsonHigginson {
  static constexpr std::string_view name = "dowson-higginson";
  static constexpr std::string_view formula = "rho/rho_0 = 1 + density_a P/(1 + density_c P)";
  static constexpr bool trivial = false;

  double a = 0;
  double c = 0;

  [[nodiscard]] DowsonHigginson in_units_of(double unit) const { return {.a = a * unit, .c = c * unit}; }
  [[nodiscard]] std::vector<LawParameter> parameters() const {
    const auto& [own_a, own_c] = *this;  // names every member: a further one does not compile here
    return {{"density_a", own_a}, {"density_c", own_c}};
  }

  template <class Scalar>
  void evaluate(const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) const {
    const Scalar slope_at_0(a), saturation(c), zero(0), one(1);
    out.slope = (one + saturation * pressure.max(zero)).inverse();
    out.value = one + slope_at_0 * pressure.max(zero) * out.slope + slope_at_0 * pressure.min(zero);
    out.slope = slope_at_0 * out.slope.square();
  }
};

using Density = std::variant<Incompressible, DowsonHigginson>;

/// (5.9e8 + 1.34 p)/(5.9e8 + p), p in Pa; limit 1.340.
[[nodiscard]] constexpr DowsonHigginson dowson_higginson_per_Pa() { return {.a = 0.34 / 5.9e8, .c = 1 / 5.9e8}; }
/// 1 + 0.6e-9 p/(1 + 1.7e-9 p), p in Pa; limit 1.353: NOT the same law.
[[nodiscard]] constexpr DowsonHigginson dowson_higginson_1977_per_Pa() { return {.a = 0.6e-9, .c = 1.7e-9}; }

// ---- what every law answers ----------------------------------------------------------------------------------------

/// A law of density: its name, its formula in the names of its parameters, whether it is constant, its values.
template <class Law>
concept DensityFormula = requires(const Law law, double unit, const ArrayOf<double>& pressure, LawValues<double>& out) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::formula } -> std::convertible_to<std::string_view>;
  { Law::trivial } -> std::convertible_to<bool>;
  { law.in_units_of(unit) } -> std::same_as<Law>;
  { law.parameters() } -> std::same_as<std::vector<LawParameter>>;
  { law.evaluate(pressure, out) } -> std::same_as<void>;
};

/// A law of viscosity: the same, and how the law is made from the keys of a case.
template <class Law>
concept ViscosityFormula = DensityFormula<Law> && requires(const Law law, const LawInputs& inputs) {
  { Law::keys } -> std::convertible_to<LawKeys>;
  { Law::from(inputs) } -> std::same_as<Law>;
  { law.ambient_slope() } -> std::same_as<double>;
};

/// The same law for pressures measured in `unit` (itself in the law's present unit).
[[nodiscard]] Viscosity in_units_of(const Viscosity& law, double unit);
[[nodiscard]] Density in_units_of(const Density& law, double unit);

/// True where the law is constant. Solvers do not count such a law as evaluated.
[[nodiscard]] bool is_trivial(const Viscosity& law);
[[nodiscard]] bool is_trivial(const Density& law);

/// Slope of ln(eta/eta_0) at zero pressure.
[[nodiscard]] double ambient_slope(const Viscosity& law);

[[nodiscard]] std::string_view name(const Viscosity& law);
[[nodiscard]] std::string_view name(const Density& law);
[[nodiscard]] std::string_view formula(const Viscosity& law);
[[nodiscard]] std::string_view formula(const Density& law);
[[nodiscard]] std::vector<LawParameter> parameters(const Viscosity& law);
[[nodiscard]] std::vector<LawParameter> parameters(const Density& law);

/// The law as numbers, for the key of a cache: its place in the variant, then all its parameters. Two laws are the same
/// exactly if their keys are equal.
[[nodiscard]] std::vector<double> cache_key(const Viscosity& law);
[[nodiscard]] std::vector<double> cache_key(const Density& law);

/// ln(eta/eta_0) and its derivative. Storage of `out` is reused.
template <class Scalar>
void evaluate(const Viscosity& law, const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) {
  out.value.resize(pressure.size());
  out.slope.resize(pressure.size());
  std::visit([&](const ViscosityFormula auto& one) { one.evaluate(pressure, out); }, law);
}

/// rho/rho_0 and its derivative. Storage of `out` is reused.
template <class Scalar>
void evaluate(const Density& law, const ArrayOf<Scalar>& pressure, LawValues<Scalar>& out) {
  out.value.resize(pressure.size());
  out.slope.resize(pressure.size());
  std::visit([&](const DensityFormula auto& one) { one.evaluate(pressure, out); }, law);
}

template <class Law, class Scalar>
[[nodiscard]] LawValues<Scalar> evaluate(const Law& law, const ArrayOf<Scalar>& pressure) {
  LawValues<Scalar> out;
  evaluate(law, pressure, out);
  return out;
}

}  // namespace ehd
