// SPDX-License-Identifier: GPL-3.0-or-later
// Contact force laws f(delta) of one roller contact behind one small interface. Every law increases, so it has an
// inverse: force(approach) and approach(force), each with its slope.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "bearing/approach_formulas.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// f = coefficient delta^exponent, 0 for delta <= 0; exponent > 1. coefficient in N/m^exponent.
struct PowerLaw {
  double coefficient = 0;
  double exponent = 10.0 / 9.0;

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const;
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;  ///< infinite at f = 0
  [[nodiscard]] double rise(double from_N, double by_N) const;
  [[nodiscard]] double begins_at() const { return 0; }
};

/// `hertz`: f = 8.06e4 l^(8/9) delta^(10/9) in N and mm, Palmgren's law as rounded in print (Teutsch & Sauer 2004).
[[nodiscard]] PowerLaw palmgren_law(double length_m);
/// `iso`: f = 35948 * 2^(10/9) l^(8/9) delta^(10/9) in N and mm: two such contacts in series are c_L of ISO/TS 16281.
[[nodiscard]] PowerLaw iso_law(double length_m);
/// `houpert`: its printed approach, a power of the force at each raceway.
[[nodiscard]] PowerLaw houpert_law(const RollerContact& contact, Raceway raceway);

/// delta = scale f ln(limit/f), with limit/f = (length/b)^2; f = 0 for delta <= 0. `lundberg` and `tripp`.
/// Such a formula leaves out terms of the order (b/length)^2. It is used while b is below length/8: there these terms
/// are below 1/64 beside a logarithm of ln 64 = 4.2, and domain() ends at limit/64. Beyond, the law goes on along its
/// tangent. That serves Newton's iterates alone: a balance that needs it is refused (refusal). The formula itself falls
/// with the force where b nears the length.
class LogarithmicLaw {
 public:
  explicit LogarithmicLaw(const LogarithmicApproach& terms) : terms_(terms) {}

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const;
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;  ///< infinite at f = 0
  [[nodiscard]] double rise(double from_N, double by_N) const;
  [[nodiscard]] double begins_at() const { return 0; }
  [[nodiscard]] double heaviest_N() const { return terms_.limit_N / narrow; }

 private:
  [[nodiscard]] double logarithm(double force_N) const;
  [[nodiscard]] double rise_inside(double from_N, double by_N) const;  ///< both forces up to heaviest_N()
  static constexpr double narrow = 64;                                 ///< (length/b)^2 at the end of the domain
  LogarithmicApproach terms_;
};

/// `lundberg`: the log kernel between planes a length l apart, the same form at both raceways.
[[nodiscard]] LogarithmicLaw lundberg_law(const RollerContact& contact, Raceway raceway);
/// `tripp`: the bodies' own lengths, at the outer raceway the ring's thickness.
[[nodiscard]] LogarithmicLaw tripp_law(const RollerContact& contact, Raceway raceway);

/// What the straight line says below its range.
enum class Unloading {
  at_zero_force,  ///< f = max(0, K delta + dF)
  /// f = 0 below delta = 0. At delta = 0 the law jumps by dF: a contact there carries any part of dF, and the rollers
  /// on the jump share what the others leave of the load. No other reading of the cut line has a balance at every load.
  at_zero_approach,
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
  [[nodiscard]] double rise(double from_N, double by_N) const;
  /// Below this approach the force is zero.
  [[nodiscard]] double begins_at() const;
};

/// `ehd`: the solver's own relation, delta(f) = delta_dry(f; x_0) - F(f), F the offset film of a FilmCurve. A film
/// always pushes: the force is positive at every approach. Above the heaviest solved load the law goes on along its
/// tangent. That serves Newton's iterates alone: a force there is outside domain(), and the caller extends the curve.
/// The constructor throws std::domain_error where the approach would not increase with the force (a datum below half
/// the contact's half width).
class CurveLaw {
 public:
  CurveLaw(std::shared_ptr<const FilmCurve> curve, double datum_m);

  [[nodiscard]] double force(double approach_m) const;
  [[nodiscard]] double stiffness(double approach_m) const { return 1 / compliance(force(approach_m)); }
  [[nodiscard]] double approach(double force_N) const;
  [[nodiscard]] double compliance(double force_N) const;
  [[nodiscard]] double rise(double from_N, double by_N) const { return approach(from_N + by_N) - approach(from_N); }
  [[nodiscard]] double begins_at() const;  ///< -infinity
  [[nodiscard]] const FilmCurve& curve() const { return *curve_; }
  [[nodiscard]] double datum_m() const { return datum_m_; }

 private:
  std::shared_ptr<const FilmCurve> curve_;
  double datum_m_;
};

using ForceLaw = std::variant<PowerLaw, LogarithmicLaw, LinearLaw, CurveLaw>;

/// The laws at the two contacts of every roller.
struct LawPair {
  ForceLaw inner, outer;
};

/// Force [N] at an approach [m]; 0 where the contact is unloaded.
[[nodiscard]] double force(const ForceLaw& law, double approach_m);
/// df/d(delta) [N/m]; 0 where the contact is unloaded.
[[nodiscard]] double stiffness(const ForceLaw& law, double approach_m);
/// The approach [m] at a force > 0 [N]; at 0 that where contact begins (-infinity for `ehd`).
[[nodiscard]] double approach(const ForceLaw& law, double force_N);
/// d(delta)/df [m/N] at a force > 0.
[[nodiscard]] double compliance(const ForceLaw& law, double force_N);
/// approach(from + by) - approach(from) [m], from >= 0, by > 0. Computed without that difference, which loses digits
/// where by is far below from. For `ehd` it is the plain difference, from > 0.
[[nodiscard]] double rise(const ForceLaw& law, double from_N, double by_N);
/// The approach [m] below which the force is zero; -infinity for `ehd`.
[[nodiscard]] double begins_at(const ForceLaw& law);
/// The contact forces [N] for which the law is meant: the range of a fit, up to the heaviest solved load of a curve, up
/// to the end of a logarithm; absent where there is no limit.
[[nodiscard]] std::optional<std::pair<double, double>> domain(const ForceLaw& law);
/// Why a balance in which the law carries this force [N] is refused; absent where it is not.
[[nodiscard]] std::optional<std::string> refusal(const ForceLaw& law, double force_N);
/// True for a law whose force drops to 0 from a finite force.
[[nodiscard]] bool jumps(const ForceLaw& law);

}  // namespace ehd::bearing
