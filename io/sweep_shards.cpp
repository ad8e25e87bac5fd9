// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_shards.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "contact/text.hpp"
#include "io/output_file.hpp"
#include "io/stored_row.hpp"

namespace ehd {

namespace {

using Clock = std::chrono::steady_clock;

std::filesystem::path shards_folder(const std::filesystem::path& folder) { return folder / "shards"; }

std::filesystem::path folder_of(const Shard& shard, const std::filesystem::path& folder) {
  return shards_folder(folder) / fmt::format("{}-of-{}", shard.number, shard.of);
}

/// N of a folder's name K-of-N; 0 if the name is not K-of-N.
std::size_t of_in_name(const std::string& name) {
  constexpr std::string_view between = "-of-";
  const auto middle = name.find(between);
  if (middle == std::string::npos) return 0;
  const char *begin = name.data() + middle + between.size(), *end = name.data() + name.size();
  std::size_t of = 0;
  const auto parsed = std::from_chars(begin, end, of);
  return parsed.ec == std::errc() && parsed.ptr == end ? of : 0;
}

/// N of the shards K-of-N in the folder.
std::size_t shards_in(const std::filesystem::path& folder) {
  std::set<std::size_t> numbers;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (const std::size_t of = of_in_name(entry->path().filename().string()); of > 0) numbers.insert(of);
  if (numbers.empty())
    throw OutputError(one_line(folder.string() +
                               ": there are no shards to merge; required is --shard 1/N to N/N with the same "
                               "--output before"));
  if (numbers.size() > 1)
    throw OutputError(
        one_line(fmt::format("{}: shards of {} and of {} stand side by side; allowed is one division, "
                             "and the folders of the other must go",
                             folder.string(), *numbers.begin(), *numbers.rbegin())));
  return *numbers.begin();
}

std::string run_again(const Shard& shard) {
  return fmt::format("required is to run again --shard {}/{}", shard.number, shard.of);
}

/// The journal of a shard, with every row of the shard, or OutputError.
std::unique_ptr<Journal> finished_journal(const Sweep& sweep, const SweepHashes& hashes,
                                          const std::filesystem::path& folder, const Shard& shard) {
  const auto own = folder_of(shard, folder);
  const JournalHeader header{.owner = hashes.of_sweep, .shard = shard.number, .of = shard.of};
  const std::vector<std::size_t> rows = rows_of(sweep, shard);
  auto journal = std::make_unique<Journal>(own, header, hashes.of(rows));
  std::size_t known = 0;
  for (const std::size_t row : rows) known += journal->holds(hashes.of_row[row]);
  if (known < rows.size())
    throw OutputError(one_line(fmt::format("{}: the shard is not finished, it holds {} of {} rows; {}",
                                           journal->file().string(), known, rows.size(), run_again(shard))));
  return journal;
}

}  // namespace

std::vector<std::size_t> rows_of(const Sweep& sweep, const Shard& shard) {
  std::vector<std::size_t> rows;
  for (std::size_t row = shard.number - 1; row < sweep.rows(); row += shard.of) rows.push_back(row);
  return rows;
}

SweepCost run_shard(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder,
                    const Shard& shard) {
  const SweepHashes hashes(sweep, request);
  const std::vector<std::size_t> rows = rows_of(sweep, shard);
  const auto own = folder_of(shard, folder);
  Journal journal(own, {.owner = hashes.of_sweep, .shard = shard.number, .of = shard.of}, hashes.of(rows),
                  request.fresh);
  SweepCost cost = compute_missing(sweep, request, hashes, rows, journal);
  for (const std::size_t row : rows)
    cost.failures.add(failure_of(kept_row(sweep, row, hashes.of_row[row], journal, run_again(shard)).json));
  write_cost(cost, own);
  return cost;
}

SweepCost merge_shards(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder) {
  const auto begin = Clock::now();
  const SweepHashes hashes(sweep, request);
  const std::size_t of = shards_in(shards_folder(folder));
  std::vector<std::unique_ptr<Journal>> journals;
  for (std::size_t number = 1; number <= of; ++number)
    journals.push_back(finished_journal(sweep, hashes, folder, {number, of}));
  SweepCost cost{.rows = sweep.rows()};
  cost.failures = write_table(
      sweep, hashes.of_sweep, folder,
      [&](std::size_t row) {
        return kept_row(sweep, row, hashes.of_row[row], *journals[row % of], run_again({row % of + 1, of}));
      },
      request.threads);
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
  return cost;
}

}  // namespace ehd
