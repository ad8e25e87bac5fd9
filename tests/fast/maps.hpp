// SPDX-License-Identifier: GPL-3.0-or-later
// Maps for tests: extremes of those that `fast` makes, and an easy one.
#pragma once

#include "fast/map.hpp"

namespace ehd {

struct NamedShape {
  const char* name;
  fast::MapShape shape;
};

/// As at (M, L) = (5000, 10): an inlet zone of a thousandth and the narrowest spike.
inline constexpr NamedShape heaviest{
    "M = 5000", {.inlet = -4, .exit = 1.0009, .scale = 1, .inlet_width = 0.002, .spike = 0.9991, .spike_width = 4e-5}};

inline constexpr NamedShape named_shapes[] = {
    heaviest,
    {"flooded from -16",
     {.inlet = -16, .exit = 1.11, .scale = 1, .inlet_width = 0.21, .spike = 0.93, .spike_width = 0.013}},
    {"flooded from -60",
     {.inlet = -60, .exit = 1.03, .scale = 1, .inlet_width = 0.07, .spike = 0.97, .spike_width = 0.0014}},
    {"thick film", {.inlet = -177, .exit = 5.3, .scale = 11, .inlet_width = 1, .spike = -4.6, .spike_width = 5.5}},
    {"moderate", {.inlet = -3.7, .exit = 1.17, .scale = 1, .inlet_width = 0.37, .spike = 0.84, .spike_width = 0.19}}};

/// phi and phi' at X.
struct Places {
  Array place, slope;
};
inline Places places_of(const fast::Map& map, const Array& X) {
  const double length = map.shape().exit - map.shape().inlet;
  Places at{.place = (X - map.shape().inlet) / length, .slope = Array(X.size())};
  for (Eigen::Index i = 0; i < X.size(); ++i) at.slope[i] = 1 / (map.slope(X[i]) * length);
  return at;
}

/// Lambda_ij by its definition, from all nodes.
inline double remainder_between(const Places& at, Eigen::Index i, Eigen::Index j) {
  const double n = static_cast<double>(at.place.size() - 1);
  return i == j ? std::log(at.slope[i]) : std::log((at.place[i] - at.place[j]) / (static_cast<double>(i - j) / n));
}

}  // namespace ehd
