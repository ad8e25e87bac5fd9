// SPDX-License-Identifier: GPL-3.0-or-later
// The run of a whole sweep: rows are computed over threads, kept as they finish (io/store), and written as one table
// (io/sweep_table). rows.csv and rows.json follow from the rows alone. What depends on the run (times, which row solved
// a shared contact) stands in cost.json.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/content_hash.hpp"
#include "io/json.hpp"
#include "io/store.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_row.hpp"
#include "io/sweep_table.hpp"

namespace ehd {

struct StoredRow;  // io/stored_row

/// What a run did.
struct SweepCost {
  std::size_t rows = 0;      ///< of the sweep, or of its shard
  std::size_t computed = 0;  ///< by this run; the others were known, or equal another
  std::size_t not_run = 0;   ///< left out by the deadline
  Failures failures = {};
  long solves = 0;  ///< contact solves of this run
  long needed = 0;  ///< contacts that its rows would have solved, each for itself
  unsigned threads = 0;
  double wall_s = 0;
  double rows_s = 0;  ///< of that computing rows, over all threads
  /// A table of films may take more solves than the rows that use it.
  [[nodiscard]] long saved() const { return std::max(0L, needed - solves); }
};
[[nodiscard]] Json to_json(const SweepCost& cost);

/// Computes what is not known yet and keeps it in folder/rows; writes folder/rows.csv, rows.json and cost.json. Throws
/// OutputError.
[[nodiscard]] SweepCost run_sweep(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder);

// ---- What run_sweep and run_shard (io/sweep_shards) share

/// Hashes kept as numbers, because memory holds millions of them, and read as texts.
struct HashList {
  std::vector<HashNumber> numbers;
  [[nodiscard]] std::string operator[](std::size_t row) const { return digits_of(numbers[row]); }
};

/// row_hash of every row, and the hash of the sweep, which follows from them.
struct SweepHashes {
  SweepHashes(const Sweep& sweep, const SweepRequest& request);
  /// The hashes of some rows.
  [[nodiscard]] std::vector<HashNumber> of(const std::vector<std::size_t>& rows) const;

  HashList of_row;
  std::string of_sweep;
};

/// Computes the rows that the journal does not hold, or holds in a wrong form, and those that lacked time or memory,
/// over threads. Equal rows are computed once. Rows that the deadline left out, or ended in the middle, stay out of the
/// journal.
[[nodiscard]] SweepCost compute_missing(const Sweep& sweep, const SweepRequest& request, const SweepHashes& hashes,
                                        const std::vector<std::size_t>& rows, Journal& journal);

/// A row of a journal, read back; where a deadline left it out, it says so. `again`: what a user does about a wrong
/// one, for the message of the OutputError.
[[nodiscard]] StoredRow kept_row(const Sweep& sweep, std::size_t row, const std::string& hash, const Journal& journal,
                                 const std::string& again);

/// folder/cost.json.
void write_cost(const SweepCost& cost, const std::filesystem::path& folder);

}  // namespace ehd
