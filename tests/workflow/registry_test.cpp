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
