// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/prolongation.hpp"

#include <algorithm>
#include <cmath>

#include "fast/steep_fall.hpp"

namespace ehd::fast {

namespace {

/// From one grid to the next the exit and H_0 move by this part of their last move: their errors fall as h^2.
constexpr double next_move = 0.25;
/// The spike moves by this part of its last move. Measured: 0.26 to 0.4 at M of 5..1000, L of 5..20, up to 2048
/// intervals. Newton steps at 40 contacts, 512 intervals: 0.25, 0.33, 0.4, 0.45 and 0.5 take 1.03, 1.01, 1, 1.01 and
/// 1.02; no move at all takes 1.14.
constexpr double next_spike_move = 0.4;
/// Upstream of the spike its move fades within this part of its distance from the exit.
constexpr double fading = 0.5;
/// Nothing moves beyond so many of these reaches upstream: exp(-40) of a move is lost in rounding.
constexpr double unmoved = 6.4;
/// A move beyond this part of the distance from spike to exit is not believed. The pressure is then only interpolated.
constexpr double largest_move = 0.2;
/// Nor is a move where the peak is further from the middle of its fall than so many of these distances: the pressure
/// then falls from the centre (L <= 1, M >= 500), and a move costs up to 20 % more products than interpolation alone.
constexpr double farthest_peak = 2;
/// Steps to the index of a place within its cell.
constexpr int place_steps = 3;

/// A pressure on its nodes.
struct Profile {
  const Grid& grid;
  const State& state;
  double inlet;
  [[nodiscard]] double length() const { return state.exit - inlet; }
  [[nodiscard]] double X(Eigen::Index i) const { return inlet + length() * grid.place[i]; }
  [[nodiscard]] Array X() const { return inlet + length() * grid.place; }
};

/// Where the pressure has fallen from this peak to the level.
double fall_to(double level, Eigen::Index peak, const Profile& profile) {
  const Array& P = profile.state.P;
  Eigen::Index i = peak;
  while (i + 2 < P.size() && P[i + 1] > level) ++i;
  return profile.X(i) + (profile.X(i + 1) - profile.X(i)) * (P[i] - level) / (P[i] - P[i + 1]);
}

/// Cubic through y_0 .. y_3 at t.
double cubic_through(const double* y, double t) {
  return -(t - 1) * (t - 2) * (t - 3) / 6 * y[0] + t * (t - 2) * (t - 3) / 2 * y[1] - t * (t - 1) * (t - 3) / 2 * y[2] +
         t * (t - 1) * (t - 2) / 6 * y[3];
}

/// P at the place phi = `at` in a cell, cubic in the index, to which the map is smooth; not below both ends of the
/// cell.
double pressure_at(double at, Eigen::Index cell, const Profile& profile) {
  const Eigen::Index first = std::clamp<Eigen::Index>(cell - 1, 0, profile.grid.n - 3);
  const double* const place = profile.grid.place.data() + first;
  const double width = profile.grid.spacing[cell];
  double t = static_cast<double>(cell - first) + (at - profile.grid.place[cell]) / width;
  for (int k = 0; k < place_steps; ++k) t -= (cubic_through(place, t) - at) / width;  // phi(t) = at
  const Array& P = profile.state.P;
  return std::max(cubic_through(P.data() + first, t), std::min(P[cell], P[cell + 1]));
}

/// How far the solution moves from a place on the grid so far to the next grid: with the spike and the exit, linearly
/// between them, and less and less upstream of the spike.
struct Move {
  double spike = 0, exit = 0;            ///< their places on the next grid
  double spike_move = 0, exit_move = 0;  ///< by which they have moved
  double reach = 1;
  [[nodiscard]] double at(double X) const {
    if (X > spike) return spike_move + (exit_move - spike_move) * (X - spike) / (exit - spike);
    const double away = (spike - X) / reach;
    return away < unmoved ? spike_move * std::exp(-away * away) : 0;
  }
};

/// Empty where there is no spike to follow.
std::optional<Move> next_move_of(const Profile& before, const Profile& last) {
  const Eigen::Index peak_before = peak_before_fall(before.X(), before.state.P),
                     peak = peak_before_fall(last.X(), last.state.P);
  const double level = std::min(before.state.P[peak_before], last.state.P[peak]) / 2;
  const double spike = fall_to(level, peak, last), to_exit = last.state.exit - spike;
  const double spike_move = next_spike_move * (spike - fall_to(level, peak_before, before));
  const double exit_move = next_move * (last.state.exit - before.state.exit);
  const bool near = spike - last.X(peak) < farthest_peak * to_exit;
  const bool small = std::max(std::abs(spike_move), std::abs(exit_move)) < largest_move * to_exit;
  if (!near || !small) return std::nullopt;
  return Move{.spike = spike + spike_move,
              .exit = last.state.exit + exit_move,
              .spike_move = spike_move,
              .exit_move = exit_move,
              .reach = fading * to_exit};
}

}  // namespace

State interpolate_to(const State& coarse, int n) {
  const int m = static_cast<int>(coarse.P.size()) - 1;
  State fine{.P = Array::Zero(n + 1), .offset = coarse.offset, .exit = coarse.exit, .tail = coarse.tail};
  for (int i = 0; i <= n; ++i) {
    const double at = static_cast<double>(i) * m / n;
    const int first = std::clamp(static_cast<int>(at) - 1, 0, m - 3);
    fine.P[i] = std::max(0.0, cubic_through(coarse.P.data() + first, at - first));
  }
  return fine;
}

State Prolongation::onto(int n, Grids& grids, double inlet) const {
  const auto profile_of = [&](const State& state) {
    return Profile{grids.of(static_cast<int>(state.P.size()) - 1), state, inlet};
  };
  const Profile last = profile_of(*last_);
  const auto move = before_ ? next_move_of(profile_of(*before_), last) : std::nullopt;
  const auto fall = steep_fall(last.X(), last_->P);
  if (!move && !fall) return interpolate_to(*last_, n);

  const Grid& fine = grids.of(n);
  State state{.P = Array::Zero(n + 1), .offset = last_->offset, .exit = last_->exit, .tail = last_->tail};
  if (move) {
    state.offset += next_move * (last_->offset - before_->offset);
    state.exit = move->exit;
  }
  const double length = state.exit - inlet;
  Eigen::Index cell = 0;
  for (int i = 1; i < n; ++i) {
    const double X = inlet + length * fine.place[i], from = move ? X - move->at(X) : X;
    const double at = (from - inlet) / last.length();
    while (cell + 1 < last.grid.n && last.grid.place[cell + 1] < at) ++cell;
    state.P[i] = fall && fall->covers(cell) ? fall->mean(from, length * (fine.place[i + 1] - fine.place[i - 1]) / 2)
                                            : pressure_at(at, cell, last);
  }
  return state;
}

}  // namespace ehd::fast
