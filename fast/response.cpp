// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/response.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "fast/harmonic_grids.hpp"

namespace ehd::fast {

namespace {

using Clock = std::chrono::steady_clock;

/// Intervals of the finest grid of the steady climb, and of the finest grid of all.
constexpr int first_nodes = 256, largest_nodes = 16384;
/// Above narrow_spikes_L and narrow_spikes_M a narrow spike passes between the nodes. A number then moves with the
/// spike's place in its cell, over one period a cell: by 4e-3 of itself at (8, 22), on 256 and on 8192 intervals, but
/// by 1e-6 at (195, 16). So it is averaged over maps whose spikes stand so many cells of the coarsest grid away from
/// that of the first; in cells of finer grids that is twice, four times, ... as much, evenly spread as well. Two maps
/// show how far a number moves; all five are taken where two do not know it. Below M = 1 it moves by 4e-5 at most.
constexpr double narrow_spikes_L = 12, narrow_spikes_M = 1;
/// kappa of heavy contacts moves from this L on, what is left of a wave does not. With kappa on one map up to L = 12,
/// 13 of 1344 errors at 192 contacts (M of 10..1000, L of 8..12.4) were up to three times as large as stated, also with
/// of_irregular = 3; with this, 1 of 1343.
constexpr double heavy_M = 30, narrow_spikes_L_of_heavy = 9.5;
constexpr double beside_first[] = {-0.2, 0.2, -0.4, 0.4};
constexpr std::size_t few_maps = 2, all_maps = 1 + std::size(beside_first);
constexpr int largest_nodes_of_few = 512, largest_nodes_of_all = 4096;
/// Error of a number over the residual that GMRES leaves, twice the largest at 40 contacts (M of 0.5..1000, L of 0..20,
/// Omega of 0..10, waves of 0.3..5 b), and the part of the tolerance that GMRES may leave in it.
constexpr double of_kappa = 0.2, of_damping = 60, of_wavy_film = 90, linear_part = 0.1;
/// The part of the tolerance that Newton's method may leave as its residual: 60 times as much in the damping.
constexpr double newton_part = 1e-5;
/// Numbers of fewer grids have no error estimate; those of so many are extrapolated once.
constexpr std::size_t fewest_grids = 3;
/// Ratios of moves that count as regular (8 for smooth solutions), and the parts of earlier moves in the error, which
/// protect against a move that is small by chance: extrapolated(). Chosen on 110 random contacts (M of 0.5..1000, L of
/// 0..20, Omega of 0..10) and 74 random waves (0.5..5 b) against the certified solver; tested on others by ehd stress,
/// part motion.
constexpr double least_ratio = 5, largest_ratio = 13;
constexpr double of_move_before = 1.0 / 8, of_second_before = 1.0 / 32, of_raw_move = 1.0 / 32;
/// So many times as large is the error of irregular moves on one map, and of those of a mean over maps; and that of all
/// moves on one map where spikes are narrow.
constexpr double of_irregular = 2, of_irregular_mean = 1.5, of_narrow_spikes = 2.5;
/// This part of the maps' spread is in the error of a mean over all, and over few, there of the largest on any grid.
constexpr double of_spread = 0.6, of_spread_of_few = 3;
/// What the moving tail of a flooded contact leaves in kappa, relative, over Omega^2 min(1, lambda). Against the
/// reference at (0.5, 2), (1, 4), (2, 15), (8, 6) and 60 random contacts, Omega of 0..100: 1e-9 to 4e-8.
constexpr double tail_error = 6e-8;
/// What it leaves in kappa_1 is as much as in kappa here: 7e-8 was seen.
constexpr double Omega_of_damping = 2;
/// A disturbance e^(i Omega (T - X)) is resolved where Omega times the widest cell of the contact is at most this.
constexpr double largest_phase = 0.4;
/// GMRES leaves less at small Omega, where the lag is a small part of kappa; down to this Omega.
constexpr double least_Omega = 1e-3;

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

/// A number on one grid after the other, each the mean over the maps.
struct Sequence {
  std::vector<Complex> values;
  /// Of the maps' numbers on the last grid: root of the mean square distance from their mean. And the largest of any
  /// grid but the coarsest.
  double spread = 0, largest_spread = 0;
  double iteration = 0;  ///< error that it leaves on the last grid, relative
  double offset = 1;     ///< the tail's error in the number over that in kappa, relative: |H_01| over the number

