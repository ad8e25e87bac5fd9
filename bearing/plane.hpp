// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and symmetric matrices in the plane of a bearing, x along the load and y across it. Closed forms: a general
// eigensolver for two unknowns costs 10 s to compile.
#pragma once

#include <array>
#include <cmath>

namespace ehd::bearing {

struct Vector2 {
  double x = 0, y = 0;

  friend Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector2 operator*(double factor, Vector2 v) { return {factor * v.x, factor * v.y}; }
  friend Vector2 operator/(Vector2 v, double divisor) { return {v.x / divisor, v.y / divisor}; }
};
[[nodiscard]] inline double dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double norm(Vector2 v) { return std::sqrt(dot(v, v)); }
[[nodiscard]] inline bool is_finite(Vector2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

/// [xx xy; xy yy].
struct Symmetric2 {
  double xx = 0, xy = 0, yy = 0;

  /// Adds factor n n'.
  void add(double factor, Vector2 n) {
    xx += factor * n.x * n.x;
    xy += factor * n.x * n.y;
    yy += factor * n.y * n.y;
  }
  friend Vector2 operator*(const Symmetric2& a, Vector2 v) {
    return {a.xx * v.x + a.xy * v.y, a.xy * v.x + a.yy * v.y};
  }
};

/// Eigenvalues, the one of larger size first, and unit eigenvectors at right angles.
struct Principal {
  std::array<double, 2> values = {};
  std::array<Vector2, 2> axes = {};
};
/// Both eigenvalues keep their digits: the smaller one is the determinant over the larger one, and the determinant is
/// computed without cancellation. The products of two entries must neither overflow nor underflow.
[[nodiscard]] Principal principal(const Symmetric2& matrix);

/// Moore-Penrose inverse. An eigenvalue below 2 epsilon of the other counts as zero, the threshold of Eigen's complete
/// orthogonal decomposition for two unknowns.
[[nodiscard]] Symmetric2 pseudo_inverse(const Symmetric2& matrix);

}  // namespace ehd::bearing
