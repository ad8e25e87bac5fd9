// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fast/counters.hpp"

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// Fixed-point steps between the tail's pressure and the film, which contains the tail's part. Each reduces the error
/// by the tail's share of the load, at most 0.01.
constexpr int tail_turns = 2;
/// The largest number of GMRES restarts. Each is needed for rounding alone: the residual that GMRES updates drifts
/// from the true one, so that a run reduces the true one by about 1e-2.
constexpr int most_restarts = 4;
/// A restart that leaves more than this share is the last.
constexpr double useful_restart = 0.5;
/// Residual, relative to its drive, that the contact's answer to moved nodes may leave. With 0.1 the shift m was up to
/// 1 % off beside spikes narrower than a cell, and moves from grid to grid were irregular: at (20, 20) from 8192
/// intervals on.
constexpr double rough_answer = 0.01;
/// Half width of a central difference: the derivative of (J - s Q) u by s at s = 0. Q depends on s by the tail alone.
constexpr double rate_step = 1e-2;

/// Interpolates from a grid with half as many intervals; cubic in the index, to which the map is smooth.
template <class Scalar>
StepOf<Scalar> finer(const StepOf<Scalar>& coarse, Eigen::Index n) {
  const ArrayOf<Scalar>& P = coarse.P;
  const Eigen::Index m = P.size() - 1;
  StepOf<Scalar> fine{.P = ArrayOf<Scalar>::Zero(n + 1), .offset = coarse.offset, .exit = coarse.exit};
  if (2 * m != n) return fine;
  for (Eigen::Index i = 0; i < m; ++i) {
    fine.P[2 * i] = P[i];
    const bool inside = i > 0 && i + 2 <= m;
    fine.P[2 * i + 1] = inside ? (9.0 * (P[i] + P[i + 1]) - P[i - 1] - P[i + 2]) / 16.0 : (P[i] + P[i + 1]) / 2.0;
  }
  return fine;
}

template <class Scalar>
void add(StepOf<Scalar>& sum, const Scalar& y, const StepOf<Scalar>& step) {
  sum.P += y * step.P;
  sum.offset += y * step.offset;
  sum.exit += y * step.exit;
}

}  // namespace

Harmonic::Harmonic(const Setting& setting, const NodeFields& nodes, const State& state, Grids& grids,
                   Counters& counters)
    : setting_(setting),
      nodes_(nodes),
      state_(state),
      grids_(grids),
      counters_(counters),
      X_(nodes.places(setting.inlet)),
      flux_scale_(1 / (nodes.exit_flux() * std::sqrt(static_cast<double>(nodes.n)))) {
  jacobian_.linearise(setting_, nodes_, state_.P, state_.exit);
  squeeze_.linearise(nodes_);
  if (!setting_.with_tail) return;
  const int n = nodes_.n;
  const double length = nodes_.length, far = -setting_.inlet;
  Grid& grid = *nodes_.grid;
  moment_ = length / n * grid.slope * X_;
  moment_by_exit_ = (state_.P * grid.slope * (X_ + length * grid.place)).sum() / n;
  tail_.emplace(far, nodes_.H[0] - far * far / 2, (moment_ * state_.P).sum(), nodes_.exit_flux(),
                setting_.groups.lambda, ambient_slope(setting_.viscosity));
  load_by_first_ = length * grid.first_weight;
  film_by_tail_.resize(n + 1, 6);
  film_by_tail_.col(0) = -length / pi * (grid.first_column() + std::log(length) * grid.first_weight);
  film_by_tail_.col(1).setOnes();
  for (int k = 2; k < 6; ++k) film_by_tail_.col(k) = film_by_tail_.col(k - 1).array() * X_;
}

/// The tail's answer to the film and the pressure of a change. Its own film and load become part of the change.
template <class Scalar>
void Harmonic::answer_of_tail(Scalar rate, StepOf<Scalar>& u, ChangeOf<Scalar>& change,
                              const Beyond<Scalar>& beyond) const {
  const Scalar load = jacobian_.length * u.integral + jacobian_.load_by_exit * u.exit + beyond.load;
  u.P[0] = Scalar(0);
  const Scalar moment = (moment_ * u.P).sum() + moment_by_exit_ * u.exit + beyond.moment;
  MovingTail::Answer<Scalar> tail = MovingTail::Answer<Scalar>::Zero();
  for (int turn = 0; turn < tail_turns; ++turn) {
    const Scalar flux = jacobian_.density_at_exit * change.film[nodes_.n] +
                        rate * (squeeze_.inflow(u, change.film) + beyond.inflow) + beyond.flux;
    const auto before = tail;
    tail = tail_->answer(rate, MovingTail::Drive<Scalar>{change.film[0], load + tail[0] + load_by_first_ * tail[1],
                                                         moment, flux}) +
           beyond.own;
    change.film.matrix() += film_by_tail_ * (tail - before).template tail<6>();
    u.P[0] = tail[1];
  }
  change.load = load + tail[0] + load_by_first_ * tail[1];
}

