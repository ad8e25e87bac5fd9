// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_run.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

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
  std::set<std::string> taken;
  std::vector<std::size_t> missing;
  const auto known_already = [&](const std::string& hash) {
    return journal.holds(hash) && (request.keep_limits || !lacked_time_or_memory(journal.row(hash)));
  };
  for (const std::size_t row : rows)
    if (!known_already(hashes.of_row[row]) && taken.insert(hashes.of_row[row]).second) missing.push_back(row);
  const std::size_t known = rows.size() - missing.size();
  if (request.progress) request.progress(known, rows.size(), 0);

  const auto cache =
      std::make_shared<ContactCache>(with_fallback(request.deadline.limiting(find_solver(sweep.solver)->solve)));
  std::mutex mutex;
  const std::size_t threads = in_threads(missing.size(), request.threads, [&](std::size_t i) {
    if (request.deadline.passed()) return;
    const auto row_begin = Clock::now();
    const std::string& hash = hashes.of_row[missing[i]];
    const ComputedRow computed = compute_row(sweep, request, missing[i], hash, cache);
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
  cost.solves = sweep.bearing ? cache->solves() : cost.needed;
  cost.threads = static_cast<unsigned>(threads);
  cost.wall_s = seconds_since(begin);
  return cost;
}

std::string kept_row(const Sweep& sweep, const SweepHashes& hashes, const SweepJournal& journal, std::size_t row) {
  const std::string& hash = hashes.of_row[row];
  return journal.holds(hash) ? journal.row(hash) : row_not_computed(sweep, row, hash, Deadline::not_run).text;
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
  SweepJournal journal(folder / "rows", {.sweep = hashes.of_sweep}, hashes.of(rows), request.fresh);
  { const OutputFile csv(folder / "rows.csv"), json(folder / "rows.json"); }  // refused before the work, not after
  const auto begin = Clock::now();
  SweepCost cost = compute_missing(sweep, request, hashes, rows, journal);
  cost.failures = write_table(
      sweep, hashes.of_sweep, folder, [&](std::size_t row) { return kept_row(sweep, hashes, journal, row); },
      request.threads);
  cost.wall_s = seconds_since(begin);
  write_cost(cost, folder);
  return cost;
}

}  // namespace ehd
