// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/answer_cost.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(bench_answer_cost)

BOOST_AUTO_TEST_CASE(a_process_that_is_refused_is_a_row_with_its_reason_and_the_other_rows_stay) {
  const auto rows = run_answer_costs({.solver = &default_solver(),
                                      .quick = true,
                                      .repetition = {.least = 1, .least_s = 0, .enough_s = 0, .most = 1},
                                      .program = "/no/such/program"});
  BOOST_REQUIRE(rows.size() > 1u);
  BOOST_TEST(rows.back().why == "not measured: /no/such/program: does not start");
  BOOST_TEST(std::all_of(rows.begin(), rows.end() - 1, [](const AnswerCost& row) { return row.why.empty(); }));
  const Json last = to_json(rows).back();
  BOOST_TEST(last["reason"] == rows.back().why);
  BOOST_TEST(!last.contains("median_s"));
  BOOST_TEST(human_table(rows).find(rows.back().why) != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
