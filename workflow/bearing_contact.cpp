// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"

namespace ehd {

using bearing::RacewayContact;
using bearing::SolvedContact;
using bearing::SolveFailure;

namespace {

/// Relative error of films that a contact force law needs.
constexpr double needed_tolerance = 1e-3;
/// A contact force depends on the offset film. No tolerance can be asked of that film, but the error of the central
/// film is close to its own. So the central film is asked for to a tenth of what a law needs. The smallest film is only
/// reported.
constexpr FilmTolerances first_tolerance{needed_tolerance, 0.1 * needed_tolerance};
/// A contact whose offset film is known less well than this is no solution for a bearing.
constexpr double largest_offset_error = 1e-2;
/// A film that is a small part of the approach need not be known as well as one that is all of it. So the error is
/// compared with the dry approach (x_0 = l) over this number, where that is larger than the film.
constexpr double dry_approach_over_film = 10;

/// The offset film of a solution and the length that its error is compared with, in Hertz units.
struct OffsetFilm {
  double film = 0, compared_with = 0, error = 0;
  [[nodiscard]] bool known_to(double share) const { return error <= share * compared_with; }
};

OffsetFilm offset_film_of(const Reading& offset, const RacewayContact& contact, double force_N, double half_width_m) {
  const double dry_offset =
      dry_approach_m(contact.at(force_N), contact.length_m) * contact.reduced_radius_m / (half_width_m * half_width_m);
  const double film = offset.value - hertz::dry_offset();
  return {.film = film, .compared_with = std::max(film, dry_offset / dry_approach_over_film), .error = *offset.error};
}

const Reading* with_error(const Observables& observables, Quantity quantity) {
  const auto found = observables.find(quantity);
  return found != observables.end() && found->second.error ? &found->second : nullptr;
}

}  // namespace

Request bearing_contact_request() {
  Request request;
  request.tolerance = first_tolerance;
  return request;
}

// A pressure spike near X = 0 disturbs the central film. The finer grids of the first tolerance may then give larger
// errors than the coarser ones of the second.
ContactSolver with_fallback(ContactSolver solver) {
  return [solver = std::move(solver)](const Problem& problem, const Request& request) {
    Solution solution = solver(problem, request);
    if (solution.record.status != StopReason::tolerance_not_met) return solution;
    if (!request.tolerance.any() || request.tolerance.tightest() >= needed_tolerance) return solution;
    Request less = request;
    less.tolerance = needed_tolerance;
    Solution again = solver(problem, less);
    return again.record.status == StopReason::converged ? again : solution;
  };
}

bearing::ContactResult solve_bearing_contact(const RacewayContact& contact, const Lubricant& lubricant,
                                             double load_N_per_m, const Request& request, ContactCache& cache) {
  const double force_N = load_N_per_m * contact.length_m;
  const Conditions conditions = contact.at(force_N);
  Nondimensional reading;
  try {
    reading = nondimensionalise(conditions, lubricant, Flooded{});
  } catch (const StatementError& error) {
    return SolveFailure{.why = error.what()};
  }
  reading.problem.wanted = {Quantity::film_minimum, Quantity::film_central, Quantity::film_offset,
                            Quantity::rolling_force};
  const KeptSolution solution = cache.solve(reading.problem, request);

  const Groups& groups = reading.problem.groups;
  const auto failed = [&](const std::string& why) {
    return SolveFailure{.why = fmt::format("M = {}, L = {}: {}", plain(groups.M, 4), plain(groups.L, 4), why),
                        .limit = solution.status == StopReason::limit_reached};
  };
  if (solution.status != StopReason::converged && solution.status != StopReason::tolerance_not_met)
    return failed(fmt::format("{}{}", to_string(solution.status),
                              solution.reason.empty() ? "" : fmt::format(" ({})", solution.reason)));
  const Reading* film = with_error(solution.observables, Quantity::film_minimum);
  const Reading* offset = with_error(solution.observables, Quantity::film_offset);
  if (!film || !offset) return failed("the solver gives no film.minimum or film.offset with an error");
  const OffsetFilm known = offset_film_of(*offset, contact, force_N, hertz::half_width_m(conditions));
  if (!known.known_to(largest_offset_error))
    return failed(fmt::format(
        "the relative error of the offset film is {}, and its absolute error is more than {} of the approach",
        plain(known.error / known.film, 2), plain(largest_offset_error / dry_approach_over_film)));
  const bool good_enough = *film->error <= needed_tolerance && known.known_to(needed_tolerance);
  const Reading* rolling = with_error(solution.observables, Quantity::rolling_force);
  const double b = hertz::half_width_m(conditions), rolling_unit = hertz::pressure_Pa(conditions) * b * b;
  return SolvedContact{
      .offset = offset->value,
      .offset_error = *offset->error,
      .film_minimum_m = film->value * *reading.scales->film_m_per_hertz_film(),
      .film_error = *film->error,
      .rolling_force_N_per_m =
          rolling ? std::optional(rolling->value * rolling_unit / conditions.reduced_radius_m) : std::nullopt,
      .rolling_error = rolling ? *rolling->error : 0,
      .converged = solution.status == StopReason::converged || good_enough};
}

}  // namespace ehd
