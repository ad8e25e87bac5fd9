// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of the paper's statements, with rollers made by hand: each letter both ways.
#include "verification/studies/paper_statements.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/made_bearing.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

/// Force [N] and approach [um] of the rollers at 0, +-45, +-90 and 180 degrees.
struct Made {
  double force_N[4];
  double approach_um[4];
};

BearingResult made_result(bearing::Law law, const Made& made) {
  BearingResult result;
  result.law = law;
  result.status = StopReason::converged;
  constexpr double azimuths_deg[] = {0, 45, 90, 180, -90, -45};
  constexpr std::size_t rows[] = {0, 1, 2, 3, 2, 1};
  for (std::size_t k = 0; k < 6; ++k) {
    const ContactRow row{.force_N = made.force_N[rows[k]], .displacement_m = 1e-6 * made.approach_um[rows[k]]};
    result.rollers.push_back({.azimuth_deg = azimuths_deg[k], .inner = row, .outer = row});
  }
  return result;
}

/// The paper's four statements hold with these: at P_d = 0, 2.5 and 10 um.
struct Figures {
  Made dry[3] = {{{9000, 5000, 500, 0}, {3.0, 1.8, 0.40, -15}},
                 {{9500, 4900, 300, 0}, {3.2, 1.7, 0.10, -17}},
                 {{11000, 4000, 0, 0}, {3.6, 1.4, -3.0, -20}}};
  Made film[3] = {{{8600, 5200, 600, 20}, {2.4, 1.5, 0.30, -12}},
                  {{9450, 4900, 400, 10}, {2.6, 1.4, 0.08, -14}},
                  {{11600, 3700, 200, 10}, {3.0, 1.1, -2.0, -17}}};  // the third one is not loaded dry
};

std::vector<PaperStatement> judged(const Figures& figures) {
  constexpr double clearances_m[] = {0, 2.5e-6, 10e-6};
  std::vector<ClearanceComparison> all;
  for (std::size_t k = 0; k < 3; ++k)
    all.push_back({clearances_m[k], made_result(bearing::Law::hertz, figures.dry[k]),
                   made_result(bearing::Law::ehd, figures.film[k])});
  return judge_paper_statements(all);
}

/// Which letters hold: "abcd" where all do.
std::string that_hold(const Figures& figures) {
  std::string letters;
  for (const PaperStatement& one : judged(figures))
    if (one.holds) letters += one.letter;
  return letters;
}

bool part(const PaperStatement& statement, const std::string& name) {
  for (const auto& [key, yes] : statement.parts)
    if (key == name) return yes;
  BOOST_FAIL(name << " is no part of (" << statement.letter << ")");
  return false;
}

double value(const PaperStatement& statement, const std::string& name) {
  for (const auto& [key, number] : statement.values)
    if (key == name) return number;
  BOOST_FAIL(name << " is no value of (" << statement.letter << ")");
  return 0;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_paper_statements)

BOOST_AUTO_TEST_CASE(all_four_hold_with_figures_that_are_as_the_paper_says) {
  BOOST_TEST(that_hold(Figures{}) == "abcd");
  const auto statements = judged(Figures{});
  EHD_CHECK(error(value(statements[0], "change"), 8600.0 / 9000 - 1), Tolerance::round_off(10, 25));
  EHD_CHECK(error(value(statements[0], "apart"), 400.0 / 9000), Tolerance::round_off(10));
  EHD_CHECK(error(value(statements[2], "largest"), 11600.0 / 11000 - 1), Tolerance::round_off(10, 25));
}

BOOST_AUTO_TEST_CASE(dry_and_film_exchanged_fail_a_b_and_c) {
  Figures figures;
  std::swap_ranges(std::begin(figures.dry), std::end(figures.dry), std::begin(figures.film));
  BOOST_TEST(that_hold(figures) == "d");
}

BOOST_AUTO_TEST_CASE(a_fails_where_the_film_raises_the_top_load) {
  Figures figures;
  figures.film[0].force_N[0] = 9100;
  BOOST_TEST(that_hold(figures) == "bcd");
  const PaperStatement a = judged(figures)[0];
  BOOST_TEST(part(a, "similar"));
  BOOST_TEST(!part(a, "lower"));
  figures.film[0].force_N[0] = 9000;  // equal is not lower
  BOOST_TEST(that_hold(figures).find('a') == std::string::npos);
}

