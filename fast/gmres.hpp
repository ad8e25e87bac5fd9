// SPDX-License-Identifier: GPL-3.0-or-later
// Flexible GMRES with right preconditioning: Y. Saad, Iterative Methods for Sparse Linear Systems, 2nd ed. 2003,
// algorithm 9.6 (with the Givens rotations of section 6.5.3).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "contact/array.hpp"
#include "fast/scalar.hpp"

namespace ehd::fast {

/// Solves A x = b, real or complex. Storage is used again by the next solve; one thread at a time.
template <class Scalar>
class GmresOf {
 public:
  using Vector = ArrayOf<Scalar>;
  static constexpr std::size_t most_steps = 40;
  /// w = A z_k with z_k = M^-1 v; the caller keeps z_k, k = 0, 1, … `w` may hold anything before.
  using Product = std::function<void(std::size_t k, const Vector& v, Vector& w)>;

  /// Starts from x = 0 and ends at |b - A x| <= relative |b|, or after most_steps. Returns the y_k of the solution
  /// x = Sum_k y_k z_k; valid until the next call.
  [[nodiscard]] std::span<const Scalar> solve(const Vector& b, double relative, const Product& product);

 private:
  void orthogonalise(std::size_t k);
  [[nodiscard]] std::span<const Scalar> back_substitution(std::size_t steps);

  struct Rotation {
    Scalar cosine;
    double sine;
  };
  std::vector<Vector> v_;               ///< orthonormal basis of the Krylov space
  std::vector<std::vector<Scalar>> h_;  ///< Hessenberg matrix, column by column, made upper triangular
  std::vector<Rotation> rotations_;     ///< the rotations that make h_ upper triangular
  std::vector<Scalar> g_, y_;           ///< the rotated right side, and the solution of the triangular system
};
using Gmres = GmresOf<double>;

}  // namespace ehd::fast
