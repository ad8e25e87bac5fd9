// SPDX-License-Identifier: GPL-3.0-or-later
// The linearised equations of the coarsest grid as a dense matrix, with its factors.
#pragma once

#include <memory>

namespace ehd::fast {

struct NodeFields;
struct Residual;
struct Step;
class Jacobian;

/// Storage is used again by the next matrix.
class Coarsest {
 public:
  Coarsest();
  ~Coarsest();

  /// Builds and factorises the matrix. False where it is singular.
  [[nodiscard]] bool factorise(const NodeFields& nodes, const Jacobian& jacobian);
  /// step = J^-1 error.
  void solve(const Residual& error, Step& step);

 private:
  struct Matrices;
  std::unique_ptr<Matrices> matrices_;
};

}  // namespace ehd::fast
