// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/uniform.hpp"

namespace ehd::fast {
Solution Uniform::solve(const Problem&, const Request&) const { return {}; }
}  // namespace ehd::fast
