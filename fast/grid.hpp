// SPDX-License-Identifier: GPL-3.0-or-later
// A grid on [X_a, X*], X_i = X_a + (X* - X_a) phi_i with phi_i = phi(i/n), and the kernel product on it. The exit moves
// while Newton runs; the map phi does not. fast.uniform: phi(s) = s. fast: a Map.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "contact/array.hpp"
#include "fast/convolution.hpp"
#include "fast/map.hpp"
#include "fast/scalar.hpp"
#include "fast/smooth_remainder.hpp"

namespace ehd::fast {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How exact a product is: `rough` takes the smooth remainder from a small table, which is enough for a smoother.
enum class Accuracy { full, rough };

/// Tables of the smooth remainder. mapped_ways.cpp takes `fine` ones for tolerances of 1e-7 and below
/// (3e-5 where M > 2e4), and for given grids of more than 4096 intervals. mapped_start.cpp takes those `of_maps` for
/// solutions that only make a map.
enum class Tables { of_maps, usual, fine };

struct Grid {
  int n = 0;              ///< intervals
  Array place;            ///< phi_i, n + 1
  Array slope;            ///< phi'_i, n + 1
  Array inverse_slope;    ///< 1/phi'_i, n + 1
  Array spacing;          ///< phi_(i+1) - phi_i, n
  Array inverse_spacing;  ///< n
  /// k of the wedge at each node, f_(i+1/2) = f_i + [(1+k)(f_(i+1) - f_i) + (1-k)(f_i - f_(i-1))]/4; n.
  Array bias;
  Array near_spike;         ///< 1 at the spike, less away from it, n + 1; empty on uniform grids
  double first_weight = 0;  ///< weight of P_0 in the integral: the first node's half of a cell

  /// y_i = Sum_j K_ij P_j over j = 1..n-1, and the integral S of P over phi, so that
  /// Int P ln|X_i - X'| dX' = l (y_i + ln l S) on [X_a, X*], l = X* - X_a. P_0 and P_n are ignored.
  void product(const Array& P, Array& y, double& integral, Accuracy accuracy = Accuracy::full);
  /// Of a complex P: two real products.
  void product(const ArrayOf<Complex>& P, ArrayOf<Complex>& y, Complex& integral, Accuracy accuracy = Accuracy::full);
  /// Column of P_0 in the product; made once.
  [[nodiscard]] const Array& first_column();
  /// K_ij for 0 < j < n, dense; made once.
  [[nodiscard]] const RowMajor& dense();
  /// The Toeplitz part's weight between nodes k apart, for g = phi' P.
  [[nodiscard]] double weight(int k) const { return toeplitz->weight(k); }

  Convolution* toeplitz = nullptr;
  std::optional<SmoothRemainder> remainder, rough_remainder;

 private:
  Array density_;                  ///< phi' P
  Array part_, real_, imaginary_;  ///< of a complex product
  Array first_column_;
  RowMajor dense_;
};

/// The grids of a workspace, by number of intervals; FFT plans outlive maps.
class Grids {
 public:
  /// From now on the grids are those of this map; without a map, the uniform ones.
  void use(std::shared_ptr<const Map> map, bool robust_wedge = false, Tables tables = Tables::usual);
  /// Ready for products.
  [[nodiscard]] Grid& of(int intervals);
  /// The same without FFT plans, which wait for the first product: for the coarsest grid of a multigrid cycle.
  [[nodiscard]] Grid& unplanned(int intervals);
  [[nodiscard]] const Map* map() const { return map_.get(); }
  [[nodiscard]] bool robust_wedge() const { return robust_wedge_; }
  [[nodiscard]] Tables tables() const { return fineness_of_tables_; }
  [[nodiscard]] double planning_s() const;

 private:
  struct Kernel {
    int intervals;
    Rule rule;
    std::unique_ptr<Convolution> convolution;
  };
  void make_uniform(Grid& grid);
  void make_mapped(Grid& grid);
  [[nodiscard]] Convolution& kernel(int intervals, Rule rule);
  [[nodiscard]] std::shared_ptr<const RemainderTable> table(int cells);
  /// The remainder on n + 1 nodes by the table of so many cells.
  [[nodiscard]] SmoothRemainder remainder(int n, int cells);
  /// The map's nodes. They are taken from the finest nodes made so far, where these contain them.
  [[nodiscard]] const MapNodes& nodes(int n);

  std::shared_ptr<const Map> map_;
  bool robust_wedge_ = false;
  Tables fineness_of_tables_ = Tables::usual;
  std::vector<Kernel> kernels_;
  std::vector<std::unique_ptr<Grid>> uniform_, mapped_;
  std::vector<std::shared_ptr<const RemainderTable>> tables_;
  std::vector<std::shared_ptr<const RemainderRule>> rules_;  ///< outlive maps, as FFT plans do
  std::vector<MapNodes> nodes_;
};

}  // namespace ehd::fast
