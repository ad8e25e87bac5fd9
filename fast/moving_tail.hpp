// SPDX-License-Identifier: GPL-3.0-or-later
// How the far inlet of a flooded contact (inlet_tail.hpp) follows a small motion of the rate s. For x = -X >= x_a
//
//   H_1(x) = H_1(X_a) - (W_1/pi) ln(x/x_a) - (m_1/pi)(1/x - 1/x_a),  F_1(x) = F_1(X_a) + s Int_(x_a)^x H_1 dx',
//   Q_1(x) = lambda Int_x^inf [ (-2/H^3 + 3 C/H^4) H_1 - F_1/H^3 ] dx',  P_1 = Q_1/(1 - a Q):
//
// the derivative of the steady tail, with the oil that the squeeze adds to the flux.
#pragma once

#include <Eigen/Core>

namespace ehd::fast {

class MovingTail {
 public:
  /// H_1(X_a), W_1 = Int P_1 dX, m_1 = Int P_1 X dX, F_1(X_a).
  template <class Scalar>
  using Drive = Eigen::Matrix<Scalar, 4, 1>;
  /// The load beyond X_a; P_1(X_a); the film's change by what is beyond, coefficients of 1, X, …, X^4.
  template <class Scalar>
  using Answer = Eigen::Matrix<Scalar, 7, 1>;

  /// Of the steady tail, whose arguments are those of inlet_tail().
  MovingTail(double far, double gap_excess, double moment, double flux, double lambda, double slope);

  template <class Scalar>
  [[nodiscard]] Answer<Scalar> answer(Scalar rate, const Drive<Scalar>& drive) const {
    return at_rest_.template cast<Scalar>() * drive + rate * (by_rate_.template cast<Scalar>() * drive);
  }

 private:
  Eigen::Matrix<double, 7, 4> at_rest_, by_rate_;
};

}  // namespace ehd::fast
