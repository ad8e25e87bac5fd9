// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/fit.hpp"

#include <fmt/format.h>
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

namespace {

/// y = constant + slope x, with the covariance of both.
struct Line {
  double constant = 0, slope = 0;
  double constant_variance = 0, covariance = 0, slope_variance = 0;
  double squares = 0;  ///< Sum (y_k - constant - slope x_k)^2
};

Line least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  Line line;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.constant, &line.slope, &line.constant_variance,
                 &line.covariance, &line.slope_variance, &line.squares);
  return line;
}

/// x = -constant/slope + y/slope; the covariance to first order.
Line turned(const Line& line) {
  const double c = line.constant, s = line.slope;
  return {.constant = -c / s,
          .slope = 1 / s,
          .constant_variance =
              (line.constant_variance - 2 * c / s * line.covariance + c * c / (s * s) * line.slope_variance) / (s * s),
          .covariance = (line.covariance - c / s * line.slope_variance) / (s * s * s),
          .slope_variance = line.slope_variance / (s * s * s * s),
          .squares = line.squares / (s * s)};
}

bool all_equal(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

}  // namespace

LinearFit fit_line(const std::vector<FitPoint>& points, FitOf of) {
  std::vector<double> approaches, forces;
  for (const FitPoint& point : points) {
    approaches.push_back(point.approach_m);
    forces.push_back(point.force_N);
  }
  if (points.size() < 2 || all_equal(approaches) || all_equal(forces))
    throw std::invalid_argument("fit_line: " + std::to_string(points.size()) +
                                " points; a line needs at least two of different approach and force");
  const Line line = of == FitOf::force ? least_squares(approaches, forces) : turned(least_squares(forces, approaches));
  if (!(line.slope > 0))
    throw std::invalid_argument("fit_line: the slope is " + plain(line.slope) +
                                " N/m; a contact force increases with the approach");
  LinearFit fit;
  fit.K_N_per_m = line.slope;
  fit.dF_N = line.constant;
  for (const FitPoint& point : points)
    fit.residual_N = std::max(fit.residual_N, std::abs(point.force_N - (fit.K_N_per_m * point.approach_m + fit.dF_N)));
  if (points.size() > 2) {  // two points leave no residual to estimate a covariance from
    fit.standard_deviation_N = std::sqrt(line.squares / static_cast<double>(points.size() - 2));
    fit.K_deviation_N_per_m = std::sqrt(line.slope_variance);
    fit.dF_deviation_N = std::sqrt(line.constant_variance);
    if (line.slope_variance > 0 && line.constant_variance > 0)
      fit.correlation = line.covariance / std::sqrt(line.slope_variance * line.constant_variance);
  }
  fit.points = points;
  fit.of = of;
  return fit;
}

// With means d_m, f_m of the points, S = Sum (d_k - d_m)^2 and K = Sum (d_k - d_m)(f_k - f_m)/S. Errors e_k of the d_k
// change
//   the slope by        dK = Sum [f_k - f_m - 2 K (d_k - d_m)] e_k/S,
//   the approach at f by  d(delta) = Sum e_k/n + (d_m - delta) dK/K.
// A fit of delta on f is linear in the d_k, with F = Sum (f_k - f_m)^2:
//   d(delta) = Sum [1/n + (f - f_m)(f_k - f_m)/F] e_k.
double LinearFit::approach_error_m(double force_N) const {
  const auto n = static_cast<double>(points.size());
  double mean_m = 0, mean_N = 0, squares_m = 0, squares_N = 0, error_m = 0;
  for (const FitPoint& point : points) {
    mean_m += point.approach_m / n;
    mean_N += point.force_N / n;
  }
  for (const FitPoint& point : points) {
    squares_m += (point.approach_m - mean_m) * (point.approach_m - mean_m);
    squares_N += (point.force_N - mean_N) * (point.force_N - mean_N);
  }
  const double from_mean_m = mean_m - (force_N - dF_N) / K_N_per_m;
  for (const FitPoint& point : points) {
    const double from_N = point.force_N - mean_N;
    const double slope = (from_N - 2 * K_N_per_m * (point.approach_m - mean_m)) / squares_m;
    const double moved = of == FitOf::force ? from_mean_m * slope / K_N_per_m : (force_N - mean_N) * from_N / squares_N;
    error_m += std::abs(1 / n + moved) * point.approach_error_m;
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
                                                   double highest_N, int points, FitOf of) {
  std::vector<FitPoint> solved;
  for (const double force_N : fit_forces_N(lowest_N, highest_N, points)) {
    const ContactResult result = contacts.at(force_N);
    if (const auto* failure = std::get_if<SolveFailure>(&result)) {
      return SolveFailure{.why = fmt::format("at a contact force of {} N: {}", plain(force_N, 4), failure->why),
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
  return fit_line(solved, of);
}

}  // namespace ehd::bearing
