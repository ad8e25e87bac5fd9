// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/tabulated_law.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::bearing {

namespace {

/// The damping has no slope of its own: a central difference over this part of the force. What it neglects is 1e-8 of
/// the slope's own change.
constexpr double force_step = 1e-4;
/// Number of places in each gap where the table is compared with the law.
constexpr int looks_in_a_gap = 9;

/// One gap between two knots.
struct Gap {
  std::size_t k = 0;
  double width = 0, t = 0;  ///< place in the gap, 0 to 1

  /// The cubic with these values and slopes at both ends, and its derivative.
  [[nodiscard]] ValueAndSlope cubic(ValueAndSlope left, ValueAndSlope right) const {
    const double secant = (right.value - left.value) / width;
    const double c2 = 3 * secant - 2 * left.slope - right.slope, c3 = left.slope + right.slope - 2 * secant;
    return {left.value + width * t * (left.slope + t * (c2 + t * c3)), left.slope + t * (2 * c2 + t * 3 * c3)};
  }
  [[nodiscard]] ValueAndSlope of(const KnotColumn& column) const {
    return cubic({column.values[k], column.slopes[k]}, {column.values[k + 1], column.slopes[k + 1]});
  }
  [[nodiscard]] ValueAndSlope of_logarithm(const KnotColumn& column) const {
    const auto knot = [&](std::size_t i) {
      return ValueAndSlope{std::log(column.values[i]), column.slopes[i] / column.values[i]};
    };
    const ValueAndSlope logarithm = cubic(knot(k), knot(k + 1));
    const double value = std::exp(logarithm.value);
    return {value, value * logarithm.slope};
  }
};

double damping_slope(const DampingOverForce& damping, double force_N) {
  return (damping(force_N * (1 + force_step)) - damping(force_N * (1 - force_step))) / (2 * force_step * force_N);
}

void put(KnotColumn& column, double value, double slope) {
  column.values.push_back(value);
  column.slopes.push_back(slope);
}

TableErrors errors_of(const TabulatedLaw& table, const CurveLaw& law, const DampingOverForce& damping) {
  TableErrors worst;
  if (damping) worst.damping = 0;
  const auto meet = [](double& largest, double value, double truth) {
    largest = std::max(largest, std::abs(value / truth - 1));
  };
  for (std::size_t k = 0; k + 1 < table.approach_m.size(); ++k)
    for (int look = 1; look <= looks_in_a_gap; ++look) {
      const double share = static_cast<double>(look) / (looks_in_a_gap + 1);
      const double approach = (1 - share) * table.approach_m[k] + share * table.approach_m[k + 1];
      const TabulatedValues found = *table.at(approach);
      const double force_N = law.force(approach);
      meet(worst.force, found.force_N, force_N);
      meet(worst.stiffness, found.stiffness_N_per_m, 1 / law.compliance(force_N));
      meet(worst.film, found.film_minimum_m, law.curve().minimum_film(force_N).value);
      if (damping) meet(*worst.damping, *found.damping_N_s_per_m, damping(force_N));
    }
  return worst;
}

}  // namespace

std::optional<TabulatedValues> TabulatedLaw::at(double approach) const {
  if (!(approach >= approach_m.front() && approach <= approach_m.back())) return std::nullopt;
  const auto above = std::upper_bound(approach_m.begin() + 1, approach_m.end() - 1, approach);
  const auto k = static_cast<std::size_t>(above - approach_m.begin()) - 1;
  const double width = approach_m[k + 1] - approach_m[k];
  const Gap gap{.k = k, .width = width, .t = (approach - approach_m[k]) / width};
  const ValueAndSlope force = gap.of_logarithm(force_N);
  TabulatedValues values{.force_N = force.value,
                         .stiffness_N_per_m = force.slope,
                         .film_minimum_m = gap.of_logarithm(film_minimum_m).value};
  if (damping_N_s_per_m) values.damping_N_s_per_m = gap.of(*damping_N_s_per_m).value;
  return values;
}

TabulatedLaw tabulate(const CurveLaw& law, double lightest_N, double heaviest_N, int knots,
                      const DampingOverForce& damping) {
  TabulatedLaw table;
  if (damping) table.damping_N_s_per_m.emplace();
  for (int k = 0; k < knots; ++k) {
    const double force_N = k + 1 == knots
                               ? heaviest_N
                               : lightest_N * std::pow(heaviest_N / lightest_N, static_cast<double>(k) / (knots - 1));
    const double stiffness = 1 / law.compliance(force_N);
    const ValueAndSlope film = law.curve().minimum_film(force_N);
    table.approach_m.push_back(law.approach(force_N));
    put(table.force_N, force_N, stiffness);
    put(table.film_minimum_m, film.value, film.slope * stiffness);
    if (damping) put(*table.damping_N_s_per_m, damping(force_N), damping_slope(damping, force_N) * stiffness);
  }
  table.errors = errors_of(table, law, damping);
  return table;
}

}  // namespace ehd::bearing
