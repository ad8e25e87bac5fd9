// SPDX-License-Identifier: GPL-3.0-or-later
// What an EHD solver says about one raceway's contact, as functions of the contact force: solved points, and the
// monotone curve through them down to vanishing load.
//
// The curve is kept in the OFFSET FILM
//   F = (b^2/R)(H_0 - H_0,dry) = delta_dry - delta,
// the distance by which the lubricant holds the bodies apart. It does not depend on the datum x_0 (a shift of x_0
// changes delta and delta_dry alike), is positive, and is nearly a power of the load at both ends, so ln F over ln f is
// what is interpolated.
#pragma once

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// One solved contact.
struct SolvedContact {
  double offset = 0;        ///< H_0, Hertz units, x_0 = b
  double offset_error = 0;  ///< absolute
  double film_minimum_m = 0;
  double film_error = 0;  ///< relative
  bool converged = true;  ///< false: a best solution that missed its tolerance, with an honest error
};
struct SolveFailure {
  std::string why;
  bool limit = false;  ///< iterations or time ended, rather than the mathematics
};
using ContactResult = std::variant<SolvedContact, SolveFailure>;

/// load [N/m] -> the solved contact. What an EHD law is built from; bearing/ knows no solver.
using ContactPoint = std::function<ContactResult(double load_N_per_m)>;

/// The solved contacts of one raceway: equal loads are solved once, however many laws and bearings ask.
class SolvedContacts {
 public:
  SolvedContacts(RacewayContact contact, ContactPoint solve) : contact_(contact), solve_(std::move(solve)) {}

  /// Solves, or remembers.
  [[nodiscard]] const ContactResult& at(double force_N);
  [[nodiscard]] const RacewayContact& contact() const { return contact_; }
  [[nodiscard]] long solves() const { return solves_; }    ///< calls of the callable
  [[nodiscard]] long recalls() const { return recalls_; }  ///< requests answered from memory

 private:
  RacewayContact contact_;
  ContactPoint solve_;
  std::map<double, ContactResult> results_;
  long solves_ = 0, recalls_ = 0;
};

/// A value and its derivative to the contact force.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// F of a solved contact [m].
[[nodiscard]] double offset_film_m(const RacewayContact& contact, double force_N, const SolvedContact& solved);

/// Rigid isoviscous cylinder (Martin 1916): h_min = 2.447484 eta_0 u_s R l/f [m].
[[nodiscard]] double martin_film_m(const RacewayContact& contact, double force_N);
/// Offset film of that contact with the deformation by Martin's pressure to first order,
///   F = h_min + (4w/(pi E')) [ ln(sqrt(2 R h_min)/b) + m - 2 H_0,dry ],
/// m = -0.3284613 the pressure's mean of ln|tan g|, x = sqrt(2 R h_min) tan g. Beyond its range (deformation not small)
/// it stays positive, and means nothing.
[[nodiscard]] double martin_offset_film_m(const RacewayContact& contact, double force_N);

/// Offset film and minimum film over the contact force, 0 < f <= heaviest.
/// - Between solved points: the cubic spline of the logarithms over ln f with not-a-knot ends (fourth order), its
/// slopes
///   limited where the points are monotone (Hyman 1983, SIAM J. Sci. Stat. Comput. 4, 645-654), so that nothing
///   overshoots.
/// - Below the lightest: Martin's films times exp(a t^(3/2) + c t^3), t = f/f_lightest, joined with value and slope;
/// the
///   powers are those in which the first piezoviscous corrections grow (alpha p_max ~ f^(3/2)).
/// - Above the heaviest, where Newton iterates may stray: the end's power law, NOT vouched for.
class FilmCurve {
 public:
  /// Forces [N] increasing, at least three; offset films and minimum films [m], positive. Throws std::invalid_argument.
  FilmCurve(RacewayContact contact, std::vector<double> forces_N, std::vector<double> offset_films_m,
            std::vector<double> minimum_films_m);

  [[nodiscard]] ValueAndSlope offset_film(double force_N) const;
  [[nodiscard]] ValueAndSlope minimum_film(double force_N) const;
  [[nodiscard]] const RacewayContact& contact() const { return contact_; }
  [[nodiscard]] const std::vector<double>& forces_N() const { return forces_N_; }
  [[nodiscard]] double lightest_N() const { return forces_N_.front(); }
  [[nodiscard]] double heaviest_N() const { return forces_N_.back(); }
  /// 4/(pi E' l) [m/N].
  [[nodiscard]] double compliance_scale() const;

  /// Twice |ln(curve/solved)| at a contact half as heavy as the lightest point, which the curve does not contain: what
  /// the rigid continuation can be trusted to at any lighter load. The larger of the two films'. Where no lighter
  /// contact can be solved: of the curve without its lightest octaves, at its lightest point.
  double joint_error = 0;
  /// The same at the extra solves that the gaps between points were judged by, and an eighth of what the curve without
  /// a point is off by there: whichever is largest.
  double interpolation_error = 0;
  /// Relative error of the contact force at a given approach by the offset film's errors above, datum x_0 = l.
  double joint_force_error = 0, interpolation_force_error = 0;
  double solver_error = 0;       ///< largest relative error of an offset film that the solver itself reports
  double film_error = 0;         ///< and of a minimum film
  std::vector<double> missed_N;  ///< contacts solved for this curve that missed their tolerance, increasing
  std::string lightest_because;  ///< why no lighter contact was solved

  /// f d(delta)/df [m] with the datum x_0 = l: what the relative errors of a contact force are relative to.
  [[nodiscard]] double rise_m(double force_N) const;

 private:
  struct Spline;
  RacewayContact contact_;
  std::vector<double> forces_N_;
  std::shared_ptr<const Spline> offset_, minimum_;  // immutable, so copies may share them
};

/// How far a curve is refined.
struct CurveRequest {
  double heaviest_N = 0;  ///< the curve reaches at least this force
  /// Contact forces [N], increasing, that a fit solves in any case: points and checks of the curve where they serve.
  std::vector<double> given_N = {};
  /// Allowed relative error of the contact force at a given approach (datum x_0 = l; up to twice that with one of the
  /// order of the radii), and of the minimum film, at an extra solve in each gap and at the joint.
  double force_bound = 1e-3, film_bound = 2e-3;
  double smallest_gap = 1.05;  ///< ratio of neighbouring forces below which no gap is split
  double widest_gap = 3;       ///< and above which one always is
  int most_points = 120;

  friend auto operator<=>(const CurveRequest&, const CurveRequest&) = default;
};

/// The same request as it is met: the heaviest force is the heaviest given one where that reaches it, else the next
/// power of two [N], so that bearings that share a raceway contact share solves; of the given forces, those within
/// reach.
[[nodiscard]] CurveRequest as_met(CurveRequest request);

/// From the heaviest force down by factors of four until the rigid continuation foretells a contact half as heavy
/// within the bounds, or no lighter one can be solved; then the gap whose extra solve disagrees most is split there,
/// until all agree; and both gaps beside a point that the others do not foretell (an eighth of the disagreement, over
/// twice the gap). Extra solves become points of the curve. A failure at the heavy end, or fewer than three points, is
/// a SolveFailure.
[[nodiscard]] std::variant<FilmCurve, SolveFailure> build_curve(SolvedContacts& contacts, const CurveRequest& request);

}  // namespace ehd::bearing
