// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/monotone_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ehd::bearing {

namespace {

/// One row of a tridiagonal system.
struct Row {
  double before = 0, diagonal = 0, after = 0, right = 0;
};

/// Elimination without exchanges. A spline's rows need none: every factor is at most one, and of the pivots only the
/// last one is a difference. It loses less than a digit where the last two gaps differ by less than a factor of eight.
std::vector<double> solve_tridiagonal(std::vector<Row> rows) {
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double factor = rows[k].before / rows[k - 1].diagonal;
    rows[k].diagonal -= factor * rows[k - 1].after;
    rows[k].right -= factor * rows[k - 1].right;
  }
  std::vector<double> solution(rows.size());
  solution.back() = rows.back().right / rows.back().diagonal;
  for (std::size_t k = rows.size() - 1; k-- > 0;)
    solution[k] = (rows[k].right - rows[k].after * solution[k + 1]) / rows[k].diagonal;
  return solution;
}

struct Piece {
  double width = 0, secant = 0;
};

/// The third derivative does not jump at the point next to an end. `next`: the piece inwards of `end`. Returns the
/// factors of the end's slope and of its neighbour's slope, and the right-hand side.
std::array<double, 3> not_a_knot(const Piece& end, const Piece& next) {
  const double both = end.width + next.width;
  return {next.width, both,
          ((end.width + 2 * both) * next.width * end.secant + end.width * end.width * next.secant) / both};
}

/// The system of the spline's slopes.
std::vector<Row> rows_of(const std::vector<Piece>& pieces) {
  const std::size_t last = pieces.size();
  std::vector<Row> rows(last + 1);
  for (std::size_t k = 1; k < last; ++k) {
    const Piece &left = pieces[k - 1], &right = pieces[k];
    rows[k] = {right.width, 2 * (left.width + right.width), left.width,
               3 * (right.width * left.secant + left.width * right.secant)};
  }
  if (last == 2) {  // one parabola: the slopes at both ends of a piece have the secant as their mean
    rows[0] = {0, 1, 1, 2 * pieces[0].secant};
    rows[2] = {1, 1, 0, 2 * pieces[1].secant};
    return rows;
  }
  const auto first_end = not_a_knot(pieces[0], pieces[1]), last_end = not_a_knot(pieces[last - 1], pieces[last - 2]);
  rows[0] = {0, first_end[0], first_end[1], first_end[2]};
  rows[last] = {last_end[1], last_end[0], 0, last_end[2]};
  return rows;
}

/// Hyman's limit: where both secants beside a point have one sign, its slope has it too, and is at most three times the
/// smaller one. An extremum of the points keeps its slope.
double limited(double slope, double before, double after) {
  constexpr double steepest = 3;
  if (!(before * after > 0)) return slope;
  const double largest = steepest * std::min(std::abs(before), std::abs(after));
  return before > 0 ? std::clamp(slope, 0.0, largest) : std::clamp(slope, -largest, 0.0);
}

std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y, MonotoneSpline::Limit limit) {
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k + 1 < x.size(); ++k)
    pieces.push_back({x[k + 1] - x[k], (y[k + 1] - y[k]) / (x[k + 1] - x[k])});
  std::vector<double> result = solve_tridiagonal(rows_of(pieces));
  if (limit == MonotoneSpline::Limit::none) return result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Piece &before = pieces[k > 0 ? k - 1 : 0], &after = pieces[std::min(k, pieces.size() - 1)];
    result[k] = limited(result[k], before.secant, after.secant);
  }
  return result;
}

}  // namespace

MonotoneSpline::MonotoneSpline(std::vector<double> x, std::vector<double> y, Limit limit)
    : x_(std::move(x)), y_(std::move(y)), slope_(slopes(x_, y_, limit)) {}

ValueAndSlope MonotoneSpline::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double h = x_[k + 1] - x_[k], t = (x - x_[k]) / h, secant = (y_[k + 1] - y_[k]) / h;
  const double c2 = 3 * secant - 2 * slope_[k] - slope_[k + 1], c3 = slope_[k] + slope_[k + 1] - 2 * secant;
  return {y_[k] + h * t * (slope_[k] + t * (c2 + t * c3)), slope_[k] + t * (2 * c2 + t * 3 * c3)};
}

}  // namespace ehd::bearing
