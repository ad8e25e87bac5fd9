// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/registry.hpp"

#include <set>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

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

BOOST_AUTO_TEST_CASE(each_solver_declares_how_it_works_and_its_order) {
  for (const auto& solver : solvers()) {
    BOOST_TEST(!solver.description.method.empty());
    BOOST_TEST(solver.description.formal_order > 0);
    BOOST_TEST(solver.description.work_exponent > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
