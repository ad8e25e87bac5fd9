// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/coarsest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fast/jacobian.hpp"
#include "fast/node_fields.hpp"
#include "fast/squeeze.hpp"
#include "fast/vectorise.hpp"

namespace ehd::fast {

using std::numbers::pi;

/// Columns 0..n-2: P_1..P_(n-1); n-1: H_0; n: X*. Rows 0..n-1: flux errors; n: the load. The film is not formed: a row
/// is a sum of three rows of the kernel, of the kernel's last row (the flux at the exit) and of the integral.
template <class Scalar>
bool CoarsestOf<Scalar>::factorise(const NodeFields& nodes, const Jacobian& jacobian, const Squeeze* squeeze,
                                   Scalar rate) {
  const Jacobian& J = jacobian;
  const int n = nodes.n;
  const RowMajor& dense = nodes.grid->dense();
  const auto kernel = [&](int i) { return &dense(i, 1); };
  const double scale = -J.length / pi, at_exit = J.density_at_exit;
  const Array& by_exit = J.film_by_exit;
  integral_ = nodes.grid->slope.segment(1, n - 1) / n;
  scaled_integral_ = scale * std::log(J.length) * integral_;
  exit_kernel_ = scale * at_exit * dense.row(n).segment(1, n - 1).transpose().array();
  const double *const with_log = scaled_integral_.data(), *const exit_kernel = exit_kernel_.data();

  lu_.resize(n + 1);
  for (int i = 0; i < n; ++i) {
    Scalar* const row = lu_.row(i);
    const int before = std::max(i - 1, 0);  // w_left of the first face is 0
    const double left = scale * J.w_left[i], mid = scale * J.w_mid[i], right = scale * J.w_right[i];
    const double together = J.w_left[i] + J.w_mid[i] + J.w_right[i] - at_exit;
    const double *const k_left = kernel(before), *const k_mid = kernel(i), *const k_right = kernel(i + 1);
    EHD_VECTORISE
    for (int j = 0; j < n - 1; ++j)
      row[j] = left * k_left[j] + mid * k_mid[j] + right * k_right[j] + together * with_log[j] - exit_kernel[j];
    row[n - 1] = together;
    row[n] = J.w_left[i] * by_exit[before] + J.w_mid[i] * by_exit[i] + J.w_right[i] * by_exit[i + 1] -
             at_exit * by_exit[n] + J.by_exit[i];
    if (i > 1) row[i - 2] += J.p_left[i];
    if (i > 0) row[i - 1] += J.p_mid[i];
    if (i + 1 < n) row[i] += J.p_right[i];
  }
  Scalar* const load = lu_.row(n);
  Eigen::Map<ArrayOf<Scalar>>(load, n - 1) = (J.length * integral_).template cast<Scalar>();
  load[n - 1] = 0;
  load[n] = J.load_by_exit;
  if (squeeze) subtract_squeeze(nodes, jacobian, *squeeze, rate);
  return lu_.factorise();
}

/// Q of a face is Q of the next face plus the oil at the node between them.
template <class Scalar>
void CoarsestOf<Scalar>::subtract_squeeze(const NodeFields& nodes, const Jacobian& jacobian, const Squeeze& squeeze,
                                          Scalar rate) {
  const int n = nodes.n;
  const RowMajor& dense = nodes.grid->dense();
  const double scale = -jacobian.length / pi;
  mass_.setZero(n - 1);
  double by_offset = 0, by_exit = 0;
  for (int i = n - 1; i >= 0; --i) {
    const int node = i + 1;
    const double film = squeeze.by_film[node];
    mass_ += film * (scale * dense.row(node).segment(1, n - 1).transpose().array() + scaled_integral_);
    if (node < n) mass_[node - 1] += squeeze.by_pressure[node];
    by_offset += film;
    by_exit += film * jacobian.film_by_exit[node];
    Scalar* const row = lu_.row(i);
    for (int j = 0; j < n - 1; ++j) row[j] -= rate * mass_[j];
    row[n - 1] -= rate * by_offset;
    row[n] -= rate * (by_exit + squeeze.by_exit[i]);
  }
}

template <class Scalar>
void CoarsestOf<Scalar>::solve(const ResidualOf<Scalar>& error, StepOf<Scalar>& step) {
  const Eigen::Index n = error.flux.size();
  solution_.resize(n + 1);
  solution_.head(n) = error.flux;
  solution_[n] = error.load;
  lu_.solve(solution_);
  step.P[0] = step.P[n] = 0;
  step.P.segment(1, n - 1) = solution_.head(n - 1);
  step.offset = solution_[n - 1];
  step.exit = solution_[n];
}

template class CoarsestOf<double>;
template class CoarsestOf<Complex>;

}  // namespace ehd::fast
