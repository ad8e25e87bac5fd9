// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bearing/fit.hpp"
#include "bearing/law_table.hpp"
#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "fast/uniform.hpp"
#include "io/bearing_json.hpp"
#include "io/bearing_notes.hpp"
#include "io/bearing_table.hpp"
#include "io/json.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"

namespace ehd {

namespace {

using verification::Tolerance;
using verification::made::needle_bearing;

BearingCase& body_of(Case& one) { return std::get<BearingCase>(one.body); }

Solution synthetic_contact(const Problem& problem, const Request&) { return verification::made::contact(problem); }

/// Counts the calls, and keeps every M to show that none comes twice at one raceway.
struct CountedContacts {
  std::map<double, int> calls;
  long total = 0;
  Wanted wanted;
  ContactSolver solver() {
    return [this](const Problem& problem, const Request& request) {
      ++calls[problem.groups.M];
      ++total;
      wanted = problem.wanted;
      return synthetic_contact(problem, request);
    };
  }
};

std::vector<BearingResult> run(const Case& one, const std::vector<bearing::Law>& laws, ContactMemory& memory) {
  return run_bearing(one, {.laws = laws, .explicitly = true}, memory);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_run)

// Counter: a dry law solves no contact, though the case has a lubricant.
BOOST_AUTO_TEST_CASE(the_dry_laws_solve_no_contact) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const auto results = run(needle_bearing(0), {bearing::Law::hertz, bearing::Law::iso}, memory);
  BOOST_REQUIRE(results.size() == 2u);
  BOOST_TEST(contacts.total == 0);
  for (const BearingResult& result : results) {
    BOOST_TEST((result.status == StopReason::converged));
    BOOST_TEST(!result.plan.runs(bearing_stage::solves));
    for (const RollerRow& row : result.rollers) BOOST_TEST(!row.inner.film_minimum_m.has_value());
  }
}

// Every dry law balances; those that need the ring's thickness say so.
BOOST_AUTO_TEST_CASE(every_dry_law_balances_and_says_what_it_needs) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(5e-6);
  one.places["bearing"].line = 3;
  const auto laws = bearing::laws_of(bearing::Laws::dry);
  for (const bearing::Law law : laws) {
    if (!bearing::needs_ring_thickness(law)) continue;
    BOOST_CHECK_EXCEPTION((void)run(one, {law}, memory), CaseError, [](const CaseError& error) {
      const std::string what = error.what();
      return what.starts_with("needle.toml:3: [bearing] ring_thickness_m: is missing") &&
             what.find('\n') == std::string::npos;
    });
    BOOST_TEST(!plan_bearing(body_of(one), {law}).runs(bearing_stage::balance(law)));
  }
  body_of(one).ring_thickness_m = 0.0035;
  const auto results = run(one, laws, memory);
  BOOST_REQUIRE(results.size() == laws.size());
  for (std::size_t k = 0; k < laws.size(); ++k) {
    BOOST_TEST((results[k].law == laws[k]));
    BOOST_TEST((results[k].status == StopReason::converged), results[k].why);
    if (k == 0) continue;
    EHD_CHECK(error(results[k].displacement_m, results[0].displacement_m),
              Tolerance::calibrated(0.3, "the largest is lundberg, 26 % above hertz at no clearance"));
    BOOST_TEST(results[k].displacement_m != results[0].displacement_m);
  }
  BOOST_TEST(contacts.total == 0);
}

// The cage over one pitch: the mean lies between, mirrored positions cancel across, and the contacts are solved once.
BOOST_AUTO_TEST_CASE(the_cage_is_turned_over_one_pitch) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const Case one = needle_bearing(30e-6);
  BearingRequest request{.laws = {bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd},
                         .explicitly = true};
  const auto still = run_bearing(one, request, memory);
  const long solved = contacts.total;
  request.cage_positions = 12;
  const auto turning = run_bearing(one, request, memory);
  BOOST_TEST(contacts.total == solved);
  BOOST_REQUIRE(turning.size() == 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    BOOST_TEST(!still[k].cage.has_value());
    BOOST_REQUIRE(turning[k].cage.has_value());
    const CageTurn& cage = *turning[k].cage;
    BOOST_TEST(turning[k].displacement_m == still[k].displacement_m);
    BOOST_TEST(turning[k].plan.runs(bearing_stage::cage));
    BOOST_TEST(cage.positions == 12);
    BOOST_TEST(cage.displacement_m.peak_to_peak > 0);
    BOOST_TEST(std::abs(cage.displacement_m.mean - turning[k].displacement_m) < cage.displacement_m.peak_to_peak);
    EHD_CHECK(std::abs(cage.displacement_lateral_m.mean) / cage.displacement_m.mean, Tolerance::round_off(22, 100));
    BOOST_TEST(cage.displacement_lateral_m.peak_to_peak > 0);
    BOOST_TEST(cage.largest_force_N >= turning[k].rollers[0].inner.force_N);
    const Json json = to_json(turning[k]);
    BOOST_TEST(json["cage"]["positions"] == 12);
    BOOST_TEST(json["cage"]["displacement_m"].contains("peak_to_peak"));
    BOOST_TEST(json["cage"]["displacement_lateral_m"].contains("mean"));
  }
}

