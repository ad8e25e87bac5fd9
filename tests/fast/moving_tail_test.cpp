// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/moving_tail.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "fast/inlet_tail.hpp"
#include "tests/check.hpp"
#include "tests/quadrature.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

struct Steady {
  double far = 16, excess = 0.83, moment = -0.4, flux = 1.1, lambda = 0.7, slope = 1.9;
  [[nodiscard]] fast::InletTail tail() const { return fast::inlet_tail(far, excess, moment, flux, lambda, slope); }
  [[nodiscard]] fast::MovingTail moving() const { return {far, excess, moment, flux, lambda, slope}; }
  [[nodiscard]] double gap(double x) const {
    return x * x / 2 + excess - std::log(x / far) / 2 - moment / std::numbers::pi * (1 / x - 1 / far);
  }
};

fast::MovingTail::Drive<double> unit(int k) { return fast::MovingTail::Drive<double>::Unit(k); }

}  // namespace

BOOST_AUTO_TEST_SUITE(moving_tail)

BOOST_AUTO_TEST_CASE(at_rest_it_is_the_derivative_of_the_steady_tail) {
  const Steady steady;
  const struct {
    int drive;
    std::function<void(Steady&, double)> move;
  } rows[] = {{0, [](Steady& s, double by) { s.excess += by; }},
              {2, [](Steady& s, double by) { s.moment += by; }},
              {3, [](Steady& s, double by) { s.flux += by; }}};
  constexpr double width = 1e-3;
  const Tolerance difference = Tolerance::asymptotic(1e-7, "width squared, and rounding over the width");
  for (const auto& [drive, move] : rows) {
    Steady ahead = steady, behind = steady;
    move(ahead, width);
    move(behind, -width);
    const auto answer = steady.moving().answer(0.0, unit(drive));
    const auto slope = [&](double there, double here) { return (there - here) / (2 * width); };
    EHD_CHECK(error(answer[0], slope(ahead.tail().load, behind.tail().load)), difference);
    EHD_CHECK(error(answer[1], slope(ahead.tail().pressure, behind.tail().pressure)), difference);
    for (int k = 0; k < 5; ++k)
      EHD_CHECK(error(answer[2 + k], slope(ahead.tail().deflection[k], behind.tail().deflection[k])), difference);
  }
}

/// Of oil without viscosity's rise, where P = Q: the integrals of the squeeze's flux.
BOOST_AUTO_TEST_CASE(a_rate_adds_the_squeezed_oil_to_the_flux) {
  Steady steady;
  steady.slope = 0;
  const double far = steady.far, pi = std::numbers::pi;
  const std::function<double(double)> oil[] = {[&](double x) { return x - far; },
                                               [&](double x) { return -(x * std::log(x / far) - x + far) / pi; },
                                               [&](double x) { return -(std::log(x / far) - (x - far) / far) / pi; }};
  // 12 points on t^3 ln t and t^2 ln t. The logarithm brings a tenth of what the first row brings.
  const Tolerance of_pressure = Tolerance::discretisation(1e-6, 2), of_load = Tolerance::discretisation(5e-4, 2);
  constexpr double rate = 0.3;
  for (int k = 0; k < 3; ++k) {
    const auto squeezed = steady.moving().answer(rate, unit(k)), at_rest = steady.moving().answer(0.0, unit(k));
    const auto slope = [&](double x) { return -steady.lambda * rate * oil[k](x) / std::pow(steady.gap(x), 3); };
    const double pressure = testing::integral_to_infinity(slope, far, 1e-10);
    const double load = testing::integral_to_infinity([&](double x) { return slope(x) * (x - far); }, far, 1e-10);
    EHD_CHECK(error(squeezed[1] - at_rest[1], pressure), of_pressure);
    EHD_CHECK(error(squeezed[0] - at_rest[0], load), of_load);
  }
  const auto none = (steady.moving().answer(rate, unit(3)) - steady.moving().answer(0.0, unit(3))).eval();
  BOOST_TEST(none.norm() == 0);
}

/// Its integrals oscillate. They are compared on the real axis, for waves from a tenth of x_a to forty x_a.
BOOST_AUTO_TEST_CASE(a_waviness_adds_the_integral_of_its_wave) {
  Steady steady;
  steady.slope = 0;
  const Tolerance of_rule = Tolerance::discretisation(5e-4, 2);
  for (const Waviness wave : {Waviness{1.6, 1}, Waviness{5, 0.3}, Waviness{16, 2}, Waviness{80, 0}, Waviness{640, 1}}) {
    const double k = wave.wavenumber();
    const auto answer = steady.moving().answer(wave);
    const auto by_wave = [&](double x) {
      const double H = steady.gap(x);
      return steady.lambda * (3 * steady.flux / H - 2 - wave.slip) / (H * H * H);
    };
    const auto integral = [&](const auto& weight) {
      // Twenty times as far the film is 400 times as thick: 1e-7 of the integral is left beyond.
      return testing::smooth_integral([&](double x) { return by_wave(x) * weight(x); }, steady.far, 20 * steady.far);
    };
    const std::complex<double> pressure(integral([&](double x) { return std::cos(k * x); }),
                                        integral([&](double x) { return std::sin(k * x); }));
    EHD_CHECK(std::abs(answer[1] - pressure) / std::abs(pressure), of_rule);
    // The points of the tail do not see the load of shorter waves, which is next to nothing.
    if (k * steady.far > 2) continue;
    const std::complex<double> load(integral([&](double x) { return (x - steady.far) * std::cos(k * x); }),
                                    integral([&](double x) { return (x - steady.far) * std::sin(k * x); }));
    EHD_CHECK(std::abs(answer[0] - load) / std::abs(load), of_rule);
  }
}

BOOST_AUTO_TEST_SUITE_END()
