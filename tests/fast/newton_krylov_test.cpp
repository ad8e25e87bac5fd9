// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/newton_krylov.hpp"

#include "fast/mapped.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(newton_krylov)

// Narrow spikes: while one moves, single nodes change by more than p_H.
BOOST_AUTO_TEST_CASE(long_steps_save_newton_steps) {
  long steps = 0;
  for (const MoesGroups& moes : {MoesGroups{908.89, 8.0998}, {59.843, 17.35}, {1234.6, 7.5961}}) {
    const Problem problem = barus_problem(moes.M, moes.L, Flooded{});
    const Solution solution = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = 512});
    BOOST_REQUIRE(solution.record.status == StopReason::converged);
    steps += solution.record.cost.newton_iterations;
  }
  EHD_CHECK(static_cast<double>(steps),
            Tolerance::calibrated(325, "half way between 273, pressure changes up to 1.5, and 377, up to 0.5"));
}

BOOST_AUTO_TEST_SUITE_END()
