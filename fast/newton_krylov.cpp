// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/newton_krylov.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// The norm that GMRES and the line search work in: rms of the relative flux error, and the relative load error.
struct Norm {
  double by_flux, by_load;
  explicit Norm(const Discretisation& at)
      : by_flux(1 / (at.exit_flux() * std::sqrt(static_cast<double>(at.n)))), by_load(2 / pi) {}
  [[nodiscard]] double of(const Discretisation& at) const {
    return std::hypot(at.e.matrix().norm() * by_flux, at.load_error * by_load);
  }
};

double residual_of(const Discretisation& at) {
  return std::max(at.residual(), std::abs(at.load_error) * 2 / pi);
}

constexpr int most_krylov = 40;

/// Flexible GMRES for J step = -(e, load) to the relative residual `relative`.
void solve_linear(Workspace& workspace, Workspace::OnGrid& w, Grid& grid, const Norm& norm, double relative,
                  Counters& counters) {
  const InStage stage(counters, Stage::krylov);
  const Discretisation& at = w.now;
  const Eigen::Index n = at.n;
  w.basis.resize(most_krylov + 1);
  w.preconditioned.resize(most_krylov);
  Eigen::Matrix<double, most_krylov + 1, most_krylov> hessenberg;  // filled up to the column in work
  std::array<double, most_krylov + 1> right{};
  std::array<double, most_krylov> cosines, sines, y;

  Array& first = w.basis[0];
  first.resize(n + 1);
  first.head(n) = -at.e * norm.by_flux;
  first[n] = -at.load_error * norm.by_load;
  const double size = first.matrix().norm();
  right[0] = size;
  first /= size;
  std::size_t k = 0;
  while (k < most_krylov) {
    Step& z = w.preconditioned[k];
    const Array& v = w.basis[k];
    w.flux_error = v.head(n) / norm.by_flux;
    workspace.multigrid.cycle(w.flux_error, v[n] / norm.by_load, z, counters);
    double load_change = 0;
    at.apply(z, grid, counters, w.product, load_change);
    ++counters.krylov;
    Array& next = w.basis[k + 1];
    next.resize(n + 1);
    next.head(n) = w.product * norm.by_flux;
    next[n] = load_change * norm.by_load;
    const auto column = static_cast<Eigen::Index>(k);
    for (std::size_t i = 0; i <= k; ++i) {
      const Array& b = w.basis[i];
      const double share = b.matrix().dot(next.matrix());
      hessenberg(static_cast<Eigen::Index>(i), column) = share;
      next -= share * b;
    }
    const double beside = next.matrix().norm();
    if (beside > 0) next /= beside;
    for (std::size_t i = 0; i < k; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const double a = hessenberg(row, column), b = hessenberg(row + 1, column);
      hessenberg(row, column) = cosines[i] * a + sines[i] * b;
      hessenberg(row + 1, column) = -sines[i] * a + cosines[i] * b;
    }
    const double length = std::hypot(hessenberg(column, column), beside);
    cosines[k] = hessenberg(column, column) / length;
    sines[k] = beside / length;
    hessenberg(column, column) = length;
    right[k + 1] = -sines[k] * right[k];
    right[k] *= cosines[k];
    ++k;
    if (!(std::abs(right[k]) > relative * size)) break;
  }
  for (std::size_t i = k; i-- > 0;) {
    double rest = right[i];
    for (std::size_t j = i + 1; j < k; ++j)
      rest -= hessenberg(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * y[j];
    y[i] = rest / hessenberg(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
  }
  Step& step = w.step;
  step.P.setZero(n + 1);
  step.product.setZero(n + 1);
  step.offset = step.exit = step.integral = 0;
  for (std::size_t i = 0; i < k; ++i) {
    const Step& z = w.preconditioned[i];
    step.P += y[i] * z.P;
    step.product += y[i] * z.product;
    step.integral += y[i] * z.integral;
    step.offset += y[i] * z.offset;
    step.exit += y[i] * z.exit;
  }
}

constexpr double unknown = std::numeric_limits<double>::infinity();

/// What a step leaves in H_min and H_cen: the same share of the larger change that it leaves of the residual, times 5.
/// At 200 problems (M of 1..1000, L of 0..20, two law sets, flooded and -4, uniform grids of 4096), stopped by it at half
/// the expected discretisation error: covers the true iteration error in 90 %, half of it in 96 %; at most 0.73 of the
/// true discretisation error was left, 0.14 in 95 %.
double film_error_left(const Discretisation& before, const Discretisation& after, double inlet, double residual_before,
                       double residual_after) {
  const double contraction = residual_after / residual_before;
  if (!(contraction < 0.5)) return unknown;
  const Eigen::Index centre = after.centre(inlet);
  const double minimum = after.H.minCoeff() / before.H.minCoeff(), central = after.H[centre] / before.H[centre];
  return 5 * contraction * std::max(std::abs(minimum - 1), std::abs(central - 1));
}

}  // namespace

Workspace::OnGrid& Workspace::on(int intervals) {
  for (const auto& one : grids_seen_) {
    if (one->n == intervals) return *one;
  }
  grids_seen_.push_back(std::make_unique<OnGrid>());
  grids_seen_.back()->n = intervals;
  return *grids_seen_.back();
}

NewtonResult newton(const Setting& setting, State& state, const Target& target, int most_iterations, const Limits& limits,
                    Workspace& workspace, Counters& counters) {
  NewtonResult result;
  const int n = static_cast<int>(state.P.size()) - 1;
  const Stage stage_before = counters.clock.change_to(Stage::grids);
  Grid& grid = workspace.grids.of(n);
  counters.clock.change_to(stage_before);
  Workspace::OnGrid& w = workspace.on(n);
  workspace.current = &w;
  if (!w.now.evaluate(setting, state, grid, counters)) return result;
  Step& step = w.step;
  int poor_steps = 0, refreshes = 0;
  bool carried = false;
  double before_refresh = unknown;  // of the norm: a fresh tail raises it on the far faces alone
  for (;; ++result.iterations) {
    result.residual = residual_of(w.now);
    const auto done = [&] {
      return result.residual <= std::max(target.residual, 8 * w.now.floor) ||
             (result.film_error < target.film_error && result.residual <= target.film_residual);
    };
    if (setting.with_tail && (result.residual <= 1e-3 || done()) && refreshes < 20) {
      // What the tail does to the film is a few per cent at the most, so this leaves less than the residual does.
      const InletTail fresh = w.now.tail_of(setting, state);
      const double enough = std::max(target.residual, target.film_error);
      if (std::abs(fresh.pressure - state.tail.pressure) > enough * fresh.pressure) {
        ++refreshes;
        before_refresh = Norm(w.now).of(w.now);
        state.tail = fresh;
        if (!w.now.evaluate_with_product(setting, state, grid, counters)) return result;
        result.residual = residual_of(w.now);
        result.film_error = unknown;
      }
    }
    if (carried && target.film_error == 0 && done()) {
      // Rounding of carried products adds up: round-off is judged by a product of its own.
      carried = false;
      if (!w.now.evaluate(setting, state, grid, counters)) return result;
      result.residual = residual_of(w.now);
    }
    if (done()) {
      result.end = NewtonEnd::converged;
      return result;
    }
    if (counters.newton >= limits.newton_iterations || limits.time_is_up()) {
      result.end = NewtonEnd::limit;
      return result;
    }
    if (result.iterations >= most_iterations || poor_steps >= 15) {
      result.end = result.residual < 1e-3 ? NewtonEnd::stalled : NewtonEnd::failed;
      return result;
    }
    ++counters.newton;
    {
      const InStage stage(counters, Stage::linearise);
      w.now.linearise(setting, state.P, state.exit);
    }
    if (!workspace.multigrid.prepare(setting, w.now, state, workspace.grids, counters)) return result;
    const Norm norm(w.now);
    const double before = norm.of(w.now);
    const double asked = std::max(target.residual / result.residual, target.film_error / result.film_error);
    solve_linear(workspace, w, grid, norm, std::clamp(asked / 2, 0.1, 0.5), counters);
    if (!step.P.allFinite() || !std::isfinite(step.offset) || !std::isfinite(step.exit)) return result;

    // The whole step is scaled, never clipped node by node.
    double length = 1;
    const double largest = step.P.abs().maxCoeff();
    const double largest_allowed = 0.5 * std::max(1.0, state.P.maxCoeff() / 2);  // Barus' spike stands at 10 p_H
    if (largest > largest_allowed) length = std::min(length, largest_allowed / largest);
    const double largest_exit = 0.05 * (state.exit + 0.2);
    if (std::abs(step.exit) > largest_exit) length = std::min(length, largest_exit / std::abs(step.exit));
    bool accepted = false;
    for (int halving = 0; halving < 12 && !accepted; ++halving, length /= 2) {
      w.candidate.tail = state.tail;
      w.candidate.P = state.P + length * step.P;
      w.candidate.offset = state.offset + length * step.offset;
      w.candidate.exit = state.exit + length * step.exit;
      if (w.candidate.exit <= setting.inlet / 2) continue;
      w.trial.product = w.now.product + length * step.product;  // linear in P: a trial costs no FFT
      w.trial.product_integral = w.now.product_integral + length * step.integral;
      if (!w.trial.evaluate_with_product(setting, w.candidate, grid, counters)) continue;
      if ((w.trial.H < 0.2 * w.now.H).any()) continue;
      const double after = norm.of(w.trial);
      if (!(after < before)) continue;
      accepted = true;
      poor_steps = after > 0.9 * before ? poor_steps + 1 : 0;
      result.film_error = film_error_left(w.now, w.trial, setting.inlet, std::min(before, before_refresh), after);
      before_refresh = unknown;
    }
    if (!accepted) {
      result.end = result.residual < 1e-3 ? NewtonEnd::stalled : NewtonEnd::failed;
      return result;
    }
    carried = true;
    std::swap(w.now, w.trial);
    std::swap(state, w.candidate);
  }
}

}  // namespace ehd::fast