// The share is of the largest dry load, 9000 N, and of any roller: loaded or not, above or below.
BOOST_AUTO_TEST_CASE(a_fails_where_any_roller_is_further_than_a_fifth_of_the_largest_dry_load_away) {
  for (const std::size_t roller : {1u, 2u, 3u})
    for (const double beyond : {-1.0, 1.0}) {
      Figures figures;
      figures.film[0].force_N[roller] = figures.dry[0].force_N[roller] + similar_load * 9000 + beyond;
      const PaperStatement a = judged(figures)[0];
      BOOST_TEST(a.holds == (beyond < 0));
      BOOST_TEST(part(a, "similar") == (beyond < 0));
      BOOST_TEST(part(a, "lower"));
      EHD_CHECK(error(value(a, "apart"), similar_load + beyond / 9000), Tolerance::round_off(100));
      BOOST_TEST((a.numbers.find("not similar") == std::string::npos) == (beyond < 0));
    }
  Figures lower;
  lower.film[0].force_N[1] = 5000 - similar_load * 9000 - 1;
  BOOST_TEST(that_hold(lower) == "bcd");
  Figures top;
  top.film[0].force_N[0] = 9000 * (1 - similar_load) - 1;
  BOOST_TEST(!judged(top)[0].holds);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_none_makes_nothing_similar) {
  Figures figures;
  figures.film[0].force_N[1] = std::nan("");
  BOOST_TEST(!part(judged(figures)[0], "similar"));
  BOOST_TEST(!judged(figures)[0].holds);
}

BOOST_AUTO_TEST_CASE(b_fails_where_one_clearance_has_no_considerably_smaller_approach) {
  for (std::size_t k = 0; k < 3; ++k)
    for (const double share : {considerably - 0.001, considerably + 0.001}) {
      Figures figures;
      figures.film[k].approach_um[0] = figures.dry[k].approach_um[0] * (1 - share);
      BOOST_TEST(judged(figures)[1].holds == (share > considerably));
    }
  Figures larger;
  for (std::size_t k = 0; k < 3; ++k) larger.film[k].approach_um[0] = 1.2 * larger.dry[k].approach_um[0];
  BOOST_TEST(that_hold(larger) == "acd");
}

BOOST_AUTO_TEST_CASE(c_fails_where_the_middle_clearance_is_not_close) {
  for (const double sign : {-1.0, 1.0})
    for (const double share : {close_load - 1e-4, close_load + 1e-4}) {
      Figures figures;
      figures.film[1].force_N[0] = 9500 * (1 + sign * share);
      const PaperStatement c = judged(figures)[2];
      BOOST_TEST(part(c, "close") == (share < close_load));
      BOOST_TEST(part(c, "opposite"));
      BOOST_TEST(c.holds == (share < close_load));
      BOOST_TEST(c.holds_at_top.value() == (share < close_load));
    }
}

// The paper's figure shows the load of every roller: "close" at psi = 0 alone is not close. 190 N are 2 % of 9500 N.
BOOST_AUTO_TEST_CASE(c_fails_where_any_roller_is_not_close_and_says_that_it_holds_at_the_top) {
  for (const std::size_t roller : {1u, 2u, 3u})
    for (const double beyond : {-1.0, 1.0}) {
      Figures figures;
      figures.film[1].force_N[roller] = figures.dry[1].force_N[roller] + close_load * 9500 + beyond;
      const PaperStatement c = judged(figures)[2];
      BOOST_TEST(c.holds == (beyond < 0));
      BOOST_TEST(part(c, "close at psi = 0"));
      BOOST_TEST(c.holds_at_top.value());
      EHD_CHECK(error(value(c, "apart"), close_load + beyond / 9500), Tolerance::round_off(1000));
      BOOST_TEST(verdict_of(c) == (beyond < 0 ? "holds" : "does not hold; at psi = 0 alone it does"));
      BOOST_TEST(cell_of(c) == (beyond < 0 ? "holds" : "at 0"));
    }
}

// Every roller that the dry law loads counts, and the others are told of: there the film's delta_i may be larger.
BOOST_AUTO_TEST_CASE(b_looks_at_every_loaded_roller_and_tells_of_the_others) {
  Figures edge;
  edge.film[2].approach_um[1] = 1.4 * (1 - considerably + 0.001);  // loaded dry with 4000 N
  const PaperStatement failing = judged(edge)[1];
  BOOST_TEST(!failing.holds);
  BOOST_TEST(failing.holds_at_top.value());
  EHD_CHECK(error(value(failing, "loaded"), -considerably + 0.001), Tolerance::round_off(1000));
  const PaperStatement b = judged(Figures{})[1];
  BOOST_TEST(b.holds);
  EHD_CHECK(error(value(b, "outside_m"), 3e-6), Tolerance::round_off(100));  // -15 against -12 um at 180 degrees
  BOOST_TEST(b.numbers.find("of 3 others 3 larger (by 3.00 um at most)") != std::string::npos);
  Figures none;
  none.film[0].approach_um[1] = std::nan("");
  BOOST_TEST(!judged(none)[1].holds);
}

