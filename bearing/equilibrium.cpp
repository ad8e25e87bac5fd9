// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/careful_sum.hpp"
#include "bearing/ring_search.hpp"
#include "contact/text.hpp"

namespace ehd::bearing {

namespace {

Place find_place(Ring& ring, const LawPair& laws, const Loading& loading) {
  if (loading.radial_N > 0)
    return ring.plane() ? balance_in_the_plane(ring, loading) : balance_along_the_load(ring, laws, loading);
  // Without a load equally spaced rollers hold the ring in the middle; with clearance it may stand anywhere near.
  Place middle;
  middle.state = ring.at(middle.v);
  return middle;
}

/// Displacement, and what the search cost.
Equilibrium at_place(const Ring& ring, const Place& place) {
  Equilibrium result;
  const Vector2 displacement = ring.displacement_m(place.v);
  result.displacement_m = displacement.x;
  result.lateral_displacement_m = displacement.y;
  if (ring.counts_from_touch()) result.position.touching_deg = std::pair{ring.first_deg(), ring.second_deg()};
  result.position.beyond_x_m = place.v.x;
  result.position.beyond_y_m = place.v.y;
  result.azimuths_deg = ring.azimuths();
  result.groups = static_cast<int>(ring.groups().size());
  result.newton_iterations = ring.evaluations();
  result.rollers_balanced = static_cast<long>(result.groups) * result.newton_iterations;
  return result;
}

/// Every roller from its group. Returns the largest error of a roller's own balance [N].
double put_rollers(Equilibrium& result, const Ring& ring, const Place& place) {
  result.rollers.resize(result.azimuths_deg.size());
  double worst_N = 0;
  for (std::size_t g = 0; g < ring.groups().size(); ++g) {
    const Ring::Group& group = ring.groups()[g];
    worst_N = std::max(worst_N, ring.roller().error_N(place.state.groups[g], ring.excess_m(group, place.v)));
    for (const int member : group.members) result.rollers[static_cast<std::size_t>(member)] = place.state.groups[g];
  }
  return worst_N;
}

struct Sums {
  double along_N = 0, across_N = 0;  ///< Sum f_i cos psi, Sum f_i sin psi
  double outer_N = 0;                ///< Sum f_o
};

/// Over all rollers, each in its own direction. Puts the stiffness and the force across.
Sums put_sums(Equilibrium& result) {
  CarefulSum along, across, outer;
  for (std::size_t j = 0; j < result.rollers.size(); ++j) {
    const RollerState& roller = result.rollers[j];
    const double cosine = cosine_of_degrees(result.azimuths_deg[j]), sine = sine_of_degrees(result.azimuths_deg[j]);
    along.add(roller.inner.force_N * cosine);
    across.add(roller.inner.force_N * sine);
    outer.add(roller.outer.force_N);
    result.stiffness_N_per_m[0][0] += roller.stiffness_N_per_m * cosine * cosine;
    result.stiffness_N_per_m[0][1] += roller.stiffness_N_per_m * cosine * sine;
    result.stiffness_N_per_m[1][1] += roller.stiffness_N_per_m * sine * sine;
  }
  result.stiffness_N_per_m[1][0] = result.stiffness_N_per_m[0][1];
  result.lateral_force_N = across.value();
  return {along.value(), across.value(), outer.value()};
}

std::optional<std::string> refusal_of_a_law(const LawPair& laws, const Equilibrium& result) {
  double inner_N = 0, outer_N = 0;
  for (const RollerState& roller : result.rollers) {
    inner_N = std::max(inner_N, roller.inner.force_N);
    outer_N = std::max(outer_N, roller.outer.force_N);
  }
  if (auto refused = refusal(laws.inner, inner_N)) return refused;
  return refusal(laws.outer, outer_N);
}

}  // namespace

std::string_view to_string(Form form) { return form == Form::plane ? "plane" : "radial"; }

std::variant<Equilibrium, NoEquilibrium> balance(const Geometry& geometry, const LawPair& laws, const Loading& loading,
                                                 Form form) {
  const double load = loading.radial_N;
  if (!(load >= 0) || !std::isfinite(load))
    return NoEquilibrium{"the radial load is " + plain(load) + " N; it must be finite and not negative"};
  Ring ring(geometry, laws, loading, form);
  if (load > 0 && !ring.can_carry())
    return NoEquilibrium{ring.plane()
                             ? "no two rollers stand less than a half turn apart with the load between them, so "
                               "nothing can carry it"
                             : "no roller stands on the loaded side, so nothing can carry the load"};

  const Place place = find_place(ring, laws, loading);
  Equilibrium result = at_place(ring, place);
  if (place.state.groups.empty() || !is_finite(place.state.force_N))
    return NoEquilibrium{fmt::format("roller forces are not finite at a displacement of {} m (load {} N)",
                                     plain(result.displacement_m), plain(load))};

  // A result that is returned balances: all rollers, each in its own direction.
  double worst_N = put_rollers(result, ring, place);
  const Sums sums = put_sums(result);
  worst_N = std::max(worst_N, std::abs(sums.along_N - load));
  if (form == Form::plane) worst_N = std::max(worst_N, std::abs(sums.across_N));
  const double scale = std::max(load, sums.outer_N);
  result.balance_error = scale > 0 ? worst_N / scale : 0;
  if (!(result.balance_error <= largest_balance_error)) {
    const bool jump = ring.plane() && (jumps(laws.inner) || jumps(laws.outer));
    return NoEquilibrium{fmt::format(
        "the forces balance only to {} of the larger of load and roller forces, {} N{}", plain(result.balance_error),
        plain(scale),
        jump ? "; rollers on the jump of a law that is cut at delta = 0 are balanced in the radial form only" : "")};
  }
  if (const auto refused = refusal_of_a_law(laws, result)) return NoEquilibrium{*refused};
  return result;
}

bool is_loaded(double force_N, double largest_N) { return force_N > 0 && force_N >= loaded_share * largest_N; }

std::optional<std::pair<double, double>> load_zone_deg(const Equilibrium& equilibrium) {
  double largest_N = 0;
  for (const RollerState& roller : equilibrium.rollers) largest_N = std::max(largest_N, roller.inner.force_N);
  if (!(largest_N > 0)) return std::nullopt;
  std::pair<double, double> zone{180, -180};
  for (std::size_t j = 0; j < equilibrium.rollers.size(); ++j) {
    if (!is_loaded(equilibrium.rollers[j].inner.force_N, largest_N)) continue;
    zone.first = std::min(zone.first, equilibrium.azimuths_deg[j]);
    zone.second = std::max(zone.second, equilibrium.azimuths_deg[j]);
  }
  return zone;
}

}  // namespace ehd::bearing
