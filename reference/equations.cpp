// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace ehd::reference {

namespace {

using Eigen::Index;
using std::numbers::pi;

/// Up to this difference the logarithmic mean is a series of so many terms; those left out are below 1e-17.
constexpr double largest_series_difference = 0.1;
constexpr int series_terms = 10;

/// The logarithmic mean of 1/eta on each face; 1 where the law is trivial, with no exponential.
FaceFluidity face_fluidity(const LawValues<double>& viscosity, bool trivial) {
  const Index n = viscosity.value.size() - 1;
  if (trivial) return {Array::Ones(n), Array::Zero(n), Array::Zero(n)};
  FaceFluidity faces{Array(n), Array(n), Array(n)};
  for (Index i = 0; i < n; ++i) {
    const auto [value, by_a, by_b] = logarithmic_mean(viscosity.value[i], viscosity.value[i + 1]);
    faces.value[i] = value;
    faces.by_left[i] = by_a;
    faces.by_right[i] = by_b;
  }
  return faces;
}

Array mid_points(const Array& nodes) {
  const Index n = nodes.size() - 1;
  return (nodes.head(n) + nodes.tail(n)) / 2;
}

/// A source term and its derivative at each X.
struct Values {
  Array value, slope;
};
Values source(const Sources::Differentiable& term, const Array& X) {
  Values at{Array(X.size()), Array(X.size())};
  for (Index i = 0; i < X.size(); ++i) std::tie(at.value[i], at.slope[i]) = term(X[i]);
  return at;
}

}  // namespace

Grid uniform_grid(double inlet, int intervals) {
  Grid grid{.inlet = inlet, .fractions = Array(intervals + 1), .kappa = Array::Zero(intervals)};
  for (int i = 0; i <= intervals; ++i) grid.fractions[i] = static_cast<double>(intervals - i) / intervals;
  return grid;
}

LogarithmicMean logarithmic_mean(double a, double b) {
  const double d = b - a, at_a = std::exp(-a), at_b = std::exp(-b);
  if (std::abs(d) > largest_series_difference) {
    const double value = (at_a - at_b) / d;
    return {value, (value - at_a) / d, (at_b - value) / d};
  }
  // e^-a phi(d) with phi = (1 - e^-d)/d = Sum (-d)^k/(k+1)!; (phi - 1)/d is the same sum from its second term.
  double value = 0, by_a = 0;
  for (int k = series_terms - 1; k >= 0; --k) {
    by_a = value;
    value = (k % 2 == 0 ? 1 : -1) / std::tgamma(k + 2.0) + d * value;
  }
  value *= at_a;
  by_a *= at_a;
  return {value, by_a, -value - by_a};  // a shift of a and b together scales the mean: by_a + by_b = -value
}

double Evaluation::relative_residual() const {
  const Index n = residual.size() - 1;
  return std::max(residual.head(n).abs().maxCoeff() / H[n], std::abs(residual[n]));
}

Equations::Equations(const Problem& problem, Grid grid)
    : viscosity_(problem.viscosity),
      density_(problem.density),
      sources_(problem.sources),
      lambda_(problem.groups.lambda),
      grid_(std::move(grid)),
      hats_(hat_integrals(grid_.fractions)),
      kernel_(log_kernel(grid_.fractions)) {
  // Face value from node i and a slope between the upstream and the downstream difference, in physical space:
  // f_i + (h_i/2) [ (1+k)/2 (f_(i+1) - f_i)/h_i + (1-k)/2 (f_i - f_(i-1))/h_(i-1) ].
  const Index n = grid_.intervals();
  const Array h = grid_.fractions.head(n) - grid_.fractions.tail(n);
  weight_after_ = (1 + grid_.kappa) / 4;
  weight_before_ = Array::Zero(n);
  weight_before_.tail(n - 1) = -(1 - grid_.kappa.tail(n - 1)) / 4 * h.tail(n - 1) / h.head(n - 1);
  weight_after_[0] = 0.5;  // no node before the first: the mean
  weight_here_ = 1 - weight_before_ - weight_after_;
}

Array Equations::film_without_offset(const Array& P, double exit) const {
  const double length = exit - grid_.inlet;
  const Array log_integral = length * ((kernel_ * P.matrix()).array() + std::log(length) * (hats_ * P).sum());
  Array film = grid_.nodes(exit).square() / 2 - log_integral / pi;
  if (sources_) film += source(sources_->film, grid_.nodes(exit)).value;
  return film;
}

