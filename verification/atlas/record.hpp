// SPDX-License-Identifier: GPL-3.0-or-later
// One point of the atlas, solved.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "contact/solution.hpp"
#include "verification/atlas/points.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

inline constexpr double atlas_worst_error = 1e-4;  ///< relative, of H_min and H_cen: above it no digits are printed

/// A quantity of a point, with its absolute error.
struct AtlasReading {
  double value = 0;
  double error = 0;
};

/// The result of one point. It is kept on disk, so that an interrupted run can continue. Names of readings are columns
/// of the CSV.
struct AtlasRecord {
  std::string id;
  std::string solver;       ///< atlas_solver_version()
  double tolerance = 0;     ///< asked for
  double time_limit_s = 0;  ///< of each solve
  StopReason status = StopReason::diverged;
  std::string reason;
  std::map<std::string, AtlasReading> readings;
  long nodes = 0;
  double wall_s = 0;

  /// H_min and H_cen are known to atlas_worst_error: only then are digits printed.
  [[nodiscard]] bool has_digits() const;
};

/// In one line, as the journal keeps it.
[[nodiscard]] std::string json_of(const AtlasRecord& record);
/// Absent where the text is no record: a file of another program, or a damaged one.
[[nodiscard]] std::optional<AtlasRecord> record_from(const std::string& json);

/// Solves a point. If H_min or H_cen is then not known to 1e-4, solves follow at 1000 times the tolerance, up to 1e-4;
/// after a solve that ran out of time, at 1e-4 at once. Tolerance, status and reason stay those of the first solve. One
/// exception: if the first solve found no film and a looser one found digits, the status is tolerance-not-met.
[[nodiscard]] AtlasRecord solve_point(const AtlasPoint& point, const RegisteredSolver& solver, double tolerance,
                                      double time_limit_s);

/// The solver's name and a digest of three short solves, to the last bit: it changes when the solver changes.
[[nodiscard]] std::string atlas_solver_version(const RegisteredSolver& solver);

}  // namespace ehd::verification
