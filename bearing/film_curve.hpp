// SPDX-License-Identifier: GPL-3.0-or-later
// The films of one raceway's contact as functions of the contact force: a monotone curve through solved contacts, down
// to vanishing load.
//
// The curve is kept in the OFFSET FILM
//   F = (b^2/R)(H_0 - H_0,dry) = delta_dry - delta,
// the distance by which the lubricant holds the bodies apart. F does not depend on the datum x_0, because a shift of
// x_0 changes delta and delta_dry alike. F is positive, and at both ends nearly a power of the load. So the curve
// interpolates ln F over ln f.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/continued_spline.hpp"
#include "bearing/geometry.hpp"
#include "bearing/monotone_spline.hpp"

namespace ehd::bearing {

/// What is known of a curve's errors. Film errors are |ln(curve/solved)|, the larger of offset film and minimum film.
/// Force errors are relative errors of the contact force at a given approach with datum x_0 = l. They follow from the
/// error of the offset film.
struct CurveErrors {
  /// Between the points: the larger of two numbers. One is the largest disagreement with an extra solve in a gap. The
  /// other: leave one point out, take the curve's error at that point, divide it by eight (build_curve.hpp).
  double interpolation = 0, interpolation_force = 0;
  /// Below the lightest point, at any load. A contact solved at half the lightest load and the exponent d ln F/d ln f
  /// at the joint bound the error there; this is twice that bound (CurvePoints::continuation). Where no lighter
  /// contact can be solved, the curve is made without its lightest octaves and judged at the lightest point.
  /// Infinite where too few points are left for that.
  double joint = 0, joint_force = 0;
  double solver_offset_film = 0;   ///< largest relative error of an offset film that the solver states
  double solver_minimum_film = 0;  ///< the same of a minimum film
  double rolling = 0;              ///< of a rolling force, relative: interpolation, the lightest loads, the solver
  std::vector<double> missed_N;    ///< contacts solved for this curve that missed their tolerance, increasing
  std::string lightest_because;    ///< why no lighter contact was solved
  /// A limit on iterations or time ended a contact, and the errors above are beyond what was asked for.
  bool cut_short = false;
};

/// The force errors of a curve hold at a given approach with the datum x_0 = l. With a datum of the order of the radii
/// they are larger, at most by this factor.
inline constexpr double force_error_by_datum = 2;

/// Offset film, minimum film and rolling force over the contact force, 0 < f <= heaviest; each a ContinuedSpline,
/// which goes over to Martin's numbers (martin.hpp) below the lightest solved contact.
class FilmCurve {
 public:
  /// Forces [N] increasing, at least three; offset films and minimum films [m], positive; rolling forces per length
  /// [N/m], positive, or none. Throws std::invalid_argument.
  FilmCurve(RacewayContact contact, std::vector<double> forces_N, const std::vector<double>& offset_films_m,
            const std::vector<double>& minimum_films_m, CurveErrors errors = {},
            const std::vector<double>& rolling_forces_N_per_m = {});

  /// Film [m] and its derivative to the force [m/N].
  [[nodiscard]] ValueAndSlope offset_film(double force_N) const;
  [[nodiscard]] ValueAndSlope minimum_film(double force_N) const;
  /// F_t = |Int h p' dx|/2 per length [N/m]; absent where a solved contact does not say it.
  [[nodiscard]] std::optional<double> rolling_force_N_per_m(double force_N) const;
  [[nodiscard]] const CurveErrors& errors() const { return errors_; }
  [[nodiscard]] const RacewayContact& contact() const { return contact_; }
  [[nodiscard]] const std::vector<double>& forces_N() const { return forces_N_; }
  [[nodiscard]] double lightest_N() const { return forces_N_.front(); }
  [[nodiscard]] double heaviest_N() const { return forces_N_.back(); }
  /// 4/(pi E' l) [m/N].
  [[nodiscard]] double compliance_scale() const;
  /// f d(delta)/df [m] with the datum x_0 = l. A relative error of the contact force is an error of the approach over
  /// this.
  [[nodiscard]] double rise_m(double force_N) const;
  /// The part of the film in that rise: an error of the film counts by it in the force.
  [[nodiscard]] double film_part(double force_N) const { return offset_film(force_N).value / rise_m(force_N); }
  /// Relative error of the contact force at a given approach with the datum x_0 = l: of the curve and of its solver.
  [[nodiscard]] double force_error(double force_N) const;
  /// Relative error of d(delta)/df with the datum x_0 = l. An interpolation error is zero at both ends of a gap. If it
  /// is a cubic, reaches e inside, and the gap is g in ln f, its slope is at most 6 sqrt(3) e/g, that of x(1-x)(1-2x).
  /// Below the lightest point the error falls with the force, like f^(3/2) to f^3.
  [[nodiscard]] double compliance_error(double force_N) const;

 private:
  RacewayContact contact_;
  std::vector<double> forces_N_;
  ContinuedSpline offset_, minimum_;
  std::optional<ContinuedSpline> rolling_;
  CurveErrors errors_;
};

}  // namespace ehd::bearing
