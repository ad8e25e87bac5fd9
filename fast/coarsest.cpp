// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/coarsest.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "fast/jacobian.hpp"
#include "fast/node_fields.hpp"

namespace ehd::fast {

using std::numbers::pi;

/// Columns 0..n-2: P_1..P_(n-1); n-1: H_0; n: X*. Rows 0..n-1: flux errors; n: the load.
struct Coarsest::Matrices {
  RowMajor film;  ///< dH_i, row by row, as Reynolds' equation combines them
  RowMajor all;
  Eigen::RowVectorXd integral;                   ///< of P dphi
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;  ///< of the transpose: Eigen is quicker by columns
  Eigen::VectorXd right_side, solution;

  void make_film(const NodeFields& nodes, const Jacobian& jacobian);
  void make_all(int n, const Jacobian& jacobian);
};

Coarsest::Coarsest() : matrices_(std::make_unique<Matrices>()) {}
Coarsest::~Coarsest() = default;

void Coarsest::Matrices::make_film(const NodeFields& nodes, const Jacobian& jacobian) {
  const int n = nodes.n;
  film.resize(n + 1, n + 1);
  const double scale = -jacobian.length / pi, log_length = std::log(jacobian.length);
  integral = (nodes.grid->slope.segment(1, n - 1) / n).matrix().transpose();
  const RowMajor& kernel = nodes.grid->dense();
  for (int i = 0; i <= n; ++i)
    film.row(i).head(n - 1) = scale * (kernel.row(i).segment(1, n - 1) + log_length * integral);
  film.col(n - 1).setOnes();
  film.col(n) = jacobian.film_by_exit.matrix();
}

void Coarsest::Matrices::make_all(int n, const Jacobian& jacobian) {
  const Jacobian& J = jacobian;
  all.resize(n + 1, n + 1);
  const double at_exit = J.density_at_exit;
  all.row(0) = J.w_mid[0] * film.row(0) + J.w_right[0] * film.row(1) - at_exit * film.row(n);
  for (int i = 0; i < n; ++i) {
    if (i > 0)
      all.row(i) = J.w_left[i] * film.row(i - 1) + J.w_mid[i] * film.row(i) + J.w_right[i] * film.row(i + 1) -
                   at_exit * film.row(n);
    if (i > 1) all(i, i - 2) += J.p_left[i];
    if (i > 0) all(i, i - 1) += J.p_mid[i];
    if (i + 1 < n) all(i, i) += J.p_right[i];
    all(i, n) += J.by_exit[i];
  }
  all.row(n).head(n - 1) = J.length * integral;
  all(n, n - 1) = 0;
  all(n, n) = J.load_by_exit;
}

bool Coarsest::factorise(const NodeFields& nodes, const Jacobian& jacobian) {
  const int n = nodes.n;
  Matrices& m = *matrices_;
  m.make_film(nodes, jacobian);
  m.make_all(n, jacobian);
  m.factors.compute(Eigen::Map<const Eigen::MatrixXd>(m.all.data(), n + 1, n + 1));
  m.right_side.resize(n + 1);
  return m.all.allFinite() && m.factors.matrixLU().diagonal().cwiseAbs().minCoeff() > 0;
}

void Coarsest::solve(const Residual& error, Step& step) {
  Matrices& m = *matrices_;
  const Eigen::Index n = error.flux.size();
  m.right_side.head(n) = error.flux.matrix();
  m.right_side[n] = error.load;
  Eigen::VectorXd& x = m.solution;
  x = m.factors.transpose().solve(m.right_side);
  step.P[0] = step.P[n] = 0;
  step.P.segment(1, n - 1) = x.head(n - 1).array();
  step.offset = x[n - 1];
  step.exit = x[n];
}

}  // namespace ehd::fast
