// SPDX-License-Identifier: GPL-3.0-or-later
// The linearised equations at one iterate, in coefficients:
//
//   dF_i = Sum_(j = i-2..i+2) p_ij dP_j + Sum_(j = i-1..i+1) w_ij dH_j + x_i dX*
//   dH_i = dH_0 + h_i dX* - (l/pi) (Sum_j K_ij dP_j + ln l Int dP dphi)
//   change of flux error i = dF_i - rho_n dH_n;  change of the load = l Int dP dphi + (Int P dphi) dX*
#pragma once

#include <tuple>

#include "contact/array.hpp"
#include "fast/carried_density.hpp"
#include "fast/state.hpp"

namespace ehd::fast {

struct Counters;
struct Grid;
struct NodeFields;
enum class Accuracy;

/// Here by_x means "derivative by x". Storage is used again; one thread at a time.
class Jacobian {
 public:
  // Faces, n entries: p_i,i-1, p_i,i, p_i,i+1; w likewise; x_i.
  Array p_left, p_mid, p_right, w_left, w_mid, w_right, by_exit;
  /// p_i,i-2 and p_i,i+2: from the carried density alone, empty where that uses no neighbours. Preconditioners omit
  /// them.
  Array p_far_left, p_far_right;
  Array film_by_exit;          ///< h_i, at fixed P; n + 1 entries
  double load_by_exit = 0;     ///< Int P dphi
  double density_at_exit = 0;  ///< rho_n
  double length = 0;           ///< l

  /// All coefficients, at the fields `nodes` of the pressure P and the exit X*.
  void linearise(const Setting& setting, const NodeFields& nodes, const Array& P, double exit);
  /// J step: what the step changes in the residual. Costs one kernel product, which is kept in step.product and
  /// step.integral. The result is valid until the next call.
  [[nodiscard]] const Residual& apply(Step& step, Counters& counters) const;
  /// apply() in two parts, for real and complex steps (a complex step costs two products). First the change of the film
  /// by the step, then the change of the residual by both.
  template <class Scalar>
  [[nodiscard]] ChangeOf<Scalar>& change_film(StepOf<Scalar>& step, Counters& counters, Accuracy accuracy) const;
  template <class Scalar>
  void change_residual(const StepOf<Scalar>& step, ChangeOf<Scalar>& change) const;

 private:
  void linearise_poiseuille(const Setting& setting, const NodeFields& nodes, const Array& P);
  void linearise_wedge(const Setting& setting, const NodeFields& nodes, const Array& P);
  void add_neighbours(const NodeFields& nodes);
  void linearise_exit(const Setting& setting, const NodeFields& nodes, double exit);

  int n_ = 0;
  Grid* grid_ = nullptr;
  CarriedDensity carried_;
  mutable std::tuple<ChangeOf<double>, ChangeOf<Complex>> change_;
};

}  // namespace ehd::fast
