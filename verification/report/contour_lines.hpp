// SPDX-License-Identifier: GPL-3.0-or-later
// Contour lines of values on a grid.
#pragma once

#include <cstddef>
#include <vector>

#include "verification/report/shapes.hpp"

namespace ehd::report {

/// Lines of the value `level` through values at the nodes (i, j), by marching squares: polylines in the coordinates
/// (i, j). A square with a value that is not finite has no line. `values`: x fastest.
[[nodiscard]] std::vector<std::vector<Point>> contour_lines(const std::vector<double>& values, std::size_t columns,
                                                            std::size_t rows, double level);

}  // namespace ehd::report
