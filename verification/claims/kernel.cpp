// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 1 to 3: the logarithmic kernel by each solver's own code against quadrature, the products by FFT on uniform
// and mapped grids against dense ones, and the deflection by Hertz's pressure.
#include "reference/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "contact/hertz.hpp"
#include "fast/convolution.hpp"
#include "fast/grid.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/hertz_gap.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/studies/draw.hpp"
#include "verification/studies/fits.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;

/// Int_0^1 (1 - s) ln|k + s| ds by quadrature: the half of a hat function beyond node k; k may be negative.
double half_hat_by_quadrature(int k) {
  return exact::integral([k](double s) { return (1 - s) * std::log(std::abs(k + s)); }, 0, 1);
}

/// Int_-1^1 (1 or t) ln|v - t| dt by quadrature, split so that the singular point is an end point. Outside the element
/// ln|v| is split off, whose first moment vanishes: the quadrature need not find a small number among large ones.
double moment_by_quadrature(double v, bool first) {
  const auto beyond = [=](double t) { return (first ? t : 1.0) * std::log1p(-t / v); };
  if (v <= -1 || v >= 1) return exact::integral(beyond, -1, 1) + (first ? 0 : 2 * std::log(std::abs(v)));
  const auto g = [=](double u, double direction) { return (first ? v + direction * u : 1.0) * std::log(u); };
  return exact::integral([=](double u) { return g(u, -1); }, 0, v + 1) +
         exact::integral([=](double u) { return g(u, 1); }, 0, 1 - v);
}

Findings judge_weights() {
  Findings found;
  double worst = 0;
  for (const double v : {0.0, -0.35, 0.8, 1.0, -1.0, 1.6, -4.9, 5.1, 37.0, -2.0e3}) {
    const auto moments = reference::log_moments(v);
    const double size = 1 + std::log(1 + std::abs(v));
    worst = worse(worst, std::abs(moments.zeroth - moment_by_quadrature(v, false)) / size,
                  std::abs(moments.first - moment_by_quadrature(v, true)) / size);
    if (std::isnan(moment_by_quadrature(v, false) + moment_by_quadrature(v, true))) worst = NAN;
  }
  // The quadrature is granted 1e-13, the weights declare 1e-14.
  found.claims.push_back(claim({.id = "kernel/reference-moments",
                                .rung = 1,
                                .statement = "the moments of ln|v - t| in reference/ equal adaptive quadrature"},
                               worst, 0, Tolerance::discretisation(1.1e-13, 2)));

  worst = 0;
  for (const int k : {0, 1, 2, 7, 23, 24, 25, 120, 3000}) {
    const double hat = half_hat_by_quadrature(k) + half_hat_by_quadrature(-k);
    worst = worse(worst, std::abs(fast::hat_moment(k) - hat) / (1 + std::log(1.0 + k)));
    if (std::isnan(hat)) worst = NAN;
  }
  found.claims.push_back(claim({.id = "kernel/fast-weights",
                                .rung = 1,
                                .statement = "the weights of the hat function in fast/ equal adaptive quadrature"},
                               worst, 0, Tolerance::discretisation(1.1e-13, 2)));

  // Both codes compute one integral: K_ij = h (g_|i-j| + ln h) on equal cells. h is a power of two, so that the nodes
  // are exact.
  constexpr int intervals = 200;
  constexpr double h = 1.0 / 32;
  const Array nodes = Array::LinSpaced(intervals + 1, intervals * h, 0.0);
  const Eigen::MatrixXd kernel = reference::log_kernel(nodes);
  double apart = 0, asymmetry = 0;
  for (int i = 1; i < intervals; ++i) {
    for (int j = 1; j < intervals; ++j) {
      apart = worse(apart, std::abs(kernel(i, j) - h * (fast::hat_moment(std::abs(i - j)) + std::log(h))) / h);
      asymmetry = worse(asymmetry, std::abs(kernel(i, j) - kernel(j, i)) / h);
    }
  }
  // reference/ declares 1e-14 (1 + ln|v|) a moment, with four moments a weight and v up to 400 half cells. fast/ takes
  // second differences of u^2 ln|u|/2 up to u = 24: four terms of that size, rounded.
  const double by_reference = 4e-14 * (1 + std::log(2.0 * intervals));
  const double by_fast = 4 * (24.0 * 24 * std::log(24.0) / 2) * std::numeric_limits<double>::epsilon();
  found.claims.push_back(claim(
      {.id = "kernel/two-codes", .rung = 1, .statement = "the kernels of reference/ and fast/ agree on equal cells"},
      apart, 0, Tolerance::discretisation(by_reference + by_fast, 1), "200 cells, relative to a cell"));
  found.claims.push_back(
      claim({.id = "kernel/symmetry", .rung = 1, .statement = "the kernel of equal cells is symmetric"}, asymmetry, 0,
            Tolerance::discretisation(by_reference, 1)));
  return found;
}

