// SPDX-License-Identifier: GPL-3.0-or-later
// The map of the mapped grid: where its nodes stand.
//
//   s(X) ~ asinh(X/(0.7 l)) + asinh((X + l)/(d l)) + 3 atan((X + l(1 + d))/(2 d l)) + asinh((X - X_sp)/w_sp)
//
// one term for the whole contact, two for the inlet zone at X = -l of width d l, one for the spike; scaled to s = 0 at
// the inlet and s = 1 at the exit. Nodes stand at equal steps of s.
#pragma once

#include "contact/array.hpp"

namespace ehd::fast {

/// The lengths that a map is made for, in Hertz half-widths.
struct MapShape {
  double inlet = -4;       ///< X_a
  double exit = 1;         ///< X* that is expected
  double scale = 1;        ///< l: half the width of the loaded zone
  double inlet_width = 1;  ///< d: width of the inlet zone over l, min(1, H_cen)^(2/3)
  double spike = 1;        ///< X_sp
  double spike_width = 1;  ///< w_sp
};

/// X at equal steps of s, and ds/dX there.
struct MapNodes {
  Array X, slope;
};

class Map {
 public:
  explicit Map(const MapShape& shape);

  [[nodiscard]] const MapShape& shape() const { return shape_; }
  /// s: 0 at the inlet, 1 at the exit, below 0 or above 1 where X lies outside.
  [[nodiscard]] double operator()(double X) const;
  /// ds/dX.
  [[nodiscard]] double slope(double X) const;

  /// The nodes at s = 0, 1/n, …, 1, to rounding.
  [[nodiscard]] MapNodes nodes(int n) const;
  /// The nodes for twice as many intervals as `coarse` has.
  [[nodiscard]] MapNodes refined(const MapNodes& coarse) const;

 private:
  /// Places are evaluated in blocks of so many: vector instructions, and no array in memory between the operations.
  static constexpr int block = 4;
  using Block = Eigen::Array<double, block, 1>;
  struct Values {
    Block s, slope, curvature;  ///< s, ds/dX, d2s/dX2
  };

  /// s before it is scaled to 0 and 1.
  [[nodiscard]] double raw(double X) const;
  [[nodiscard]] Array samples() const;
  [[nodiscard]] Values evaluate(const Block& X) const;
  [[nodiscard]] Block slopes(const Block& X) const;
  /// The X where s is `target`, and the slopes there. `X`: first guesses, within [low, high].
  [[nodiscard]] MapNodes sharpened(const Array& X, const Array& target, const Array& low, const Array& high) const;
  [[nodiscard]] Block sharpened(Block X, const Block& target, const Block& low, const Block& high) const;
  [[nodiscard]] double inverse(double s, double guess, double low, double high) const;

  MapShape shape_;
  double first_ = 0, range_ = 1;
};

}  // namespace ehd::fast
