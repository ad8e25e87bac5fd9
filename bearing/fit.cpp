// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/fit.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/text.hpp"

namespace ehd::bearing {

LinearLaw LinearFit::law(Unloading unloading) const {
  return {.K_N_per_m = K_N_per_m,
          .dF_N = dF_N,
          .unloading = unloading,
          .fitted_N = {points.front().force_N, points.back().force_N}};
}

LinearFit fit_line(const std::vector<FitPoint>& points) {
  std::vector<double> approaches, forces;
  for (const FitPoint& point : points) {
    approaches.push_back(point.approach_m);
    forces.push_back(point.force_N);
  }
  if (points.size() < 2 || *std::min_element(approaches.begin(), approaches.end()) ==
                               *std::max_element(approaches.begin(), approaches.end()))
    throw std::invalid_argument("fit_line: " + std::to_string(points.size()) +
                                " points; a line needs at least two of different approach");
  LinearFit fit;
  double variance_dF = 0, covariance = 0, variance_K = 0, squares = 0;
  gsl_fit_linear(approaches.data(), 1, forces.data(), 1, points.size(), &fit.dF_N, &fit.K_N_per_m, &variance_dF,
                 &covariance, &variance_K, &squares);
  if (!(fit.K_N_per_m > 0))
    throw std::invalid_argument("fit_line: the slope is " + std::to_string(fit.K_N_per_m) +
                                " N/m; a contact force increases with the approach");
  for (const FitPoint& point : points)
    fit.residual_N = std::max(fit.residual_N, std::abs(point.force_N - (fit.K_N_per_m * point.approach_m + fit.dF_N)));
  if (points.size() > 2) {  // two points leave no residual to estimate a covariance from
    fit.standard_deviation_N = std::sqrt(squares / static_cast<double>(points.size() - 2));
    fit.K_deviation_N_per_m = std::sqrt(variance_K);
    fit.dF_deviation_N = std::sqrt(variance_dF);
    if (variance_K > 0 && variance_dF > 0) fit.correlation = covariance / std::sqrt(variance_K * variance_dF);
  }
  fit.points = points;
  return fit;
}

// With means d_m, f_m of the points, S = Sum (d_k - d_m)^2 and K = Sum (d_k - d_m)(f_k - f_m)/S. Errors e_k of the d_k
// change
//   the slope by        dK = Sum [f_k - f_m - 2 K (d_k - d_m)] e_k/S,
//   the approach at f by  d(delta) = Sum e_k/n + (d_m - delta) dK/K.
double LinearFit::approach_error_m(double force_N) const {
  const auto n = static_cast<double>(points.size());
  double mean_m = 0, mean_N = 0, squares = 0, error_m = 0;
  for (const FitPoint& point : points) {
    mean_m += point.approach_m / n;
    mean_N += point.force_N / n;
  }
  for (const FitPoint& point : points) squares += (point.approach_m - mean_m) * (point.approach_m - mean_m);
  const double from_mean_m = mean_m - (force_N - dF_N) / K_N_per_m;
  for (const FitPoint& point : points) {
    const double slope = (point.force_N - mean_N - 2 * K_N_per_m * (point.approach_m - mean_m)) / squares;
    error_m += std::abs(1 / n + from_mean_m * slope / K_N_per_m) * point.approach_error_m;
  }
  return error_m;
}

std::vector<double> fit_forces_N(double lowest_N, double highest_N, int points) {
  std::vector<double> forces;
  forces.reserve(static_cast<std::size_t>(std::max(points, 0)));
  for (int k = 0; k < points; ++k)
    forces.push_back(points == 1 ? lowest_N : lowest_N + (highest_N - lowest_N) * k / (points - 1));
  return forces;
}

std::variant<LinearFit, SolveFailure> fit_contacts(const SolvableContact& contacts, double datum_m, double lowest_N,
                                                   double highest_N, int points) {
  std::vector<FitPoint> solved;
  for (const double force_N : fit_forces_N(lowest_N, highest_N, points)) {
    const ContactResult result = contacts.at(force_N);
    if (const auto* failure = std::get_if<SolveFailure>(&result)) {
      return SolveFailure{.why = "at a contact force of " + plain(force_N, 4) + " N: " + failure->why,
                          .limit = failure->limit};
    }
    const auto& contact = std::get<SolvedContact>(result);
    const Conditions conditions = contacts.contact.at(force_N);
    const double b = hertz::half_width_m(conditions);
    solved.push_back({.force_N = force_N,
                      .approach_m = approach_m(conditions, contact.offset, datum_m),
                      .approach_error_m = b * b / contacts.contact.reduced_radius_m * contact.offset_error,
                      .converged = contact.converged});
  }
  return fit_line(solved);
}

}  // namespace ehd::bearing
