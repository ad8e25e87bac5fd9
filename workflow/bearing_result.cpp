// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_result.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd {

int loaded_rollers(const std::vector<RollerRow>& rollers) {
  double largest_N = 0;
  for (const RollerRow& row : rollers) largest_N = std::max(largest_N, row.inner.force_N);
  return static_cast<int>(std::count_if(rollers.begin(), rollers.end(), [&](const RollerRow& row) {
    return bearing::is_loaded(row.inner.force_N, largest_N);
  }));
}

std::size_t most_loaded(const BearingResult& result) {
  const auto lighter = [](const RollerRow& one, const RollerRow& other) {
    return one.inner.force_N < other.inner.force_N;
  };
  return static_cast<std::size_t>(std::max_element(result.rollers.begin(), result.rollers.end(), lighter) -
                                  result.rollers.begin());
}

double largest_force_N(const BearingResult& result) {
  return result.rollers.empty() ? 0 : result.rollers[most_loaded(result)].inner.force_N;
}

std::optional<ContactPlace> largest_pressure_place(const BearingResult& result) {
  if (result.rollers.empty()) return std::nullopt;
  const std::size_t most = most_loaded(result);
  const RollerRow& roller = result.rollers[most];
  if (!roller.inner.hertz_pressure_Pa) return std::nullopt;
  const bool inner = *roller.inner.hertz_pressure_Pa >= roller.outer.hertz_pressure_Pa.value_or(0);
  return ContactPlace{.roller = most, .raceway = inner ? bearing::Raceway::inner : bearing::Raceway::outer};
}

std::optional<ContactPlace> smallest_film_place(const BearingResult& result) {
  const double largest_N = largest_force_N(result);
  std::optional<ContactPlace> place;
  std::optional<double> smallest_m;
  for (std::size_t j = 0; j < result.rollers.size(); ++j) {
    if (!bearing::is_loaded(result.rollers[j].inner.force_N, largest_N)) continue;
    for (const bearing::Raceway raceway : bearing::both_raceways) {
      const auto film_m = result.rollers[j].at(raceway).film_minimum_m;
      if (!film_m || (smallest_m && *film_m >= *smallest_m)) continue;
      smallest_m = film_m;
      place = {.roller = j, .raceway = raceway};
    }
  }
  return place;
}

const BearingResult* full_relation_in(const std::vector<BearingResult>& results) {
  for (const BearingResult& result : results)
    if (result.law == bearing::Law::ehd && !result.rollers.empty()) return &result;
  return nullptr;
}

// The stiffness in motion at 0 Hz is the same number, found in another way. Where the result has it, the error is that
// of the motion plus the difference of the two. This is smaller than what the film curves alone can state.
std::optional<double> stiffness_error(const BearingResult& result, const BearingResult* full) {
  if (result.rollers.empty() || !needs_film(result.law)) return std::nullopt;
  const double along = result.stiffness_N_per_m[0][0];
  const auto relative = [along](double error) { return std::abs(error / along); };
  if (result.fit) {
    if (!full) return std::nullopt;
    const double of_full = full->stiffness_N_per_m[0][0];
    return relative(std::abs(along - of_full) + stiffness_error(*full, nullptr).value_or(0) * std::abs(of_full));
  }
  for (const DynamicRow& row : result.dynamics) {
    if (row.frequency_Hz != 0) continue;
    const auto& moving = row.ring.stiffness_N_per_m;
    return relative(row.ring.error * std::abs(moving[0][0] + moving[1][1]) + std::abs(moving[0][0] - along));
  }
  return result.stiffness_error_N_per_m ? std::optional(relative(*result.stiffness_error_N_per_m)) : std::nullopt;
}

std::optional<double> torque_error(const BearingResult& result, const BearingResult* full) {
  if (!result.torque) return std::nullopt;
  if (!result.fit) return result.torque->error;
  if (!full || !full->torque) return std::nullopt;
  const double of_full = full->torque->torque_N_m, away = std::abs(result.torque->torque_N_m - of_full);
  return (away + full->torque->error * std::abs(of_full)) / std::abs(result.torque->torque_N_m);
}

std::optional<double> motion_error(const BearingResult& result, const BearingResult* full, std::size_t k) {
  const bearing::RingMotion& own = result.dynamics[k].ring;
  if (!result.fit) return own.error;
  if (!full || full->dynamics.size() != result.dynamics.size()) return std::nullopt;
  const bearing::RingMotion& other = full->dynamics[k].ring;
  const auto trace = [](const bearing::Matrix2& K) { return std::abs(K[0][0] + K[1][1]); };
  double away = 0;
  for (const auto& [r, s] : {std::pair{0U, 0U}, {1U, 1U}, {0U, 1U}})
    away = std::max(away, std::abs(own.stiffness_N_per_m[r][s] - other.stiffness_N_per_m[r][s]));
  return own.error + (away + other.error * trace(other.stiffness_N_per_m)) / trace(own.stiffness_N_per_m);
}

namespace {
constexpr double error_of_a_digit = 0.5;  ///< with a larger one not even the first digit is known
}

bool knows_stiffness(const BearingResult& result, const BearingResult* full) {
  return stiffness_error(result, full).value_or(0) <= error_of_a_digit;
}

bool knows_motion(const BearingResult& result, const BearingResult* full, std::size_t k) {
  return motion_error(result, full, k).value_or(0) <= error_of_a_digit;
}

bool knows_damping(const DynamicRow& row) { return row.ring.damping_error.value_or(0) <= error_of_a_digit; }

std::optional<std::pair<double, double>> geometric_load_zone_deg(const BearingResult& result, double clearance_m) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double along = result.displacement_m, across = result.displacement_lateral_m;
  const double moved = std::hypot(along, across), cosine = clearance_m / 2 / moved;
  if (!(moved > 0) || cosine >= 1) return std::nullopt;
  const double middle = std::atan2(across, along) * degrees, half = std::acos(std::max(cosine, -1.0)) * degrees;
  return std::pair(middle - half, middle + half);
}

std::optional<double> load_zone_error_deg(const BearingResult& result, double clearance_m) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double along = result.displacement_m, across = result.displacement_lateral_m;
  const double moved = std::hypot(along, across), cosine = clearance_m / 2 / moved;
  if (!result.errors || !(moved > 0) || std::abs(cosine) >= 1) return std::nullopt;
  const double along_error = result.errors->displacement_m, across_error = result.errors->displacement_lateral_m;
  const double moved_error = (std::abs(along) * along_error + std::abs(across) * across_error) / moved;
  const double turned = (std::abs(across) * along_error + std::abs(along) * across_error) / (moved * moved);
  const double cotangent = std::abs(cosine) / std::sqrt(1 - cosine * cosine);
  return degrees * (cotangent * moved_error / moved + turned);
}

}  // namespace ehd
