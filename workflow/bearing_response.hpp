// SPDX-License-Identifier: GPL-3.0-or-later
// The harmonic response of one contact of a roller with a raceway: conditions in SI -> dimensionless problem ->
// response -> kappa, which the dynamics of a bearing needs.
#pragma once

#include <functional>
#include <vector>

#include "bearing/response_curve.hpp"
#include "contact/conditions.hpp"
#include "contact/response.hpp"

namespace ehd {

struct Problem;

using ContactResponder = std::function<Response(const Problem&, const ResponseRequest&)>;

/// The solver of responses that bearings use: the default one where it states a compliance and a lag to 1 %, else the
/// certified one, which takes a hundred times as long.
[[nodiscard]] ContactResponder bearing_responder();

/// Tolerance 5e-3.
[[nodiscard]] ResponseRequest bearing_response_request();

/// kappa of the contact at a load [N/m]: slow motion, and at the frequencies [rad/s]. A response that missed its
/// tolerance is taken with its stated errors.
[[nodiscard]] bearing::ResponseResult respond_bearing_contact(const bearing::RacewayContact& contact,
                                                              const Lubricant& lubricant, double load_N_per_m,
                                                              const std::vector<double>& omegas,
                                                              ResponseRequest request, const ContactResponder& respond);

}  // namespace ehd
