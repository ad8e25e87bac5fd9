// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/solver_lists.hpp"

#include <algorithm>

namespace ehd::verification {

bool on_equal_cells(const RegisteredSolver& solver) {
  const auto pairs = solver_twins();
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const SolverTwins& pair) { return pair.solver == &solver || pair.twin == &solver; });
}

std::vector<const RegisteredSolver*> second_order_solvers() {
  std::vector<const RegisteredSolver*> list;
  for (const bool dense : {true, false})
    for (const bool equal_cells : {true, false})
      for (const RegisteredSolver& solver : solvers())
        if (!solver.certified && solver.dense() == dense && on_equal_cells(solver) == equal_cells)
          list.push_back(&solver);
  return list;
}

}  // namespace ehd::verification