Findings judge_operator() {
  Findings found;
  for (const int intervals : {64, 256, 1024}) {
    fast::Convolution convolution(intervals);
    Draw draw(20240917);  // any fixed seed
    Array x(intervals + 1), dense = Array::Zero(intervals + 1), y(intervals + 1);
    for (double& value : x) value = draw.uniform(-1, 1);
    x[intervals] = 0;
    double weights = 0;
    for (int i = 0; i <= intervals; ++i) {
      for (int j = 0; j <= intervals; ++j) dense[i] += convolution.weight(std::abs(i - j)) * x[j];
      weights += 2 * convolution.weight(i) * convolution.weight(i);
    }
    convolution.apply(x, y);
    // A transform of N = 2n points errs by eps log2 N in the 2-norm; three transforms and a product:
    // |error|_max <= 4 eps log2(2n) |g|_2 |x|_2, beside the dense sum's own n eps.
    const double bound = std::sqrt(weights) * std::sqrt(x.square().sum());
    found.claims.push_back(
        claim({.id = fmt::format("operator/fft-{}", intervals),
               .rung = 2,
               .statement = fmt::format("the FFT product equals the dense one on {} cells", intervals)},
              (y - dense).abs().maxCoeff() / bound, 0, Tolerance::round_off(4 * std::log2(2.0 * intervals)),
              "relative to |g|_2 |x|_2"));
  }
  return found;
}

/// Sum_j h phi'_j P_j (w_|i-j| + Lambda_ij + ln h) term by term, every factor from its definition, and the largest sum
/// of the terms' sizes.
struct DenseProduct {
  Array y;
  double size = 0;
};
DenseProduct dense_product(const fast::Map& map, const Array& X, const Array& P) {
  constexpr double c = 1.2020569031595942854 / (4 * pi * pi);  // zeta(3)/(4 pi^2)
  const Eigen::Index n = X.size() - 1;
  const double h = 1 / static_cast<double>(n), length = X[n] - X[0];
  DenseProduct result{.y = Array::Zero(n + 1)};
  for (Eigen::Index i = 0; i <= n; ++i) {
    double size = 0;
    for (Eigen::Index j = 1; j < n; ++j) {
      const double k = static_cast<double>(std::abs(i - j)), slope = 1 / (map.slope(X[j]) * length);
      const double weight = k == 0 ? -std::log(2 * pi) + 2 * c : k == 1 ? -c : std::log(k);
      const double beside = std::log(k == 0 ? slope : std::abs(X[i] - X[j]) / length / (k * h));
      result.y[i] += h * slope * P[j] * (weight + beside + std::log(h));
      size += h * slope * std::abs(P[j]) * (std::abs(weight) + std::abs(beside) + std::abs(std::log(h)));
    }
    result.size = std::max(result.size, size);
  }
  return result;
}

/// The mapped operator. Up to 128 cells the smooth remainder is computed whole, and the only error is rounding. On more
/// cells it is interpolated with eight points from a table of 128 or 256 cells.
Findings judge_mapped_operator() {
  // A map as at (M, L) = (60, 10) with H_cen = 0.02.
  constexpr double film = 0.02;
  const auto map = std::make_shared<const fast::Map>(fast::MapShape{
      .inlet = -4, .exit = 1.033, .scale = 1, .inlet_width = 0.0737, .spike = 0.967, .spike_width = 0.0015});
  const double length = map->shape().exit - map->shape().inlet;
  Findings found;
  for (const int intervals : {64, 128, 512, 2048}) {
    fast::Grids grids;
    grids.use(map);
    const Array X = map->nodes(intervals).X, P = hertz::pressure(X);
    Array y;
    double load = 0;
    grids.of(intervals).product(P, y, load);
    const DenseProduct dense = dense_product(*map, X, P);
    const double apart = (y - dense.y).abs().maxCoeff();
    const bool whole = intervals <= 128;
    // Three transforms and a product, as above, and two sums. Differences of near places cancel: eps/smallest spacing.
    const double nearest = (X.tail(intervals) - X.head(intervals)).minCoeff() / length;
    found.claims.push_back(claim(
        {.id = fmt::format("operator/mapped-{}", intervals),
         .rung = 2,
         .statement = fmt::format("FFT and smooth remainder make the dense product on {} mapped cells{}", intervals,
                                  whole ? "" : ", but for what interpolation leaves of a film")},
        whole ? apart / dense.size : length / pi * apart / film, 0,
        whole ? Tolerance::round_off(4 * std::log2(2.0 * intervals) + 2 * std::sqrt(intervals) +
                                     0.1 / (nearest * intervals))
              : Tolerance::calibrated(intervals <= 1024 ? 1e-6 : 1e-8, "eight points of 128 or 256 cells"),
        whole ? "relative to the sum of its terms' sizes" : "film error over H_cen = 0.02, largest of all nodes"));
  }
  return found;
}

