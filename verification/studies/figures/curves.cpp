// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/figures/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contact/legendre.hpp"

namespace ehd::verification {

namespace {

std::vector<std::size_t> divided(const std::vector<double>& X, const std::vector<ThinnedCurve>& curves, double factor) {
  std::vector<std::size_t> kept{0, X.size() - 1};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, X.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double furthest = 1;
    std::size_t split = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double t = (X[i] - X[from]) / (X[to] - X[from]);
      for (const ThinnedCurve& curve : curves) {
        const double chord = curve.values[from] + t * (curve.values[to] - curve.values[from]);
        const double off = std::abs(curve.values[i] - chord) / (factor * curve.allowed[i]);
        if (off > furthest) furthest = off, split = i;
      }
    }
    if (split == from) continue;
    kept.push_back(split);
    open.emplace_back(from, split);
    open.emplace_back(split, to);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace

Thinning thin(const std::vector<double>& X, const std::vector<ThinnedCurve>& curves, std::size_t most) {
  if (X.size() < 2 || most < 2)
    throw std::invalid_argument(
        fmt::format("a curve of {} points thinned to {}; required are at least 2 of each", X.size(), most));
  for (const ThinnedCurve& curve : curves)
    if (curve.values.size() != X.size() || curve.allowed.size() != X.size())
      throw std::invalid_argument(
          fmt::format("a curve has {} values and {} bounds over {} abscissae; required are as many of each",
                      curve.values.size(), curve.allowed.size(), X.size()));
  Thinning thinning;
  constexpr double looser = 1.5;
  for (thinning.kept = divided(X, curves, 1); thinning.kept.size() > most;
       thinning.kept = divided(X, curves, thinning.factor))
    thinning.factor *= looser;
  return thinning;
}

double gap_behind_exit(const Profile& pressure, double X) {
  const double exit = pressure.last();
  const int rule = pressure.degree() + 8;  // the logarithm bends on the last pieces alone, where P is small
  static thread_local std::map<int, std::pair<VectorOf<double>, VectorOf<double>>> rules;
  auto found = rules.find(rule);
  if (found == rules.end()) {
    const VectorOf<double> nodes = lobatto_nodes<double>(rule);
    found = rules.emplace(rule, std::pair{nodes, lobatto_weights(rule, nodes)}).first;
  }
  const auto& [nodes, weights] = found->second;
  double integral = 0;
  for (std::size_t k = 0; k < pressure.pieces(); ++k) {
    const double half = (pressure.end(k + 1) - pressure.end(k)) / 2, middle = pressure.end(k) + half;
    for (Eigen::Index j = 0; j < nodes.size(); ++j) {
      const double t = middle + half * nodes[j];
      if (!(t < exit)) continue;  // P = 0
      integral += half * weights[j] * pressure.value(k, t) * std::log1p((X - exit) / (exit - t));
    }
  }
  return (X * X - exit * exit) / 2 - integral / std::numbers::pi;
}

}  // namespace ehd::verification
