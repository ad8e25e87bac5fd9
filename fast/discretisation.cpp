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
  const double quotient = (u - v) / d, by_d = 1 / d;
  const double mid = std::sqrt(u * v), even = d * d;
  const double m = 1 + even * (1.0 / 24 + even / 1920), odd = d * (1.0 / 12 + even / 480);
  const bool near = std::abs(d) < 0.03;
  return {near ? mid * m : quotient, near ? mid * (-0.5 * m - odd) : (quotient - u) * by_d,
          near ? mid * (-0.5 * m + odd) : (v - quotient) * by_d};
}

}  // namespace

bool Discretisation::evaluate(const Setting& setting, State& state, Grid& on, Counters& counters) {
  {
    const InStage stage(counters, Stage::product);
    on.product(state.P, product, product_integral);
  }
  ++counters.convolutions;
  counters.convolution_points += on.n;
  return evaluate_with_product(setting, state, on, counters);
}

bool Discretisation::evaluate_with_product(const Setting& setting, State& state, Grid& on, Counters& counters) {
  const InStage stage(counters, Stage::residual);
  n = on.n;
  grid = &on;
  length = state.exit - setting.inlet;
  Array& P = state.P;
  P[n] = 0;

  // Film by the pressure on the grid; the first node's own half comes with the tail.
  const InletTail& tail = state.tail;
  P[0] = setting.with_tail ? tail.pressure : 0;
  deflection = product;
  integral = product_integral;
  if (setting.with_tail) {
    deflection += P[0] * on.first_column();
    integral += P[0] * on.first_weight;
  }
  deflection = length * (deflection + std::log(length) * integral);
  H.resize(n + 1);
  const double x0 = setting.inlet, by_pi = 1 / pi;
  const double* const place = on.place.data();
  if (setting.with_tail) {
    const double* const t = tail.deflection;
    std::copy_n(t, 5, tail_);
    for (int i = 0; i <= n; ++i) {
      const double X = x0 + length * place[i];
      H[i] = state.offset + X * X / 2 - by_pi * deflection[i] + (t[0] + X * (t[1] + X * (t[2] + X * (t[3] + X * t[4]))));
    }
  } else {
    for (int i = 0; i <= n; ++i) {
      const double X = x0 + length * place[i];
      H[i] = state.offset + X * X / 2 - by_pi * deflection[i];
    }
  }
  load_error = length * integral + tail.load - pi / 2;
  if (setting.sources) {
    for (int i = 0; i <= n; ++i) H[i] += setting.sources->film(x0 + length * place[i]).first;
    load_error -= pi / 2 * setting.sources->load;
  }
  if (!(H.minCoeff() > 0) || !H.allFinite()) return false;

  counters.clock.change_to(Stage::laws);
  ehd::evaluate(setting.viscosity, P, log_viscosity);
  ehd::evaluate(setting.density, P, density);
  if (is_trivial(setting.viscosity)) {
    fluidity.setOnes(n + 1);
  } else {
    fluidity = (-log_viscosity.value).exp();
    counters.viscosity_points += n + 1;
  }
  if (!is_trivial(setting.density)) counters.density_points += n + 1;

  counters.clock.change_to(Stage::residual);

  // Faces.
  eps.resize(n);
  flux.resize(n);
  e.resize(n);
  const double by_lambda = 1 / setting.groups.lambda, by_length = 1 / length;
  const double* const a = log_viscosity.value.data();
  const double* const u = fluidity.data();
  const double* const rho = density.value.data();
  const double* const gap = H.data();
  const double* const p = P.data();
  const double* const by_spacing = on.by_spacing.data();
  const double* const k = on.bias.data();
  double* const mobility = eps.data();
  double* const through = flux.data();
  for (int i = 0; i < n; ++i) {
    const double m = log_mean(u[i], u[i + 1], a[i + 1] - a[i]) + setting.fluidity_floor;
    const double Hf = (gap[i] + gap[i + 1]) / 2;
    mobility[i] = (rho[i] + rho[i + 1]) / 2 * Hf * Hf * Hf * m * by_lambda;
  }
  through[0] = (rho[0] * gap[0] + rho[1] * gap[1]) / 2 - mobility[0] * (p[1] - p[0]) * by_spacing[0] * by_length;
  for (int i = 1; i < n; ++i) {
    const double here = rho[i] * gap[i];
    const double wedge =
        here + ((1 + k[i]) * (rho[i + 1] * gap[i + 1] - here) + (1 - k[i]) * (here - rho[i - 1] * gap[i - 1])) / 4;
    through[i] = wedge - mobility[i] * (p[i + 1] - p[i]) * by_spacing[i] * by_length;
  }
  e = flux - exit_flux();
  if (setting.sources) {
    const auto& balance = setting.sources->balance;
    const double at_exit = balance(state.exit).first;
    for (int i = 0; i < n; ++i) e[i] += balance(x0 + length * (place[i] + place[i + 1]) / 2).first - at_exit;
  }
  if (!e.allFinite()) return false;
  floor = std::numeric_limits<double>::epsilon() *
          (eps * P.head(n).max(P.tail(n)) * on.by_spacing * by_length + (density.value * H).head(n)).maxCoeff() / exit_flux();
  return true;
}

InletTail Discretisation::tail_of(const Setting& setting, const State& state) const {
  if (!setting.with_tail) return {};
  const double far = -setting.inlet;
  const double moment = length / n * (state.P * grid->slope * places(setting.inlet)).sum();
  return inlet_tail(far, H[0] - far * far / 2, moment, exit_flux(), setting.groups.lambda,
                    ambient_slope(setting.viscosity));
}

