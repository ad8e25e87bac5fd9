// SPDX-License-Identifier: GPL-3.0-or-later
// The one array type that fields are kept in.
#pragma once

#include <Eigen/Core>

namespace ehd {

/// A field on the nodes (or faces) of a grid; element-wise arithmetic.
template <class Scalar>
using ArrayOf = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
using Array = ArrayOf<double>;

}  // namespace ehd
