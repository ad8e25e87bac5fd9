// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/deadline.hpp"

#include <cmath>

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"
#include "workflow/registry.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(deadline)

BOOST_AUTO_TEST_CASE(a_solve_gets_no_more_time_than_is_left) {
  double limit_s = 0;
  const ContactSolver solver = [&](const Problem&, const Request& request) {
    limit_s = request.time_limit_s;
    return Solution();
  };
  (void)Deadline(50).limiting(solver)({}, {.time_limit_s = 300});
  BOOST_TEST(limit_s <= 50);
  BOOST_TEST(limit_s > 40);
  (void)Deadline(50).limiting(solver)({}, {.time_limit_s = 3});
  BOOST_TEST(limit_s == 3);
  (void)Deadline().limiting(solver)({}, {.time_limit_s = 300});
  BOOST_TEST(limit_s == 300);
  BOOST_TEST(std::isinf(Deadline().left_s()));
}

BOOST_AUTO_TEST_CASE(after_the_deadline_nothing_is_solved) {
  int solves = 0;
  const ContactSolver solver = [&](const Problem&, const Request&) {
    ++solves;
    return Solution();
  };
  constexpr double passed_long_ago_s = -1;
  const Solution solution = Deadline(passed_long_ago_s).limiting(solver)({}, {});
  BOOST_TEST(solves == 0);
  BOOST_TEST((solution.record.status == StopReason::limit_reached));
  BOOST_TEST(solution.record.reason == Deadline::not_run);
}

BOOST_AUTO_TEST_CASE(a_reason_tells_time_from_iterations) {
  const Problem problem = nondimensionalise(MoesGroups{.M = 20, .L = 10}, Lubricant{}, Flooded{}).problem;
  for (const RegisteredSolver& solver : solvers()) {
    BOOST_TEST_CONTEXT(solver.name) {
      const Solution late = solver.solve(problem, {.time_limit_s = 1e-9});
      BOOST_TEST((late.record.status == StopReason::limit_reached));
      BOOST_TEST(late.record.reason.find(Deadline::out_of_time) != std::string::npos, late.record.reason);
      const Solution few = solver.solve(problem, {.max_iterations = 1});
      BOOST_TEST((few.record.status == StopReason::limit_reached));
      BOOST_TEST(few.record.reason.find(Deadline::out_of_time) == std::string::npos, few.record.reason);
      if (!solver.respond) continue;
      const Response late_response = solver.respond(problem, {.time_limit_s = 1e-9}),
                     few_response = solver.respond(problem, {.max_iterations = 1});
      BOOST_TEST((late_response.status == StopReason::limit_reached));
      BOOST_TEST(late_response.reason.find(Deadline::out_of_time) != std::string::npos, late_response.reason);
      BOOST_TEST(few_response.reason.find(Deadline::out_of_time) == std::string::npos, few_response.reason);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
