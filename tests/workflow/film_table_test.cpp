// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/check.hpp"
#include "tests/made_table.hpp"
#include "workflow/registry.hpp"

using namespace ehd;
using namespace ehd::verification;
using ehd::testing::corner_films;
using ehd::testing::corner_M;
using ehd::testing::corner_range;
using ehd::testing::corner_source;
using ehd::testing::corner_table;
using ehd::testing::made_films;
using ehd::testing::made_oil;
using ehd::testing::made_range;
using ehd::testing::made_source;
using ehd::testing::made_table;

namespace {

/// Points that are no nodes and no held-out points of a table.
std::vector<MoesGroups> other_points(const FilmRange& range, int count) {
  std::vector<MoesGroups> points;
  for (int i = 0; i < count; ++i) {
    const double u = std::fmod(0.31 + 0.6180339887 * i, 1), v = std::fmod(0.17 + 0.7548776662 * i, 1);
    points.push_back({.M = range.M_low * std::pow(range.M_high / range.M_low, u),
                      .L = range.L_low + v * (range.L_high - range.L_low)});
  }
  return points;
}

/// A central film that bends where M = 30.
ByFilm<double> bent_films(const MoesGroups& at) {
  ByFilm<double> films = made_films(at);
  films[1] *= 1 + 0.1 * std::abs(std::log(at.M / 30));
  return films;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(film_table)

BOOST_AUTO_TEST_CASE(a_table_meets_its_tolerance_and_its_stated_errors_hold_elsewhere) {
  for (const double tolerance : {1e-3, 1e-5}) {
    const FilmTable table = made_table(tolerance);
    BOOST_TEST((table.status == StopReason::converged));
    for (const MoesGroups& at : other_points(made_range, 300)) {
      const auto films = *films_at(table, at);
      const auto truth = made_films(at);
      for (std::size_t k = 0; k < table_film_count; ++k) {
        BOOST_TEST(table.errors[k].stated <= tolerance);
        EHD_CHECK(std::abs(films[k].value - truth[k]) / table_error_unit(table_films[k], truth[k]),
                  Tolerance::required(table.errors[k].stated, "the table states it"));
      }
    }
  }
}

/// The derivatives of all films against central differences over `step` of ln M and of L: step^2 times a third
/// derivative of at most `third` films, and rounding over the step.
void check_derivatives(const FilmTable& table, const MoesGroups& at, double step, double third) {
  const auto films = *films_at(table, at);
  const double d = step * at.M;
  const auto right = *films_at(table, {at.M + d, at.L}), left = *films_at(table, {at.M - d, at.L});
  const auto up = *films_at(table, {at.M, at.L + step}), down = *films_at(table, {at.M, at.L - step});
  const Tolerance small = Tolerance::asymptotic(third * step * step + 1e-14 / step, "step^2, and rounding/step");
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const double film = films[k].value - table_shift(table_films[k]);
    EHD_CHECK(std::abs(films[k].by_M - (right[k].value - left[k].value) / (2 * d)) * at.M / film, small);
    EHD_CHECK(std::abs(films[k].by_L - (up[k].value - down[k].value) / (2 * step)) / film, small);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_agree_with_differences) {
  const FilmTable table = made_table();
  for (const MoesGroups& at : other_points({.M_low = 7.1, .M_high = 390, .L_low = 2.1, .L_high = 17.9}, 40))
    check_derivatives(table, at, 1e-4, 10);
}

BOOST_AUTO_TEST_CASE(derivatives_agree_with_differences_in_panels_with_curved_edges) {
  const FilmTable table = corner_table();
  int curved = 0;
  for (const MoesGroups& at : other_points({.M_low = 1.21, .M_high = 6.9, .L_low = 2.1, .L_high = 17.9}, 200)) {
    if (std::abs(std::log(at.M / corner_M(at.L))) < 0.05) continue;
    ++curved;
    check_derivatives(table, at, 1e-5, 300);  // of the root 0.05 from the corner
  }
  BOOST_TEST(curved > 100);
}

BOOST_AUTO_TEST_CASE(a_corner_of_the_central_film_becomes_an_edge_and_the_stated_errors_hold_beside_it) {
  const FilmTable table = corner_table();
  BOOST_TEST((table.status == StopReason::converged));
  BOOST_TEST(table.solves + table.held_out < 1500);
  std::vector<MoesGroups> points = other_points(corner_range, 300);
  BOOST_REQUIRE(table.at_bend.has_value());
  BOOST_REQUIRE(table.at_bend->stated.has_value());
  BOOST_TEST((*table.at_bend->stated)[1] > table.errors[1].stated);
  BOOST_TEST((*table.at_bend->stated)[1] < 0.1);
  for (const double distance : {1e-6, 1e-5, 5e-5, 2e-4, 5e-4, 1e-3, 1e-2, 5e-2})
    for (const double L : {2.1, 5.3, 9.7, 17.6})
      for (const double side : {-1.0, 1.0}) points.push_back({corner_M(L) * std::exp(side * distance), L});
  for (const MoesGroups& at : points) {
    const auto films = *films_at(table, at);
    const auto truth = corner_films(at);
    for (std::size_t k = 0; k < table_film_count; ++k)
      EHD_CHECK(std::abs(films[k].value - truth[k]) / table_error_unit(table_films[k], truth[k]),
                Tolerance::stated(films[k].error));
  }
}

BOOST_AUTO_TEST_CASE(panels_may_reach_outside_the_range_but_the_table_does_not) {
  FilmRange narrow = corner_range;
  narrow.M_low = 1.5;  // the corner is at M = 1.33 to 1.93
  const FilmTable table = build_film_table(made_oil(), {.range = narrow, .tolerance = 1e-4}, corner_source());
  BOOST_TEST((table.status == StopReason::converged));
  bool reaches_outside = false;
  for (const FilmPanel& panel : table.panels) reaches_outside |= ends_of(panel.shape.low).first < narrow.M_low;
  BOOST_TEST(reaches_outside);
  BOOST_TEST(!films_at(table, {1.49, 5}).has_value());
  for (const MoesGroups& at : other_points(narrow, 300))
    EHD_CHECK(error((*films_at(table, at))[1].value, corner_films(at)[1]),
              Tolerance::required(table.errors[1].stated, "the table states it"));
}

// Without panels beside the bend this table ended with tolerance-not-met.
BOOST_AUTO_TEST_CASE(a_table_of_barus_oil_holds_the_corner_at_high_L) {
  const TableOil oil{.lubricant = {.viscosity = ViscosityLaw::barus, .density = DensityLaw::incompressible}};
  const FilmTableRequest request{.range = {.M_low = 1.5, .M_high = 2.5, .L_low = 18, .L_high = 20}, .tolerance = 1e-3};
  const FilmTable table = build_film_table(oil, request, film_solves(oil, request.tolerance, 1, 60));
  BOOST_TEST((table.status == StopReason::converged));
  BOOST_TEST(table.solves + table.held_out < 800);
  for (const double M : {1.77, 1.785, 1.787, 1.7935, 1.81}) {
    const MoesGroups at{M, 19.9};  // the corner is at M = 1.787
    const Solution solution = default_solver().solve(problem_of(oil, at), {.tolerance = 1e-5});
    const FilmAt central = (*films_at(table, at))[1];
    EHD_CHECK(error(central.value, solution.observables.at(Quantity::film_central).value),
              Tolerance::stated(central.error));
  }
}

// The contacts next to the bend are the only ones beside which the peak is this near to X = 0.
BOOST_AUTO_TEST_CASE(where_no_contact_next_to_the_bend_is_solved_no_error_is_known_there) {
  const FilmSource failing = [](const std::vector<MoesGroups>& contacts) {
    std::vector<SolvedFilms> solved = corner_source()(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (std::abs(std::log(contacts[i].M / corner_M(contacts[i].L))) < 1.5e-4) solved[i].why = "diverged";
    return solved;
  };
  const FilmTable table = build_film_table(made_oil(), {.range = corner_range, .tolerance = 1e-4}, failing);
  BOOST_REQUIRE((table.status == StopReason::converged));
  BOOST_REQUIRE(table.at_bend.has_value());
  BOOST_TEST(!table.at_bend->stated.has_value());
  BOOST_TEST(!std::isfinite((*films_at(table, {corner_M(7) * 1.0001, 7}))[1].error));
  BOOST_TEST((*films_at(table, {1.1 * corner_M(7), 7}))[1].error == table.errors[1].stated);
}

// The solves next to the bend stated .006 for the Couette film, until they were asked once more.
BOOST_AUTO_TEST_CASE(a_loose_table_across_the_bend_converges_as_tighter_ones_do) {
  const FilmTableRequest request{.range = {.M_low = 1, .M_high = 100, .L_low = 5, .L_high = 20}, .tolerance = 5e-3};
  const FilmTable table = build_film_table(made_oil(), request, film_solves(made_oil(), request.tolerance, 1, 60));
  BOOST_TEST((table.status == StopReason::converged));
  BOOST_TEST(table.errors[2].solves <= solve_share * request.tolerance);
}

BOOST_AUTO_TEST_CASE(outside_the_range_there_is_no_film) {
  const FilmTable table = made_table();
  const FilmRange& in = made_range;
  for (const MoesGroups& at : {MoesGroups{in.M_low, in.L_low}, MoesGroups{in.M_high, in.L_high}, MoesGroups{7, 10}})
    BOOST_TEST(films_at(table, at).has_value());
  const double nan = testing::not_a_number;
  for (const MoesGroups& at : {MoesGroups{2.999, 10}, MoesGroups{400.1, 10}, MoesGroups{20, 1.999},
                               MoesGroups{20, 18.01}, MoesGroups{nan, 10}, MoesGroups{20, nan}, MoesGroups{-20, 10}})
    BOOST_TEST(!films_at(table, at).has_value());
}

BOOST_AUTO_TEST_CASE(no_contact_is_solved_twice_and_every_one_is_counted) {
  std::vector<MoesGroups> asked;
  const FilmTable table =
      build_film_table(made_oil(), {.range = made_range, .tolerance = 1e-5}, made_source(made_films, &asked));
  BOOST_TEST(static_cast<long>(asked.size()) == table.solves + table.held_out);
  long coefficients = 0;
  for (const FilmPanel& panel : table.panels) coefficients += (panel.degree_M + 1L) * (panel.degree_L + 1L);
  BOOST_TEST(table.solves == coefficients);
  std::vector<std::pair<double, double>> places;
  for (const MoesGroups& at : asked) {
    BOOST_TEST(made_range.contains(at));
    places.emplace_back(at.M, at.L);
  }
  std::sort(places.begin(), places.end());
  // The two panels share the nodes at M = 7, at most one a degree of L.
  const auto shared = std::distance(std::unique(places.begin(), places.end()), places.end());
  BOOST_TEST(shared <= table.panels.front().degree_L + 1);
}

BOOST_AUTO_TEST_CASE(a_range_that_holds_the_bend_of_the_central_film_is_split) {
  const auto ends = [](double low, double high) {
    const FilmTable table = build_film_table(
        made_oil(), {.range = {.M_low = low, .M_high = high, .L_low = 2, .L_high = 18}, .tolerance = 1e-3},
        made_source(made_films));
    std::vector<double> M{ends_of(table.panels.front().shape.low).first};
    for (const FilmPanel& panel : table.panels) M.push_back(ends_of(panel.shape.high).first);
    for (double& one : M) one = std::round(1e9 * one) / 1e9;  // the exponential of a logarithm
    return M;
  };
  BOOST_TEST((ends(2, 1000) == std::vector<double>{2, 7, 1000}));
  BOOST_TEST((ends(0.5, 100) == std::vector<double>{0.5, 1, 7, 100}));
  BOOST_TEST((ends(10, 100) == std::vector<double>{10, 100}));
}

BOOST_AUTO_TEST_CASE(a_tolerance_that_cannot_be_met_is_said_with_the_error_found) {
  const FilmTableRequest request{.range = made_range, .tolerance = 1e-5, .most_solves = 800};
  const FilmTable table = build_film_table(made_oil(), request, made_source(bent_films));
  BOOST_TEST((table.status == StopReason::tolerance_not_met));
  BOOST_TEST(table.reason.find("film.central") != std::string::npos);
  BOOST_TEST(table.solves + table.held_out <= request.most_solves);
  BOOST_TEST(table.errors[1].stated > request.tolerance);
  BOOST_TEST(!table.panels.empty());
  double worst = 0;
  for (const MoesGroups& at : other_points(made_range, 300))
    worst = std::max(worst, error((*films_at(table, at))[1].value, bent_films(at)[1]));
  EHD_CHECK(worst, Tolerance::required(table.errors[1].stated, "the table states it, also where it misses"));
}

// One panel has the largest difference to a held-out solve, the other the largest error of a solve.
BOOST_AUTO_TEST_CASE(a_table_of_two_panels_converges_only_where_both_together_meet_the_tolerance) {
  constexpr double tolerance = 1e-3;
  const auto made = [](double error_above) {
    const FilmSource source = [=](const std::vector<MoesGroups>& contacts) {
      std::vector<SolvedFilms> solved;
      for (const MoesGroups& at : contacts) {
        SolvedFilms& one = solved.emplace_back();
        one.value = made_films(at);
        one.value[1] *= 1 + 0.02 * std::abs(std::log(std::min(at.M, 7.0) / 3));  // a bend
        one.error.fill(at.M < 7.01 ? 0 : error_above);
      }
      return solved;
    };
    return build_film_table(
        made_oil(), {.range = {.M_low = 2, .M_high = 20, .L_low = 2, .L_high = 18}, .tolerance = tolerance}, source);
  };
  for (const double share : {0.2, 0.9}) {  // what each solve is asked for, and more
    const FilmTable table = made(share * tolerance);
    BOOST_REQUIRE(table.panels.size() == 2u);
    BOOST_TEST(table.errors[1].found > 0.03 * tolerance);
    BOOST_TEST(table.errors[1].stated == 3 * table.errors[1].found + table.errors[1].solves);
    BOOST_TEST((table.status == StopReason::converged) == (table.errors[1].stated <= tolerance));
    BOOST_TEST((table.status == StopReason::converged) == (share == 0.2));
  }
}

BOOST_AUTO_TEST_CASE(solves_that_state_more_than_the_tolerance_end_the_growth_at_once) {
  const FilmTable table =
      build_film_table(made_oil(), {.range = made_range, .tolerance = 1e-8}, made_source(made_films));
  BOOST_TEST((table.status == StopReason::tolerance_not_met));
  BOOST_TEST(table.errors[0].solves == 1e-7);
  BOOST_TEST(table.errors[0].stated > 1e-7);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_not_solved_leaves_no_table_and_is_named) {
  const FilmSource failing = [](const std::vector<MoesGroups>& contacts) {
    std::vector<SolvedFilms> solved(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) solved[i].value = made_films(contacts[i]);
    solved.back().why = "diverged: it fled";
    return solved;
  };
  const FilmTable table = build_film_table(made_oil(), {.range = made_range, .tolerance = 1e-3}, failing);
  BOOST_TEST((table.status == StopReason::limit_reached));
  BOOST_TEST(table.panels.empty());
  for (const char* text : {"M = ", "L = ", "it fled"})
    BOOST_CHECK_MESSAGE(table.reason.find(text) != std::string::npos, text << " is not in " << table.reason);
}

BOOST_AUTO_TEST_CASE(an_offset_below_its_dry_value_is_refused) {
  const auto too_deep = [](const MoesGroups& at) {
    ByFilm<double> films = made_films(at);
    films[3] = -0.7;
    return films;
  };
  const FilmTable table = build_film_table(made_oil(), {.range = made_range, .tolerance = 1e-3}, made_source(too_deep));
  BOOST_TEST((table.status == StopReason::limit_reached));
  BOOST_TEST(table.reason.find("film.offset") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_table_of_solves_has_the_films_of_a_solve) {
  const FilmTableRequest request{.range = {.M_low = 15, .M_high = 40, .L_low = 6, .L_high = 9}, .tolerance = 1e-3};
  const FilmTable table = build_film_table(made_oil(), request, film_solves(made_oil(), request.tolerance, 2, 60));
  BOOST_REQUIRE((table.status == StopReason::converged));
  const MoesGroups at{21.3, 7.4};
  const Solution solution = default_solver().solve(problem_of(made_oil(), at), {.tolerance = 1e-5});
  const auto films = *films_at(table, at);
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const double truth = solution.observables.at(table_films[k]).value;
    EHD_CHECK(std::abs(films[k].value - truth) / table_error_unit(table_films[k], truth),
              Tolerance::required(table.errors[k].stated, "the table states it"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
