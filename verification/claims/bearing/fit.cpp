// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the straight line of the law ehd-linear, its points, and the rollers balanced with it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/studies/fits.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

namespace {

/// Of the fitted line against the least squares of f on delta, done here again.
struct LineErrors {
  double line = nothing, spread = nothing, correlation = nothing;
};
LineErrors errors_of_line(const bearing::LinearFit& fit, const std::vector<double>& approaches_m,
                          const std::vector<double>& forces_N) {
  LineErrors errors;
  const auto sum = [](const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0); };
  const double n = static_cast<double>(forces_N.size()), K = slope(approaches_m, forces_N),
               dF = (sum(forces_N) - K * sum(approaches_m)) / n;
  errors.line = worse(std::abs(fit.K_N_per_m / K - 1), std::abs(fit.dF_N / dF - 1));
  double largest = 0, squares = 0;
  for (const auto& point : fit.points) {
    const double off = point.force_N - (K * point.approach_m + dF);
    largest = std::max(largest, std::abs(off));
    squares += off * off;
  }
  errors.spread = worse(std::abs(fit.residual_N / largest - 1),
                        std::abs(fit.standard_deviation_N / std::sqrt(squares / (n - 2)) - 1));
  // Two lines through the points that differ in K turn about their middle: where that lies at delta > 0, a larger K
  // has a smaller dF.
  double square_sum = 0;
  for (const double approach_m : approaches_m) square_sum += approach_m * approach_m;
  errors.correlation = std::abs(fit.correlation + sum(approaches_m) / std::sqrt(n * square_sum));
  return errors;
}

}  // namespace

Findings judge_fit(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd_linear}, .films = true}, memory);
  Findings found;
  for (const bool inner : {true, false}) {
    const std::string id = fmt::format("fit/{}/{}", bearing_case.id, raceway_name(inner));
    const std::string at = ", " + raceway_name(inner) + " raceway";
    const ByHand contact = by_hand(body, inner);
    const bool fitted = results.size() == 1 && results[0].fit && results[0].datum_m;
    double points_error = fitted ? 0 : nothing;
    LineErrors errors;
    int solved = 0;
    if (fitted) {
      const bearing::LinearFit& fit = one_of(*results[0].fit, inner);
      const double datum = one_of(*results[0].datum_m, inner);
      std::vector<double> approaches_m, forces_N;
      for (const auto& point : fit.points) {
        approaches_m.push_back(point.approach_m);
        forces_N.push_back(point.force_N);
        const double film = solved_by_hand(body, inner, point.force_N).offset_film_m;
        points_error =
            worse(points_error, std::abs((dry_m(contact, point.force_N, datum) - point.approach_m) / film - 1));
        ++solved;
      }
      errors = errors_of_line(fit, approaches_m, forces_N);
    }
    found.claims.push_back(
        claim(sentence(id + "/points",
                       "the points of the fit are delta_dry less the film that `reference` finds at their loads" + at),
              points_error, 0, film_tolerance(), fmt::format("{} contacts, relative to the offset film", solved)));
    found.claims.push_back(
        claim(sentence(id + "/line", "K and dF are the least squares of f on delta through them" + at), errors.line, 0,
              Tolerance::round_off(64, 1e4), "sums of six products; n Sxx - Sx^2 cancels two digits"));
    found.claims.push_back(claim(sentence(id + "/spread",
                                          "the residual is the largest distance from the line, the deviation that of "
                                          "points - 2 degrees of freedom" +
                                              at),
                                 errors.spread, 0, Tolerance::round_off(64, 1e6),
                                 "a distance is a hundredth of the force"));
    found.claims.push_back(claim(
        sentence(id + "/correlation", "K and dF are correlated by -Sum delta/sqrt(n Sum delta^2)" + at),
        errors.correlation, 0, Tolerance::round_off(64, 1e4), "sums of six products; n Sxx - Sx^2 cancels two digits"));
    double pressure_error = fitted && !results[0].rollers.empty() ? 0 : nothing, film_error = pressure_error;
    int loaded = 0;
    for (const RollerRow& roller : fitted ? results[0].rollers : std::vector<RollerRow>{}) {
      const ContactRow& row = one_of(roller, inner);
      if (!(row.force_N > 2000) || roller.azimuth_deg < 0) continue;  // where the line was fitted, one of each pair
      pressure_error = worse(pressure_error, std::abs(row.hertz_pressure_Pa.value_or(nothing) /
                                                          std::sqrt(row.force_N / contact.length_m *
                                                                    contact.modulus_Pa / (2 * pi * contact.radius_m)) -
                                                      1));
      film_error = worse(
          film_error,
          std::abs(row.film_minimum_m.value_or(nothing) / solved_by_hand(body, inner, row.force_N).film_minimum_m - 1));
      ++loaded;
    }
    found.claims.push_back(claim(sentence(id + "/pressure", "the rollers' p_H are sqrt(f E'/(2 pi R l))" + at),
                                 loaded > 0 ? pressure_error : nothing, 0, rounding()));
    found.claims.push_back(
        claim(sentence(id + "/film",
                       "the rollers' films by `ehd-linear` are those that `reference` finds at their loads" + at),
              loaded > 0 ? film_error : nothing, 0, film_tolerance(), fmt::format("{} rollers", loaded)));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
