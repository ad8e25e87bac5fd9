// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/known_pressures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehd {

namespace {

/// A height with a larger error is not reported.
constexpr double vaguest_height = 0.05;
/// With fewer grids a spike has no error estimate.
constexpr std::size_t fewest_for_spike = 4;
/// A spike is resolved where the nodes next to it are lower by at most this part of its height. In 30 solves on equal
/// cells and on the maps of `fast` it was at most 0.04 at heights that hold their stated error. At the five that do not
/// it was 0.13 to 0.57.
constexpr double steepest_resolved = 0.1;
/// On fewer grids than a spike needs, a maximum whose error is larger is taken for a spike, unless L is so small that
/// there is none.
constexpr double vaguest_smooth_maximum = 3e-3, spike_free_L = 2.5;
/// An unknown spike grows with the grids; half as high again was met.
constexpr double unknown_spike_growth = 0.5;
/// error_of_moves() takes so many of the last moves; each earlier one counts less by this factor. Heights of 752
/// contacts (M of 0.05..5000, L of 0..30) on 512 to 2048 intervals of the three kinds of map of `fast`, against 4096
/// intervals: of 2038 errors below 5 %, 5 missed; of the last move alone 161 of 2890, on 256 intervals 6 of 403.
/// Through the program, against `reference` at 350 contacts of M = 0.3..500, four tolerances: 0 of 575.
constexpr double less_each_move = 2;
constexpr std::size_t moves = 3;

/// Ratio of moves from which on a height settles.
constexpr double settling_ratio = 1.5;

bool resolves_peak(const Fields& fields, double place) {
  const Array &X = fields.X, &P = fields.P;
  const Eigen::Index right = std::lower_bound(X.begin(), X.end(), place) - X.begin();
  if (right < 2 || right + 1 >= X.size()) return false;
  const Eigen::Index top = P[right] > P[right - 1] ? right : right - 1;
  return std::min(P[top - 1], P[top + 1]) >= (1 - steepest_resolved) * P[top];
}

class Pressures {
 public:
  Pressures(Observables& seen, const Wanted& wanted, const Fields& fields, std::vector<std::string>& notes)
      : seen_(seen), wanted_(wanted), fields_(fields), notes_(notes) {}

  void judge(std::size_t grids, double L) {
    const auto spike = seen_.find(Quantity::pressure_spike);
    if (spike != seen_.end()) judge_spike(spike->second, grids);
    const auto maximum = seen_.find(Quantity::pressure_maximum);
    // The maximum may be a spike itself.
    const bool smooth = L <= spike_free_L || grids >= fewest_for_spike;
    const double vaguest = smooth ? vaguest_height : vaguest_smooth_maximum;
    if (maximum != seen_.end() && !(maximum->second.error.value_or(1) < vaguest))
      drop(Quantity::pressure_maximum, "its height is not known to 5 %");
  }

 private:
  void judge_spike(Reading& spike, std::size_t grids) {
    if (grids < fewest_for_spike || !resolves_peak(fields_, spike.place.value_or(0))) spike.error.reset();
    const double vague = spike.error.value_or(1);
    const bool known = vague < vaguest_height;
    const auto maximum = seen_.find(Quantity::pressure_maximum);
    if (maximum != seen_.end()) {
      const double height = spike.value * (1 + (known ? vague : std::max(unknown_spike_growth, vague)));
      const bool may_be_higher = height > maximum->second.value || maximum->second.place == spike.place;
      if (may_be_higher && known) {
        const double above = std::abs(height / maximum->second.value - 1);
        maximum->second.error = std::max({maximum->second.error.value_or(1), vague, above});
      } else if (may_be_higher) {
        drop(Quantity::pressure_maximum, "the spike, whose height is not known to 5 %, may be higher");
      }
    }
    if (!known) drop(Quantity::pressure_spike, "its height is not known to 5 %");
  }

  void drop(Quantity quantity, const char* why) {
    if (seen_.erase(quantity) > 0 && wanted_.contains(quantity))
      notes_.push_back(
          fmt::format("{} omitted: {}. Try a smaller tolerance, or more nodes.", to_string(quantity), why));
  }

  Observables& seen_;
  const Wanted& wanted_;
  const Fields& fields_;
  std::vector<std::string>& notes_;
};

}  // namespace

double error_of_moves(const std::vector<double>& heights) {
  double error = 0, share = spike_safety;
  for (std::size_t m = heights.size(), back = 0; back < moves && back + 2 <= m; ++back) {
    error = std::max(error, share * std::abs(heights[m - 1 - back] - heights[m - 2 - back]));
    share /= less_each_move;
  }
  return error;
}

double peak_error(Quantity peak, const std::vector<double>& values, const GridEstimate& found, double relative_error) {
  const bool settles = found.observed_order && *found.observed_order >= std::log2(settling_ratio);
  if (peak == Quantity::pressure_spike && !settles) return std::numeric_limits<double>::infinity();
  return std::max(spike_safety * relative_error, error_of_moves(values) / std::abs(values.back()));
}

void keep_known_pressures(Observables& seen, const Wanted& wanted, const Fields& fields, std::size_t grids, double L,
                          std::vector<std::string>& notes) {
  Pressures(seen, wanted, fields, notes).judge(grids, L);
}

}  // namespace ehd
