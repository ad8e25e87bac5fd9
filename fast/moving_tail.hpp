// SPDX-License-Identifier: GPL-3.0-or-later
// How the far inlet of a flooded contact (inlet_tail.hpp) follows a small motion of the rate s. For x = -X >= x_a
//
//   H_1(x) = H_1(X_a) - (W_1/pi) ln(x/x_a) - (m_1/pi)(1/x - 1/x_a),  F_1(x) = F_1(X_a) + s Int_(x_a)^x H_1 dx',
//   Q_1(x) = lambda Int_x^inf [ (-2/H^3 + 3 C/H^4) H_1 - F_1/H^3 ] dx',  P_1 = Q_1/(1 - a Q):
//
// This is the derivative of the steady tail; the squeeze adds oil to the flux. A waviness R_1 = e^(ikx) that moves with
// the slip S adds R_1 to H_1. To F_1 it adds S R_1 and a part that does not depend on x (Harmonic::beyond).
#pragma once

#include <Eigen/Core>
#include <complex>

#include "contact/response.hpp"
#include "fast/tail_rule.hpp"

namespace ehd::fast {

class MovingTail {
 public:
  /// H_1(X_a), W_1 = Int P_1 dX, m_1 = Int P_1 X dX, F_1(X_a).
  template <class Scalar>
  using Drive = Eigen::Matrix<Scalar, 4, 1>;
  /// The load beyond X_a; P_1(X_a); the change of the film that this load makes, coefficients of 1, X, …, X^4.
  template <class Scalar>
  using Answer = Eigen::Matrix<Scalar, 7, 1>;

  /// About the steady tail; arguments as of inlet_tail().
  MovingTail(double far, double gap_excess, double moment, double flux, double lambda, double slope);

  template <class Scalar>
  [[nodiscard]] Answer<Scalar> answer(Scalar rate, const Drive<Scalar>& drive) const {
    return at_rest_.template cast<Scalar>() * drive + rate * (by_rate_.template cast<Scalar>() * drive);
  }
  /// The answer to a waviness, without the part of F_1 that does not depend on x.
  [[nodiscard]] Answer<std::complex<double>> answer(const Waviness& waviness) const;

 private:
  static constexpr int points = TailRule::points;
  using Points = Eigen::Array<double, points, 1>;

  /// The answers to Q_1, given at the points of the rule and at X_a. Each column is one Q_1.
  template <class Scalar, int columns>
  [[nodiscard]] Eigen::Matrix<Scalar, 7, columns> answers(
      const Eigen::Matrix<Scalar, points, columns>& reduced,
      const Eigen::Matrix<Scalar, 1, columns>& reduced_at_edge) const;

  Points x_, dx_, by_reduced_;  ///< x, dx/dt, dP/dQ
  Eigen::Matrix<double, 7, 4> at_rest_, by_rate_;
  double far_, gap_excess_, moment_, flux_, lambda_, by_reduced_at_edge_;
};

}  // namespace ehd::fast
