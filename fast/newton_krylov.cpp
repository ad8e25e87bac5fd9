// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/newton_krylov.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fast/workspace.hpp"

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// The residual counts as met at this multiple of its rounding floor.
constexpr double rounding_floors = 8;
/// An end without the target counts as stalled below this residual, as failed above.
constexpr double stalled_below = 1e-3;
/// The tail is refreshed once the residual is below this, at most so many times.
constexpr double tail_refreshed_below = 1e-3;
constexpr int most_tail_refreshes = 20;
/// GMRES reduces the residual to this share of the distance to the target, within these bounds (relative residual).
constexpr double krylov_share = 0.5, tightest_krylov = 0.1, loosest_krylov = 0.5;
/// A step changes the pressure at most by this share of half its maximum, or of 1 where that is more, and the exit at
/// most by this share of X* + 0.2. (Barus' spike stands at 10 p_H.) Where a spike moves, one node changes by the
/// spike's whole height; a smaller bound would hold all nodes back. Newton steps at 300 flooded contacts (M of
/// 0.5..2000, L to 30), tolerance 1e-5: 0.5, 1 and 1.5 take 1.06, 1.02 and 1; 0.05 and 0.2 for the exit take 1.02 and
/// 1.
constexpr double largest_pressure_change = 1.5, largest_exit_change = 0.2, exit_margin = 0.2;
/// A step leaves at least this share of the film at every node.
constexpr double smallest_film_left = 0.2;
/// A step leaves the exit to the right of this part of X_a.
constexpr double leftmost_exit = 0.5;
/// A step is halved at most so many times before Newton gives up.
constexpr int most_halvings = 12;
/// A step may raise the norm by this factor: while a spike moves, its faces err more at every other step. Newton steps
/// of 11 contacts to 1e-4: from a neighbour's solution 320, from nothing 355; with 1 in its place 336 and 348.
constexpr double largest_growth = 1.5;
/// A step is poor where it leaves more than this share of the norm; so many poor steps in a row end Newton. Of 144
/// contacts of M = 2e4..7e5 and L = 15..80, 4 do not reach 1e-4; with 15 in its place 5.
constexpr double poor_contraction = 0.9;
constexpr int most_poor_steps = 25;
/// The multigrid cycle is factorised again where the conductances H^3/eta have changed by this: the sum over the steps
/// of the largest change of ln eta and three times that of ln H. Instructions of 40 contacts (M of 0.5..1000, L to 15
/// or 20), over those with 0 in its place: films to 1e-5 .94, to 1e-4 .95, H_cen to 1e-6 .88; with 0.1 .945, .96, .89;
/// with 0.4 .93, .94, .88.
constexpr double refactorised_at = 0.2;
/// With a contraction above this the film error is unknown.
constexpr double useful_contraction = 0.5;
/// Film error left after a step, over contraction x last change. At 200 problems (M of 1..1000, L of 0..20, two law
/// sets, flooded and -4, uniform grids of 4096), stopped by this estimate at half the expected discretisation error: it
/// covers the true iteration error in 90 %, half of that error in 96 %. At most 0.73 of the true discretisation error
/// was left, 0.14 in 95 %.
constexpr double film_error_factor = 5;

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The norm of GMRES and the line search: rms of the flux errors in units of the oil, and the relative load error.
struct Norm {
  const Array& oil;
  double per_root_n, load_scale;
  explicit Norm(const Discretisation& at)
      : oil(at.oil), per_root_n(1 / std::sqrt(static_cast<double>(at.nodes.n))), load_scale(2 / pi) {}
  [[nodiscard]] double of(const Residual& error) const {
    return std::hypot((error.flux / oil).matrix().norm() * per_root_n, error.load * load_scale);
  }
};

double residual_of(const Discretisation& at) { return std::max(at.residual(), std::abs(at.error.load) * 2 / pi); }

/// The film error that a step leaves in H_min and H_cen.
double film_error_left(const NodeFields& before, const NodeFields& after, double inlet, double contraction) {
  if (!(contraction < useful_contraction)) return unknown;
  const Eigen::Index centre = after.centre(inlet);
  const double minimum = after.H.minCoeff() / before.H.minCoeff(), central = after.H[centre] / before.H[centre];
  return film_error_factor * contraction * std::max(std::abs(minimum - 1), std::abs(central - 1));
}

/// The largest change of the conductances, as `refactorised_at` counts it.
double change_of_conductances(const NodeFields& before, const NodeFields& after) {
  return (after.log_viscosity.value - before.log_viscosity.value).abs().maxCoeff() +
         3 * (after.H / before.H - 1).abs().maxCoeff();
}

