// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_run.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>
#include <utility>

#include "io/content_hash.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/contact_cache.hpp"
#include "workflow/parallel.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

SweepHashes::SweepHashes(const Sweep& sweep, const SweepRequest& request) {
  std::vector<HashNumber>& numbers = of_row.numbers;
  numbers.resize(sweep.rows());
  in_threads(numbers.size(), request.threads,
             [&](std::size_t row) { numbers[row] = hash_number(row_hash(sweep, request, row)).value(); });
  of_sweep = content_hash({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(HashNumber)});
}

std::vector<HashNumber> SweepHashes::of(const std::vector<std::size_t>& rows) const {
  std::vector<HashNumber> some(rows.size());
  std::transform(rows.begin(), rows.end(), some.begin(), [&](std::size_t row) { return of_row.numbers[row]; });
  return some;
}

namespace {

/// Rows that are not known, in increasing order; of equal rows the first. By sorting: a set of texts would take twice
/// the memory of all else.
std::vector<std::size_t> missing_rows(const SweepHashes& hashes, const std::vector<std::size_t>& rows,
                                      const std::function<bool(const std::string& hash)>& known) {
  std::vector<std::size_t> missing;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(missing),
               [&](std::size_t row) { return !known(hashes.of_row[row]); });
  const auto& number = hashes.of_row.numbers;
  std::sort(missing.begin(), missing.end(), [&](std::size_t one, std::size_t other) {
    return std::pair(number[one], one) < std::pair(number[other], other);
  });
  missing.erase(std::unique(missing.begin(), missing.end(),
                            [&](std::size_t one, std::size_t other) { return number[one] == number[other]; }),
                missing.end());
  std::sort(missing.begin(), missing.end());
  return missing;
}

}  // namespace

SweepCost compute_missing(const Sweep& sweep, const SweepRequest& request, const SweepHashes& hashes,
                          const std::vector<std::size_t>& rows, SweepJournal& journal) {
  const auto begin = Clock::now();
  SweepCost cost{.rows = rows.size()};
  const std::vector<std::size_t> missing =
      missing_rows(hashes, rows, [&](const std::string& hash) { return journal.holds(hash); });
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
      sweep, hashes.of_sweep, folder, [&](std::size_t row) { return journal.row(hashes.of_row[row]); },
      request.threads);
  cost.wall_s = seconds_since(begin);
  write_cost(cost, folder);
  return cost;
}

}  // namespace ehd
