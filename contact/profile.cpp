// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "contact/legendre.hpp"

namespace ehd {

Profile::Profile(const Array& X, const Array& values, const std::vector<Eigen::Index>& elements) {
  const Eigen::Index nodes = X.size();
  if (nodes < 2 || values.size() != nodes)
    throw std::invalid_argument(fmt::format(
        "a profile has {} places and {} values; required are as many of each, at least 2", nodes, values.size()));
  if (!elements.empty() && (elements.size() < 2 || elements.front() != 0 || elements.back() != nodes - 1))
    throw std::invalid_argument("the elements of a profile do not reach from its first node to its last");
  begins_.push_back(0);
  if (elements.empty()) {
    ends_.assign(X.begin(), X.end());
    begins_.reserve(ends_.size());
    coefficients_.reserve(2 * ends_.size());
    for (Eigen::Index i = 0; i + 1 < nodes; ++i) {
      coefficients_.push_back((values[i] + values[i + 1]) / 2);
      coefficients_.push_back((values[i + 1] - values[i]) / 2);
      begins_.push_back(coefficients_.size());
    }
    return;
  }
  std::map<int, MatrixOf<double>> to_legendre;  // by degree: finding the nodes takes longer than using them
  ends_.push_back(X[0]);
  for (std::size_t k = 0; k + 1 < elements.size(); ++k) {
    const int degree = static_cast<int>(elements[k + 1] - elements[k]);
    auto at = to_legendre.find(degree);
    if (at == to_legendre.end())
      at = to_legendre.emplace(degree, lobatto_to_legendre(degree, lobatto_nodes<double>(degree))).first;
    const VectorOf<double> own = at->second * values.segment(elements[k], degree + 1).matrix();
    coefficients_.insert(coefficients_.end(), own.begin(), own.end());
    begins_.push_back(coefficients_.size());
    ends_.push_back(X[elements[k + 1]]);
    degree_ = std::max(degree_, degree);
  }
}

double Profile::value(std::size_t k, double x) const {
  const double left = ends_[k], right = ends_[k + 1];
  const double t = ((x - left) - (right - x)) / (right - left);
  const double* const coefficients = &coefficients_[begins_[k]];
  const std::size_t count = begins_[k + 1] - begins_[k];
  if (count == 2) return coefficients[0] + t * coefficients[1];  // a straight line: the sum below, bit for bit
  // Clenshaw's sum of a Legendre series.
  double next = 0, after = 0;
  for (std::size_t m = count; m-- > 0;) {
    const auto order = static_cast<double>(m);
    const double now = coefficients[m] + (2 * order + 1) / (order + 1) * t * next - (order + 1) / (order + 2) * after;
    after = next;
    next = now;
  }
  return next;
}

double relative_l2_error(const Profile& profile, const Profile& truth) {
  const double begin = std::max(profile.first(), truth.first()), end = std::min(profile.last(), truth.last());
  if (!(begin < end)) return std::numeric_limits<double>::quiet_NaN();
  // The square of a polynomial of degree p, by the Lobatto rule on p + 2 nodes: exact to degree 2 p + 1.
  const int rule = std::max(profile.degree(), truth.degree()) + 1;
  const VectorOf<double> nodes = lobatto_nodes<double>(rule), weights = lobatto_weights(rule, nodes);
  std::size_t a = 0, b = 0;
  double difference = 0, size = 0;
  for (double left = begin; left < end;) {
    while (profile.end(a + 1) <= left) ++a;
    while (truth.end(b + 1) <= left) ++b;
    const double right = std::min({profile.end(a + 1), truth.end(b + 1), end});
    const double half = (right - left) / 2, middle = left + half;
    for (int j = 0; j <= rule; ++j) {
      const double x = std::clamp(middle + half * nodes[j], left, right);
      const double exact = truth.value(b, x), off = profile.value(a, x) - exact;
      difference += half * weights[j] * off * off;
      size += half * weights[j] * exact * exact;
    }
    left = right;
  }
  return size > 0 ? std::sqrt(difference / size) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ehd
