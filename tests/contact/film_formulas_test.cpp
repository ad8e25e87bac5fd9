// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/film_formulas.hpp"

#include <cmath>
#include <map>

#include "tests/check.hpp"

namespace {
using namespace ehd;
using verification::Tolerance;
}  // namespace

BOOST_AUTO_TEST_SUITE(film_formulas)

BOOST_AUTO_TEST_CASE(minimum_films_have_the_known_agreement_with_a_computed_one) {
  // At M = 20, L = 10, G = 5000 the computed H_min (Roelands, Dowson-Higginson density) is 3.784 in Moes units; the
  // formulas are off by the percentages that the literature notes give, to their last digit (and 3.784's own half
  // digit).
  const std::map<std::string, double> percent = {{"Dowson & Higginson 1977", 1.3},
                                                 {"Dowson & Higginson 1966", 1.9},
                                                 {"Hamrock & Jacobson 1984", -2.9},
                                                 {"Pan & Hamrock 1989", -4.9}};
  int rows = 0;
  for (const auto& formula : ehd::film_formulas({.M = 20, .L = 10}, 5000)) {
    if (formula.of != "film.minimum") continue;
    BOOST_TEST_CONTEXT(formula.name) {
      BOOST_REQUIRE(percent.contains(formula.name));
      EHD_CHECK(std::abs(formula.moes_film / 3.784 - 1 - percent.at(formula.name) / 100),
                Tolerance::calibrated(0.0005 + 0.0005 / 3.784, "half digits of the percentage and of 3.784"));
    }
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(power_laws_equal_their_printed_form_in_the_mean_speed) {
  const double G = 4300, M = 31, L = 7;
  const double U = std::pow(L / G, 4) / 2, W = M * std::pow(L / G, 2);
  const double moes = 1 / std::sqrt(2 * U);
  std::map<std::string, double> expected = {
      {"Dowson & Higginson 1966 film.minimum", 1.6 * std::pow(G, 0.6) * std::pow(U, 0.7) * std::pow(W, -0.13) * moes},
      {"Dowson & Higginson 1977 film.minimum",
       2.65 * std::pow(U, 0.70) * std::pow(G, 0.54) * std::pow(W, -0.13) * moes},
      {"Hamrock & Jacobson 1984 film.minimum",
       3.07 * std::pow(U, 0.71) * std::pow(G, 0.57) * std::pow(W, -0.11) * moes},
      {"Pan & Hamrock 1989 film.minimum", 1.714 * std::pow(W, -0.128) * std::pow(U, 0.694) * std::pow(G, 0.568) * moes},
      {"Dowson & Toyoda 1978 film.central", 3.06 * std::pow(G, 0.56) * std::pow(U, 0.69) * std::pow(W, -0.10) * moes},
      {"Pan & Hamrock 1989 film.central", 2.922 * std::pow(W, -0.166) * std::pow(U, 0.692) * std::pow(G, 0.470) * moes},
      {"Moes (Venner 1991) film.couette", moes_film_formula({.M = M, .L = L})}};
  for (const auto& formula : ehd::film_formulas({.M = M, .L = L}, G)) {
    const std::string key = formula.name + " " + formula.of;
    BOOST_TEST_CONTEXT(key) {
      BOOST_REQUIRE(expected.contains(key));
      EHD_CHECK(error(formula.moes_film, expected[key]), Tolerance::round_off(128));
    }
    expected.erase(key);
  }
  BOOST_TEST(expected.empty());
}

BOOST_AUTO_TEST_CASE(moes_formula_has_the_four_asymptotes) {
  // Far into a regime the formula is its asymptote; what is left is the next regime's share, named by its ratio.
  const auto check = [](double M, double L, double asymptote, double remainder, const char* why) {
    BOOST_TEST_CONTEXT("M = " << M << ", L = " << L) {
      EHD_CHECK(error(moes_film_formula({.M = M, .L = L}), asymptote), Tolerance::asymptotic(remainder, why));
    }
  };
  // RI: (1 + (EI/RI)^(7/3))^(3/7), EI/RI = 2.621 M^(4/5)/3.
  check(1e-3, 0, 3 / 1e-3, 3.0 / 7 * std::pow(2.621 / 3 * std::pow(1e-3, 0.8), 7.0 / 3) * 1.01, "EI beside RI");
  check(1e6, 0, 2.621 * std::pow(1e6, -0.2), 3.0 / 7 * std::pow(3 / 2.621 * std::pow(1e6, -0.8), 7.0 / 3) * 1.01,
        "RI beside EI");
  // EP: s = 7/5 at large M. The share of EI is (EI/EP)^s/s, that of RP (EP/RP)^(7/2) 2/7.
  const double M = 1e6, L = 50;
  const double ep = 1.311 * std::pow(M, -0.125) * std::pow(L, 0.75), ei = 2.621 * std::pow(M, -0.2);
  const double rp = 1.287 * std::pow(L, 2.0 / 3);
  check(M, L, ep, (std::pow(ei / ep, 1.4) / 1.4 + std::pow(ep / rp, 3.5) * 2 / 7) * 1.01, "EI and RP beside EP");
}

BOOST_AUTO_TEST_CASE(moes_formula_lies_within_its_stated_5_percent_of_computed_films) {
  // Barus, incompressible, X = 0 film in Moes units (computed, 0.1 %, 0.3 % at M = 200).
  struct Row {
    double M, L, central;
  };
  int rows = 0;
  for (const Row row : {Row{2, 5, 4.5521}, Row{5, 10, 6.0726}, Row{20, 0, 1.4204}, Row{20, 10, 5.2764},
                        Row{100, 15, 5.7503}, Row{200, 5, 2.5810}}) {
    BOOST_TEST_CONTEXT("M = " << row.M << ", L = " << row.L) {
      EHD_CHECK(error(moes_film_formula({.M = row.M, .L = row.L}), row.central),
                Tolerance::required(0.05, "within 5 % for M >= 2, by the literature notes"));
    }
    ++rows;
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(without_G_or_piezoviscosity_only_moes_formula_is_left) {
  BOOST_TEST(ehd::film_formulas({.M = 20, .L = 0}, 5000).size() == 1U);
  BOOST_TEST(ehd::film_formulas({.M = 20, .L = 10}, 0).size() == 1U);
  BOOST_TEST(ehd::film_formulas({.M = 20, .L = 10}, 5000).size() == 7U);
}

// In SI, from the printed form: W = w/(E'R), U = eta_0 u_m/(E'R), G = alpha E'.
BOOST_AUTO_TEST_CASE(the_spike_formula_equals_its_printed_form) {
  const double G = 4700, M = 23, L = 8, modulus = 2.1e11, radius = 0.013;
  const double U = std::pow(L / G, 4) / 2, W = M * std::pow(L / G, 2);
  const double load = W * modulus * radius, pi = 3.14159265358979323846;
  const double half_width = std::sqrt(8 * load * radius / (pi * modulus)),
               hertz_pressure = 2 * load / (pi * half_width);
  const SpikeFormula spike = pan_hamrock_spike({.M = M, .L = L}, G);
  EHD_CHECK(error(spike.height * hertz_pressure,
                  modulus * 0.648 * std::pow(W, 0.185) * std::pow(U, 0.275) * std::pow(G, 0.391)),
            Tolerance::round_off(128));
  EHD_CHECK(
      error(spike.place * half_width, radius * 1.111 * std::pow(W, 0.606) * std::pow(U, -0.021) * std::pow(G, 0.077)),
      Tolerance::round_off(128));
  EHD_CHECK(error(spike.minimum_place * half_width,
                  radius * 1.439 * std::pow(W, 0.548) * std::pow(U, -0.011) * std::pow(G, 0.026)),
            Tolerance::round_off(128));
}

BOOST_AUTO_TEST_SUITE_END()
