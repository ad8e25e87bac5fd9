// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/response.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "fast/harmonic.hpp"
#include "fast/judgement.hpp"
#include "fast/mapped_start.hpp"
#include "fast/mapped_ways.hpp"
#include "fast/prolongation.hpp"

namespace ehd::fast {

namespace {

using Clock = std::chrono::steady_clock;

/// Intervals of the finest grid of the steady climb, and of the finest grid of all.
constexpr int first_nodes = 512, largest_nodes = 16384;
/// Error of a number over the residual that GMRES leaves, twice the largest at 40 contacts (M of 0.5..1000, L of 0..20,
/// Omega of 0..10, waves of 0.3..5 b), and the part of the tolerance that GMRES may leave in it.
constexpr double of_kappa = 0.2, of_damping = 60, of_wavy_film = 90, linear_part = 0.1;
/// Numbers of fewer grids have no error estimate.
constexpr std::size_t fewest_grids = 4;
/// Ratios of moves that count as regular (8 for smooth solutions), and the parts of the moves in the error: judged().
/// Where a spike passes between the nodes, moves fall by 2 from grid to grid, not by 8.
constexpr double least_ratio = 5, largest_ratio = 13;
constexpr double of_limit = 2, of_regular_move = 0.5, of_irregular_move = 2.5, of_move_before = 0.5, less_each_move = 2;
constexpr std::size_t moves_back = 4;
/// Above this L, where spikes are narrow, errors are so many times as large. With it the errors that kappa states to
/// 1e-4 hold at 184 of 184 random contacts (M of 0.5..1000, L of 0..20, Omega of 0..10, both law sets, flooded and
/// cut), those of kappa_0 at 197 of 198, of kappa_1 at 161 of 161, of wavy films at 167 of 168, at a median of 33 to
/// 170 times the true ones; 45 of 229 were not known to 1e-4 on 4096 or 8192 intervals, all of them above L = 12.
/// Without it: 191 of 192, 210 of 214, 166 of 169 and 178 of 181, and 37 not known.
constexpr double narrow_spikes_L = 12, of_narrow_spikes = 2.5;
/// What the moving tail of a flooded contact leaves in kappa, relative, over Omega^2 min(1, lambda). Against the
/// reference at (0.5, 2), (1, 4), (2, 15), (8, 6) and 60 random contacts, Omega of 0..100: 1e-9 to 4e-8.
constexpr double tail_error = 6e-8;
/// What it leaves in kappa_1 is as much as in kappa here: 7e-8 was seen.
constexpr double Omega_of_damping = 2;
/// A disturbance e^(i Omega (T - X)) is resolved where Omega times the widest cell of the contact is at most this.
constexpr double largest_phase = 0.4;

struct Judged {
  Complex value;
  double error = std::numeric_limits<double>::infinity();
  StopReason status = StopReason::diverged;
};

/// Of a coarser grid, where there was one.
template <class Scalar>
const StepOf<Scalar>* known(const StepOf<Scalar>& u) {
  return u.P.size() > 0 ? &u : nullptr;
}

/// A number on one grid after the other.
struct Sequence {
  std::vector<Complex> values;
  double iteration = 0;  ///< error that it leaves on the last grid, relative
  double offset = 1;     ///< the tail's error in the number over that in kappa, relative: |H_01| over the number
};

class ResponseSolve {
 public:
  ResponseSolve(const Problem& problem, const ResponseRequest& request, Workspace& workspace)
      : request_(request),
        steady_{.tolerance = {},
                .nodes = first_nodes,
                .max_iterations = request.max_iterations,
                .time_limit_s = request.time_limit_s},
        run_(begin_mapped(problem, steady_, workspace)) {}

  [[nodiscard]] Response solve();

 private:
  [[nodiscard]] bool find_steady();
  [[nodiscard]] bool refine();
  [[nodiscard]] bool spent() const { return run_.limit_reached || run_.limits.time_is_up(); }
  void add_grid(const NodeFields& nodes, double residual);
  [[nodiscard]] Judged judged(const Sequence& sequence, double Omega, double wavenumber) const;
  template <class Next>
  [[nodiscard]] Judged certified(double Omega, double wavenumber, bool refines, const Next& next);
  [[nodiscard]] Judged stiffness(double Omega, bool refines = true);
  [[nodiscard]] Judged wavy_film(const Waviness& waviness);
  [[nodiscard]] SlowStiffness slow();
  /// That GMRES may leave in a number whose error is so many times the residual.
  [[nodiscard]] double residual_for(double amplification) const {
    return linear_part * request_.tolerance / amplification;
  }