void Discretisation::inject(const Discretisation& fine, const Array& fine_pressure, Array& pressure, const Grid& on) {
  n = on.n;
  grid = &on;
  length = fine.length;
  integral = fine.integral;
  std::copy_n(fine.tail_, 5, tail_);
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
  const double by_lambda = 1 / setting.groups.lambda, by_length = 1 / length, floor_of_fluidity = setting.fluidity_floor;
  const double* const a = log_viscosity.value.data();
  const double* const slope = log_viscosity.slope.data();
  const double* const u = fluidity.data();
  const double* const rho = density.value.data();
  const double* const drho = density.slope.data();
  const double* const gap = H.data();
  const double* const p = P.data();
  const double* const by_spacing = grid->by_spacing.data();
  const double* const k = grid->bias.data();
  double *const pl = p_left.data(), *const pm = p_mid.data(), *const pr = p_right.data();
  double *const wl = w_left.data(), *const wm = w_mid.data(), *const wr = w_right.data(), *const by_x = by_exit.data();
  // Poiseuille part: -eps (P_(i+1) - P_i)/(X_(i+1) - X_i).
  for (int i = 0; i < n; ++i) {
    const LogMean m = log_mean_with_slopes(u[i], u[i + 1], a[i + 1] - a[i]);
    const double mean = m.value + floor_of_fluidity;
    const double Hf = (gap[i] + gap[i + 1]) / 2, rho_f = (rho[i] + rho[i + 1]) / 2;
    const double cube = Hf * Hf * Hf * by_lambda, per_length = by_spacing[i] * by_length;
    const double gradient = (p[i + 1] - p[i]) * per_length;
    const double mobility = rho_f * cube * mean;
    const double by_density = gradient * cube * mean / 2, by_mean = gradient * rho_f * cube;
    const double by_film = 1.5 * gradient * rho_f * Hf * Hf * by_lambda * mean;
    pl[i] = 0;
    wl[i] = 0;
    pm[i] = mobility * per_length - by_density * drho[i] - by_mean * m.by_a * slope[i];
    pr[i] = -mobility * per_length - by_density * drho[i + 1] - by_mean * m.by_b * slope[i + 1];
    wm[i] = wr[i] = -by_film;
    by_x[i] = mobility * gradient * by_length;
  }
  // Wedge.
  pm[0] += 0.5 * gap[0] * drho[0];
  wm[0] += 0.5 * rho[0];
  pr[0] += 0.5 * gap[1] * drho[1];
  wr[0] += 0.5 * rho[1];
  for (int i = 1; i < n; ++i) {
    const double left = -(1 - k[i]) / 4, middle = 1 - k[i] / 2, right = (1 + k[i]) / 4;
    pl[i] = left * gap[i - 1] * drho[i - 1];
    wl[i] = left * rho[i - 1];
    pm[i] += middle * gap[i] * drho[i];
    wm[i] += middle * rho[i];
    pr[i] += right * gap[i + 1] * drho[i + 1];
    wr[i] += right * rho[i + 1];
  }
  // dX_i = phi_i dX*; dH_i = X_i phi_i - (1/pi) d/dl (l K P + l ln l Int P dphi).
  load_by_exit = integral;
  const double inlet = setting.inlet;
  film_by_exit = (inlet + length * grid->place) * grid->place - (deflection * by_length + integral) / pi;
  if (setting.with_tail) {  // the tail's own deflection is a function of X
    const auto X = inlet + length * grid->place;
    film_by_exit += grid->place * (tail_[1] + X * (2 * tail_[2] + X * (3 * tail_[3] + X * 4 * tail_[4])));
  }
  if (setting.sources) {
    const auto& [film, balance, load] = *setting.sources;
    const Array& place = grid->place;
    for (int i = 0; i <= n; ++i) film_by_exit[i] += film(inlet + length * place[i]).second * place[i];
    const double at_exit = balance(exit).second;
    for (int i = 0; i < n; ++i) {
      const double middle = (place[i] + place[i + 1]) / 2;
      by_exit[i] += balance(inlet + length * middle).second * middle - at_exit;
    }
  }
}

void Discretisation::apply(Step& step, Grid& on, Counters& counters, Array& change, double& load_change) const {
  const Stage before = counters.clock.change_to(Stage::product);
  on.product(step.P, step.product, step.integral);
  counters.clock.change_to(before);
  ++counters.convolutions;
  counters.convolution_points += n;
  const double constant = step.offset - length * std::log(length) * step.integral / pi, scale = length / pi;
  film_change_.resize(n + 1);
  film_change_ = constant + film_by_exit * step.exit - scale * step.product;
  const double* const dP = step.P.data();
  const double* const dH = film_change_.data();
  const double exit_change = density.value[n] * dH[n], dX = step.exit;
  change.resize(n);
  double* const out = change.data();
  const double *const pl = p_left.data(), *const pm = p_mid.data(), *const pr = p_right.data();
  const double *const wl = w_left.data(), *const wm = w_mid.data(), *const wr = w_right.data(), *const bx = by_exit.data();
  out[0] = pm[0] * dP[0] + pr[0] * dP[1] + wm[0] * dH[0] + wr[0] * dH[1] + bx[0] * dX - exit_change;
  for (int i = 1; i < n; ++i) {
    out[i] = pl[i] * dP[i - 1] + pm[i] * dP[i] + pr[i] * dP[i + 1] + wl[i] * dH[i - 1] + wm[i] * dH[i] +
             wr[i] * dH[i + 1] + bx[i] * dX - exit_change;
  }
  load_change = length * step.integral + load_by_exit * step.exit;
}

}  // namespace ehd::fast
