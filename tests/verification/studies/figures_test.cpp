// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/figures/figures.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "contact/hertz.hpp"
#include "io/json.hpp"
#include "tests/check.hpp"
#include "verification/studies/figures/curves.hpp"
#include "verification/studies/figures/parts.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

double interpolated(const std::vector<double>& X, const std::vector<double>& Y, double x) {
  const auto above = std::upper_bound(X.begin() + 1, X.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - X.begin());
  return Y[i - 1] + (Y[i] - Y[i - 1]) * (x - X[i - 1]) / (X[i] - X[i - 1]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_figures)

BOOST_AUTO_TEST_CASE(a_thinned_curve_keeps_its_bound_and_its_ends) {
  std::vector<double> X, bump, line;
  constexpr int points = 2001;
  for (int i = 0; i < points; ++i) {
    X.push_back(-3 + 6.0 * i / (points - 1));
    bump.push_back(std::exp(-40 * X.back() * X.back()));
    line.push_back(2 - 3 * X.back());
  }
  const std::vector<double> allowed(points, 1e-3);
  const Thinning thinning = thin(X, {{bump, allowed}, {line, allowed}}, points);
  BOOST_TEST(thinning.factor == 1);
  BOOST_TEST(thinning.kept.front() == 0U);
  BOOST_TEST(thinning.kept.back() == points - 1U);
  BOOST_TEST(thinning.kept.size() < 80U);
  std::vector<double> x, y;
  for (const std::size_t i : thinning.kept) x.push_back(X[i]), y.push_back(bump[i]);
  double worst = 0;
  for (std::size_t i = 0; i < X.size(); ++i) worst = std::max(worst, std::abs(interpolated(x, y, X[i]) - bump[i]));
  EHD_CHECK(worst, Tolerance::required(1e-3 * (1 + 1e-12), "the bound given, and rounding"));
  // Most points stand where the curve bends.
  BOOST_TEST(std::count_if(x.begin(), x.end(), [](double at) { return std::abs(at) < 0.5; }) >
             static_cast<long>(x.size()) - 10);

  const Thinning coarse = thin(X, {{bump, allowed}}, 12);
  BOOST_TEST(coarse.kept.size() <= 12U);
  BOOST_TEST(coarse.factor > 1);
  BOOST_CHECK_THROW((void)thin({1}, {}, 10), std::invalid_argument);
  BOOST_CHECK_THROW((void)thin({1, 2}, {{{1}, {1}}}, 10), std::invalid_argument);
}

// Exact: the gap of the dry contact, outside its edge, from Hertz's pressure.
BOOST_AUTO_TEST_CASE(the_gap_behind_the_exit_is_hertz_gap_for_hertz_pressure) {
  constexpr int intervals = 20000;
  Array X(intervals + 1), P(intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    X[i] = -std::cos(3.14159265358979323846 * i / intervals);  // nodes crowd where the pressure has its root
    P[i] = std::sqrt(std::max(0.0, 1 - X[i] * X[i]));
  }
  const Profile pressure(X, P);
  int rows = 0;
  for (const double x : {1.0, 1.07, 1.4, 2.5}) {
    const double gap = (x * std::sqrt(x * x - 1) - std::log(x + std::sqrt(x * x - 1))) / 2;
    EHD_CHECK(std::abs(gap_behind_exit(pressure, x) - gap),
              Tolerance::discretisation(1.0 / intervals / intervals, 100));
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(a_case_has_two_profiles_and_their_difference) {
  const Json made = ehd::verification::figures({.case_id = "own-moes-5-5"});
  BOOST_TEST(!made.contains("failed"));
  BOOST_TEST(!made.contains("maps"));
  BOOST_REQUIRE(made.at("cases").size() == 1);
  const Json& one = made["cases"][0];
  BOOST_TEST(one["viscosity"] == "roelands");
  BOOST_TEST(one["inlet"] == -4.0);
  BOOST_REQUIRE(one["solvers"].size() == 2);
  for (const Json& solver : one["solvers"]) {
    BOOST_TEST(solver["status"] == "converged");
    const auto X = solver["X"].get<std::vector<double>>(), P = solver["P"].get<std::vector<double>>(),
               H = solver["H"].get<std::vector<double>>();
    BOOST_REQUIRE((X.size() == P.size() && X.size() == H.size() && X.size() > 20 && X.size() <= 400));
    BOOST_TEST(std::is_sorted(X.begin(), X.end()));
    const double exit = solver["pressure"]["exit_x"], smallest = solver["film"]["minimum"]["hertz"],
                 highest = solver["pressure"]["maximum"]["hertz"];
    BOOST_TEST(X.back() > exit);
    BOOST_TEST(P.back() == 0);
    BOOST_TEST(H.back() > 1.5 * smallest);  // the gap opens behind the exit
    // The extremes of the drawn curves are the reported ones within the chords' bound.
    const double chord = solver["chord_error"];
    EHD_CHECK(error(*std::min_element(H.begin(), H.end()), smallest), Tolerance::required(2 * chord, "chords"));
    EHD_CHECK(error(*std::max_element(P.begin(), P.end()), highest), Tolerance::required(2 * chord, "chords"));
  }
  const Json& difference = one.at("difference");
  BOOST_TEST(difference["X"].size() == difference["P"].size());
  BOOST_TEST(difference["X"].size() == difference["H_relative"].size());
  EHD_CHECK(std::abs(difference["film_central"].get<double>()),
            Tolerance::discretisation(difference["stated"].get<double>(), 1));
}

BOOST_AUTO_TEST_CASE(quick_convergence_shows_declared_and_fitted_orders) {
  const Json made = ehd::verification::figures({.rung = 5, .quick = true});
  BOOST_TEST(!made.contains("failed"));
  BOOST_TEST(!made.contains("cases"));
  BOOST_REQUIRE(made.contains("convergence"));
  int algebraic = 0, geometric = 0;
  for (const Json& series : made["convergence"]) {
    BOOST_TEST(series["points"].size() >= 4);
    if (series["kind"] == "geometric") {
      BOOST_TEST(series["fitted_factor"].get<double>() > 2);
      ++geometric;
      continue;
    }
    EHD_CHECK(std::abs(series["fitted_order"].get<double>() - series["declared_order"].get<double>()),
              Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth"));
    ++algebraic;
  }
  BOOST_TEST(algebraic == 8);
  BOOST_TEST(geometric == 1);
}

BOOST_AUTO_TEST_CASE(no_order_is_declared_of_the_smallest_film_beside_a_spike_or_fitted_to_three_grids) {
  const Json made = ehd::verification::figures({.rung = 8, .quick = true});
  BOOST_TEST(!made.contains("failed"));
  int spiked = 0, declared = 0, unfitted = 0, fitted = 0;
  for (const Json& series : made.at("convergence")) {
    BOOST_TEST_CONTEXT(series["id"]) {
      if (series["kind"] == "geometric") continue;
      BOOST_TEST(series["case"] == "own-moes-20-10");  // Roelands, a spike at X = 0.9
      const bool says = series["title"].get<std::string>().find("no order is declared") != std::string::npos;
      if (series["quantity"] == "film.minimum") {
        BOOST_TEST(!series.contains("declared_order"));
        spiked += says ? 1 : 0;
      } else {
        BOOST_TEST(!says);
        declared += series.contains("declared_order") ? 1 : 0;
      }
      if (series.contains("fitted_order")) BOOST_TEST(series["fitted_points"].get<int>() >= 4);
      (series.contains("fitted_order") ? fitted : unfitted) += 1;
      if (series["points"].size() < 4) BOOST_TEST(!series.contains("fitted_order"));
    }
  }
  BOOST_TEST(spiked == 4);  // every solver's own grids
  BOOST_TEST(declared == 4);
  BOOST_TEST(unfitted >= 4);  // dense solvers stand on three grids here
  BOOST_TEST(fitted >= 1);
}

BOOST_AUTO_TEST_CASE(the_bearing_has_three_laws_at_three_clearances_and_the_statements) {
  const Json made = ehd::verification::figures({.rung = 11, .quick = true});
  BOOST_TEST(!made.contains("failed"));
  BOOST_REQUIRE(made.at("bearing").size() == 3);
  double before = -1;
  for (const Json& bearing : made["bearing"]) {
    BOOST_TEST(bearing["clearance_m"].get<double>() > before);
    before = bearing["clearance_m"];
    BOOST_REQUIRE(bearing["laws"].size() == 3);
    for (const Json& law : bearing["laws"]) BOOST_TEST(law["rollers"].size() == 22);
  }
  BOOST_REQUIRE(made.at("times").size() == 1);  // in a quick run nothing is in motion
  BOOST_TEST(made["times"][0]["name"] == "bearing");
  BOOST_TEST(made["times"][0]["wall_s"].get<double>() > 0);
  BOOST_TEST(made.at("statements").size() == 8);
  BOOST_REQUIRE(made.at("force_law").size() == 18);
  for (const Json& law : made["force_law"]) {
    const auto delta = law["displacement_m"].get<std::vector<double>>(),
               force = law["force_N"].get<std::vector<double>>();
    BOOST_TEST(delta.size() == force.size());
    BOOST_TEST(std::is_sorted(delta.begin(), delta.end()));
    BOOST_TEST(std::is_sorted(force.begin(), force.end()));
    if (law["law"] == "ehd") {
      const auto film = law["film_minimum_m"].get<std::vector<double>>();
      BOOST_TEST(film.size() == force.size());
      BOOST_TEST(std::is_sorted(film.rbegin(), film.rend()));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_rung_without_figures_has_none) {
  const Json made = ehd::verification::figures({.rung = 1});
  BOOST_TEST(made.size() == 1U);  // threads alone
}

BOOST_AUTO_TEST_CASE(after_the_deadline_there_are_no_figures) {
  constexpr double passed_s = -1;
  BOOST_TEST(ehd::verification::figures({.rung = 5, .quick = true, .deadline = ehd::Deadline(passed_s)}).is_null());
}

BOOST_AUTO_TEST_SUITE_END()