// An asymmetric cage is balanced in the plane, and the radial form says what it leaves out.
BOOST_AUTO_TEST_CASE(the_form_is_a_choice_and_a_skipped_stage) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(30e-6);
  const auto skipped_why = [](const Plan& plan) {
    for (const SkippedStage& stage : plan.skipped)
      if (stage.stage == bearing_stage::across) return stage.why;
    return std::string();
  };
  BOOST_TEST(skipped_why(plan_bearing(body_of(one), {bearing::Law::hertz})).find("symmetric") != std::string::npos);
  body_of(one).geometry.first_azimuth_deg = 5;
  BOOST_TEST(skipped_why(plan_bearing(body_of(one), {bearing::Law::hertz})).empty());
  BearingRequest request{.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .explicitly = true};
  const auto plane = run_bearing(one, request, memory);
  request.form = bearing::Form::radial;
  const auto radial = run_bearing(one, request, memory);
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(plane[k].displacement_lateral_m != 0);
    BOOST_TEST(radial[k].displacement_lateral_m == 0);
    BOOST_TEST(skipped_why(radial[k].plan).find("radial") != std::string::npos);
    const auto says = [](const BearingResult& result) {
      return std::any_of(result.notes.begin(), result.notes.end(),
                         [](const BearingNote& note) { return std::holds_alternative<note::LateralForce>(note); });
    };
    BOOST_TEST(!says(plane[k]));
    BOOST_TEST(says(radial[k]));
  }
  BOOST_TEST(plane[1].variants.size() == 1u);
}

// Counter: the same load at the same raceway is never solved twice, across laws and clearances.
BOOST_AUTO_TEST_CASE(equal_contacts_are_solved_once_across_laws_and_clearances) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  long before = 0;
  for (const double clearance_m : {0.0, 2.5e-6, 10e-6}) {
    const auto results = run(needle_bearing(clearance_m), {bearing::Law::ehd_linear, bearing::Law::ehd}, memory);
    for (const BearingResult& result : results) BOOST_TEST((result.status == StopReason::converged));
    if (before > 0)
      BOOST_TEST(contacts.total - before <= 6);  // fit and curve are there; only edges of the zone are new
    before = contacts.total;
  }
  BOOST_TEST(memory.solves() == contacts.total);
  for (const auto& [M, calls] : contacts.calls) BOOST_TEST(calls == 1);
  const Wanted needed{Quantity::film_minimum, Quantity::film_central, Quantity::film_offset, Quantity::rolling_force};
  BOOST_TEST((contacts.wanted == needed));
}

// The slowest bearing that was met: 0.1 m of interference took a minute. Its forces reach far beyond every contact that
// can be solved, so that each roller was solved again and again.
BOOST_AUTO_TEST_CASE(a_bearing_of_absurd_interference_asks_for_few_contacts) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const long most_solves = 150;  // the program needs 100; three ordinary clearances need 40
  (void)run(needle_bearing(-0.1), {bearing::Law::ehd_linear, bearing::Law::ehd}, memory);
  BOOST_TEST(contacts.total <= most_solves);
}

// Counter: mirrored rollers are balanced once.
BOOST_AUTO_TEST_CASE(mirrored_rollers_are_balanced_once) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  for (const BearingResult& result : run(needle_bearing(0), {bearing::Law::hertz, bearing::Law::ehd}, memory)) {
    BOOST_TEST(result.rollers_balanced == 12 * result.newton_iterations);
  }
}

// Exact: the fit's points have the approach of the composition's closed form, with the datum that meets Palmgren's law.
BOOST_AUTO_TEST_CASE(the_fit_sees_the_approach_of_the_solved_contacts) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const Case one = needle_bearing(0);
  const auto results = run(one, {bearing::Law::hertz, bearing::Law::ehd_linear}, memory);
  const BearingResult& linear = results.at(1);
  BOOST_REQUIRE(linear.fit.has_value());
  const double largest_N = results.at(0).rollers.at(0).inner.force_N;
  const double R = 1 / (2 / 0.005 + 2 / 0.048), modulus = 2.06e11 / (1 - 0.09), l = 0.122;
  const bearing::PowerLaw palmgren = bearing::palmgren_law(l);
  Conditions at_largest{.load_N_per_m = largest_N / l, .reduced_radius_m = R, .reduced_modulus_Pa = modulus};
  EHD_CHECK(error(dry_approach_m(at_largest, linear.datum_m->inner), palmgren.approach(largest_N)),
            Tolerance::round_off(1000));
  BOOST_TEST(linear.fit->inner.points.size() == 6u);
  for (const bearing::FitPoint& point : linear.fit->inner.points) {
    Conditions conditions = at_largest;
    conditions.load_N_per_m = point.force_N / l;
    const double u_s = 0.0265 * (1 - std::pow(0.005 / 0.053, 2)) * 5000 * std::acos(-1) / 30;
    const double U = 0.02 * u_s / (modulus * R), M = conditions.load_N_per_m / (modulus * R) / std::sqrt(U);
    const double film_m = R * std::sqrt(U) * 2.4474842468 / M * std::pow(1 + std::pow(M / 0.25, 1.5), 0.58);
    EHD_CHECK(error(point.approach_m, dry_approach_m(conditions, linear.datum_m->inner) - film_m),
              Tolerance::round_off(1000, 10));
  }
}

