// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/text.hpp"

namespace ehd {

namespace {

/// How often the interval of ln Omega that holds the highest certified frequency is halved.
constexpr int halvings = 6;
/// Where no requested frequency is known, lower ones are tried, each 2^6 times lower than the one before. Omega = 1e9
/// takes four such steps to a flooded contact's 93.
constexpr double lower_by = 64;
constexpr int most_lower = 8;

bool is_known(const auto& at) { return at.status == StopReason::converged; }

/// 1/(chi - i Omega lag), with the errors of chi and lag, absolute.
Kappa kappa_of(double chi, double chi_error, double Omega, double lag, double lag_error) {
  const double delay = Omega * lag, size = chi * chi + delay * delay;
  const double by_own = std::abs(chi * chi - delay * delay) / (size * size),
               by_other = 2 * std::abs(chi) / (size * size);
  return {.stiffness = chi / size,
          .damping = lag / size,
          .stiffness_error = by_own * chi_error + by_other * Omega * std::abs(delay) * lag_error,
          .damping_error = by_own * lag_error + by_other * std::abs(lag) * chi_error};
}

/// "; kappa_1 is known to 1.3e-4 only": the numbers of slow motion that miss the tolerance. They have no row of their
/// own in the table of frequencies.
std::string missed_of(const SlowStiffness& slow, double tolerance) {
  std::string text;
  for (const auto& [name, error] : {std::pair("kappa_0", slow.error_0), std::pair("kappa_1", slow.error_1)}) {
    if (error <= tolerance) continue;
    text += std::isfinite(error) ? fmt::format("; {} is known to {} only", name, rounded_up(error, 2))
                                 : fmt::format("; {} is not known", name);
  }
  return text;
}

}  // namespace

Kappa in_series(const Stiffness& at, double compliance) {
  const std::complex<double> chi = 1.0 / at.kappa;
  Kappa kappa = kappa_of(chi.real() + compliance, at.error * std::abs(chi), at.Omega, at.lag(),
                         at.lag_error * std::abs(at.lag()));
  if (compliance == 0 && at.Omega > 0)  // Im kappa errs by no more than kappa
    kappa.damping_error = std::min(kappa.damping_error, at.error * std::abs(at.kappa) / at.Omega);
  return kappa;
}

Kappa in_series(const SlowStiffness& slow, double compliance) {
  if (compliance == 0)
    return {.stiffness = slow.kappa_0,
            .damping = slow.kappa_1,
            .stiffness_error = slow.error_0 * std::abs(slow.kappa_0),
            .damping_error = slow.error_1 * std::abs(slow.kappa_1)};
  return kappa_of(1 / slow.kappa_0 + compliance, slow.error_0 / std::abs(slow.kappa_0), 0, slow.lag,
                  slow.lag_error * std::abs(slow.lag));
}

void find_highest_certified(Response& found, double tolerance, const std::function<bool(double)>& certified,
                            const std::function<bool()>& spent, double resolved_up_to) {
  found.highest_certified.reset();
  if (!found.slow || !(found.slow->error_0 <= tolerance)) return;
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (const Stiffness& at : found.frequencies)
    if (!is_known(at)) high = std::min(high, at.Omega);
  for (const Stiffness& at : found.frequencies)
    if (is_known(at) && at.Omega < high) low = std::max(low, at.Omega);
  if (std::isfinite(high)) {
    const auto halve_at = [&](double Omega) { (certified(Omega) ? low : high) = Omega; };
    if (low < resolved_up_to && resolved_up_to < high && !spent()) halve_at(resolved_up_to);
    for (int k = 0; k < most_lower && low == 0 && !spent(); ++k) halve_at(high / lower_by);
    for (int k = 0; k < halvings && 0 < low && low < resolved_up_to && !spent(); ++k) halve_at(std::sqrt(low * high));
  }
  found.highest_certified = low;
}

void answer_nothing(Response& found, const ResponseRequest& request, StopReason status, std::string_view why) {
  found = {};
  for (const double Omega : request.frequencies) found.frequencies.push_back({.Omega = Omega, .status = status});
  for (const Waviness& waviness : request.waviness) found.waviness.push_back({.waviness = waviness, .status = status});
  found.status = status;
  found.reason = why;
}

void conclude(Response& found, double tolerance, bool spent, std::string_view why) {
  const auto known = [](const auto& at) { return is_known(at); };
  const std::string slow = found.slow ? missed_of(*found.slow, tolerance) : "; no slow motion was found";
  const bool kappa = std::all_of(found.frequencies.begin(), found.frequencies.end(), known);
  const bool all = slow.empty() && kappa && std::all_of(found.waviness.begin(), found.waviness.end(), known);
  found.status = all ? StopReason::converged : spent ? StopReason::limit_reached : StopReason::tolerance_not_met;
  if (!all) found.reason = fmt::format("{}{}", why, slow);
  if (!kappa && found.highest_certified)
    found.reason +=
        fmt::format("; kappa is certified up to Omega = {} at least", rounded_down(*found.highest_certified, 3));
}

}  // namespace ehd
