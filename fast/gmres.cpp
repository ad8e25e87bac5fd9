// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/gmres.hpp"

#include <cmath>

namespace ehd::fast {

using Eigen::numext::conj;

template <class Scalar>
std::span<const Scalar> GmresOf<Scalar>::solve(const Vector& b, double relative, const Product& product) {
  v_.resize(most_steps + 1);
  h_.resize(most_steps);
  rotations_.resize(most_steps);
  g_.assign(most_steps + 1, 0);
  y_.resize(most_steps);

  const double beta = b.matrix().norm();
  v_[0] = b / beta;
  g_[0] = beta;
  std::size_t k = 0;
  while (k < most_steps) {
    product(k, v_[k], v_[k + 1]);
    orthogonalise(k);
    ++k;
    if (!(std::abs(g_[k]) > relative * beta)) break;  // |g_k| = |b - A x_k|
  }
  return back_substitution(k);
}

/// Arnoldi's step by modified Gram-Schmidt, w = v_(k+1), then the rotations that keep h upper triangular.
template <class Scalar>
void GmresOf<Scalar>::orthogonalise(std::size_t k) {
  std::vector<Scalar>& h = h_[k];
  h.resize(k + 1);
  Vector& w = v_[k + 1];
  for (std::size_t i = 0; i <= k; ++i) {
    h[i] = v_[i].matrix().dot(w.matrix());
    w -= h[i] * v_[i];
  }
  const double below = w.matrix().norm();  // h_(k+1,k)
  if (below > 0) w /= below;

  for (std::size_t i = 0; i < k; ++i) {
    const auto& [c, s] = rotations_[i];
    const Scalar upper = h[i], lower = h[i + 1];
    h[i] = conj(c) * upper + s * lower;
    h[i + 1] = -s * upper + c * lower;
  }
  const double length = std::hypot(std::abs(h[k]), below);
  const Rotation last{.cosine = h[k] / length, .sine = below / length};
  h[k] = length;
  g_[k + 1] = -last.sine * g_[k];
  g_[k] *= conj(last.cosine);
  rotations_[k] = last;
}

template <class Scalar>
std::span<const Scalar> GmresOf<Scalar>::back_substitution(std::size_t steps) {
  for (std::size_t i = steps; i-- > 0;) {
    Scalar rest = g_[i];
    for (std::size_t j = i + 1; j < steps; ++j) rest -= h_[j][i] * y_[j];
    y_[i] = rest / h_[i][i];
  }
  return std::span(y_).first(steps);
}

template class GmresOf<double>;
template class GmresOf<Complex>;

}  // namespace ehd::fast