// Invariant: the datum changes the approach, not the film.
BOOST_AUTO_TEST_CASE(another_datum_needs_no_other_contact) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(0);
  (void)run(one, {bearing::Law::ehd}, memory);
  const long solved = contacts.total;
  body_of(one).datum = LundbergDatum{};
  const auto results = run(one, {bearing::Law::ehd}, memory);
  BOOST_TEST(contacts.total == solved);
  EHD_CHECK(error(results.at(0).datum_m->inner, 0.122), Tolerance::round_off(1));
}

BOOST_AUTO_TEST_CASE(a_key_of_the_datum_that_its_law_does_not_read_is_noted) {
  Case one = needle_bearing(0);
  for (const char* key : {"datum.law", "datum.x0_m", "datum.load_N"}) one.places[key] = {.line = 20};
  const auto unread = [&](const Datum& datum, bearing::Law law) {
    body_of(one).datum = datum;
    ContactMemory memory(synthetic_contact);
    std::vector<std::string> found;
    for (const std::string& note : notes_of(run(one, {law}, memory).at(0)))
      if (note.find("has no effect") != std::string::npos) found.push_back(note);
    return found;
  };
  using Notes = std::vector<std::string>;
  const std::string x0 = "datum.x0_m has no effect: the datum's law is ", load = "datum.load_N has no effect: ";
  BOOST_TEST((unread(PalmgrenDatum{}, bearing::Law::ehd) == Notes{x0 + "palmgren, and only x0 reads it"}));
  BOOST_TEST((unread(LengthDatum{0.01}, bearing::Law::ehd) ==
              Notes{load + "the datum's law is x0, and only palmgren reads it"}));
  BOOST_TEST(unread(LundbergDatum{}, bearing::Law::ehd_linear).size() == 2U);
  BOOST_TEST(unread(LundbergDatum{}, bearing::Law::hertz).empty());  // a dry law has no datum
}

BOOST_AUTO_TEST_CASE(an_ehd_law_at_rest_is_refused_in_one_line) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(0);
  body_of(one).operation.inner_speed_rpm = 0;
  BOOST_CHECK_EXCEPTION((void)run(one, {bearing::Law::ehd}, memory), CaseError, [](const CaseError& error) {
    const std::string what = error.what();
    return what.starts_with("needle.toml:7: ") && what.find('\n') == std::string::npos;
  });
  BOOST_TEST((run(one, {bearing::Law::hertz}, memory).at(0).status == StopReason::converged));
  BOOST_TEST(contacts.total == 0);
}

BOOST_AUTO_TEST_CASE(a_dry_case_skips_ehd_laws_by_default_and_refuses_them_when_named) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(0);
  body_of(one).lubricant.reset();
  BOOST_TEST((default_laws(body_of(one)) == std::vector{bearing::Law::hertz}));
  BOOST_CHECK_THROW((void)run(one, {bearing::Law::ehd_linear}, memory), CaseError);
  const Plan plan = plan_bearing(body_of(one), {bearing::Law::hertz, bearing::Law::ehd});
  const auto skipped = std::find_if(plan.skipped.begin(), plan.skipped.end(),
                                    [](const SkippedStage& stage) { return stage.stage == bearing_stage::solves; });
  BOOST_REQUIRE(skipped != plan.skipped.end());
  BOOST_TEST(skipped->why == "the case has no lubricant");
}

