// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep divided over processes: each computes a shard, and the finished shards are merged.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "io/sweep_run.hpp"

namespace ehd {

/// A part of a sweep: the rows that shard `number` of `of` computes.
struct Shard {
  std::size_t number = 1, of = 1;  ///< 1 <= number <= of
};

/// The rows of a shard, in increasing order: row = number - 1 modulo `of`.
[[nodiscard]] std::vector<std::size_t> rows_of(const Sweep& sweep, const Shard& shard);

/// Computes what is not known yet of a shard and keeps it in folder/shards/K-of-N, with a cost.json and without
/// tables. Throws OutputError.
[[nodiscard]] SweepCost run_shard(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder,
                                  const Shard& shard);

/// The rows.csv and rows.json of run_sweep, from folder/shards, where all shards of one number must be complete;
/// OutputError says which is not, and why.
[[nodiscard]] SweepCost merge_shards(const Sweep& sweep, const SweepRequest& request,
                                     const std::filesystem::path& folder);

}  // namespace ehd
