// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a sweep: computed over threads and processes, kept as they are finished, written as one table.
//
// What a row says depends on the row alone: its contacts are cold solves at loads that follow from its own case. So
// threads, shards, the order of the rows, and which row solved a shared contact first change no bit of rows.csv and
// rows.json; what does change (times, who solved what) is in cost.json.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/sweep_file.hpp"

namespace ehd {

/// A part of a sweep: the rows that shard `number` of `of` computes.
struct Shard {
  std::size_t number = 1, of = 1;  ///< 1 <= number <= of
};

struct SweepRequest {
  int max_iterations = 2000;  ///< of each contact solve
  double time_limit_s = 300;  ///< likewise; where it ends a solve, a row does depend on the machine
  unsigned threads = 0;       ///< 0: as many as there are cores
  bool fresh = false;         ///< rows of an earlier run are computed again
  /// After every row, one call at a time: rows known so far, of how many, how many of them this run computed.
  std::function<void(std::size_t known, std::size_t all, std::size_t computed)> progress = {};
};

/// What a run did.
struct SweepCost {
  std::size_t rows = 0;      ///< of the sweep, or of its shard
  std::size_t computed = 0;  ///< by this run; the others were known, or equal another
  std::size_t failed = 0;    ///< rows with a law that did not converge
  std::string first_failure = {};
  long solves = 0;  ///< contact solves of this run
  long needed = 0;  ///< what its rows would have solved, each for itself
  unsigned threads = 0;
  double wall_s = 0;
  double rows_s = 0;  ///< of that computing rows, over all threads
  [[nodiscard]] long saved() const { return needed - solves; }
};
[[nodiscard]] Json to_json(const SweepCost& cost);

/// 64 hexadecimal digits of all that a row's numbers follow from: the case with its values, laws, solver, tolerance,
/// limits, and the program (its commit; where that does not tell, its own bytes).
[[nodiscard]] std::string row_hash(const Sweep& sweep, const SweepRequest& request, std::size_t row);

/// The rows of a shard, in increasing order: row = number - 1 modulo `of`.
[[nodiscard]] std::vector<std::size_t> rows_of(const Sweep& sweep, const Shard& shard);

/// Computes what is not known yet and keeps it in folder/rows, or a shard's in folder/shards/K-of-N; writes
/// folder/rows.csv, rows.json and cost.json, a shard its cost.json alone. Throws OutputError.
[[nodiscard]] SweepCost run_sweep(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder);
[[nodiscard]] SweepCost run_shard(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder,
                                  const Shard& shard);

/// The same rows.csv and rows.json from folder/shards, where all shards of one number must be complete; OutputError
/// says which is not, and why.
[[nodiscard]] SweepCost merge_shards(const Sweep& sweep, const SweepRequest& request,
                                     const std::filesystem::path& folder);

/// The header of rows.csv, and a row's lines, from its object in rows.json.
[[nodiscard]] std::string csv_header(const Sweep& sweep);
[[nodiscard]] std::string csv_lines(const Sweep& sweep, const Json& row);

}  // namespace ehd
