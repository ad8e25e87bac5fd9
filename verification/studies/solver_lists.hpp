// SPDX-License-Identifier: GPL-3.0-or-later
// Solvers by kind, for studies, figures and stress tests that go over several of them.
#pragma once

#include <vector>

#include "workflow/registry.hpp"

namespace ehd::verification {

/// One of a pair of twins: the classical grid of equal cells.
[[nodiscard]] bool on_equal_cells(const RegisteredSolver& solver);

/// Every solver but the certified one: dense ones first, and of each kind those on equal cells before others.
[[nodiscard]] std::vector<const RegisteredSolver*> second_order_solvers();

}  // namespace ehd::verification
