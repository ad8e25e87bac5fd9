// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/observables.hpp"

#include <cmath>
#include <numbers>

#include "tests/check.hpp"

namespace {

using namespace ehd;
using std::numbers::pi;
using verification::Tolerance;

/// Nodes from a to b, crowded by `bend` towards the middle so that no spacing equals another.
Array graded(double a, double b, Eigen::Index intervals, double bend = 0.3) {
  const Array s = Array::LinSpaced(intervals + 1, 0.0, 1.0);
  return a + (b - a) * (s + bend * (2 * pi * s).sin() / (2 * pi));
}

/// Fields of closed form on a grid; constants distinguishable, density not 1 at the exit.
Fields fields_on(const Array& X, const Array& P, const Array& H) {
  Fields fields;
  fields.X = X;
  fields.P = P;
  fields.H = H;
  fields.density = 1.07 + 0.1 * P;
  fields.log_viscosity = 3 * P;
  fields.flux = Array::Constant(X.size() - 1, 0.25);
  fields.offset = -0.41;
  return fields;
}

double value(const Observables& seen, Quantity quantity) { return seen.at(quantity).value; }

/// The largest ratio of error to h^order over four grids of 2^k intervals stays bounded if the order is right; here the
/// order is fitted through the four and returned.
template <class F>
double fitted_order(F error_of, int coarsest) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int k = 0; k < 4; ++k) {
    const double x = std::log2(static_cast<double>(coarsest << k)), y = -std::log2(error_of(coarsest << k));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (4 * sxy - sx * sy) / (4 * sxx - sx * sx);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(observables)

BOOST_AUTO_TEST_CASE(interpolation_reproduces_a_polynomial_of_its_degree) {
  Array nodes(6);
  nodes << -0.3, -0.22, -0.05, 0.01, 0.2, 0.27;
  const auto quintic = [](auto x) { return 1.3 - 0.7 * x + 2 * x * x - 5 * x * x * x + 11 * x * x * x * x * x; };
  const Array values = quintic(nodes);
  int rows = 0;
  for (const double x : {-0.3, -0.1, 0.0, 0.13, 0.27}) {
    // Condition: the sum of |Lagrange polynomials| over these nodes, below 10.
    EHD_CHECK(error(interpolate(nodes, values, x), quintic(x)), Tolerance::round_off(50, 10));
    ++rows;
  }
  BOOST_TEST(rows == 5);
}

BOOST_AUTO_TEST_CASE(the_minimum_film_lies_between_the_nodes) {
  // A quartic with its minimum 0.052 at X = 0.8137, not a node.
  const auto film = [](auto x) {
    const auto t = x - 0.8137;
    return 0.052 + 0.9 * t * t + 0.4 * t * t * t + 0.7 * t * t * t * t;
  };
  const Array X = graded(-2, 1.1, 40);
  const auto seen = observe(fields_on(X, 1 - X.square(), film(X)), want_everything());
  // Exact for a quartic; golden section finds the place to the root of eps, the value to eps.
  EHD_CHECK(error(value(seen, Quantity::film_minimum), 0.052), Tolerance::round_off(1000));
  EHD_CHECK(error(seen.at(Quantity::film_minimum).place.value(), 0.8137),
            Tolerance::asymptotic(1e-6, "root of eps times the root of H/H''"));
  BOOST_TEST(film(X).minCoeff() > 0.052 * (1 + 1e-6));  // the smallest node is something else
}

BOOST_AUTO_TEST_CASE(a_smooth_minimum_film_converges_with_the_order_of_its_quartic) {
  const auto film_error = [](int n) {
    const Array X = graded(-2, 1.1, n);
    const Array H = 1 + ((X - 0.61).exp() - 1).square();
    return error(value(observe(fields_on(X, 1 - X.square(), H), {Quantity::film_minimum}), Quantity::film_minimum),
                 1.0);
  };
  // Five nodes: the error is of order 5 where the minimum lies in general position, and of order 6 or more on average.
  BOOST_TEST(fitted_order(film_error, 32) >= 4.5);
}

BOOST_AUTO_TEST_CASE(a_minimum_at_either_end_is_that_node) {
  const Array X = graded(-2, 1.1, 12);
  const auto at = [&](const Array& H) {
    return observe(fields_on(X, 1 - X.square(), H), {Quantity::film_minimum}).at(Quantity::film_minimum);
  };
  EHD_CHECK(error(at(2 - X).value, 2 - 1.1), Tolerance::round_off(8));
  EHD_CHECK(error(at(3 + X).place.value(), -2), Tolerance::round_off(8));
}

BOOST_AUTO_TEST_CASE(the_central_film_is_at_zero_and_not_at_a_node) {
  const Array X = graded(-2, 1.1, 30);
  BOOST_TEST(X.abs().minCoeff() > 1e-3);
  const Array H = 0.31 + 0.2 * X + 0.7 * X.square() - 1.1 * X.cube() + X.square().square() * X;
  EHD_CHECK(error(value(observe(fields_on(X, 1 - X.square(), H), want_everything()), Quantity::film_central), 0.31),
            Tolerance::round_off(500));
}

BOOST_AUTO_TEST_CASE(without_zero_in_the_grid_there_is_no_central_film) {
  const Array X = graded(-2, -0.1, 16);
  BOOST_TEST(
      !observe(fields_on(X, 1 - X.square(), 1 + X.square()), want_everything()).contains(Quantity::film_central));
}

BOOST_AUTO_TEST_CASE(couette_film_offset_approach_and_exit_are_read_off) {
  const Array X = graded(-2, 1.13, 16);
  const Array P = 1.13 - X, H = 0.2 + 0.1 * X.square();
  const auto seen = observe(fields_on(X, P, H), want_everything());
  EHD_CHECK(error(value(seen, Quantity::film_couette), 1.07 * (0.2 + 0.1 * 1.13 * 1.13)), Tolerance::round_off(16));
  EHD_CHECK(error(value(seen, Quantity::film_offset), -0.41), Tolerance::round_off(1));
  EHD_CHECK(error(value(seen, Quantity::approach), 0.41), Tolerance::round_off(1));
  EHD_CHECK(error(value(seen, Quantity::pressure_exit), 1.13), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE(the_largest_pressure_is_the_vertex_of_its_parabola) {
  const Array X = graded(-2, 1.1, 25);
  const Array P = 0.93 - 0.4 * (X - 0.217).square();
  const auto at = observe(fields_on(X, P, 1 + X.square()), want_everything()).at(Quantity::pressure_maximum);
  EHD_CHECK(error(at.value, 0.93), Tolerance::round_off(100));
  EHD_CHECK(error(at.place.value(), 0.217), Tolerance::round_off(1000));
}

BOOST_AUTO_TEST_CASE(a_spike_is_a_second_maximum_behind_a_valley) {
  const Array X = graded(-2, 1.1, 400);
  const Array body = 1 - X.square(), peak = 0.7 - 300 * (X - 0.9).square();
  const auto with = observe(fields_on(X, body.max(peak).max(0.0), 1 + X.square()), want_everything());
  EHD_CHECK(error(value(with, Quantity::pressure_spike), 0.7), Tolerance::round_off(1000));
  EHD_CHECK(error(with.at(Quantity::pressure_spike).place.value(), 0.9), Tolerance::round_off(1000));
  EHD_CHECK(error(value(with, Quantity::pressure_maximum), 1.0), Tolerance::round_off(1000));
  // One hump is none, nor a ripple of rounding's size.
  const auto without = observe(fields_on(X, body.max(0.0), 1 + X.square()), want_everything());
  BOOST_TEST(!without.contains(Quantity::pressure_spike));
  Array rippled = body.max(0.0);
  rippled[300] += 1e-12;
  BOOST_TEST(!observe(fields_on(X, rippled, 1 + X.square()), want_everything()).contains(Quantity::pressure_spike));
}

BOOST_AUTO_TEST_CASE(rolling_force_is_half_the_integral_of_film_over_pressure) {
  // H = 0.4 + P rises and falls with P: the integral over a closed hump vanishes, so H gets a part odd in X.
  const auto force_error = [](int n) {
    const Array X = graded(-1, 1, n);
    const Array P = (1 - X.square()).square(), H = 0.4 + P + 0.3 * X;
    // Int H dP = 0.3 Int X P' dX = -0.3 Int P dX = -0.3 * 16/15.
    return error(value(observe(fields_on(X, P, H), {Quantity::rolling_force}), Quantity::rolling_force),
                 0.15 * 16 / 15);
  };
  // The trapezoid rule in P is second order; fitted over four grids, to a tenth.
  EHD_CHECK(std::abs(fitted_order(force_error, 32) - 2), Tolerance::discretisation(0.1, 1));
}

BOOST_AUTO_TEST_CASE(what_lies_beyond_the_inlet_counts_in_load_and_rolling_force) {
  const Array X = graded(-1, 1, 64);
  Fields fields = fields_on(X, 1 - X.abs(), 2 + 0 * X);  // a tent: Int P dX = 1, H constant: Int H dP = 0
  const double load = 1;
  const Array mid_node = X.abs();
  BOOST_REQUIRE(mid_node.minCoeff() < 1e-12);  // the tent's top is a node, so the trapezoid rule is exact
  const auto plain = observe(fields, want_everything());
  EHD_CHECK(std::abs(value(plain, Quantity::load_error) - std::abs(2 * load / pi - 1)), Tolerance::round_off(64));
  EHD_CHECK(value(plain, Quantity::rolling_force), Tolerance::round_off(64));
  fields.load_beyond_inlet = pi / 2 - 1;
  fields.work_beyond_inlet = -0.37;
  const auto with_tail = observe(fields, want_everything());
  EHD_CHECK(value(with_tail, Quantity::load_error), Tolerance::round_off(64));
  EHD_CHECK(error(value(with_tail, Quantity::rolling_force), 0.185), Tolerance::round_off(64));
}

BOOST_AUTO_TEST_CASE(flux_variation_is_relative_to_the_exit_flux) {
  const Array X = graded(-2, 1, 16);
  Fields fields = fields_on(X, 1 - X, 0.5 + 0 * X);  // P = 0 at the exit: rho H = 1.07 * 0.5
  const double exit = 1.07 * 0.5;
  fields.flux.setConstant(exit);
  fields.flux[3] = exit * 0.98;
  fields.flux[9] = exit * 1.01;
  EHD_CHECK(error(value(observe(fields, want_everything()), Quantity::flux_variation), 0.02),
            Tolerance::round_off(100));
}

BOOST_AUTO_TEST_CASE(only_what_is_wanted_is_observed) {
  const Array X = graded(-2, 1, 32);
  const Fields fields = fields_on(X, 1 - X, 0.5 + X.square());
  int rows = 0;
  for (const Quantity quantity : all_quantities) {
    if (quantity == Quantity::pressure_spike) continue;  // these fields have none
    const auto seen = observe(fields, {quantity});
    BOOST_TEST(seen.size() == 1U);
    BOOST_TEST(seen.contains(quantity));
    ++rows;
  }
  BOOST_TEST(rows == 10);
  BOOST_TEST(observe(fields, {}).empty());
}

BOOST_AUTO_TEST_CASE(martins_film_has_his_rolling_force) {
  // Rigid, isoviscous: x = tan(g), H/H_m = 1/cos^2 g, dP/dx ~ (H - H_exit)/H^3; F_t/(E'R) = 1.470515 sqrt(U_s W) means
  // T* M = 1.470515/sqrt(32/pi) * pi = 1.4475 (see verification/exact/martin.hpp). Here with M = 0.083.
  const double M = 0.083, exit = 0.4751299200930562, H_m = 2.447484 / M * pi / (8 * M);
  const double lambda = 3 * pi * pi / (8 * M * M), length = std::sqrt(2 * H_m);
  const int n = 4000;
  const double exit_angle = std::atan(exit), beyond = 0.0157, first = -pi / 2 + beyond;
  const Array g = Array::LinSpaced(n + 1, first, exit_angle);
  const Array film = H_m / g.cos().square();
  const double H_exit = H_m / std::pow(std::cos(exit_angle), 2);
  Array P = Array::Zero(n + 1);
  const auto slope = [&](double angle) {  // dP/dg
    const double H = H_m / std::pow(std::cos(angle), 2);
    return lambda * (H - H_exit) / (H * H * H) * length / std::pow(std::cos(angle), 2);
  };
  for (int i = 1; i <= n; ++i)  // Simpson
    P[i] = P[i - 1] + (g[i] - g[i - 1]) / 6 * (slope(g[i - 1]) + 4 * slope((g[i - 1] + g[i]) / 2) + slope(g[i]));
  Fields fields = fields_on(length * g.tan(), P, film);
  // Int H dP = lambda length/H_m Int (1 - (H_exit/H_m) cos^2 g) dg, here from -pi/2 to the first node.
  fields.work_beyond_inlet = lambda * length / H_m * (beyond - H_exit / H_m * (beyond / 2 - std::sin(2 * beyond) / 4));
  const double force = value(observe(fields, {Quantity::rolling_force}), Quantity::rolling_force);
  // Half a digit of 1.4475, and the trapezoid rule: (angle step)^2/(6 beyond) relative to a sum of about 1.
  const double step = g[1] - g[0];
  EHD_CHECK(error(force * M, 1.4475), Tolerance::discretisation(0.00005 / 1.4475 + step * step / (6 * beyond), 1));
}

// A parabola lies on every polynomial through six nodes; a kink of slope 1 at X = 0 does not.
BOOST_AUTO_TEST_CASE(a_kink_of_the_film_at_the_centre_is_rough) {
  Fields fields;
  fields.X = Array::LinSpaced(41, -1, 1);
  fields.H = 1 + fields.X.square();
  fields.P = 1 - (fields.X - 0.2).square();  // the maximum is four cells behind the centre
  EHD_CHECK(roughness_at_centre(fields), Tolerance::round_off(1000));
  fields.H += fields.X.abs();
  const double rough = roughness_at_centre(fields);
  BOOST_TEST(rough > 0.01);  // in one cell the kink changes H by 0.05; a fifth of that must show
  fields.P = 1 - (fields.X - 0.1).square();
  BOOST_TEST(roughness_at_centre(fields) > 3 * rough);  // two cells
}

BOOST_AUTO_TEST_SUITE_END()