Evaluation Equations::evaluate(const State& state) const {
  const Index n = grid_.intervals();
  const Array& P = state.P;
  const double length = state.exit - grid_.inlet;
  Evaluation at;
  at.X = grid_.nodes(state.exit);
  const Array film = film_without_offset(P, state.exit);
  at.H = state.offset + film;

  // At fixed P and s: dX/dX* = 1 - s, d length/dX* = 1.
  const double load = (hats_ * P).sum();
  at.deflection_by_exit = at.X * (1 - grid_.fractions) - (at.X.square() / 2 - film) / length - load / pi;
  if (sources_) {
    const Values added = source(sources_->film, at.X);  // in `film` too, and not proportional to the length
    at.deflection_by_exit += added.slope * (1 - grid_.fractions) - added.value / length;
  }

  ehd::evaluate(viscosity_, P, at.viscosity);
  ehd::evaluate(density_, P, at.density);
  at.viscosity_points = is_trivial(viscosity_) ? 0 : n + 1;
  at.density_points = is_trivial(density_) ? 0 : n + 1;

  at.mean_fluidity = face_fluidity(at.viscosity, is_trivial(viscosity_));
  const Array spacing = at.X.tail(n) - at.X.head(n);
  const Array face_film = (at.H.head(n) + at.H.tail(n)) / 2;
  const Array face_density = (at.density.value.head(n) + at.density.value.tail(n)) / 2;
  at.gradient = (P.tail(n) - P.head(n)) / spacing;
  at.mobility = face_density * face_film.cube() * at.mean_fluidity.value / lambda_;

  const Array f = at.density.value * at.H;
  at.wedge = weight_here_ * f.head(n) + weight_after_ * f.tail(n);
  at.wedge.tail(n - 1) += weight_before_.tail(n - 1) * f.head(n - 1);

  at.residual.resize(n + 1);
  at.residual.head(n) = at.mobility * at.gradient - at.wedge + f[n];
  at.residual[n] = 2 / pi * length * load - 1;
  if (sources_) {
    at.residual.head(n) +=
        source(sources_->balance, at.X.tail(1)).value[0] - source(sources_->balance, mid_points(at.X)).value;
    at.residual[n] -= sources_->load;
  }

  // Each term of the flux is known to rounding: P in the gradient; H, a difference of terms of size 1 + X^2/2, in
  // the mobility (as its cube) and in the wedge.
  const Array film_terms = 1 + at.X.head(n).square() / 2;
  at.rounding.resize(n + 1);
  at.rounding.head(n) = std::numeric_limits<double>::epsilon() *
                        (at.mobility * (P.head(n) + P.tail(n)).abs() / spacing +
                         (3 * (at.mobility * at.gradient / face_film).abs() + face_density) * film_terms);
  at.rounding[n] = std::numeric_limits<double>::epsilon();
  return at;
}

Eigen::MatrixXd Equations::jacobian(const State& state, const Evaluation& at) const {
  const Index n = grid_.intervals();
  const double length = state.exit - grid_.inlet;
  const Array spacing = at.X.tail(n) - at.X.head(n);
  const Array face_film = (at.H.head(n) + at.H.tail(n)) / 2;
  const Array face_density = (at.density.value.head(n) + at.density.value.tail(n)) / 2;
  const Array flow = at.mobility * at.gradient;

  // Flux of face i by the film at nodes i-1, i, i+1. The mean film takes half of each neighbour.
  const Array by_mean_film = 1.5 * flow / face_film;
  const Array& rho = at.density.value;
  Array film_before = Array::Zero(n);
  film_before.tail(n - 1) = -weight_before_.tail(n - 1) * rho.head(n - 1);
  const Array film_here = by_mean_film - weight_here_ * rho.head(n);
  const Array film_after = by_mean_film - weight_after_ * rho.tail(n);

  // Flux of face i by the pressure at the same nodes where the film is fixed: density, fluidity, gradient.
  const Array by_mean_density = flow / (2 * face_density);
  const Array by_fluidity = face_density * face_film.cube() / lambda_ * at.gradient;
  const Array wedge_slope = at.density.slope * at.H;  // d(rho H)/dP
  Array pressure_before = Array::Zero(n);
  pressure_before.tail(n - 1) = -weight_before_.tail(n - 1) * wedge_slope.head(n - 1);
  const Array pressure_here = -at.mobility / spacing + by_mean_density * at.density.slope.head(n) +
                              by_fluidity * at.mean_fluidity.by_left * at.viscosity.slope.head(n) -
                              weight_here_ * wedge_slope.head(n);
  const Array pressure_after = at.mobility / spacing + by_mean_density * at.density.slope.tail(n) +
                               by_fluidity * at.mean_fluidity.by_right * at.viscosity.slope.tail(n) -
                               weight_after_ * wedge_slope.tail(n);

  // d(flux + H_n) for a change of the film at every node.
  const auto by_film = [&](const auto& film_change) -> Array {
    Array change = film_here * film_change.head(n) + film_after * film_change.tail(n) + film_change[n];
    change.tail(n - 1) += film_before.tail(n - 1) * film_change.head(n - 1);
    return change;
  };

  Eigen::MatrixXd J(n + 1, n + 1);
  for (Index j = 1; j < n; ++j) {
    const Array film_change = -length / pi * (kernel_.col(j).array() + std::log(length) * hats_[j]);
    J.col(j - 1).head(n) = by_film(film_change);
    J(j - 1, j - 1) += pressure_after[j - 1];
    J(j, j - 1) += pressure_here[j];
    if (j + 1 < n) J(j + 1, j - 1) += pressure_before[j + 1];
    J(n, j - 1) = 2 / pi * length * hats_[j];
  }
  J.col(n - 1).head(n) = by_film(Array::Ones(n + 1).eval());
  J(n, n - 1) = 0;
  J.col(n).head(n) = by_film(at.deflection_by_exit) - flow / length;
  J(n, n) = 2 / pi * (hats_ * state.P).sum();
  if (sources_)
    J.col(n).head(n).array() += source(sources_->balance, at.X.tail(1)).slope[0] -
                                source(sources_->balance, mid_points(at.X)).slope * (1 - mid_points(grid_.fractions));
  return J;
}

}  // namespace ehd::reference
