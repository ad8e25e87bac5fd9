// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/box_bench.hpp"

#include <nlohmann/json.hpp>

#include "io/tables.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// Films of 2 (1 + offset) and 3 (1 + offset), with the error that it reports.
RegisteredSolver made_solver(std::string name, double offset, double reported, double wall_s = 0.02) {
  RegisteredSolver solver = *find_solver("fast");
  solver.name = std::move(name);
  solver.solve = [=](const Problem&, const Request&) {
    Solution solution;
    solution.record.status = StopReason::converged;
    solution.record.cost.wall_s = wall_s;
    solution.observables[Quantity::film_minimum] = {.value = 2 * (1 + offset), .error = reported};
    solution.observables[Quantity::film_central] = {.value = 3 * (1 - offset), .error = reported};
    return solution;
  };
  return solver;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bench_box_bench)

BOOST_AUTO_TEST_CASE(the_box_is_that_of_the_method) {
  int cut = 0, flooded = 0;
  double lightest = 1e9, widest = 0;
  for (const BoxContact& contact : bench_contacts(false)) {
    (contact.flooded() ? flooded : cut) += 1;
    lightest = std::min(lightest, contact.moes.M);
    const auto* const inlet = std::get_if<TruncatedAt>(&contact.inlet);
    BOOST_CHECK_EQUAL(inlet == nullptr, contact.flooded());
    if (inlet) {
      BOOST_CHECK_LE(inlet->x, -4);
      widest = std::min(widest, inlet->x);
    }
  }
  BOOST_TEST(cut == 104);
  BOOST_TEST(flooded == 128);
  BOOST_TEST(lightest == 0.05);
  BOOST_TEST(widest < -10);  // thick films at M = 0.5 begin further out
}

BOOST_AUTO_TEST_CASE(achieved_errors_are_against_the_truth_and_bars_are_counted) {
  const RegisteredSolver truth = made_solver("truth", 0, 1e-9), good = made_solver("good", 1e-4, 2e-4),
                         proud = made_solver("proud", 1e-4, 5e-5);
  const auto contacts = bench_contacts(true);
  const auto rows = run_box_bench({.solvers = {&good, &proud}, .contacts = contacts, .truth = &truth});
  BOOST_REQUIRE_EQUAL(rows.size(), 2 * box_settings().size() * contacts.size());
  for (const BoxRow& row : rows) {
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_REQUIRE(row.achieved[k] && row.truth_error[k]);
      EHD_CHECK(error(*row.achieved[k], 1e-4), Tolerance::round_off(10, 1e4));
    }
    BOOST_CHECK_EQUAL(row.status, "converged");
    BOOST_CHECK_GE(row.wall_s.size(), 3u);
  }
  const std::string table = human_table(rows);
  const auto count = std::to_string(2 * contacts.size() / 2);  // films of half the contacts: the cut ones, the flooded
  BOOST_TEST(table.find(count + " of " + count) != std::string::npos);
  BOOST_TEST(table.find(" 0 of " + count) != std::string::npos);
  BOOST_TEST(to_json(rows)[0]["film.central"]["achieved"].get<double>() > 0);
  const std::string csv = box_csv(rows);
  BOOST_TEST(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == rows.size() + 1);
}

BOOST_AUTO_TEST_CASE(without_a_truth_nothing_is_achieved) {
  const RegisteredSolver good = made_solver("good", 1e-4, 2e-4);
  const auto rows = run_box_bench({.solvers = {&good}, .contacts = bench_contacts(true)});
  BOOST_REQUIRE(!rows.empty());
  for (const BoxRow& row : rows) BOOST_CHECK(!row.achieved[0] && !row.achieved[1] && row.reported[0]);
  BOOST_TEST(human_table(rows).find("0 of 0") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
