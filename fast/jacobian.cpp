// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/jacobian.hpp"

#include <cmath>
#include <numbers>

#include "fast/counters.hpp"
#include "fast/log_mean.hpp"
#include "fast/node_fields.hpp"
#include "fast/vectorise.hpp"

namespace ehd::fast {

using std::numbers::pi;

void Jacobian::linearise(const Setting& setting, const NodeFields& nodes, const Array& P, double exit) {
  n_ = nodes.n;
  grid_ = nodes.grid;
  length = nodes.length;
  density_at_exit = nodes.density.value[n_];
  load_by_exit = nodes.integral;
  for (Array* array : {&p_left, &p_mid, &p_right, &w_left, &w_mid, &w_right, &by_exit}) array->resize(n_);
  linearise_poiseuille(setting, nodes, P);
  linearise_wedge(setting, nodes, P);
  linearise_exit(setting, nodes, exit);
}

/// The part of -eps_i (P_(i+1) - P_i)/(X_(i+1) - X_i), which sets every coefficient. The others add to them.
void Jacobian::linearise_poiseuille(const Setting& setting, const NodeFields& nodes, const Array& P) {
  const int n = n_;
  const double inverse_lambda = 1 / setting.groups.lambda, inverse_length = 1 / length;
  const double fluidity_floor = setting.fluidity_floor;
  const double* const a = nodes.log_viscosity.value.data();
  const double* const slope = nodes.log_viscosity.slope.data();
  const double* const u = nodes.fluidity.data();
  const double* const rho = nodes.density.value.data();
  const double* const drho = nodes.density.slope.data();
  const double* const gap = nodes.H.data();
  const double* const p = P.data();
  const double* const inverse_spacing = grid_->inverse_spacing.data();
  double *const pl = p_left.data(), *const pm = p_mid.data(), *const pr = p_right.data();
  double *const wl = w_left.data(), *const wm = w_mid.data(), *const wr = w_right.data(), *const by_x = by_exit.data();
  EHD_VECTORISE
  for (int i = 0; i < n; ++i) {
    const LogMean m = log_mean_with_slopes(u[i], u[i + 1], a[i + 1] - a[i]);
    const double mean = m.value + fluidity_floor;
    const double Hf = (gap[i] + gap[i + 1]) / 2, rho_f = (rho[i] + rho[i + 1]) / 2;
    const double cube = Hf * Hf * Hf * inverse_lambda, per_length = inverse_spacing[i] * inverse_length;
    const double gradient = (p[i + 1] - p[i]) * per_length;
    const double mobility = rho_f * cube * mean;
    const double by_density = gradient * cube * mean / 2, by_mean = gradient * rho_f * cube;
    const double by_film = 1.5 * gradient * rho_f * Hf * Hf * inverse_lambda * mean;
    pl[i] = 0;
    wl[i] = 0;
    pm[i] = mobility * per_length - by_density * drho[i] - by_mean * m.by_a * slope[i];
    pr[i] = -mobility * per_length - by_density * drho[i + 1] - by_mean * m.by_b * slope[i + 1];
    wm[i] = wr[i] = -by_film;
    by_x[i] = mobility * gradient * inverse_length;
  }
}

/// The part of f_(i+1/2).
void Jacobian::linearise_wedge(const Setting& setting, const NodeFields& nodes, const Array& P) {
  const int n = n_;
  carried_.linearise(setting, nodes, P);
  const double* const rho = carried_.value.data();
  const double* const drho = carried_.by_own.data();
  const double* const gap = nodes.H.data();
  const double* const k = grid_->bias.data();
  double *const pl = p_left.data(), *const pm = p_mid.data(), *const pr = p_right.data();
  double *const wl = w_left.data(), *const wm = w_mid.data(), *const wr = w_right.data();
  pm[0] += 0.5 * gap[0] * drho[0];
  wm[0] += 0.5 * rho[0];
  pr[0] += 0.5 * gap[1] * drho[1];
  wr[0] += 0.5 * rho[1];
  EHD_VECTORISE
  for (int i = 1; i < n; ++i) {
    const double left = -(1 - k[i]) / 4, middle = 1 - k[i] / 2, right = (1 + k[i]) / 4;
    pl[i] = left * gap[i - 1] * drho[i - 1];
    wl[i] = left * rho[i - 1];
    pm[i] += middle * gap[i] * drho[i];
    wm[i] += middle * rho[i];
    pr[i] += right * gap[i + 1] * drho[i + 1];
    wr[i] += right * rho[i + 1];
  }
  p_far_left.resize(0);
  p_far_right.resize(0);
  if (carried_.by_neighbours) add_neighbours(nodes);
}

/// The part of the carried densities that the neighbours of their nodes change. Near the ends there is none.
void Jacobian::add_neighbours(const NodeFields& nodes) {
  const int n = n_;
  const Array &gap = nodes.H, &k = grid_->bias, &by_left = carried_.by_left, &by_right = carried_.by_right;
  p_far_left.setZero(n);
  p_far_right.setZero(n);
  for (int i = 1; i < n; ++i) {
    const double left = -(1 - k[i]) / 4 * gap[i - 1], middle = (1 - k[i] / 2) * gap[i],
                 right = (1 + k[i]) / 4 * gap[i + 1];
    p_far_left[i] = left * by_left[i - 1];
    p_left[i] += middle * by_left[i];
    p_mid[i] += left * by_right[i - 1] + right * by_left[i + 1];
    p_right[i] += middle * by_right[i];
    p_far_right[i] = right * by_right[i + 1];
  }
}

/// The nodes move with the exit, dX_i = phi_i dX*: dH_i = X_i phi_i - (1/pi) d/dl (l K P + l ln l Int P dphi).
void Jacobian::linearise_exit(const Setting& setting, const NodeFields& nodes, double exit) {
  const int n = n_;
  const double inlet = setting.inlet, inverse_length = 1 / length;
  const Array& place = grid_->place;
  film_by_exit = (inlet + length * place) * place - (nodes.deflection * inverse_length + nodes.integral) / pi;
  if (setting.with_tail) {  // the tail's deflection is a function of X
    const auto X = inlet + length * place;
    const auto& t = nodes.tail_deflection;
    film_by_exit += place * (t[1] + X * (2 * t[2] + X * (3 * t[3] + X * 4 * t[4])));
  }
  if (!setting.sources) return;
  const auto& [film, balance, load] = *setting.sources;
  for (int i = 0; i <= n; ++i) film_by_exit[i] += film(inlet + length * place[i]).second * place[i];
  const double at_exit = balance(exit).second;
  for (int i = 0; i < n; ++i) {
    const double middle = (place[i] + place[i + 1]) / 2;
    by_exit[i] += balance(inlet + length * middle).second * middle - at_exit;
  }
}

template <class Scalar>
ChangeOf<Scalar>& Jacobian::change_film(StepOf<Scalar>& step, Counters& counters, Accuracy accuracy) const {
  const int n = n_;
  const Stage before = counters.clock.change_to(Stage::product);
  grid_->product(step.P, step.product, step.integral, accuracy);
  counters.clock.change_to(before);
  for (int part = 0; part < parts_of<Scalar>; ++part) counters.count_product(n);
  const Scalar constant = step.offset - length * std::log(length) * step.integral / pi;
  const double scale = length / pi;
  auto& change = std::get<ChangeOf<Scalar>>(change_);
  change.film.resize(n + 1);
  change.film = constant + film_by_exit * step.exit - scale * step.product;
  return change;
}

template <class Scalar>
void Jacobian::change_residual(const StepOf<Scalar>& step, ChangeOf<Scalar>& change) const {
  const int n = n_;
  const Scalar* const dP = step.P.data();
  const Scalar* const dH = change.film.data();
  const Scalar exit_change = density_at_exit * dH[n], dX = step.exit;
  change.flux.resize(n);
  Scalar* const out = change.flux.data();
  const double *const pl = p_left.data(), *const pm = p_mid.data(), *const pr = p_right.data();
  const double *const wl = w_left.data(), *const wm = w_mid.data(), *const wr = w_right.data();
  const double* const by_x = by_exit.data();
  out[0] = pm[0] * dP[0] + pr[0] * dP[1] + wm[0] * dH[0] + wr[0] * dH[1] + by_x[0] * dX - exit_change;
  for (int i = 1; i < n; ++i) {
    out[i] = pl[i] * dP[i - 1] + pm[i] * dP[i] + pr[i] * dP[i + 1] + wl[i] * dH[i - 1] + wm[i] * dH[i] +
             wr[i] * dH[i + 1] + by_x[i] * dX - exit_change;
  }
  if (p_far_left.size() > 0) {
    for (int i = 2; i + 2 <= n; ++i) out[i] += p_far_left[i] * dP[i - 2] + p_far_right[i] * dP[i + 2];
  }
  change.load = length * step.integral + load_by_exit * step.exit;
}

const Residual& Jacobian::apply(Step& step, Counters& counters) const {
  auto& change = change_film(step, counters, Accuracy::full);
  change_residual(step, change);
  return change;
}

template ChangeOf<double>& Jacobian::change_film(Step&, Counters&, Accuracy) const;
template ChangeOf<Complex>& Jacobian::change_film(StepOf<Complex>&, Counters&, Accuracy) const;
template void Jacobian::change_residual(const Step&, ChangeOf<double>&) const;
template void Jacobian::change_residual(const StepOf<Complex>&, ChangeOf<Complex>&) const;

}  // namespace ehd::fast
