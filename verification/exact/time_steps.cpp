// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/time_steps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "contact/lu_factors.hpp"

namespace ehd::verification::exact {

namespace {

using std::numbers::pi;
constexpr double small_change = 1e-6;  // of the differences that make the matrix; Newton's method corrects them
constexpr double settled = 1e-10;      // of the unknowns, against amplitudes of 1e-4
constexpr int iterations_a_matrix = 6;
constexpr int most_iterations = 60;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Int Int of ln|u| twice: hats of width 1 integrate ln|u| to its second difference.
double twice_integrated_log(double u) { return u == 0 ? 0 : u * u / 2 * (std::log(std::abs(u)) - 1.5); }

/// Everything at one time: values at the nodes, and the masses of the cells about the nodes 1 … n.
struct Moment {
  Array P, X, H, f, mass, faces;
  double load = 0;
};

/// The cubic through the four nodes about X = 0: its error is small beside that of second order, which falls regularly
/// with the intervals wherever 0 stands between the nodes.
double film_at_centre(const Moment& at) {
  constexpr Eigen::Index nodes = 4;
  const Eigen::Index first = std::upper_bound(at.X.begin(), at.X.end(), 0.0) - at.X.begin() - nodes / 2;
  double film = 0;
  for (Eigen::Index i = first; i < first + nodes; ++i) {
    double part = at.H[i];
    for (Eigen::Index j = first; j < first + nodes; ++j)
      if (j != i) part *= -at.X[j] / (at.X[i] - at.X[j]);
    film += part;
  }
  return film;
}

/// R(X) = amplitude cos(wavenumber X - phase), added to the gap.
struct Feature {
  double amplitude = 0, wavenumber = 0, phase = 0;
};

class Contact {
 public:
  Contact(const Problem& problem, int intervals, double inlet)
      : problem_(problem), n_(intervals), inlet_(inlet), kernel_(intervals + 1, intervals + 1) {
    for (int i = 0; i <= n_; ++i)
      for (int j = 0; j <= n_; ++j)
        kernel_(i, j) =
            twice_integrated_log(i - j + 1) - 2 * twice_integrated_log(i - j) + twice_integrated_log(i - j - 1);
  }

  /// y: P_1 … P_(n-1), X*, H_0.
  [[nodiscard]] Moment moment(const Eigen::VectorXd& y, const Feature& feature) const {
    Moment at;
    const double h = (y[n_ - 1] - inlet_) / n_;
    at.P = Array::Zero(n_ + 1);
    at.P.segment(1, n_ - 1) = y.head(n_ - 1).array();
    at.X = Array::LinSpaced(n_ + 1, inlet_, y[n_ - 1]);
    at.load = h * at.P.sum();
    at.H = y[n_] + at.X.square() / 2 + feature.amplitude * (feature.wavenumber * at.X - feature.phase).cos() -
           (h * (kernel_ * at.P.matrix()).array() + h * std::log(h) * at.P.sum()) / pi;
    at.f = evaluate(problem_.density, at.P).value * at.H;
    at.faces = (at.X.head(n_) + at.X.tail(n_)) / 2;
    at.mass = h * at.f.tail(n_);  // the middle of a cell, to second order; the last cell is half as wide
    at.mass[n_ - 1] = h / 2 * (0.75 * at.f[n_] + 0.25 * at.f[n_ - 1]);
    return at;
  }

  /// Mass balance of each cell. The last entry of `speed` is the exit's.
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
      if (!lu_ || k % iterations_a_matrix == iterations_a_matrix - 1) make(y, residual);
      const Eigen::VectorXd step = lu_->solve(r);
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
    lu_.emplace(std::move(J));
  }
  std::optional<LuFactors> lu_;
};

/// y of a steady solution, on n equal intervals.
Eigen::VectorXd on_equal_intervals(const Fields& start, int n) {
  const double inlet = start.X[0], exit = start.X[start.X.size() - 1];
  Eigen::VectorXd y(n + 1);
  for (int i = 1; i < n; ++i) {
    const double X = inlet + (exit - inlet) * i / n;
    const auto right = std::upper_bound(start.X.begin(), start.X.end(), X) - start.X.begin();
    const double part = (X - start.X[right - 1]) / (start.X[right] - start.X[right - 1]);
    y[i - 1] = start.P[right - 1] + part * (start.P[right] - start.P[right - 1]);
  }
  y[n - 1] = exit, y[n] = start.offset;
  return y;
}

/// The contact from rest, one step after the other.
class Motion {
 public:
  Motion(const Problem& problem, const Fields& start, int intervals)
      : n_(intervals), contact_(problem, intervals, start.X[0]), y_(on_equal_intervals(start, intervals)) {}

