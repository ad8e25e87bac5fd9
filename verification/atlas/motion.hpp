// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas of motion: stiffness and damping of the film over M, L and Omega, and the part of a waviness that passes
// it. By the certified solver, as kappa.csv and waviness.csv beside atlas.csv. docs/atlas.md explains the
// columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/atlas/atlas.hpp"

namespace ehd::verification {

/// The points: all law sets, flooded.
[[nodiscard]] std::vector<AtlasPoint> motion_points();
/// What is asked of a point: Omega besides slow motion, and waves.
[[nodiscard]] ResponseRequest motion_request(const AtlasPoint& point);

/// (lambda_w/b) M^(3/4)/L^(1/2): over it, amplitude ratios of all contacts are said to be one curve (Venner, Couhier,
/// Lubrecht & Greenwood 1997).
[[nodiscard]] double similar_wavelength(MoesGroups moes, double wavelength_b);
/// The waves of motion_request() have these similar wavelengths, and four digits in b.
inline constexpr double similar_wavelengths[] = {1, 2, 4, 8, 16};

/// A table of the atlas of motion. NAME_error is the absolute uncertainty of the printed NAME.
struct MotionTable {
  std::string_view file, comment;
  std::vector<std::string> places;  ///< columns after the point's that say where: Omega; or wavelength, slip
  std::vector<std::string> values;  ///< columns, each followed by NAME_error
};
/// Re kappa and Im kappa/Omega; at Omega = 0 kappa_0 and kappa_1.
[[nodiscard]] const MotionTable& kappa_table();
[[nodiscard]] const MotionTable& waviness_table();

[[nodiscard]] std::string motion_csv_text(const MotionTable& table, const std::vector<AtlasRow>& rows);
/// Throws CaseError as read_atlas_table does.
[[nodiscard]] std::vector<AtlasRow> read_motion_table(const MotionTable& table, const std::filesystem::path& folder);

/// The error of everything that is asked for in the response of a point; digits that are known are more.
inline constexpr double motion_tolerance = 1e-5;
[[nodiscard]] AtlasRecord solve_motion(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                                       double time_limit_s);
/// Under which a record has a value of a row.
[[nodiscard]] std::string motion_reading_name(const MotionTable& table, const std::string& value, const AtlasRow& row);
/// Of one point.
[[nodiscard]] std::vector<AtlasRow> motion_rows(const MotionTable& table, const AtlasPoint& point,
                                                const AtlasRecord& record);

/// As run_atlas. left_over stays empty.
[[nodiscard]] AtlasResult run_motion_atlas(const AtlasRequest& request, const RegisteredSolver& solver);
[[nodiscard]] std::string human_motion_summary(const AtlasResult& result);

}  // namespace ehd::verification
