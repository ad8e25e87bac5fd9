// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/harmonic.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "contact/lu_factors.hpp"

namespace ehd::reference::hp {

namespace {

using std::numbers::pi;
constexpr Complex i_unit(0, 1);
/// Nearer to X = 0 than this part of x, the closed form of the tail's film is a difference of terms like 1/v^2, and the
/// series is taken; so many terms leave 1e-20.
constexpr double tail_series_below = 0.1;
constexpr int tail_series_terms = 20;

/// t of the places where an element has rows: its collocation points, then its right end.
VectorOf<double> row_places_of(const ReferenceElement<double>& shape) {
  VectorOf<double> t(shape.degree + 1);
  t << shape.points, 1;
  return t;
}

/// Values at an element's rows -> Legendre coefficients.
MatrixOf<double> rows_to_legendre(const ReferenceElement<double>& shape) {
  const VectorOf<double> t = row_places_of(shape);
  MatrixOf<double> values(t.size(), t.size());
  for (Eigen::Index i = 0; i < t.size(); ++i) values.row(i) = legendre(shape.degree, t[i]).transpose();
  return values.inverse();
}

/// Values at an element's rows -> integrals from each collocation point, and last from the left end, to the right end:
/// Int_t^1 P_k = (P_(k-1) - P_(k+1))/(2k + 1) at t.
MatrixOf<double> integrals_to_right_end(const ReferenceElement<double>& shape) {
  const int p = shape.degree;
  MatrixOf<double> of_legendre(p + 1, p + 1);
  for (int i = 0; i <= p; ++i) {
    const double t = i < p ? shape.points[i] : -1;
    const VectorOf<double> P = legendre(p + 1, t);
    of_legendre(i, 0) = 1 - t;
    for (int k = 1; k <= p; ++k) of_legendre(i, k) = (P[k - 1] - P[k + 1]) / (2 * k + 1);
  }
  return of_legendre * rows_to_legendre(shape);
}

/// The film at X that a load of 1 before the inlet causes, spread over X' = -y < -x like y^-4:
///   -(1/pi) Int_x^inf 3 x^3/y^4 ln(y + X) dy = -(1/pi) [ ln(x + X) + 1/(2v) - 1/v^2 + ln(1 + v)/v^3 ],  v = X/x.
double film_of_tail_load(double x, double X) {
  const double v = X / x;
  double B = std::log(x);
  if (std::abs(v) < tail_series_below) {
    double power = 1;  // (-v)^k: ln(1 + v) + Sum (-v)^k/(k + 3)
    for (int k = 0; k < tail_series_terms; ++k, power *= -v) B += power / (k + 3) + (k > 0 ? -power / k : 0);
  } else {
    const double room = 1 + v;
    if (room > 0) B += (1 + 1 / (v * v * v)) * std::log(room);  // its factor vanishes at v = -1
    B += 1 / (2 * v) - 1 / (v * v);
  }
  return -B / pi;
}

}  // namespace

Harmonic::Harmonic(const Problem& problem, Resolved steady)
    : steady_(std::move(steady)), lambda_(problem.groups.lambda) {
  const auto& equations = *steady_.equations;
  const auto& state = steady_.run.state;
  const auto& at = steady_.run.at;
  stretching_ = equations.stretching(state.exit);
  J_ = equations.jacobian(state, at);
  film_ = equations.film_jacobian(state, at);
  by_film_ = 3 * at.mobility * at.slope / at.H - at.density.value;
  coordinate_.resize(at.H.size());
  for (Eigen::Index r = 0; r < at.H.size(); ++r)
    coordinate_[r] = equations.coordinate_by_exit(equations.row_places()[static_cast<std::size_t>(r)]);
  add_squeeze();
  tail_load_ = VectorOf<double>::Zero(J_.cols());
  tail_film_ = ArrayOf<double>::Zero(at.H.size());
  tail_squeeze_ = VectorOf<double>::Zero(intervals());
  if (std::holds_alternative<Flooded>(problem.inlet)) add_tail();
}

template <class AtRows>
AtRows Harmonic::integrals_to_exit(const AtRows& at_rows) const {
  const auto& equations = *steady_.equations;
  const int n = intervals();
  AtRows integrals(n + 1, at_rows.cols());
  AtRows beyond = AtRows::Zero(1, at_rows.cols());
  std::map<int, MatrixOf<double>> rules;
  for (int e = equations.mesh().elements() - 1; e >= 0; --e) {
    const auto& shape = equations.reference(e);
    const int first = equations.first_node(e), p = shape.degree;
    auto& rule = rules[p];
    if (rule.size() == 0) rule = integrals_to_right_end(shape);
    AtRows values(p + 1, at_rows.cols());
    values.topRows(p) = at_rows.middleRows(first, p);
    values.row(p) = at_rows.row(equations.row_of_right_end(e));
    const AtRows within = equations.half_length(e) * stretching_ * (rule * values);
    integrals.middleRows(first, p) = within.topRows(p).rowwise() + beyond.row(0);
    beyond += within.row(p);
  }
  integrals.row(n) = beyond.row(0);
  return integrals;
}

void Harmonic::add_squeeze() {
  const auto& equations = *steady_.equations;
  const auto& at = steady_.run.at;
  const int n = intervals();
  mass_ = at.density.value.matrix().asDiagonal() * film_;
  const ArrayOf<double> by_pressure = at.density.slope * at.H;
  for (int e = 0; e < equations.mesh().elements(); ++e) {
    const auto& shape = equations.reference(e);
    const int first = equations.first_node(e), p = shape.degree, columns = std::min(p + 1, n - first);
    mass_.block(first, first, p, columns) +=
        (by_pressure.segment(first, p).matrix().asDiagonal() * shape.at_points).leftCols(columns);
    const int right = equations.row_of_right_end(e);
    if (first + p < n) mass_(right, first + p) += by_pressure[right];
  }
  mass_(mass_.rows() - 1, 0) += by_pressure[mass_.rows() - 1];

  MatrixOf<double> inner = integrals_to_exit(mass_);
  const VectorOf<double> mass = (at.density.value * at.H).matrix();
  const MatrixOf<double> steady_mass = integrals_to_exit(MatrixOf<double>(mass));
  const double length = stretching_ * equations.mesh().extent();
  inner.col(n + 2) += steady_mass / length;
  inner.col(n + 2).array() -= steady_.run.state.flux;
  inner.col(n + 2).head(n).array() += coordinate_.head(n) * mass.head(n).array();
  K_ = MatrixOf<double>::Zero(n + 3, n + 3);
  K_.topRows(n) = inner.topRows(n);
  inflow_ = inner.row(n).transpose();
}

void Harmonic::add_tail() {
  const auto& equations = *steady_.equations;
  const auto& at = steady_.run.at;
  const int n = intervals();
  const double x = -equations.mesh().inlet;
  VectorOf<double> load = VectorOf<double>::Zero(n + 3);  // W_1
  load.head(n) = stretching_ * equations.integrals().head(n);
  load[n + 2] = at.load_integral / equations.mesh().extent();
  const VectorOf<double> film = film_.row(film_.rows() - 1).transpose();
  const VectorOf<double> pressure = -lambda_ / std::pow(x, 4) * (8 * inflow_ / (5 * x) + 0.4 * film - load / (10 * pi));
  tail_load_ = -lambda_ / std::pow(x, 3) * (2 * inflow_ / (5 * x) + 4 * film / 15 - 11 * load / (90 * pi));
  for (Eigen::Index r = 0; r < at.X.size(); ++r) tail_film_[r] = film_of_tail_load(x, at.X[r]);
  const MatrixOf<double> squeeze = integrals_to_exit(MatrixOf<double>((at.density.value * tail_film_).matrix()));
  tail_squeeze_ = squeeze.col(0).head(n);

  const int exit = equations.row_of_right_end(equations.mesh().elements() - 1);
  K_.topRows(n) += (by_film_ * tail_film_).head(n).matrix() * tail_load_.transpose();
  K_.row(n) = -pressure.transpose();
  K_.row(n + 1) = 2 / pi * tail_load_.transpose();
  K_.row(n + 2) = -at.density.value[exit] * tail_film_[exit] * tail_load_.transpose();
}

ComplexVector Harmonic::solved(double Omega, const ComplexVector& drive) const {
  const int n = intervals();
  const Complex squeeze = i_unit * Omega;
  MatrixOf<Complex> A = J_ + squeeze * K_;
  A.topRows(n) += (squeeze * squeeze) * (tail_squeeze_ * tail_load_.transpose());
  const VectorOf<double> rows = steady_.run.at.scale.cwiseInverse();
  A = rows.asDiagonal() * A;
  return Eigen::PartialPivLU<Eigen::Ref<MatrixOf<Complex>>>(A).solve(rows.cwiseProduct(drive));
}

const ComplexVector& Harmonic::of_load(double Omega) const {
  if (of_load_ && of_load_->first == Omega) return of_load_->second;
  ComplexVector drive = ComplexVector::Zero(J_.rows());
  drive[intervals() + 1] = 2 / pi;
  return of_load_.emplace(Omega, solved(Omega, drive)).second;
}

const SlowMotion& Harmonic::of_slow_load() const {
  if (of_slow_load_) return *of_slow_load_;
  const VectorOf<double> rows = steady_.run.at.scale.cwiseInverse();
  const LuFactors lu(rows.asDiagonal() * J_);
  VectorOf<double> drive = VectorOf<double>::Zero(J_.rows());
  drive[intervals() + 1] = 2 / pi;
  SlowMotion& slow = of_slow_load_.emplace();
  slow.u_0 = lu.solve(rows.cwiseProduct(drive));
  slow.u_1 = lu.solve(rows.cwiseProduct(-squeeze(slow.u_0)));
  return slow;
}

ArrayOf<Complex> Harmonic::feature(const Waviness& waviness) const {
  return (-i_unit * waviness.wavenumber() * steady_.run.at.X).exp();
}

const ComplexVector& Harmonic::of_waviness(const Waviness& waviness) const {
  if (of_waviness_ && of_waviness_->first == waviness) return of_waviness_->second;
  const auto& at = steady_.run.at;
  const int n = intervals();
  const int exit = steady_.equations->row_of_right_end(steady_.equations->mesh().elements() - 1);
  const ArrayOf<Complex> R = feature(waviness);
  // i Omega Int_X^X* R dX' = s (R(X) - R(X*)) exactly, also where elements are longer than waves; what is left of rho
  // R, (rho - 1) R, falls with the pressure.
  const MatrixOf<Complex> denser = integrals_to_exit(MatrixOf<Complex>(((at.density.value - 1) * R).matrix()));
  const ArrayOf<Complex> squeeze =
      waviness.slip * (R - R[exit]).head(n) + i_unit * waviness.Omega() * denser.col(0).head(n).array();
  ComplexVector drive = ComplexVector::Zero(J_.rows());
  drive.head(n) = -((by_film_ * R).head(n) + squeeze).matrix();
  drive[n + 2] = at.density.value[exit] * R[exit];
  return of_waviness_.emplace(waviness, solved(waviness.Omega(), drive)).second;
}

ComplexVector Harmonic::of_sources(double Omega, const Sources& sources) const {
  const auto& at = steady_.run.at;
  const int n = intervals(), exit = steady_.equations->row_of_right_end(steady_.equations->mesh().elements() - 1);
  const MatrixOf<Complex> mass = integrals_to_exit(MatrixOf<Complex>((at.density.value * sources.feature).matrix()));
  ComplexVector drive = ComplexVector::Zero(J_.rows());
  drive.head(n) =
      sources.balance.head(n) - (by_film_ * sources.feature).head(n).matrix() - i_unit * Omega * mass.col(0).head(n);
  drive[n + 1] = 2 / pi * sources.load;
  drive[n + 2] = sources.balance[n] + at.density.value[exit] * sources.feature[exit];
  return solved(Omega, drive);
}

ComplexVector Harmonic::film_change(const ComplexVector& u, double Omega) const {
  const Complex tail = i_unit * Omega * tail_load_.cwiseProduct(u).sum();
  return film_ * u + tail * tail_film_.matrix();
}

std::optional<Complex> Harmonic::central_film(const ComplexVector& u, double Omega) const {
  const auto& equations = *steady_.equations;
  const auto& breakpoints = equations.mesh().breakpoints;
  const double exit = steady_.run.state.exit, xi = -exit / stretching_;
  if (xi <= breakpoints.front() || xi >= 0) return std::nullopt;
  const auto right = std::upper_bound(breakpoints.begin(), breakpoints.end(), xi);
  const int e = static_cast<int>(right - breakpoints.begin()) - 1;
  const auto& shape = equations.reference(e);
  const int first = equations.first_node(e), p = shape.degree, end = equations.row_of_right_end(e);
  const ComplexVector change = film_change(u, Omega);
  ComplexVector H_1(p + 1);
  VectorOf<double> H(p + 1);
  H_1 << change.segment(first, p), change[end];
  H << steady_.run.at.H.segment(first, p).matrix(), steady_.run.at.H[end];
  const double half = equations.half_length(e), t = (xi - breakpoints[static_cast<std::size_t>(e)]) / half - 1;
  const MatrixOf<double> coefficients = rows_to_legendre(shape);
  const Complex moving = (legendre(p, t).transpose() * coefficients) * H_1;
  const double slope = legendre_derivatives(p, t).dot(coefficients * H) / (half * stretching_);
  const double by_exit = 1 + xi / equations.mesh().extent();
  return moving - slope * by_exit * u[intervals() + 2];
}

std::vector<double> Harmonic::excess(const ComplexVector& u, double Omega, double film, double amplitude,
                                     const Waviness* waviness) const {
  const auto& equations = *steady_.equations;
  const auto& at = steady_.run.at;
  const int n = intervals();
  ComplexVector mass = mass_ * u + at.density.value.matrix().cwiseProduct(film_change(u, Omega) - film_ * u);
  if (waviness) mass += ((at.density.value - 1) * feature(*waviness)).matrix();
  ComplexVector P = ComplexVector::Zero(n + 1);
  P.head(n) = u.head(n);
  const double length = std::max(1.0, std::sqrt(2 * steady_.run.state.flux));
  std::vector<double> excess;
  for (int e = 0; e < equations.mesh().elements(); ++e) {
    const auto& shape = equations.reference(e);
    const int first = equations.first_node(e), p = shape.degree, right = equations.row_of_right_end(e);
    const double half = equations.half_length(e) * stretching_;
    const double tail = (shape.to_legendre.bottomRows(2) * P.segment(first, p + 1)).cwiseAbs().sum();
    ComplexVector at_rows(p + 1);
    at_rows << mass.segment(first, p), mass[right];
    const double mass_tail = (rows_to_legendre(shape).bottomRows(2) * at_rows).cwiseAbs().sum();
    // A flux that is wrong by e moves the film by e where the oil is nearly solid, else the pressure by lambda e/H^3.
    const double flux_to_film =
        std::min(1.0, lambda_ * half * half / std::pow(at.H[right], 3) * at.fluidity.maxCoeff());
    // A pressure that is wrong before the contact stays wrong up to it, because nothing holds it there.
    const double reach = std::max(0.0, -at.X[right] - length);
    const double error = tail * (half / (p * p) + reach / p) + Omega * half * mass_tail / p * flux_to_film;
    excess.push_back(error / (film * amplitude));
  }
  return excess;
}

}  // namespace ehd::reference::hp
