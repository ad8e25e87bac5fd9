// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "contact/text.hpp"
#include "io/content_hash.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/stored_row.hpp"
#include "io/sweep_films.hpp"
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
                       unsigned threads, Journal& journal) {
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
                          const std::vector<std::size_t>& rows, Journal& journal) {
  const auto begin = Clock::now();
  SweepCost cost{.rows = rows.size()};
  forget_wrong_rows(sweep, hashes, rows, request.threads, journal);
  const std::vector<std::size_t> missing = missing_rows(hashes, rows, [&](const std::string& hash) {
    return journal.holds(hash) && (request.keep_limits || !lacked_time_or_memory(journal.row(hash)));
  });
  const std::size_t known = rows.size() - missing.size();
  if (request.progress) request.progress(known, rows.size(), 0);

  const auto cache =
      std::make_shared<ContactCache>(with_fallback(request.deadline.limiting(find_solver(sweep.solver)->solve)));
  std::optional<FilmTable> table;
  if (sweep.table && !missing.empty()) table = build_table(sweep, request);
  std::mutex mutex;
  const std::size_t threads = in_threads(missing.size(), request.threads, [&](std::size_t i) {
    if (request.deadline.passed()) return;
    const auto row_begin = Clock::now();
    const std::string& hash = hashes.of_row[missing[i]];
    const ComputedRow computed = compute_row(sweep, request, missing[i], hash, cache, table ? &*table : nullptr);
    const double row_s = seconds_since(row_begin);
    if (request.deadline.passed() && lacked_time_or_memory(computed.text)) return;
    const std::lock_guard lock(mutex);
    journal.add(hash, computed.text);
    cost.rows_s += row_s;
    cost.needed += computed.needed;
    ++cost.computed;
    if (request.progress) request.progress(known + cost.computed, rows.size(), cost.computed);
  });
  cost.not_run = missing.size() - cost.computed;
  cost.solves = table ? table->solves + table->held_out : sweep.bearing ? cache->solves() : cost.needed;
  cost.threads = static_cast<unsigned>(threads);
  cost.wall_s = seconds_since(begin);
  return cost;
}

StoredRow kept_row(const Sweep& sweep, std::size_t row, const std::string& hash, const Journal& journal,
                   const std::string& again) {
  if (!journal.holds(hash))
    return read_stored_row(sweep, row, hash, row_not_computed(sweep, row, hash, Deadline::not_run).text);
  try {
    return read_stored_row(sweep, row, hash, journal.row(hash));
  } catch (const StoredRowError& wrong) {
    throw OutputError(
        one_line(fmt::format("{}: row {} is damaged: {}; {}", journal.file().string(), row, wrong.what(), again)));
  }
}

void write_cost(const SweepCost& cost, const std::filesystem::path& folder) {
  OutputFile file(folder / "cost.json", Replaces::file);
  Json json{{"schema", "ehd-sweep-cost-1"}, {"provenance", provenance()}};
  json.update(to_json(cost));
  file.commit(json_text(json));
}

Json to_json(const SweepCost& cost) {
  Json json = Json::object();
  json["rows"] = cost.rows;
  json["computed"] = cost.computed;
  if (cost.not_run > 0) json["not_run"] = cost.not_run;
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
  Journal journal(folder / "rows", {.owner = hashes.of_sweep}, hashes.of(rows), request.fresh);
  for (const char* name : {"rows.csv", "rows.json", "cost.json"})
    const OutputFile refused_before_the_work(folder / name, Replaces::file);
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
