// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/numerics.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <limits>
#include <memory>

namespace ehd::verification::exact {

namespace {

using Function = std::function<double(double)>;

constexpr double asked = 2e-14,  // GSL refuses less than 50 eps
    granted_relative = 1e-13, granted_absolute = 1e-15;
constexpr std::size_t most_intervals = 1000;

double call(double x, void* function) { return (*static_cast<const Function*>(function))(x); }

/// By default GSL aborts the program. Here every status is checked instead.
void keep_going_on_gsl_errors() { [[maybe_unused]] static const auto once = gsl_set_error_handler_off(); }

gsl_function wrap(const Function& f) { return {.function = call, .params = const_cast<Function*>(&f)}; }

double judged(int status, double value, double estimate) {
  // Rounding may stop the adaptive rule before the requested error. The reached error counts.
  const bool ran = status == GSL_SUCCESS || status == GSL_EROUND || status == GSL_EMAXITER;
  return ran && estimate <= granted_relative * std::abs(value) + granted_absolute
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

using Workspace = std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)>;

Workspace workspace() { return {gsl_integration_workspace_alloc(most_intervals), gsl_integration_workspace_free}; }

}  // namespace

double integral(const Function& f, double a, double b) {
  keep_going_on_gsl_errors();
  gsl_function integrand = wrap(f);
  const Workspace space = workspace();
  double value = 0, estimate = 0;
  const int status = gsl_integration_qags(&integrand, a, b, 0, asked, most_intervals, space.get(), &value, &estimate);
  return judged(status, value, estimate);
}

double integral_to_infinity(const Function& f, double a) {
  keep_going_on_gsl_errors();
  gsl_function integrand = wrap(f);
  const Workspace space = workspace();
  double value = 0, estimate = 0;
  const int status = gsl_integration_qagiu(&integrand, a, 0, asked, most_intervals, space.get(), &value, &estimate);
  return judged(status, value, estimate);
}

double root(const Function& f, double a, double b) {
  keep_going_on_gsl_errors();
  gsl_function function = wrap(f);
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, a, b) != GSL_SUCCESS)
    return std::numeric_limits<double>::quiet_NaN();
  constexpr double precision = 4 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < 200; ++step) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()), 0,
                               precision) == GSL_SUCCESS)
      return gsl_root_fsolver_root(solver.get());
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ehd::verification::exact