// The range of a default fit follows the dry balance, to the bit, while the rollers are heavy enough for a contact to
// be solved. Below, the range is raised with a note: a bearing without a load has a line too. A stated range stays.
BOOST_AUTO_TEST_CASE(every_bearing_has_a_line_whatever_its_load) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const auto raised = [](const BearingResult& result) {
    const auto notes = notes_of(result);
    return std::count_if(notes.begin(), notes.end(),
                         [](const std::string& note) { return note.starts_with("fit raised to M = 0.01 at the "); });
  };
  const auto M_of = [](double force_N, bool inner) {
    const double R = 1 / (2 / 0.005 + (inner ? 2 / 0.048 : -2 / 0.058)), modulus = 2.06e11 / (1 - 0.09);
    const double u_s = 0.0265 * (1 - std::pow(0.005 / 0.053, 2)) * 5000 * std::acos(-1) / 30;
    return force_N / 0.122 / (modulus * R) / std::sqrt(0.02 * u_s / (modulus * R));
  };
  Case one = needle_bearing(0);
  body_of(one).fit = {.load_N = {}, .points = 6};
  for (const double load_N : {0.0, 1e-3, 0.5, 300.0}) {
    body_of(one).operation.radial_load_N = load_N;
    const BearingResult light = run(one, {bearing::Law::ehd_linear}, memory).at(0);
    BOOST_TEST((light.status == StopReason::converged), light.why);
    BOOST_REQUIRE(light.fit.has_value());
    BOOST_TEST(raised(light) == 2);
    for (const bool inner : {true, false}) {
      const auto& points = (inner ? light.fit->inner : light.fit->outer).points;
      EHD_CHECK(error(M_of(points.front().force_N, inner), 1e-2), Tolerance::round_off(1000));
      EHD_CHECK(error(points.back().force_N / points.front().force_N, 6), Tolerance::round_off(10));
    }
    EHD_CHECK(light.balance_error, Tolerance::required(1e-12, "what a balance promises"));
  }
  for (const double load_N : {1e3, 50e3}) {
    body_of(one).operation.radial_load_N = load_N;
    const auto heavy = run(one, {bearing::Law::hertz, bearing::Law::ehd_linear}, memory);
    const double largest_N = heavy.at(0).rollers.at(0).inner.force_N;
    BOOST_TEST(raised(heavy.at(1)) == 0);
    for (const auto& fit : {heavy.at(1).fit->inner, heavy.at(1).fit->outer}) {
      BOOST_TEST(fit.points.front().force_N == 0.2 * largest_N);
      BOOST_TEST(fit.points.back().force_N == 1.2 * largest_N);
    }
  }
  // Where the rollers press harder by themselves, the outer line is about that.
  body_of(one).operation = {.inner_speed_rpm = 30000, .outer_speed_rpm = 0, .radial_load_N = 1e3};
  const BearingResult spinning = run(one, {bearing::Law::ehd_linear}, memory).at(0);
  const double centrifugal_N =
      7850 * std::acos(-1) / 4 * 25e-6 * 0.122 * 0.0265 * std::pow((1 - 5.0 / 53) / 2 * 1000 * std::acos(-1), 2);
  EHD_CHECK(error(spinning.fit->outer.points.back().force_N, 1.2 * centrifugal_N), Tolerance::round_off(100));
  BOOST_TEST(spinning.fit->inner.points.back().force_N < spinning.fit->outer.points.back().force_N);
  // Stated, it stands.
  one = needle_bearing(0);
  body_of(one).fit.load_N = std::pair{0.1, 0.6};
  const BearingResult refused = run(one, {bearing::Law::ehd_linear}, memory).at(0);
  BOOST_TEST((refused.status == StopReason::diverged));
  BOOST_TEST(refused.rollers.empty());
  BOOST_TEST(refused.why.find("at a contact force of 0.1 N: M = ") != std::string::npos, refused.why);
  BOOST_TEST(refused.why.find("is out of range") != std::string::npos, refused.why);
}

// A case is judged by its own contacts, not by what another case has left in the memory that they share.
BOOST_AUTO_TEST_CASE(what_another_case_left_in_the_memory_is_not_judged) {
  const auto solver = [](StopReason heavy) {
    return [heavy](const Problem& problem, const Request&) {
      Solution solution = verification::made::contact(problem);
      if (problem.groups.M < 9) return solution;  // 13 kN, above what the light case needs
      solution.record.status = heavy;
      solution.observables[Quantity::film_minimum].error = 5e-3;
      return solution;
    };
  };
  const std::vector laws{bearing::Law::ehd_linear, bearing::Law::ehd};
  Case heavy = needle_bearing(0), light = needle_bearing(0);
  heavy.id = "heavy";
  body_of(heavy).operation.radial_load_N = 200e3;
  body_of(heavy).fit = body_of(light).fit = {.load_N = {}, .points = 6};
  body_of(light).operation.radial_load_N = 20e3;
  for (const StopReason end : {StopReason::tolerance_not_met, StopReason::limit_reached, StopReason::diverged}) {
    ContactMemory shared(solver(end)), own(solver(end));
    for (const BearingResult& result : run(heavy, laws, shared)) BOOST_TEST((result.status == end));
    const auto after = run(light, laws, shared), alone = run(light, laws, own);
    for (std::size_t k = 0; k < laws.size(); ++k) {
      BOOST_TEST((after[k].status == StopReason::converged), after[k].why);
      BOOST_TEST(after[k].why == alone[k].why);
      BOOST_TEST(notes_of(after[k]) == notes_of(alone[k]), boost::test_tools::per_element());
      BOOST_TEST(after[k].displacement_m == alone[k].displacement_m);
    }
    // And the other way round: remembered contacts that missed their tolerance count in this case too.
    for (const BearingResult& result : run(heavy, laws, shared)) BOOST_TEST((result.status == end));
    // A law that fails for another reason has not come to a limit.
    Case refused = light;
    body_of(refused).fit.load_N = std::pair{0.1, 0.6};
    BOOST_TEST((run(refused, {bearing::Law::ehd_linear}, shared).at(0).status == StopReason::diverged));
  }
}

