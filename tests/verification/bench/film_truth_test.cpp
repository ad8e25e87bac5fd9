// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/film_truth.hpp"

#include <string>
#include <vector>

#include "contact/text.hpp"
#include "tests/check.hpp"

namespace ehd::verification {

namespace {

constexpr double minimum = 0.0741427, central = 0.0856067;

/// A run whose films are off by a relative `off`, and which states `error`.
JudgedRun made_run(const std::string& solver, double off, double error, int nodes) {
  JudgedRun made;
  made.tolerance = 1e-3;
  made.run.solver = solver;
  Solution& solution = made.run.solution;
  solution.record.status = StopReason::converged;
  solution.fields.X = Array::LinSpaced(nodes, -4, 1);
  solution.observables[Quantity::film_minimum] = {.value = minimum * (1 + off), .error = error};
  solution.observables[Quantity::film_central] = {.value = central * (1 - off), .error = error};
  return made;
}

Case with_digits(std::initializer_list<Quantity> films) {
  Case one;
  for (const Quantity film : films) {
    Expectation digits;
    digits.quantity = to_string(film);
    digits.value = film == Quantity::film_minimum ? minimum : central;
    digits.digits = "digits";
    digits.uncertainty = 1e-9;
    one.expectations.push_back(digits);
  }
  return one;
}

JudgedRun no_more() {
  BOOST_FAIL("a further run was asked for");
  return made_run("nobody", 0, 0, 2);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bench_film_truth)

// Two runs of one solver may end on one grid: neither is off by 0 because the other is the same.
BOOST_AUTO_TEST_CASE(no_run_is_the_truth_of_itself) {
  std::vector<JudgedRun> runs{made_run("reference", 1e-6, 4e-5, 100), made_run("reference", 1e-6, 4e-5, 100),
                              made_run("fast", 2e-4, 1e-3, 200), made_run("fast", 2e-6, 1e-3, 200)};
  const auto truth = film_truth(with_digits({}), runs, [] { return made_run("reference", 0, 9e-4, 90); });
  BOOST_REQUIRE(truth.has_value());
  for (const std::string& words : truth->words)
    BOOST_TEST(words.find("reference at 0.001") != std::string::npos, words);
  for (JudgedRun& run : runs) judge(run, *truth);
  for (std::size_t film = 0; film < 2; ++film) {
    for (const std::size_t same : {0u, 1u}) BOOST_TEST(runs[same].films[film].words() == "-");
    // 1.99e-4 is five times what the truth states: a bound, not a number.
    BOOST_TEST(!runs[2].films[film].known().has_value());
    const auto distance = Tolerance::asymptotic(2e-6, "|1 + a|/|1 + b| - 1 is a - b but for a part b, 1e-6, of itself");
    EHD_CHECK(error(runs[2].films[film].bound().value(), 1.99e-4 + 4e-5), distance);
    EHD_CHECK(error(runs[3].films[film].bound().value(), 1e-6 + 4e-5), distance);
    BOOST_TEST(runs[3].films[film].words() == "<" + plain(*runs[3].films[film].bound(), 2));
  }
}

BOOST_AUTO_TEST_CASE(a_tighter_run_is_the_truth_of_both_films) {
  std::vector<JudgedRun> runs{made_run("reference", 1e-6, 4e-5, 100), made_run("fast", 2e-4, 1e-3, 200)};
  const auto truth = film_truth(with_digits({}), runs, [] { return made_run("reference", 0, 1e-8, 300); });
  BOOST_REQUIRE(truth.has_value());
  for (const std::string& words : truth->words) BOOST_TEST(words.starts_with("one more run, reference"), words);
  for (JudgedRun& run : runs) judge(run, *truth);
  for (std::size_t film = 0; film < 2; ++film) {
    EHD_CHECK(error(runs[0].films[film].known().value(), 1e-6), Tolerance::round_off(10, 1e6));
    EHD_CHECK(error(runs[1].films[film].known().value(), 2e-4), Tolerance::round_off(10, 1e4));
  }
}

// The digits of one film are not the truth of one film while a solution is that of the other.
BOOST_AUTO_TEST_CASE(digits_are_the_truth_where_the_case_has_both) {
  std::vector<JudgedRun> runs{made_run("fast", 2e-4, 1e-3, 200)};
  const auto digits = film_truth(with_digits({Quantity::film_minimum, Quantity::film_central}), runs, no_more);
  BOOST_REQUIRE(digits.has_value());
  for (const std::string& words : digits->words) BOOST_TEST(words.starts_with("the case's digits"), words);
  judge(runs[0], *digits);
  EHD_CHECK(error(runs[0].films[1].known().value(), 2e-4), Tolerance::round_off(10, 1e4));
  const auto one =
      film_truth(with_digits({Quantity::film_minimum}), runs, [] { return made_run("reference", 0, 1e-8, 300); });
  BOOST_REQUIRE(one.has_value());
  for (const std::string& words : one->words) BOOST_TEST(words.starts_with("one more run"), words);
}

BOOST_AUTO_TEST_CASE(without_a_solution_with_errors_there_is_no_truth) {
  JudgedRun failed = made_run("reference", 0, 1e-8, 300), vague = made_run("fast", 0, 1e-3, 200);
  failed.run.solution.record.status = StopReason::diverged;
  vague.run.solution.observables.at(Quantity::film_central).error.reset();
  BOOST_TEST(!film_truth(with_digits({}), {vague}, [&] { return failed; }).has_value());
  vague.run.solution.observables.at(Quantity::film_central).error = 1e-3;
  vague.run.solution.record.status = StopReason::tolerance_not_met;  // its stated error is as honest
  BOOST_TEST(film_truth(with_digits({}), {vague}, [&] { return failed; }).has_value());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
