// SPDX-License-Identifier: GPL-3.0-or-later
// A time for people to read.
#pragma once

#include <string>

namespace ehd {

/// "45 s", "3.1 min", "2 h"
[[nodiscard]] std::string duration(double seconds);

}  // namespace ehd
