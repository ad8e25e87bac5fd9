// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/smooth_remainder.hpp"

#include <cmath>
#include <random>

#include "tests/check.hpp"
#include "tests/fast/maps.hpp"

using namespace ehd;
using fast::Map;
using fast::RemainderTable;
using fast::SmoothRemainder;
using verification::Tolerance;

namespace {

std::shared_ptr<const RemainderTable> table_of(const Map& map, int cells) {
  const Places at = places_of(map, map.nodes(cells).X);
  return std::make_shared<const RemainderTable>(RemainderTable::of(at.place, at.slope));
}

SmoothRemainder remainder_on(int n, const std::shared_ptr<const RemainderTable>& table) {
  if (n == table->cells) return SmoothRemainder(table);
  return {table, std::make_shared<const fast::RemainderRule>(fast::RemainderRule::of(n, table->cells))};
}

Array random_array(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Array x(size);
  for (double& value : x) value = uniform(random);
  return x;
}

constexpr std::pair<int, int> cells_and_intervals[] = {{64, 64},   {128, 128},  {128, 256},  {128, 512},
                                                       {128, 333}, {128, 1000}, {128, 1001}, {256, 2048}};

}  // namespace

BOOST_AUTO_TEST_SUITE(smooth_remainder)

BOOST_AUTO_TEST_CASE(table_holds_the_logarithms_of_the_difference_quotients) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      const Map map(shape);
      for (const int cells : {16, 97, 128}) {
        const Places at = places_of(map, map.nodes(cells).X);
        const RemainderTable table = RemainderTable::of(at.place, at.slope);
        BOOST_REQUIRE_EQUAL(table.cells, cells);
        BOOST_REQUIRE_EQUAL(table.values.rows(), cells + 1);
        double worst = 0;
        for (int i = 0; i <= cells; ++i) {
          for (int j = 0; j <= cells; ++j) {
            const double truth = remainder_between(at, i, j);
            worst = std::max(worst, std::abs(table.values(i, j) - truth) / (1 + std::abs(truth)));
          }
        }
        EHD_CHECK(worst, Tolerance::round_off(4));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 15);
}

BOOST_AUTO_TEST_CASE(neighbouring_nodes_lead_to_the_diagonal) {
  // Lambda_ii = ln phi'_i is the limit of Lambda_ij: the mean of both neighbours differs from it by the third
  // derivative of ln phi, which falls as h^2.
  const Map map(named_shapes[4].shape);
  double before = 0;
  int rows = 0;
  for (const int n : {512, 1024, 2048}) {
    const Places at = places_of(map, map.nodes(n).X);
    double worst = 0;
    for (int i = 1; i < n; ++i)
      worst = std::max(worst, std::abs((remainder_between(at, i, i - 1) + remainder_between(at, i, i + 1)) / 2 -
                                       remainder_between(at, i, i)));
    if (before > 0)
      EHD_CHECK(std::abs(std::log2(before / worst) - 2), Tolerance::asymptotic(0.1, "h^2 and h^4 at n = 512"));
    before = worst;
    ++rows;
  }
  BOOST_REQUIRE_EQUAL(rows, 3);
}

