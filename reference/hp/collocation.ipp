// SPDX-License-Identifier: GPL-3.0-or-later
// Implementation of collocation.hpp, to be included where another scalar type than double is wanted.
#pragma once

#include <boost/math/constants/constants.hpp>

#include "reference/hp/collocation.hpp"

namespace ehd::reference::hp {

namespace detail {
/// Nearer to X = 0 than this part of x, the closed form of the tail's deflection is a difference of terms like 1/v, and
/// the series is taken; so many terms leave 1e-40, less than the rounding of 34 digits.
inline constexpr double tail_series_below = 0.1;
inline constexpr int tail_series_end = 40;
}  // namespace detail

template <class Scalar>
std::pair<Scalar, Scalar> tail_deflection(const Scalar& lambda, const Scalar& x, const Scalar& X) {
  using std::abs;
  using std::log;
  using std::log1p;
  const Scalar v = X / x, one(1), two(2);
  Scalar B = log(x), slope(0);
  if (abs(v) < Scalar(detail::tail_series_below)) {
    B += one / two;
    Scalar power(1);  // (-v)^(j-1)
    for (int j = 1; j < detail::tail_series_end; ++j, power *= -v) {
      const Scalar coefficient = one / Scalar(j) - one / Scalar(j + 2);
      B += coefficient * power * v;
      slope += Scalar(j) * coefficient * power;
    }
  } else {
    const Scalar room = one + v;
    const Scalar log_room = room > Scalar(0) ? Scalar(log1p(v)) : Scalar(0);  // its factor vanishes at v = -1
    B += one / v + (one - one / (v * v)) * log_room;
    slope = -one / (v * v) + two * log_room / (v * v * v) + (v - one) / (v * v);  // (1 - 1/v^2)/(1 + v) = (v - 1)/v^2
  }
  const Scalar factor = -two * lambda / (Scalar(3) * boost::math::constants::pi<Scalar>() * x * x);
  return {factor * B, factor * slope / x};
}

template <class Scalar>
Collocation<Scalar>::Collocation(const Problem& problem, Mesh mesh, Points points,
                                 std::shared_ptr<const SourcesOf<Scalar>> sources)
    : problem_(problem),
      mesh_(std::move(mesh)),
      points_(points),
      sources_(std::move(sources)),
      flooded_(std::holds_alternative<Flooded>(problem.inlet)),
      intervals_(mesh_.intervals()),
      extent_(mesh_.extent()),
      lambda_(problem.groups.lambda) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (!sources_) sources_ = problem.sources;
  }
  const Scalar two(2);
  int node = 0;
  integrals_ = Vector::Zero(intervals_ + 1);
  for (int e = 0; e < mesh_.elements(); ++e) {
    const int degree = mesh_.degrees[static_cast<std::size_t>(e)];
    auto& element = elements_[degree];
    if (!element) element = std::make_shared<const ReferenceElement<Scalar>>(reference_element<Scalar>(points, degree));
    first_.push_back(node);
    integrals_.segment(node, degree + 1) += half_length(e) * element->weights;
    for (int i = 0; i < degree; ++i)
      places_.push_back({e, Scalar(1) + element->points[i], Scalar(1) - element->points[i]});
    node += degree;
  }
  for (int e = 0; e < mesh_.elements(); ++e) {
    right_end_.push_back(static_cast<int>(places_.size()));
    places_.push_back({e, two, Scalar(0)});
  }
  places_.push_back({0, Scalar(0), two});
  kernel_ = kernel_rows(places_);
}

