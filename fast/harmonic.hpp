// SPDX-License-Identifier: GPL-3.0-or-later
// The first-order equations of a small motion e^(s T) about the solution of one grid, s the rate: i Omega, or real.
//
//   (J - s Q) u = drive,  u = (P_1, H_01, X*_1) at fixed phi,
//
// with Newton's own Jacobian J (jacobian.hpp) and the squeeze Q (squeeze.hpp). The far inlet of a flooded contact
// follows the motion (moving_tail.hpp). The product contains the inlet's answer, the preconditioner does not. Solver:
// flexible GMRES with one multigrid cycle. Only these two depend on s; the rest is made once a grid. Where the nodes
// follow a spike there is one more unknown (moved_nodes.hpp).
//
// Tried without gain, at (20, 10) to 1e-4, 512 intervals:
// - a smoother without the kernel's smooth remainder: a third more GMRES steps, 1.14 times the instructions. Inside the
//   grid its dipoles hardly see the remainder; at the ends they do;
// - GMRES ended at three times the residual: 1.03 times the instructions, because its error is stated too;
// - a start extrapolated from two coarser grids: as many steps, at (200, 12) too;
// - the smooth remainder in complex numbers: a third more instructions in all than in two real products.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "contact/response.hpp"
#include "fast/gmres.hpp"
#include "fast/moved_nodes.hpp"
#include "fast/moving_tail.hpp"
#include "fast/multigrid.hpp"

namespace ehd::fast {

class Harmonic {
 public:
  /// Small motions about `state`, a solution on its grid with the fields `nodes`. `grids` must keep its map.
  Harmonic(const Setting& setting, const NodeFields& nodes, const State& state, Grids& grids, Counters& counters);

  /// The solution u, and the part `residual` of the drive that it leaves, in the norm of Newton's method. Where the
  /// nodes follow the spike, u is taken at nodes that move by m.
  template <class Scalar>
  struct Motion {
    StepOf<Scalar> u;
    Scalar m{0};
    double residual = 1;
    ArrayOf<Scalar> driving_film = {};  ///< n + 1: R_1, and the film of the far inlet's answer to it; none for a load
  };
  /// For a load of amplitude 1, R_1 = 0. With `moved`, made for this grid, the nodes follow the spike. `coarser`: the
  /// motion on the grid with half as many intervals, where the iteration starts. The iteration ends where at most
  /// `residual` of the drive is left, or where it no longer gains.
  template <class Scalar>
  [[nodiscard]] Motion<Scalar> of_load(Scalar rate, double residual, const MovedNodes* moved = nullptr,
                                       const Motion<Scalar>* coarser = nullptr);
  /// For a waviness of amplitude 1 at a constant load.
  [[nodiscard]] Motion<Complex> of_waviness(const Waviness& waviness, double residual,
                                            const MovedNodes* moved = nullptr,
                                            const Motion<Complex>* coarser = nullptr);
  /// What drives the far inlet besides the change u: nodes that move, or a waviness.
  template <class Scalar>
  struct Beyond {
    Scalar load{0}, moment{0};  ///< added to W_1 and m_1 of MovingTail::Drive
    Scalar inflow{0}, flux{0};  ///< added to F_1(X_a): inflow times the rate, and flux
    MovingTail::Answer<Scalar> own = MovingTail::Answer<Scalar>::Zero();  ///< of a waviness
  };
  /// What drives a motion besides the bodies.
  struct Sources {
    ArrayOf<Complex> feature;  ///< R_1 at the nodes, n + 1
    ArrayOf<Complex> flux;     ///< of the flux errors, n faces
    Complex load = 0;          ///< W_1
    Beyond<Complex> beyond = {};
  };
  [[nodiscard]] Motion<Complex> of_sources(Complex rate, const Sources& sources, double residual,
                                           const MovedNodes* moved = nullptr, const Motion<Complex>* coarser = nullptr);
  /// Second term for slow motion: u(s) = u + s u_1, m(s) = m + s m_1. `rest`: the motion by the load at s = 0.
  [[nodiscard]] Motion<double> of_slow_load(const Motion<double>& rest, double residual,
                                            const MovedNodes* moved = nullptr, const Motion<double>* coarser = nullptr);

