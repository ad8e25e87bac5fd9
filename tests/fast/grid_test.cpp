// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/grid.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "contact/hertz.hpp"
#include "fast/start.hpp"
#include "tests/check.hpp"
#include "tests/fast/maps.hpp"
#include "tests/quadrature.hpp"

using namespace ehd;
using namespace ehd::fast;
using ehd::testing::singular_integral;
using std::numbers::pi;
using verification::Tolerance;

namespace {

struct OnMap {
  explicit OnMap(const MapShape& shape, bool robust_wedge = false) : map(std::make_shared<const Map>(shape)) {
    grids.use(map, robust_wedge);
  }
  std::shared_ptr<const Map> map;
  Grids grids;
};

/// The weights by their definition: -ln 2 pi + 2c, -c, ln k with c = zeta(3)/(4 pi^2).
double weight_by_definition(int k) {
  constexpr double zeta_of_3 = 1.2020569031595942854;
  const double c = zeta_of_3 / (4 * pi * pi);
  return k == 0 ? -std::log(2 * pi) + 2 * c : k == 1 ? -c : std::log(static_cast<double>(k));
}

/// Sum_j h phi'_j P_j (w_|i-j| + Lambda_ij + ln h) over 0 < j < n, term by term, and the sum of the terms' sizes.
struct DenseProduct {
  Array y;
  double size = 0;
};
DenseProduct dense_product(const Map& map, int n, const Array& P) {
  const Places at = places_of(map, map.nodes(n).X);
  const double h = 1.0 / n;
  DenseProduct result{.y = Array::Zero(n + 1)};
  for (int i = 0; i <= n; ++i) {
    double size = 0;
    for (int j = 1; j < n; ++j) {
      const double toeplitz = weight_by_definition(std::abs(i - j)), beside = remainder_between(at, i, j);
      const double g = h * at.slope[j] * P[j];
      result.y[i] += g * (toeplitz + beside + std::log(h));
      size += std::abs(g) * (std::abs(toeplitz) + std::abs(beside) + std::abs(std::log(h)));
    }
    result.size = std::max(result.size, size);
  }
  return result;
}

/// Hertz' pressure, of the size and roughly of the shape of every heavily loaded one, at the map's nodes.
Array hertz_at(const Map& map, int n) { return hertz::pressure(map.nodes(n).X); }

double fitted_order(const std::vector<int>& grids, const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const double x = -std::log(grids[k]), y = std::log(errors[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double m = static_cast<double>(grids.size());
  return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(grid)

BOOST_AUTO_TEST_CASE(places_slopes_and_spacings_are_those_of_the_map) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    OnMap on(shape);
    for (const int n : {64, 97, 1000}) {
      BOOST_TEST_CONTEXT(name << ", n = " << n) {
        const Grid& grid = on.grids.of(n);
        const Array X = on.map->nodes(n).X;
        const Places at = places_of(*on.map, X);
        const double length = shape.exit - shape.inlet;
        BOOST_REQUIRE_EQUAL(grid.n, n);
        EHD_CHECK((grid.place - at.place).abs().maxCoeff(), Tolerance::round_off(2));
        EHD_CHECK((grid.slope / at.slope - 1).abs().maxCoeff(), Tolerance::round_off(16, 1));
        EHD_CHECK((grid.spacing - (X.tail(n) - X.head(n)) / length).abs().maxCoeff(), Tolerance::round_off(2));
        EHD_CHECK((grid.inverse_slope * grid.slope - 1).abs().maxCoeff(), Tolerance::round_off(2));
        EHD_CHECK((grid.inverse_spacing * grid.spacing - 1).abs().maxCoeff(), Tolerance::round_off(2));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 15);
}

BOOST_AUTO_TEST_CASE(near_the_spike_is_one_there_and_nothing_far_away) {
  int rows = 0;
  for (const auto& [name, shape] : named_shapes) {
    BOOST_TEST_CONTEXT(name) {
      OnMap on(shape);
      constexpr int n = 128;
      const Array X = on.map->nodes(n).X, &near = on.grids.of(n).near_spike;
      BOOST_REQUIRE_EQUAL(near.size(), n + 1);
      const double reach = std::min(8 * shape.spike_width, (shape.exit - shape.spike) / 4);
      for (int j = 2; j < n; ++j) {
        const double away = (X[j] - shape.spike) / reach;
        EHD_CHECK(std::abs(near[j] - std::exp(-away * away)), Tolerance::round_off(10, 10));
      }
      BOOST_TEST((near[0] == 0 && near[1] == 0 && near[n] == 0));
      BOOST_TEST(near.maxCoeff() > 0.5);
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5);
  Grids uniform;
  BOOST_CHECK_EQUAL(uniform.of(64).near_spike.size(), 0);
}

BOOST_AUTO_TEST_CASE(wedge_is_third_order_at_the_inlet_and_upwind_at_the_exit_and_the_spike) {
  for (const bool robust : {false, true}) {
    OnMap on(named_shapes[4].shape, robust);
    const Grid& grid = on.grids.of(128);
    BOOST_REQUIRE_EQUAL(grid.bias.size(), 128);
    const Array X = on.map->nodes(128).X;
    for (int i = 0; i < 128; ++i) {
      if (X[i] < -1) EHD_CHECK(std::abs(grid.bias[i] - 0.5), Tolerance::asymptotic(3 * std::exp(-8.0), "tanh(8X)"));
      const double falling = robust ? -1 : -0.5, near = grid.near_spike[i];
      if (X[i] > 0.7)
        EHD_CHECK(std::abs(grid.bias[i] - ((1 - near) * falling - near)),
                  Tolerance::asymptotic(3 * std::exp(-5.6), "tanh(8X)"));
    }
  }
}

BOOST_AUTO_TEST_CASE(product_equals_the_dense_one_on_the_same_nodes) {
  int rows = 0;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const auto& [name, shape] : named_shapes) {
    for (const int n : {16, 31, 64, 97, 128}) {  // tables without interpolation
      BOOST_TEST_CONTEXT(name << ", n = " << n) {
        OnMap on(shape);
        Array P(n + 1), y;
        for (double& value : P) value = uniform(random);
        double sum = 0;
        on.grids.of(n).product(P, y, sum);
        const DenseProduct dense = dense_product(*on.map, n, P);
        // As for the FFT product by itself, with two more sums. Places near each other cancel: Lambda is known to eps
        // over the smallest spacing.
        const Array X = on.map->nodes(n).X;
        const double nearest = (X.tail(n) - X.head(n)).minCoeff() / (X[n] - X[0]);
        EHD_CHECK((y - dense.y).abs().maxCoeff() / dense.size,
                  Tolerance::round_off(3 * std::log2(2.0 * n) + 2 * std::sqrt(n) + 0.1 / nearest / n));
        double expected = 0;
        const Places at = places_of(*on.map, X);
        for (int j = 1; j < n; ++j) expected += at.slope[j] * P[j] / n;
        EHD_CHECK(error(sum, expected), Tolerance::round_off(16 + std::sqrt(n)));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 25);
}

BOOST_AUTO_TEST_CASE(interpolated_remainders_leave_a_film_error_that_is_known) {
  // In units of the central film that goes with the map, largest over the nodes. A solution feels a hundredth of it:
  // what is smooth is taken up by the pressure. H_cen with n = 512 and interpolated against whole tables: (5000, 0)
  // 9e-7, flooded 1.4e-6; (5000, 10) 5e-8, flooded 1e-7; (1000, 10) 1e-8, flooded 5e-8.
  struct Row {
    const NamedShape& map;
    double film, with_128, with_256;
  };
  const double heavy = expected_lengths({.M = 5000, .L = 10}).film;
  const Row rows[] = {{named_shapes[0], heavy, 1.7e-4, 7.5e-7},
                      {named_shapes[1], 0.1, 1.3e-7, 1.5e-9},
                      {named_shapes[2], 0.02, 1e-6, 2.4e-8},
                      {named_shapes[3], 60, 2e-12, 3e-15},
                      {named_shapes[4], 0.22, 2.8e-9, 2e-11}};
  int checked = 0;
  for (const auto& [map, film, with_128, with_256] : rows) {
    for (const int n : {256, 333, 512, 1000, 1024, 2048, 4096}) {
      BOOST_TEST_CONTEXT(map.name << ", n = " << n) {
        OnMap on(map.shape);
        const Array P = hertz_at(*on.map, n);
        Array y;
        double sum = 0;
        on.grids.of(n).product(P, y, sum);
        const DenseProduct dense = dense_product(*on.map, n, P);
        const double scale = (map.shape.exit - map.shape.inlet) / (pi * film);
        EHD_CHECK(scale * (y - dense.y).abs().maxCoeff(),
                  Tolerance::calibrated(n > 1024 ? with_256 : with_128, "measured with Hertz' pressure, times 1.3"));
        ++checked;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(checked, 35);
}

BOOST_AUTO_TEST_CASE(tables_of_maps_err_by_what_a_map_bears) {
  // Relative to the largest of the product, on the finest grid that only makes a map; its film may err by 1e-2.
  constexpr double errors[] = {4.3e-6, 1.4e-6, 1.4e-6, 1.2e-8, 1.5e-7};
  for (std::size_t k = 0; k < std::size(named_shapes); ++k) {
    BOOST_TEST_CONTEXT(named_shapes[k].name) {
      constexpr int n = 128;
      OnMap on(named_shapes[k].shape);
      const Array P = hertz_at(*on.map, n);
      Array whole, y;
      double sum = 0, same_sum = 0;
      on.grids.of(n).product(P, whole, sum);
      on.grids.use(on.map, false, fast::Tables::of_maps);
      on.grids.of(n).product(P, y, same_sum);
      BOOST_TEST(sum == same_sum);
      EHD_CHECK((y - whole).abs().maxCoeff() / whole.abs().maxCoeff(),
                Tolerance::calibrated(errors[k], "measured, times 1.3"));
    }
  }
}

BOOST_AUTO_TEST_CASE(rough_products_err_by_what_a_smoother_bears) {
  // Relative to the largest of the product, of a pressure that changes sign from node to node, as a smoother's does.
  constexpr double errors[] = {1.2e-4, 3.6e-5, 1.1e-4, 1.6e-6, 6.4e-6};
  int checked = 0;
  for (std::size_t k = 0; k < std::size(named_shapes); ++k) {
    for (const int n : {128, 333, 512, 2048}) {
      BOOST_TEST_CONTEXT(named_shapes[k].name << ", n = " << n) {
        OnMap on(named_shapes[k].shape);
        Array P = hertz_at(*on.map, n), full, rough;
        for (Eigen::Index i = 1; i < n; i += 2) P[i] = -P[i];
        double sum = 0, same_sum = 0;
        on.grids.of(n).product(P, full, sum);
        on.grids.of(n).product(P, rough, same_sum, fast::Accuracy::rough);
        BOOST_TEST(sum == same_sum);
        EHD_CHECK((rough - full).abs().maxCoeff() / full.abs().maxCoeff(),
                  Tolerance::calibrated(errors[k], "measured, times 1.3"));
        ++checked;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(checked, 20);
}

BOOST_AUTO_TEST_CASE(dense_kernel_is_the_product_column_by_column) {
  int rows = 0;
  for (const bool mapped : {false, true}) {
    for (const int n : {32, 64, 333}) {
      BOOST_TEST_CONTEXT("mapped " << mapped << ", n = " << n) {
        OnMap on(heaviest.shape);
        if (!mapped) on.grids.use(nullptr);
        Grid& grid = on.grids.of(n);
        const Eigen::MatrixXd& dense = grid.dense();
        BOOST_REQUIRE_EQUAL(dense.rows(), n + 1);
        for (const int j : {1, 2, n / 3, n / 2, n - 2, n - 1}) {
          Array unit = Array::Zero(n + 1), y;
          unit[j] = 1;
          double sum = 0;
          grid.product(unit, y, sum);
          const double size = dense.col(j).cwiseAbs().maxCoeff();
          EHD_CHECK((y.matrix() - dense.col(j)).cwiseAbs().maxCoeff() / size,
                    Tolerance::round_off(3 * std::log2(2.0 * n) + 64));
          EHD_CHECK(error(sum, grid.slope[j] / n), Tolerance::round_off(3));
          ++rows;
        }
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 36);
}

BOOST_AUTO_TEST_CASE(first_column_is_the_inner_half_of_the_first_node) {
  int rows = 0;
  for (const int n : {64, 97, 512}) {
    BOOST_TEST_CONTEXT("n = " << n) {
      OnMap on(named_shapes[1].shape);
      Grid& grid = on.grids.of(n);
      const Places at = places_of(*on.map, on.map->nodes(n).X);
      const Array& column = grid.first_column();
      double worst = 0;
      for (int i = 0; i <= n; ++i) {
        const double expected =
            at.slope[0] / (2.0 * n) *
            (weight_by_definition(i) + remainder_between(at, i, 0) - std::log(static_cast<double>(n)));
        worst = std::max(worst, std::abs(column[i] - expected));
      }
      EHD_CHECK(worst / column.abs().maxCoeff(),
                n > 128 ? Tolerance::calibrated(1e-8, "128 cells at the inlet's end") : Tolerance::round_off(200));
      EHD_CHECK(error(grid.first_weight, at.slope[0] / (2.0 * n)), Tolerance::round_off(16));
      ++rows;
    }
  }
  // Uniform: Int over half a cell, exact for a linear pressure; against quadrature seen from the next node but one.
  Grids uniform;
  Grid& grid = uniform.of(64);
  const double h = 1.0 / 64;
  const double expected = singular_integral([=](double t) { return (1 - t / h) * std::log(2 * h - t); }, 0, h);
  EHD_CHECK(error(grid.first_column()[2], expected), Tolerance::discretisation(1e-13, 20));
  EHD_CHECK(error(grid.first_weight, h / 2), Tolerance::round_off(2));
  BOOST_REQUIRE_EQUAL(rows, 3);
}

BOOST_AUTO_TEST_CASE(corrected_trapezoid_rule_has_fifth_order) {
  // (1 - t^2)^6 on [-1, 1], smooth at both ends, seen from a node: against quadrature.
  const auto bump = [](double t) { return std::pow(1 - t * t, 6); };
  const std::vector<int> sizes{32, 64, 128, 256};
  std::vector<double> errors;
  for (const int n : sizes) {
    const double h = 2.0 / n;
    double worst = 0;
    for (const int part : {1, 2, 3, 4, 5}) {  // X = -0.75, …, 0.25, nodes of every grid
      const int i = part * n / 8;
      const double X = -1 + i * h;
      const double truth = singular_integral([&](double t) { return bump(t) * std::log(X - t); }, -1, X) +
                           singular_integral([&](double t) { return bump(t) * std::log(t - X); }, X, 1);
      double sum = 0;
      for (int j = 0; j <= n; ++j) sum += h * bump(-1 + j * h) * (trapezoid_weight(std::abs(i - j)) + std::log(h));
      worst = std::max(worst, std::abs(sum - truth));
    }
    errors.push_back(worst);
  }
  EHD_CHECK(std::abs(fitted_order(sizes, errors) - 5), Tolerance::asymptotic(0.2, "h^5 and h^7 at n = 32"));
  // What is left: zeta'(-4) h^5 f''''/12 with zeta'(-4) = 3 zeta(5)/(4 pi^4) = 0.0079838, and the second difference
  // that stands for f'' in the h^3 term, c h^5 f''''/12 with c = zeta(3)/(4 pi^2) = 0.0304485. At X = 0 f'''' = 360.
  const int n = 128;
  const double h = 2.0 / n;
  const double truth = 2 * singular_integral([&](double t) { return bump(t) * std::log(t); }, 0, 1);
  double sum = 0;
  for (int j = 0; j <= n; ++j) sum += h * bump(-1 + j * h) * (trapezoid_weight(std::abs(n / 2 - j)) + std::log(h));
  EHD_CHECK(error(std::abs(sum - truth), (0.0079838 + 0.0304485) * std::pow(h, 5) * 360 / 12),
            Tolerance::asymptotic(0.05, "h^2 f^(6)/f^(4)"));
  for (int k = 0; k < 40; ++k)
    EHD_CHECK(std::abs(trapezoid_weight(k) - weight_by_definition(k)), Tolerance::round_off(8));
}

BOOST_AUTO_TEST_CASE(product_on_a_map_keeps_the_fifth_order) {
  const MapShape shape{.inlet = -1, .exit = 1, .scale = 1.3, .inlet_width = 0.9, .spike = 0.6, .spike_width = 0.7};
  const auto bump = [](double t) { return std::pow(std::max(0.0, 1 - t * t), 6); };
  const std::vector<int> sizes{32, 64, 128, 256};
  std::vector<double> errors;
  for (const int n : sizes) {
    OnMap on(shape);
    Grid& grid = on.grids.of(n);
    const Array X = on.map->nodes(n).X;
    Array P(n + 1), y;
    for (int i = 0; i <= n; ++i) P[i] = bump(X[i]);
    double sum = 0;
    grid.product(P, y, sum);
    double worst = 0;
    for (int i = n / 8; i < n; i += n / 8) {
      const double truth = singular_integral([&](double t) { return bump(t) * std::log(X[i] - t); }, -1, X[i]) +
                           singular_integral([&](double t) { return bump(t) * std::log(t - X[i]); }, X[i], 1);
      worst = std::max(worst, std::abs(2 * (y[i] + std::log(2.0) * sum) - truth));
    }
    errors.push_back(worst);
  }
  EHD_CHECK(std::abs(fitted_order(sizes, errors) - 5), Tolerance::asymptotic(0.3, "h^5 and h^7 at n = 32"));
}

BOOST_AUTO_TEST_CASE(plans_outlive_maps) {
  OnMap on(heaviest.shape);
  (void)on.grids.of(64);
  const double planning_s = on.grids.planning_s();
  on.grids.use(std::make_shared<const Map>(named_shapes[4].shape));
  const Grid& other = on.grids.of(64);
  BOOST_CHECK_EQUAL(on.grids.planning_s(), planning_s);
  const Places at = places_of(*on.grids.map(), on.grids.map()->nodes(64).X);
  EHD_CHECK((other.place - at.place).abs().maxCoeff(), Tolerance::round_off(2));
}

BOOST_AUTO_TEST_SUITE_END()