template <class Scalar>
ChangeOf<Scalar>& Harmonic::change_by(Scalar rate, StepOf<Scalar>& u) {
  auto& change = jacobian_.change_film(u, counters_, Accuracy::full);
  if (tail_) {
    answer_of_tail(rate, u, change);
    const Scalar load = change.load;
    jacobian_.change_residual(u, change);
    change.load = load;
  } else {
    jacobian_.change_residual(u, change);
  }
  squeeze_.subtract(rate, u, change);
  return change;
}

/// (J - s Q) u + m (R_m - s q) where nodes follow the spike, else (J - s Q) u.
template <class Scalar>
const ChangeOf<Scalar>& Harmonic::change_by(Scalar rate, Motion<Scalar>& motion) {
  ChangeOf<Scalar>& change = change_by(rate, motion.u);
  if (const auto& by_m = std::get<SolverOf<Scalar>>(solvers_).by_m) {
    change.flux += motion.m * by_m->flux;
    change.load += motion.m * by_m->load;
    change.film += motion.m * by_m->film;
  }
  return change;
}

/// The norm of Newton's method.
double Harmonic::norm(const auto& residual) const {
  return std::hypot(residual.flux.matrix().norm() * flux_scale_, std::abs(residual.load) * 2 / pi);
}

template <class Scalar>
bool Harmonic::factorised(Scalar rate) {
  auto& solver = std::get<SolverOf<Scalar>>(solvers_);
  if (!std::exchange(solver.prepared, true))
    solver.multigrid.prepare_motion(setting_, nodes_, jacobian_, squeeze_, state_, grids_, counters_);
  if (solver.factorised == rate) return true;
  solver.factorised.reset();
  solver.by_m.reset();
  if (!solver.multigrid.factorise(rate, counters_)) return false;
  solver.factorised = rate;
  return true;
}

/// Lets the nodes follow the spike from here on, at the rate of the factors; they stay where `moved` is null. GMRES
/// solves for the contact's answer to moved nodes and starts from the one at the rate before. Where that is exact
/// enough, GMRES makes no step.
template <class Scalar>
void Harmonic::let_nodes_follow(Scalar rate, const MovedNodes* moved) {
  auto& solver = std::get<SolverOf<Scalar>>(solvers_);
  if (moved && solver.by_m) return;
  solver.by_m.reset();
  if (!moved) return;
  ChangeOf<Scalar> by_m = by_moved_nodes(rate, *moved);
  Motion<Scalar> answer{.u = {.P = ArrayOf<Scalar>::Zero(nodes_.n + 1)}};
  ResidualOf<Scalar> left{.flux = -by_m.flux, .load = -by_m.load};
  if (auto before = answer_before<Scalar>()) {
    const auto& change = change_by(rate, *before);
    const ResidualOf<Scalar> left_by_it{.flux = left.flux - change.flux, .load = left.load - change.load};
    const double residual = norm(left_by_it) / norm(left);
    if (residual < answer.residual) {
      answer = {.u = std::move(*before), .residual = residual};
      left = left_by_it;
    }
  }
  if (answer.residual > rough_answer) correct(rate, left, rough_answer / answer.residual, answer);
  solver.answer = std::move(answer.u);
  solver.by_m = std::move(by_m);
}

/// The contact's answer to moved nodes at the rate before, else at rest.
template <class Scalar>
std::optional<StepOf<Scalar>> Harmonic::answer_before() const {
  const StepOf<Scalar>& own = std::get<SolverOf<Scalar>>(solvers_).answer;
  if (own.P.size() > 0) return own;
  const Step& at_rest = std::get<SolverOf<double>>(solvers_).answer;
  if (at_rest.P.size() == 0) return std::nullopt;
  return StepOf<Scalar>{
      .P = at_rest.P.template cast<Scalar>(), .offset = Scalar(at_rest.offset), .exit = Scalar(at_rest.exit)};
}

/// Moves the nodes until nothing is left under the spike.
template <class Scalar>
void Harmonic::take_spike_out(Motion<Scalar>& motion) const {
  const auto& solver = std::get<SolverOf<Scalar>>(solvers_);
  if (!solver.by_m) return;
  const Scalar m = shift_with_spike(motion.u.P, solver.answer.P);
  add(motion.u, m, solver.answer);
  motion.m += m;
}

