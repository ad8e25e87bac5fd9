// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/response.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "fast/harmonic_grids.hpp"
#include "fast/mapped_judgement.hpp"

namespace ehd::fast {

namespace {

using Clock = std::chrono::steady_clock;

/// Intervals of the finest grid of the steady climb, and of the finest grid of all.
constexpr int first_nodes = 256, largest_nodes = 16384;
/// The nodes follow the spike (moved_nodes.hpp) where L and M are above these: there it may be narrow. With fixed nodes
/// stated errors were too small at (67, 6.9), at some contacts of L = 8.9..9.2, at (10.3, 7.9) to 1e-5, and at 13 of
/// 1344 numbers of heavy contacts (L of 8..12.4), there up to three times. Contacts of smaller M have hardly a spike.
constexpr double narrow_spike_L = 5, narrow_spike_M = 0.5;
/// GMRES may leave this part of the tolerance in a number.
constexpr double linear_part = 0.1;
/// For this tolerance and looser ones the first map is good enough: care_of_maps().
constexpr double tolerance_of_first_map = 1e-3;
/// The first map is good enough up to this M only. Of 15 heavier contacts (to M = 5000), asked for 1e-3, 5 missed the
/// damping with it, by up to 4.8.
constexpr double first_map_M = 1000;
/// Newton's method may leave this part of the tolerance as its residual. The damping then errs by 60 times as much.
constexpr double newton_part = 1e-5;
/// Numbers of fewer grids have no error estimate. With just so many the error has a rule of its own: extrapolated().
constexpr std::size_t fewest_grids = 3;
/// Above these M and L the spike of an incompressible oil is so narrow that three grids agree by chance: 77 of 1,007
/// random contacts missed a number, by up to 13. There numbers need a grid more. Of 1,777 other contacts with a spike
/// one missed, by 1.3.
constexpr double steep_M = 50, steep_L = 9;
/// Moves whose ratio lies between these count as regular (8 for smooth solutions). `Parts`: what the error takes of the
/// last moves, see extrapolated(). The earlier ones protect against a move that is small by chance. Chosen on 110
/// random contacts (M of 0.5..1000, L of 0..20, Omega of 0..10) and 74 random waves (0.5..5 b) against the certified
/// solver; tested on others by ehd stress, part motion.
constexpr double least_ratio = 5, largest_ratio = 13;
struct Parts {
  double last, before, second_before;
};
constexpr Parts of_usual{.last = 1, .before = 1.0 / 8, .second_before = 1.0 / 32};
/// Four grids and more up to mild_L, where moves are regular and the maps the best. Of 500 other contacts, 5000
/// numbers, the error was at most .25 of the last move in 98 % of those of four grids, .17 of those of five and more.
constexpr Parts of_regular_four{.last = 0.3, .before = 0.04, .second_before = 0};
constexpr Parts of_regular_more{.last = 0.2, .before = 0.025, .second_before = 0.005};
/// Five grids and more up to mild_L, where moves are irregular, with the best maps. Of 900 random contacts up to M =
/// 1000 and L = 20, with three frequencies and two waves each, asked for 1e-3 to 1e-5, 17 of 18,176 errors were too
/// small, by up to 2.64. With twice of_usual for all irregular moves 14 of 18,048 were, and kappa to 1e-4 took 836
/// intervals in the mean instead of 730.
constexpr Parts of_irregular_more{.last = 0.5, .before = 1.0 / 16, .second_before = 1.0 / 64};
/// Four grids and more beyond mild_L. Of 956 random contacts 37 missed a number with of_usual, by up to 21. With these
/// parts, of_raw_move_of_four and on_first_map 8 do, by up to 1.5.
constexpr Parts of_stiff{.last = 1, .before = 1.0 / 5, .second_before = 1.0 / 16};
/// The part of the raw move |f_m - f_(m-1)| in the error of three grids. They may agree by chance: at (17.8, 18.1),
/// Barus, kappa_0 stated 4e-5 and was 1e-3 off.
constexpr double of_raw_move = 1.0 / 8;
/// Three grids beyond mild_L need larger parts. Of 500 numbers that three grids gave to 5e-3 there, 15 missed, by up
/// to 4.6. With these parts of both moves 376 are given, and none misses. On the best maps 26 of 463 missed, and 2 of
/// 331 do.
constexpr double of_move_beyond_mild = 3, of_raw_move_beyond_mild = 1;
/// The same of four grids beside a narrow spike, on the first map or where the spike is steep. At (225, 16.6),
/// Roelands, kappa_1 stated 2e-5 and was 4e-4 off.
constexpr double of_raw_move_of_four = 1.0 / 16;
/// So many times as large is the error on maps that are not the best: of irregular moves, and of all beyond mild_L.
constexpr double on_first_map = 2;
/// Disturbances on their way make the lag converge late. At Omega = 10 its true error is 0.3 to 0.5 of the raw move on
/// three and on four grids, and errors of three grids were up to 4 times too small. So the error of the lag is at least
/// this part of the raw move, times Omega up to the largest part.
constexpr double of_raw_lag = 0.06, largest_of_raw_lag = 0.6;
/// On the first map the error of the lag at a frequency is so many times that of other numbers: of 400 contacts asked
/// for 1e-3, kappa missed one error there, by 1.08, and the lag two, by 1.5 and 2.
constexpr double of_lag_on_first_map = 2;
/// What the moving tail of a flooded contact leaves in kappa, relative, over Omega^2 min(1, lambda). Against the
/// reference at (0.5, 2), (1, 4), (2, 15), (8, 6) and 60 random contacts, Omega of 0..100: 1e-9 to 4e-8. With
/// compressible oil at M of 0.45 to 9, L of 7 to 38, Omega of 10 to 50: up to 1.2e-7.
constexpr double tail_error = 6e-8, compressible_tail_error = 1.6e-7;
/// In kappa_1 the moving tail leaves as much as in kappa at this Omega: 7e-8 was seen.
constexpr double Omega_of_damping = 2;
/// A disturbance e^(i Omega (T - X)) is resolved where Omega times the widest cell of the contact is at most this.
constexpr double largest_phase = 0.4;
/// The widest cell of the finest grid is foretold from a coarser one, to this part.
constexpr double of_foretold_cell = 0.02;
/// The lag's part of kappa falls with Omega. So the residual that GMRES may leave falls alike, down to this Omega.
constexpr double least_Omega = 1e-3;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct Judged {
  Complex value;
  double error = std::numeric_limits<double>::infinity();
  StopReason status = StopReason::diverged;
};

/// How many times larger than GMRES's residual the error of a number may be. Bounds of what 1100 random contacts showed
/// (M of .02..1000, L of 0..22, Omega of 0..10, waves of .5..5 b). The largest of kappa: 10 up to M = 0.1, 6 up to 0.5,
/// 0.8 up to 2, 0.4 beyond. Of the damping: 30 up to M = 20, 50 up to 200, 430 up to 1000. Of the wavy film: 30, 70,
/// 980.
struct Amplification {
  explicit Amplification(double M)
      : of_kappa(std::clamp(2 / M, 0.5, 20.0)), of_damping(std::max(60.0, M / 2)), of_wavy_film(std::max(90.0, M)) {}
  double of_kappa, of_damping, of_wavy_film;
};

/// For tolerances of 1e-3 and looser the first map is good enough. It gathers fewer nodes at the spike, and a response
/// takes 0.7 of the time (220 random contacts). At 1e-5, 10 of 815 stated errors were too small with it, and none of
/// 1077 with better maps.
Care care_of_maps(const Groups& groups, double tolerance) {
  const bool first = tolerance >= tolerance_of_first_map && groups.M <= first_map_M && is_calibrated(groups);
  return first ? Care::least : Care::full;
}

/// The motion on a coarser grid; null where there was none.
template <class Scalar>
const Harmonic::Motion<Scalar>* known(const Harmonic::Motion<Scalar>& motion) {
  return motion.u.P.size() > 0 ? &motion : nullptr;
}

/// A number on one grid after the other.
struct Sequence {
  std::vector<Complex> values = {};
  double iteration = 0;  ///< error that GMRES leaves on the last grid, relative
  double offset = 1;     ///< the tail's error in the number over that in kappa, relative: |H_01| over the number
  double raw_part = 0;   ///< the error is at least this part of the last raw move
  double safety = 1;     ///< so many times as large is the error of extrapolation
};

double raw_move(const std::vector<Complex>& f) { return std::abs(f[f.size() - 1] - f[f.size() - 2]); }

class ResponseSolve {
 public:
  ResponseSolve(const Problem& problem, const ResponseRequest& request, Workspace& workspace)
      : problem_(problem),
        request_(request),
        care_(care_of_maps(problem.groups, request.tolerance)),
        grids_(problem,
               {.tolerance = {},
                .nodes = first_nodes,
                .max_iterations = request.max_iterations,
                .time_limit_s = request.time_limit_s},
               newton_part * request.tolerance, care_, workspace) {}

