// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/grid_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ehd::verification {

namespace {

constexpr double smallest_order = 1e-2, largest_order = 20;
/// An order is sought to this part of itself: grids know a few digits of it. Some 50 halvings do.
constexpr double order_precision = 1e-12;
constexpr int most_order_halvings = 200;

/// The order at which (f2 - f1)/(f3 - f2) = `ratio`, 0 < ratio < 1, n1 > n2 > n3: with f = f0 + c n^-p that quotient is
/// (n2^-p - n1^-p)/(n3^-p - n2^-p), which falls with p.
std::optional<double> order_of(double n1, double n2, double n3, double ratio) {
  const double fine = std::log(n2 / n1), coarse = std::log(n3 / n2);  // negative
  const auto excess = [&](double p) { return -std::expm1(p * fine) / std::expm1(-p * coarse) - ratio; };
  double low = smallest_order, high = largest_order;
  if (!(excess(low) > 0)) return std::nullopt;  // slower than any power worth the name
  if (excess(high) > 0) return high;
  for (int k = 0; k < most_order_halvings && high - low > order_precision * high; ++k) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::string_view to_string(Trend trend) {
  switch (trend) {
    case Trend::asymptotic: return "asymptotic";
    case Trend::monotone: return "monotone";
    case Trend::oscillatory: return "oscillatory";
    case Trend::stalled: return "stalled";
    case Trend::divergent: return "divergent";
  }
  return "";
}

GridStudy study_grids(const std::vector<GridValue>& values, double formal_order, double noise) {
  const std::size_t m = values.size();
  if (m < 3) throw std::invalid_argument("a grid study needs three grids or more");
  for (std::size_t i = 0; i < m; ++i) {
    if (!std::isfinite(values[i].value)) throw std::invalid_argument("a grid's value is not finite");
    if (!(values[i].cells > (i == 0 ? 0 : values[i - 1].cells)))
      throw std::invalid_argument("grids must go from coarse to fine");
  }
  const auto [n1, f1] = values[m - 1];
  const auto [n2, f2] = values[m - 2];
  const auto [n3, f3] = values[m - 3];
  const double size = std::max(std::abs(f1), std::numeric_limits<double>::min());
  const double last = f2 - f1, before = f3 - f2;
  const double half_range = (std::max({f1, f2, f3}) - std::min({f1, f2, f3})) / 2;

  GridStudy study;
  const double of_two = 2 * noise * size;  // noise of a difference of two values
  if (std::abs(last) <= of_two && std::abs(before) <= of_two) {
    study.trend = Trend::stalled;
    study.uncertainty = std::max(half_range / size, noise);
    return study;
  }
  study.uncertainty = std::numeric_limits<double>::infinity();
  if (last * before <= 0) {
    // Differences fall if the last is smaller; each is compared per logarithm of its factor of refinement.
    if (!(std::abs(last) * std::log(n2 / n3) < std::abs(before) * std::log(n1 / n2))) return study;
    study.trend = Trend::oscillatory;
    study.uncertainty = half_range / size;  // above the noise, because the difference before is
    return study;
  }
  study.observed_order = order_of(n1, n2, n3, last / before);
  if (!study.observed_order) return study;

  const auto near_formal = [&](std::optional<double> order) {
    constexpr double near = 0.1;
    return order && std::abs(*order - formal_order) <= near * formal_order;
  };
  bool shown_twice = false;
  if (m >= 4) {
    const auto [n4, f4] = values[m - 4];
    const double ratio = before / (f4 - f3);
    shown_twice = ratio > 0 && near_formal(order_of(n2, n3, n4, ratio));
  }
  double q = std::min(std::max(0.5, *study.observed_order), formal_order);
  study.trend = Trend::monotone;
  study.safety = 3;
  if (shown_twice && near_formal(study.observed_order)) {
    study.trend = Trend::asymptotic;
    study.safety = 1.25;
    q = formal_order;
  }
  const double correction = last / std::expm1(q * std::log(n1 / n2));
  if (study.trend == Trend::asymptotic) study.extrapolated = f1 - correction;
  study.uncertainty = std::max(study.safety * std::abs(correction) / size, noise);
  return study;
}

}  // namespace ehd::verification
