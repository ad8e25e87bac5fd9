// SPDX-License-Identifier: GPL-3.0-or-later
// One V(1,0) cycle of linear multigrid for the linearised problem: the preconditioner of GMRES.
//
// Smoother: a direct banded solve in the dipole variable d, phi'_j dP_j = 2 d_j - d_(j-1) - d_(j+1), which turns the
// log kernel into its second difference (~ 1/k^2), truncated at |k| <= 1; no relaxation factor. Flux errors are
// averaged over the two faces of a coarse cell, laws and fields are injected, corrections come back by linear
// interpolation. dH_0 and dX* are solved for on the coarsest level, which is dense (coarsest.hpp).
//
// For a motion of the rate s (squeeze.hpp) every level contains the squeeze: s w_i m_i in row i of the band, s Q in the
// errors and in the coarsest matrix.
#pragma once

#include <memory>
#include <vector>

#include "fast/banded.hpp"
#include "fast/coarsest.hpp"
#include "fast/jacobian.hpp"
#include "fast/node_fields.hpp"
#include "fast/squeeze.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

template <class Scalar>
class MultigridOf {
 public:
  /// Linearises every level at the iterate of the finest, whose fields and Jacobian are given and must stay, and
  /// factorises them. False where the coarsest matrix is singular.
  [[nodiscard]] bool prepare(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                             const State& state, Grids& grids, Counters& counters);
  /// Linearises every level for motions. The factors come later, by factorise(rate).
  void prepare_motion(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                      const Squeeze& squeeze, const State& state, Grids& grids, Counters& counters);
  /// Factorises the levels of a motion for this rate. False where the coarsest matrix is singular.
  [[nodiscard]] bool factorise(Scalar rate, Counters& counters);
  /// step = approximately J^-1 error.
  void cycle(const ResidualOf<Scalar>& error, StepOf<Scalar>& step, Counters& counters);

 private:
  struct Level {
    int n = 0;
    const NodeFields* nodes = nullptr;
    const Jacobian* jacobian = nullptr;
    const Squeeze* squeeze = nullptr;  ///< of a motion
    NodeFields own_nodes;              ///< on coarse levels
    Jacobian own_jacobian;
    Squeeze own_squeeze;
    Array pressure;
    BandedOf<Scalar> band;
    bool smooths = true;
    ResidualOf<Scalar> error;
    ArrayOf<Scalar> dipole;
    StepOf<Scalar> step;

    void assemble_band(Scalar rate);
    void smooth(Scalar rate, Counters& counters);
    void restrict_to(Level& coarse) const;
    void add_correction(const Level& coarse);
  };

  void linearise(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian, const Squeeze* squeeze,
                 const State& state, Grids& grids, Counters& counters);
  void factorise_bands();
  void down(std::size_t index, Counters& counters);
  [[nodiscard]] Level& level_of(int intervals);

  std::vector<std::unique_ptr<Level>> known_;  ///< by number of intervals, kept for the next grid and the next solve
  std::vector<Level*> levels_;                 ///< in use, fine to coarse
  CoarsestOf<Scalar> coarsest_;
  Scalar rate_{0};
};
using Multigrid = MultigridOf<double>;

}  // namespace ehd::fast