  [[nodiscard]] Response solve();

 private:
  [[nodiscard]] bool follows_spike() const {
    return problem_.groups.L > narrow_spike_L && problem_.groups.M > narrow_spike_M;
  }
  /// The bound of M: at (2170, 13.2), Roelands, three grids agreed on a kappa_0 that was 2.9 stated errors off.
  [[nodiscard]] bool is_mild() const { return problem_.groups.L <= mild_L && problem_.groups.M <= first_map_M; }
  [[nodiscard]] bool is_steep() const {
    return problem_.groups.L > steep_L && problem_.groups.M > steep_M && is_trivial(problem_.density);
  }
  /// How the nodes of the k-th grid follow the spike; null where they stay.
  [[nodiscard]] const MovedNodes* moved(std::size_t k) { return follows_spike() ? &grids_.moved(k) : nullptr; }
  struct Extrapolated {
    Complex value;
    double error = 0;
  };
  [[nodiscard]] Extrapolated extrapolated(const std::vector<Complex>& values) const;
  [[nodiscard]] const Parts& parts_of(bool five, bool is_regular) const;
  [[nodiscard]] Judged judged(const Sequence& sequence, double Omega, double wavenumber) const;
  /// One more grid.
  [[nodiscard]] bool refine() { return grids_.refine(largest_nodes); }
  /// Disturbances of this wavenumber are resolved by the finest grid of all.
  [[nodiscard]] double resolved_wavenumber() const {
    const Harmonic& finest = grids_[grids_.size() - 1];
    return largest_phase / (finest.widest_cell() * finest.intervals() / largest_nodes);
  }
  /// No grid resolves this wavenumber: finer ones need not be made.
  [[nodiscard]] bool is_beyond_grids(double wavenumber) const {
    return wavenumber > (1 + of_foretold_cell) * resolved_wavenumber();
  }
  template <class Next>
  [[nodiscard]] Judged certified(double Omega, double wavenumber, const Next& next);
  [[nodiscard]] Stiffness stiffness(double Omega);
  [[nodiscard]] Judged wavy_film(const Waviness& waviness);
  [[nodiscard]] SlowStiffness slow();
  void add_slow(std::size_t k, Harmonic::Motion<double>& rest, Harmonic::Motion<double>& next, Sequence& stiffness,
                Sequence& damping, Sequence& lag);
  void fill(Cost& cost) const;
  /// The residual that GMRES may leave for a number whose error is so many times the residual.
  [[nodiscard]] double residual_for(double amplification) const {
    return linear_part * request_.tolerance / amplification;
  }