  /// H_1 at X = 0, without R_1, of a motion that was solved last. Empty where the contact does not reach X = 0.
  [[nodiscard]] std::optional<Complex> central_film(const Waviness& waviness, Motion<Complex>& motion,
                                                    const MovedNodes* moved = nullptr);
  /// (J - s Q) u. Valid until the next call.
  template <class Scalar>
  [[nodiscard]] const ChangeOf<Scalar>& product(Scalar rate, StepOf<Scalar>& u) {
    return change_by(rate, u);
  }

  [[nodiscard]] int intervals() const { return nodes_.n; }
  /// The widest cell of -1 < X < X*, which disturbances have to cross.
  [[nodiscard]] double widest_cell() const;

 private:
  /// Solver and storage for one kind of number, real or complex.
  template <class Scalar>
  struct SolverOf {
    MultigridOf<Scalar> multigrid;
    GmresOf<Scalar> gmres;
    std::vector<Motion<Scalar>> preconditioned;
    ArrayOf<Scalar> right_side;
    ResidualOf<Scalar> unscaled;
    bool prepared = false;
    std::optional<Scalar> factorised = {};  ///< the rate of the factors
    /// Where the nodes follow the spike: the change by m = 1 at this rate, R_m - s q of moved_nodes.hpp, with the
    /// tail's answer.
    std::optional<ChangeOf<Scalar>> by_m = {};
    StepOf<Scalar> answer = {};  ///< the contact's rough answer to by_m; until it is solved, that at the rate before
  };

  template <class Scalar>
  [[nodiscard]] Motion<Scalar> solved(Scalar rate, const ResidualOf<Scalar>& drive, double residual,
                                      const MovedNodes* moved, const Motion<Scalar>* coarser);
  template <class Scalar>
  void correct(Scalar rate, const ResidualOf<Scalar>& left, double relative, Motion<Scalar>& motion);
  template <class Scalar>
  void let_nodes_follow(Scalar rate, const MovedNodes* moved);
  template <class Scalar>
  [[nodiscard]] std::optional<StepOf<Scalar>> answer_before() const;
  template <class Scalar>
  void take_spike_out(Motion<Scalar>& motion) const;
  template <class Scalar>
  [[nodiscard]] ChangeOf<Scalar>& change_by(Scalar rate, StepOf<Scalar>& u);
  template <class Scalar>
  [[nodiscard]] const ChangeOf<Scalar>& change_by(Scalar rate, Motion<Scalar>& motion);
  template <class Scalar>
  void answer_of_tail(Scalar rate, StepOf<Scalar>& u, ChangeOf<Scalar>& change,
                      const Beyond<Scalar>& beyond = {}) const;
  [[nodiscard]] Beyond<Complex> beyond(const Waviness& waviness, const ArrayOf<Complex>& feature) const;
  template <class Scalar>
  [[nodiscard]] ChangeOf<Scalar> by_moved_nodes(Scalar rate, const MovedNodes& moved);
  template <class Scalar>
  [[nodiscard]] bool factorised(Scalar rate);
  [[nodiscard]] Complex at_centre(const ArrayOf<Complex>& H_1, const ArrayOf<Complex>& X_1) const;
  [[nodiscard]] double norm(const auto& residual) const;
  [[nodiscard]] ArrayOf<Complex> feature(const Waviness& waviness) const;

  std::optional<MovingTail> tail_;
  const Setting setting_;
  const NodeFields nodes_;
  const State state_;
  Grids& grids_;
  Counters& counters_;
  Jacobian jacobian_;
  Squeeze squeeze_;
  Array X_;
  Eigen::Matrix<double, Eigen::Dynamic, 6> film_by_tail_;  ///< film by P_1(X_a) and by the factors of 1, X, …, X^4
  Array moment_;                                           ///< Int P X dX by P_j, n + 1
  double moment_by_exit_ = 0, load_by_first_ = 0;          ///< load_by_first_: load within the grid by P_1(X_a)
  double flux_scale_;
  std::tuple<SolverOf<double>, SolverOf<Complex>> solvers_;
};

}  // namespace ehd::fast
