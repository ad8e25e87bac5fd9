// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 0 and 10: an oil by its grade has the viscosity that its standards define.
#include "contact/oil_grade.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"

namespace ehd::verification {

namespace {

/// Inverting log log Z stretches a rounding error by ln(10)^2 log10 Z, which is at most 40 up to 2e7 mm2/s.
Tolerance inverted_log_log() { return Tolerance::round_off(64, 40); }

constexpr double smallest_grade_with_index = 7;

/// Calls visit(viscosity at 40 C, at 100 C) for each grade that can have this index.
template <class Visit>
void for_each_grade(double index, const Visit& visit) {
  for (const double grade : iso_viscosity_grades()) {
    const double at_40C = midpoint_of_grade_mm2_per_s(grade).value_or(nothing);
    if (grade >= smallest_grade_with_index) visit(at_40C, viscosity_100C_mm2_per_s(at_40C, index).value_or(nothing));
  }
}

double oil_viscosity(double at_40C, double at_100C, double temperature_C) {
  return viscosity_at_mm2_per_s(at_40C, at_100C, temperature_C).value_or(nothing);
}

double viscosities_apart(double one, double other) { return std::abs(one / other - 1); }

/// Both temperatures of the definition give back the viscosities that were stated there.
Claim grade_claim() {
  double error = 0;
  for_each_grade(95, [&](double at_40C, double at_100C) {
    error = worse(error, viscosities_apart(oil_viscosity(at_40C, at_100C, 40), at_40C),
                  viscosities_apart(oil_viscosity(at_40C, at_100C, 100), at_100C));
  });
  return claim(
      {.id = "inputs/oil/definition",
       .rung = 0,
       .statement = "an ISO VG oil has its grade's viscosity at 40 \u00b0C, and at 100 \u00b0C that of its index"},
      error, 0, inverted_log_log());
}

Claim falling_claim() {
  bool falls = true;
  double lowest = nothing, highest = nothing;
  for_each_grade(95, [&](double at_40C, double at_100C) {
    double before = std::numeric_limits<double>::infinity();
    for (double T = -50; T <= 150; T += 5) {
      const auto found = viscosity_at_mm2_per_s(at_40C, at_100C, T);
      if (!found) continue;  // outside the range of D341
      falls = falls && *found < before && oil_density_kg_per_m3(870, T) > oil_density_kg_per_m3(870, T + 5);
      before = *found;
      lowest = std::isnan(lowest) ? before : std::min(lowest, before);
      highest = std::isnan(highest) ? before : std::max(highest, before);
    }
  });
  const bool ran = highest > lowest;
  return claim_fact({.id = "inputs/oil/monotone",
                     .rung = 0,
                     .statement = "viscosity and density of an oil fall with temperature, -50 to 150 C"},
                    falls && ran, "every grade from 7, index 95",
                    fmt::format("{} to {} mm2/s", plain(lowest, 3), plain(highest, 3)));
}

/// The index of an oil is found again from the viscosity at 100 C that it gives.
Claim index_back_claim() {
  double error = 0;
  for (const double index : {0.0, 50.0, 95.0, 100.0, 150.0})
    for_each_grade(index, [&](double at_40C, double at_100C) {
      if (std::isnan(at_100C)) return;  // less than 2 mm2/s at 100 C: no index
      error = worse(error, std::abs(viscosity_index(at_40C, at_100C).value_or(nothing) - index));
    });
  return claim({.id = "inputs/oil/index-inverse",
                .rung = 0,
                .statement = "the viscosity at 100 C that follows from an index has that index"},
               error, 0,
               Tolerance::calibrated(0.3,
                                     "the coefficients of D2270 jump by up to 0.18 % of H where their ranges "
                                     "meet (7.7 mm2/s), 0.27 of an index"));
}

/// L and H of ASTM D2270, table 1: the viscosities at 40 C of index 0 and 100.
struct IndexTableRow {
  double at_100C, L, H;
};
constexpr IndexTableRow index_table[] = {{2, 7.994, 6.394},  {4, 25.32, 19.56},  {5, 40.23, 28.49}, {10, 147.7, 82.87},
                                         {15, 296.5, 149.7}, {20, 493.2, 229.5}, {70, 4905, 1558}};

std::vector<Claim> index_claims() {
  const Tolerance whole_index = Tolerance::required(0.5, "ASTM D2270 states an index as a whole number");
  std::vector<Claim> claims;
  double at_zero = 0, at_hundred = 0;
  for (const IndexTableRow& row : index_table) {
    at_zero = worse(at_zero, std::abs(viscosity_index(row.L, row.at_100C).value_or(nothing)));
    at_hundred = worse(at_hundred, std::abs(viscosity_index(row.H, row.at_100C).value_or(nothing) - 100));
  }
  claims.push_back(claim({.id = "published/oil/index-0",
                          .rung = 10,
                          .statement = "oils with L of table 1 of ASTM D2270 have the viscosity index 0"},
                         at_zero, 0, whole_index));
  claims.push_back(claim({.id = "published/oil/index-100",
                          .rung = 10,
                          .statement = "oils with H of table 1 of ASTM D2270 have the viscosity index 100"},
                         at_hundred, 0, whole_index));
  struct Example {
    double at_40C, at_100C, index;
  };
  double error = 0;
  for (const Example& one : {Example{73.30, 8.86, 92}, Example{22.83, 5.05, 156}})
    error = worse(error, std::abs(viscosity_index(one.at_40C, one.at_100C).value_or(nothing) - one.index));
  claims.push_back(claim({.id = "published/oil/index-examples",
                          .rung = 10,
                          .statement = "the examples of ASTM D2270 below and above 100 have the indices 92 and 156"},
                         error, 0, whole_index));
  return claims;
}

/// D341's own explicit inverse, viscosity from Z, against the program, which inverts Z itself. One line through two
/// viscosities gives Z at a third temperature.
Claim explicit_inverse_claim() {
  double error = 0;
  for (const double at_40C : {4.0, 22.0, 320.0}) {
    const double at_100C = at_40C == 4 ? 1.4 : at_40C == 22 ? 4.2 : 24;
    const auto ordinate = [](double v) {
      return std::log10(std::log10(v + 0.7 + std::exp(-1.47 - 1.84 * v - 0.51 * v * v)));
    };
    for (const double T : {0.0, 70.0, 120.0}) {
      const double share = std::log10((T + 273.15) / 313.15) / std::log10(373.15 / 313.15);
      const double part = std::pow(10, std::pow(10, (1 - share) * ordinate(at_40C) + share * ordinate(at_100C))) - 0.7;
      const double inverse =
          part - std::exp(-0.7487 - 3.295 * part + 0.6119 * part * part - 0.3193 * part * part * part);
      error = worse(error, viscosities_apart(oil_viscosity(at_40C, at_100C, T), inverse));
    }
  }
  return claim({.id = "published/oil/d341-inverse",
                .rung = 10,
                .statement = "viscosities over temperature agree with the explicit inverse that ASTM D341 prints"},
               error, 0,
               Tolerance::calibrated(3e-4, "the printed inverse is an approximation: up to 2.8e-4 off, at 0.25 mm2/s"));
}

Findings judge_oil_grades() {
  Findings found;
  found.claims = {grade_claim(), falling_claim(), index_back_claim(), explicit_inverse_claim()};
  for (Claim& one : index_claims()) found.claims.push_back(std::move(one));
  return found;
}

}  // namespace

std::vector<Topic> oil_grade_topics() {
  return {{.name = "oil by its grade", .rungs = {0, 10}, .judge = judge_oil_grades}};
}

}  // namespace ehd::verification
