// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "contact/text.hpp"
#include "io/csv.hpp"

namespace ehd {

namespace {

constexpr const char* roller_columns =
    "case,clearance_m,law,azimuth_deg,inner_force_N,inner_displacement_m,inner_film_minimum_m,"
    "inner_hertz_pressure_Pa,outer_force_N,outer_displacement_m,outer_film_minimum_m,outer_hertz_pressure_Pa,"
    "roller,inner_lambda_ratio,outer_lambda_ratio,file";
constexpr const char* motion_columns =
    ",frequency_Hz,inner_stiffness_N_per_m,inner_damping_N_s_per_m,outer_stiffness_N_per_m,outer_damping_N_s_per_m";

std::string number_cell(const std::optional<double>& value) {
  return "," + (value ? plain(*value, 17) : std::string());
}

std::string roller_cells(const Case& one, const BearingResult& result, std::size_t j) {
  const RollerRow& roller = result.rollers[j];
  std::string cells =
      fmt::format("{}{},{}{}", one.id, number_cell(std::get<BearingCase>(one.body).geometry.clearance_m),
                  to_string(result.law), number_cell(roller.azimuth_deg));
  for (const ContactRow* at : {&roller.inner, &roller.outer})
    cells += number_cell(at->force_N) + number_cell(at->displacement_m) + number_cell(at->film_minimum_m) +
             number_cell(at->hertz_pressure_Pa);
  return fmt::format("{},{}{}{},{}", cells, j + 1, number_cell(roller.inner.lambda_ratio),
                     number_cell(roller.outer.lambda_ratio), csv_cell(one.file.string()));
}

std::string motion_cells(const DynamicRow& row, std::size_t j) {
  std::string cells = number_cell(row.frequency_Hz);
  for (const bearing::ContactMotion* at : {&row.rollers[j].inner, &row.rollers[j].outer})
    cells += number_cell(at->stiffness_N_per_m) + number_cell(at->damping_N_s_per_m);
  return cells;
}

std::string csv_rows(const Case& one, const BearingResult& result, bool moving) {
  std::string rows;
  for (std::size_t j = 0; j < result.rollers.size(); ++j) {
    const std::string roller = roller_cells(one, result, j);
    if (result.dynamics.empty()) rows += roller + (moving ? ",,,,,\n" : "\n");
    for (const DynamicRow& row : result.dynamics) rows += roller + motion_cells(row, j) + "\n";
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
    for (const BearingResult& result : results[k]) rows += csv_rows(cases[k], result, moving);
  if (rows.empty()) return std::nullopt;
  return fmt::format("{}{}\n{}", roller_columns, moving ? motion_columns : "", rows);
}

}  // namespace ehd