/// The share of a step that keeps pressure and exit within their bounds. A step is scaled as a whole, never clipped
/// node by node.
double longest(const Step& step, const State& state) {
  double length = 1;
  const double largest = step.P.abs().maxCoeff();
  const double largest_allowed = largest_pressure_change * std::max(1.0, state.P.maxCoeff() / 2);
  if (largest > largest_allowed) length = std::min(length, largest_allowed / largest);
  const double largest_exit = largest_exit_change * (state.exit + exit_margin);
  if (std::abs(step.exit) > largest_exit) length = std::min(length, largest_exit / std::abs(step.exit));
  return length;
}

class Newton {
 public:
  Newton(const Setting& setting, State& state, const Target& target, Workspace& workspace, Counters& counters)
      : setting_(setting),
        state_(state),
        target_(target),
        workspace_(workspace),
        counters_(counters),
        grid_(workspace.grids.of(static_cast<int>(state.P.size()) - 1)),
        w_(workspace.on(grid_.n)) {
    workspace.current = &w_;
  }

  NewtonResult operator()(int most_iterations, const Limits& limits) {
    if (!w_.now.evaluate(setting_, state_, grid_, counters_)) return result_;
    for (;; ++result_.iterations) {
      result_.residual = residual_of(w_.now);
      if (!refresh_tail() || !renew_product()) return result_;
      if (done()) return ended(NewtonEnd::converged);
      if (counters_.newton >= limits.newton_iterations || limits.time_is_up()) return ended(NewtonEnd::limit);
      if (result_.iterations >= most_iterations || poor_steps_ >= most_poor_steps) return given_up();
      ++counters_.newton;
      if (!find_step()) return result_;
      if (!search_along_step()) return given_up();
    }
  }

 private:
  [[nodiscard]] bool done() const {
    const bool small = result_.residual <= std::max(target_.residual, rounding_floors * w_.now.rounding) ||
                       (result_.film_error < target_.film_error && result_.residual <= target_.film_residual);
    return small && w_.now.flux_variation() <=
                        std::max(target_.flux_variation, rounding_floors * w_.now.rounding_of_flux_variation());
  }
  NewtonResult ended(NewtonEnd end) {
    result_.end = end;
    return result_;
  }
  NewtonResult given_up() { return ended(result_.residual < stalled_below ? NewtonEnd::stalled : NewtonEnd::failed); }

  /// The tail beyond a flooded inlet, made new from the present fields. A tail changes the film by a few per cent at
  /// most, so a tail as exact as the target leaves less error than the residual does. False where no film is left.
  bool refresh_tail() {
    if (!setting_.with_tail || tail_refreshes_ >= most_tail_refreshes) return true;
    if (!(result_.residual <= tail_refreshed_below || done())) return true;
    const InletTail fresh = w_.now.tail_of(setting_, state_);
    const double enough = std::max(target_.residual, target_.film_error);
    if (!(std::abs(fresh.pressure - state_.tail.pressure) > enough * fresh.pressure)) return true;
    ++tail_refreshes_;
    norm_before_refresh_ = Norm(w_.now).of(w_.now.error);
    state_.tail = fresh;
    if (!w_.now.evaluate_with_product(setting_, state_, grid_, counters_)) return false;
    result_.residual = residual_of(w_.now);
    result_.film_error = unknown;
    return true;
  }

  /// Rounding errors of products that were added up from steps grow. So a solve to round-off is judged by a new
  /// product. False where no film is left.
  bool renew_product() {
    if (!product_is_a_sum_ || target_.film_error != 0 || !done()) return true;
    product_is_a_sum_ = false;
    if (!w_.now.evaluate(setting_, state_, grid_, counters_)) return false;
    result_.residual = residual_of(w_.now);
    return true;
  }

  /// w_.step = -J^-1 e, by GMRES. False where it cannot be found.
  bool find_step() {
    {
      const InStage stage(counters_, Stage::linearise);
      w_.jacobian.linearise(setting_, w_.now.nodes, state_.P, state_.exit);
    }
    if (!(changed_since_factors_ <= refactorised_at)) {
      if (!workspace_.multigrid.prepare(setting_, w_.now.nodes, w_.jacobian, state_, workspace_.grids, counters_))
        return false;
      changed_since_factors_ = 0;
    }
    const double to_film_target =
        std::min(target_.film_error / result_.film_error, target_.film_residual / result_.residual);
    const double to_target = std::max(target_.residual / result_.residual, to_film_target);
    solve_linear(std::clamp(to_target * krylov_share, tightest_krylov, loosest_krylov));
    const Step& step = w_.step;
    return step.P.allFinite() && std::isfinite(step.offset) && std::isfinite(step.exit);
  }

