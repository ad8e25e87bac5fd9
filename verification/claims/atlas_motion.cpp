// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 10: the atlas of motion (cases/atlas/kappa.csv, waviness.csv). Both solvers meet a sample of its points, at
// tolerances that the atlas was not made with.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "verification/claims/response_parts.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/motion_maps.hpp"

namespace ehd::verification {

namespace {

constexpr int rung_of_points = 10;
/// Slow: the dense solver needs more than about a second.
constexpr std::pair<const char*, bool> motion_sample[] = {
    {"atlas-isoviscous-m0.5-l0-flooded", false}, {"atlas-roelands-m0.7-l25-flooded", false},
    {"atlas-roelands-m2-l5-flooded", false},     {"atlas-roelands-m20-l10-flooded", false},
    {"atlas-roelands-m100-l5-flooded", true},    {"atlas-barus-m5-l5-flooded", false},
    {"atlas-barus-m1-l15-flooded", false},       {"atlas-barus-m50-l10-flooded", true}};

/// Difference of a number from the row's, over the sum of both stated errors; NaN where one of the two is not known.
double apart(const AtlasRow& row, const std::string& column, const std::map<std::string, AtlasReading>& found,
             const std::string& name) {
  const auto at = found.find(name);
  if (row.at(column).empty() || at == found.end()) return nothing;
  return std::abs(at->second.value - std::stod(row.at(column))) /
         (at->second.error + std::stod(row.at(column + "_error")));
}

Findings judge_motion(const std::string& id) {
  const std::string statement = "both solvers meet the stiffness, damping and waves of " + id;
  std::error_code error;
  if (!std::filesystem::exists(atlas_folder() / kappa_table().file, error))
    return {.claims = {},
            .skipped = {{{.id = "atlas/motion/" + id, .rung = rung_of_points, .statement = statement},
                         "there is no atlas of motion in " + atlas_folder().string()}}};
  const MotionMaps maps = motion_maps(atlas_folder());
  Findings findings;
  for (const auto& [solver, tolerance] : {std::pair{&default_solver(), 1e-4}, std::pair{&certified_solver(), 1e-6}}) {
    double worst = 0;
    int numbers = 0;
    std::string where;
    for (const AtlasPoint& point : motion_points()) {
      if (point.id() != id) continue;
      const AtlasRecord record = solve_motion(point, *solver, tolerance, 60);
      for (const auto& [table, rows] :
           {std::pair{&kappa_table(), &maps.kappa}, std::pair{&waviness_table(), &maps.waviness}}) {
        for (const AtlasRow& row : *rows) {
          if (row.at("id") != id) continue;
          for (const std::string& value : table->values) {
            const double off = apart(row, value, record.readings, motion_reading_name(*table, value, row));
            ++numbers;
            if (!(off <= worst)) where = value + " at " + row.at(table->places.front());
            worst = worse(worst, off);
          }
        }
      }
    }
    findings.claims.push_back(claim(
        {.id = fmt::format("atlas/motion/{}/{}", id, solver->name),
         .rung = rung_of_points,
         .statement =
             fmt::format("{} at {} meets the stiffness, damping and waves of {}", solver->name, plain(tolerance), id),
         .solver = solver->name},
        numbers > 0 ? worst : nothing, 0, Tolerance::required(1, "the errors of both cover the difference"),
        fmt::format("{} numbers, farthest: {}", numbers, where)));
  }
  return findings;
}

}  // namespace

std::vector<Topic> atlas_motion_topics() {
  std::vector<Topic> topics;
  for (const auto& [id, slow] : motion_sample)
    topics.push_back({.name = std::string("atlas of motion ") + id,
                      .rungs = {rung_of_points},
                      .slow = slow,
                      .judge = [id = std::string(id)] { return judge_motion(id); },
                      .expected_s = slow ? 10.0 : 2.0});
  return topics;
}

}  // namespace ehd::verification