// A curve that ends where a limit stopped a contact is worse than what was asked for, and more time would mend it. The
// same end for another reason is the best that there is.
BOOST_AUTO_TEST_CASE(a_limit_that_ends_a_film_curve_is_the_status) {
  constexpr double lightest_M = 0.2;  // of those that are solved; Martin's films take over far below
  const std::vector laws{bearing::Law::ehd_linear, bearing::Law::ehd};
  for (const StopReason end : {StopReason::limit_reached, StopReason::diverged}) {
    ContactMemory memory([end](const Problem& problem, const Request&) {
      Solution solution = verification::made::contact(problem);
      if (problem.groups.M < lightest_M) solution.record.status = end;
      return solution;
    });
    const bool limit = end == StopReason::limit_reached;
    for (const BearingResult& result : run(needle_bearing(0), laws, memory)) {
      BOOST_REQUIRE(result.curve.has_value());
      BOOST_TEST(result.curve->inner.errors().joint > 2e-3);
      BOOST_TEST((result.status == (limit ? StopReason::limit_reached : StopReason::converged)), result.why);
      BOOST_TEST((result.why == "the limit on iterations or time ended contacts of the film curves") == limit);
      BOOST_TEST(!result.rollers.empty());
    }
  }
}

// The films beside a line need lighter contacts than the line.
BOOST_AUTO_TEST_CASE(a_line_whose_films_a_limit_ended_says_so) {
  for (const StopReason end : {StopReason::limit_reached, StopReason::diverged}) {
    int solved = 0;
    ContactMemory memory([&](const Problem& problem, const Request&) {
      Solution solution = verification::made::contact(problem);
      if (++solved > 12) solution.record.status = end;  // the six of each line
      return solution;
    });
    const BearingResult result = run(needle_bearing(0), {bearing::Law::ehd_linear}, memory).at(0);
    const bool limit = end == StopReason::limit_reached;
    BOOST_TEST(!result.curve.has_value());
    BOOST_TEST(!result.rollers.empty());
    BOOST_TEST((result.status == (limit ? StopReason::limit_reached : StopReason::converged)), result.why);
  }
}

// A law first asks its contacts for a tenth of the error that it can bear. If that fails, it asks for the error that it
// can bear, which is enough.
BOOST_AUTO_TEST_CASE(a_contact_that_misses_what_is_asked_for_is_asked_for_what_is_needed) {
  constexpr double needed = 1e-3;
  for (const bool met : {true, false}) {
    int fine = 0, coarse = 0;
    ContactMemory memory(
        [&](const Problem& problem, const Request& request) {
          const bool enough = request.tolerance.tightest() >= needed;
          (enough ? coarse : fine) += 1;
          Solution solution = verification::made::contact(problem);
          if (enough && met) return solution;
          solution.record.status = StopReason::tolerance_not_met;
          solution.observables[Quantity::film_minimum].error = 5e-3;
          return solution;
        },
        bearing_contact_request());
    const Case one = needle_bearing(0);
    const BearingResult result = run(one, {bearing::Law::ehd}, memory).at(0);
    BOOST_TEST((result.status == (met ? StopReason::converged : StopReason::tolerance_not_met)), result.why);
    BOOST_TEST((notes_of(result).back() == result.why) == !met);
    BOOST_TEST(human_table(one, {result}).find("no balance") == std::string::npos);
    BOOST_TEST(fine > 0);
    BOOST_TEST(coarse == fine);
  }
}

// Every skipped stage has its reason, and no stage is both run and skipped.
BOOST_AUTO_TEST_CASE(a_plan_gives_a_reason_for_every_skip) {
  const Case one = needle_bearing(0);
  for (const auto& laws :
       {std::vector{bearing::Law::hertz}, {bearing::Law::ehd_linear}, {bearing::Law::iso, bearing::Law::ehd}}) {
    const Plan plan = plan_bearing(std::get<BearingCase>(one.body), laws);
    BOOST_TEST(!plan.run.empty());
    for (const SkippedStage& skipped : plan.skipped) {
      BOOST_TEST(!skipped.why.empty());
      BOOST_TEST(!plan.runs(skipped.stage));
    }
  }
}

