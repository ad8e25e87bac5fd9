// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas: line contacts over a grid of M and L, solved by the certified solver, as atlas.csv, digits.txt and one
// case file a point. docs/atlas.md explains the columns.
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

/// What is asked of every point, and how it is recorded: the films at rest, or the motion (motion.hpp).
struct AtlasPart {
  std::string name;    ///< of the folder that keeps its records
  std::string solver;  ///< its version, which a record must have
  std::function<double(const AtlasPoint&)> usual_tolerance;
  std::function<AtlasRecord(const AtlasPoint&, double tolerance, double time_limit_s)> solve;
  std::function<bool(const AtlasRecord&)> has_digits;  ///< false: a longer time limit may find some
};

/// The selected points, in the order of the request. Those without a valid record are solved, the heaviest first, and
/// each record is written at once. Throws OutputError where the folder cannot be written, or where another run is at
/// work there.
[[nodiscard]] std::vector<AtlasResult::Entry> recorded_entries(const AtlasRequest& request, const AtlasPart& part);
/// Writes a file whole, if its text is another one.
void replace_file(const std::filesystem::path& file, const std::string& text);

/// Solves the points without a valid record, the heaviest first, and writes each record at once. Then writes atlas.csv,
/// digits.txt and the case files, each whole or not at all. A case in which a number changes gets the next version.
/// Throws OutputError where the folder cannot be written; CaseError where `only` has to keep the rows of an atlas.csv
/// that cannot be read.
[[nodiscard]] AtlasResult run_atlas(const AtlasRequest& request, const RegisteredSolver& solver);

/// For a terminal: numbers of points and digits, the slowest points, and those without digits.
[[nodiscard]] std::string human_summary(const AtlasResult& result);

}  // namespace ehd::verification
