// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_memory.hpp"

#include <atomic>
#include <memory>
#include <variant>

#include "bearing/fit.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/bearing_of_case.hpp"

using namespace ehd;
using verification::made::needle_bearing;

namespace {

struct Needle {
  Case one = needle_bearing(0);
  const BearingCase& body = std::get<BearingCase>(one.body);
  bearing::RacewayContact contact = raceway_contacts_of(body).inner;
  const Lubricant& oil = body.lubricant->lubricant;
};

/// A solver in closed form that counts its calls.
ContactSolver counted(long& calls) {
  return [&calls](const Problem& problem, const Request&) {
    ++calls;
    return verification::made::contact(problem);
  };
}

constexpr double heaviest_N = 11e3;

}  // namespace

BOOST_AUTO_TEST_SUITE(contact_memory)

// Counter: no contact is solved twice, by a second curve or a fit.
BOOST_AUTO_TEST_CASE(equal_contacts_are_solved_once) {
  const Needle needle;
  long calls = 0;
  ContactMemory memory(counted(calls));
  const bearing::SolvableContact contacts = memory.of(needle.contact, needle.oil);
  const bearing::CurveRequest request{.heaviest_N = heaviest_N};
  BOOST_REQUIRE(std::holds_alternative<bearing::FilmCurve>(bearing::build_curve(contacts, request)));
  const long solved = calls;
  BOOST_TEST(solved == memory.solves());
  BOOST_REQUIRE(std::holds_alternative<bearing::FilmCurve>(bearing::build_curve(contacts, request)));
  BOOST_TEST(calls == solved);
  for (const double datum_m : {0.02, 0.03}) {
    const auto fit = bearing::fit_contacts(contacts, datum_m, 2000, 12000, 6);
    BOOST_REQUIRE(std::holds_alternative<bearing::LinearFit>(fit));
    BOOST_TEST(calls == solved + 6);
  }
  BOOST_TEST(memory.solves() == solved + 6);
  BOOST_TEST(memory.recalls() > 0);
}

// Counter: a curve that is used again counts its points as recalled.
BOOST_AUTO_TEST_CASE(equal_curves_are_built_once) {
  const Needle needle;
  long calls = 0;
  ContactMemory memory(counted(calls));
  const auto& first = memory.curve(needle.contact, needle.oil, {.heaviest_N = heaviest_N});
  const long solved = calls, recalled = memory.recalls();
  const auto& second =
      memory.curve(needle.contact, needle.oil, {.heaviest_N = heaviest_N + 1});  // the same power of two
  BOOST_TEST(&first == &second);
  BOOST_TEST(calls == solved);
  const auto points = static_cast<long>(std::get<bearing::FilmCurve>(first).forces_N().size());
  BOOST_TEST(memory.recalls() == recalled + points);
}

// Counter: each run over a shared cache reports the contacts that it would solve alone.
BOOST_AUTO_TEST_CASE(each_run_over_a_shared_cache_counts_its_own_contacts) {
  const Needle needle;
  long calls = 0;
  const auto cache = std::make_shared<ContactCache>(with_fallback(counted(calls)));
  ContactMemory one(cache), other(cache);
  const auto& first = one.curve(needle.contact, needle.oil, {.heaviest_N = heaviest_N});
  const auto& second = other.curve(needle.contact, needle.oil, {.heaviest_N = heaviest_N});
  BOOST_TEST(one.solves() == calls);
  BOOST_TEST(other.solves() == calls);
  BOOST_TEST(one.recalls() == other.recalls());
  BOOST_TEST(cache->solves() == calls);
  BOOST_TEST((std::get<bearing::FilmCurve>(first).forces_N() == std::get<bearing::FilmCurve>(second).forces_N()));
}

// Regression: in a shared cache the second request of a contact once got the answer of the first.
BOOST_AUTO_TEST_CASE(the_fallback_asks_the_solver_again) {
  const Needle needle;
  int fine = 0, coarse = 0;
  const auto cache = std::make_shared<ContactCache>(with_fallback([&](const Problem& problem, const Request& request) {
    Solution solution = verification::made::contact(problem);
    const bool enough = request.tolerance.tightest() >= 1e-3;
    ++(enough ? coarse : fine);
    if (!enough) solution.record.status = StopReason::tolerance_not_met;
    if (!enough) solution.observables[Quantity::film_minimum].error = 5e-3;
    return solution;
  }));
  ContactMemory memory(cache);
  const bearing::ContactResult solved = memory.of(needle.contact, needle.oil).at(5000);
  BOOST_REQUIRE(std::holds_alternative<bearing::SolvedContact>(solved));
  BOOST_TEST(std::get<bearing::SolvedContact>(solved).converged);
  BOOST_TEST(fine == 1);
  BOOST_TEST(coarse == 1);
  BOOST_TEST(cache->solves() == 1);  // contacts, not calls of the solver
}

BOOST_AUTO_TEST_SUITE_END()
