// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/steep_layer.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <utility>

namespace ehd::reference::hp {

namespace {

constexpr double least_power = 0.3, largest_power = 2;
/// The power of Barus oil, where only two places are known.
constexpr double expected_power = 0.5;
/// Binary digits to which a power is fitted.
constexpr int power_digits = 20;
/// Breakpoints further from the end of the path than this, in reaches, hardly move. 5 and 30 do as well.
constexpr double moved_part = 10;
/// Nearer to the end of the path than this, in reaches, the film is not linear in the floor. At M = 1.7515, L = 18,
/// Barus, flooded, the layer ends at X = 1.2e-4. At 3, 10, 18 and 70 reaches from there the central film was off by
/// 5e-4, 6e-5, 9e-6 and 7e-7, relative: linear in the floor from the third on.
constexpr double nearest_linear = 30;
/// Within so many reaches of X = 0 the film then changes by more than the central film errs: there by 2.5e-3 and 1.8e-4
/// at the first two.
constexpr double unsettled_reaches = 5;

/// The power at which three places lie on one path: (X_b - X_c)/(X_a - X_b) = (b^q - c^q)/(a^q - b^q) for the floors
/// a > b > c. The right side falls with q.
std::optional<double> power_through(const SteepPlace& a, const SteepPlace& b, const SteepPlace& c) {
  const double ratio = (b.X - c.X) / (a.X - b.X);
  const auto excess = [&](double q) {
    const double to_b = std::pow(b.floor / a.floor, q), to_c = std::pow(c.floor / a.floor, q);
    return (to_b - to_c) / (1 - to_b) - ratio;
  };
  if (!(excess(least_power) > 0 && excess(largest_power) < 0)) return std::nullopt;
  const auto [below, above] = boost::math::tools::bisect(excess, least_power, largest_power,
                                                         boost::math::tools::eps_tolerance<double>(power_digits));
  return (below + above) / 2;
}

}  // namespace

SteepPlace steep_place(const Resolved& solved) {
  const auto& at = solved.run.at;
  const int points = solved.equations->intervals();
  const Array fall = (-at.slope.head(points)).max(0.0);
  const Array weight = (fall / fall.maxCoeff()).square().square();
  const double exit = solved.run.state.exit;  // a distance from it keeps its digits
  double sum = 0, moment = 0;
  for (int i = 1; i + 1 < points; ++i) {
    const double part = weight[i] * (at.X[i + 1] - at.X[i - 1]);
    sum += part;
    moment += part * (at.X[i] - exit);
  }
  return {.floor = solved.floor, .X = exit + moment / sum};
}

std::vector<SteepPlace> places_apart(const std::vector<Resolved>& floors) {
  std::vector<SteepPlace> places;
  const auto apart = floors_apart(floors);
  for (std::size_t k = std::min<std::size_t>(apart.size(), 3); k-- > 0;)
    places.push_back(steep_place(floors[apart[k]]));
  return places;
}

std::optional<LayerPath> path_of(const std::vector<SteepPlace>& places) {
  const std::size_t n = places.size();
  if (n < 2 || places[n - 1].X == places[n - 2].X) return std::nullopt;
  const SteepPlace &before = places[n - 2], &last = places[n - 1];
  const std::optional<double> power = n > 2 ? power_through(places[n - 3], before, last) : expected_power;
  if (!power) return std::nullopt;
  const double part = std::pow(last.floor / before.floor, *power);
  const double reach = (before.X - last.X) * part / (1 - part);
  return LayerPath{.end = last.X - reach, .reach = reach, .power = *power};
}

std::optional<LayerPath> expected_path(const std::vector<SteepPlace>& places) {
  const std::size_t n = places.size();
  if (n < 2) return std::nullopt;
  if (const auto path = path_of(places)) return path;
  double step = places[n - 2].X - places[n - 1].X;
  if (const double before = n > 2 ? places[n - 3].X - places[n - 2].X : 0; std::abs(before) > std::abs(step))
    step = before;
  return LayerPath{.end = places[n - 1].X - step, .reach = step, .power = expected_power};
}

bool is_at_centre(const LayerPath& path, const SteepPlace& place) {
  return std::abs(path.end) < nearest_linear * std::abs(place.X - path.end);
}

bool is_at_centre(const std::vector<SteepPlace>& places) {
  const auto path = expected_path(places);
  return path && is_at_centre(*path, places.back());
}

double unsettled_distance(const LayerPath& path) { return unsettled_reaches * std::abs(path.reach); }

std::optional<Resolved> followed(const Problem& problem, const Resolved& last, const LayerPath& path, double floor,
                                 double shortest) {
  const auto& equations = *last.equations;
  const double exit = last.run.state.exit, stretching = equations.stretching(exit);
  const double nearer = std::pow(floor / last.floor, path.power), width = moved_part * std::abs(path.reach);
  Mesh mesh = equations.mesh();
  for (std::size_t i = 1; i + 1 < mesh.breakpoints.size(); ++i) {
    const double from_end = exit - path.end + stretching * mesh.breakpoints[i], u = from_end / width;
    mesh.breakpoints[i] -= (1 - nearer) * from_end / (1 + u * u * u * u) / stretching;
  }
  const auto too_short = [&](double left, double right) { return !(right - left >= shortest); };
  if (std::ranges::adjacent_find(mesh.breakpoints, too_short) != mesh.breakpoints.end()) return std::nullopt;
  Resolved next{.equations = std::make_shared<const Collocation<double>>(problem, std::move(mesh), equations.points()),
                .run = {},
                .floor = floor};
  next.run.state = last.run.state;
  return next;
}

}  // namespace ehd::reference::hp
