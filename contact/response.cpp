// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/text.hpp"

namespace ehd {

namespace {

/// Of the interval, in ln Omega, that holds the highest certified frequency.
constexpr int halvings = 6;

bool is_known(const auto& at) { return at.status == StopReason::converged; }

}  // namespace

void find_highest_certified(Response& found, double tolerance, const std::function<bool(double)>& certified,
                            const std::function<bool()>& spent) {
  found.highest_certified.reset();
  if (!found.slow || !(found.slow->error_0 <= tolerance)) return;
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (const Stiffness& at : found.frequencies)
    if (!is_known(at)) high = std::min(high, at.Omega);
  for (const Stiffness& at : found.frequencies)
    if (is_known(at) && at.Omega < high) low = std::max(low, at.Omega);
  if (std::isfinite(high)) {
    double bottom = low > 0 ? low : high * std::exp2(-2 * halvings);
    for (int k = 0; k < halvings && !spent(); ++k) {
      const double middle = std::sqrt(bottom * high);
      const bool known = certified(middle);
      (known ? bottom : high) = middle;
      if (known) low = middle;
    }
  }
  found.highest_certified = low;
}

void conclude(Response& found, double tolerance, bool spent, std::string_view why) {
  const auto known = [](const auto& at) { return is_known(at); };
  const bool slow = found.slow && found.slow->error_0 <= tolerance && found.slow->error_1 <= tolerance;
  const bool kappa = std::all_of(found.frequencies.begin(), found.frequencies.end(), known);
  const bool all = slow && kappa && std::all_of(found.waviness.begin(), found.waviness.end(), known);
  found.status = all ? StopReason::converged : spent ? StopReason::limit_reached : StopReason::tolerance_not_met;
  if (!all) found.reason = why;
  if (!kappa && found.highest_certified)
    found.reason += "; kappa is certified up to Omega = " + plain(*found.highest_certified, 3);
}

}  // namespace ehd
