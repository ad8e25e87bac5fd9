// SPDX-License-Identifier: GPL-3.0-or-later
// The harmonic response of one contact of a roller with a raceway: conditions in SI -> dimensionless problem ->
// response
// -> kappa, which the dynamics of a bearing needs.
#pragma once

#include <functional>
#include <vector>

#include "bearing/response_curve.hpp"
#include "contact/conditions.hpp"
#include "contact/response.hpp"

namespace ehd {

struct Problem;

using ContactResponder = std::function<Response(const Problem&, const ResponseRequest&)>;

/// The solver of responses that bearings use: the certified one. On NA4908 `fast` takes a seventh of its time, but it
/// knows the ring's damping to 3.6 %; 2 % is needed.
[[nodiscard]] ContactResponder bearing_responder();

/// Tolerance 1e-6: at the lowest frequency that is not slow, Omega = 0.01, damping is then known to some 1e-3.
[[nodiscard]] ResponseRequest bearing_response_request();

/// kappa of the contact at a load [N/m]: slow motion, and at the frequencies [rad/s]. A response that missed its
/// tolerance is taken with its stated errors.
[[nodiscard]] bearing::ResponseResult respond_bearing_contact(const bearing::RacewayContact& contact,
                                                              const Lubricant& lubricant, double load_N_per_m,
                                                              const std::vector<double>& omegas,
                                                              ResponseRequest request, const ContactResponder& respond);

}  // namespace ehd
