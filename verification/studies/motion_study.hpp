// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of both discrete harmonic operators against a manufactured motion, grid by grid, about the discrete steady
// state of the same grid. Rung 5 fits orders to them.
#pragma once

#include <limits>
#include <utility>

#include "verification/exact/manufactured_motion.hpp"

namespace ehd::verification {

/// Absolute, of complex amplitudes. Pressure: of points that move with the exit, the largest over the nodes
/// (collocation: over 21 points of each element). NaN where the steady solve or the motion was not found.
struct MotionErrors {
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  double pressure = nothing, offset = nothing, exit = nothing;
};
inline constexpr std::pair<const char*, double MotionErrors::*> motion_quantities[] = {
    {"pressure", &MotionErrors::pressure}, {"offset", &MotionErrors::offset}, {"exit", &MotionErrors::exit}};

inline constexpr int motion_elements[] = {32, 48, 72, 108};  ///< of one degree

/// fast/harmonic.hpp on the mapped grid of `fast`.
[[nodiscard]] MotionErrors motion_errors_of_fast(const exact::ManufacturedMotion& truth, int intervals);
/// reference/hp/harmonic.hpp on `elements` equal elements.
[[nodiscard]] MotionErrors motion_errors_of_collocation(const exact::ManufacturedMotion& truth, int elements,
                                                        int degree);

}  // namespace ehd::verification
