// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/plausibility.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "io/bearing_notes.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/contact_run.hpp"

namespace ehd {

namespace {

using verification::made::needle_bearing;

std::vector<std::string> names_of(const Facts& facts) {
  std::vector<std::string> names;
  for (const Unusual& one : unusual(facts)) names.emplace_back(one.range->name);
  return names;
}

/// Which numbers of the stated bearing are unusual after a change.
std::vector<std::string> after(const std::function<void(BearingCase&)>& change) {
  Case one = needle_bearing(10e-6);
  change(std::get<BearingCase>(one.body));
  return names_of(facts_of(std::get<BearingCase>(one.body), {}));
}

using Names = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_SUITE(plausibility)

BOOST_AUTO_TEST_CASE(slips_of_a_unit_are_named) {
  BOOST_TEST(after([](BearingCase&) {}).empty());
  BOOST_TEST((after([](BearingCase& b) { b.geometry.pitch_diameter_m = 65.5; }) == Names{"surface speed", "D/d_m"}));
  BOOST_TEST((after([](BearingCase& b) { b.operation.inner_speed_rpm = 3e6; }) == Names{"surface speed"}));
  BOOST_TEST((after([](BearingCase& b) { b.geometry.length_m = 10.5; }) == Names{"l/D"}));
  BOOST_TEST((after([](BearingCase& b) { b.lubricant->viscosity_Pa_s = 20; }) == Names{"viscosity"}));
  BOOST_TEST((after([](BearingCase& b) { b.lubricant->viscosity_Pa_s = 2e-5; }) == Names{"viscosity"}));
  BOOST_TEST((after([](BearingCase& b) { b.lubricant->lubricant.alpha_per_Pa = 2e-11; }) == Names{"alpha"}));
  BOOST_TEST((after([](BearingCase& b) { b.lubricant->lubricant.p0_Pa = 1.96e5; }) == Names{"p_0"}));
  BOOST_TEST((after([](BearingCase& b) { b.roughness_m = 0.15; }) == Names{"roughness"}));
  BOOST_TEST((after([](BearingCase& b) { b.modulus_Pa = 2.06e8; }) == Names{"E'"}));
  BOOST_TEST((after([](BearingCase& b) { b.geometry.density_kg_per_m3 = 7.85; }) == Names{"density of the rollers"}));
  BOOST_TEST((after([](BearingCase& b) { b.geometry.clearance_m = -0.1; }) == Names{"P_d/d_m"}));
  BOOST_TEST((after([](BearingCase& b) { b.geometry.rollers *= 3; }) == Names{"rollers over the most that fit"}));
  // 7 of these rollers cover less than the pitch circle, but only 6 fit. 6 rollers of half its diameter touch.
  BOOST_TEST((after([](BearingCase& b) {
                b.geometry.rollers = 7;
                b.geometry.roller_diameter_m = 0.44 * b.geometry.pitch_diameter_m;
              }) == Names{"rollers over the most that fit", "D/d_m"}));
  BOOST_TEST((after([](BearingCase& b) {
                b.geometry.rollers = 6;
                b.geometry.roller_diameter_m = b.geometry.pitch_diameter_m / 2;
              }) == Names{"D/d_m"}));
}

// Each row gives its note just outside its bounds, and none just inside.
BOOST_AUTO_TEST_CASE(every_row_of_the_table_is_judged_at_its_bounds) {
  BOOST_REQUIRE(usual_ranges().size() >= 8U);
  for (const UsualRange& range : usual_ranges()) {
    BOOST_TEST_CONTEXT(range.name) {
      BOOST_TEST((range.lowest || range.highest));
      BOOST_TEST(!range.reason.empty());
      for (const auto& [bound, outwards] : {std::pair{range.lowest, -1.0}, {range.highest, 1.0}}) {
        if (!bound) continue;
        Facts facts;
        facts.*range.fact = *bound + outwards * 1e-3 * std::abs(*bound);
        BOOST_TEST((names_of(facts) == Names{std::string(range.name)}));
        BOOST_TEST(sentence_of(unusual(facts)[0]).find(outwards > 0 ? " is above " : " is below ") !=
                   std::string::npos);
        facts.*range.fact = *bound - outwards * 1e-3 * std::abs(*bound);
        BOOST_TEST(unusual(facts).empty());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_numbers_of_a_result_are_judged_too) {
  std::vector<RollerRow> rollers(2);
  rollers[0].outer.hertz_pressure_Pa = 4.921e12;
  rollers[1].inner.film_minimum_m = 3e-11;
  const Case one = needle_bearing(0);
  const auto found = unusual(facts_of(std::get<BearingCase>(one.body), rollers));
  BOOST_REQUIRE(found.size() == 2U);
  BOOST_TEST(sentence_of(found[0]) == "p_H = 4921 GPa is above 4 GPa: a numerical test, not a contact of steel");
  BOOST_TEST(sentence_of(found[1]).starts_with("thinnest film = 0.03 nm is below 1 nm: "));
}

// p_H = L sqrt(M/2pi)/alpha: 38.47 GPa at the corner (5000, 30), 0.81 GPa at (20, 10).
BOOST_AUTO_TEST_CASE(a_contact_is_judged_in_SI_and_by_its_groups) {
  ContactCase contact;
  contact.lubricant = Lubricant{.viscosity = ViscosityLaw::roelands, .alpha_per_Pa = 2.2e-8, .z = 0.68};
  contact.inlet = Flooded{};
  RegisteredSolver none;
  none.solve = [](const Problem&, const Request&) { return Solution{}; };
  const auto notes = [&](const Statement& statement) {
    contact.statement = statement;
    return run_contact(contact, none, {}).notes;
  };
  BOOST_TEST(notes(MoesGroups{20, 10}).empty());
  BOOST_REQUIRE(notes(MoesGroups{5000, 30}).size() == 1U);
  BOOST_TEST(notes(MoesGroups{5000, 30})[0].starts_with("p_H = 38.47 GPa is above 4 GPa"));
  for (const auto& [groups, says] :
       {std::pair{MoesGroups{0.04, 10}, "M = 0.04 is below 0.05: stated errors are calibrated for M of 0.05 to 5000"},
        {MoesGroups{6000, 1}, "M = 6000 is above 5e3: stated errors are"},
        {MoesGroups{20, 31}, "L = 31 is above 30: stated errors are calibrated for L of 0 to 30"}}) {
    BOOST_REQUIRE(!notes(groups).empty());
    BOOST_TEST(notes(groups)[0].starts_with(says), notes(groups)[0]);
  }
  contact.inlet = TruncatedAt{-2.4};
  BOOST_TEST(notes(MoesGroups{20, 10}).empty());  // near cuts were tested there
  BOOST_REQUIRE(notes(MoesGroups{100, 10}).size() == 1U);
  BOOST_TEST(notes(MoesGroups{100, 10})[0].starts_with("the inlet's X = -2.4 is above -2.5: stated errors"));
  contact.inlet = TruncatedAt{-2.5};
  BOOST_TEST(notes(MoesGroups{100, 10}).empty());
  contact.inlet = Flooded{};
  contact.lubricant->z.reset();
  Conditions conditions{.load_N_per_m = 1.1e5,
                        .reduced_radius_m = 1.2e-2,
                        .reduced_modulus_Pa = 2.3e11,
                        .speed_sum_m_per_s = 3.1,
                        .viscosity_Pa_s = 0.021};
  BOOST_TEST(notes(conditions).empty());
  Conditions in_mm = conditions, in_N_per_mm = conditions;
  in_mm.reduced_radius_m = 12;
  in_N_per_mm.load_N_per_m = 110;
  BOOST_TEST(notes(in_mm).at(0).starts_with("R = 12 m is above 2 m"));
  BOOST_TEST(notes(in_N_per_mm).at(0).starts_with("load = 110 N/m is below 1e3 N/m"));
  conditions.speed_sum_m_per_s = 500;
  BOOST_REQUIRE(notes(conditions).size() == 2U);  // and L, which that speed makes large
  BOOST_TEST(notes(conditions)[0].starts_with("surface speed = 250 m/s is above 200 m/s"));
}

// A bearing that has no balance says what is unusual about it.
BOOST_AUTO_TEST_CASE(a_bearing_without_a_balance_is_judged_by_what_is_stated) {
  ContactMemory memory([](const Problem&, const Request&) { return Solution{}; });
  Case one = needle_bearing(0);
  std::get<BearingCase>(one.body).operation.inner_speed_rpm = 1e6;
  const auto result = run_bearing(one, {.laws = {bearing::Law::ehd}, .explicitly = true}, memory).at(0);
  BOOST_TEST((result.status != StopReason::converged));
  const auto notes = notes_of(result);
  BOOST_TEST(std::any_of(notes.begin(), notes.end(),
                         [](const std::string& note) { return note.starts_with("surface speed = "); }));
}

// Where no contact of its oil can be solved, the refusal says it.
BOOST_AUTO_TEST_CASE(a_bearing_refused_for_its_oil_is_judged_by_what_is_stated) {
  ContactMemory memory([](const Problem&, const Request&) { return Solution{}; });
  Case one = needle_bearing(0);
  std::get<BearingCase>(one.body).operation.inner_speed_rpm = 3e6;
  BOOST_CHECK_EXCEPTION((void)run_bearing(one, {.laws = {bearing::Law::ehd}}, memory), CaseError,
                        [](const CaseError& error) {
                          return std::string(error.what()).find("needs no oil; surface speed = ") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd
