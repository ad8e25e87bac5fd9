// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_summary.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "io/bearing_json.hpp"
#include "io/bearing_table.hpp"
#include "tests/check.hpp"
#include "tests/made_bearing.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// Four rollers: one loaded most, two less, one that the film alone touches.
BearingResult made_result() {
  BearingResult result;
  result.law = bearing::Law::ehd;
  result.status = StopReason::converged;
  result.displacement_m = 10e-6;
  result.stiffness_N_per_m[0][0] = 5.0012e8;
  const auto contact = [](double force_N, double film_m) {
    return ContactRow{.force_N = force_N,
                      .displacement_m = 1e-6,
                      .film_minimum_m = film_m,
                      .hertz_pressure_Pa = 4e7 * std::sqrt(force_N),
                      .lambda_ratio = film_m / 1e-7};
  };
  result.rollers = {{0, contact(900, 0.31e-6), contact(903, 0.30e-6)},
                    {90, contact(400, 0.35e-6), contact(403, 0.34e-6)},
                    {180, contact(5, 50e-6), contact(8, 0.2e-6)},
                    {-90, contact(400, 0.35e-6), contact(403, 0.34e-6)}};
  return result;
}

const BearingErrors some_errors{.displacement_m = 2e-8, .largest_force_N = 3, .smallest_film = 1e-3};

BearingResult with(std::optional<BearingErrors> errors, BearingResult result = made_result()) {
  result.errors = errors;
  return result;
}

std::vector<BearingResult> with_errors_of_ehd(std::vector<BearingResult> results) {
  for (BearingResult& result : results)
    if (result.law == bearing::Law::ehd) result.errors = some_errors;
  return results;
}

bool says(const std::string& text, const std::string& phrase) { return text.find(phrase) != std::string::npos; }

/// The text with each note in one line: the program wraps them at the width of a table.
std::string with_whole_notes(std::string text) {
  const std::string broken = "\n      ";
  for (std::size_t at = 0; (at = text.find(broken, at)) != std::string::npos; ++at)
    text.replace(at, broken.size(), " ");
  return text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_summary)

BOOST_AUTO_TEST_CASE(the_summary_has_the_numbers_of_the_loaded_rollers_with_their_errors) {
  const Case one = made::needle_bearing(10e-6);
  const std::string text = summary_table(std::get<BearingCase>(one.body), {with(some_errors)});
  for (const char* phrase :
       {"10.00(2)", "900(3)", "1202(2)", "+-60.00(7)", "3 of 4", "0.3000(3)", "3.000(3)", " 500\n"})
    BOOST_CHECK_MESSAGE(says(text, phrase), phrase << " is not in\n" << text);
  BOOST_TEST(!says(text, "0.2"));  // the film of the unloaded roller
}

// The most loaded roller has its largest pressure at the outer ring; two rollers of equal load are one row of the
// table.
BOOST_AUTO_TEST_CASE(the_summary_says_where_pressure_and_film_are) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult result = made_result();
  const auto text = [&] { return summary_table(std::get<BearingCase>(one.body), {with(some_errors, result)}); };
  BOOST_TEST(says(text(), " 0, outer\n  load zone"), text());
  BOOST_TEST(says(text(), " 0, outer\n  stiffness"), text());
  result.rollers[1].inner.film_minimum_m = 0.29e-6;
  result.rollers[1].inner.lambda_ratio = 2.9;
  BOOST_TEST(says(text(), "2.900(3)\n    at psi [deg], raceway            +-90, inner\n"), text());
  const Json json = to_json(result);
  BOOST_TEST(json["largest_pressure"]["azimuth_deg"] == 0.0);
  BOOST_TEST(json["largest_pressure"]["raceway"] == "outer");
  BOOST_TEST(json["largest_pressure"]["hertz_pressure_Pa"] == *result.rollers[0].outer.hertz_pressure_Pa);
  BOOST_TEST(json["smallest_film"]["azimuth_deg"] == 90.0);
  BOOST_TEST(json["smallest_film"]["raceway"] == "inner");
  BOOST_TEST(json["smallest_film"]["lambda_ratio"] == 2.9);
}

// d(psi) = cot psi d(delta)/delta = 0.066 degrees above; without clearance it is 0, under preload the zone is the
// circle. A ring that moved by 10 um across the load too is turned by an error of 0.02 um along it: 1e-3 rad, and
// cot psi d(delta)/delta is 3.8e-4.
BOOST_AUTO_TEST_CASE(a_load_zone_has_an_error_by_size_and_direction_of_the_displacement) {
  const auto zone = [](double clearance_m, double across_m) {
    const Case one = made::needle_bearing(clearance_m);
    BearingResult result = made_result();
    result.displacement_lateral_m = across_m;
    const std::string text = summary_table(std::get<BearingCase>(one.body), {with(some_errors, result)});
    const auto at = text.find("load zone [deg]"), end = text.find('\n', at);
    return text.substr(text.rfind("  ", end) + 2, end - text.rfind("  ", end) - 2);
  };
  BOOST_TEST(zone(0, 0) == "+-90");
  BOOST_TEST(zone(-30e-6, 0) == "+-180.0");
  BOOST_TEST(zone(10e-6, 10e-6) == "-24.30(8) to 114.30(8)");
}

// A force of 903 N that is known to 90 % may be a tenth of it, and its pressure a third.
BOOST_AUTO_TEST_CASE(a_pressure_follows_the_root_of_a_force_that_is_hardly_known) {
  const Case one = made::needle_bearing(10e-6);
  const auto pressure = [&](double error_N) {
    const BearingResult result = with(BearingErrors{.displacement_m = 2e-8, .largest_force_N = error_N});
    const std::string text = summary_table(std::get<BearingCase>(one.body), {result});
    const auto at = text.find("its maximum pressure"), end = text.find('\n', at);
    if (at == std::string::npos) return std::string("left out");
    return text.substr(text.rfind("  ", end) + 2, end - text.rfind("  ", end) - 2);
  };
  BOOST_TEST(pressure(3) == "1202(2)");
  BOOST_TEST(pressure(0.9 * 903) == "1.2(9)e3");
  BOOST_TEST(pressure(904) == "left out");
}

// The motion at 0 Hz is the same stiffness by another way; a line is off by its distance from the full relation.
BOOST_AUTO_TEST_CASE(a_stiffness_has_an_error_from_motion_at_rest_or_from_the_full_relation) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult films = made_result(), line = made_result(), dry = made_result();
  films.dynamics = {{.frequency_Hz = 100}, {.frequency_Hz = 0}};
  films.dynamics.back().ring = {.stiffness_N_per_m = {{{5.0022e8, 0}, {0, 4.9978e8}}}, .error = 2e-3};
  line.law = bearing::Law::ehd_linear;
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  line.stiffness_N_per_m[0][0] = 4.87e8;
  dry.law = bearing::Law::hertz;
  const auto text = [&](const std::vector<BearingResult>& results) {
    return summary_table(std::get<BearingCase>(one.body), with_errors_of_ehd(results));
  };
  BOOST_TEST(says(text({films}), " 500(3)\n"));  // 2e-3 of the trace, and 0.1
  BOOST_TEST(says(text({dry, line, films}), " 500.1    4.9(2)e2      500(3)\n"), text({dry, line, films}));
  BOOST_TEST(says(text({line}), " 487\n"));

  const auto stated = [](const Json& json) { return json.at("stiffness_error").get<double>(); };
  const double motion = (2e-3 * (5.0022e8 + 4.9978e8) + 1e5) / 5.0012e8;
  EHD_CHECK(error(stated(to_json(films)), motion), Tolerance::round_off(100));
  EHD_CHECK(error(stated(to_json(line, &films)), (5.0012e8 - 4.87e8 + motion * 5.0012e8) / 4.87e8),
            Tolerance::round_off(1000));
  BOOST_TEST(!to_json(line).contains("stiffness_error"));
  BOOST_TEST(!to_json(dry).contains("stiffness_error"));
}

// The line of 3.4e8 is off by 0.47, that of 3.3e8 by 0.52.
BOOST_AUTO_TEST_CASE(a_stiffness_without_a_known_digit_is_left_out_of_text_and_json) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult films = made_result(), line = made_result();
  line.law = bearing::Law::ehd_linear;
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  const auto is_given = [&](const BearingResult& last) {
    const Json json = to_json(last, &films);
    const bool given = json.contains("stiffness_N_per_m");
    const std::string text = human_table(one, {with(some_errors, films), last}, {.details = true});
    const auto cells_of = [&](const std::string& head) {  // of the last law
      const auto at = text.find(head), end = text.find('\n', at);
      return text.substr(at, end - at);
    };
    BOOST_TEST(cells_of("stiffness along").ends_with("  -") == !given, text);
    BOOST_TEST(cells_of("ehd-linear           0  ").ends_with("  -") == !given, text);
    return given;
  };
  line.stiffness_N_per_m[0][0] = 3.4e8;
  BOOST_TEST(is_given(line));
  line.stiffness_N_per_m[0][0] = 3.3e8;
  BOOST_TEST(!is_given(line));
  BOOST_TEST(!to_json(line, &films).contains("stiffness_error"));
  films.stiffness_error_N_per_m = std::numeric_limits<double>::infinity();
  BOOST_TEST(!to_json(films).contains("stiffness_N_per_m"));
  BOOST_TEST(!says(human_table(one, {films}), "stiffness along"));
}

// In motion too a line is off by its distance from the full relation. Alone, its error is not known.
BOOST_AUTO_TEST_CASE(the_json_of_a_line_in_motion_has_its_distance_from_the_full_relation) {
  BearingResult films = made_result(), line = made_result();
  films.dynamics = {{.frequency_Hz = 0}};
  films.dynamics[0].ring = {.stiffness_N_per_m = {{{5.0e8, 0}, {0, 4.5e8}}}, .error = 2e-3};
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  line.dynamics = films.dynamics;
  line.dynamics[0].ring = {.stiffness_N_per_m = {{{4.8e8, 0}, {0, 4.6e8}}}, .error = 1e-3};
  const auto stated = [](const Json& json) { return json["dynamics"][0]["error"].get<double>(); };
  EHD_CHECK(error(stated(to_json(films)), 2e-3), Tolerance::round_off(1));
  EHD_CHECK(error(stated(to_json(line, &films)), 1e-3 + (2e7 + 2e-3 * 9.5e8) / 9.4e8), Tolerance::round_off(100));
  BOOST_TEST(!to_json(line)["dynamics"][0].contains("error"));
}

BOOST_AUTO_TEST_CASE(the_torque_of_a_fitted_law_is_as_wrong_as_it_is_far_from_the_full_relation) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult films = made_result(), line = made_result();
  films.torque = RollingTorque{.torque_N_m = 8, .error = 0.01};
  line.law = bearing::Law::ehd_linear;
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  line.torque = RollingTorque{.torque_N_m = 6.6, .error = 0.01};
  const auto text = [&](const std::vector<BearingResult>& results) {
    return summary_table(std::get<BearingCase>(one.body), with_errors_of_ehd(results));
  };
  BOOST_TEST(says(text({line, films}), "7(2)     8.00(8)\n"), text({line, films}));
  BOOST_TEST(says(text({line}), " 6.6\n"), text({line}));
  EHD_CHECK(error(to_json(films)["torque_error"].get<double>(), 0.01), Tolerance::round_off(1));
  EHD_CHECK(error(to_json(line, &films)["torque_error"].get<double>(), (1.4 + 0.08) / 6.6), Tolerance::round_off(100));
  BOOST_TEST(!to_json(line).contains("torque_error"));
}

BOOST_AUTO_TEST_CASE(tables_of_motion_print_the_digits_that_are_known) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult result = made_result();
  const bearing::ContactMotion contact{
      .stiffness_N_per_m = 3.1921234e9, .damping_N_s_per_m = 1181.234, .stiffness_error = 4e6, .damping_error = 30};
  DynamicRow row{.frequency_Hz = 100, .ring = {}, .rollers = {}};
  for (const RollerRow& roller : result.rollers)
    row.rollers.push_back({.azimuth_deg = roller.azimuth_deg, .inner = contact, .outer = contact});
  row.ring = {.stiffness_N_per_m = {{{8.8261234567e9, 0}, {0, 9.7812345678e9}}},
              .damping_N_s_per_m = bearing::Matrix2{{{5712.3, 0}, {0, 10712.3}}},
              .error = 1e-13,
              .damping_error = 1e-3};
  result.dynamics = {row};
  const std::string text = human_table(one, {result});
  for (const char* phrase : {"3192(4)", "1.18(3)e3", " 8826.1  9781.2  ", "5.71(2)e3", "1.071(2)e4"})
    BOOST_CHECK_MESSAGE(says(text, phrase), phrase << " is not in\n" << text);
}

// The error of a line in motion counts the deviation of its K too; beside the smaller one at rest a line says why.
BOOST_AUTO_TEST_CASE(the_table_of_motion_says_why_errors_of_a_line_are_larger) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult films = made_result(), line = made_result();
  films.dynamics = line.dynamics = {{.frequency_Hz = 0, .ring = {.stiffness_N_per_m = {{{5e8, 0}, {0, 5e8}}}}}};
  line.law = bearing::Law::ehd_linear;
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  const std::string words = "  errors of ehd-linear in motion: also by the standard deviation of its K";
  BOOST_TEST(says(human_table(one, {line, films}), words), human_table(one, {line, films}));
  BOOST_TEST(!says(human_table(one, {line}), words));
}

