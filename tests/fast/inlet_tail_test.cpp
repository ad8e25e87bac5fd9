// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/inlet_tail.hpp"

#include <cmath>
#include <numbers>

#include "tests/check.hpp"
#include "tests/quadrature.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

/// The model's ODE, integrated by GSL: the truth for the rule on 12 points.
struct Model {
  double far, excess, moment, flux, lambda, slope;
  [[nodiscard]] double gap(double x) const {
    return x * x / 2 + excess - std::log(x / far) / 2 - moment / std::numbers::pi * (1 / x - 1 / far);
  }
};

double to_infinity(const testing::Function& f, double from) { return testing::integral_to_infinity(f, from, 1e-10); }

double pressure(const Model& m, double x) {
  const double reduced = to_infinity(
      [&](double t) {
        const double h = m.gap(t);
        return m.lambda * (1 / (h * h) - m.flux / (h * h * h));
      },
      x);
  return m.slope > 0 ? -std::log1p(-m.slope * reduced) / m.slope : reduced;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(inlet_tail)

BOOST_AUTO_TEST_CASE(pressure_load_and_deflection_are_those_of_the_model) {
  // (M, L) about (1, 5): l = 1.8, the grid begins at -4 l.
  const Model model{.far = 7.4, .excess = 0.83, .moment = -0.4, .flux = 2.1, .lambda = 3.7, .slope = 1.9};
  const auto tail = fast::inlet_tail(model.far, model.excess, model.moment, model.flux, model.lambda, model.slope);
  const Tolerance rule = Tolerance::discretisation(1e-7, 2);  // 12 points on t^2 ln t
  EHD_CHECK(error(tail.pressure, pressure(model, model.far)), rule);
  const double load = to_infinity([&](double x) { return pressure(model, x); }, model.far);
  EHD_CHECK(error(tail.load, load), rule);

  const double X = 0.9;
  const double expected =
      -to_infinity([&](double x) { return pressure(model, x) * std::log(x + X); }, model.far) / std::numbers::pi;
  double polynomial = 0;
  for (int k = 4; k >= 0; --k) polynomial = polynomial * X + tail.deflection[k];
  EHD_CHECK(error(polynomial, expected),
            Tolerance::asymptotic(std::pow(X / model.far, 5), "first term left out of the Taylor polynomial"));
}

BOOST_AUTO_TEST_CASE(far_out_the_leading_term_remains) {
  int rows = 0;
  for (const double far : {50.0, 100.0, 200.0}) {
    const auto tail = fast::inlet_tail(far, 1.3, -0.2, 0.7, 2.9, 0.6);
    // Next term -(16 A + 8 C)/(5 x^5) against 4/(3 x^3).
    const double remainder = 2 * (16 * 1.3 + 8 * 0.7) / 5 * 3 / 4 / (far * far);
    const Tolerance next = Tolerance::asymptotic(remainder, "twice the next term of the series");
    EHD_CHECK(error(tail.pressure, 2.9 * 4 / (3 * std::pow(far, 3))), next);
    EHD_CHECK(error(tail.load, 2.9 * 2 / (3 * far * far)), next);
    ++rows;
  }
  BOOST_REQUIRE_EQUAL(rows, 3);
}

BOOST_AUTO_TEST_SUITE_END()
