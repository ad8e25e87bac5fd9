// SPDX-License-Identifier: GPL-3.0-or-later
// Times for people to read.
#pragma once

#include <string>

namespace ehd {

/// "45 s", "3.1 min", "2 h"
[[nodiscard]] std::string duration(double seconds);
/// Of one computation: "0.31 ms", "2.4 s".
[[nodiscard]] std::string computing_time(double seconds, int digits = 3);
/// The number alone, for a column in ms: "0.31".
[[nodiscard]] std::string milliseconds(double seconds, int digits = 3);

}  // namespace ehd
