// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "contact/text.hpp"
#include "io/content_hash.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/stored_row.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/contact_cache.hpp"
#include "workflow/parallel.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Rows of an earlier run that are not what this program writes: they are computed again.
void forget_wrong_rows(const Sweep& sweep, const SweepHashes& hashes, const std::vector<std::size_t>& rows,
                       unsigned threads, SweepJournal& journal) {
  std::mutex mutex;
  std::vector<std::string> wrong;
  in_threads(rows.size(), threads, [&](std::size_t i) {
    const std::string& hash = hashes.of_row[rows[i]];
    if (!journal.holds(hash)) return;
    try {
      (void)read_stored_row(sweep, rows[i], hash, journal.row(hash));
    } catch (const StoredRowError&) {
      const std::lock_guard lock(mutex);
      wrong.push_back(hash);
    }
  });
  for (const std::string& hash : wrong) journal.forget(hash);
}

}  // namespace

SweepHashes::SweepHashes(const Sweep& sweep, const SweepRequest& request) {
  std::string all;
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    of_row.push_back(row_hash(sweep, request, row));
    all += of_row.back();
  }
  of_sweep = content_hash(all);
}

std::set<std::string> SweepHashes::of(const std::vector<std::size_t>& rows) const {
  std::set<std::string> some;
  for (const std::size_t row : rows) some.insert(of_row[row]);
  return some;
}

SweepCost compute_missing(const Sweep& sweep, const SweepRequest& request, const SweepHashes& hashes,
                          const std::vector<std::size_t>& rows, SweepJournal& journal) {
  const auto begin = Clock::now();
  SweepCost cost{.rows = rows.size()};
  forget_wrong_rows(sweep, hashes, rows, request.threads, journal);
  std::set<std::string> taken;
  std::vector<std::size_t> missing;
  for (const std::size_t row : rows)
    if (!journal.holds(hashes.of_row[row]) && taken.insert(hashes.of_row[row]).second) missing.push_back(row);
  const std::size_t known = rows.size() - missing.size();
  if (request.progress) request.progress(known, rows.size(), 0);

  const auto cache = std::make_shared<ContactCache>(with_fallback(find_solver(sweep.solver)->solve));
  std::mutex mutex;
  in_threads(missing.size(), request.threads, [&](std::size_t i) {
    const auto row_begin = Clock::now();
    const std::string& hash = hashes.of_row[missing[i]];
    const ComputedRow computed = compute_row(sweep, request, missing[i], hash, cache);
    const double row_s = seconds_since(row_begin);
    const std::lock_guard lock(mutex);
    journal.add(hash, computed.text);
    cost.rows_s += row_s;
    cost.needed += computed.needed;
    ++cost.computed;
    if (request.progress) request.progress(known + cost.computed, rows.size(), cost.computed);
  });
  cost.solves = sweep.bearing ? cache->solves() : cost.needed;
  cost.threads = request.threads > 0 ? request.threads : std::max(1u, std::thread::hardware_concurrency());
  cost.wall_s = seconds_since(begin);
  return cost;
}

StoredRow kept_row(const Sweep& sweep, std::size_t row, const std::string& hash, const SweepJournal& journal,
                   const std::string& again) {
  try {
    return read_stored_row(sweep, row, hash, journal.row(hash));
  } catch (const StoredRowError& wrong) {
    throw OutputError(
        one_line(fmt::format("{}: row {} is damaged: {}; {}", journal.file().string(), row, wrong.what(), again)));
  }
}

void write_cost(const SweepCost& cost, const std::filesystem::path& folder) {
  OutputFile file(folder / "cost.json");
  Json json = to_json(cost);
  json["provenance"] = provenance();
  file.commit(json_text(json));
}

Json to_json(const SweepCost& cost) {
  Json json = Json::object();
  json["rows"] = cost.rows;
  json["computed"] = cost.computed;
  json["failed"] = cost.failures.rows;
  json["contact_solves"] = cost.solves;
  json["contact_solves_saved"] = cost.saved();
  json["threads"] = cost.threads;
  put(json, "wall_s", cost.wall_s);
  put(json, "rows_s", cost.rows_s);
  return json;
}

SweepCost run_sweep(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder) {
  const SweepHashes hashes(sweep, request);
  std::vector<std::size_t> rows(sweep.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  SweepJournal journal(folder / "rows", {.sweep = hashes.of_sweep}, hashes.of(rows), request.fresh);
  { const OutputFile csv(folder / "rows.csv"), json(folder / "rows.json"); }  // refused before the work, not after
  const auto begin = Clock::now();
  SweepCost cost = compute_missing(sweep, request, hashes, rows, journal);
  cost.failures = write_table(
      sweep, hashes.of_sweep, folder,
      [&](std::size_t row) {
        return kept_row(sweep, row, hashes.of_row[row], journal, "required is the same run again");
      },
      request.threads);
  cost.wall_s = seconds_since(begin);
  write_cost(cost, folder);
  return cost;
}

}  // namespace ehd