// A contact that is not solved leaves the law without a balance, and says which contact.
BOOST_AUTO_TEST_CASE(a_failing_contact_is_no_balance) {
  ContactMemory memory([](const Problem&, const Request&) {
    Solution solution;
    solution.record.status = StopReason::diverged;
    solution.record.reason = "no start was admissible";
    return solution;
  });
  for (const BearingResult& result : run(needle_bearing(0), {bearing::Law::ehd_linear, bearing::Law::ehd}, memory)) {
    BOOST_TEST((result.status == StopReason::diverged));
    BOOST_TEST(result.rollers.empty());
    BOOST_TEST(result.why.find("no start was admissible") != std::string::npos);
    BOOST_TEST(!to_json(result).contains("rollers"));
  }
}

// The JSON has what interface.md names, numbers only, and nothing null.
BOOST_AUTO_TEST_CASE(the_json_is_complete_and_finite) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const Case one = needle_bearing(10e-6);
  for (const BearingResult& result : run(one, default_laws(std::get<BearingCase>(one.body)), memory)) {
    const Json json = to_json(result);
    for (const char* key : {"case", "version", "law", "displacement_m", "displacement_lateral_m", "load_zone_deg",
                            "stiffness_N_per_m", "rollers", "balance_error", "cost", "plan", "notes"})
      BOOST_TEST(json.contains(key), key);
    BOOST_TEST(json.dump().find("null") == std::string::npos);
    BOOST_TEST(json.contains("fit") == (result.law == bearing::Law::ehd_linear));
    BOOST_TEST(json["rollers"].size() == 22u);
    BOOST_TEST(json["stiffness_N_per_m"][0].size() == 2u);
    BOOST_TEST(json["stiffness_N_per_m"][0][0].get<double>() > 1e8);
    BOOST_TEST(json["load_zone_deg"][0].get<double>() == -json["load_zone_deg"][1].get<double>());
    BOOST_TEST(!json.contains("cage"));
    BOOST_TEST(!json["rollers"][0]["inner"].contains("lambda_ratio"));
    BOOST_TEST(json["cost"].contains("contact_solves"));
    EHD_CHECK(json["balance_error"].get<double>(), Tolerance::required(1e-12, "what a balance promises"));
  }
}

// Notes: the fit outside its range, a lambda ratio below one, pressures that no steel bears.
BOOST_AUTO_TEST_CASE(notes_say_what_a_reader_should_know) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const auto noted = [](const BearingResult& result, const std::string& words) {
    const auto notes = notes_of(result);
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
  };
  Case one = needle_bearing(10e-6);
  body_of(one).roughness_m = 2e-6;
  const auto rough = run(one, {bearing::Law::ehd_linear}, memory).at(0);
  BOOST_TEST(noted(rough, "fit used outside its range"));
  BOOST_TEST(noted(rough, "lambda ratio"));
  BOOST_REQUIRE(rough.rollers[0].outer.lambda_ratio.has_value());
  EHD_CHECK(error(*rough.rollers[0].outer.lambda_ratio, *rough.rollers[0].outer.film_minimum_m / 2e-6),
            Tolerance::round_off(1));
  BOOST_TEST(to_json(rough)["rollers"][0]["outer"].contains("lambda_ratio"));
  BOOST_TEST(noted(rough, "cut at delta = 0"));
  body_of(one).geometry.length_m = 0.005;
  BOOST_TEST(noted(run(one, {bearing::Law::hertz}, memory).at(0), "4 GPa"));
}

// Loaded rollers: a hundredth of the largest force or more, with every law and in every place that counts them.
BOOST_AUTO_TEST_CASE(loaded_rollers_carry_a_hundredth_of_the_largest_force) {
  std::vector<RollerRow> rollers(5);
  rollers[0].inner.force_N = 1000;
  rollers[1].inner.force_N = 10;
  rollers[2].inner.force_N = 9.99;
  rollers[3].inner.force_N = 1e-3;
  BOOST_TEST(loaded_rollers(rollers) == 2);
  BOOST_TEST(loaded_rollers(std::vector<RollerRow>(3)) == 0);
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  for (const BearingResult& result :
       run(needle_bearing(10e-6), {bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd}, memory)) {
    const auto [from, to] = result.load_zone_deg.value();
    int inside = 0, pushing = 0;
    for (const RollerRow& row : result.rollers) {
      inside += row.azimuth_deg >= from && row.azimuth_deg <= to ? 1 : 0;
      pushing += row.inner.force_N > 0 ? 1 : 0;
    }
    BOOST_TEST(to_json(result)["loaded_rollers"].get<int>() == inside);
    if (result.law == bearing::Law::ehd) BOOST_TEST(pushing > inside);
  }
}

