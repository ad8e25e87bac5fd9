// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/ring.hpp"

#include <algorithm>
#include <utility>

#include "bearing/careful_sum.hpp"

namespace ehd::bearing {

namespace {

/// Smallest cosine of half the angle between the directions beside the load. A roller closer to 90 degrees multiplies
/// the load by more than a million.
constexpr double grazing = 1e-6;

}  // namespace

Ring::Ring(const Geometry& geometry, const LawPair& laws, const Loading& loading, Form form)
    : azimuths_(azimuths_deg(geometry)),
      roller_(laws, loading.centrifugal_N),
      gap_m_(geometry.clearance_m / 2 + roller_.origin_m()) {
  plane_ = form == Form::plane && !symmetric_to_load(azimuths_);
  if (plane_) {
    for (int j = 0; j < static_cast<int>(azimuths_.size()); ++j) add_group(azimuths_[static_cast<std::size_t>(j)], {j});
  } else {
    for (const RollerGroup& group : mirror_groups(azimuths_)) add_group(group.azimuth_deg, group.members);
  }
  find_directions_beside_the_load();
  counts_from_touch_ = roller_.begins() && gap_m_ > 0 && loading.radial_N > 0 && can_carry();
  for (std::size_t g = 0; g < groups_.size(); ++g)
    groups_[g].excess_m = counts_from_touch_ ? excess_at_touch_m(azimuth_of_[g]) : -gap_m_;
  guess_N_.assign(groups_.size(), 0.0);
}

bool Ring::can_carry() const { return half_cosine() > grazing; }

Vector2 Ring::displacement_m(Vector2 v) const {
  if (!counts_from_touch_) return v;
  const double middle = (first_deg_ + second_deg_) / 2;  // exactly 0 for a mirrored pair
  return v + gap_m_ / half_cosine() * Vector2{cosine_of_degrees(middle), sine_of_degrees(middle)};
}

RingState Ring::at(Vector2 v) {
  RingState state;
  ++evaluations_;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    state.groups.push_back(roller_.at(excess_m(groups_[g], v), guess_N_[g]));
    guess_N_[g] = state.groups.back().inner.force_N;
  }
  sum(state);
  return state;
}

void Ring::sum(RingState& state) const {
  CarefulSum along, across, total;
  state.stiffness_N_per_m = {};
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto count = static_cast<double>(groups_[g].members.size());
    const Vector2& n = groups_[g].direction;
    const double f = count * state.groups[g].inner.force_N;
    along.add(f * n.x);
    across.add(f * n.y);
    total.add(f);
    state.stiffness_N_per_m.add(count * state.groups[g].stiffness_N_per_m, n);
  }
  state.force_N = {along.value(), across.value()};
  state.total_N = total.value();
}

void Ring::add_group(double azimuth, std::vector<int> members) {
  groups_.push_back({.direction = {cosine_of_degrees(azimuth), plane_ ? sine_of_degrees(azimuth) : 0.0},
                     .members = std::move(members)});
  azimuth_of_.push_back(azimuth);
}

void Ring::find_directions_beside_the_load() {
  if (plane_) {
    first_deg_ = -180;
    second_deg_ = 180;
    for (const double azimuth : azimuths_) {
      if (azimuth <= 0) first_deg_ = std::max(first_deg_, azimuth);
      if (azimuth >= 0) second_deg_ = std::min(second_deg_, azimuth);
    }
  } else {
    // The roller nearest to the load line and its mirror image, whether or not that is a roller.
    second_deg_ = *std::min_element(azimuth_of_.begin(), azimuth_of_.end());
    first_deg_ = -second_deg_;
  }
}

double Ring::half_cosine() const {
  const double half = (second_deg_ - first_deg_) / 2;
  return half < 180 ? cosine_of_degrees(half) : -1;
}

double Ring::excess_at_touch_m(double azimuth) const {
  return -2 * gap_m_ * sine_of_degrees((azimuth - first_deg_) / 2) * sine_of_degrees((azimuth - second_deg_) / 2) /
         half_cosine();
}

}  // namespace ehd::bearing
