// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/discretisation.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "fast/jacobian.hpp"
#include "fast/start.hpp"
#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::fast;
using verification::Tolerance;

namespace {

/// Distinguishable, non-default values: (M, L) = (7, 6), Roelands, compressible.
Setting setting_of_seven_and_six() {
  const Groups groups{.M = 7, .L = 6, .lambda = 0.0755, .alpha_p_H = 6.333};
  return {.groups = groups,
          .viscosity = Roelands{.alpha = 6.333, .p0 = 0.681, .z = 0.61},
          .density = DowsonHigginson{.a = 0.166, .c = 0.488},
          .inlet = -3.7};
}

struct JacobianCase {
  const char* name;
  bool sourced, mapped, robust_wedge, with_tail;
};
constexpr JacobianCase jacobian_cases[] = {
    {"uniform", false, false, false, false},       {"uniform, sources", true, false, false, false},
    {"uniform, tail", false, false, false, true},  {"mapped", false, true, false, false},
    {"mapped, sources", true, true, false, false}, {"mapped, robust wedge", false, true, true, false},
    {"mapped, tail", false, true, false, true},    {"mapped, all", true, true, true, true}};

std::shared_ptr<const Map> map_from(double inlet) {
  return std::make_shared<const Map>(
      MapShape{.inlet = inlet, .exit = 1.17, .scale = 1, .inlet_width = 0.37, .spike = 0.84, .spike_width = 0.19});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(discretisation)

BOOST_AUTO_TEST_CASE(jacobian_product_is_the_derivative_of_the_residual) {
  const Sources sources{.film = [](double X) { return std::pair(0.07 * X * X * X, 0.21 * X * X); },
                        .balance = [](double X) { return std::pair(0.05 * X * X + 0.02, 0.1 * X); },
                        .load = 0.013};
  int rows = 0;
  for (const auto& [name, sourced, mapped, robust_wedge, with_tail] : jacobian_cases) {
    BOOST_TEST_CONTEXT(name) {
      Setting setting = setting_of_seven_and_six();
      if (sourced) setting.sources = std::make_shared<const Sources>(sources);
      setting.with_tail = with_tail;
      constexpr int n = 96;
      Grids grids;
      if (mapped) grids.use(map_from(setting.inlet), robust_wedge);
      Grid& grid = grids.of(n);
      BOOST_CHECK_EQUAL(grid.bias.abs().maxCoeff() > 0.1, mapped);
      Counters counters;
      State state = first_iterate(setting, Shape::hertz, 0.21, grid);
      Discretisation at;
      BOOST_REQUIRE(at.evaluate(setting, state, grid, counters));
      BOOST_CHECK_EQUAL(state.P[0] > 0, with_tail);
      Jacobian jacobian;
      jacobian.linearise(setting, at.nodes, state.P, state.exit);

      std::mt19937 random(5);
      std::uniform_real_distribution<double> uniform(-1, 1);
      for (int trial = 0; trial < 4; ++trial) {
        // Each unknown by itself, then all together.
        Step step{
            .P = Array::Zero(n + 1), .offset = trial == 1 || trial == 3 ? 0.7 : 0.0, .exit = trial >= 2 ? -0.4 : 0.0};
        if (trial == 0 || trial == 3) {
          for (int i = 1; i < n; ++i) step.P[i] = state.P[i] * uniform(random);
        }
        const auto& [change, load_change] = jacobian.apply(step, counters);
        // Central differences at two widths, extrapolated: error O(width^4) + eps/width.
        const auto difference = [&](double width, double& load) {
          State up = state, down = state;
          up.P += width * step.P, down.P -= width * step.P;
          up.offset += width * step.offset, down.offset -= width * step.offset;
          up.exit += width * step.exit, down.exit -= width * step.exit;
          Discretisation a, b;
          BOOST_REQUIRE(a.evaluate(setting, up, grid, counters));
          BOOST_REQUIRE(b.evaluate(setting, down, grid, counters));
          load = (a.error.load - b.error.load) / (2 * width);
          return Array((a.error.flux - b.error.flux) / (2 * width));
        };
        double load_wide = 0, load_narrow = 0;
        const Array wide = difference(2e-4, load_wide), narrow = difference(1e-4, load_narrow);
        const Array expected = (4 * narrow - wide) / 3;
        // Rounding of e (condition: the largest face flux over e) over the width.
        EHD_CHECK((change - expected).abs().maxCoeff() / expected.abs().maxCoeff(), Tolerance::round_off(100, 1e4));
        EHD_CHECK(std::abs(load_change - (4 * load_narrow - load_wide) / 3), Tolerance::round_off(n, 1e4));
      }
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 8);
}

BOOST_AUTO_TEST_CASE(the_first_pressure_deflects_with_its_half_of_a_cell_and_the_tail_with_its_polynomial) {
  int rows = 0;
  for (const bool mapped : {false, true}) {
    BOOST_TEST_CONTEXT("mapped " << mapped) {
      Setting setting = setting_of_seven_and_six();
      constexpr int n = 96;
      Grids grids;
      if (mapped) grids.use(map_from(setting.inlet));
      Grid& grid = grids.of(n);
      Counters counters;
      State state = first_iterate(setting, Shape::hertz, 0.21, grid);
      Discretisation without, with;
      BOOST_REQUIRE(without.evaluate(setting, state, grid, counters));
      setting.with_tail = true;
      state.tail.pressure = 0.031;
      state.tail.load = 0.047;
      state.tail.deflection[0] = 0.013, state.tail.deflection[1] = -0.007, state.tail.deflection[2] = 0.003;
      state.tail.deflection[3] = 0.0011, state.tail.deflection[4] = -0.0005;
      BOOST_REQUIRE(with.evaluate(setting, state, grid, counters));
      const double length = with.nodes.length, P0 = state.tail.pressure, half = grid.first_weight;
      for (int i = 0; i <= n; ++i) {
        const double X = setting.inlet + length * grid.place[i], X2 = X * X;
        const double expected = without.nodes.H[i] -
                                length / std::numbers::pi * P0 * (grid.first_column()[i] + std::log(length) * half) +
                                0.013 - 0.007 * X + 0.003 * X2 + 0.0011 * X2 * X - 0.0005 * X2 * X2;
        EHD_CHECK(error(with.nodes.H[i], expected), Tolerance::round_off(64, 2));
        ++rows;
      }
      EHD_CHECK(error(with.error.load - without.error.load, 0.047 + length * P0 * half), Tolerance::round_off(32, 30));
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 194);
}

BOOST_AUTO_TEST_CASE(trivial_laws_are_not_evaluated) {
  Setting setting = setting_of_seven_and_six();
  setting.viscosity = Isoviscous{};
  setting.density = Incompressible{};
  Grids grids;
  Grid& grid = grids.of(64);
  Counters counters;
  State state = first_iterate(setting, Shape::hertz, 0.2, grid);
  Discretisation at;
  BOOST_REQUIRE(at.evaluate(setting, state, grid, counters));
  BOOST_CHECK_EQUAL(counters.viscosity_points, 0);
  BOOST_CHECK_EQUAL(counters.density_points, 0);
  BOOST_REQUIRE(at.evaluate(setting_of_seven_and_six(), state, grid, counters));
  BOOST_CHECK_EQUAL(counters.viscosity_points, 65);
  BOOST_CHECK_EQUAL(counters.density_points, 65);
}

BOOST_AUTO_TEST_SUITE_END()
