// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_cache.hpp"

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/check.hpp"
#include "workflow/parallel.hpp"

using namespace ehd;

namespace {

const Problem one{.groups = {.M = 20, .L = 10, .lambda = 0.01, .alpha_p_H = 18},
                  .viscosity = Roelands{.alpha = 18, .p0 = 0.2, .z = 0.6},
                  .density = DowsonHigginson{.a = 0.5, .c = 1.5},
                  .inlet = TruncatedAt{-4}};

/// Problems that differ from `one` and from each other in one number or law.
std::vector<Problem> different_problems() {
  std::vector<Problem> different(14, one);
  different[1].groups.M = 21;
  different[2].groups.L = 11;
  different[3].groups.lambda = 0.02;
  different[4].groups.alpha_p_H = 19;
  different[5].viscosity = Roelands{.alpha = 19, .p0 = 0.2, .z = 0.6};
  different[6].viscosity = Roelands{.alpha = 18, .p0 = 0.3, .z = 0.6};
  different[7].viscosity = Roelands{.alpha = 18, .p0 = 0.2, .z = 0.7};
  different[8].viscosity = Barus{.alpha = 18};
  different[9].viscosity = Isoviscous{};
  different[10].density = Incompressible{};
  different[11].density = DowsonHigginson{.a = 0.5, .c = 1.6};
  different[12].inlet = Flooded{};
  different[13].wanted = {Quantity::film_minimum};
  return different;
}

/// Numbers its solves: the film says which solve it is from.
struct CountingSolver {
  std::shared_ptr<std::atomic<int>> calls = std::make_shared<std::atomic<int>>(0);
  Solution operator()(const Problem&, const Request&) const {
    Solution solution;
    solution.observables[Quantity::film_minimum].value = ++*calls;
    return solution;
  }
};

int film(ContactCache& cache, const Problem& problem, const Request& request = {}) {
  return static_cast<int>(cache.solve(problem, request).observables.at(Quantity::film_minimum).value);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(contact_cache)

BOOST_AUTO_TEST_CASE(only_equal_problems_share_a_solution) {
  const std::vector<Problem> different = different_problems();
  ContactCache cache{CountingSolver()}, forgetful{CountingSolver(), 3};
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < different.size(); ++i) BOOST_TEST(film(cache, different[i]) == static_cast<int>(i) + 1);
  BOOST_TEST(cache.solves() == 14);
  BOOST_TEST(cache.recalls() == 14);
  // A full cache solves further contacts again.
  for (int round = 0; round < 2; ++round)
    for (const Problem& of : different) (void)film(forgetful, of);
  BOOST_TEST(forgetful.solves() == 14 + 11);
}

BOOST_AUTO_TEST_CASE(only_equal_requests_share_a_solution) {
  const std::vector<Request> different{{},
                                       {.tolerance = 1e-4},
                                       {.tolerance = {std::nullopt, 1e-4}},
                                       {.tolerance = {1e-4, std::nullopt}},
                                       {.tolerance = {}, .nodes = 64},
                                       {.tolerance = {}, .nodes = 128},
                                       {.tolerance = {}, .nodes = 128, .iteration_share = 0.1},
                                       {.max_iterations = 100},
                                       {.time_limit_s = 10}};
  ContactCache cache{CountingSolver()};
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < different.size(); ++i)
      BOOST_TEST(film(cache, one, different[i]) == static_cast<int>(i) + 1);
  BOOST_TEST(cache.recalls() == static_cast<long>(different.size()));
}

BOOST_AUTO_TEST_CASE(a_manufactured_problem_is_solved_each_time) {
  Problem manufactured = one;
  manufactured.sources = std::make_shared<const Sources>();
  ContactCache cache{CountingSolver()};
  BOOST_TEST(film(cache, one) == 1);
  BOOST_TEST(film(cache, manufactured) == 2);
  BOOST_TEST(film(cache, manufactured) == 3);
  BOOST_TEST(cache.recalls() == 0);
}

BOOST_AUTO_TEST_CASE(threads_that_ask_for_one_contact_wait_for_one_solve) {
  const CountingSolver counting;
  ContactCache cache([&counting](const Problem& problem, const Request& request) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return counting(problem, request);
  });
  std::vector<int> films(8);
  in_threads(films.size(), 4, [&](std::size_t i) { films[i] = film(cache, one); });
  for (const int each : films) BOOST_TEST(each == 1);
  BOOST_TEST(cache.solves() == 1);
  BOOST_TEST(cache.recalls() == 7);
}

BOOST_AUTO_TEST_CASE(what_a_solver_throws_is_thrown_again) {
  ContactCache cache([](const Problem&, const Request&) -> Solution { throw std::runtime_error("a bug"); });
  for (int round = 0; round < 2; ++round) BOOST_CHECK_THROW((void)cache.solve(one, {}), std::runtime_error);
  BOOST_TEST(cache.solves() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