// A film-dominated bearing: its contacts are rigid rollers with f ~ 1/film, which no line describes. That is said
// first, with the number, and in the JSON.
BOOST_AUTO_TEST_CASE(a_line_that_does_not_describe_its_contacts_says_so_first) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case light = needle_bearing(10e-6);
  body_of(light).operation.radial_load_N = 20;
  body_of(light).fit = {};
  const auto poor = run(light, {bearing::Law::ehd_linear}, memory).at(0);
  BOOST_REQUIRE(poor.fit.has_value());
  const double misfit = poor.fit->inner.residual_N / poor.fit->inner.points.back().force_N;
  BOOST_TEST(misfit > 0.15);
  const Json json = to_json(poor);
  BOOST_TEST(json["fit"]["inner"]["misfit"].get<double>() == misfit);
  BOOST_TEST(!json["fit"]["inner"]["describes_contacts"].get<bool>());
  const auto first = json["notes"][0].get<std::string>();
  BOOST_TEST(first.starts_with("the line does not describe its inner contacts: it misses them by up to "), first);
  // It misses the contacts of the bearing by more than the points of its fit.
  BOOST_TEST(poor.fit->inner.in_use->misfit() > misfit);
  BOOST_TEST(first.find(plain(100 * poor.fit->inner.in_use->misfit(), 2) + " % of the heaviest") != std::string::npos,
             first);
  BOOST_TEST(json["notes"][1].get<std::string>().starts_with("the line does not describe its outer contacts"));

  const Json good = to_json(run(needle_bearing(10e-6), {bearing::Law::ehd_linear}, memory).at(0));
  BOOST_TEST(good["fit"]["inner"]["describes_contacts"].get<bool>());
  BOOST_TEST(good["fit"]["inner"]["misfit"].get<double>() <= bearing::largest_misfit);
  for (const auto& note : good["notes"])
    BOOST_TEST(note.get<std::string>().find("does not describe") == std::string::npos, note.get<std::string>());
}

// The line fits its own contacts to 1 %, but the bearing loads others. Where these are not solved, nothing is known.
BOOST_AUTO_TEST_CASE(a_line_that_does_not_describe_the_loads_it_is_used_at_says_so_first) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  for (const double load_N : {500.0, 1e6}) {
    Case one = needle_bearing(10e-6);
    body_of(one).operation.radial_load_N = load_N;
    const Json json = to_json(run(one, {bearing::Law::ehd_linear}, memory).at(0));
    const Json& line = json["fit"]["inner"];
    BOOST_TEST(line["misfit"].get<double>() < 0.02);
    BOOST_TEST(line["in_use"]["misfit"].get<double>() > 0.15);
    BOOST_TEST(!line["describes_contacts"].get<bool>());
    double heaviest_N = 0;
    for (const Json& roller : json["rollers"])
      heaviest_N = std::max(heaviest_N, roller["inner"]["force_N"].get<double>());
    BOOST_TEST(line["in_use"]["load_N"][1].get<double>() == heaviest_N);
    const auto first = json["notes"][0].get<std::string>();
    BOOST_TEST(first.starts_with("the line does not describe its inner contacts: they carry "), first);
    BOOST_TEST(first.find("fitted from 2000 to 12000 N") != std::string::npos, first);

    const auto without_films = run_bearing(one, {.laws = {bearing::Law::ehd_linear}, .films = false}, memory).at(0);
    BOOST_TEST(!without_films.fit->inner.describes_contacts());
    BOOST_TEST(notes_of(without_films).at(0).starts_with("the line may not describe its inner contacts"));
  }
}

// The line lets go of contacts that ehd still loads. Where ehd is balanced too, the line is judged at these as well.
BOOST_AUTO_TEST_CASE(a_line_is_judged_at_the_contacts_that_it_lets_go) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  const Case one = needle_bearing(4e-6);
  const auto alone = run(one, {bearing::Law::ehd_linear}, memory).at(0);
  const auto both = run(one, {bearing::Law::ehd_linear, bearing::Law::ehd}, memory);
  const bearing::LineInUse by_line = alone.fit->inner.in_use.value(), use = both[0].fit->inner.in_use.value();
  double lightest_N = by_line.lightest_N, missed_N = by_line.residual_N;
  for (std::size_t j = 0; j < both[1].rollers.size(); ++j) {
    const ContactRow& at = both[1].rollers[j].inner;
    if (both[0].rollers[j].inner.force_N > 0 || at.force_N < 0.01 * by_line.heaviest_N) continue;
    lightest_N = std::min(lightest_N, at.force_N);
    missed_N = std::max(missed_N, std::abs(at.force_N - alone.fit->inner.law().force(at.displacement_m)));
  }
  BOOST_TEST(lightest_N < 0.1 * by_line.lightest_N);
  BOOST_TEST(use.lightest_N == lightest_N);
  BOOST_TEST(use.heaviest_N == by_line.heaviest_N);
  BOOST_TEST(use.residual_N == missed_N);
  BOOST_TEST(alone.fit->inner.describes_contacts());
  BOOST_TEST(!both[0].fit->inner.describes_contacts());
  BOOST_TEST(
      notes_of(both[0]).front().starts_with("the line does not describe its inner contacts: they carry 130.2 to "));
}

