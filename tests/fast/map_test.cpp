// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/map.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "tests/fast/maps.hpp"

using namespace ehd;
using fast::Map;
using fast::MapNodes;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(map)

BOOST_AUTO_TEST_CASE(s_runs_from_zero_at_the_inlet_to_one_at_the_exit) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      const Map map(shape);
      EHD_CHECK(std::abs(map(shape.inlet)), Tolerance::round_off(0));
      EHD_CHECK(std::abs(map(shape.exit) - 1), Tolerance::round_off(0));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5);
}

BOOST_AUTO_TEST_CASE(slope_is_the_derivative_of_s) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      const Map map(shape);
      double worst = 0;
      for (const double X : map.nodes(97).X) {
        // Central differences over 1e-3, 5e-4 and 2.5e-4 of s, extrapolated twice. The widths are those of the rounded
        // places, so that only s is rounded.
        double difference[3];
        for (int k = 0; k < 3; ++k) {
          const double reach = 1e-3 / std::pow(2, k) / map.slope(X), up = X + reach, down = X - reach;
          difference[k] = (map(up) - map(down)) / (up - down);
        }
        const double first = (4 * difference[1] - difference[0]) / 3, second = (4 * difference[2] - difference[1]) / 3;
        worst = std::max(worst, error((16 * second - first) / 15, map.slope(X)));
      }
      // s of size 1, a few terms, over the narrowest width.
      EHD_CHECK(worst, Tolerance::round_off(40, 2 / 5e-4));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5);
}

BOOST_AUTO_TEST_CASE(slopes_of_nodes_are_the_slopes_one_by_one) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      const Map map(shape);
      const auto [X, slopes] = map.nodes(1000);
      for (Eigen::Index i = 0; i < X.size(); ++i) {
        EHD_CHECK(error(slopes[i], map.slope(X[i])), Tolerance::round_off(8));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5005);
}

BOOST_AUTO_TEST_CASE(nodes_stand_at_equal_steps_of_s) {
  // Nodes come from vectorised blocks; the scalar s, from std::asinh and std::atan, judges them here.
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    const Map map(shape);
    for (const int n : {16, 17, 31, 33, 64, 97, 333, 512, 1000, 1001, 4095, 4096}) {
      BOOST_TEST_CONTEXT(name << ", n = " << n) {
        const Array X = map.nodes(n).X;
        BOOST_REQUIRE_EQUAL(X.size(), n + 1);
        BOOST_CHECK_EQUAL(X[0], shape.inlet);
        BOOST_CHECK_EQUAL(X[n], shape.exit);
        BOOST_CHECK_GT((X.tail(n) - X.head(n)).minCoeff(), 0);
        double worst = 0;
        for (int i = 0; i <= n; ++i) {
          // X is rounded to half an eps; the slope of s carries that rounding into s.
          const double condition = 1 + std::abs(X[i]) * map.slope(X[i]);
          worst = std::max(worst, std::abs(map(X[i]) - static_cast<double>(i) / n) / condition);
        }
        EHD_CHECK(worst, Tolerance::round_off(4));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 60);
}

BOOST_AUTO_TEST_CASE(refined_nodes_hold_the_coarse_ones_and_are_those_of_twice_as_many_intervals) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    const Map map(shape);
    for (const int n : {8, 16, 32, 33, 97, 512}) {
      BOOST_TEST_CONTEXT(name << ", n = " << n) {
        const MapNodes nodes = map.nodes(n);
        const Array coarse = nodes.X, fine = map.refined(nodes).X, again = map.nodes(2 * n).X;
        BOOST_REQUIRE_EQUAL(fine.size(), 2 * n + 1);
        BOOST_REQUIRE_EQUAL(again.size(), 2 * n + 1);
        for (int i = 0; i <= n; ++i) BOOST_CHECK_EQUAL(fine[2 * i], coarse[i]);
        double worst = 0;
        for (int i = 0; i <= 2 * n; ++i)
          worst = std::max(worst, std::abs(fine[i] - again[i]) / (std::abs(fine[i]) + 1 / map.slope(fine[i])));
        // 2 n <= 32 comes from straight lines through samples.
        EHD_CHECK(worst, Tolerance::round_off(4));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 30);
}

BOOST_AUTO_TEST_SUITE_END()
