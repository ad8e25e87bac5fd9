// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/numerics.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <limits>
#include <memory>
#include <new>

namespace ehd::verification::exact {

namespace {

using Function = std::function<double(double)>;

constexpr double asked = 2e-14,  // GSL refuses less than 50 eps
    granted_relative = 1e-13, granted_absolute = 1e-15;
constexpr std::size_t most_intervals = 1000;
/// Brent's method takes some ten steps; bisection alone would take about 60.
constexpr int most_root_steps = 200;

double call(double x, void* function) { return (*static_cast<const Function*>(function))(x); }

gsl_function wrap(const Function& f) { return {.function = call, .params = const_cast<Function*>(&f)}; }

double judged(int status, double value, double estimate) {
  // Rounding may stop the adaptive rule before the requested error. The reached error counts.
  const bool ran = status == GSL_SUCCESS || status == GSL_EROUND || status == GSL_EMAXITER;
  return ran && estimate <= granted_relative * std::abs(value) + granted_absolute
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

/// GSL returns null where memory is lacking.
template <class Made>
Made* allocated(Made* made) {
  if (!made) throw std::bad_alloc();
  return made;
}

using Workspace = std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)>;

Workspace workspace(std::size_t intervals) {
  return {allocated(gsl_integration_workspace_alloc(intervals)), gsl_integration_workspace_free};
}

enum class LogAt { left, right };

constexpr double granted = 1e-13;  ///< absolute
/// GSL gives up on an interval of a few ulps. Its integral is below `granted`: about 1e-15 ln 1e-15.
constexpr double shortest = 1e-15;
constexpr std::size_t qaws_intervals = 200;

/// Int_a^b f(t) ln(t - a) dt or Int_a^b f(t) ln(b - t) dt.
double log_integral(const Function& f, double a, double b, LogAt end) {
  if (!(b - a > shortest)) return 0;
  keep_going_on_gsl_errors();
  const bool left = end == LogAt::left;
  const std::unique_ptr<gsl_integration_qaws_table, decltype(&gsl_integration_qaws_table_free)> weight(
      allocated(gsl_integration_qaws_table_alloc(0, 0, left ? 1 : 0, left ? 0 : 1)), gsl_integration_qaws_table_free);
  const Workspace space = workspace(qaws_intervals);
  gsl_function integrand = wrap(f);
  double value = 0, estimate = 0;
  const int status =
      gsl_integration_qaws(&integrand, a, b, weight.get(), granted, 0, qaws_intervals, space.get(), &value, &estimate);
  return status == GSL_SUCCESS && estimate <= granted ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void keep_going_on_gsl_errors() { [[maybe_unused]] static const auto once = gsl_set_error_handler_off(); }

double integral(const Function& f, double a, double b) {
  keep_going_on_gsl_errors();
  gsl_function integrand = wrap(f);
  const Workspace space = workspace(most_intervals);
  double value = 0, estimate = 0;
  const int status = gsl_integration_qags(&integrand, a, b, 0, asked, most_intervals, space.get(), &value, &estimate);
  return judged(status, value, estimate);
}

double integral_to_infinity(const Function& f, double a) {
  keep_going_on_gsl_errors();
  gsl_function integrand = wrap(f);
  const Workspace space = workspace(most_intervals);
  double value = 0, estimate = 0;
  const int status = gsl_integration_qagiu(&integrand, a, 0, asked, most_intervals, space.get(), &value, &estimate);
  return judged(status, value, estimate);
}

/// Beyond b the integral goes on to X, and the part beyond b is subtracted: so the logarithm is singular at an end
/// point only.
double log_potential(const Function& f, double a, double b, double X) {
  if (X <= b) return log_integral(f, a, X, LogAt::right) + log_integral(f, X, b, LogAt::left);
  return log_integral(f, a, X, LogAt::right) - log_integral(f, b, X, LogAt::right);
}

double root(const Function& f, double a, double b) {
  keep_going_on_gsl_errors();
  gsl_function function = wrap(f);
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      allocated(gsl_root_fsolver_alloc(gsl_root_fsolver_brent)), gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, a, b) != GSL_SUCCESS)
    return std::numeric_limits<double>::quiet_NaN();
  constexpr double precision = 4 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < most_root_steps; ++step) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()), 0,
                               precision) == GSL_SUCCESS)
      return gsl_root_fsolver_root(solver.get());
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ehd::verification::exact