// Bad input: a load that gives a roller more than the largest M that is solved. The dry laws carry it.
BOOST_AUTO_TEST_CASE(a_load_beyond_every_film_is_refused_in_one_line) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(0);
  one.places["operation.radial_load_N"] = {12, "1e12"};
  body_of(one).operation.radial_load_N = 1e12;
  for (const bearing::Law law : {bearing::Law::ehd_linear, bearing::Law::ehd})
    BOOST_CHECK_EXCEPTION((void)run(one, {law}, memory), CaseError, [](const CaseError& error) {
      const std::string what = error.what();
      return what.starts_with("needle.toml:12: radial_load_N = 1e12: ") && what.find("M = 1e6,") != std::string::npos &&
             what.find("; allowed ") != std::string::npos && what.find('\n') == std::string::npos;
    });
  BOOST_TEST(contacts.total == 0);
  BOOST_TEST((run(one, {bearing::Law::hertz}, memory).at(0).status == StopReason::converged));
}

// Bad input: an oil so thick, as one too cold is, that L is out of range at every force.
BOOST_AUTO_TEST_CASE(an_oil_beyond_every_film_is_refused_in_one_line) {
  CountedContacts contacts;
  ContactMemory memory(contacts.solver());
  Case one = needle_bearing(0);
  one.places["lubricant"] = {20};
  body_of(one).lubricant->viscosity_Pa_s = 500;
  BOOST_CHECK_EXCEPTION((void)run(one, {bearing::Law::ehd}, memory), CaseError, [](const CaseError& error) {
    const std::string what = error.what();
    return what.starts_with("needle.toml:20: [lubricant]: ") &&
           what.find("at the inner raceway L = ") != std::string::npos &&
           what.find("; allowed is 0 to 100") != std::string::npos && what.find('\n') == std::string::npos;
  });
  BOOST_TEST(contacts.total == 0);
  BOOST_TEST((run(one, {bearing::Law::hertz}, memory).at(0).status == StopReason::converged));
}

// Published: the first balance of NA4908 in paper.md (Palmgren datum, fit over 2..12 kN), two digits; the films there
// come from another program.
BOOST_AUTO_TEST_CASE(the_needle_bearing_of_the_first_balance) {
  const fast::Uniform solver;
  ContactMemory memory([&](const Problem& problem, const Request& request) { return solver.solve(problem, request); });
  struct Printed {
    double clearance_m, dry_N, linear_N, linear_um;
  };
  for (const Printed& printed :
       {Printed{0, 9285, 8752, 2.44}, {2.5e-6, 9816, 9280, 2.61}, {10e-6, 11199, 10682, 3.06}}) {
    const auto results =
        run(needle_bearing(printed.clearance_m), {bearing::Law::hertz, bearing::Law::ehd_linear}, memory);
    BOOST_REQUIRE((results.at(1).status == StopReason::converged));
    const Tolerance two_digits = Tolerance::required(5e-3, "paper.md: two digits");
    EHD_CHECK(error(results[0].rollers[0].inner.force_N, printed.dry_N), two_digits);
    EHD_CHECK(error(results[1].rollers[0].inner.force_N, printed.linear_N), two_digits);
    EHD_CHECK(error(1e6 * results[1].rollers[0].inner.displacement_m, printed.linear_um), two_digits);
    EHD_CHECK(error(results[1].fit->inner.K_N_per_m, 3.10e9), two_digits);
  }
}

BOOST_AUTO_TEST_CASE(the_load_zone_follows_from_clearance_and_displacement) {
  BearingResult result;
  result.displacement_m = 10e-6;
  EHD_CHECK(error(geometric_load_zone_deg(result, 10e-6)->second, 60), Tolerance::round_off(64));
  EHD_CHECK(error(geometric_load_zone_deg(result, 0)->second, 90), Tolerance::round_off(64));
  EHD_CHECK(error(geometric_load_zone_deg(result, -1e-3)->second, 180), Tolerance::round_off(64));
  BOOST_TEST(!geometric_load_zone_deg(result, 21e-6).has_value());
  result.displacement_lateral_m = 10e-6;  // the ring moves towards 45 degrees
  const auto zone = geometric_load_zone_deg(result, 0).value();
  EHD_CHECK(error(zone.first, -45), Tolerance::round_off(64));
  EHD_CHECK(error(zone.second, 135), Tolerance::round_off(64));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd
