// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/registry.hpp"

#include <memory>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "contact/interruption.hpp"
#include "contact/nondimensional.hpp"
#include "tests/check.hpp"
#include "workflow/batch.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// A light contact without piezoviscosity: the cheapest.
Problem light_contact() { return nondimensionalise(MoesGroups{2, 0}, Lubricant{}, TruncatedAt{-4}).problem; }
Problem other_contact() { return nondimensionalise(MoesGroups{20, 10}, Lubricant{}, Flooded{}).problem; }

std::vector<const RegisteredSolver*> solvers_with_transforms() {
  std::vector<const RegisteredSolver*> list;
  for (const RegisteredSolver& solver : solvers())
    if (solver.uses_fft) list.push_back(&solver);
  BOOST_REQUIRE_EQUAL(list.size(), 2u);
  return list;
}

/// In a thread of its own, so that nothing is kept from other tests.
template <class Work>
void in_a_new_thread(const Work& work) {
  std::thread(work).join();
}

double planning_s(const Solution& solution) { return solution.record.cost.planning_s; }

}  // namespace

BOOST_AUTO_TEST_SUITE(registry)

BOOST_AUTO_TEST_CASE(every_solver_is_found_by_its_own_name) {
  std::set<std::string> names;
  for (const auto& solver : solvers()) {
    BOOST_TEST(find_solver(solver.name) == &solver);
    names.insert(solver.name);
  }
  BOOST_TEST(names.size() == solvers().size());
  for (const char* name : {"reference", "reference.uniform", "fast", "fast.uniform"}) BOOST_CHECK(find_solver(name));
}

// A sweep tries a row again only where its reason names the time. A dense solver ends before its limit where the next
// grid, eight times as long, would not fit.
BOOST_AUTO_TEST_CASE(a_solve_that_time_ended_says_so_even_where_it_gave_up_before_its_limit) {
  for (const char* solver : {"reference.linear", "reference.uniform"})
    for (const double limit_s : {0.1, 0.3, 0.9}) {
      const Solution solution =
          find_solver(solver)->solve(other_contact(), {.tolerance = 1e-9, .time_limit_s = limit_s});
      BOOST_TEST((solution.record.status == StopReason::limit_reached));
      BOOST_TEST(solution.record.reason.find(time_limit_reason) != std::string::npos, solution.record.reason);
    }
}

BOOST_AUTO_TEST_CASE(the_traits_tell_the_solvers_apart) {
  BOOST_TEST(default_solver().name == "fast");
  BOOST_TEST(certified_solver().name == "reference");
  std::set<int> looks;
  int defaults = 0, certified = 0;
  for (const RegisteredSolver& solver : solvers()) {
    BOOST_TEST(solver.look > 0);
    looks.insert(solver.look);
    defaults += solver.is_default;
    certified += solver.certified;
    BOOST_TEST(solver.dense() == solver.name.starts_with("reference"));
  }
  BOOST_TEST(looks.size() == solvers().size());
  BOOST_TEST(defaults == 1);
  BOOST_TEST(certified == 1);
  const auto twins = solver_twins();
  BOOST_REQUIRE(twins.size() == 1u);
  BOOST_TEST(twins[0].solver->name == "fast.uniform");
  BOOST_REQUIRE(twins[0].twin != nullptr);
  BOOST_TEST(twins[0].twin->name == "reference.uniform");
}

BOOST_AUTO_TEST_CASE(the_solver_that_nobody_names_and_the_certified_one_have_a_response) {
  for (const RegisteredSolver* solver : {&default_solver(), &certified_solver()}) {
    BOOST_REQUIRE(solver->respond);
    const Response found = solver->respond(light_contact(), {.frequencies = {1}, .tolerance = 1e-4});
    BOOST_TEST((found.status == StopReason::converged));
  }
  BOOST_TEST(responsive_solver_names() == "reference, fast");
  for (const RegisteredSolver& solver : solvers()) BOOST_TEST((solver.response_tolerance > 0) == bool(solver.respond));
  BOOST_TEST(certified_solver().response_tolerance < default_solver().response_tolerance);
}

BOOST_AUTO_TEST_CASE(an_unknown_solver_is_absent) {
  BOOST_CHECK(find_solver("") == nullptr);
  BOOST_CHECK(find_solver("Fast") == nullptr);
}

BOOST_AUTO_TEST_CASE(dense_memory_grows_with_the_square_of_the_intervals) {
  const auto& bytes = find_solver("reference")->memory_bytes;
  BOOST_TEST(bytes(2000) == 4 * bytes(1000));
  BOOST_TEST(bytes(1000) >= 8.0 * 1000 * 1000);  // at least one matrix
  BOOST_TEST(available_memory_bytes() > 0);
}

BOOST_AUTO_TEST_CASE(a_thread_plans_once_and_its_later_solves_have_the_same_bits) {
  for (const RegisteredSolver* solver : solvers_with_transforms()) {
    Solution first, again, elsewhere;
    in_a_new_thread([&] {
      first = solver->solve(light_contact(), {.tolerance = 1e-2});
      (void)solver->solve(other_contact(), {.tolerance = 1e-3});
      again = solver->solve(light_contact(), {.tolerance = 1e-2});
    });
    in_a_new_thread([&] { elsewhere = solver->solve(light_contact(), {.tolerance = 1e-2}); });
    BOOST_TEST_CONTEXT(solver->name) {
      BOOST_TEST((first.record.status == StopReason::converged));
      BOOST_TEST(planning_s(first) > 0);
      BOOST_TEST(planning_s(again) == 0);
      BOOST_TEST(planning_s(elsewhere) > 0);
      BOOST_TEST(identical(first, again));
      BOOST_TEST(identical(first, elsewhere));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_large_workspace_is_not_kept) {
  for (const RegisteredSolver* solver : solvers_with_transforms()) {
    in_a_new_thread([&] {
      (void)solver->solve(light_contact(), {.tolerance = {}, .nodes = 16384});
      BOOST_TEST_CONTEXT(solver->name)
      BOOST_TEST(planning_s(solver->solve(light_contact(), {.tolerance = {}, .nodes = 256})) > 0);
    });
  }
}

BOOST_AUTO_TEST_CASE(what_an_exception_leaves_behind_is_thrown_away) {
  Problem throwing = light_contact();
  int calls = 0;
  const auto source = [&calls](const double&) -> std::pair<double, double> {
    if (++calls == 1000) throw std::runtime_error("in the middle of a solve");
    return {0, 0};
  };
  throwing.sources = std::make_shared<const Sources>(Sources{.film = source, .balance = source});
  for (const RegisteredSolver* solver : solvers_with_transforms()) {
    in_a_new_thread([&] {
      calls = 0;
      const Solution before = solver->solve(light_contact(), {.tolerance = 1e-2});
      BOOST_CHECK_THROW((void)solver->solve(throwing, {.tolerance = 1e-2}), std::runtime_error);
      const Solution after = solver->solve(light_contact(), {.tolerance = 1e-2});
      BOOST_TEST_CONTEXT(solver->name) {
        BOOST_TEST(identical(before, after));
        BOOST_TEST(planning_s(after) > 0);
      }
    });
  }
}

BOOST_AUTO_TEST_CASE(every_response_tells_how_many_frequencies_and_waves_are_done) {
  int solvers_seen = 0;
  for (const RegisteredSolver& solver : solvers()) {
    if (!solver.respond) continue;
    ++solvers_seen;
    std::vector<std::size_t> told;
    ResponseRequest request{.frequencies = {2, 1}, .waviness = {{.wavelength = 1}}, .tolerance = 1e-2};
    request.progress = [&](std::size_t done, std::size_t all) {
      BOOST_TEST(all == 3u);
      told.push_back(done);
    };
    (void)solver.respond(light_contact(), request);
    BOOST_TEST_CONTEXT(solver.name) { BOOST_TEST(told == std::vector<std::size_t>({0, 1, 2, 3})); }
  }
  BOOST_TEST(solvers_seen == 2);
}

BOOST_AUTO_TEST_CASE(each_solver_declares_how_it_works_and_its_order) {
  for (const auto& solver : solvers()) {
    BOOST_TEST(!solver.description.method.empty());
    BOOST_TEST(solver.description.formal_order > 0);
    BOOST_TEST(solver.description.work_exponent > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
