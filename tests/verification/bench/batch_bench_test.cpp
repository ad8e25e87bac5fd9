// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/batch_bench.hpp"

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/tables.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

RegisteredSolver made_solver(const std::function<double()>& offset) {
  RegisteredSolver solver = *find_solver("fast");
  solver.name = "made";
  solver.solve = [offset](const Problem&, const Request&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    Solution solution;
    solution.record.status = StopReason::converged;
    solution.fields.offset = offset();
    return solution;
  };
  return solver;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bench_batch_bench)

BOOST_AUTO_TEST_CASE(two_threads_that_wait_are_twice_as_quick) {
  const RegisteredSolver solver = made_solver([] { return 1.0; });
  const auto rows = run_batch({.solvers = {&solver}, .problems = batch_problems(true)});
  BOOST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(rows[0].speed_up == 1);
  BOOST_TEST(rows[0].converged == batch_problems(true).size());
  BOOST_TEST(rows[0].wall_s.size() == 3u);
  EHD_CHECK(error(rows[1].speed_up, 2), Tolerance::calibrated(0.4, "sleeps of 5 ms on a loaded machine"));
  BOOST_TEST(rows[1].same_results);
  BOOST_TEST(to_json(rows)[1]["threads"] == 2);
}

BOOST_AUTO_TEST_CASE(results_that_differ_are_told) {
  std::atomic<int> calls = 0;
  const RegisteredSolver solver = made_solver([&] { return static_cast<double>(++calls); });
  const auto rows = run_batch({.solvers = {&solver}, .problems = batch_problems(true), .rounds = 1});
  BOOST_TEST(!rows[1].same_results);
  BOOST_TEST(human_table(rows).find("DIFFER") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_batch_holds_both_law_sets_and_both_inlets) {
  int roelands = 0, flooded = 0;
  const auto problems = batch_problems(false);
  for (const Problem& one : problems) {
    roelands += std::holds_alternative<Roelands>(one.viscosity) ? 1 : 0;
    flooded += std::holds_alternative<Flooded>(one.inlet) ? 1 : 0;
  }
  BOOST_TEST(problems.size() >= 40u);
  BOOST_TEST(2 * static_cast<std::size_t>(roelands) == problems.size());
  BOOST_TEST(2 * static_cast<std::size_t>(flooded) == problems.size());
}

BOOST_AUTO_TEST_SUITE_END()
