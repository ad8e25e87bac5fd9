// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/traceability.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "io/json.hpp"
#include "tests/check.hpp"
#include "verification/suite.hpp"

namespace {

using namespace ehd;
using namespace ehd::verification;

Claim made_claim(const std::string& id, int rung, double error, double tolerance) {
  return claim({.id = id, .rung = rung, .statement = "something holds"}, error, 0,
               Tolerance::required(tolerance, "here"));
}

Findings some_findings() {
  return {.claims = {made_claim("a/one", 0, 0.1, 1), made_claim("a/two", 0, 2, 1),
                     made_claim("b/x/one", 3, std::nan(""), 1)},
          .skipped = {{{.id = "a/three", .rung = 0, .statement = "something else"}, "not now"}}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(traceability)

BOOST_AUTO_TEST_CASE(claims_are_counted_by_verdict_for_each_part) {
  const auto rows = trace({{"part/a", "a's", {"a/*"}}, {"part/ends", "one", {"*/one", "b/*"}}}, some_findings());
  BOOST_REQUIRE(rows.size() == 2U);
  BOOST_TEST(rows[0].pass == 1U);
  BOOST_TEST(rows[0].fail == 1U);
  BOOST_TEST(rows[0].skipped == 1U);
  BOOST_TEST(rows[0].judged() == 2U);
  BOOST_TEST(rows[1].pass == 1U);
  BOOST_TEST(rows[1].inconclusive == 1U);  // matched by both patterns, counted once
  BOOST_TEST(rows[1].unmatched.empty());
  BOOST_TEST((rows[1].examples == std::vector<std::string>{"a/one", "b/x/one"}));
}

BOOST_AUTO_TEST_CASE(a_part_without_a_judged_claim_or_with_a_dead_pattern_fails) {
  const auto rows =
      trace({{"supported", "s", {"a/one"}}, {"skipped-only", "s", {"a/three"}}, {"dead", "s", {"a/one", "c/*"}}},
            some_findings());
  const auto claims = judge_traceability(rows);
  BOOST_REQUIRE(claims.size() == 3U);
  BOOST_TEST((claims[0].verdict == Verdict::pass));
  BOOST_TEST((claims[1].verdict == Verdict::fail));
  BOOST_TEST((claims[2].verdict == Verdict::fail));
  BOOST_TEST(claims[2].note.find("c/*") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(parts_have_names_and_patterns_of_their_own) {
  std::set<std::string> ids;
  for (const TraceablePart& part : traceable_parts()) {
    BOOST_TEST(ids.insert(part.id).second, part.id);
    BOOST_TEST(!part.text.empty());
    BOOST_TEST(!part.patterns.empty());
  }
  BOOST_TEST(ids.size() > 10U);
}

BOOST_AUTO_TEST_CASE(a_rung_is_summed_up_with_its_worst_claim) {
  Findings findings = some_findings();
  SuiteResult result;
  result.claims = findings.claims;
  result.skipped = findings.skipped;
  result.claims.push_back(made_claim("b/narrow", 3, 0.9, 1));
  result.claims.push_back(claim_finding({.id = "b/finding", .rung = 3, .statement = "found"}, "note"));
  const auto rungs_of = summarise(result);
  BOOST_REQUIRE(rungs_of.size() == static_cast<std::size_t>(rungs));
  BOOST_TEST(rungs_of[0].pass == 1U);
  BOOST_TEST(rungs_of[0].fail == 1U);
  BOOST_TEST(rungs_of[0].skipped == 1U);
  BOOST_TEST(rungs_of[0].worst_claim == "a/two");  // a claim that fails is the worst
  BOOST_REQUIRE(rungs_of[0].worst_margin.has_value());
  BOOST_TEST(*rungs_of[0].worst_margin == -1);
  BOOST_TEST(rungs_of[3].inconclusive == 1U);
  BOOST_TEST(rungs_of[3].worst_claim == "b/narrow");  // NaN has no margin, a finding uses none
  BOOST_TEST(!rungs_of[5].worst_margin.has_value());

  const Json json = to_json(result);
  BOOST_TEST(json["schema"] == "ehd-verify-2");
  BOOST_TEST(json["rungs"].size() == static_cast<std::size_t>(rungs));
  BOOST_TEST(json["rungs"][0]["worst_claim"] == "a/two");
  BOOST_TEST(json["traceability"].size() == traceable_parts().size());
  BOOST_TEST(!json["rungs"][5].contains("worst_margin"));
}

BOOST_AUTO_TEST_CASE(the_worse_of_two_errors_keeps_a_NaN) {
  const double unknown = std::nan("");
  BOOST_TEST(worse(1, 2) == 2);
  BOOST_TEST(worse(2, 1) == 2);
  BOOST_TEST(std::isnan(worse(unknown, 1)));
  BOOST_TEST(std::isnan(worse(1, unknown)));
  BOOST_TEST(std::isnan(worse(1, 2, unknown, 3)));
}

BOOST_AUTO_TEST_SUITE_END()