/// Adds to the motion what GMRES finds for (J - s Q) du + dm (R_m - s q) = left. The preconditioner takes the spike out
/// of every step, so that m needs no equation of its own.
template <class Scalar>
void Harmonic::correct(Scalar rate, const ResidualOf<Scalar>& left, double relative, Motion<Scalar>& motion) {
  const InStage stage(counters_, Stage::krylov);
  auto& solver = std::get<SolverOf<Scalar>>(solvers_);
  const Eigen::Index n = nodes_.n;
  const double load_scale = 2 / pi;
  solver.preconditioned.resize(Gmres::most_steps);
  solver.right_side.resize(n + 1);
  solver.right_side.head(n) = left.flux * flux_scale_;
  solver.right_side[n] = left.load * load_scale;
  const auto y =
      solver.gmres.solve(solver.right_side, relative, [&](std::size_t k, const ArrayOf<Scalar>& v, ArrayOf<Scalar>& w) {
        Motion<Scalar>& z = solver.preconditioned[k];
        solver.unscaled.flux = v.head(n) / flux_scale_;
        solver.unscaled.load = v[n] / load_scale;
        solver.multigrid.cycle(solver.unscaled, z.u, counters_);
        z.m = Scalar(0);
        take_spike_out(z);
        const auto& change = change_by(rate, z);
        ++counters_.krylov;
        w.resize(n + 1);
        w.head(n) = change.flux * flux_scale_;
        w[n] = change.load * load_scale;
      });
  for (std::size_t k = 0; k < y.size(); ++k) {
    const Motion<Scalar>& z = solver.preconditioned[k];
    add(motion.u, y[k], z.u);
    motion.m += y[k] * z.m;
  }
}

template <class Scalar>
Harmonic::Motion<Scalar> Harmonic::solved(Scalar rate, const ResidualOf<Scalar>& drive, double residual,
                                          const MovedNodes* moved, const Motion<Scalar>* coarser) {
  const Eigen::Index n = nodes_.n;
  const Motion<Scalar> nothing{.u = {.P = ArrayOf<Scalar>::Zero(n + 1)}};
  Motion<Scalar> found = nothing;
  if (!factorised(rate)) return found;
  let_nodes_follow(rate, moved);
  const double size = norm(drive);
  ResidualOf<Scalar> left = drive;
  const auto refresh = [&](Motion<Scalar>& motion) {
    const auto& change = change_by(rate, motion);
    left.flux = drive.flux - change.flux;
    left.load = drive.load - change.load;
    return norm(left) / size;
  };
  if (coarser) {
    found.u = finer(coarser->u, n);
    found.m = coarser->m;
    take_spike_out(found);
    found.residual = refresh(found);
    if (!(found.residual < 1)) {
      found = nothing;
      left = drive;
    }
  }
  for (int restart = 0; restart < most_restarts && found.residual > residual; ++restart) {
    const double before = found.residual;
    correct(rate, left, residual / before, found);
    found.residual = refresh(found);
    if (!(found.residual < useful_restart * before)) break;
  }
  return found;
}

template <class Scalar>
Harmonic::Motion<Scalar> Harmonic::of_load(Scalar rate, double residual, const MovedNodes* moved,
                                           const Motion<Scalar>* coarser) {
  return solved(rate, ResidualOf<Scalar>{.flux = ArrayOf<Scalar>::Zero(nodes_.n), .load = Scalar(1)}, residual, moved,
                coarser);
}

Harmonic::Motion<double> Harmonic::of_slow_load(const Motion<double>& rest, double residual, const MovedNodes* moved,
                                                const Motion<double>* coarser) {
  Step at_rest = rest.u;
  const auto at_rate = [&](double rate) {
    Residual change = product(rate, at_rest);
    if (!moved) return change;
    const ChangeOf<double> by_m = by_moved_nodes(rate, *moved);
    change.flux += rest.m * by_m.flux;
    change.load += rest.m * by_m.load;
    return change;
  };
  const Residual ahead = at_rate(rate_step), behind = at_rate(-rate_step);
  const Residual by_rate{.flux = -(ahead.flux - behind.flux) / (2 * rate_step),
                         .load = -(ahead.load - behind.load) / (2 * rate_step)};
  return solved(0.0, by_rate, residual, moved, coarser);
}

/// What nodes that move by 1 change in the film and in the residual. The tail answers, too.
template <class Scalar>
ChangeOf<Scalar> Harmonic::by_moved_nodes(Scalar rate, const MovedNodes& moved) {
  StepOf<Scalar> tail{.P = ArrayOf<Scalar>::Zero(nodes_.n + 1)};
  ChangeOf<Scalar> change, by_tail;
  change.load = moved.error.load;
  change.film = moved.film;
  if (tail_)
    answer_of_tail(
        rate, tail, change,
        Beyond<Scalar>{.load = moved.error.load, .moment = Scalar(moved.moment), .inflow = Scalar(moved.inflow)});
  by_tail.film = change.film - moved.film;
  jacobian_.change_residual(tail, by_tail);
  change.flux = moved.error.flux + by_tail.flux - rate * moved.squeeze;
  squeeze_.subtract(rate, tail, change);
  return change;
}

