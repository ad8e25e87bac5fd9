// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/carried_density.hpp"

#include <cmath>
#include <memory>

#include "fast/counters.hpp"
#include "fast/node_fields.hpp"
#include "tests/check.hpp"
#include "tests/fast/maps.hpp"

using namespace ehd;
using namespace ehd::fast;
using verification::Tolerance;

namespace {

constexpr int n = 64;
constexpr DowsonHigginson law{.a = 0.4, .c = 1.2};

/// A pressure that rises, has a peak, and falls within a cell, at the nodes of a map or of the uniform grid.
struct Falling {
  Setting setting;
  Grids grids;
  NodeFields nodes;
  Array P = Array::Zero(n + 1);
  Counters counters;

  explicit Falling(bool mapped) {
    setting.density = law;
    if (mapped) grids.use(std::make_shared<const Map>(named_shapes[4].shape));
    nodes.n = n;
    nodes.grid = &grids.of(n);
    for (int j = 1; j < n; ++j) P[j] = j < 50 ? 0.02 * j : j == 50 ? 0.6 : 0.01 * (n - j);
    evaluate();
  }
  void evaluate() { nodes.evaluate_laws(setting, P, counters); }
  [[nodiscard]] CarriedDensity linearised() const {
    CarriedDensity carried;
    carried.linearise(setting, nodes, P);
    return carried;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(carried_density)

BOOST_AUTO_TEST_CASE(at_the_spike_it_lies_on_the_chord_between_the_neighbours) {
  const Falling at(true);
  const CarriedDensity carried = at.linearised();
  const Array &rho = at.nodes.density.value, &w = at.nodes.grid->near_spike;
  int near = 0;
  for (int j = 1; j < n; ++j) {
    const double share = (at.P[j] - at.P[j - 1]) / (at.P[j + 1] - at.P[j - 1]);
    const double chord = rho[j - 1] + (rho[j + 1] - rho[j - 1]) * share;
    EHD_CHECK(std::abs(carried.value[j] - ((1 - w[j]) * rho[j] + w[j] * chord)), Tolerance::round_off(10, 10));
    near += w[j] > 0.5;
  }
  BOOST_TEST(near > 1);
  BOOST_TEST(near < n / 2);
  BOOST_CHECK_EQUAL(carried.value[0], rho[0]);
  BOOST_CHECK_EQUAL(carried.value[n], rho[n]);
}

BOOST_AUTO_TEST_CASE(between_equal_neighbours_the_chord_is_the_tangent) {
  Falling at(true);
  Eigen::Index j = 0;
  at.nodes.grid->near_spike.maxCoeff(&j);
  at.P.segment(j - 1, 3) << 0.3, 0.7, 0.3;
  at.evaluate();
  const double rho = at.nodes.density.value[j - 1], slope = at.nodes.density.slope[j - 1];
  const double w = at.nodes.grid->near_spike[j], own = at.nodes.density.value[j];
  EHD_CHECK(std::abs(at.linearised().value[j] - ((1 - w) * own + w * (rho + slope * 0.4))),
            Tolerance::round_off(10, 10));
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_value) {
  const Falling at(true);
  const CarriedDensity carried = at.linearised();
  BOOST_TEST(carried.by_neighbours);
  for (int j = 2; j < n - 1; ++j) {
    const double by[] = {carried.by_left[j], carried.by_own[j], carried.by_right[j]};
    for (int k = 0; k < 3; ++k) {
      // Central differences at two widths, extrapolated: error O(width^4) + eps/width.
      const auto difference = [&](double width) {
        Falling up(true), down(true);
        up.P[j - 1 + k] += width, down.P[j - 1 + k] -= width;
        up.evaluate(), down.evaluate();
        return (up.linearised().value[j] - down.linearised().value[j]) / (2 * width);
      };
      const double expected = (4 * difference(1e-3) - difference(2e-3)) / 3;
      EHD_CHECK(std::abs(by[k] - expected), Tolerance::round_off(100, 1e3));
    }
  }
}

BOOST_AUTO_TEST_CASE(uniform_grids_and_incompressible_oil_keep_the_density_of_the_node) {
  Falling uniform(false), incompressible(true);
  incompressible.setting.density = Incompressible{};
  incompressible.evaluate();
  for (const Falling* at : {&uniform, &incompressible}) {
    const CarriedDensity carried = at->linearised();
    BOOST_TEST(!carried.by_neighbours);
    BOOST_TEST((carried.value == at->nodes.density.value).all());
    BOOST_TEST((carried.by_own == at->nodes.density.slope).all());
  }
}

BOOST_AUTO_TEST_SUITE_END()
