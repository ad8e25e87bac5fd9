// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the film curve of one raceway: decides which contacts are solved, and measures the curve's errors.
#pragma once

#include <compare>
#include <variant>
#include <vector>

#include "bearing/film_curve.hpp"
#include "bearing/solved_contacts.hpp"

namespace ehd::bearing {

/// How far a curve is refined.
struct CurveRequest {
  double heaviest_N = 0;  ///< the curve reaches at least this force
  /// Contact forces [N], increasing, that a fit solves in any case. The first and the last become points, the others
  /// extra solves of their gaps.
  std::vector<double> given_N = {};
  /// Allowed relative errors, at an extra solve in each gap and below the lightest point. force_bound: of the contact
  /// force at a given approach with datum x_0 = l; with a datum of the order of the radii the error may be twice that.
  /// film_bound: of the minimum film.
  double force_bound = 1e-3, film_bound = 2e-3;
  double smallest_gap = 1.05;  ///< a gap is not split into neighbours whose forces have a ratio below this
  double widest_gap = 3;       ///< a gap is always split where the ratio of its forces is above this
  int most_points = 120;

  friend auto operator<=>(const CurveRequest&, const CurveRequest&) = default;
};

/// The request as build_curve carries it out. It is rounded, so that bearings with equal raceway contacts share solves:
/// the heaviest force becomes the heaviest given one where that is enough, else the next power of two [N]. Given forces
/// above four times the heaviest are dropped.
[[nodiscard]] CurveRequest as_met(CurveRequest request);

/// 1. Points go down from the heaviest force by factors of four. They end where the continuation to Martin's films is
///    within the bounds, judged by a contact of half the lightest force, or where no lighter contact can be solved.
/// 2. The gap whose extra solve disagrees most is split there, until all agree.
/// 3. Each point is predicted by the others, over twice the gap. Where an eighth of the disagreement is beyond the
///    bounds, the gaps on both sides of the point are split.
/// Extra solves become points of the curve. A failure at the heaviest force, or fewer than three points, is a
/// SolveFailure.
[[nodiscard]] std::variant<FilmCurve, SolveFailure> build_curve(const SolvableContact& contacts,
                                                                const CurveRequest& request);

}  // namespace ehd::bearing
