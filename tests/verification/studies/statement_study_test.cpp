// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/statement_study.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/case.hpp"

namespace ehd::verification {

namespace {

std::vector<Case> needle_bearing_at_three_clearances() {
  std::vector<Case> cases;
  for (const char* id : {"na4908", "na4908-2.5um", "na4908-10um"}) cases.push_back(read_case(find_case(id)));
  return cases;
}

Solution synthetic_contact(const Problem& problem, const Request&) { return made::contact(problem); }

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_statement_study)

// Agreement: the row "as the case" has the statements of the cases themselves, and every choice is judged.
BOOST_AUTO_TEST_CASE(every_choice_is_judged_and_the_first_row_is_the_case_itself) {
  const auto cases = needle_bearing_at_three_clearances();
  ContactMemory memory(synthetic_contact);
  const auto rows = study_statements(cases, memory);
  std::vector<ClearanceComparison> clearances;
  for (const Case& one : cases) {
    const auto results =
        run_bearing(one, {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .explicitly = true}, memory);
    clearances.push_back({std::get<BearingCase>(one.body).geometry.clearance_m, results[0], results[1]});
  }
  const auto statements = judge_paper_statements(clearances);
  BOOST_REQUIRE(!rows.empty());
  BOOST_REQUIRE_EQUAL(rows.front().statements.size(), statements.size());
  for (std::size_t k = 0; k < statements.size(); ++k)
    BOOST_TEST(rows.front().statements[k].numbers == statements[k].numbers);
  std::set<std::string> linear, full;
  for (const StudyRow& row : rows) {
    BOOST_TEST(row.statements.size() == 4u, row.factor << " " << row.value << ": " << row.why);
    (row.law == bearing::Law::ehd ? full : linear).insert(row.factor);
  }
  std::set<std::string> known{"as the case", "two choices"};
  known.insert(open_choices.begin(), open_choices.end());
  BOOST_TEST(linear == known, boost::test_tools::per_element());
  BOOST_TEST(full.size() == 9u);  // no fit (its range, its direction), no letting go
  // "Two choices" are not of the table with one choice changed, and name both.
  const auto pairs =
      std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return row.factor == "two choices"; });
  BOOST_TEST(pairs == 6);
  for (const StudyRow& row : rows) {
    if (row.factor == "two choices") BOOST_TEST(row.value.find(", x_0 = ") != std::string::npos);
    BOOST_TEST(row.scan.has_value() ==
               (row.factor != "two choices" && row.factor != "datum" && row.factor != "unloading"));
  }
  int of = 0;
  for (const StudySummary& one : summarise(rows)) of += one.letter == 'a' ? one.of : 0;
  BOOST_TEST(of == static_cast<int>(rows.size()) - pairs);
  for (const StudySummary& one : summarise(rows)) {
    BOOST_TEST(one.of > 10);
    BOOST_TEST((one.holds == 0 || one.holds == one.of) == one.exceptions.empty());
  }
}

// Counter: a datum and the other ring ask for no contact that is not known; a choice changes what it says it changes.
BOOST_AUTO_TEST_CASE(a_choice_changes_what_it_says) {
  const auto cases = needle_bearing_at_three_clearances();
  ContactMemory memory(synthetic_contact);
  const auto rows = study_statements(cases, memory);
  const auto value = [&](const std::string& factor, const std::string& name, char letter) {
    std::vector<double> values;
    for (const StudyRow& row : rows)
      for (const PaperStatement& one : row.statements)
        if (row.law == bearing::Law::ehd_linear && row.factor == factor && one.letter == letter)
          for (const auto& [key, number] : one.values)
            if (key == name) values.push_back(number);
    return values;
  };
  const auto thicker = value("viscosity", "most", 'b');
  BOOST_REQUIRE_EQUAL(thicker.size(), 4u);
  BOOST_TEST(std::is_sorted(thicker.rbegin(), thicker.rend()));  // a thicker film holds the bodies further apart
  const auto turned = value("rotating ring", "change", 'a'), as_is = value("as the case", "change", 'a');
  BOOST_REQUIRE_EQUAL(turned.size(), 1u);
  BOOST_TEST(turned[0] != as_is[0]);    // the cage, and so the centrifugal force, is another
  constexpr double small_change = 0.1;  // the films stay; centrifugal forces are a small part of the load
  BOOST_TEST(std::abs(turned[0] - as_is[0]) < small_change * std::abs(as_is[0]));
  BOOST_TEST(value("length", "change", 'a').size() == 1u);
  // Another dry law moves the loads that EHD is compared with. Another density moves no film of the synthetic contact.
  for (const double change : value("K_Hertz", "change", 'a')) BOOST_TEST(change != as_is[0]);
  BOOST_TEST(value("K_Hertz", "change", 'a').size() == 2u);
  BOOST_TEST(value("density", "change", 'a').size() == 2u);
  // The line of delta on f is the steeper one, so that the most loaded roller carries more.
  const auto steeper = value("fit direction", "change", 'a');
  BOOST_REQUIRE_EQUAL(steeper.size(), 1u);
  BOOST_TEST(steeper[0] > as_is[0]);
}

BOOST_AUTO_TEST_CASE(cases_that_are_not_one_bearing_have_no_study) {
  auto cases = needle_bearing_at_three_clearances();
  std::get<BearingCase>(cases[1].body).geometry.rollers = 20;
  ContactMemory memory(synthetic_contact);
  BOOST_TEST(study_statements(cases, memory).empty());
  cases.pop_back();
  BOOST_TEST(study_statements(cases, memory).empty());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