template <class Scalar>
auto Collocation<Scalar>::kernel_rows(const std::vector<Place<Scalar>>& places) const -> Matrix {
  using std::log;
  const auto rows = static_cast<Eigen::Index>(places.size());
  Matrix kernel = Matrix::Zero(rows, intervals_ + 1);
  Matrix moments;
  Vector work;
  for (int e = 0; e < mesh_.elements(); ++e) {
    const auto& element = reference(e);
    const int degree = element.degree;
    const Scalar half = half_length(e), left = Scalar(mesh_.breakpoints[static_cast<std::size_t>(e)]),
                 right = Scalar(mesh_.breakpoints[static_cast<std::size_t>(e) + 1]);
    const Scalar measure = Scalar(2) * log(half);  // Int_-1^1 ln r dt
    moments.resize(degree + 1, rows);
    work.resize(degree + 2);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Place<Scalar>& at = places[static_cast<std::size_t>(i)];
      const auto other = static_cast<std::size_t>(at.element);
      auto m = moments.col(i);
      if (at.element == e) {
        const Scalar t =
            at.from_left < at.from_right ? Scalar(at.from_left - Scalar(1)) : Scalar(Scalar(1) - at.from_right);
        moments_inside(degree, t, at.from_left, at.from_right, work, m);
      } else if (at.element > e) {
        const Scalar distance = (Scalar(mesh_.breakpoints[other]) - right) + half_length(at.element) * at.from_left;
        moments_outside(degree, Scalar(distance / half), work, m);
      } else {
        const Scalar distance = (left - Scalar(mesh_.breakpoints[other + 1])) + half_length(at.element) * at.from_right;
        moments_outside(degree, Scalar(distance / half), work, m);
        for (int k = 1; k <= degree; k += 2) m[k] = -m[k];
      }
      m[0] += measure;
    }
    kernel.middleCols(first_node(e), degree + 1).noalias() += half * (moments.transpose() * element.to_legendre);
  }
  return kernel;
}

template <class Scalar>
ArrayOf<Scalar> Collocation<Scalar>::film(const State<Scalar>& state, const std::vector<Place<Scalar>>& places,
                                          const Matrix& rows) const {
  using std::log;
  const Scalar pi = boost::math::constants::pi<Scalar>();
  const Scalar s = stretching(state.exit);
  const Vector log_integral = rows * state.P;
  const Scalar load = integrals_.dot(state.P), log_s = log(s);
  ArrayOf<Scalar> H(rows.rows());
  for (Eigen::Index i = 0; i < H.size(); ++i) {
    const Scalar X = state.exit + s * xi(places[static_cast<std::size_t>(i)]);
    H[i] = state.offset + X * X / Scalar(2) - s / pi * (log_integral[i] + log_s * load);
    if (flooded_) H[i] += tail_deflection(lambda_, Scalar(-Scalar(mesh_.inlet)), X).first;
    if (sources_) H[i] += sources_->film(X).first;
  }
  return H;
}

template <class Scalar>
std::vector<Place<Scalar>> Collocation<Scalar>::node_places() const {
  std::vector<Place<Scalar>> places;
  for (int e = 0; e < mesh_.elements(); ++e) {
    const auto& element = reference(e);
    for (int j = 0; j < element.degree; ++j)
      places.push_back({e, Scalar(1) + element.nodes[j], Scalar(1) - element.nodes[j]});
  }
  places.push_back({mesh_.elements() - 1, Scalar(2), Scalar(0)});
  return places;
}

template <class Scalar>
ArrayOf<Scalar> Collocation<Scalar>::node_coordinates(const Scalar& exit) const {
  const auto places = node_places();
  const Scalar s = stretching(exit);
  ArrayOf<Scalar> X(static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < X.size(); ++i) X[i] = exit + s * xi(places[static_cast<std::size_t>(i)]);
  return X;
}

template <class Scalar>
Scalar Collocation<Scalar>::interpolate(const Vector& P, int element, const Scalar& t) const {
  const auto& shape = reference(element);
  const Vector coefficients = shape.to_legendre * P.segment(first_node(element), shape.degree + 1);
  return coefficients.dot(legendre(shape.degree, t));
}