  const Problem& problem_;
  const ResponseRequest& request_;
  const Amplification amplification_{problem_.groups.M};
  const Clock::time_point begin_ = Clock::now();
  const Care care_;
  HarmonicGrids grids_;
};

const Parts& ResponseSolve::parts_of(bool five, bool is_regular) const {
  if (!is_mild()) return of_stiff;
  if (care_ != Care::full) return of_usual;
  if (is_regular) return five ? of_regular_more : of_regular_four;
  return five ? of_irregular_more : of_usual;
}

/// f_k on the grids, R_k = (4 f_k - f_(k-1))/3 and S_k = (8 R_k - R_(k-1))/7, since errors fall as h^2 and then h^3;
/// r_k = |R_k - R_(k-1)|, d = |f_m - f_(m-1)|. The value is S_m, the error max(|S_m - S_(m-1)|, a r_m, b r_(m-1), c
/// r_(m-2)) with `Parts` a, b, c; of three grids max(r_m, d/8), beyond mild_L more; of four grids at least d/16 where
/// they may agree by chance. The parts are smaller where r_(m-1)/r_m and r_(m-2)/r_(m-1) are regular.
ResponseSolve::Extrapolated ResponseSolve::extrapolated(const std::vector<Complex>& f) const {
  const std::size_t m = f.size();
  // From the finest grid backwards: R(0), R(1), ...
  const auto R = [&](std::size_t back) { return (4.0 * f[m - 1 - back] - f[m - 2 - back]) / 3.0; };
  const auto S = [&](std::size_t back) { return (8.0 * R(back) - R(back + 1)) / 7.0; };
  const auto move = [&](std::size_t back) { return std::abs(R(back) - R(back + 1)); };
  const auto regular = [&](std::size_t back) {
    return move(back + 1) >= least_ratio * move(back) && move(back + 1) <= largest_ratio * move(back);
  };
  if (m == fewest_grids) {
    const bool narrow = follows_spike() && !is_mild();
    const double last = narrow ? of_move_beyond_mild : 1, raw = narrow ? of_raw_move_beyond_mild : of_raw_move;
    return {.value = S(0), .error = std::max(last * move(0), raw * raw_move(f))};
  }
  const bool five = m > fewest_grids + 1, best_maps = care_ == Care::full;
  const bool is_regular = regular(0) && (!five || regular(1));
  const Parts& part = parts_of(five, is_regular);
  double error = std::max(
      {std::abs(S(0) - S(1)), part.last * move(0), part.before * move(1), five ? part.second_before * move(2) : 0});
  if (!best_maps && (!is_regular || !is_mild())) error *= on_first_map;
  if (!five && follows_spike() && (!best_maps || is_steep()))
    error = std::max(error, of_raw_move_of_four * raw_move(f));
  return {.value = S(0), .error = error};
}

Judged ResponseSolve::judged(const Sequence& sequence, double Omega, double wavenumber) const {
  const std::size_t m = sequence.values.size();
  Judged found{.value = sequence.values.back()};
  if (!std::isfinite(std::abs(found.value))) return found;
  found.status = grids_.spent() ? StopReason::limit_reached : StopReason::tolerance_not_met;
  if (m < fewest_grids + (is_steep() ? 1 : 0)) return found;
  const auto [value, error] = extrapolated(sequence.values);
  found.value = value;
  if (wavenumber * grids_[m - 1].widest_cell() > largest_phase) return found;
  const Setting& setting = grids_.run().setting;
  const double of_tail = is_trivial(problem_.density) ? tail_error : compressible_tail_error;
  const double tail = setting.with_tail ? of_tail * std::min(1.0, setting.groups.lambda) * Omega * Omega : 0;
  found.error =
      std::max(sequence.safety * error, sequence.raw_part * raw_move(sequence.values)) / std::abs(found.value);
  found.error += tail * sequence.offset + grids_.run().truncation + sequence.iteration + grids_.residual(m - 1);
  if (found.error <= request_.tolerance) found.status = StopReason::converged;
  return found;
}

/// A number on one grid after the other until it is known; next(k, sequence) adds its value on the k-th grid.
template <class Next>
Judged ResponseSolve::certified(double Omega, double wavenumber, const Next& next) {
  Judged found;
  Sequence sequence;
  const bool beyond = is_beyond_grids(wavenumber);
  for (std::size_t k = 0; k < grids_.size() || (!beyond && refine()); ++k) {
    next(k, sequence);
    found = judged(sequence, Omega, wavenumber);
    if (found.status == StopReason::converged || found.status == StopReason::diverged || grids_.spent()) break;
  }
  return found;
}

Stiffness ResponseSolve::stiffness(double Omega) {
  Harmonic::Motion<Complex> motion;
  Sequence lag{.raw_part = std::min(of_raw_lag * Omega, largest_of_raw_lag),
               .safety = care_ == Care::full ? 1 : of_lag_on_first_map};
  const Complex rate(0, Omega);
  const double allowed = residual_for(amplification_.of_kappa) * std::clamp(Omega, least_Omega, 1.0);
  const Judged kappa = certified(Omega, Omega, [&](std::size_t k, Sequence& sequence) {
    motion = grids_[k].of_load(rate, allowed, moved(k), known(motion));
    const Complex chi = -motion.u.offset;
    sequence.values.push_back(1.0 / chi);
    sequence.iteration = amplification_.of_kappa * motion.residual;
    lag.values.emplace_back(-chi.imag() / Omega);
    // The error of the lag, if all of the error of kappa were in the imaginary part.
    lag.offset = std::abs(chi.imag()) > 0 ? std::abs(chi / chi.imag()) : 0;
    lag.iteration = sequence.iteration * lag.offset;
  });
  Stiffness found{.Omega = Omega, .kappa = kappa.value, .error = kappa.error, .status = kappa.status};
  if (Omega > 0) found.lag_error = judged(lag, Omega, Omega).error;
  return found;
}

Judged ResponseSolve::wavy_film(const Waviness& waviness) {
  Harmonic::Motion<Complex> motion;
  const double Omega = waviness.Omega(), allowed = residual_for(amplification_.of_wavy_film);
  return certified(Omega, std::max(Omega, waviness.wavenumber()), [&](std::size_t k, Sequence& sequence) {
    Harmonic& harmonic = grids_[k];
    motion = harmonic.of_waviness(waviness, allowed, moved(k), known(motion));
    const Complex film = 1.0 + harmonic.central_film(waviness, motion, moved(k)).value_or(not_known);
    sequence.values.push_back(film);
    sequence.iteration = amplification_.of_wavy_film * motion.residual;
    sequence.offset = std::abs(motion.u.offset / film);
  });
}

/// kappa = -1/(u_0 + s u_1) = kappa_0 + s kappa_1; the lag is u_1.
SlowStiffness ResponseSolve::slow() {
  Judged stiff, damped, lagging;
  Harmonic::Motion<double> rest, next;
  Sequence stiffness, damping, lag;
  for (std::size_t k = 0; k < grids_.size() || refine(); ++k) {
    add_slow(k, rest, next, stiffness, damping, lag);
    // Each number is that of the first grid on which it is known; the lag is taken with the damping.
    if (stiff.status != StopReason::converged) stiff = judged(stiffness, 0, 0);
    if (damped.status != StopReason::converged) {
      damped = judged(damping, Omega_of_damping, 0);
      lagging = judged(lag, Omega_of_damping, 0);
    }
    if ((stiff.status == StopReason::converged && damped.status == StopReason::converged) || grids_.spent()) break;
  }
  return {.kappa_0 = stiff.value.real(),
          .kappa_1 = damped.value.real(),
          .error_0 = stiff.error,
          .error_1 = damped.error,
          .lag = lagging.value.real(),
          .lag_error = lagging.error};
}

/// kappa_0, kappa_1 and the lag on the k-th grid; `rest` (u_0) and `next` (u_1) are those of the grid before.
void ResponseSolve::add_slow(std::size_t k, Harmonic::Motion<double>& rest, Harmonic::Motion<double>& next,
                             Sequence& stiffness, Sequence& damping, Sequence& lag) {
  Harmonic& harmonic = grids_[k];
  const double allowed = residual_for(amplification_.of_damping);
  rest = harmonic.of_load(0.0, allowed, moved(k), known(rest));
  next = harmonic.of_slow_load(rest, allowed, moved(k), known(next));
  const double offset_0 = rest.u.offset, offset_1 = next.u.offset;
  stiffness.values.emplace_back(-1 / offset_0);
  damping.values.emplace_back(offset_1 / (offset_0 * offset_0));
  lag.values.emplace_back(offset_1);
  stiffness.iteration = amplification_.of_kappa * rest.residual;
  damping.iteration = lag.iteration = amplification_.of_damping * std::max(rest.residual, next.residual);
}

void ResponseSolve::fill(Cost& cost) const {
  const Counters& counters = grids_.run().counters;
  if (grids_.size() > 0) cost.nodes = grids_[grids_.size() - 1].intervals();
  cost.levels = static_cast<int>(grids_.size());
  cost.newton_iterations = counters.newton;
  cost.krylov_iterations = counters.krylov;
  cost.convolutions = counters.convolutions;
  cost.planning_s = grids_.planning_s();
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count() - cost.planning_s;
}

Response ResponseSolve::solve() {
  Response found;
  for (const double Omega : request_.frequencies) found.frequencies.push_back({.Omega = Omega});
  for (const Waviness& waviness : request_.waviness) found.waviness.push_back({.waviness = waviness});
  if (!grids_.climb()) {
    answer_nothing(found, request_, grids_.spent() ? StopReason::limit_reached : StopReason::diverged,
                   "the steady state was not found");
    fill(found.cost);
    return found;
  }
  found.slow = slow();
  std::size_t done = 0;
  request_.tell(done);
  for (Stiffness& at : found.frequencies) {
    at = stiffness(at.Omega);
    request_.tell(++done);
  }
  const auto certified = [&](double Omega) { return stiffness(Omega).status == StopReason::converged; };
  if (request_.seeks_highest)
    find_highest_certified(
        found, request_.tolerance, certified, [&] { return grids_.spent(); },
        (1 - of_foretold_cell) * resolved_wavenumber());
  for (WavinessResponse& at : found.waviness) {
    const Judged film = wavy_film(at.waviness);
    at.film = film.value, at.error = film.error, at.status = film.status;
    request_.tell(++done);
  }
  conclude(found, request_.tolerance, grids_.spent(), "the finest grids differ by more than the tolerance");
  fill(found.cost);
  return found;
}

}  // namespace

Response response(const Problem& problem, const ResponseRequest& request, Workspace& workspace) {
  return ResponseSolve(problem, request, workspace).solve();
}

}  // namespace ehd::fast
