// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder as results.json has it: rungs 0 to rungs - 1, with their names in the file itself.
#pragma once

namespace ehd::report {

inline constexpr int rungs = 12;

}  // namespace ehd::report
