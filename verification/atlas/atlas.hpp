// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas: line contacts over a grid of M and L, solved by the certified solver, as atlas.csv, digits.txt and one
// case file a point. cases/atlas/README.md explains the columns.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/output_file.hpp"
#include "verification/atlas/digits.hpp"
#include "verification/atlas/points.hpp"
#include "verification/atlas/record.hpp"
#include "verification/atlas/table.hpp"

namespace ehd::verification {

struct AtlasRequest {
  std::filesystem::path folder;
  std::vector<AtlasPoint> points;
  std::string only;  ///< solve points with this in their id; rows and files of the others stay as they are
  std::optional<double> tolerance = {};  ///< instead of each point's usual one
  double time_limit_s = 30;
  unsigned threads = 0;  ///< 0: as many as there are cores
  bool fresh = false;    ///< solve every point again, whatever an earlier run has recorded
  /// Called after each point, one thread at a time. Reused points come first, apart from overlaps between threads.
  std::function<void(std::size_t done, std::size_t all, const AtlasRecord& record, bool reused)> progress = {};
};

struct AtlasResult {
  struct Entry {
    AtlasPoint point;
    AtlasRecord record;
    bool reused = false;  ///< from a record of an earlier run
  };
  std::vector<Entry> entries;          ///< selected points, in the order of the request
  std::vector<std::string> left_over;  ///< case files in the folder that belong to no row
  double wall_s = 0;
};

[[nodiscard]] std::vector<AtlasPoint> selected_points(const AtlasRequest& request);

/// Solves the points without a valid record, the heaviest first, and writes each record at once. Then writes atlas.csv,
/// digits.txt and the case files, each whole or not at all. A case in which a number changes gets the next version.
/// Throws OutputError where the folder cannot be written; CaseError where `only` has to keep the rows of an atlas.csv
/// that cannot be read.
[[nodiscard]] AtlasResult run_atlas(const AtlasRequest& request, const RegisteredSolver& solver);

/// For a terminal: numbers of points and digits, the slowest points, and those without digits.
[[nodiscard]] std::string human_summary(const AtlasResult& result);

}  // namespace ehd::verification
