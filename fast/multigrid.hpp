// SPDX-License-Identifier: GPL-3.0-or-later
// One V(1,0) cycle of linear multigrid for the linearised problem: the preconditioner of GMRES.
//
// Smoother: a direct banded solve in the dipole variable d, phi'_j dP_j = 2 d_j - d_(j-1) - d_(j+1), which turns the
// log kernel into its second difference (~ 1/k^2), truncated at |k| <= 1; no relaxation factor. Flux errors are
// averaged over the two faces of a coarse cell, laws and fields are injected, corrections come back by linear
// interpolation. dH_0 and dX* are solved for on the coarsest level, which is dense (coarsest.hpp).
#pragma once

#include <memory>
#include <vector>

#include "fast/banded.hpp"
#include "fast/coarsest.hpp"
#include "fast/jacobian.hpp"
#include "fast/node_fields.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

class Multigrid {
 public:
  /// Linearises every level at the iterate of the finest, whose fields and Jacobian are given and must stay. False
  /// where the coarsest matrix is singular.
  [[nodiscard]] bool prepare(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                             const State& state, Grids& grids, Counters& counters);
  /// step = approximately J^-1 error.
  void cycle(const Residual& error, Step& step, Counters& counters);

 private:
  struct Level {
    int n = 0;
    const NodeFields* nodes = nullptr;
    const Jacobian* jacobian = nullptr;
    NodeFields own_nodes;  ///< on coarse levels
    Jacobian own_jacobian;
    Array pressure;
    Banded band;
    bool smooths = true;
    Residual error;
    Array dipole;
    Step step;

    void assemble_band();
    void smooth(Counters& counters);
    void restrict_to(Level& coarse) const;
    void add_correction(const Level& coarse);
  };

  void down(std::size_t index, Counters& counters);
  [[nodiscard]] Level& level_of(int intervals);

  std::vector<std::unique_ptr<Level>> known_;  ///< by number of intervals, kept for the next grid and the next solve
  std::vector<Level*> levels_;                 ///< in use, fine to coarse
  Coarsest coarsest_;
};

}  // namespace ehd::fast