  void add(const std::vector<Complex>& of_maps) {
    const double count = static_cast<double>(of_maps.size());
    const Complex mean = std::accumulate(of_maps.begin(), of_maps.end(), Complex(0)) / count;
    double squares = 0;
    for (const Complex& one : of_maps) squares += std::norm(one - mean);
    values.push_back(mean);
    spread = std::sqrt(squares / count);
    if (values.size() > 1) largest_spread = std::max(largest_spread, spread);
  }
};

class ResponseSolve {
 public:
  ResponseSolve(const Problem& problem, const ResponseRequest& request, Workspace& workspace)
      : problem_(problem), request_(request), workspace_(workspace) {}

  [[nodiscard]] Response solve();

 private:
  [[nodiscard]] bool refine();
  /// Whether kappa moves with the spike's place in its cell.
  [[nodiscard]] bool moves_kappa() const {
    return problem_.groups.L > (problem_.groups.M > heavy_M ? narrow_spikes_L_of_heavy : narrow_spikes_L);
  }
  /// More maps may be needed, and can be had.
  [[nodiscard]] bool may_average() const {
    return narrow_spikes_ && problem_.groups.M > narrow_spikes_M && !none_beside_;
  }
  [[nodiscard]] bool spent() const {
    return std::ranges::any_of(maps_, [](const auto& map) { return map->spent(); });
  }
  [[nodiscard]] double time_left_s() const {
    return request_.time_limit_s - std::chrono::duration<double>(Clock::now() - begin_).count();
  }
  [[nodiscard]] HarmonicGrids& add_map();
  [[nodiscard]] const Run& run() const { return maps_.front()->run(); }
  [[nodiscard]] std::span<const std::unique_ptr<HarmonicGrids>> used() const { return std::span(maps_).first(used_); }
  /// That all maps in use have.
  [[nodiscard]] std::size_t grids() const {
    return (*std::ranges::min_element(used(), {}, [](const auto& map) { return map->size(); }))->size();
  }
  void use(std::size_t count);
  template <class Pass>
  void on_few_then_all(bool may_make, const Pass& pass);
  /// number(map, harmonic) of every map in use on the k-th grid.
  template <class Number>
  [[nodiscard]] std::vector<Complex> on_maps(std::size_t k, const Number& number) {
    std::vector<Complex> found;
    for (std::size_t map = 0; map < used_; ++map) found.push_back(number(map, (*maps_[map])[k]));
    return found;
  }
  struct Extrapolated {
    Complex value;
    double error = 0;
  };
  [[nodiscard]] Extrapolated extrapolated(const std::vector<Complex>& values) const;
  [[nodiscard]] Judged judged(const Sequence& sequence, double Omega, double wavenumber) const;
  template <class Next>
  [[nodiscard]] Judged certified(double Omega, double wavenumber, bool refines, const Next& next);
  [[nodiscard]] Stiffness stiffness(double Omega, bool refines = true);
  [[nodiscard]] Judged wavy_film(const Waviness& waviness);
  [[nodiscard]] SlowStiffness slow();
  void add_slow(std::size_t k, std::vector<Step>& u_0, std::vector<Step>& u_1, Sequence& stiffness, Sequence& damping,
                Sequence& lag);
  void fill(Cost& cost) const;
  /// That GMRES may leave in a number whose error is so many times the residual.
  [[nodiscard]] double residual_for(double amplification) const {
    return linear_part * request_.tolerance / amplification;
  }