/// |film - flat| for Hertz's pressure on equal cells of [-1, 1]: at the centre, or the largest of all nodes.
double flatness_error(int intervals, bool centre_only) {
  const Array nodes = Array::LinSpaced(intervals + 1, 1.0, -1.0);
  const Array deflection = (reference::log_kernel(nodes) * hertz::pressure(nodes).matrix()).array() / pi;
  const Array error = (nodes.square() / 2 - deflection + hertz::dry_offset()).abs();
  return centre_only ? error[intervals / 2] : error.maxCoeff();
}

Findings judge_elasticity() {
  Findings found;
  double worst = 0;
  for (const double X : {-6.1, -1.0, -0.7, 0.0, 0.43, 1.0, 1.2, 2.9}) {
    const double closed = hertz::gap(Array::Constant(1, X))[0] - hertz::dry_offset();
    worst = worse(worst, std::abs(exact::hertz_film_by_quadrature(X) / closed - 1));
    if (std::isnan(exact::hertz_film_by_quadrature(X))) worst = NAN;
  }
  found.claims.push_back(claim({.id = "elasticity/hertz-gap",
                                .rung = 3,
                                .statement = "Hertz's pressure leaves a flat gap inside, and the printed one outside"},
                               worst, 0, Tolerance::discretisation(1e-12, 1), "closed form against quadrature"));

  // At the centre the ends have the weight ln|0 -+ 1| = 0, so that the second order of linear interpolation shows. Over
  // the whole contact, the square root in the pressure at an end costs a load of order h^(3/2), there with weight ln h.
  for (const bool centre : {true, false}) {
    const double declared = centre ? 2.0 : 1.5;
    std::vector<double> x, y;
    for (const int intervals : {64, 128, 256, 512}) {
      const double logarithm = centre ? 1 : std::log(intervals / 2.0);
      x.push_back(std::log2(intervals));
      y.push_back(-std::log2(flatness_error(intervals, centre) / logarithm));
    }
    found.claims.push_back(
        order_claim({.id = centre ? "elasticity/order-centre" : "elasticity/order-contact",
                     .rung = 3,
                     .statement = std::string("on piecewise linear pressure the film of Hertz's contact converges ") +
                                  (centre ? "like h^2 at the centre" : "like h^(3/2) ln h over the whole contact")},
                    slope(x, y), declared, order_over_four_grids(), "64 to 512 cells on [-1, 1]"));
  }
  return found;
}

Findings judge_mapped_elasticity() {
  // On a map both edges are nodes. The pressure's square root there leaves zeta(-1/2) h^(3/2) (Navot 1961).
  const auto map = std::make_shared<const fast::Map>(
      fast::MapShape{.inlet = -1, .exit = 1, .scale = 1, .inlet_width = 0.2, .spike = 0.9, .spike_width = 0.1});
  std::vector<double> x, minus;
  double last = 0;
  for (const int intervals : {128, 256, 512, 1024, 2048}) {
    fast::Grids grids;
    grids.use(map);
    const Array X = map->nodes(intervals).X;
    Array y;
    double load = 0;
    grids.of(intervals).product(hertz::pressure(X), y, load);
    const double length = X[intervals] - X[0];
    last = 0;
    for (Eigen::Index i = 0; i <= intervals; ++i) {
      if (std::abs(X[i]) > 0.9) continue;
      const double deflection = length / pi * (y[i] + std::log(length) * load);
      last = worse(last, std::abs(X[i] * X[i] / 2 - deflection + hertz::dry_offset()));
    }
    x.push_back(std::log2(intervals));
    minus.push_back(-std::log2(last));
  }
  return {{order_claim({.id = "elasticity/order-mapped",
                        .rung = 3,
                        .statement = "on a mapped grid the film of Hertz's contact converges like h^(3/2)"},
                       slope(x, minus), 1.5,
                       Tolerance::calibrated(0.1, "fitted orders over five grids are read to a tenth"),
                       fmt::format("128 to 2048 cells, |X| <= 0.9, error {:.1e} on the last", last))},
          {}};
}

}  // namespace

std::vector<Topic> kernel_topics() {
  return {{.name = "kernel", .rungs = {1}, .judge = judge_weights},
          {.name = "operator", .rungs = {2}, .judge = judge_operator},
          {.name = "operator", .rungs = {2}, .judge = judge_mapped_operator},
          {.name = "elasticity", .rungs = {3}, .judge = judge_elasticity},
          {.name = "elasticity", .rungs = {3}, .judge = judge_mapped_elasticity}};
}

}  // namespace ehd::verification