  const ResponseRequest& request_;
  const Request steady_;
  Run run_;
  Prolongation prolongation_;
  struct OnGrid {
    std::unique_ptr<Harmonic> harmonic;
    double residual = 0;  ///< that Newton left
  };
  std::vector<OnGrid> grids_;
};

/// Of run_.state, with these fields.
void ResponseSolve::add_grid(const NodeFields& nodes, double residual) {
  grids_.push_back(
      {.harmonic = std::make_unique<Harmonic>(run_.setting, nodes, run_.state, run_.workspace.grids, run_.counters),
       .residual = residual});
  prolongation_.note(run_.state);
}

bool ResponseSolve::find_steady() {
  const MappedClimb climb = best_climb(run_, steady_);
  if (!climb.complete) return false;
  Discretisation at;
  for (std::size_t k = 0; k < climb.states.size(); ++k) {
    run_.state = climb.states[k];
    Grid& grid = run_.workspace.grids.of(climb.grids[k].nodes);
    if (!at.evaluate(run_.setting, run_.state, grid, run_.counters)) return false;
    add_grid(at.nodes, climb.grids[k].residual);
  }
  return true;
}

/// A grid with twice as many intervals.
bool ResponseSolve::refine() {
  const int n = 2 * grids_.back().harmonic->intervals();
  if (n > largest_nodes || spent()) return false;
  const double film = film_now(run_);
  const State last = run_.state;
  run_.state = prolongation_.onto(n, run_.workspace.grids, run_.setting.inlet);
  const Attempt attempt = solve_on(run_, film, {.residual = round_off_residual});
  if (attempt.succeeded) {
    add_grid(run_.workspace.now().nodes, attempt.newton.residual);
  } else {
    run_.state = last;
  }
  return attempt.succeeded;
}

/// f_k on the grids, R_k = (4 f_k - f_(k-1))/3 and S_k = (8 R_k - R_(k-1))/7, since errors fall as h^2 and then h^3;
/// r_k = |R_k - R_(k-1)|. The value is S_m. Its error, where r_(m-1)/r_m and r_(m-2)/r_(m-1) are regular:
/// max(2 |S_m - S_(m-1)|, r_m/2), of four grids r_m instead of its half;
/// else max(|S_m - S_(m-1)|, 2.5 r_m, r_(m-1)/2, r_(m-2)/4, r_(m-3)/8).
Judged ResponseSolve::judged(const Sequence& sequence, double Omega, double wavenumber) const {
  const std::vector<Complex>& f = sequence.values;
  const std::size_t m = f.size();
  Judged found{.value = f.back()};
  if (!std::isfinite(std::abs(found.value))) return found;
  found.status = spent() ? StopReason::limit_reached : StopReason::tolerance_not_met;
  if (m < fewest_grids) return found;
  // From the finest grid backwards: R(0), R(1), ...
  const auto R = [&](std::size_t back) { return (4.0 * f[m - 1 - back] - f[m - 2 - back]) / 3.0; };
  const auto S = [&](std::size_t back) { return (8.0 * R(back) - R(back + 1)) / 7.0; };
  const auto move = [&](std::size_t back) { return std::abs(R(back) - R(back + 1)); };
  const auto regular = [&](std::size_t back) {
    return move(back + 1) >= least_ratio * move(back) && move(back + 1) <= largest_ratio * move(back);
  };
  const double limit = std::abs(S(0) - S(1));
  found.value = S(0);
  if (wavenumber * grids_[m - 1].harmonic->widest_cell() > largest_phase) return found;
  double error = std::max(limit, of_irregular_move * move(0));
  if (regular(0) && (m == fewest_grids || regular(1))) {
    error = std::max(of_limit * limit, (m == fewest_grids ? 1 : of_regular_move) * move(0));
  } else {
    double part = of_move_before;
    for (std::size_t back = 1; back + 3 <= m && back < moves_back; ++back, part /= less_each_move)
      error = std::max(error, part * move(back));
  }
  if (run_.setting.groups.L > narrow_spikes_L) error *= of_narrow_spikes;
  const double tail =
      run_.setting.with_tail ? tail_error * std::min(1.0, run_.setting.groups.lambda) * Omega * Omega : 0;
  found.error = error / std::abs(found.value) + tail * sequence.offset + run_.truncation + sequence.iteration +
                grids_[m - 1].residual;
  if (found.error <= request_.tolerance) found.status = StopReason::converged;
  return found;
}

/// A number on one grid after the other until it is known; next(harmonic, sequence) adds its value there. Finer grids
/// are made where it `refines`.
template <class Next>
Judged ResponseSolve::certified(double Omega, double wavenumber, bool refines, const Next& next) {
  Sequence sequence;
  Judged found;
  for (std::size_t k = 0; k < grids_.size() || (refines && refine()); ++k) {
    next(*grids_[k].harmonic, sequence);
    found = judged(sequence, Omega, wavenumber);
    if (found.status == StopReason::converged || found.status == StopReason::diverged || spent()) break;
  }
  return found;
}

Judged ResponseSolve::stiffness(double Omega, bool refines) {
  StepOf<Complex> u;
  return certified(Omega, Omega, refines, [&](Harmonic& harmonic, Sequence& sequence) {
    auto motion = harmonic.of_load(Complex(0, Omega), residual_for(of_kappa), known(u));
    u = std::move(motion.u);
    sequence.values.push_back(-1.0 / u.offset);
    sequence.iteration = of_kappa * motion.residual;
  });
}

Judged ResponseSolve::wavy_film(const Waviness& waviness) {
  StepOf<Complex> u;
  const double Omega = waviness.Omega();
  return certified(Omega, std::max(Omega, waviness.wavenumber()), true, [&](Harmonic& harmonic, Sequence& sequence) {
    auto motion = harmonic.of_waviness(waviness, residual_for(of_wavy_film), known(u));
    u = std::move(motion.u);
    const auto deflection = harmonic.central_film(waviness, u);
    const Complex film = deflection ? 1.0 + *deflection : Complex(std::numeric_limits<double>::quiet_NaN());
    sequence.values.push_back(film);
    sequence.iteration = of_wavy_film * motion.residual;
    sequence.offset = std::abs(u.offset / film);
  });
}

/// kappa = -1/(u_0 + s u_1) = kappa_0 + s kappa_1.
SlowStiffness ResponseSolve::slow() {
  Step u_0, u_1;
  Sequence stiffness, damping;
  Judged stiff, damped;
  for (std::size_t k = 0; k < grids_.size() || refine(); ++k) {
    Harmonic& harmonic = *grids_[k].harmonic;
    auto at_rest = harmonic.of_load(0.0, residual_for(of_damping), known(u_0));
    u_0 = std::move(at_rest.u);
    auto moving = harmonic.of_slow_load(u_0, residual_for(of_damping), known(u_1));
    u_1 = std::move(moving.u);
    stiffness.values.emplace_back(-1 / u_0.offset);
    stiffness.iteration = of_kappa * at_rest.residual;
    damping.values.emplace_back(u_1.offset / (u_0.offset * u_0.offset));
    damping.iteration = of_damping * std::max(at_rest.residual, moving.residual);
    // Each as it is where it is known first: finer grids may agree by chance where a spike passes between their nodes.
    if (stiff.status != StopReason::converged) stiff = judged(stiffness, 0, 0);
    if (damped.status != StopReason::converged) damped = judged(damping, Omega_of_damping, 0);
    if ((stiff.status == StopReason::converged && damped.status == StopReason::converged) || spent()) break;
  }
  return {
      .kappa_0 = stiff.value.real(), .kappa_1 = damped.value.real(), .error_0 = stiff.error, .error_1 = damped.error};
}

Response ResponseSolve::solve() {
  Response found;
  for (const double Omega : request_.frequencies) found.frequencies.push_back({.Omega = Omega});
  for (const Waviness& waviness : request_.waviness) found.waviness.push_back({.waviness = waviness});
  if (!find_steady()) {
    found.status = spent() ? StopReason::limit_reached : StopReason::diverged;
    found.reason = "the steady state was not found";
    return found;
  }
  found.slow = slow();
  for (Stiffness& at : found.frequencies) {
    const Judged kappa = stiffness(at.Omega);
    at.kappa = kappa.value, at.error = kappa.error, at.status = kappa.status;
  }
  const auto certified = [&](double Omega) { return stiffness(Omega, false).status == StopReason::converged; };
  find_highest_certified(found, request_.tolerance, certified, [&] { return spent(); });
  for (WavinessResponse& at : found.waviness) {
    const Judged film = wavy_film(at.waviness);
    at.film = film.value, at.error = film.error, at.status = film.status;
  }
  conclude(found, request_.tolerance, spent(), "the finest grids differ by more than the tolerance");
  found.cost.nodes = grids_.back().harmonic->intervals();
  found.cost.levels = static_cast<int>(grids_.size());
  found.cost.newton_iterations = run_.counters.newton;
  found.cost.krylov_iterations = run_.counters.krylov;
  found.cost.convolutions = run_.counters.convolutions;
  found.cost.planning_s = run_.workspace.grids.planning_s() - run_.planning_before;
  found.cost.wall_s = std::chrono::duration<double>(Clock::now() - run_.begin).count() - found.cost.planning_s;
  return found;
}

}  // namespace

Response response(const Problem& problem, const ResponseRequest& request, Workspace& workspace) {
  return ResponseSolve(problem, request, workspace).solve();
}

}  // namespace ehd::fast
