// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/grid.hpp"

#include <cmath>

namespace ehd::fast {

namespace {

/// Cells of the remainder's table for n intervals. Against the dense product at M = 5000 (tests): 128 cells err by 3e-7
/// of H_cen, 256 by less than 1e-9.
int table_cells(int n) { return n <= 256 ? n : n <= 1024 ? 128 : 256; }

}  // namespace

void Grid::product(const Array& P, Array& y, double& integral) {
  const double h = 1.0 / n;
  density_.resize(n + 1);
  density_ = slope * P;
  density_[0] = density_[n] = 0;
  toeplitz->apply(density_, y);
  if (remainder) remainder->add(density_, y);
  const double sum = density_.sum();
  integral = h * sum;
  y = h * y + h * std::log(h) * sum;
}

const Eigen::MatrixXd& Grid::dense() {
  if (dense_.size() > 0) return dense_;
  const double h = 1.0 / n, log_h = std::log(h);
  dense_.resize(n + 1, n + 1);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double beside = remainder ? remainder->entry(i, j) : 0;
      dense_(i, j) = h * slope[j] * (toeplitz->weight(std::abs(i - j)) + beside + log_h);
    }
  }
  return dense_;
}

void Grids::use(std::shared_ptr<const Map> map, bool robust_wedge) {
  map_ = std::move(map);
  robust_wedge_ = robust_wedge;
  mapped_.clear();
  tables_.clear();
}

Convolution& Grids::kernel(int intervals, Rule rule) {
  for (const Kernel& one : kernels_) {
    if (one.intervals == intervals && one.rule == rule) return *one.convolution;
  }
  kernels_.push_back({intervals, rule, std::make_unique<Convolution>(intervals, rule)});
  return *kernels_.back().convolution;
}

double Grids::planning_s() const {
  double sum = 0;
  for (const Kernel& one : kernels_) sum += one.convolution->planning_s();
  return sum;
}

std::shared_ptr<const RemainderTable> Grids::table(int cells) {
  for (const auto& one : tables_) {
    if (one->cells == cells) return one;
  }
  const MapShape& shape = map_->shape();
  const double length = shape.exit - shape.inlet;
  const Array X = map_->nodes(cells);
  tables_.push_back(std::make_shared<const RemainderTable>(
      RemainderTable::of((X - shape.inlet) / length, (map_->slopes(X) * length).inverse())));
  return tables_.back();
}

Grid& Grids::of(int intervals) {
  auto& grids = map_ ? mapped_ : uniform_;
  for (const auto& one : grids) {
    if (one->n == intervals) return *one;
  }
  grids.push_back(std::make_unique<Grid>());
  Grid& grid = *grids.back();
  const int n = grid.n = intervals;
  if (map_) {
    const MapShape& shape = map_->shape();
    const double length = shape.exit - shape.inlet;
    const Array X = map_->nodes(n);
    grid.place = (X - shape.inlet) / length;
    grid.slope = (map_->slopes(X) * length).inverse();
    grid.spacing = (X.tail(n) - X.head(n)) / length;
    // Third order where the inlet's pressure rises, upwind where the spike may stand.
    const double at_spike = robust_wedge_ ? -1 : -0.5;
    grid.bias = 0.5 - (0.5 - at_spike) / 2 * (1 + (4 * X.head(n)).tanh());
    grid.toeplitz = &kernel(n, Rule::corrected_trapezoid);
    grid.remainder.emplace(n, table(table_cells(n)));
  } else {
    grid.place = Array::LinSpaced(n + 1, 0, 1);
    grid.slope.setOnes(n + 1);
    grid.spacing.setConstant(n, 1.0 / n);
    grid.bias.setZero(n);
    grid.toeplitz = &kernel(n, Rule::piecewise_linear);
  }
  grid.by_slope = grid.slope.inverse();
  grid.by_spacing = grid.spacing.inverse();
  const double h = 1.0 / n, log_h = std::log(h);
  grid.first_weight = h * grid.slope[0] / 2;
  grid.first_column.resize(n + 1);
  for (int i = 0; i <= n; ++i) {
    const double beside = grid.remainder ? grid.remainder->entry(i, 0) : 0;
    grid.first_column[i] = h * grid.slope[0] * (grid.toeplitz->inner_half_weight(i) + (beside + log_h) / 2);
  }
  return grid;
}

}  // namespace ehd::fast