BOOST_AUTO_TEST_CASE(interpolation_is_exact_for_polynomials_of_seventh_degree) {
  // A table that holds p(s_i) q(s_j): eight points leave rounding only, at any number of intervals.
  const auto p = [](double s) { return 0.3 + s * (1.1 + s * (-0.7 + s * (2 + s * s * (s * s - 1.3 * s + 0.4)))); };
  const auto q = [](double s) { return 1.2 - s * (0.4 - s * s * (0.9 + s * s * (0.1 - 2.1 * s * s))); };
  int rows = 0;
  for (const auto& [cells, n] : cells_and_intervals) {
    BOOST_TEST_CONTEXT(cells << " cells, n = " << n) {
      RemainderTable table{.cells = cells, .values = Eigen::MatrixXd(cells + 1, cells + 1)};
      for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j)
          table.values(i, j) = p(static_cast<double>(i) / cells) * q(static_cast<double>(j) / cells);
      }
      const SmoothRemainder remainder = remainder_on(n, std::make_shared<const RemainderTable>(table));
      const Array x = random_array(n + 1, 3);
      double sum = 0, size = 0;
      for (int j = 0; j <= n; ++j) {
        const double term = q(static_cast<double>(j) / n) * x[j];
        sum += term, size += std::abs(term);
      }
      Array y = Array::Constant(n + 1, 0.7);  // add() keeps the old values
      remainder.add(x, y);
      double worst = 0;
      for (int i = 0; i <= n; ++i) worst = std::max(worst, std::abs(y[i] - 0.7 - p(static_cast<double>(i) / n) * sum));
      // Two interpolations of 8 points, whose weights sum to less than 40 at the ends, and sums of sqrt(n) growth.
      EHD_CHECK(worst / size, Tolerance::round_off(std::sqrt(n) + 16, 3));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 8);
}

BOOST_AUTO_TEST_CASE(add_uses_the_entries_and_they_are_symmetric) {
  int rows = 0;
  const Map map(heaviest.shape);
  for (const auto& [cells, n] : cells_and_intervals) {
    BOOST_TEST_CONTEXT(cells << " cells, n = " << n) {
      const SmoothRemainder remainder = remainder_on(n, table_of(map, cells));
      for (const int j : {0, 1, n / 3, n / 2 + 1, n - 1, n}) {
        Array unit = Array::Zero(n + 1), y = Array::Zero(n + 1);
        unit[j] = 1;
        remainder.add(unit, y);
        double worst = 0;
        for (int i = 0; i <= n; i += 7) {
          worst = std::max(worst, std::abs(y[i] - remainder.entry(i, j)));
          worst = std::max(worst, std::abs(remainder.entry(j, i) - remainder.entry(i, j)));
        }
        // 64 products with the table's entries, at most 12.
        EHD_CHECK(worst, Tolerance::round_off(64, 12));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 48);
}

BOOST_AUTO_TEST_CASE(product_equals_the_dense_sum_to_what_interpolation_leaves) {
  // Absolute, for a smooth x whose sizes add up to about 1: eight points err as the table's eighth derivative, by 2^8
  // less with half the step. grid_test judges the film error that this leaves.
  constexpr double with_128[] = {6e-8, 8e-9, 2.4e-8, 8e-11, 3.5e-10},
                   with_256[] = {2.6e-10, 6e-11, 1.3e-10, 3e-13, 2.6e-12};
  int rows = 0;
  for (std::size_t k = 0; k < std::size(named_shapes); ++k) {
    const auto& [name, shape] = named_shapes[k];
    const Map map(shape);
    for (const auto& [cells, n] : cells_and_intervals) {
      BOOST_TEST_CONTEXT(name << ", " << cells << " cells, n = " << n) {
        const Places at = places_of(map, map.nodes(n).X);
        const SmoothRemainder remainder = remainder_on(n, table_of(map, cells));
        Array x(n + 1), y = Array::Zero(n + 1);
        for (int i = 0; i <= n; ++i) x[i] = std::sin(3.0 * i / n) / n;
        remainder.add(x, y);
        double worst = 0;
        for (int i = 0; i <= n; ++i) {
          double sum = 0;
          for (int j = 0; j <= n; ++j) sum += remainder_between(at, i, j) * x[j];
          worst = std::max(worst, std::abs(y[i] - sum));
        }
        EHD_CHECK(worst, cells == n
                             ? Tolerance::round_off(std::sqrt(n), 6)
                             : Tolerance::calibrated(cells == 128 ? with_128[k] : with_256[k], "measured, times 1.4"));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 40);
}

BOOST_AUTO_TEST_SUITE_END()
