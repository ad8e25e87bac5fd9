// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "io/csv.hpp"

namespace ehd {

namespace {

constexpr const char* roller_columns =
    "case,clearance_m,law,azimuth_deg,inner_force_N,inner_displacement_m,inner_film_minimum_m,"
    "inner_hertz_pressure_Pa,outer_force_N,outer_displacement_m,outer_film_minimum_m,outer_hertz_pressure_Pa,"
    "roller,inner_lambda_ratio,outer_lambda_ratio,file";
constexpr const char* motion_columns =
    ",frequency_Hz,inner_stiffness_N_per_m,inner_damping_N_s_per_m,outer_stiffness_N_per_m,outer_damping_N_s_per_m,"
    "ring_stiffness_xx_N_per_m,ring_stiffness_yy_N_per_m,ring_stiffness_xy_N_per_m,ring_damping_xx_N_s_per_m,"
    "ring_damping_yy_N_s_per_m,ring_damping_xy_N_s_per_m";

std::string comma_number(const std::optional<double>& value) {
  constexpr int all_digits = 17;
  return "," + csv_number(value, all_digits);
}

std::string roller_cells(const Case& one, const BearingResult& result, std::size_t j) {
  const RollerRow& roller = result.rollers[j];
  std::string cells =
      fmt::format("{}{},{}{}", one.id, comma_number(std::get<BearingCase>(one.body).geometry.clearance_m),
                  to_string(result.law), comma_number(roller.azimuth_deg));
  for (const ContactRow* at : {&roller.inner, &roller.outer})
    cells += comma_number(at->force_N) + comma_number(at->displacement_m) + comma_number(at->film_minimum_m) +
             comma_number(at->hertz_pressure_Pa);
  return fmt::format("{},{}{}{},{}", cells, j + 1, comma_number(roller.inner.lambda_ratio),
                     comma_number(roller.outer.lambda_ratio), csv_cell(one.file.string()));
}

/// Without what is not known of the ring, as in the JSON.
std::string motion_cells(const BearingResult& result, const BearingResult* full, std::size_t k, std::size_t j) {
  const DynamicRow& row = result.dynamics[k];
  const bool stiffness = knows_motion(result, full, k), damping = knows_damping(row);
  std::string cells = comma_number(row.frequency_Hz);
  for (const bearing::ContactMotion* at : {&row.rollers[j].inner, &row.rollers[j].outer})
    cells += comma_number(stiffness ? std::optional(at->stiffness_N_per_m) : std::nullopt) +
             comma_number(damping ? at->damping_N_s_per_m : std::nullopt);
  const auto add_ring = [&](const std::optional<bearing::Matrix2>& matrix) {
    for (const auto& [r, s] : {std::pair{0U, 0U}, {1U, 1U}, {0U, 1U}})
      cells += comma_number(matrix ? std::optional((*matrix)[r][s]) : std::nullopt);
  };
  add_ring(stiffness ? std::optional(row.ring.stiffness_N_per_m) : std::nullopt);
  add_ring(damping ? row.ring.damping_N_s_per_m : std::nullopt);
  return cells;
}

std::string csv_rows(const Case& one, const BearingResult& result, const BearingResult* full, bool moving) {
  std::string rows;
  for (std::size_t j = 0; j < result.rollers.size(); ++j) {
    const std::string roller = roller_cells(one, result, j);
    if (result.dynamics.empty()) rows += roller + (moving ? ",,,,,,,,,,,\n" : "\n");
    for (std::size_t k = 0; k < result.dynamics.size(); ++k) rows += roller + motion_cells(result, full, k, j) + "\n";
  }
  return rows;
}

}  // namespace

std::optional<std::string> bearing_csv(const std::vector<Case>& cases,
                                       const std::vector<std::vector<BearingResult>>& results) {
  const bool moving = std::ranges::any_of(results, [](const std::vector<BearingResult>& laws) {
    return std::ranges::any_of(laws, [](const BearingResult& result) { return !result.dynamics.empty(); });
  });
  std::string rows;
  for (std::size_t k = 0; k < cases.size(); ++k)
    for (const BearingResult& result : results[k])
      rows += csv_rows(cases[k], result, full_relation_in(results[k]), moving);
  if (rows.empty()) return std::nullopt;
  return fmt::format("{}{}\n{}", roller_columns, moving ? motion_columns : "", rows);
}

}  // namespace ehd
