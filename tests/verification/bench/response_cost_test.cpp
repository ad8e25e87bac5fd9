// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/response_cost.hpp"

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(bench_response_cost)

BOOST_AUTO_TEST_CASE(a_frequency_is_timed_beside_its_achieved_error_and_a_bearing_beside_its_balance) {
  const Repetition once{.least = 1, .least_s = 0, .enough_s = 1e3, .most = 1};
  const ResponseCost cost = run_response_costs({.quick = true, .repetition = once});
  BOOST_REQUIRE(cost.frequencies.size() == 2u);
  for (const FrequencyCost& row : cost.frequencies) {
    BOOST_TEST(row.solver == (row.achieved ? "fast" : "reference"));
    BOOST_TEST((row.status == StopReason::converged));
    BOOST_TEST(row.frequency_s > 0);
    BOOST_TEST(row.c_s > 0);
    BOOST_TEST(row.stated <= row.tolerance);
    if (row.achieved) EHD_CHECK(*row.achieved, Tolerance::discretisation(row.stated, 1));
  }
  BOOST_REQUIRE(cost.bearings.size() == 1u);
  BOOST_TEST(cost.bearings[0].responses > 0);
  BOOST_TEST(cost.bearings[0].dynamic_s > cost.bearings[0].balance_s);
  const Json json = to_json(cost);
  BOOST_TEST(json["frequencies"].size() == 2u);
  BOOST_TEST(json["bearings"][0]["bearing"] == "na4908");
  BOOST_TEST(human_table(cost).find("na4908") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
