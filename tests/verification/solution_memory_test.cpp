// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/solution_memory.hpp"

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"

namespace ehd::verification {

namespace {

/// A solver that counts its calls.
struct Counting {
  long calls = 0;
  StopReason status = StopReason::converged;

  [[nodiscard]] RegisteredSolver solver() {
    RegisteredSolver counting = *find_solver("fast");
    counting.solve = [this](const Problem&, const Request&) {
      Solution solution;
      ++calls;
      solution.record.status = status;
      solution.fields.X = Array::Zero(1000);
      return solution;
    };
    return counting;
  }
};

Problem some_problem() {
  return nondimensionalise(MoesGroups{.M = 20, .L = 10}, Lubricant{.alpha_per_Pa = {}, .z = {}}, Flooded{}).problem;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(solution_memory)

BOOST_AUTO_TEST_CASE(the_same_problem_and_request_are_solved_once) {
  Counting counting;
  SolutionMemory memory(1e9);
  const RegisteredSolver solver = counting.solver();
  const Solution first = memory.solve(solver, some_problem(), {}), again = memory.solve(solver, some_problem(), {});
  BOOST_TEST(counting.calls == 1);
  BOOST_TEST(memory.recalls() == 1);
  BOOST_TEST(again.fields.X.size() == first.fields.X.size());
  memory.forget();
  (void)memory.solve(solver, some_problem(), {});
  BOOST_TEST(counting.calls == 2);
}

BOOST_AUTO_TEST_CASE(every_part_of_problem_and_request_is_part_of_the_key) {
  std::vector<std::pair<Problem, Request>> different{{some_problem(), {}}};
  const auto add_problem = [&](auto change) { change(different.emplace_back(some_problem(), Request{}).first); };
  const auto add_request = [&](auto change) { change(different.emplace_back(some_problem(), Request{}).second); };
  add_problem([](Problem& p) { p.groups.M *= 1.5; });
  add_problem([](Problem& p) { p.groups.L *= 1.5; });
  add_problem([](Problem& p) { p.groups.lambda *= 1.5; });
  add_problem([](Problem& p) { p.groups.alpha_p_H *= 1.5; });
  add_problem([](Problem& p) { p.viscosity = Isoviscous{}; });
  add_problem([](Problem& p) { p.viscosity = Barus{.alpha = 1.9}; });
  add_problem([](Problem& p) { p.density = DowsonHigginson{.a = 0.3, .c = 0.8}; });
  add_problem([](Problem& p) { p.inlet = TruncatedAt{-4}; });
  add_problem([](Problem& p) { p.inlet = TruncatedAt{-5}; });
  add_problem([](Problem& p) { p.wanted = {Quantity::film_minimum}; });
  add_request([](Request& r) { r.tolerance = 1e-4; });
  add_request([](Request& r) { r.tolerance = {}; });
  add_request([](Request& r) { r.nodes = 128; });
  add_request([](Request& r) { r.iteration_share = 0.1; });
  add_request([](Request& r) { r.max_iterations = 7; });
  add_request([](Request& r) { r.time_limit_s = 1; });
  Counting counting;
  SolutionMemory memory(1e9);
  RegisteredSolver solver = counting.solver();
  for (const auto& [problem, request] : different) (void)memory.solve(solver, problem, request);
  solver.name = "another";
  (void)memory.solve(solver, some_problem(), {});
  BOOST_TEST(counting.calls == static_cast<long>(different.size()) + 1);
  BOOST_TEST(memory.recalls() == 0);
}

BOOST_AUTO_TEST_CASE(limits_sources_and_a_full_memory_are_not_kept) {
  Counting counting;
  SolutionMemory memory(1e9), full(100);
  const RegisteredSolver solver = counting.solver();
  for (int i = 0; i < 2; ++i) (void)full.solve(solver, some_problem(), {});
  Problem with_sources = some_problem();
  with_sources.sources = std::make_shared<Sources>();
  for (int i = 0; i < 2; ++i) (void)memory.solve(solver, with_sources, {});
  counting.status = StopReason::limit_reached;
  for (int i = 0; i < 2; ++i) (void)memory.solve(solver, some_problem(), {});
  BOOST_TEST(counting.calls == 6);
  BOOST_TEST(full.recalls() + memory.recalls() == 0);
}

BOOST_AUTO_TEST_CASE(the_remembered_solvers_are_those_of_the_registry) {
  for (const RegisteredSolver& solver : solvers()) BOOST_TEST(remembered(solver.name).name == solver.name);
  BOOST_CHECK_THROW((void)remembered("no solver"), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