// Every force is known to 42 N. p_H has half the relative error of the force, a film the whole one and its own.
BOOST_AUTO_TEST_CASE(the_rollers_table_ends_a_number_at_the_first_digit_of_its_error) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult result =
      with(BearingErrors{.displacement_m = 2e-9, .largest_force_N = 0.3, .any_force_N = 42, .smallest_film = 1e-3});
  for (const std::size_t j : {1U, 3U}) {
    result.rollers[j].inner.force_N = 437;
    result.rollers[j].inner.hertz_pressure_Pa = 836.2e6;
  }
  const std::string text = human_table(one, {result});
  for (const char* row : {"0          900  1200  0.31     3.1", "+-90       440   840  0.35     3.5",
                          "180         10     -     -       -"})
    BOOST_CHECK_MESSAGE(says(text, row), row << " is not in\n" << text);
}

BOOST_AUTO_TEST_CASE(the_rollers_table_has_load_pressure_film_and_lambda_ratio) {
  const Case one = made::needle_bearing(10e-6);
  const BearingErrors small{.displacement_m = 2e-9, .largest_force_N = 0.3};
  const std::string text = human_table(one, {with(small)});
  for (const char* row :
       {"ehd: f_i   p_H    h_i  lambda", "0        900.0  1200  0.310    3.10", "180        5.0     -      -       -"})
    BOOST_CHECK_MESSAGE(says(text, row), row << " is not in\n" << text);
  BOOST_TEST(!says(text, "delta_i"));
  BOOST_TEST(says(human_table(one, {made_result()}, {.details = true}), "delta_i"));
}

BOOST_AUTO_TEST_CASE(a_law_without_errors_has_no_brackets_and_an_empty_row_is_left_out) {
  BearingResult dry = made_result();
  dry.law = bearing::Law::hertz;
  for (RollerRow& roller : dry.rollers)
    for (ContactRow* at : {&roller.inner, &roller.outer}) at->film_minimum_m = at->lambda_ratio = std::nullopt;
  const Case one = made::needle_bearing(10e-6);
  const std::string text = summary_table(std::get<BearingCase>(one.body), {dry});
  BOOST_TEST(!says(text, "("));
  BOOST_TEST(!says(text, "film"));
  BOOST_TEST(!says(text, "lambda"));
  dry.rollers.clear();
  BOOST_TEST(summary_table(std::get<BearingCase>(one.body), {dry}) == "");
}

// Only a dry law may have six digits: it is solved to rounding.
BOOST_AUTO_TEST_CASE(a_law_with_films_but_without_a_budget_has_three_digits_and_a_note) {
  BearingResult line = made_result();
  line.law = bearing::Law::ehd_linear;
  line.displacement_m = 10.1234e-6;
  line.rollers.front().inner.force_N = 912.345;
  line.notes.emplace_back(note::NoBudget{.why = "nobody knows"});
  const std::string text = human_table(made::needle_bearing(10e-6), {line});
  for (const char* phrase :
       {" 10.1\n", " 912\n", " 1.2e3\n", "    - no error budget, and so no errors in brackets: nobody knows\n"})
    BOOST_CHECK_MESSAGE(says(text, phrase), phrase << " is not in\n" << text);
  BOOST_TEST(says(text, " 912  1200  0.310 "), text);
  line.law = bearing::Law::hertz;
  BOOST_TEST(says(human_table(made::needle_bearing(10e-6), {line}), " 10.1234\n"));
}

BOOST_AUTO_TEST_CASE(tables_of_cage_and_motion_print_the_digits_that_are_known) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult result = made_result();
  result.rollers.front().inner.force_N = 912.345;
  result.cage = {.positions = 24,
                 .displacement_m = {.mean = 10.1234567e-6, .peak_to_peak = 1.23456e-9},
                 .displacement_lateral_m = {.mean = 1e-22, .peak_to_peak = 2.34567e-9},
                 .largest_force_N = 912.345};
  const auto shows = [&](const std::optional<BearingErrors>& errors, const std::string& mean,
                         const std::string& largest, const std::string& along = "     0.00123",
                         const std::string& across = "     0.00235") {
    const std::string text = human_table(one, {with(errors, result)});
    const std::string row = "  " + mean + "  " + along + "                 0  " + across + "\n";
    BOOST_TEST(says(text, row), text);
    BOOST_TEST(text.ends_with("  " + largest + "\n"), text);
  };
  shows(some_errors, "10.12(2)", "912(3)", "     < 0.042");  // twice the error of one displacement
  shows(BearingErrors{.displacement_m = 2e-10, .largest_force_N = 3}, "10.1235(2)", "912(3)", "   0.0012(4)");
  shows({}, "10.1", "912");
  result.law = bearing::Law::hertz;
  shows({}, "10.1235", "912.345");
}