template <class Scalar>
Evaluation<Scalar> Collocation<Scalar>::evaluate(const State<Scalar>& state, const Scalar& floor) const {
  using std::log;
  const Scalar pi = boost::math::constants::pi<Scalar>(), one(1), two(2);
  const auto rows = static_cast<Eigen::Index>(places_.size());
  const Scalar s = stretching(state.exit), log_s = log(s);
  Evaluation<Scalar> at;
  at.X.resize(rows);
  at.P.resize(rows);
  at.slope.resize(rows);
  at.film_by_exit.resize(rows);
  const Vector log_integral = kernel_ * state.P;
  at.load_integral = integrals_.dot(state.P);
  for (int e = 0; e < mesh_.elements(); ++e) {
    const auto& shape = reference(e);
    const auto nodes = state.P.segment(first_node(e), shape.degree + 1);
    // Against the value in the middle, so that a slope of a short element is not the rounding of a large pressure.
    const Scalar base = nodes[shape.degree / 2];
    const Vector local = nodes.array() - base;
    const Scalar per_X = one / (half_length(e) * s);
    at.P.segment(first_node(e), shape.degree) = (shape.at_points * local).array() + base;
    at.slope.segment(first_node(e), shape.degree) = (shape.slope_at_points * local).array() * per_X;
    at.P[row_of_right_end(e)] = nodes[shape.degree];
    at.slope[row_of_right_end(e)] = shape.slope_at_right.dot(local) * per_X;
    if (e == 0) {
      at.P[rows - 1] = nodes[0];
      at.slope[rows - 1] = shape.slope_at_left.dot(local) * per_X;
    }
  }
  at.H.resize(rows);
  ArrayOf<Scalar> source = ArrayOf<Scalar>::Zero(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Scalar place = xi(places_[static_cast<std::size_t>(i)]);
    const Scalar X = state.exit + s * place, X_by_exit = one + place / extent_;
    at.X[i] = X;
    at.H[i] = state.offset + X * X / two - s / pi * (log_integral[i] + log_s * at.load_integral);
    at.film_by_exit[i] = X * X_by_exit - (log_integral[i] + (log_s + one) * at.load_integral) / (pi * extent_);
    if (flooded_) {
      const auto [value, slope] = tail_deflection(lambda_, Scalar(-Scalar(mesh_.inlet)), X);
      at.H[i] += value;
      at.film_by_exit[i] += slope * X_by_exit;
    }
    if (sources_) {
      const auto [value, slope] = sources_->film(X);
      at.H[i] += value;
      at.film_by_exit[i] += slope * X_by_exit;
    }
    if (sources_) source[i] = sources_->balance(X).first;
  }
  ehd::evaluate(problem_.viscosity, at.P, at.viscosity);
  ehd::evaluate(problem_.density, at.P, at.density);
  at.fluidity = (-at.viscosity.value).exp() + floor;
  at.mobility = at.density.value * at.H.cube() * at.fluidity / lambda_;
  at.balance = at.mobility * at.slope - at.density.value * at.H + state.flux - source;

  const int n = intervals_;
  const Scalar film_inlet = at.H[rows - 1], x = -Scalar(mesh_.inlet), x2 = x * x;
  if (flooded_) {
    // P' = lambda (H - C)/H^3 with H = X^2/2 + A beyond the first node, in powers of 1/x; docs/certified-solver.md,
    // section 5.
    const Scalar A = film_inlet - x2 / two;
    at.tail_pressure =
        lambda_ * (Scalar(4) / Scalar(3) - (Scalar(16) * A + Scalar(8) * state.flux) / (Scalar(5) * x2)) / (x * x2);
    at.tail_load = lambda_ * (two / Scalar(3) - (Scalar(4) * A + two * state.flux) / (Scalar(5) * x2)) / x2;
  }
  at.residual.resize(n + 3);
  at.residual.head(n) = at.balance.head(n).matrix();
  at.residual[n] = state.P[0] - at.tail_pressure;
  at.residual[n + 1] = two / pi * (s * at.load_integral + at.tail_load) - one;
  if (sources_) at.residual[n + 1] -= sources_->load;
  const int exit = row_of_right_end(mesh_.elements() - 1);
  at.residual[n + 2] = state.flux - at.density.value[exit] * at.H[exit];
  if (sources_) at.residual[n + 2] -= source[exit];
  at.scale.resize(n + 3);
  at.scale.head(n) = ((at.density.value * at.H).head(n).abs() + std::max(state.flux, Scalar(0))).matrix();
  at.scale[n] = flooded_ ? Scalar(lambda_ / (x * x2)) : Scalar(1);
  at.scale[n + 1] = one;
  at.scale[n + 2] = at.scale[n - 1];
  return at;
}

template <class Scalar>
auto Collocation<Scalar>::film_jacobian(const State<Scalar>& state, const Evaluation<Scalar>& at) const -> Matrix {
  using std::log;
  const Scalar pi = boost::math::constants::pi<Scalar>(), s = stretching(state.exit), log_s = log(s);
  const int n = intervals_;
  Matrix G(at.H.size(), n + 3);
  for (int j = 0; j < n; ++j) G.col(j) = ((kernel_.col(j).array() + log_s * integrals_[j]) * (-s / pi)).matrix();
  G.col(n).setOnes();
  G.col(n + 1).setZero();
  G.col(n + 2) = at.film_by_exit.matrix();
  return G;
}

