// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ehd::reference::hp {

namespace {

/// Seeded elements: the finest over the inlet zone, the widest over their distance to the contact's centre.
constexpr double finest_per_inlet_zone = 0.5, widest_per_distance = 0.5;
/// An element is at most this much wider than wanted at its middle.
constexpr double largest_overshoot = 1.5;
/// An element that would fill this part of the remaining length up to the inlet fills all of it.
constexpr double last_part = 0.75;
/// Where a new inlet cuts an element and would leave less than this part of it, the neighbour takes this part over.
constexpr double least_part_kept = 0.1;

}  // namespace

int Mesh::intervals() const { return std::accumulate(degrees.begin(), degrees.end(), 0); }

Mesh seeded_mesh(const Seed& seed) {
  // Sizes wanted at X: geometric about -l and about l, where the exit is near; never above half a length in the
  // contact.
  const auto wanted = [&](double X) {
    const double finest = seed.inlet_zone * finest_per_inlet_zone;
    const double grade = (seed.growth - 1) / seed.growth;
    const double about_inlet = finest + grade * std::abs(X + seed.length);
    const double about_exit = finest + grade * std::abs(X - seed.length);
    const double widest = widest_per_distance * std::max(seed.length, std::abs(X));
    return std::min({about_inlet, about_exit, std::max(widest, finest)});
  };
  Mesh mesh;
  mesh.inlet = seed.inlet;
  std::vector<double>& b = mesh.breakpoints;
  // From the exit to the inlet; each element as wide as wanted at its far end or so.
  double X = seed.exit;
  b.push_back(0);
  double width = wanted(X);
  for (;;) {
    width = std::min(width, largest_overshoot * wanted(X - width / 2));
    const double left = X - seed.inlet;
    if (width >= last_part * left) break;
    X -= width;
    b.push_back(X - seed.exit);
    width = wanted(X);
  }
  b.push_back(seed.inlet - seed.exit);
  std::reverse(b.begin(), b.end());
  mesh.degrees.assign(b.size() - 1, seed.degree);
  return mesh;
}

Mesh adapted(const Mesh& mesh, const std::vector<double>& excess, const std::function<bool(int)>& mergeable,
             double shortest, double cut) {
  Mesh out;
  out.inlet = mesh.inlet;
  out.breakpoints.push_back(mesh.breakpoints.front());
  const int elements = mesh.elements();
  for (int e = 0; e < elements; ++e) {
    const auto at = static_cast<std::size_t>(e);
    const double left = mesh.breakpoints[at], right = mesh.breakpoints[at + 1];
    const int degree = mesh.degrees[at];
    if (excess[at] > 1 && right - left > 2 * shortest) {
      out.breakpoints.push_back(left + cut * (right - left));
      out.degrees.push_back(degree);
    } else if (e + 1 < elements && excess[at] <= 1 && excess[at + 1] <= 1 && mergeable(e)) {
      out.breakpoints.push_back(mesh.breakpoints[at + 2]);
      out.degrees.push_back(degree);
      ++e;
      continue;
    }
    out.breakpoints.push_back(right);
    out.degrees.push_back(degree);
  }
  return out;
}

Mesh with_elements(const Mesh& mesh, std::vector<double> excess, int elements, double shortest) {
  Mesh out = mesh;
  auto& b = out.breakpoints;
  auto& degrees = out.degrees;
  while (out.elements() > std::max(elements, 1)) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e + 1 < degrees.size(); ++e) {
      // Merging raises the excess above both values, and more so for unequal lengths.
      const double joined = std::max(excess[e] * std::pow((b[e + 2] - b[e]) / (b[e + 1] - b[e]), degrees[e]),
                                     excess[e + 1] * std::pow((b[e + 2] - b[e]) / (b[e + 2] - b[e + 1]), degrees[e]));
      if (joined < least) least = joined, best = e;
    }
    const auto at = static_cast<std::ptrdiff_t>(best);
    excess[best] = least;
    b.erase(b.begin() + at + 1);
    degrees.erase(degrees.begin() + at + 1);
    excess.erase(excess.begin() + at + 1);
  }
  while (out.elements() < elements) {
    std::size_t worst = degrees.size();
    for (std::size_t e = 0; e < degrees.size(); ++e)
      if (b[e + 1] - b[e] > 2 * shortest && (worst == degrees.size() || excess[e] > excess[worst])) worst = e;
    if (worst == degrees.size()) break;
    const auto at = static_cast<std::ptrdiff_t>(worst);
    excess[worst] = std::ldexp(excess[worst], -degrees[worst]);
    excess.insert(excess.begin() + at, double(excess[worst]));
    b.insert(b.begin() + at + 1, (b[worst] + b[worst + 1]) / 2);
    degrees.insert(degrees.begin() + at, int(degrees[worst]));
  }
  return out;
}

Mesh with_intervals(Mesh mesh, int intervals) {
  const int elements = mesh.elements();
  for (int e = 0; e < elements; ++e)
    mesh.degrees[static_cast<std::size_t>(e)] = intervals / elements + (e < intervals % elements ? 1 : 0);
  return mesh;
}

Mesh with_degree(Mesh mesh, int degree) {
  std::fill(mesh.degrees.begin(), mesh.degrees.end(), degree);
  return mesh;
}

Mesh shifted(Mesh mesh, double part) {
  auto& b = mesh.breakpoints;
  for (std::size_t e = 1; e + 1 < b.size(); ++e) b[e] += part * (b[e + 1] - b[e]);
  return mesh;
}

Mesh cut_at(Mesh mesh, double inlet, double exit) {
  const double stretching = (exit - mesh.inlet) / mesh.extent();
  const double first = (inlet - exit) / stretching;
  auto& b = mesh.breakpoints;
  std::size_t drop = 0;  // elements before the new inlet, and a cut one of which little is left
  while (drop + 2 < b.size() && b[drop + 1] - first < least_part_kept * (b[drop + 1] - b[drop])) ++drop;
  b.erase(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(drop));
  mesh.degrees.erase(mesh.degrees.begin(), mesh.degrees.begin() + static_cast<std::ptrdiff_t>(drop));
  b.front() = first;
  mesh.inlet = inlet;
  return mesh;
}

}  // namespace ehd::reference::hp
