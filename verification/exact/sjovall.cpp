// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/sjovall.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <new>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/text.hpp"
#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

namespace {

using std::numbers::pi;

struct Integrand {
  double eps, exponent, limit;
};

/// With psi = psi_l (1 - s^2) the zero of power n at the edge of the load zone becomes one of power 2n + 1, which is
/// smooth enough for the quadrature.
double integrand(double s, void* parameters) {
  const auto& of = *static_cast<const Integrand*>(parameters);
  const double psi = of.limit * (1 - s * s), half = std::sin(psi / 2);
  const double share = 1 - half * half / of.eps;
  return share > 0 ? std::pow(share, of.exponent) * std::cos(psi) * 2 * of.limit * s : 0;
}

}  // namespace

double SjovallIntegral::operator()(double eps) const {
  if (!(eps > 0)) throw std::domain_error(fmt::format("Sjovall integral: eps = {}; it must be positive", plain(eps)));
  Integrand of{eps, exponent, eps < 1 ? std::acos(1 - 2 * eps) : pi};
  gsl_function function{integrand, &of};
  constexpr std::size_t intervals = 1000;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  if (!workspace) throw std::bad_alloc();
  double value = 0, estimated = 0;
  keep_going_on_gsl_errors();
  const int status =
      gsl_integration_qag(&function, 0, 1, 0, 1e-13, intervals, GSL_INTEG_GAUSS61, workspace.get(), &value, &estimated);
  // At large eps the integral is a small difference. GSL then reports round-off with a good value.
  if (status != GSL_SUCCESS && !(estimated <= 1e-12 * std::abs(value)))
    throw std::runtime_error(std::string("Sjovall integral: ") + gsl_strerror(status));
  return value / pi;
}

}  // namespace ehd::verification::exact
