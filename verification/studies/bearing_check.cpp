// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/bearing_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "verification/claim.hpp"
#include "verification/quad.hpp"

namespace ehd::verification {

using bearing::RollerState;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Forces [N] between which a root is sought, nearly all that a double holds, and the factor of one step outwards.
constexpr double smallest_tried_N = 1e-300, largest_tried_N = 1e300, search_factor = 16;
/// From 1 to 1e300 some 1,050 halvings end at the last bit.
constexpr int most_force_halvings = 2000;

struct QuadVector {
  Quad x, y;
};
Quad dot(const QuadVector& a, const QuadVector& b) { return a.x * b.x + a.y * b.y; }

QuadVector direction(double degrees) {
  const Quad angle = Quad(degrees) * acos(Quad(-1)) / 180;
  return {cos(angle), sin(angle)};
}

/// A line that lets go at zero approach is cut there: the length [m] of the part below. Other laws have none.
struct CutOff {
  double operator()(const bearing::PowerLaw&) const { return 0; }
  double operator()(const bearing::LogarithmicLaw&) const { return 0; }
  double operator()(const bearing::CurveLaw&) const { return 0; }
  double operator()(const bearing::LinearLaw& line) const {
    return bearing::jumps(line) ? std::max(0.0, line.dF_N / line.K_N_per_m) : 0;
  }
};

/// One roller: the approach of both its contacts as a function of its inner force.
struct Roller {
  const bearing::LawPair& laws;
  double centrifugal_N, origin_m;  ///< origin: the total approach at which it begins to carry
  bool begins;                     ///< false: it carries at every approach, and origin_m is 0

  Roller(const bearing::LawPair& both, double thrown_N)
      : laws(both),
        centrifugal_N(thrown_N),
        origin_m(bearing::begins_at(both.inner) + bearing::approach(both.outer, thrown_N)),
        begins(std::isfinite(origin_m)) {
    if (!begins) origin_m = 0;
  }
  [[nodiscard]] double needs_m(double f) const {
    return begins ? bearing::rise(laws.inner, 0, f) + bearing::rise(laws.outer, centrifugal_N, f)
                  : bearing::approach(laws.inner, f) + bearing::approach(laws.outer, f + centrifugal_N);
  }
  /// The force f with needs_m(f) = s, to the last bit.
  [[nodiscard]] double force_N(double s) const {
    if (begins && !(s > 0)) return 0;
    double low = 1, high = 1;
    while (needs_m(low) > s && low > smallest_tried_N) low /= search_factor;
    while (needs_m(high) < s && high < largest_tried_N) high *= search_factor;
    for (int k = 0; k < most_force_halvings; ++k) {
      const double middle = low + (high - low) / 2;
      if (!(middle > low && middle < high)) break;
      (needs_m(middle) < s ? low : high) = middle;
    }
    return high;
  }
};

}  // namespace

double worst_bisection_error(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                             const bearing::Loading& loading, bearing::Form form,
                             const bearing::Equilibrium& equilibrium) {
  const auto count = static_cast<std::size_t>(geometry.rollers);
  if (equilibrium.rollers.size() != count || equilibrium.azimuths_deg.size() != count) return nothing;
  constexpr double rounding_deg = 1e-11;  // a hundred times the rounding of an azimuth
  for (std::size_t j = 0; j < count; ++j) {
    const double psi = geometry.first_azimuth_deg + 360.0 * static_cast<double>(j) / geometry.rollers;
    if (!(std::abs(std::remainder(psi - equilibrium.azimuths_deg[j], 360.0)) <= rounding_deg)) return nothing;
  }

  // The ring: rollers in two directions touch there, which gives two linear equations; then the returned step beyond.
  const Roller roller(laws, loading.centrifugal_N);
  const Quad gap = Quad(geometry.clearance_m) / 2 + roller.origin_m;
  QuadVector ring{0, 0};
  if (const auto& touching = equilibrium.position.touching_deg) {
    const QuadVector a = direction(touching->first), b = direction(touching->second);
    if (touching->first == touching->second) {
      ring = {gap * a.x, gap * a.y};
    } else {
      const Quad determinant = a.x * b.y - a.y * b.x;
      ring = {gap * (b.y - a.y) / determinant, gap * (a.x - b.x) / determinant};
    }
  }
  const Quad reference = sqrt(dot(ring, ring));
  ring.x += equilibrium.position.beyond_x_m;
  ring.y += equilibrium.position.beyond_y_m;
  const Quad size = reference + std::abs(equilibrium.position.beyond_x_m) + std::abs(equilibrium.position.beyond_y_m);
  double worst = 0;
  if (size > 0) {
    worst = worse(worst, static_cast<double>(abs(ring.x - equilibrium.displacement_m) / size),
                  static_cast<double>(abs(ring.y - equilibrium.lateral_displacement_m) / size));
  }

  const double cut_m = std::visit(CutOff{}, laws.inner) + std::visit(CutOff{}, laws.outer);
  Quad along = 0, across = 0, outer = 0;
  std::vector<double> apart_N;
  for (std::size_t j = 0; j < count; ++j) {
    const RollerState& returned = equilibrium.rollers[j];
    const QuadVector n = direction(equilibrium.azimuths_deg[j]);
    const auto s = static_cast<double>(dot(ring, n) - gap);
    double f = roller.force_N(s);
    if (cut_m > 0) {
      // On the jump of its law a roller carries any force between those on either side.
      const double slack = 4 * std::numeric_limits<double>::epsilon() * (static_cast<double>(size) + cut_m);
      const double least = roller.force_N(s - slack), most = roller.force_N(s + slack);
      f = returned.inner.force_N < least ? least : returned.inner.force_N > most ? most : returned.inner.force_N;
    }
    apart_N.push_back(std::abs(f - returned.inner.force_N));
    apart_N.push_back(std::abs(f + loading.centrifugal_N - returned.outer.force_N));
    along += f * n.x;
    across += f * n.y;
    outer += f + loading.centrifugal_N;
  }
  apart_N.push_back(static_cast<double>(abs(along - loading.radial_N)));
  if (form == bearing::Form::plane) apart_N.push_back(static_cast<double>(abs(across)));
  const double scale = std::max(loading.radial_N, static_cast<double>(outer));
  for (const double one_N : apart_N) worst = worse(worst, scale > 0 ? one_N / scale : one_N);
  return worst;
}

}  // namespace ehd::verification
