// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/unseen_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workflow/contact_memory.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

/// Shares of the lightest load. A curve is judged at a half, so that is not among them.
constexpr std::array unseen_shares = {0.93, 0.8, 0.65, 0.4, 0.3, 0.2, 0.12, 0.06, 0.03};
/// A hundredth of what the curve's own contacts are solved to.
constexpr double unseen_tolerance = 1e-6;

}  // namespace

UnseenContacts unseen_below(const bearing::FilmCurve& curve, const Lubricant& lubricant) {
  Request request = bearing_contact_request();
  request.tolerance = unseen_tolerance;
  ContactMemory memory(default_solver().solve, request);
  const bearing::SolvableContact contacts = memory.of(curve.contact(), lubricant);
  UnseenContacts unseen;
  for (const double share : unseen_shares) {
    const double force_N = share * curve.lightest_N();
    const bearing::ContactResult result = contacts.at(force_N);
    const auto* solved = std::get_if<bearing::SolvedContact>(&result);
    if (!solved) continue;
    const double offset_m = bearing::offset_film_m(curve.contact(), force_N, *solved);
    const double offset_error = bearing::relative_offset_error(*solved);
    const bearing::ValueAndSlope offset = curve.offset_film(force_N);
    const double of_offset = std::abs(std::log(offset.value / offset_m)) - offset_error;
    const double of_minimum =
        std::abs(std::log(curve.minimum_film(force_N).value / solved->film_minimum_m)) - solved->film_error;
    const double of_force = (std::abs(offset.value - offset_m) - offset_error * offset_m) / curve.rise_m(force_N);
    unseen.worst = std::max({unseen.worst, of_offset / curve.errors().joint, of_minimum / curve.errors().joint,
                             of_force / curve.errors().joint_force});
    ++unseen.contacts;
  }
  return unseen;
}

}  // namespace ehd::verification
