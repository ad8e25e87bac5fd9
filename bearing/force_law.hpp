// SPDX-License-Identifier: GPL-3.0-or-later
// Contact force laws f(delta) of one roller contact behind one small interface. Every law is increasing, so it is
// stated in either direction: force(approach) with its slope, approach(force) with its slope.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "bearing/film_curve.hpp"
#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// f = coefficient delta^(10/9), 0 for delta <= 0. coefficient in N/m^(10/9).
struct PowerLaw {
  double coefficient = 0;

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const;
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;  ///< infinite at f = 0
  [[nodiscard]] double begins_at() const { return 0; }
};

/// `hertz`: f = 8.06e4 l^(8/9) delta^(10/9) in N and mm, Palmgren's law as rounded in print (Teutsch & Sauer 2004).
[[nodiscard]] PowerLaw palmgren_law(double length_m);
/// `iso`: f = 35948 * 2^(10/9) l^(8/9) delta^(10/9) in N and mm: two such contacts in series are c_L of ISO/TS 16281.
[[nodiscard]] PowerLaw iso_law(double length_m);

/// What the straight line says below its range.
enum class Unloading {
  at_zero_force,     ///< f = max(0, K delta + dF)
  at_zero_approach,  ///< f = 0 below delta = 0; at delta = 0 the contact carries anything from 0 to dF
};

/// `ehd-linear`: f = K delta + dF.
struct LinearLaw {
  double K_N_per_m = 0;
  double dF_N = 0;
  Unloading unloading = Unloading::at_zero_force;
  std::pair<double, double> fitted_N = {};  ///< contact forces between which the line was fitted

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const;
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;
  /// Below this approach the force is zero.
  [[nodiscard]] double begins_at() const;
};

/// `ehd`: the solver's own relation, delta(f) = delta_dry(f; x_0) - F(f), F the offset film of a FilmCurve. A film
/// always pushes: the force is positive at every approach. Above the heaviest solved load it goes on along its tangent,
/// for Newton's iterates; a force there is outside domain(). Throws std::domain_error at construction where the
/// approach would not increase with the force (a datum below half the contact's half width).
class CurveLaw {
 public:
  CurveLaw(std::shared_ptr<const FilmCurve> curve, double datum_m);

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const { return 1 / compliance(force(approach_m)); }
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;
  [[nodiscard]] double begins_at() const;  ///< -infinity
  [[nodiscard]] const FilmCurve& curve() const { return *curve_; }
  [[nodiscard]] double datum_m() const { return datum_m_; }

 private:
  std::shared_ptr<const FilmCurve> curve_;
  double datum_m_;
};

using ForceLaw = std::variant<PowerLaw, LinearLaw, CurveLaw>;

/// Force [N] at an approach [m]; 0 where the contact is unloaded.
[[nodiscard]] double force(const ForceLaw& law, double approach_m);
/// df/d(delta) [N/m]; 0 where the contact is unloaded.
[[nodiscard]] double stiffness(const ForceLaw& law, double approach_m);
/// The approach [m] at a force > 0 [N]; at 0 the one where contact begins (-infinity for `ehd`).
[[nodiscard]] double approach(const ForceLaw& law, double force_N);
/// d(delta)/df [m/N] at a force > 0.
[[nodiscard]] double compliance(const ForceLaw& law, double force_N);
/// The approach [m] below which the force is zero; -infinity for `ehd`.
[[nodiscard]] double begins_at(const ForceLaw& law);
/// The contact forces [N] for which the law is vouched for: the range of the fit, up to the heaviest solved load;
/// absent where there is no limit.
[[nodiscard]] std::optional<std::pair<double, double>> domain(const ForceLaw& law);

}  // namespace ehd::bearing
