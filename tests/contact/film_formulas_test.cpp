// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/film_formulas.hpp"

#include <cmath>

#include "tests/check.hpp"

namespace {
using namespace ehd;
using verification::Tolerance;
}  // namespace

BOOST_AUTO_TEST_SUITE(film_formulas)

// The printed power laws and their agreement with computed films are judged by the claims formulas/*
// (verification/claims/literature.cpp).

BOOST_AUTO_TEST_CASE(moes_formula_has_the_four_asymptotes) {
  // Far into a regime the formula goes to its asymptote. The remainder is the share of the next regime.
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

BOOST_AUTO_TEST_SUITE_END()