template <class Scalar>
auto Collocation<Scalar>::jacobian(const State<Scalar>& state, const Evaluation<Scalar>& at) const -> Matrix {
  using std::log;
  const Scalar pi = boost::math::constants::pi<Scalar>(), one(1), two(2), three(3);
  const int n = intervals_;
  const auto rows = at.H.size();
  const Scalar s = stretching(state.exit), log_s = log(s);
  Matrix J(n + 3, n + 3);

  // Through the film: d balance/dH = 3 mobility P'/H - rho, dH/dP = -(s/pi)(W + ln s S), dH/dH_0 = 1.
  const ArrayOf<Scalar> by_film = three * at.mobility * at.slope / at.H - at.density.value;
  for (int j = 0; j < n; ++j)
    J.col(j).head(n) =
        (by_film.head(n) * (kernel_.col(j).head(n).array() + log_s * integrals_[j]) * (-s / pi)).matrix();
  J.col(n).head(n) = by_film.head(n).matrix();
  J.col(n + 1).head(n).setOnes();
  J.col(n + 2).head(n) = (by_film * at.film_by_exit - at.mobility * at.slope / (s * extent_)).head(n).matrix();
  if (sources_) {
    for (int i = 0; i < n; ++i)
      J(i, n + 2) -= sources_->balance(at.X[i]).second * (one + xi(places_[static_cast<std::size_t>(i)]) / extent_);
  }
  // Through the pressure at the point itself, and its slope.
  const ArrayOf<Scalar> by_pressure =
      (at.density.slope * at.H.cube() * at.fluidity -
       at.density.value * at.H.cube() * at.viscosity.slope * (-at.viscosity.value).exp()) /
          lambda_ * at.slope -
      at.density.slope * at.H;
  for (int e = 0; e < mesh_.elements(); ++e) {
    const auto& shape = reference(e);
    const int first = first_node(e), degree = shape.degree;
    const int columns = std::min(degree + 1, n - first);  // the exit's pressure is no unknown
    const Scalar per_X = one / (half_length(e) * s);
    J.block(first, first, degree, columns) +=
        (by_pressure.segment(first, degree).matrix().asDiagonal() * shape.at_points +
         (at.mobility.segment(first, degree) * per_X).matrix().asDiagonal() * shape.slope_at_points)
            .leftCols(columns);
  }

  // Inlet, load and exit.
  const Scalar x = -Scalar(mesh_.inlet), x2 = x * x;
  const Eigen::Index inlet = rows - 1, exit = row_of_right_end(mesh_.elements() - 1);
  Scalar pressure_by_film(0), pressure_by_flux(0), load_by_film(0), load_by_flux(0);
  if (flooded_) {
    pressure_by_film = Scalar(-16) * lambda_ / (Scalar(5) * x2 * x2 * x);
    pressure_by_flux = pressure_by_film / two;
    load_by_film = Scalar(-4) * lambda_ / (Scalar(5) * x2 * x2);
    load_by_flux = load_by_film / two;
  }
  const auto film_row = [&](Eigen::Index row) -> VectorOf<Scalar> {
    return (kernel_.row(row).head(n).transpose() + log_s * integrals_.head(n)) * (-s / pi);
  };
  J.row(n).head(n) = (-pressure_by_film * film_row(inlet)).transpose();
  J(n, 0) += one;
  J(n, n) = -pressure_by_film;
  J(n, n + 1) = -pressure_by_flux;
  J(n, n + 2) = -pressure_by_film * at.film_by_exit[inlet];
  J.row(n + 1).head(n) = (two / pi * (s * integrals_.head(n) + load_by_film * film_row(inlet))).transpose();
  J(n + 1, n) = two / pi * load_by_film;
  J(n + 1, n + 1) = two / pi * load_by_flux;
  J(n + 1, n + 2) = two / pi * (at.load_integral / extent_ + load_by_film * at.film_by_exit[inlet]);
  J.row(n + 2).head(n) = (-at.density.value[exit] * film_row(exit)).transpose();
  J(n + 2, n) = -at.density.value[exit];
  J(n + 2, n + 1) = one;
  J(n + 2, n + 2) = -at.density.value[exit] * at.film_by_exit[exit];
  if (sources_) J(n + 2, n + 2) -= sources_->balance(at.X[exit]).second;
  return J;
}

}  // namespace ehd::reference::hp
