// SPDX-License-Identifier: GPL-3.0-or-later
// Flexible GMRES with right preconditioning: Y. Saad, Iterative Methods for Sparse Linear Systems, 2nd ed. 2003,
// algorithm 9.6 (with the Givens rotations of section 6.5.3).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "contact/array.hpp"

namespace ehd::fast {

/// Solves A x = b. Storage is used again by the next solve; one thread at a time.
class Gmres {
 public:
  static constexpr std::size_t most_steps = 40;
  /// w = A z_k with z_k = M^-1 v; the caller keeps z_k, k = 0, 1, … `w` may hold anything before.
  using Product = std::function<void(std::size_t k, const Array& v, Array& w)>;

  /// From x = 0 until |b - A x| <= relative |b|, or most_steps. The y_k of the solution x = Sum_k y_k z_k; valid until
  /// the next call.
  [[nodiscard]] std::span<const double> solve(const Array& b, double relative, const Product& product);

 private:
  void orthogonalise(std::size_t k);
  [[nodiscard]] std::span<const double> back_substitution(std::size_t steps);

  struct Rotation {
    double cosine, sine;
  };
  std::vector<Array> v_;                ///< orthonormal basis of the Krylov space
  std::vector<std::vector<double>> h_;  ///< Hessenberg matrix, column by column, made upper triangular
  std::vector<Rotation> rotations_;     ///< that made it so
  std::vector<double> g_, y_;           ///< the rotated right side, and the solution of the triangular system
};

}  // namespace ehd::fast