  /// J step = -e to the relative residual `relative`, in the scaling of Norm.
  void solve_linear(double relative) {
    const InStage stage(counters_, Stage::krylov);
    const Norm norm(w_.now);
    const Residual& error = w_.now.error;
    const Eigen::Index n = grid_.n;
    w_.right_side.resize(n + 1);
    w_.right_side.head(n) = -error.flux / norm.oil * norm.per_root_n;
    w_.right_side[n] = -error.load * norm.load_scale;
    w_.preconditioned.resize(Gmres::most_steps);
    const auto product = [&](std::size_t k, const Array& v, Array& Jz) {
      Step& z = w_.preconditioned[k];
      w_.unscaled.flux = v.head(n) * norm.oil / norm.per_root_n;
      w_.unscaled.load = v[n] / norm.load_scale;
      workspace_.multigrid.cycle(w_.unscaled, z, counters_);
      const Residual& change = w_.jacobian.apply(z, counters_);
      ++counters_.krylov;
      Jz.resize(n + 1);
      Jz.head(n) = change.flux / norm.oil * norm.per_root_n;
      Jz[n] = change.load * norm.load_scale;
    };
    const auto y = w_.gmres.solve(w_.right_side, relative, product);
    Step& step = w_.step;
    step.P.setZero(n + 1);
    step.product.setZero(n + 1);
    step.offset = step.exit = step.integral = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const Step& z = w_.preconditioned[k];
      step.P += y[k] * z.P;
      step.product += y[k] * z.product;
      step.integral += y[k] * z.integral;
      step.offset += y[k] * z.offset;
      step.exit += y[k] * z.exit;
    }
  }

  /// The longest share of the step, by halving, that raises the norm by largest_growth at most. False where there is
  /// none.
  bool search_along_step() {
    const Norm norm(w_.now);
    const double before = norm.of(w_.now.error);
    double length = longest(w_.step, state_);
    for (int halving = 0; halving < most_halvings; ++halving, length /= 2) {
      if (!try_step(length)) continue;
      const double after = norm.of(w_.trial.error);
      if (!(after < largest_growth * before)) continue;
      poor_steps_ = after > poor_contraction * before ? poor_steps_ + 1 : 0;
      const double contraction = after / std::min(before, norm_before_refresh_);
      result_.film_error = film_error_left(w_.now.nodes, w_.trial.nodes, setting_.inlet, contraction);
      changed_since_factors_ += change_of_conductances(w_.now.nodes, w_.trial.nodes);
      norm_before_refresh_ = unknown;
      product_is_a_sum_ = true;
      std::swap(w_.now, w_.trial);
      std::swap(state_, w_.candidate);
      return true;
    }
    return false;
  }

  /// w_.trial: the fields after this share of the step. The product is linear in P, so a trial costs no FFT. False
  /// where the exit or the film goes too far.
  bool try_step(double length) {
    const Step& step = w_.step;
    State& candidate = w_.candidate;
    candidate.tail = state_.tail;
    candidate.P = state_.P + length * step.P;
    candidate.offset = state_.offset + length * step.offset;
    candidate.exit = state_.exit + length * step.exit;
    if (candidate.exit <= leftmost_exit * setting_.inlet) return false;
    NodeFields& trial = w_.trial.nodes;
    trial.product = w_.now.nodes.product + length * step.product;
    trial.product_integral = w_.now.nodes.product_integral + length * step.integral;
    if (!w_.trial.evaluate_with_product(setting_, candidate, grid_, counters_)) return false;
    return !(trial.H < smallest_film_left * w_.now.nodes.H).any();
  }

  const Setting& setting_;
  State& state_;
  const Target& target_;
  Workspace& workspace_;
  Counters& counters_;
  Grid& grid_;
  Workspace::OnGrid& w_;
  NewtonResult result_;
  int poor_steps_ = 0, tail_refreshes_ = 0;
  bool product_is_a_sum_ = false;           ///< K P of the state was added up from steps
  double changed_since_factors_ = unknown;  ///< the conductances, since the multigrid cycle was factorised
  double norm_before_refresh_ = unknown;    ///< a fresh tail raises the norm, on the far faces alone
};

}  // namespace

NewtonResult newton(const Setting& setting, State& state, const Target& target, int most_iterations,
                    const Limits& limits, Workspace& workspace, Counters& counters) {
  const Stage before = counters.clock.change_to(Stage::grids);
  Newton run(setting, state, target, workspace, counters);
  counters.clock.change_to(before);
  return run(most_iterations, limits);
}

}  // namespace ehd::fast