// The paper's words about the rollers further out contradict the balance of loads. They are reported all the same.
BOOST_AUTO_TEST_CASE(a_tells_what_is_printed_of_the_rollers_further_out) {
  const PaperStatement a = judged(Figures{})[0];
  BOOST_TEST(a.statement.find("in contrast ... decrease") != std::string::npos);
  BOOST_TEST(!part(a, "printed decrease"));
  BOOST_TEST(a.numbers.find("do not decrease") != std::string::npos);
  Figures less;
  less.film[0].force_N[1] = 4800, less.film[0].force_N[2] = 450;
  BOOST_TEST(part(judged(less)[0], "printed decrease"));
}

BOOST_AUTO_TEST_CASE(c_fails_where_the_largest_clearance_has_a_lower_top_load) {
  Figures figures;
  figures.film[2].force_N[0] = 10900;
  const PaperStatement c = judged(figures)[2];
  BOOST_TEST(part(c, "close"));
  BOOST_TEST(!part(c, "opposite"));
  BOOST_TEST(that_hold(figures) == "abd");
}

// Further out: the rollers that the dry law loads. What the others gain, 2 x 5000 + 20000 N here, does not count.
BOOST_AUTO_TEST_CASE(c_looks_at_the_rollers_that_the_dry_law_loads) {
  Figures gained;
  gained.film[2].force_N[2] = 5000;
  gained.film[2].force_N[3] = 20000;
  BOOST_TEST(part(judged(gained)[2], "opposite"));
  Figures higher;
  higher.film[2].force_N[1] = 4050;  // the loaded ones carry more
  higher.film[2].force_N[2] = -5000;
  BOOST_TEST(!part(judged(higher)[2], "opposite"));
  BOOST_TEST(judged(Figures{})[2].numbers.find("further out -600 N, 2 of 2 rollers") != std::string::npos);
  Figures mixed;  // 2 x -300 and 2 x +100: their sum falls, two of four carry less
  mixed.dry[2].force_N[2] = 1000;
  mixed.film[2].force_N[2] = 1100;
  BOOST_TEST(part(judged(mixed)[2], "opposite"));
  BOOST_TEST(judged(mixed)[2].numbers.find("further out -400 N, 2 of 4 rollers") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(d_fails_where_displacements_do_not_concentrate_in_both_models) {
  for (const bool film : {false, true}) {
    Figures top, side;
    (film ? top.film : top.dry)[2].approach_um[0] = film ? 2.59 : 3.19;    // no longer grows at 0 degrees
    (film ? side.film : side.dry)[2].approach_um[2] = film ? 0.09 : 0.11;  // no longer falls at 90 degrees
    BOOST_TEST(!judged(top)[3].holds);
    BOOST_TEST(!judged(side)[3].holds);
  }
  BOOST_TEST(judged(Figures{})[3].holds);
}

// One bearing at several clearances has one datum and one fit: their values count, not their kinds alone.
BOOST_AUTO_TEST_CASE(cases_with_another_datum_or_fit_do_not_differ_in_clearance_only) {
  const auto pair = [](auto change) {
    std::vector<Case> cases{made::needle_bearing(0), made::needle_bearing(2.5e-6)};
    change(std::get<BearingCase>(cases[0].body), std::get<BearingCase>(cases[1].body));
    return differ_only_in_clearance(cases);
  };
  BOOST_TEST(pair([](BearingCase&, BearingCase&) {}));
  BOOST_TEST(pair([](BearingCase& one, BearingCase& other) { one.datum = other.datum = LengthDatum{1e-3}; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase& other) {
    one.datum = LengthDatum{1e-3};
    other.datum = LengthDatum{2e-3};
  }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.datum = PalmgrenDatum{9000}; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.datum = LundbergDatum{}; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.fit.points = 7; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.fit.load_N = std::pair{1000.0, 12000.0}; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.fit.load_N.reset(); }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.ring_thickness_m = 0.004; }));
  BOOST_TEST(!pair([](BearingCase& one, BearingCase&) { one.roughness_m = 1e-7; }));
}

