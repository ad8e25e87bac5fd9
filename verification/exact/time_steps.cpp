// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/time_steps.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace ehd::verification::exact {

namespace {

using std::numbers::pi;
constexpr double small_change = 1e-6;  // of the differences that make the matrix; Newton's method corrects them
constexpr double settled = 1e-10;      // of the unknowns, against amplitudes of 1e-4
constexpr int iterations_a_matrix = 6;
constexpr int most_iterations = 60;

/// Int Int of ln|u| twice: hats of width 1 integrate ln|u| to its second difference.
double twice_integrated_log(double u) { return u == 0 ? 0 : u * u / 2 * (std::log(std::abs(u)) - 1.5); }

/// Everything at one time: nodes, and what the cells of the nodes 1 … n hold.
struct Moment {
  Array P, X, H, f, mass, faces;
  double load = 0;
};

/// Linear between the two nodes about X = 0.
double film_at_centre(const Moment& at) {
  const auto right = std::upper_bound(at.X.begin(), at.X.end(), 0.0) - at.X.begin();
  const double part = -at.X[right - 1] / (at.X[right] - at.X[right - 1]);
  return at.H[right - 1] + part * (at.H[right] - at.H[right - 1]);
}

class Contact {
 public:
  Contact(const Problem& problem, int intervals, double inlet)
      : problem_(problem), n_(intervals), inlet_(inlet), kernel_(intervals + 1, intervals + 1) {
    for (int i = 0; i <= n_; ++i)
      for (int j = 0; j <= n_; ++j)
        kernel_(i, j) =
            twice_integrated_log(i - j + 1) - 2 * twice_integrated_log(i - j) + twice_integrated_log(i - j - 1);
  }

  /// y: P_1 … P_(n-1), X*.
  [[nodiscard]] Moment moment(const Eigen::VectorXd& y, double offset) const {
    Moment at;
    const double h = (y[n_ - 1] - inlet_) / n_;
    at.P = Array::Zero(n_ + 1);
    at.P.segment(1, n_ - 1) = y.head(n_ - 1).array();
    at.X = Array::LinSpaced(n_ + 1, inlet_, y[n_ - 1]);
    at.load = h * at.P.sum();
    at.H = offset + at.X.square() / 2 - (h * (kernel_ * at.P.matrix()).array() + h * std::log(h) * at.P.sum()) / pi;
    at.f = evaluate(problem_.density, at.P).value * at.H;
    at.faces = (at.X.head(n_) + at.X.tail(n_)) / 2;
    at.mass = h * at.f.tail(n_);  // the middle of a cell, to second order; the last cell is half as wide
    at.mass[n_ - 1] = h / 2 * (0.75 * at.f[n_] + 0.25 * at.f[n_ - 1]);
    return at;
  }

  /// Change of the masses less what flows in, for face speeds `speed` (the last one that of the exit).
  [[nodiscard]] Eigen::VectorXd balance(const Moment& at, const Array& mass_rate, const Array& speed) const {
    const double h = at.X[1] - at.X[0];
    const Array log_mobility = evaluate(problem_.density, at.P).value.log() + 3 * at.H.log() -
                               evaluate(problem_.viscosity, at.P).value - std::log(problem_.groups.lambda);
    Array inflow(n_ + 1);  // through the faces to the left, and through the exit
    for (int i = 0; i < n_; ++i) {
      const double carried = i == 0 ? (at.f[0] + at.f[1]) / 2 : at.f[i] + (at.f[i + 1] - at.f[i - 1]) / 4;
      const double mobility = std::exp((log_mobility[i] + log_mobility[i + 1]) / 2);
      inflow[i] = carried * (1 - speed[i]) - mobility * (at.P[i + 1] - at.P[i]) / h;
    }
    inflow[n_] = at.f[n_] * (1 - speed[n_]);
    return (mass_rate - inflow.head(n_) + inflow.tail(n_)).matrix();
  }

