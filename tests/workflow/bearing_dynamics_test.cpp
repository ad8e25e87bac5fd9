// SPDX-License-Identifier: GPL-3.0-or-later
// A bearing in motion with contacts and responses in closed form.
#include "workflow/bearing_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bearing/law_table.hpp"
#include "bearing/response_curve.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "io/bearing_csv.hpp"
#include "io/bearing_json.hpp"
#include "io/bearing_table.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "workflow/law_export.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

using std::numbers::pi;
using verification::Tolerance;
using verification::made::needle_bearing;

Solution made_solution(const Problem& problem, const Request&) {
  Solution solution = verification::made::contact(problem);
  // Martin's rolling force in Hertz units, F_t R/(p_H b^2) = 1.4475/M
  solution.observables[Quantity::rolling_force] = {.value = 1.4475 / problem.groups.M, .error = 1e-6};
  return solution;
}

/// kappa_0 as the slope of the made solutions, pi/(-1/2 - 2 H_0 - 2 M dH_0/dM); kappa_1 a tenth of it, and at a
/// frequency both fall by Omega^2.
Response made_response(const Problem& problem, const ResponseRequest& request) {
  const auto offset = [&](double M) {
    Problem other = problem;
    other.groups.M = M;
    return verification::made::contact(other).observables.at(Quantity::film_offset).value;
  };
  const double M = problem.groups.M, step = 1e-4;
  const double slope = (offset(M * (1 + step)) - offset(M * (1 - step))) / (2 * step);
  const double kappa_0 = pi / (-0.5 - 2 * offset(M) - 2 * slope);
  Response response{.status = StopReason::converged,
                    .reason = {},
                    .slow = SlowStiffness{.kappa_0 = kappa_0,
                                          .kappa_1 = kappa_0 / 10,
                                          .error_0 = 1e-8,
                                          .error_1 = 1e-7,
                                          .lag = 1 / kappa_0 / 10,
                                          .lag_error = 1e-7}};
  for (const double Omega : request.frequencies)
    response.frequencies.push_back({.Omega = Omega,
                                    .kappa = kappa_0 * (1 - Omega * Omega) * std::complex<double>(1, Omega / 10),
                                    .error = 1e-8,
                                    .lag_error = 1e-7,
                                    .status = StopReason::converged});
  return response;
}

ContactMemory made_memory() {
  ContactMemory memory(made_solution);
  memory.respond_by(made_response);
  return memory;
}