  const Problem& problem_;
  const ResponseRequest& request_;
  Workspace& workspace_;
  const Clock::time_point begin_ = Clock::now();
  std::vector<std::unique_ptr<HarmonicGrids>> maps_;  ///< their k-th grids have the same number of intervals
  std::size_t used_ = 1;                              ///< maps that the present number is taken from
  bool none_beside_ = false;                          ///< the first map has none beside it
  bool narrow_spikes_ = false;                        ///< they move the present number
};

HarmonicGrids& ResponseSolve::add_map() {
  const Request steady{
      .tolerance = {}, .nodes = first_nodes, .max_iterations = request_.max_iterations, .time_limit_s = time_left_s()};
  Workspace& own = maps_.empty() ? workspace_ : workspace_.beside(maps_.size() - 1);
  maps_.push_back(std::make_unique<HarmonicGrids>(problem_, steady, newton_part * request_.tolerance, own));
  return *maps_.back();
}

/// Takes the present number from so many maps, from the first alone where the others cannot be had.
void ResponseSolve::use(std::size_t count) {
  while (maps_.size() < count && !none_beside_) {
    const double cells = beside_first[maps_.size() - 1];
    none_beside_ = !add_map().climb_beside(*maps_.front(), fewest_grids, cells);
  }
  if (none_beside_) maps_.resize(1);
  used_ = std::min(count, maps_.size());
}

/// Calls pass() with few maps in use, and where it is not content with all; maps are made where that is allowed.
template <class Pass>
void ResponseSolve::on_few_then_all(bool may_make, const Pass& pass) {
  use(may_average() ? few_maps : 1);
  if (pass() || used_ == 1 || spent() || (maps_.size() == used_ && !may_make)) return;
  use(all_maps);
  pass();
}

/// One more grid on every map in use that has no more than the others.
bool ResponseSolve::refine() {
  const int most = used_ == 1 ? largest_nodes : used_ == few_maps ? largest_nodes_of_few : largest_nodes_of_all;
  const std::size_t known = grids();
  return std::ranges::all_of(used(), [&](const auto& map) { return map->size() > known || map->refine(most); });
}

/// f_k on the grids, R_k = (4 f_k - f_(k-1))/3 and S_k = (8 R_k - R_(k-1))/7, since errors fall as h^2 and then h^3;
/// r_k = |R_k - R_(k-1)|. The value is S_m, the error max(|S_m - S_(m-1)|, r_m, r_(m-1)/8, r_(m-2)/32), of three grids
/// max(r_m, |f_m - f_(m-1)|/32). Where r_(m-1)/r_m or r_(m-2)/r_(m-1) is irregular, the error is of_irregular
/// times as large. A mean over maps is then R_m, which amplifies their spread least, and its error half as large again.
ResponseSolve::Extrapolated ResponseSolve::extrapolated(const std::vector<Complex>& f) const {
  const std::size_t m = f.size();
  // From the finest grid backwards: R(0), R(1), ...
  const auto R = [&](std::size_t back) { return (4.0 * f[m - 1 - back] - f[m - 2 - back]) / 3.0; };
  const auto S = [&](std::size_t back) { return (8.0 * R(back) - R(back + 1)) / 7.0; };
  const auto move = [&](std::size_t back) { return std::abs(R(back) - R(back + 1)); };
  const auto regular = [&](std::size_t back) {
    return move(back + 1) >= least_ratio * move(back) && move(back + 1) <= largest_ratio * move(back);
  };
  if (m == fewest_grids)
    return {.value = S(0), .error = std::max(move(0), of_raw_move * std::abs(f[m - 1] - f[m - 2]))};
  const bool five = m > fewest_grids + 1;
  const double error =
      std::max({std::abs(S(0) - S(1)), move(0), of_move_before * move(1), five ? of_second_before * move(2) : 0});
  if (regular(0) && (!five || regular(1))) return {.value = S(0), .error = error};
  return used_ > 1 ? Extrapolated{.value = R(0), .error = of_irregular_mean * error}
                   : Extrapolated{.value = S(0), .error = of_irregular * error};
}

Judged ResponseSolve::judged(const Sequence& sequence, double Omega, double wavenumber) const {
  const std::size_t m = sequence.values.size();
  Judged found{.value = sequence.values.back()};
  if (!std::isfinite(std::abs(found.value))) return found;
  found.status = spent() ? StopReason::limit_reached : StopReason::tolerance_not_met;
  if (m < fewest_grids) return found;
  auto [value, error] = extrapolated(sequence.values);
  found.value = value;
  const Harmonic& finest = (*maps_.front())[m - 1];
  if (wavenumber * finest.widest_cell() > largest_phase) return found;
  if (used_ == 1 && narrow_spikes_) error *= of_narrow_spikes;
  error += used_ == few_maps ? of_spread_of_few * sequence.largest_spread : of_spread * sequence.spread;
  const Setting& setting = run().setting;
  const double tail = setting.with_tail ? tail_error * std::min(1.0, setting.groups.lambda) * Omega * Omega : 0;
  double residual = 0;
  for (const auto& map : used()) residual = std::max(residual, map->residual(m - 1));
  found.error = error / std::abs(found.value);
  found.error += tail * sequence.offset + run().truncation + sequence.iteration + residual;
  if (found.error <= request_.tolerance) found.status = StopReason::converged;
  return found;
}

/// A number on one grid after the other until it is known; next(k, sequence) adds its value on the k-th grid. Finer
/// grids, and more maps, are made where it `refines`.
template <class Next>
Judged ResponseSolve::certified(double Omega, double wavenumber, bool refines, const Next& next) {
  Judged found;
  on_few_then_all(refines, [&] {
    Sequence sequence;
    for (std::size_t k = 0; k < grids() || (refines && refine()); ++k) {
      next(k, sequence);
      found = judged(sequence, Omega, wavenumber);
      if (found.status == StopReason::converged || found.status == StopReason::diverged || spent()) return true;
    }
    return false;
  });
  return found;
}

Stiffness ResponseSolve::stiffness(double Omega, bool refines) {
  std::vector<StepOf<Complex>> u;
  Sequence lag;
  narrow_spikes_ = moves_kappa();
  const Judged kappa = certified(Omega, Omega, refines, [&](std::size_t k, Sequence& sequence) {
    if (k == 0) u.assign(used_, {}), lag = {};
    double residual = 0;
    const auto chi = on_maps(k, [&](std::size_t map, Harmonic& harmonic) {
      auto motion = harmonic.of_load(Complex(0, Omega), residual_for(of_kappa) * std::clamp(Omega, least_Omega, 1.0),
                                     known(u[map]));
      u[map] = std::move(motion.u);
      residual = std::max(residual, motion.residual);
      return -u[map].offset;
    });
    std::vector<Complex> kappas, lags;
    for (const Complex& one : chi) {
      kappas.push_back(1.0 / one);
      lags.emplace_back(-one.imag() / Omega);
    }
    sequence.add(kappas);
    sequence.iteration = of_kappa * residual;
    lag.add(lags);
    // An error of kappa, all of it in the imaginary part.
    lag.offset = std::abs(chi.front().imag()) > 0 ? std::abs(chi.front() / chi.front().imag()) : 0;
    lag.iteration = sequence.iteration * lag.offset;
  });
  Stiffness found{.Omega = Omega, .kappa = kappa.value, .error = kappa.error, .status = kappa.status};
  if (Omega > 0) found.lag_error = judged(lag, Omega, Omega).error;
  return found;
}

Judged ResponseSolve::wavy_film(const Waviness& waviness) {
  std::vector<StepOf<Complex>> u;
  const double Omega = waviness.Omega();
  narrow_spikes_ = problem_.groups.L > narrow_spikes_L;
  return certified(Omega, std::max(Omega, waviness.wavenumber()), true, [&](std::size_t k, Sequence& sequence) {
    if (k == 0) u.assign(used_, {});
    double residual = 0;
    sequence.add(on_maps(k, [&](std::size_t map, Harmonic& harmonic) {
      auto motion = harmonic.of_waviness(waviness, residual_for(of_wavy_film), known(u[map]));
      u[map] = std::move(motion.u);
      residual = std::max(residual, motion.residual);
      const auto deflection = harmonic.central_film(waviness, u[map]);
      return deflection ? 1.0 + *deflection : Complex(std::numeric_limits<double>::quiet_NaN());
    }));
    sequence.iteration = of_wavy_film * residual;
    sequence.offset = std::abs(u.front().offset / sequence.values.back());
  });
}

/// kappa = -1/(u_0 + s u_1) = kappa_0 + s kappa_1; the lag is u_1.
SlowStiffness ResponseSolve::slow() {
  Judged stiff, damped, lagging;
  narrow_spikes_ = moves_kappa();
  on_few_then_all(true, [&] {
    std::vector<Step> u_0(used_), u_1(used_);
    Sequence stiffness, damping, lag;
    for (std::size_t k = 0; k < grids() || refine(); ++k) {
      add_slow(k, u_0, u_1, stiffness, damping, lag);
      // Each number is that of the first grid on which it is known. Finer grids may agree by chance where a spike
      // passes between their nodes.
      if (stiff.status != StopReason::converged) stiff = judged(stiffness, 0, 0);
      if (damped.status != StopReason::converged) {
        damped = judged(damping, Omega_of_damping, 0);
        lagging = judged(lag, Omega_of_damping, 0);
      }
      if ((stiff.status == StopReason::converged && damped.status == StopReason::converged) || spent()) return true;
    }
    return false;
  });
  return {.kappa_0 = stiff.value.real(),
          .kappa_1 = damped.value.real(),
          .error_0 = stiff.error,
          .error_1 = damped.error,
          .lag = lagging.value.real(),
          .lag_error = lagging.error};
}

/// kappa_0, kappa_1 and the lag on the k-th grid; u_0 and u_1 are those of each map's grid before.
void ResponseSolve::add_slow(std::size_t k, std::vector<Step>& u_0, std::vector<Step>& u_1, Sequence& stiffness,
                             Sequence& damping, Sequence& lag) {
  double at_rest = 0, moving = 0;
  const auto lags = on_maps(k, [&](std::size_t map, Harmonic& harmonic) {
    auto rest = harmonic.of_load(0.0, residual_for(of_damping), known(u_0[map]));
    u_0[map] = std::move(rest.u);
    auto motion = harmonic.of_slow_load(u_0[map], residual_for(of_damping), known(u_1[map]));
    u_1[map] = std::move(motion.u);
    at_rest = std::max(at_rest, rest.residual);
    moving = std::max(moving, motion.residual);
    return Complex(u_1[map].offset);
  });
  stiffness.add(on_maps(k, [&](std::size_t map, const Harmonic&) { return Complex(-1 / u_0[map].offset); }));
  damping.add(
      on_maps(k, [&](std::size_t map, const Harmonic&) { return lags[map] / (u_0[map].offset * u_0[map].offset); }));
  lag.add(lags);
  stiffness.iteration = of_kappa * at_rest;
  damping.iteration = lag.iteration = of_damping * std::max(at_rest, moving);
}

void ResponseSolve::fill(Cost& cost) const {
  const HarmonicGrids& first = *maps_.front();
  cost.nodes = first[first.size() - 1].intervals();
  cost.levels = static_cast<int>(first.size());
  for (const auto& map : maps_) {
    const Run& run = map->run();
    cost.newton_iterations += run.counters.newton;
    cost.krylov_iterations += run.counters.krylov;
    cost.convolutions += run.counters.convolutions;
    cost.planning_s += run.workspace.grids.planning_s() - run.planning_before;
  }
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count() - cost.planning_s;
}

Response ResponseSolve::solve() {
  Response found;
  for (const double Omega : request_.frequencies) found.frequencies.push_back({.Omega = Omega});
  for (const Waviness& waviness : request_.waviness) found.waviness.push_back({.waviness = waviness});
  if (!add_map().climb()) {
    answer_nothing(found, request_, spent() ? StopReason::limit_reached : StopReason::diverged,
                   "the steady state was not found");
    return found;
  }
  found.slow = slow();
  for (Stiffness& at : found.frequencies) at = stiffness(at.Omega);
  const auto certified = [&](double Omega) { return stiffness(Omega, false).status == StopReason::converged; };
  find_highest_certified(found, request_.tolerance, certified, [&] { return spent(); });
  for (WavinessResponse& at : found.waviness) {
    const Judged film = wavy_film(at.waviness);
    at.film = film.value, at.error = film.error, at.status = film.status;
  }
  conclude(found, request_.tolerance, spent(), "the finest grids differ by more than the tolerance");
  fill(found.cost);
  return found;
}

}  // namespace

Response response(const Problem& problem, const ResponseRequest& request, Workspace& workspace) {
  return ResponseSolve(problem, request, workspace).solve();
}

}  // namespace ehd::fast
