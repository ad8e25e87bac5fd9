// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/contour_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehd::report {

std::vector<std::vector<Point>> contour_lines(const std::vector<double>& values, std::size_t columns, std::size_t rows,
                                              double level) {
  if (columns < 2 || rows < 2 || values.size() != columns * rows) return {};
  // Each crossing lies on a grid edge. An edge is named by its lower node and its direction, so that the two squares
  // beside the edge name the same crossing.
  struct Segment {
    std::size_t from, to;  // edges
    bool used = false;
  };
  const auto value = [&](std::size_t i, std::size_t j) { return values[j * columns + i]; };
  const auto edge = [&](std::size_t i, std::size_t j, bool up) { return 2 * (j * columns + i) + (up ? 1U : 0U); };
  std::vector<Segment> segments;
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const double a = value(i, j), b = value(i + 1, j), c = value(i + 1, j + 1), d = value(i, j + 1);
      if (!std::isfinite(a + b + c + d)) continue;
      const bool above_a = a > level, above_b = b > level, above_c = c > level, above_d = d > level;
      const std::size_t low = edge(i, j, false), right = edge(i + 1, j, true), high = edge(i, j + 1, false),
                        left = edge(i, j, true);
      std::vector<std::size_t> crossed;
      if (above_a != above_b) crossed.push_back(low);
      if (above_b != above_c) crossed.push_back(right);
      if (above_c != above_d) crossed.push_back(high);
      if (above_d != above_a) crossed.push_back(left);
      if (crossed.size() == 2) segments.push_back({crossed[0], crossed[1]});
      if (crossed.size() == 4) {  // a saddle: the mean value decides which corners are joined
        const bool middle = (a + b + c + d) / 4 > level;
        if (middle == above_a) {
          segments.push_back({low, right});
          segments.push_back({high, left});
        } else {
          segments.push_back({low, left});
          segments.push_back({right, high});
        }
      }
    }
  }
  const auto point = [&](std::size_t name) {
    const bool up = name % 2 == 1;
    const std::size_t i = (name / 2) % columns, j = (name / 2) / columns;
    const double from = value(i, j), to = up ? value(i, j + 1) : value(i + 1, j);
    const double share = (level - from) / (to - from);
    return Point{static_cast<double>(i) + (up ? 0 : share), static_cast<double>(j) + (up ? share : 0)};
  };
  std::vector<std::vector<Point>> lines;
  for (Segment& start : segments) {
    if (start.used) continue;
    start.used = true;
    std::vector<std::size_t> chain{start.from, start.to};
    for (int side = 0; side < 2; ++side) {
      for (bool grown = true; grown;) {
        grown = false;
        for (Segment& next : segments) {
          if (next.used || (next.from != chain.back() && next.to != chain.back())) continue;
          next.used = true;
          chain.push_back(next.from == chain.back() ? next.to : next.from);
          grown = true;
          break;
        }
      }
      std::reverse(chain.begin(), chain.end());
    }
    std::vector<Point> line;
    for (const std::size_t name : chain) line.push_back(point(name));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace ehd::report
