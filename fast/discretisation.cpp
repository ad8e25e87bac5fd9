// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/discretisation.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// Logarithmic mean of u and v = e^-a, e^-b and its derivatives to a and b; d = b - a.
struct LogMean {
  double value, by_a, by_b;
};

inline double log_mean(double u, double v, double d) {
  // Below 0.03 the quotient cancels: series about the geometric mean, next term d^6/322560.
  const double quotient = (u - v) / d;
  const double series = std::sqrt(u * v) * (1 + d * d * (1.0 / 24 + d * d / 1920));
  return std::abs(d) < 0.03 ? series : quotient;
}

inline LogMean log_mean_with_slopes(double u, double v, double d) {
  if (std::abs(d) < 0.03) {
    const double mid = std::sqrt(u * v), even = d * d;
    const double m = 1 + even * (1.0 / 24 + even / 1920);
    const double odd = d * (1.0 / 12 + even / 480);
    return {mid * m, mid * (-0.5 * m - odd), mid * (-0.5 * m + odd)};
  }
  const double m = (u - v) / d;
  return {m, (m - u) / d, (v - m) / d};
}

}  // namespace

bool Discretisation::evaluate(const Setting& setting, State& state, Convolution& kernel, Counters& counters) {
  n = static_cast<int>(state.P.size()) - 1;
  h = (state.exit - setting.inlet) / n;
  Array& P = state.P;
  P[n] = 0;

  // Film by the pressure on the grid; the first node's own half hat comes with the tail.
  const InletTail& tail = state.tail;
  P[0] = 0;
  const double log_h = std::log(h);
  kernel.apply(P, deflection);
  ++counters.convolutions;
  counters.convolution_points += n;
  double sum = P.head(n).sum();
  deflection = h * deflection + h * log_h * sum;
  H.resize(n + 1);
  const double x0 = setting.inlet, by_pi = 1 / pi;
  if (setting.with_tail) {
    P[0] = tail.pressure;
    sum += P[0] / 2;
    for (int i = 0; i <= n; ++i) deflection[i] += h * P[0] * (kernel.inner_half_weight(i) + log_h / 2);
  }
  for (int i = 0; i <= n; ++i) {
    const double X = x0 + i * h;
    H[i] = state.offset + X * X / 2 - by_pi * deflection[i];
  }
  if (setting.with_tail) {
    const double* const t = tail.deflection;
    for (int i = 0; i <= n; ++i) {
      const double X = x0 + i * h;
      H[i] += t[0] + X * (t[1] + X * (t[2] + X * (t[3] + X * t[4])));
    }
  }
  load_error = h * sum + tail.load - pi / 2;
  if (setting.sources) {
    for (int i = 0; i <= n; ++i) H[i] += setting.sources->film(x0 + i * h).first;
    load_error -= pi / 2 * setting.sources->load;
  }
  if (!(H.minCoeff() > 0) || !H.allFinite()) return false;

  ehd::evaluate(setting.viscosity, P, log_viscosity);
  ehd::evaluate(setting.density, P, density);
  if (is_trivial(setting.viscosity)) {
    fluidity.setOnes(n + 1);
  } else {
    fluidity = (-log_viscosity.value).exp();
    counters.viscosity_points += n + 1;
  }
  if (!is_trivial(setting.density)) counters.density_points += n + 1;

  // Faces.
  eps.resize(n);
  flux.resize(n);
  e.resize(n);
  const double by_lambda = 1 / setting.groups.lambda, by_h = 1 / h;
  const double* const a = log_viscosity.value.data();
  const double* const u = fluidity.data();
  const double* const rho = density.value.data();
  const double* const gap = H.data();
  const double* const p = P.data();
  for (int i = 0; i < n; ++i) {
    const double m = log_mean(u[i], u[i + 1], a[i + 1] - a[i]) + setting.fluidity_floor;
    const double Hf = (gap[i] + gap[i + 1]) / 2;
    eps[i] = (rho[i] + rho[i + 1]) / 2 * Hf * Hf * Hf * m * by_lambda;
  }
  flux[0] = (rho[0] * gap[0] + rho[1] * gap[1]) / 2 - eps[0] * (p[1] - p[0]) * by_h;
  for (int i = 1; i < n; ++i) {
    const double wedge = rho[i] * gap[i] + (rho[i + 1] * gap[i + 1] - rho[i - 1] * gap[i - 1]) / 4;
    flux[i] = wedge - eps[i] * (p[i + 1] - p[i]) * by_h;
  }
  e = flux - exit_flux();
  if (setting.sources) {
    const auto& balance = setting.sources->balance;
    const double at_exit = balance(state.exit).first;
    for (int i = 0; i < n; ++i) e[i] += balance(x0 + (i + 0.5) * h).first - at_exit;
  }
  if (!e.allFinite()) return false;
  floor = std::numeric_limits<double>::epsilon() *
          (eps * P.head(n).max(P.tail(n)) * by_h + (density.value * H).head(n)).maxCoeff() / exit_flux();
  return true;
}

InletTail Discretisation::tail_of(const Setting& setting, const State& state) const {
  if (!setting.with_tail) return {};
  const double far = -setting.inlet;
  const double moment = h * (state.P * Array::LinSpaced(n + 1, setting.inlet, state.exit)).sum();
  return inlet_tail(far, H[0] - far * far / 2, moment, exit_flux(), setting.groups.lambda,
                    ambient_slope(setting.viscosity));
}

