// SPDX-License-Identifier: GPL-3.0-or-later
// One V(1,0) cycle of linear multigrid for the linearised problem: the preconditioner of GMRES.
//
// Smoother: a direct banded solve in the dipole variable d, dP_j = 2 d_j - d_(j-1) - d_(j+1), which turns the log kernel
// into its second difference (~ 1/k^2), truncated at |k| <= 1; no relaxation factor. Flux errors are averaged over the
// two faces of a coarse cell, laws and fields are injected, corrections come back by linear interpolation. dH_0 and dX*
// are solved on the coarsest level, which is dense.
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "fast/banded.hpp"
#include "fast/discretisation.hpp"

namespace ehd::fast {

class Multigrid {
 public:
  /// Dense from here on: uniform grids, where 32 and 128 measured no better, and mapped ones.
  static constexpr int coarsest_uniform = 64, coarsest_mapped = 32;

  /// Linearises every level at the iterate of `finest` (which is linearised already). False where the coarsest matrix
  /// is singular.
  [[nodiscard]] bool prepare(const Setting& setting, const Discretisation& finest, const State& state, Grids& grids,
                             Counters& counters);
  /// step = approximately J^-1 (flux error, load error).
  void cycle(const Array& flux_error, double load_error, Step& step, Counters& counters);

 private:
  struct Level {
    int n = 0;
    const Discretisation* scheme = nullptr;
    std::unique_ptr<Discretisation> own;  ///< on coarse levels
    Grid* grid = nullptr;
    Array pressure;
    Banded band;
    bool smooths = true;
    Array error, change, dipole;
    Step step;
  };

  void assemble_band(Level& level) const;
  [[nodiscard]] bool assemble_dense(const Level& level);
  void solve_dense(Level& level, double load_error);
  void down(std::size_t index, double load_error, Counters& counters);

  [[nodiscard]] Level& level_of(int intervals);

  std::vector<std::unique_ptr<Level>> known_;  ///< by number of intervals, kept for the next grid and the next solve
  std::vector<Level*> levels_;                 ///< in use, fine to coarse
  RowMajor film_, dense_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;  ///< of the transpose: Eigen is quicker by columns
  Eigen::VectorXd right_side_, solution_;
  Eigen::RowVectorXd integral_;
};

}  // namespace ehd::fast
