// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehd::fast {

namespace {

/// Calibrated as docs/fast-errors.md says: bars of three grids; the ratios of moves that count as regular (8 for smooth
/// solutions); bars of regular and of irregular sequences; how much less each move further back counts.
constexpr double of_three = 1.6, of_plain_move = 3;
constexpr double least_ratio = 6, largest_ratio = 11;
constexpr double of_regular = 2, of_regular_move = 4;
constexpr double of_irregular = 1.5, less_each_move = 6;
constexpr std::size_t moves_back = 4;

bool is_regular(double ratio) { return ratio >= least_ratio && ratio <= largest_ratio; }

/// The last moves of a film, relative: r_m, r_(m-1), s_m, s_(m-1), s_(m-2). Those of too few grids are 0.
struct Moves {
  double r = 0, r_before = 0, s = 0, s_before = 0, s_two_before = 0;
  [[nodiscard]] bool regular() const { return is_regular(r_before / r); }
};

Moves moves_of(const std::vector<double>& f) {
  const std::size_t m = f.size();
  const auto R = [&](std::size_t k) { return (4 * f[k] - f[k - 1]) / 3; };
  const auto S = [&](std::size_t k) { return (8 * R(k) - R(k - 1)) / 7; };
  Moves moves{.r = (R(m - 1) - R(m - 2)) / f[m - 1]};
  if (m < 4) return moves;
  moves.r_before = (R(m - 2) - R(m - 3)) / f[m - 1];
  moves.s = (S(m - 1) - S(m - 2)) / f[m - 1];
  if (m > 4) moves.s_before = (S(m - 2) - S(m - 3)) / f[m - 1];
  if (m > 5) moves.s_two_before = (S(m - 3) - S(m - 4)) / f[m - 1];
  return moves;
}

double last_move(const std::vector<double>& f) { return std::abs(1 - f[f.size() - 2] / f.back()); }

/// The error of the central film in parts of moves, as extrapolation.hpp has it: b and c, then d_0 and d_1.
constexpr double central_three_mild = 0.15, central_three = 0.25, central_three_on_first_map = 0.8;
/// Beyond this L three grids may agree on a wrong central film: the last move of either film counts too.
constexpr double central_move_L = 10, central_move = 0.25;
/// With more grids this part of the last move counts, beyond mild_L and on a map that is not settled.
constexpr double central_move_of_more = 0.1;
struct CentralParts {
  double s, r;
};
struct CentralFactors {
  CentralParts regular, irregular;
  double smallest_at_least, smallest_by_film;
};
constexpr CentralFactors central_wide{.regular = {.s = 0.5, .r = 0.03},
                                      .irregular = {.s = 1, .r = 0.1},
                                      .smallest_at_least = 0.01,
                                      .smallest_by_film = 0.3};
constexpr CentralFactors central_mild{.regular = {.s = 0.5, .r = 0.06},
                                      .irregular = {.s = 1, .r = 0.15},
                                      .smallest_at_least = 0.01,
                                      .smallest_by_film = 0.3};
constexpr CentralFactors central_stiff{
    .regular = {.s = 1, .r = 0.1}, .irregular = {.s = 1, .r = 0.3}, .smallest_at_least = 0.05, .smallest_by_film = 1};

/// The same of the smallest film: a, b, c, d, e.
struct SmallestParts {
  double s, r, r_before;
};
/// Coarse grids, up to so many intervals, have rules of their own.
constexpr int coarse = 512, middling = 1024;
struct SmallestRule {
  SmallestParts regular, irregular;
  double s_before;
  double move = 0;  ///< of the last move of either film
};
struct SmallestFactors {
  double three, move;  ///< of three grids: of r_3, of the last move of either film
  SmallestRule on_coarse, on_middling, on_fine;