ArrayOf<Complex> Harmonic::feature(const Waviness& waviness) const {
  return (Complex(0, -waviness.wavenumber()) * X_.cast<Complex>()).exp();
}

Harmonic::Motion<Complex> Harmonic::of_sources(Complex rate, const Sources& sources, double residual,
                                               const MovedNodes* moved, const Motion<Complex>* coarser) {
  StepOf<Complex> tail{.P = ArrayOf<Complex>::Zero(nodes_.n + 1)};
  ChangeOf<Complex> change;
  change.film = ArrayOf<Complex>::Zero(nodes_.n + 1);
  if (tail_) answer_of_tail(rate, tail, change, sources.beyond);
  const Complex load = change.load;
  change.film += sources.feature;
  jacobian_.change_residual(tail, change);
  squeeze_.subtract(rate, tail, change);
  const ResidualOf<Complex> drive{.flux = sources.flux - change.flux, .load = sources.load - load};
  Motion<Complex> found = solved(rate, drive, residual, moved, coarser);
  found.driving_film = std::move(change.film);
  return found;
}

/// The part of F_1 that does not depend on x: rho_n R(X*) + i Omega Int rho R dX - S R(X_a). The integral of R is known
/// in closed form. That of (rho - 1) R is a sum over the nodes.
Harmonic::Beyond<Complex> Harmonic::beyond(const Waviness& waviness, const ArrayOf<Complex>& feature) const {
  if (!tail_) return {};
  const Array denser = nodes_.length / nodes_.n * nodes_.grid->slope * (nodes_.density.value - 1);
  return {.flux = (jacobian_.density_at_exit - waviness.slip) * feature[nodes_.n] +
                  Complex(0, waviness.Omega()) * (denser * feature).sum(),
          .own = tail_->answer(waviness)};
}

Harmonic::Motion<Complex> Harmonic::of_waviness(const Waviness& waviness, double residual, const MovedNodes* moved,
                                                const Motion<Complex>* coarser) {
  const ArrayOf<Complex> R = feature(waviness);
  return of_sources(Complex(0, waviness.Omega()),
                    {.feature = R, .flux = ArrayOf<Complex>::Zero(nodes_.n), .beyond = beyond(waviness, R)}, residual,
                    moved, coarser);
}

/// At X = 0, of the film H_1 at nodes that move by X_1: by the cubic through the four nodes about it.
Complex Harmonic::at_centre(const ArrayOf<Complex>& H_1, const ArrayOf<Complex>& X_1) const {
  const auto right = std::upper_bound(X_.begin(), X_.end(), 0.0) - X_.begin();
  const Eigen::Index first = std::clamp<Eigen::Index>(right - 2, 0, nodes_.n - 3);
  Complex film = 0, moved = 0;
  double slope = 0;
  for (Eigen::Index j = first; j < first + 4; ++j) {
    double basis = 1, basis_slope = 0;
    for (Eigen::Index k = first; k < first + 4; ++k) {
      if (k == j) continue;
      basis_slope = (basis_slope * -X_[k] + basis) / (X_[j] - X_[k]);
      basis *= -X_[k] / (X_[j] - X_[k]);
    }
    film += basis * H_1[j];
    moved += basis * X_1[j];
    slope += basis_slope * nodes_.H[j];
  }
  return film - slope * moved;
}

std::optional<Complex> Harmonic::central_film(const Waviness& waviness, Motion<Complex>& motion,
                                              const MovedNodes* moved) {
  if (state_.exit <= 0) return std::nullopt;
  const ArrayOf<Complex> H_1 = change_by(Complex(0, waviness.Omega()), motion).film + motion.driving_film;
  ArrayOf<Complex> X_1 = nodes_.grid->place * motion.u.exit;
  if (moved) X_1 += motion.m * nodes_.length * moved->place;
  return at_centre(H_1, X_1) - 1.0;
}

double Harmonic::widest_cell() const {
  const Array cells = X_.tail(nodes_.n) - X_.head(nodes_.n);
  double widest = 0;
  for (Eigen::Index i = 0; i < nodes_.n; ++i)
    if (X_[i + 1] > -1) widest = std::max(widest, cells[i]);
  return widest;
}

template Harmonic::Motion<double> Harmonic::of_load(double, double, const MovedNodes*, const Motion<double>*);
template Harmonic::Motion<Complex> Harmonic::of_load(Complex, double, const MovedNodes*, const Motion<Complex>*);
template ChangeOf<double>& Harmonic::change_by(double, Step&);
template ChangeOf<Complex>& Harmonic::change_by(Complex, StepOf<Complex>&);

}  // namespace ehd::fast