// Invariant: an end of a range holds, and a factor `precision` beyond it does not, judged anew from the cases.
BOOST_AUTO_TEST_CASE(the_ends_of_a_range_are_where_the_verdict_turns) {
  ContactMemory memory([](const Problem& problem, const Request&) { return made::contact(problem); });
  std::vector<Case> cases;
  for (const double clearance_m : {0.0, 2.5e-6, 10e-6}) cases.push_back(made::needle_bearing(clearance_m));
  const DatumScan scan = scan_datum(cases, bearing::Law::ehd_linear, memory);
  const auto holds_at = [&](double x0_m, char letter) {
    std::vector<ClearanceComparison> clearances;
    for (Case one : cases) {
      std::get<BearingCase>(one.body).datum = LengthDatum{x0_m};
      const auto results =
          run_bearing(one, {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .explicitly = true}, memory);
      clearances.push_back({std::get<BearingCase>(one.body).geometry.clearance_m, results[0], results[1]});
    }
    for (const PaperStatement& one : judge_paper_statements(clearances))
      if (one.letter == letter) return one.holds;
    return false;
  };
  // b of the heaviest contact by hand: 11.2 kN and F_c = 28 N at the outer raceway, R = 2.736 mm.
  const double outer_m = 1 / (2 / 0.005 - 2 / 0.058), modulus_Pa = 2.06e11 / 0.91;
  const double b = std::sqrt(8 * (11203 + 28) / 0.122 * outer_m / (std::acos(-1) * modulus_Pa));
  EHD_CHECK(error(scan.half_width_m, b), Tolerance::required(1e-3, "the load is known to four digits"));
  EHD_CHECK(error(scan.lowest_m, 0.6 * scan.half_width_m), Tolerance::round_off(2));
  int ends = 0;
  for (const auto& [letter, ranges] : {std::pair{'a', scan.a_m}, {'b', scan.b_m}, {'c', scan.c_m}, {'d', scan.d_m}})
    for (const auto& [low, high] : ranges) {
      BOOST_TEST(holds_at(low, letter), letter << " at " << low);
      BOOST_TEST(holds_at(high, letter), letter << " at " << high);
      if (low > scan.lowest_m && ++ends)
        BOOST_TEST(!holds_at(low / scan.precision, letter), letter << " below " << low);
      if (high < scan.highest_m && ++ends)
        BOOST_TEST(!holds_at(high * scan.precision, letter), letter << " above " << high);
    }
  BOOST_TEST(ends >= 3);
  for (const auto& [low, high] : scan.b_m) {
    if (low > scan.lowest_m) continue;
    BOOST_TEST(words_of(scan, {{low, high}}).find("(the scan's end) to ") != std::string::npos);
  }
  BOOST_TEST(words_of(scan, {}) == "nowhere");
  BOOST_TEST(words_of(scan, {{2 * scan.lowest_m, 3 * scan.lowest_m}}).find("scan") == std::string::npos);
}

// Invariant: what is judged of the paper does not depend on the order of the clearances, and needs three of them.
BOOST_AUTO_TEST_CASE(the_papers_statements_are_judged_from_three_clearances) {
  ContactMemory memory([](const Problem& problem, const Request&) { return made::contact(problem); });
  std::vector<Case> cases;
  std::vector<ClearanceComparison> clearances;
  for (const double clearance_m : {10e-6, 0.0, 2.5e-6}) {
    cases.push_back(made::needle_bearing(clearance_m));
    const auto results = run_bearing(
        cases.back(), {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .explicitly = true}, memory);
    clearances.push_back({clearance_m, results.at(0), results.at(1)});
  }
  BOOST_TEST(differ_only_in_clearance(cases));
  const auto statements = judge_paper_statements(clearances);
  BOOST_REQUIRE(statements.size() == 4u);
  std::reverse(clearances.begin(), clearances.end());
  const auto reversed = judge_paper_statements(clearances);
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(statements[k].letter == static_cast<char>('a' + static_cast<int>(k)));
    BOOST_TEST(statements[k].numbers == reversed[k].numbers);
    BOOST_TEST(!statements[k].numbers.empty());
  }
  clearances.pop_back();
  BOOST_TEST(judge_paper_statements(clearances).empty());
  std::get<BearingCase>(cases[1].body).operation.radial_load_N = 49e3;
  BOOST_TEST(!differ_only_in_clearance(cases));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::verification
