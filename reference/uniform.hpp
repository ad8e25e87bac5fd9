// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solver.hpp"

namespace ehd::reference {

class Uniform {
 public:
  static constexpr SolverDescription description{.name = "reference.uniform", .method = "", .cite = "", .formal_order = 2, .work_exponent = 1};
  [[nodiscard]] Solution solve(const Problem& problem, const Request& request) const;
};

}  // namespace ehd::reference