  /// At the offset of the start.
  [[nodiscard]] bool rests() {
    const Array rest = Array::Zero(n_ + 1);
    const double offset = y_[n_];
    const auto residual = [&](const Eigen::VectorXd& at) {
      return with_last(contact_.balance(contact_.moment(at, {}), rest.head(n_), rest), at[n_] - offset);
    };
    if (!Root<decltype(residual)>().find(y_, residual)) return false;
    before_ = now_ = contact_.moment(y_, {});
    load_ = now_.load;
    return true;
  }
  /// H_0 is given.
  [[nodiscard]] bool step_at(double offset, double step) {
    return advance(step, {}, [&](const Eigen::VectorXd& at, const Moment&) { return at[n_] - offset; });
  }
  /// The load is that at rest.
  [[nodiscard]] bool step_over(const Feature& feature, double step) {
    return advance(step, feature, [&](const Eigen::VectorXd&, const Moment& at) { return at.load - load_; });
  }
  [[nodiscard]] const Moment& now() const { return now_; }

 private:
  using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  [[nodiscard]] static Eigen::VectorXd with_last(const Eigen::VectorXd& first, double last) {
    Eigen::VectorXd all(first.size() + 1);
    all << first, last;
    return all;
  }
  /// The last equation is `condition`: a given H_0 or load.
  template <class Condition>
  [[nodiscard]] bool advance(double step, const Feature& feature, const Condition& condition) {
    const Residual residual = [&](const Eigen::VectorXd& at) {
      const Moment next = contact_.moment(at, feature);
      const auto rate = [&](const Array& a, const Array& b, const Array& c) -> Array {
        return (3 * a - 4 * b + c) / (2 * step);
      };
      Array speed(n_ + 1);
      speed << rate(next.faces, now_.faces, before_.faces),
          (3 * next.X[n_] - 4 * now_.X[n_] + before_.X[n_]) / (2 * step);
      return with_last(contact_.balance(next, rate(next.mass, now_.mass, before_.mass), speed), condition(at, next));
    };
    if (!root_.find(y_, residual)) return false;
    before_ = now_;
    now_ = contact_.moment(y_, feature);
    return true;
  }

  int n_;
  Contact contact_;
  Eigen::VectorXd y_;
  Root<Residual> root_;
  Moment before_, now_;
  double load_ = 0;
};

}  // namespace

MotionInTime motion_by_time_steps(const Problem& problem, const Fields& start, const TimeSteps& request) {
  const MotionInTime failed{.kappa = not_known, .film = not_known};
  Motion motion(problem, start, request.intervals);
  if (!motion.rests()) return failed;
  const double step = 2 * pi / (request.Omega * request.steps);
  std::complex<double> load = 0, film = 0;
  double mean_film = 0;
  for (int k = 1; k <= request.periods * request.steps; ++k) {
    const double angle = 2 * pi * k / request.steps;
    if (!motion.step_at(start.offset + std::abs(start.offset) * request.amplitude * std::sin(angle), step))
      return failed;
    if (k <= (request.periods - 1) * request.steps) continue;
    const double central = film_at_centre(motion.now());
    load += motion.now().load * std::polar(2.0 / request.steps, -angle);
    film += central * std::polar(2.0 / request.steps, -angle);
    mean_film += central / request.steps;
  }
  // H_01 e^(i Omega T) with H_0 = offset + Re(H_01 e^(i Omega T)): sin is -i.
  return {.kappa = -load / (std::complex<double>(0, -1) * std::abs(start.offset) * request.amplitude),
          .film = std::abs(film) / mean_film};
}

std::complex<double> film_by_time_steps(const Problem& problem, const Fields& start, const WavinessSteps& request) {
  Motion motion(problem, start, request.intervals);
  if (!motion.rests()) return not_known;
  const double step = 2 * pi / (request.waviness.Omega() * request.steps),
               amplitude = request.amplitude * film_at_centre(motion.now());
  std::complex<double> film = 0;
  for (int k = 1; k <= request.periods * request.steps; ++k) {
    const double angle = 2 * pi * k / request.steps;
    const double grown = k < request.steps ? (1 - std::cos(angle / 2)) / 2 : 1;  // over the first period
    if (!motion.step_over({grown * amplitude, request.waviness.wavenumber(), angle}, step)) return not_known;
    if (k > (request.periods - 1) * request.steps)
      film += film_at_centre(motion.now()) * std::polar(2.0 / request.steps, -angle);
  }
  return film / amplitude;
}

}  // namespace ehd::verification::exact
