// SPDX-License-Identifier: GPL-3.0-or-later
// LU with row exchanges of a large dense matrix: Eigen's, compiled once. Each file that instantiates it takes some
// seconds longer to compile.
#pragma once

#include <Eigen/LU>

namespace ehd {

class LuFactors {
 public:
  /// A square matrix, which is overwritten.
  explicit LuFactors(Eigen::MatrixXd matrix);
  LuFactors(const LuFactors&) = delete;
  LuFactors& operator=(const LuFactors&) = delete;
  LuFactors(LuFactors&&) = delete;
  LuFactors& operator=(LuFactors&&) = delete;
  ~LuFactors();

  /// x of A x = b; b has as many entries as A has rows. Not finite where A is singular.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factors_;  ///< in the place of the matrix
};

}  // namespace ehd