// The ring is known to 0.02 um by ehd, to 0.3 um by the line, whose rollers are as far off as they are from ehd.
BOOST_AUTO_TEST_CASE(details_print_the_digits_that_are_known) {
  const Case one = made::needle_bearing(10e-6);
  BearingResult full = made_result();
  full.displacement_lateral_m = 1.23456e-6;
  full.stiffness_N_per_m = {{{5.0012e8, 3.1234e7}, {3.1234e7, 4.1234e8}}};
  full.stiffness_error_N_per_m = 2e6;
  full.rollers[0].inner.displacement_m = 2.34567e-6;
  full.rollers[2].inner.displacement_m = -2.34567e-6;
  BearingResult line = full;
  line.law = bearing::Law::ehd_linear;
  line.fit.emplace();
  line.fit->inner.points = line.fit->outer.points = {{}};
  line.rollers[2].inner.displacement_m = -45.4321e-6;
  line.stiffness_N_per_m[1][1] = 5.1234e8;
  full.errors = some_errors;
  full.errors->displacement_lateral_m = 2e-8;
  const auto row = [&](const std::string& begin, const std::vector<BearingResult>& results) {
    const std::string text = human_table(one, results, {.details = true});
    const auto at = text.find("\n  " + begin + " ", begin == "ehd" ? text.find("\n  ring") : text.find("delta_i"));
    return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  };
  BOOST_TEST(row("0", {full}) == "  0             2.35");
  BOOST_TEST(row("180", {full}) == "  180          -2.35");
  BOOST_TEST(says(row("ehd", {full}), " 1.23 "), row("ehd", {full}));
  BOOST_TEST(row("ehd", {full}).ends_with("  500  412  31"), row("ehd", {full}));
  line.errors = {.displacement_m = 3e-7, .largest_force_N = 30};
  BOOST_TEST(row("0", {line, full}) == "  0                     2.3          2.35");
  BOOST_TEST(row("180", {line, full}) == "  180                   -50         -2.35");
  full.errors.reset();
  BOOST_TEST(row("0", {full}) == "  0             2.35");
  full.law = bearing::Law::hertz;
  BOOST_TEST(row("0", {full}) == "  0              2.346");
}

BOOST_AUTO_TEST_CASE(details_and_the_film_of_unloaded_rollers_are_not_in_the_first_table) {
  BearingResult result = made_result();
  result.variants = {{.name = "cut at delta = 0", .rollers = result.rollers}};
  result.notes = {note::CutVariant{}, note::Oil{.remark = "about the oil"}};
  const Case one = made::needle_bearing(10e-6);
  const std::string table = human_table(one, {with(some_errors, result)});
  BOOST_TEST(says(table, "about the oil"));
  BOOST_TEST(!says(table, "variant"));
  BOOST_TEST(!says(table, "contacts solved"));
  BOOST_TEST(!says(table, "50.000"));
  const std::string details = human_table(one, {result}, {.details = true});
  BOOST_TEST(says(details, "contacts solved"));
  BOOST_TEST(says(with_whole_notes(details), "loaded rollers 3 as without it, force of roller 1 900 N as without it"));
}

BOOST_AUTO_TEST_CASE(a_note_that_two_laws_share_is_printed_once) {
  BearingResult line = made_result(), films = made_result();
  line.law = bearing::Law::ehd_linear;
  for (BearingResult* result : {&line, &films}) result->notes.emplace_back(note::NoFilms{.why = "of both"});
  films.notes.emplace_back(note::NoFilms{.why = "of one"});
  const std::string text = human_table(made::needle_bearing(10e-6), {line, films});
  BOOST_TEST(says(text,
                  "\n  notes on ehd-linear, ehd\n    - no films: of both\n"
                  "\n  notes on ehd\n    - no films: of one\n"),
             text);
  BOOST_TEST(text.find("of both") == text.rfind("of both"));
}

BOOST_AUTO_TEST_SUITE_END()
