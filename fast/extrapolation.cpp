// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehd::fast {

namespace {

/// Calibrated as extrapolation.hpp says: bars of three grids; the ratios of moves that count as regular (8 for smooth
/// solutions); bars of regular and of irregular sequences; how much less each move further back counts.
constexpr double of_three = 1.6, of_plain_move = 3;
constexpr double least_ratio = 6, largest_ratio = 11;
constexpr double of_regular = 2, of_regular_move = 4;
constexpr double of_irregular = 1.5, of_spike = 2, less_each_move = 6;
constexpr std::size_t moves_back = 4;

/// The last moves of a film, relative: of R, of R one grid before, of S. Empty moves are 0.
struct Moves {
  double now = 0, before = 0, limit = 0;
  [[nodiscard]] double last() const { return std::abs(now); }
};

Moves moves_of(const std::vector<double>& f) {
  const std::size_t m = f.size();
  const auto R = [&](std::size_t k) { return (4 * f[k] - f[k - 1]) / 3; };
  const auto S = [&](std::size_t k) { return (8 * R(k) - R(k - 1)) / 7; };
  Moves moves{.now = (R(m - 1) - R(m - 2)) / f[m - 1]};
  if (m < 4) return moves;
  moves.before = (R(m - 2) - R(m - 3)) / f[m - 1];
  moves.limit = (S(m - 1) - S(m - 2)) / f[m - 1];
  return moves;
}

/// The central film's error in parts of moves, as extrapolation.hpp has it: a, then b and c, then d_0 and d_1.
constexpr double of_three_for_central = 0.15;
struct MoveFactors {
  double limit, second_order;
};
struct CentralFactors {
  MoveFactors regular, irregular;
  double smallest_at_least, smallest_by_film;
};
constexpr CentralFactors of_mild{.regular = {.limit = 0.25, .second_order = 0.015},
                                 .irregular = {.limit = 0.5, .second_order = 0.4},
                                 .smallest_at_least = 0.01,
                                 .smallest_by_film = 0.3};
constexpr CentralFactors of_stiff{.regular = {.limit = 0.5, .second_order = 0.03},
                                  .irregular = {.limit = 1, .second_order = 3},
                                  .smallest_at_least = 0.03,
                                  .smallest_by_film = 2};

}  // namespace

Limit limit_of(const std::vector<double>& f, bool spike) {
  const std::size_t m = f.size();
  if (m == 1) return {.value = f[0], .error = std::numeric_limits<double>::infinity()};
  // From the finest grid backwards: R(0), R(1), …
  const auto R = [&](std::size_t back) { return (4 * f[m - 1 - back] - f[m - 2 - back]) / 3; };
  if (m == 2) return {.value = R(0), .error = std::abs(f[1] - f[0])};
  const auto r = [&](std::size_t back) { return R(back) - R(back + 1); };
  const auto S = [&](std::size_t back) { return (8 * R(back) - R(back + 1)) / 7; };
  if (m == 3)
    return {.value = S(0), .error = std::max(of_three * std::abs(r(0)), std::abs(f[2] - f[1]) / of_plain_move)};

  const double move = std::abs(S(0) - S(1));
  // Beside a spike two regular ratios prove nothing: they are those of the smooth part. What the spike adds shows only
  // on grids that begin to see it.
  const auto regular = [&](std::size_t back) {
    if (spike) return false;
    const double ratio = r(back + 1) / r(back);
    return ratio >= least_ratio && ratio <= largest_ratio;
  };
  // One ratio may be near 8 by chance.
  if (regular(0) && m == 4) return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)))};
  if (regular(0) && regular(1))
    return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)) / of_regular_move)};
  double error = move, share = spike ? of_spike : of_irregular;
  for (std::size_t back = 0; back + 3 <= m && back < moves_back; ++back, share /= less_each_move)
    error = std::max(error, share * std::abs(r(back)));
  return {.value = S(0), .error = error};
}

double central_film_error(const std::vector<double>& central, const std::vector<double>& minimum, bool mild) {
  const Moves own = moves_of(central), smallest = moves_of(minimum);
  const CentralFactors& of = mild ? of_mild : of_stiff;
  if (central.size() == 3) return of_three_for_central * std::max(own.last(), smallest.last());
  const double ratio = own.before / own.now;
  const MoveFactors& by = ratio >= least_ratio && ratio <= largest_ratio ? of.regular : of.irregular;
  const double tie = std::max(of.smallest_at_least, of.smallest_by_film * std::min(1.0, central.back()));
  return std::max({by.limit * std::abs(own.limit), by.second_order * own.last(), tie * std::abs(smallest.limit)});
}

}  // namespace ehd::fast
