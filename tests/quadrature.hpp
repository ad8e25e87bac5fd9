// SPDX-License-Identifier: GPL-3.0-or-later
// GSL's adaptive quadrature for smooth functions, for end singularities, for those with a logarithm and to infinity.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <functional>

#include "tests/check.hpp"

namespace ehd::testing {

using Function = std::function<double(double)>;

inline double call(double x, void* f) { return (*static_cast<Function*>(f))(x); }

/// Relative accuracy asked for; stopping at round-off is as good.
constexpr double asked_of_quadrature = 1e-13;

namespace detail {
template <class Rule>
double integrated(Function f, const Rule& rule) {
  gsl_function wrapped{.function = call, .params = &f};
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(2000);
  double value = 0, uncertainty = 0;
  gsl_error_handler_t* handler = gsl_set_error_handler_off();
  const int status = rule(&wrapped, workspace, &value, &uncertainty);
  gsl_set_error_handler(handler);
  gsl_integration_workspace_free(workspace);
  BOOST_REQUIRE(status == GSL_SUCCESS || status == GSL_EROUND);
  return value;
}
}  // namespace detail

/// Int_a^b f for a smooth f.
inline double smooth_integral(const Function& f, double a, double b) {
  return detail::integrated(f, [&](auto* g, auto* workspace, auto* value, auto* uncertainty) {
    return gsl_integration_qag(g, a, b, 1e-15, asked_of_quadrature, 2000, GSL_INTEG_GAUSS61, workspace, value,
                               uncertainty);
  });
}

/// Int_a^b f for an f with integrable singularities at the ends.
inline double singular_integral(const Function& f, double a, double b) {
  return detail::integrated(f, [&](auto* g, auto* workspace, auto* value, auto* uncertainty) {
    return gsl_integration_qags(g, a, b, 1e-15, asked_of_quadrature, 2000, workspace, value, uncertainty);
  });
}

/// Int_a^infinity f to a relative accuracy.
inline double integral_to_infinity(const Function& f, double a, double accuracy) {
  return detail::integrated(f, [&](auto* g, auto* workspace, auto* value, auto* uncertainty) {
    return gsl_integration_qagiu(g, a, 0, accuracy, 2000, workspace, value, uncertainty);
  });
}

/// Int_a^b f(t) ln|t - end| dt where `end` is a or b, f smooth.
inline double integral_with_log(const Function& f, double a, double b, double end) {
  if (b <= a) return 0;
  gsl_integration_qaws_table* table = gsl_integration_qaws_table_alloc(0, 0, end == a ? 1 : 0, end == b ? 1 : 0);
  const double value = detail::integrated(f, [&](auto* g, auto* workspace, auto* result, auto* uncertainty) {
    return gsl_integration_qaws(g, a, b, table, 1e-15, asked_of_quadrature, 2000, workspace, result, uncertainty);
  });
  gsl_integration_qaws_table_free(table);
  return value;
}

/// Int_a^b f(t) ln|v - t| dt for any v and an f that is smooth beyond a and b too. Beside the interval: as much again
/// beyond it, where the singularity is at an end.
inline double log_integral(const Function& f, double a, double b, double v) {
  if (v >= a && v <= b) return integral_with_log(f, a, v, v) + integral_with_log(f, v, b, v);
  const double near = 0.01 * (b - a);
  if (v > b && v - b < near) return integral_with_log(f, a, v, v) - integral_with_log(f, b, v, v);
  if (v < a && a - v < near) return integral_with_log(f, v, b, v) - integral_with_log(f, v, a, v);
  return smooth_integral([&](double t) { return f(t) * std::log(std::abs(v - t)); }, a, b);
}

}  // namespace ehd::testing
