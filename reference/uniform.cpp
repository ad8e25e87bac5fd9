// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/uniform.hpp"

namespace ehd::reference {
Solution Uniform::solve(const Problem&, const Request&) const { return {}; }
}  // namespace ehd::reference