void Discretisation::inject(const Discretisation& fine, const Array& fine_pressure, Array& pressure,
                            const Setting& setting, double exit) {
  n = (fine.n + 1) / 2;
  h = (exit - setting.inlet) / n;
  const bool nested = fine.n % 2 == 0;
  const auto take = [&](const Array& from, Array& to) {
    to.resize(n + 1);
    if (nested) {
      to = from(Eigen::seqN(0, n + 1, 2));
    } else {
      const double ratio = static_cast<double>(fine.n) / n;
      for (int i = 0; i <= n; ++i) {
        const int left = std::min(static_cast<int>(i * ratio), fine.n - 1);
        const double share = i * ratio - left;
        to[i] = (1 - share) * from[left] + share * from[left + 1];
      }
    }
  };
  take(fine_pressure, pressure);
  take(fine.H, H);
  take(fine.deflection, deflection);
  take(fine.log_viscosity.value, log_viscosity.value);
  take(fine.log_viscosity.slope, log_viscosity.slope);
  take(fine.density.value, density.value);
  take(fine.density.slope, density.slope);
  take(fine.fluidity, fluidity);
}

void Discretisation::linearise(const Setting& setting, const Array& P, double exit) {
  for (Array* array : {&p_left, &p_mid, &p_right, &w_left, &w_mid, &w_right, &by_exit}) array->resize(n);
  const double by_lambda = 1 / setting.groups.lambda, by_h = 1 / h, length = exit - setting.inlet;
  const double* const a = log_viscosity.value.data();
  const double* const slope = log_viscosity.slope.data();
  const double* const u = fluidity.data();
  const double* const rho = density.value.data();
  const double* const drho = density.slope.data();
  const double* const gap = H.data();
  const double* const p = P.data();
  const double inlet = setting.inlet;
  for (int i = 0; i < n; ++i) {
    LogMean m = log_mean_with_slopes(u[i], u[i + 1], a[i + 1] - a[i]);
    m.value += setting.fluidity_floor;
    const double Hf = (gap[i] + gap[i + 1]) / 2, rho_f = (rho[i] + rho[i + 1]) / 2;
    const double cube = Hf * Hf * Hf * by_lambda, gradient = (p[i + 1] - p[i]) * by_h;
    const double mobility = rho_f * cube * m.value;
    // Poiseuille part: -eps (P_(i+1) - P_i)/h.
    const double by_density = gradient * cube * m.value / 2, by_mean = gradient * rho_f * cube;
    const double by_film = 1.5 * gradient * rho_f * Hf * Hf * by_lambda * m.value;
    p_mid[i] = mobility * by_h - by_density * drho[i] - by_mean * m.by_a * slope[i];
    p_right[i] = -mobility * by_h - by_density * drho[i + 1] - by_mean * m.by_b * slope[i + 1];
    w_mid[i] = w_right[i] = -by_film;
    by_exit[i] = mobility * gradient / length;
    // Wedge.
    const int left = i > 0 ? i - 1 : 0;
    const double c_left = i > 0 ? -0.25 : 0.0, c_mid = i > 0 ? 1.0 : 0.5, c_right = i > 0 ? 0.25 : 0.5;
    p_left[i] = c_left * gap[left] * drho[left];
    w_left[i] = c_left * rho[left];
    p_mid[i] += c_mid * gap[i] * drho[i];
    w_mid[i] += c_mid * rho[i];
    p_right[i] += c_right * gap[i + 1] * drho[i + 1];
    w_right[i] += c_right * rho[i + 1];
  }
  // dX_i = s_i dX*; dH_i = X_i s_i - (1/pi) d/dX*( h g*P + h ln h Sum P ), h proportional to the length.
  film_by_exit.resize(n + 1);
  const double sum = P.head(n).sum() - P[0] / 2;
  load_by_exit = h * sum / length;
  for (int i = 0; i <= n; ++i) {
    const double s = static_cast<double>(i) / n, X = inlet + i * h;
    film_by_exit[i] = X * s - (deflection[i] + h * sum) / (pi * length);
  }
  if (setting.sources) {
    const auto& [film, balance, load] = *setting.sources;
    for (int i = 0; i <= n; ++i) film_by_exit[i] += film(inlet + i * h).second * i / n;
    const double at_exit = balance(exit).second;
    for (int i = 0; i < n; ++i) by_exit[i] += balance(inlet + (i + 0.5) * h).second * (i + 0.5) / n - at_exit;
  }
}

void Discretisation::apply(const Step& step, Convolution& kernel, Counters& counters, Array& change,
                           double& load_change) const {
  kernel.apply(step.P, product_);
  ++counters.convolutions;
  counters.convolution_points += n;
  const double sum = step.P.head(n).sum();
  const double constant = step.offset - h * std::log(h) * sum / pi, scale = h / pi;
  film_change_.resize(n + 1);
  const double* const dP = step.P.data();
  double* const dH = film_change_.data();
  for (int i = 0; i <= n; ++i) dH[i] = constant + film_by_exit[i] * step.exit - scale * product_[i];
  const double exit_change = density.value[n] * dH[n];
  change.resize(n);
  change[0] = p_mid[0] * dP[0] + p_right[0] * dP[1] + w_mid[0] * dH[0] + w_right[0] * dH[1] +
              by_exit[0] * step.exit - exit_change;
  for (int i = 1; i < n; ++i) {
    change[i] = p_left[i] * dP[i - 1] + p_mid[i] * dP[i] + p_right[i] * dP[i + 1] + w_left[i] * dH[i - 1] +
                w_mid[i] * dH[i] + w_right[i] * dH[i + 1] + by_exit[i] * step.exit - exit_change;
  }
  load_change = h * sum + load_by_exit * step.exit;
}

}  // namespace ehd::fast