  [[nodiscard]] const SmallestRule& on(int finest) const {
    return finest <= coarse ? on_coarse : finest <= middling ? on_middling : on_fine;
  }
};
constexpr SmallestFactors smallest_mild{.three = 0.25,
                                        .move = 0,
                                        .on_coarse = {.regular = {.s = 0.4, .r = 0.04, .r_before = 0.003},
                                                      .irregular = {.s = 0.3, .r = 0.1, .r_before = 0.02},
                                                      .s_before = 0.05},
                                        .on_middling = {.regular = {.s = 0.4, .r = 0.1, .r_before = 0.003},
                                                        .irregular = {.s = 0.5, .r = 0.9, .r_before = 0.17},
                                                        .s_before = 0.05},
                                        .on_fine = {.regular = {.s = 0.6, .r = 0.16, .r_before = 0.008},
                                                    .irregular = {.s = 0.5, .r = 0.9, .r_before = 0.17},
                                                    .s_before = 0.1}};
constexpr SmallestRule middle_grids{.regular = {.s = 0.8, .r = 0.3, .r_before = 0.01},
                                    .irregular = {.s = 1, .r = 1.5, .r_before = 0.3},
                                    .s_before = 0.3};
constexpr SmallestFactors smallest_middle{.three = 0.4,
                                          .move = 0.25,
                                          .on_coarse = {.regular = {.s = 0.5, .r = 0.15, .r_before = 0.01},
                                                        .irregular = {.s = 0.4, .r = 0.15, .r_before = 0.03},
                                                        .s_before = 0.3},
                                          .on_middling = middle_grids,
                                          .on_fine = middle_grids};
/// Up to between_L the rules of wide spikes hold on grids of up to `middling` intervals.
constexpr SmallestFactors smallest_between{.three = smallest_middle.three,
                                           .move = smallest_middle.move,
                                           .on_coarse = smallest_mild.on_coarse,
                                           .on_middling = smallest_mild.on_middling,
                                           .on_fine = middle_grids};
constexpr SmallestRule stiff_grids{
    .regular = {.s = 1, .r = 0.5, .r_before = 0.01}, .irregular = {.s = 1.5, .r = 2, .r_before = 0.4}, .s_before = 1};
constexpr SmallestFactors smallest_stiff{
    .three = 0.5, .move = 0.25, .on_coarse = stiff_grids, .on_middling = stiff_grids, .on_fine = stiff_grids};
/// Up to the first L the spike is wide, and even the smallest film is regular; on settled maps nearly so up to the
/// others.
constexpr double wide_spike_L = 8, between_L = 12, settled_L = 20;
/// On a map that is not settled.
constexpr SmallestParts unsettled_parts{.s = 1.5, .r = 2, .r_before = 0.35};
constexpr SmallestRule of_unsettled{.regular = unsettled_parts, .irregular = unsettled_parts, .s_before = 0.5};
/// There three grids may miss the spike, unless it is wide: the last move of either film counts too.
constexpr double unsettled_three_wide = 0.5, unsettled_three_middle = 1, unsettled_three_stiff = 1.6;
constexpr double unsettled_move = 0.55;
/// Beyond mild_L more than three grids may miss the spike too: this part of that move counts.
constexpr double unsettled_move_of_more = 0.75;

SmallestFactors smallest_factors(MapFit fit, double L) {
  if (fit == MapFit::settled)
    return L <= wide_spike_L ? smallest_mild
           : L <= between_L  ? smallest_between
           : L <= settled_L  ? smallest_middle
                             : smallest_stiff;
  SmallestFactors of;
  of.on_coarse = of.on_middling = of.on_fine = of_unsettled;
  of.three = L <= wide_spike_L ? unsettled_three_wide : L <= mild_L ? unsettled_three_middle : unsettled_three_stiff;
  of.move = L <= wide_spike_L ? 0 : unsettled_move;
  if (L > mild_L) of.on_coarse.move = of.on_middling.move = of.on_fine.move = unsettled_move_of_more;
  return of;
}

}  // namespace

std::vector<double> on_exact_halves(std::vector<double> values, const std::vector<int>& intervals) {
  const auto h2 = [](double n) { return 1 / (n * n); };
  double finer = values.back(), half = intervals.back();
  for (std::size_t k = values.size() - 1; k-- > 0;) {
    half /= 2;
    const double slope = (values[k] - finer) / (h2(intervals[k]) - h2(intervals[k + 1]));
    finer = values[k];
    values[k] += slope * (h2(half) - h2(intervals[k]));
  }
  return values;
}

Limit limit_of(const std::vector<double>& f) {
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
  const auto regular = [&](std::size_t back) { return is_regular(r(back + 1) / r(back)); };
  // One ratio may be near 8 by chance.
  if (regular(0) && m == 4) return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)))};
  if (regular(0) && regular(1))
    return {.value = S(0), .error = std::max(of_regular * move, std::abs(r(0)) / of_regular_move)};
  double error = move, share = of_irregular;
  for (std::size_t back = 0; back + 3 <= m && back < moves_back; ++back, share /= less_each_move)
    error = std::max(error, share * std::abs(r(back)));
  return {.value = S(0), .error = error};
}

double central_film_error(const std::vector<double>& central, const std::vector<double>& minimum, MapFit fit,
                          double L) {
  const Moves own = moves_of(central), smallest = moves_of(minimum);
  const CentralFactors& of = L <= wide_spike_L ? central_wide : L <= mild_L ? central_mild : central_stiff;
  const double move = std::max(last_move(central), last_move(minimum));
  if (central.size() == 3) {
    const double three = L <= mild_L            ? central_three_mild
                         : fit == MapFit::first ? central_three_on_first_map
                                                : central_three;
    return std::max(three * std::max(std::abs(own.r), std::abs(smallest.r)),
                    L <= central_move_L ? 0 : central_move * move);
  }
  const CentralParts& by = own.regular() ? of.regular : of.irregular;
  const double tie = std::max(of.smallest_at_least, of.smallest_by_film * std::min(1.0, central.back()));
  const double of_move = fit == MapFit::settled || L <= mild_L ? 0 : central_move_of_more * move;
  return std::max({by.s * std::abs(own.s), by.r * std::abs(own.r), tie * std::abs(smallest.s), of_move});
}

double smallest_film_error(const std::vector<double>& minimum, const std::vector<double>& central, MapFit fit, double L,
                           int finest) {
  const Moves own = moves_of(minimum);
  const SmallestFactors of = smallest_factors(fit, L);
  const double move = central.size() < 2 ? last_move(minimum) : std::max(last_move(minimum), last_move(central));
  if (minimum.size() == 3) return std::max(of.three * std::abs(own.r), of.move * move);
  const SmallestRule& rule = of.on(finest);
  const SmallestParts& by = own.regular() ? rule.regular : rule.irregular;
  return std::max({by.s * std::abs(own.s), by.r * std::abs(own.r), by.r_before * std::abs(own.r_before),
                   rule.s_before * std::abs(own.s_before), rule.move * move});
}

double compressible_film_error(const std::vector<double>& minimum, int finest) {
  constexpr std::size_t least_grids = 6;
  constexpr int least_intervals = 4000;
  if (minimum.size() < least_grids || finest < least_intervals) return 0;
  const Moves own = moves_of(minimum);
  return std::max(std::abs(own.s_before), std::abs(own.s_two_before) / 2);
}

}  // namespace ehd::fast