 private:
  const Problem& problem_;
  int n_;
  double inlet_;
  Eigen::MatrixXd kernel_;
};

/// Newton's method with a matrix of differences, which serves as long as the iteration settles fast.
template <class Residual>
class Root {
 public:
  [[nodiscard]] bool find(Eigen::VectorXd& y, const Residual& residual) {
    for (int k = 0; k < most_iterations; ++k) {
      const Eigen::VectorXd r = residual(y);
      if (!r.allFinite()) return false;
      if (!made_ || k % iterations_a_matrix == iterations_a_matrix - 1) make(y, residual);
      const Eigen::VectorXd step = lu_.solve(r);
      y -= step;
      if (step.cwiseAbs().maxCoeff() < settled) return true;
    }
    return false;
  }

 private:
  void make(const Eigen::VectorXd& y, const Residual& residual) {
    Eigen::MatrixXd J(y.size(), y.size());
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      Eigen::VectorXd more = y, less = y;
      more[j] += small_change, less[j] -= small_change;
      J.col(j) = (residual(more) - residual(less)) / (2 * small_change);
    }
    lu_.compute(J);
    made_ = true;
  }
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  bool made_ = false;
};

}  // namespace

MotionInTime motion_by_time_steps(const Problem& problem, const Fields& start, const TimeSteps& request) {
  using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
  const MotionInTime failed{.kappa = std::numeric_limits<double>::quiet_NaN(),
                            .film = std::numeric_limits<double>::quiet_NaN()};
  const int n = request.intervals;
  const Contact contact(problem, n, start.X[0]);
  const double exit = start.X[start.X.size() - 1];
  Eigen::VectorXd y(n);
  for (int i = 1; i < n; ++i) {
    const double X = start.X[0] + (exit - start.X[0]) * i / n;
    const auto right = std::upper_bound(start.X.begin(), start.X.end(), X) - start.X.begin();
    const double part = (X - start.X[right - 1]) / (start.X[right] - start.X[right - 1]);
    y[i - 1] = start.P[right - 1] + part * (start.P[right] - start.P[right - 1]);
  }
  y[n - 1] = exit;
  const Array rest = Array::Zero(n + 1);
  Residual residual = [&](const Eigen::VectorXd& at) {
    return contact.balance(contact.moment(at, start.offset), rest.head(n), rest);
  };
  if (!Root<Residual>().find(y, residual)) return failed;

  const double step = 2 * pi / (request.Omega * request.steps);
  Moment before = contact.moment(y, start.offset), last = before;
  double offset = start.offset;
  residual = [&](const Eigen::VectorXd& at) {
    const Moment now = contact.moment(at, offset);
    const auto rate = [&](const Array& a, const Array& b, const Array& c) -> Array {
      return (3 * a - 4 * b + c) / (2 * step);
    };
    Array speed(n + 1);
    speed << rate(now.faces, last.faces, before.faces), (3 * now.X[n] - 4 * last.X[n] + before.X[n]) / (2 * step);
    return contact.balance(now, rate(now.mass, last.mass, before.mass), speed);
  };
  Root<Residual> root;
  std::complex<double> load = 0, film = 0;
  double mean_film = 0;
  for (int k = 1; k <= request.periods * request.steps; ++k) {
    const double angle = 2 * pi * k / request.steps;
    offset = start.offset + std::abs(start.offset) * request.amplitude * std::sin(angle);
    if (!root.find(y, residual)) return failed;
    before = last;
    last = contact.moment(y, offset);
    if (k <= (request.periods - 1) * request.steps) continue;
    const double central = film_at_centre(last);
    load += last.load * std::polar(2.0 / request.steps, -angle);
    film += central * std::polar(2.0 / request.steps, -angle);
    mean_film += central / request.steps;
  }
  // H_01 e^(i Omega T) with H_0 = offset + Re(H_01 e^(i Omega T)): sin is -i.
  return {.kappa = -load / (std::complex<double>(0, -1) * std::abs(start.offset) * request.amplitude),
          .film = std::abs(film) / mean_film};
}

}  // namespace ehd::verification::exact
