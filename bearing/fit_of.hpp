// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ehd::bearing {

/// Whose squares the straight-line fit minimises: those of the forces (f on delta), or those of the approaches (delta
/// on f). The second line is at least as steep.
enum class FitOf { force, approach };

}  // namespace ehd::bearing
