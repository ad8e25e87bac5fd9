// SPDX-License-Identifier: GPL-3.0-or-later
// The problem on a grid (Setting), its unknowns (State), a correction of them (Step), and the equations' errors
// (Residual). Corrections and errors are real in Newton's method, complex in harmonic motion.
#pragma once

#include <memory>

#include "contact/array.hpp"
#include "contact/problem.hpp"
#include "contact/rheology.hpp"
#include "fast/inlet_tail.hpp"
#include "fast/scalar.hpp"

namespace ehd::fast {

/// What stays fixed while Newton runs.
struct Setting {
  Groups groups;
  Viscosity viscosity;
  Density density;
  double inlet = -4;                            ///< X_a
  bool with_tail = false;                       ///< flooded: the asymptotic inlet lies beyond X_a
  double fluidity_floor = 0;                    ///< added to the mean of 1/eta at each face; 0 in every solution
  std::shared_ptr<const Sources> sources = {};  ///< of a manufactured solution; empty in physical problems
};

/// The unknowns. P has n + 1 entries; P_0 is 0, or the pressure of the tail; P_n = 0.
struct State {
  Array P;
  double offset = 0;  ///< H_0
  double exit = 1;    ///< X*
  InletTail tail;     ///< flooded: held during a Newton step, refreshed between steps (see newton_krylov.cpp)
};

/// A correction of the unknowns. P has n + 1 entries, 0 at both ends.
template <class Scalar>
struct StepOf {
  ArrayOf<Scalar> P;
  Scalar offset{0};
  Scalar exit{0};
  ArrayOf<Scalar> product = {};  ///< K P, filled in by Jacobian::apply
  Scalar integral{0};            ///< Int P dphi, filled in by Jacobian::apply
};
using Step = StepOf<double>;

/// Errors of the discrete equations, or changes of them.
template <class Scalar>
struct ResidualOf {
  ArrayOf<Scalar> flux;  ///< F_i - rho_n H_n on the n faces
  Scalar load{0};        ///< Int P dX - pi/2
};
using Residual = ResidualOf<double>;

/// What a step changes.
template <class Scalar>
struct ChangeOf : ResidualOf<Scalar> {
  ArrayOf<Scalar> film;  ///< dH at the n + 1 nodes
};

}  // namespace ehd::fast