BearingResult moved(const Case& one, bearing::Law law, const std::vector<double>& frequencies_Hz,
                    ContactMemory& memory) {
  return run_bearing(one, {.laws = {law}, .explicitly = true, .frequencies_Hz = frequencies_Hz}, memory).at(0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_dynamics)

// Exact: kappa(0) is the slope of the load, so that the ring at rest is as stiff as its balance says.
BOOST_AUTO_TEST_CASE(at_rest_the_stiffness_is_that_of_the_balance) {
  ContactMemory memory = made_memory();
  Case one = needle_bearing(3e-6);
  std::get<BearingCase>(one.body).geometry.first_azimuth_deg = 3;
  const BearingResult result = moved(one, bearing::Law::ehd, {0}, memory);
  BOOST_REQUIRE(result.dynamics.size() == 1u);
  const bearing::RingMotion& ring = result.dynamics[0].ring;
  const auto& K = result.stiffness_N_per_m;
  const double trace = K[0][0] + K[1][1];
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      EHD_CHECK(std::abs(ring.stiffness_N_per_m[i][j] - K[i][j]) / trace,
                Tolerance::required(5e-3, "slopes of a curve that is known to 1e-3"));
  BOOST_REQUIRE(result.stiffness_error_N_per_m.has_value());
  EHD_CHECK(std::abs(ring.stiffness_N_per_m[0][0] - K[0][0]),
            Tolerance::required(*result.stiffness_error_N_per_m, "its stated error"));
  EHD_CHECK(*result.stiffness_error_N_per_m, Tolerance::required(0.03 * K[0][0], "two digits"));
  BOOST_TEST(ring.stiffness_N_per_m[0][1] == ring.stiffness_N_per_m[1][0]);
  BOOST_TEST(std::abs(K[0][1]) > 1e-4 * trace);  // the cage is not symmetric to the load
  BOOST_TEST(ring.damping_N_s_per_m.has_value());
  EHD_CHECK(ring.error, Tolerance::required(0.01, "half of what a bearing in motion may state"));
}

BOOST_AUTO_TEST_CASE(the_json_has_kappa_of_slow_motion_over_the_force) {
  ContactMemory memory = made_memory();
  const BearingResult result = moved(needle_bearing(0), bearing::Law::ehd, {0}, memory);
  const Json json = to_json(result);
  for (const bearing::Raceway raceway : bearing::both_raceways) {
    const Json& response = json.at("curve").at(std::string(to_string(raceway))).at("response");
    BOOST_REQUIRE(result.response.has_value());
    const bearing::ResponseCurve& curve = result.response->at(raceway);
    for (const char* key : {"force_N", "kappa_0", "kappa_0_error", "kappa_1", "kappa_1_error"})
      BOOST_TEST(response.at(key).size() == curve.forces_N().size(), key);
    const double last_N = curve.forces_N().back();
    BOOST_TEST(response.at("kappa_0").back().get<double>() == curve.slow(last_N).stiffness);
    BOOST_TEST(response.at("kappa_1").back().get<double>() == curve.slow(last_N).damping);
    BOOST_TEST(response.at("datum_m").get<double>() == 0.122);
  }
  const Json still = to_json(moved(needle_bearing(0), bearing::Law::ehd, {}, memory));
  BOOST_TEST(!still.at("curve").at("inner").contains("response"));
}

// Counter: 22 rollers in mirrored pairs have 12 contacts a raceway, those below the curve none of their own; four more
// continue the curve to light loads. Many clearances share a curve through all loads.
BOOST_AUTO_TEST_CASE(responses_are_solved_once_and_at_the_loads_of_the_rollers_alone) {
  ContactMemory memory = made_memory();
  const auto responses = [&](double clearance_m) {
    return moved(needle_bearing(clearance_m), bearing::Law::ehd, {0, 100}, memory).responses;
  };
  const long first = responses(0);
  BOOST_TEST(first > 0);
  BOOST_TEST(first <= 2 * (12 + 4));
  BOOST_TEST(responses(0) == 0);
  BOOST_TEST(memory.responses() == first);
  for (const double clearance_m : {1e-6, 2e-6, 3e-6, 4e-6}) BOOST_TEST(responses(clearance_m) > 0);
  for (const double clearance_m : {5e-6, 6e-6, 0.0}) BOOST_TEST(responses(clearance_m) == 0);
}

// At a frequency that is not slow, the response at that frequency counts; the mass of the rollers too.
BOOST_AUTO_TEST_CASE(a_fast_motion_asks_for_its_own_response) {
  ContactMemory memory = made_memory();
  const Case one = needle_bearing(0);
  const BearingResult result = moved(one, bearing::Law::ehd, {0, 3000}, memory);
  BOOST_REQUIRE(result.dynamics.size() == 2u);
  const double f = result.rollers[0].inner.force_N, l = 0.122, modulus = 2.06e11 / 0.91;
  const double b = std::sqrt(8 * f / l / (2 / 0.005 + 2 / 0.048) / (pi * modulus));
  const double u_m = 0.053 / 4 * (1 - std::pow(5.0 / 53, 2)) * 5000 * pi / 30, Omega = 2 * pi * 3000 * b / u_m;
  const double datum = 4 / (pi * modulus * l) * std::log(result.datum_m->inner / b);
  const auto film = [&](const bearing::ContactMotion& contact, double omega) {  // without the datum
    return 1.0 / (1.0 / std::complex(contact.stiffness_N_per_m, omega * *contact.damping_N_s_per_m) - datum);
  };
  const auto slow = film(result.dynamics[0].rollers[0].inner, 0),
             fast = film(result.dynamics[1].rollers[0].inner, 2 * pi * 3000);
  const Tolerance curve = Tolerance::required(5e-3, "the curve's bound of 2e-3, through the datum");
  EHD_CHECK(error(fast.real() / slow.real(), 1 - Omega * Omega), curve);
  EHD_CHECK(error(fast.imag() / slow.real(), (1 - Omega * Omega) * Omega / 10), curve);
}

// An error of the film is one of the force by the film's part of the approach, and of the motion by as much as the
// stiffness changes over that force.
BOOST_AUTO_TEST_CASE(the_error_of_the_films_counts_in_motion_by_their_part_of_the_approach) {
  const auto at_rest = [](double stated) {
    ContactMemory memory(
        [stated](const Problem& problem, const Request&) { return verification::made::contact(problem, stated); });
    memory.respond_by(made_response);
    return moved(needle_bearing(0), bearing::Law::ehd, {0}, memory);
  };
  constexpr double stated = 1e-3;
  const BearingResult exact = at_rest(1e-12), result = at_rest(stated);
  const auto force_of = [&](std::size_t j) { return result.rollers[j].inner.force_N; };
  const auto& rollers = result.dynamics.at(0).rollers;
  const double K = rollers[0].inner.stiffness_N_per_m;
  const double power = std::log(K / rollers[1].inner.stiffness_N_per_m) / std::log(force_of(0) / force_of(1));
  const bearing::FilmCurve& curve = result.curve->inner;
  const double part = curve.offset_film(force_of(0)).value / curve.rise_m(force_of(0));
  BOOST_TEST(part < 0.3);
  const double grown = rollers[0].inner.stiffness_error - exact.dynamics.at(0).rollers[0].inner.stiffness_error;
  EHD_CHECK(error(grown, power * K * bearing::force_error_by_datum * stated * part),
            Tolerance::required(0.2, "the stiffness as a power of the force between two rollers"));
}

// The certified solver takes a hundred times as long. A spike that no grid resolves is no reason to call it.
BOOST_AUTO_TEST_CASE(a_heavy_contact_of_a_bearing_is_answered_by_the_default_solver) {
  const Lubricant oil{
      .viscosity = ViscosityLaw::roelands, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = 2.2e-8, .z = 0.68};
  const Problem problem = nondimensionalise(MoesGroups{8, 22}, oil, Flooded{}).problem;
  const Response found = bearing_responder()(problem, bearing_response_request());
  BOOST_REQUIRE(found.slow.has_value());
  BOOST_TEST(found.cost.krylov_iterations > 0);  // `reference` has none
  EHD_CHECK(found.slow->lag_error, Tolerance::required(1e-2, "half of the 2 % that the damping of a bearing may err"));
}

// At this frequency the first two asks of `fast` leave too large an error of the lag; the third one does not.
BOOST_AUTO_TEST_CASE(the_default_solver_is_asked_a_third_time_before_the_certified_one) {
  const Lubricant oil{
      .viscosity = ViscosityLaw::roelands, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = 2.2e-8, .z = 0.68};
  const Problem problem = nondimensionalise(MoesGroups{20, 20}, oil, Flooded{}).problem;
  ResponseRequest request = bearing_response_request();
  request.frequencies = {0.5};
  const Response found = bearing_responder()(problem, request);
  request.tolerance /= 4;
  const Response second = default_solver().respond(problem, request);
  BOOST_TEST(found.cost.krylov_iterations > 0);  // `reference` has none
  BOOST_TEST(found.cost.nodes > second.cost.nodes);
  BOOST_REQUIRE(found.frequencies.size() == 1u);
  EHD_CHECK(std::abs(found.frequencies[0].lag()) * found.frequencies[0].lag_error,
            Tolerance::required(1e-2 * std::hypot(found.frequencies[0].lag(), bearing::lag_scale(20)),
                                "half of the 2 % that the damping of a bearing may err"));
}

// Light contacts have a smaller Omega at the same frequency; Omega = 1 is 25 kHz at the heaviest.
// Unloaded rollers resonate near 10 kHz, and errors are large there; so the bearing is known at 5 and 11 kHz.
BOOST_AUTO_TEST_CASE(a_frequency_that_is_not_known_ends_with_a_lower_one_that_is) {
  const auto why = [](const std::vector<double>& frequencies_Hz, double known_up_to = 0.5) {
    ContactMemory memory(made_solution);
    memory.respond_by([known_up_to](const Problem& problem, const ResponseRequest& request) {
      Response response = made_response(problem, request);
      for (Stiffness& at : response.frequencies)
        if (at.Omega > known_up_to) at.lag_error = 0.1;
      if (known_up_to == 0) response.slow->lag_error = 0.1;
      return response;
    });
    const BearingResult result = moved(needle_bearing(0), bearing::Law::ehd, frequencies_Hz, memory);
    BOOST_TEST((result.status == StopReason::tolerance_not_met));
    return result.why;
  };
  const std::string some = why({40000, 30000, 100, 5000}), one = why({30000}), far = why({1e9, 100}),
                    asked = why({30000, 11000}), none = why({30000}, 0);
  BOOST_TEST(some.starts_with("at 30000 Hz stiffness and damping are known to "), some);
  for (const std::string& text : {some, one, far})
    BOOST_TEST(text.ends_with("0.02 is needed; of the lower frequencies tried, 5000 Hz is the highest known one"),
               text);
  BOOST_TEST(asked.ends_with("0.02 is needed; of the lower frequencies tried, 11000 Hz is the highest known one"),
             asked);
  BOOST_TEST(none.ends_with("0.02 is needed; of the lower frequencies tried, none is known"), none);
}

/// Beyond this Omega no grid of these contacts resolves kappa.
Response resolved_up_to_2(const Problem& problem, const ResponseRequest& request) {
  Response response = made_response(problem, request);
  for (Stiffness& at : response.frequencies)
    if (at.Omega > 2) at = {.Omega = at.Omega, .status = StopReason::tolerance_not_met};
  return response;
}

BOOST_AUTO_TEST_CASE(a_frequency_that_no_grid_resolves_has_no_digits_and_leaves_the_others) {
  ContactMemory memory(made_solution), known = made_memory();
  memory.respond_by(resolved_up_to_2);
  const Case one = needle_bearing(0);
  const BearingResult both = moved(one, bearing::Law::ehd, {1e8, 100}, memory),
                      alone = moved(one, bearing::Law::ehd, {100}, known);
  BOOST_TEST((both.status == StopReason::tolerance_not_met));
  BOOST_TEST(both.why.starts_with("at 1e8 Hz stiffness and damping are not known; of the lower frequencies tried, "),
             both.why);
  BOOST_REQUIRE(both.dynamics.size() == 2u);
  BOOST_TEST(both.dynamics[1].ring.error == alone.dynamics[0].ring.error);
  BOOST_TEST(*both.dynamics[1].ring.damping_error == *alone.dynamics[0].ring.damping_error);
  const Json json = to_json(both), far = json.at("dynamics").at(0), slow = json.at("dynamics").at(1);
  for (const char* key : {"stiffness_N_per_m", "damping_N_s_per_m", "error", "damping_error"}) {
    BOOST_TEST(!far.contains(key), key);
    BOOST_TEST(slow.contains(key), key);
  }
  for (const char* key : {"stiffness_N_per_m", "damping_N_s_per_m"}) {
    BOOST_TEST(!far.at("rollers").at(0).at("inner").contains(key), key);
    BOOST_TEST(slow.at("rollers").at(0).at("inner").contains(key), key);
  }
  const std::string text = human_table(one, {both}, {});
  const auto row = text.find("  1e8  ");
  BOOST_REQUIRE(row != std::string::npos);
  const std::string cells = text.substr(row, text.find('\n', row) - row);
  BOOST_TEST(cells.find_first_of("0123456789", 5) == std::string::npos, cells);
  const auto csv = bearing_csv({one}, {{both}});
  BOOST_REQUIRE(csv.has_value());
  BOOST_TEST(csv->find(",100000000,,,,,,,,,,\n") != std::string::npos);
}

// An error of more than half of a number leaves it no digit.
BOOST_AUTO_TEST_CASE(a_matrix_without_a_known_digit_is_left_out_of_the_json) {
  ContactMemory memory = made_memory();
  BearingResult result = moved(needle_bearing(0), bearing::Law::ehd, {100}, memory);
  result.dynamics[0].ring.error = 1.65;
  const Json stiff = to_json(result).at("dynamics").at(0);
  BOOST_TEST(!stiff.contains("stiffness_N_per_m"));
  BOOST_TEST(!stiff.at("rollers").at(0).at("inner").contains("stiffness_N_per_m"));
  BOOST_TEST(stiff.contains("damping_N_s_per_m"));
  EHD_CHECK(error(stiff.at("error").get<double>(), 1.65), Tolerance::round_off(1));
  result.dynamics[0].ring.error = 1e-3;
  result.dynamics[0].ring.damping_error = 0.6;
  const Json damped = to_json(result).at("dynamics").at(0);
  BOOST_TEST(damped.contains("stiffness_N_per_m"));
  BOOST_TEST(!damped.contains("damping_N_s_per_m"));
  BOOST_TEST(!damped.at("rollers").at(0).at("inner").contains("damping_N_s_per_m"));
}

// The certified solver resolves no higher frequencies, and takes a hundred times as long.
BOOST_AUTO_TEST_CASE(a_frequency_that_no_grid_resolves_is_no_reason_to_ask_again) {
  const Lubricant oil{
      .viscosity = ViscosityLaw::roelands, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = 2.2e-8, .z = 0.68};
  const Problem problem = nondimensionalise(MoesGroups{20, 10}, oil, Flooded{}).problem;
  ResponseRequest beyond = bearing_response_request(), slow = beyond;
  beyond.frequencies = {1e6};
  const Response found = bearing_responder()(problem, beyond), at_rest = bearing_responder()(problem, slow);
  BOOST_TEST(found.cost.nodes == at_rest.cost.nodes);
  BOOST_TEST(found.cost.krylov_iterations > 0);  // `reference` has none
  BOOST_TEST((found.frequencies.at(0).status == StopReason::tolerance_not_met));
}

BOOST_AUTO_TEST_CASE(a_law_without_a_film_has_stiffness_alone) {
  ContactMemory memory = made_memory();
  for (const bearing::Law law : {bearing::Law::hertz, bearing::Law::ehd_linear}) {
    const BearingResult result = moved(needle_bearing(0), law, {0, 50}, memory);
    BOOST_REQUIRE(result.dynamics.size() == 2u);
    const auto& K = result.stiffness_N_per_m;
    EHD_CHECK(error(result.dynamics[0].ring.stiffness_N_per_m[0][0], K[0][0]), Tolerance::round_off(1000));
    BOOST_TEST(!result.dynamics[1].ring.damping_N_s_per_m.has_value());
    const Json json = to_json(result);
    BOOST_TEST(json["dynamics"][1].contains("stiffness_N_per_m"));
    BOOST_TEST(!json["dynamics"][1].contains("damping_N_s_per_m"));
    BOOST_TEST(!json["dynamics"][1].contains("damping_error"));
    BOOST_TEST(json["notes"].dump().find("unknown, not zero") != std::string::npos);
  }
  BOOST_TEST(memory.responses() == 0);
}

BOOST_AUTO_TEST_CASE(the_plan_says_why_there_is_no_motion_and_no_response) {
  const auto body = std::get<BearingCase>(needle_bearing(0).body);
  const auto why = [&](bool dynamic, bearing::Law law, std::string_view stage) {
    for (const SkippedStage& skipped : plan_bearing(body, {law}, bearing::Form::plane, 0, dynamic).skipped)
      if (skipped.stage == stage) return skipped.why;
    return std::string();
  };
  BOOST_TEST(why(false, bearing::Law::ehd, bearing_stage::dynamics).find("--dynamic") != std::string::npos);
  BOOST_TEST(why(true, bearing::Law::ehd, bearing_stage::dynamics).empty());
  BOOST_TEST(why(true, bearing::Law::ehd, bearing_stage::response).empty());
  BOOST_TEST(why(true, bearing::Law::hertz, bearing_stage::response).find("no law") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_contact_without_a_response_leaves_the_balance_and_a_reason) {
  for (const StopReason end : {StopReason::limit_reached, StopReason::diverged}) {
    ContactMemory memory(made_solution);
    memory.respond_by([end](const Problem&, const ResponseRequest&) {
      return Response{.status = end, .reason = "the time is over"};
    });
    const Case one = needle_bearing(0);
    const BearingResult result = moved(one, bearing::Law::ehd, {0}, memory),
                        at_rest = moved(one, bearing::Law::ehd, {}, memory);
    BOOST_TEST((result.status == end));
    BOOST_TEST(result.dynamics.empty());
    BOOST_TEST(!result.response.has_value());
    BOOST_TEST(result.displacement_m == at_rest.displacement_m);
    const Json json = to_json(result), resting = to_json(at_rest);
    BOOST_TEST(json.at("status") == std::string(to_string(end)));
    BOOST_TEST(!json.contains("dynamics"));
    for (const char* key : {"rollers", "displacement_m", "stiffness_N_per_m", "torque_N_m", "balance_error"})
      BOOST_TEST(json.at(key) == resting.at(key), key);
    // Text and JSON say which part ended, and why.
    const std::string note = json.at("notes").back(), text = human_table(one, {result}, {});
    BOOST_TEST(note.find("balanced, but its stiffness and damping in motion are not known") != std::string::npos, note);
    BOOST_TEST(note.find("the time is over") != std::string::npos, note);
    for (const char* words : {"balanced, but its stiffness and damping in motion are not known", "the time is over"})
      BOOST_TEST(text.find(words) != std::string::npos, text);  // on two lines: the table is not that wide
  }
}

// Exact: the made rolling force is 1.4475/M in Hertz units at every load, F_t = 1.4475 p_H b^2/(R M).
BOOST_AUTO_TEST_CASE(the_torque_sums_the_rolling_forces_of_both_raceways) {
  ContactMemory memory = made_memory();
  const BearingResult result = moved(needle_bearing(0), bearing::Law::ehd, {}, memory);
  BOOST_TEST(result.dynamics.empty());
  BOOST_REQUIRE(result.torque.has_value());
  const double l = 0.122, modulus = 2.06e11 / 0.91, turn = 5000 * pi / 30;
  const double u_s = 0.053 / 2 * (1 - std::pow(5.0 / 53, 2)) * turn;
  double sum = 0;
  for (const RollerRow& roller : result.rollers)
    for (const bool inner : {true, false}) {
      const double R = 1 / (2 / 0.005 + (inner ? 2 / 0.048 : -2 / 0.058));
      const double w = (inner ? roller.inner : roller.outer).force_N / l;
      const double b2 = 8 * w * R / (pi * modulus), p_H = 2 * w / (pi * std::sqrt(b2));
      sum += 1.4475 * p_H * b2 / R / (w / std::sqrt(0.02 * u_s * modulus * R));
    }
  EHD_CHECK(error(result.torque->torque_N_m, u_s * l * sum / turn),
            Tolerance::required(1e-3, "rollers below the lightest contact follow Martin's form, 1.4705 for 1.4475"));
  EHD_CHECK(error(to_json(result)["torque_N_m"].get<double>(), result.torque->torque_N_m), Tolerance::round_off(1));
}

BOOST_AUTO_TEST_CASE(a_law_is_exported_over_the_balance_with_its_damping) {
  ContactMemory memory = made_memory();
  const LawExport law = export_law(needle_bearing(0), {.raceway = bearing::Raceway::outer, .knots = 20}, memory);
  BOOST_TEST(law.table.approach_m.size() == 20u);
  BOOST_TEST(law.lightest_N < law.balance_lightest_N);
  BOOST_TEST(law.heaviest_N > law.balance_heaviest_N);
  BOOST_TEST(law.no_damping.empty());
  BOOST_REQUIRE(law.table.damping_N_s_per_m.has_value());
  EHD_CHECK(law.force_error, Tolerance::required(2e-3, "the bounds of a curve"));
  ContactMemory without(made_solution);
  without.respond_by([](const Problem&, const ResponseRequest&) { return Response{.reason = "no steady state"}; });
  const LawExport undamped = export_law(needle_bearing(0), {}, without);
  BOOST_TEST(!undamped.table.damping_N_s_per_m.has_value());
  BOOST_TEST(undamped.no_damping.find("no steady state") != std::string::npos);
  BOOST_TEST((undamped.status == StopReason::converged));  // of the balance
}

BOOST_AUTO_TEST_CASE(a_law_that_a_limit_cut_short_is_exported_with_that_status) {
  ContactMemory memory([](const Problem& problem, const Request& request) {
    Solution solution = made_solution(problem, request);
    if (problem.groups.M < 0.2) solution.record.status = StopReason::limit_reached;
    return solution;
  });
  const LawExport law = export_law(needle_bearing(0), {}, memory);
  BOOST_TEST(law.table.approach_m.size() > 0u);
  BOOST_TEST((law.status == StopReason::limit_reached));
  BOOST_TEST(law.why == "the limit on iterations or time ended contacts of the film curves");
}

// Between its ends the damping of light contacts nearly vanishes, and there its relative error is the largest.
BOOST_AUTO_TEST_CASE(the_damping_error_of_an_exported_law_is_that_of_its_smallest_damping) {
  const auto exported = [](double left_at_M_10) {
    ContactMemory memory(made_solution);
    memory.respond_by([left_at_M_10](const Problem& problem, const ResponseRequest& request) {
      Response response = made_response(problem, request);
      SlowStiffness& slow = *response.slow;
      slow.lag_error = 1e-3 * slow.lag;
      const double away = std::log(problem.groups.M / 10);
      slow.lag *= (left_at_M_10 + away * away) / (1 + away * away);
      slow.kappa_1 = slow.lag * slow.kappa_0 * slow.kappa_0;
      slow.error_1 = slow.lag_error / slow.lag;
      return response;
    });
    // Preload keeps every roller above the lightest contact of the curve, and M from 5 to 22.
    return export_law(needle_bearing(-2e-5), {.raceway = bearing::Raceway::inner, .knots = 60}, memory);
  };
  const LawExport dipped = exported(0.02), level = exported(1);
  BOOST_REQUIRE((dipped.damping_error && level.damping_error));
  const std::vector<double>& damping = dipped.table.damping_N_s_per_m->values;
  const auto smallest = std::min_element(damping.begin(), damping.end());
  BOOST_REQUIRE((smallest != damping.begin() && smallest + 1 != damping.end()));
  BOOST_TEST(*dipped.damping_error > 5 * *level.damping_error);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd
