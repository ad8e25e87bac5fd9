// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/grid.hpp"

#include <algorithm>
#include <cmath>

namespace ehd::fast {

namespace {

/// Cells of the remainder's table: `small_table` up to the given number of intervals, `large_table` above. Compared
/// with solutions on whole tables, 128 cells move H_cen by 1.4e-6 of itself at (5000, 0), by 1e-7 at (5000, 10), H_min
/// by 1.3e-6 at most; 256 cells by less than a hundredth of that.
constexpr int small_table = 128, large_table = 256, small_table_up_to = 512;
/// Cells of the table for rough products. With 32 cells, 64 or those above GMRES takes the same number of steps to
/// within half a per cent, 7,400 at 150 random contacts (M = 0.5..1000, L = 0..20, both laws) to 1e-4; with 16 it takes
/// 5 % more. Up to `whole_table_up_to` intervals the interpolation costs more than the whole table.
constexpr int rough_table = 32, whole_table_up_to = 64;
/// Cells of a fine table: 256 cells leave 3e-8 of H_cen at (3000, 0), 2e-9 at (110, 0), 2e-11 at (10, 0), all cut at
/// -3 to -4.
constexpr int fine_table = 512;
/// Cells where the solution only makes a map. With 64 Newton takes as many steps as with whole tables. With 32 it takes
/// up to 1.4 times as many (950 contacts, M of 0.01..5000, L up to 30).
constexpr int table_of_maps = 64;

int table_cells(int n, Tables tables) {
  if (tables == Tables::of_maps) return std::min(n, table_of_maps);
  if (tables == Tables::fine) return std::min(n, fine_table);
  return n <= small_table ? n : n <= small_table_up_to ? small_table : large_table;
}

/// The wedge's k: third order in the inlet, where the pressure rises; more upwind where it falls. From one to the
/// other k follows 1/(1 + exp(bias_steepness X)). Near the spike k tends to -1. With any other k rho H oscillates
/// in front of the steep fall behind the spike; with -0.5 the oscillation grows tenfold from node to node.
constexpr double inlet_bias = 0.5, outlet_bias = -0.5, upwind_bias = -1, bias_steepness = 8;
/// near_spike is exp(-(distance/reach)^2). The reach is so many widths of the spike, but at most this part of the
/// distance from the spike to the exit. With both numbers doubled the films are as good.
constexpr double near_widths = 8, nearer_than_exit = 0.25;

}  // namespace

void Grid::product(const Array& P, Array& y, double& integral, Accuracy accuracy) {
  const double h = 1.0 / n;
  density_.resize(n + 1);
  density_ = slope * P;
  density_[0] = density_[n] = 0;
  toeplitz->apply(density_, y);
  if (accuracy == Accuracy::rough && rough_remainder) {
    rough_remainder->add(density_, y);
  } else if (remainder) {
    remainder->add(density_, y);
  }
  const double sum = density_.sum();
  integral = h * sum;
  y = h * y + h * std::log(h) * sum;
}

void Grid::product(const ArrayOf<Complex>& P, ArrayOf<Complex>& y, Complex& integral, Accuracy accuracy) {
  double by_real = 0, by_imaginary = 0;
  part_ = P.real();
  product(part_, real_, by_real, accuracy);
  part_ = P.imag();
  product(part_, imaginary_, by_imaginary, accuracy);
  y.resize(n + 1);
  y.real() = real_;
  y.imag() = imaginary_;
  integral = {by_real, by_imaginary};
}

const Array& Grid::first_column() {
  if (first_column_.size() > 0) return first_column_;
  Array unit = Array::Zero(n + 1);
  unit[0] = 1;
  first_column_.setConstant(n + 1, -std::log(static_cast<double>(n)));
  if (remainder) remainder->add(unit, first_column_);
  for (int i = 0; i <= n; ++i) first_column_[i] = first_column_[i] / 2 + toeplitz->inner_half_weight(i);
  first_column_ *= slope[0] / n;
  return first_column_;
}

const RowMajor& Grid::dense() {
  if (dense_.size() > 0) return dense_;
  const double h = 1.0 / n, log_h = std::log(h);
  dense_.resize(n + 1, n + 1);
  for (int i = 0; i <= n; ++i) {
    double* const row = dense_.row(i).data();
    for (int j = 0; j <= n; ++j) row[j] = toeplitz->weight(std::abs(i - j)) + log_h;
    if (remainder) remainder->add_row(i, row);
    for (int j = 0; j <= n; ++j) row[j] *= h * slope[j];
  }
  return dense_;
}

void Grids::use(std::shared_ptr<const Map> map, bool robust_wedge, Tables tables) {
  map_ = std::move(map);
  robust_wedge_ = robust_wedge;
  fineness_of_tables_ = tables;
  mapped_.clear();
  tables_.clear();
  nodes_.clear();
}

const MapNodes& Grids::nodes(int n) {
  const auto find = [&](auto wanted) {
    return std::find_if(nodes_.begin(), nodes_.end(),
                        [&](const MapNodes& one) { return wanted(static_cast<int>(one.X.size()) - 1); });
  };
  if (const auto known = find([&](int m) { return m == n; }); known != nodes_.end()) return *known;
  MapNodes made;
  if (const auto finer = find([&](int m) { return m > n && m % n == 0; }); finer != nodes_.end()) {
    const auto every = Eigen::seqN(0, n + 1, (finer->X.size() - 1) / n);
    made = {.X = finer->X(every), .slope = finer->slope(every)};
  } else if (const auto coarser = find([&](int m) { return 2 * m == n; }); coarser != nodes_.end()) {
    made = map_->refined(*coarser);
  } else {
    made = map_->nodes(n);
  }
  nodes_.push_back(std::move(made));
  return nodes_.back();
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
  const auto finer =
      std::find_if(tables_.begin(), tables_.end(), [&](const auto& one) { return one->cells % cells == 0; });
  if (finer != tables_.end()) {
    const auto every = Eigen::seqN(0, cells + 1, (*finer)->cells / cells);
    tables_.push_back(std::make_shared<const RemainderTable>(
        RemainderTable{.cells = cells, .values = (*finer)->values(every, every)}));
    return tables_.back();
  }
  const MapShape& shape = map_->shape();
  const double length = shape.exit - shape.inlet;
  const auto& [X, slope] = nodes(cells);
  tables_.push_back(std::make_shared<const RemainderTable>(
      RemainderTable::of((X - shape.inlet) / length, (slope * length).inverse())));
  return tables_.back();
}

SmoothRemainder Grids::remainder(int n, int cells) {
  if (cells == n) return SmoothRemainder(table(cells));
  const auto known =
      std::find_if(rules_.begin(), rules_.end(), [&](const auto& one) { return one->n == n && one->cells == cells; });
  if (known != rules_.end()) return {table(cells), *known};
  rules_.push_back(std::make_shared<const RemainderRule>(RemainderRule::of(n, cells)));
  return {table(cells), rules_.back()};
}

Grid& Grids::of(int intervals) {
  Grid& grid = unplanned(intervals);
  grid.toeplitz->plan();
  return grid;
}

Grid& Grids::unplanned(int intervals) {
  auto& grids = map_ ? mapped_ : uniform_;
  for (const auto& one : grids) {
    if (one->n == intervals) return *one;
  }
  auto made = std::make_unique<Grid>();
  Grid& grid = *made;
  grid.n = intervals;
  if (map_) {
    make_mapped(grid);
  } else {
    make_uniform(grid);
  }
  grid.inverse_slope = grid.slope.inverse();
  grid.inverse_spacing = grid.spacing.inverse();
  grid.first_weight = grid.slope[0] / intervals / 2;
  grids.push_back(std::move(made));  // whole: after an exception above the next solve makes it anew
  return grid;
}

void Grids::make_mapped(Grid& grid) {
  const int n = grid.n;
  const MapShape& shape = map_->shape();
  const double length = shape.exit - shape.inlet;
  const auto& [X, slope] = nodes(n);
  grid.place = (X - shape.inlet) / length;
  grid.slope = (slope * length).inverse();
  grid.spacing = (X.tail(n) - X.head(n)) / length;
  const double reach = std::min(near_widths * shape.spike_width, nearer_than_exit * (shape.exit - shape.spike));
  grid.near_spike = (-((X - shape.spike) / reach).square()).exp();
  for (const int end : {0, 1, n}) grid.near_spike[end] = 0;
  const double falling = robust_wedge_ ? upwind_bias : outlet_bias;
  grid.bias = inlet_bias - (inlet_bias - falling) / 2 * (2 - 2 / (1 + (bias_steepness * X.head(n)).exp()));
  grid.bias += (upwind_bias - grid.bias) * grid.near_spike.head(n);
  grid.toeplitz = &kernel(n, Rule::corrected_trapezoid);
  grid.remainder = remainder(n, table_cells(n, fineness_of_tables_));
  if (n > whole_table_up_to) grid.rough_remainder = remainder(n, rough_table);
}

void Grids::make_uniform(Grid& grid) {
  const int n = grid.n;
  grid.place = Array::LinSpaced(n + 1, 0, 1);
  grid.slope.setOnes(n + 1);
  grid.spacing.setConstant(n, 1.0 / n);
  grid.bias.setZero(n);
  grid.toeplitz = &kernel(n, Rule::piecewise_linear);
}

}  // namespace ehd::fast
