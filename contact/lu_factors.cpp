// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/lu_factors.hpp"

#include <utility>

namespace ehd {

LuFactors::LuFactors(Eigen::MatrixXd matrix) : matrix_(std::move(matrix)), factors_(matrix_) {}

LuFactors::~LuFactors() = default;

Eigen::VectorXd LuFactors::solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

}  // namespace ehd
