// SPDX-License-Identifier: GPL-3.0-or-later
// The problems that the tests of this folder solve, and what they read off a solution.
#pragma once

#include <cmath>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/solver.hpp"
#include "tests/check.hpp"

namespace ehd::testing {

inline Problem roelands_problem(MoesGroups moes, const Inlet& inlet, DensityLaw density, double alpha_per_Pa, double z,
                                double p0_Pa) {
  const Lubricant oil{
      .viscosity = ViscosityLaw::roelands, .density = density, .alpha_per_Pa = alpha_per_Pa, .z = z, .p0_Pa = p0_Pa};
  return nondimensionalise(moes, oil, inlet).problem;
}

/// Roelands z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa with Dowson-Higginson density: the data of the table of
/// films computed independently with high-order collocation.
inline Problem roelands_problem(double M, double L, Inlet inlet) {
  return roelands_problem({M, L}, inlet, DensityLaw::dowson_higginson, 2.2e-8, 0.68, 1.96e8);
}

/// Data that cannot be mistaken for another's: Roelands z = 0.55 and the second Dowson-Higginson form.
inline Problem distinct_problem(double M, double L, Inlet inlet) {
  return roelands_problem({M, L}, inlet, DensityLaw::dowson_higginson_1977, 1.7e-8, 0.55, 1.8e8);
}

/// Barus and incompressible; isoviscous where L = 0.
inline Problem barus_problem(double M, double L, Inlet inlet) {
  return nondimensionalise(MoesGroups{M, L}, Lubricant{}, inlet).problem;
}

[[nodiscard]] inline double value(const Solution& solution, Quantity quantity) {
  return solution.observables.at(quantity).value;
}
/// A number is within the error that the solution states for it. `truth`: with at least two digits more.
inline void check_stated(const Solution& solution, Quantity quantity, double truth) {
  const Reading& reading = solution.observables.at(quantity);
  const double unit = has_absolute_error(quantity) ? 1 : std::abs(truth);
  BOOST_TEST_CONTEXT(to_string(quantity))
  EHD_CHECK(std::abs(reading.value - truth) / unit, verification::Tolerance::stated(reading.error.value()));
}
[[nodiscard]] inline double stated_error(const Solution& solution, Quantity quantity) {
  return solution.observables.at(quantity).error.value();
}

/// Request of one grid.
inline Request on_nodes(int nodes) {
  Request request;
  request.tolerance = {};
  request.nodes = nodes;
  return request;
}

inline Request within(double tolerance) {
  Request request;
  request.tolerance = tolerance;
  return request;
}

/// Slope of ln(error) on ln(1/n) by least squares, n doubling: the observed order.
inline double fitted_order(const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto count = static_cast<double>(errors.size());
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double x = static_cast<double>(k) * std::log(2.0), y = -std::log(errors[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

}  // namespace ehd::testing
