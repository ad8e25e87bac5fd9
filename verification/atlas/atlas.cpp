// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/atlas.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <set>

#include "io/case_reader.hpp"
#include "io/content_hash.hpp"
#include "io/output_file.hpp"
#include "io/store.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification {

namespace {

constexpr std::string_view records_name = ".progress";

/// The key of a point's record in the journal.
std::string key_of(const AtlasPoint& point) { return content_hash(point.id()); }

/// All points, not the selected ones alone: a journal drops rows with other keys.
std::vector<HashNumber> keys_of(const std::vector<AtlasPoint>& points) {
  std::vector<HashNumber> keys;
  for (const AtlasPoint& point : points) keys.push_back(hash_number(key_of(point)).value());
  return keys;
}

/// The record of an earlier run with the same point, solver and tolerance. Absent where a longer time limit may give
/// more digits.
std::optional<AtlasRecord> earlier(const Journal& records, const AtlasPoint& point, const AtlasRecord& asked,
                                   const AtlasPart& part) {
  const std::string key = key_of(point);
  auto record = records.holds(key) ? record_from(records.row(key)) : std::nullopt;
  if (!record || record->id != asked.id || record->solver != asked.solver || record->tolerance != asked.tolerance)
    return std::nullopt;
  const bool more_time = record->time_limit_s < asked.time_limit_s;
  if (more_time && (record->status == StopReason::limit_reached || !part.has_digits(*record))) return std::nullopt;
  return record;
}

/// The case file of a point. Where it differs from the old file, it has the next version.
std::string versioned_text(const std::filesystem::path& file, const AtlasPoint& point, const AtlasRecord& record) {
  const auto old_text = atlas_text(file);
  if (!old_text) return case_text_of(point, record);
  try {
    const int old = read_case(file).version;
    return case_text_of(point, record, *old_text == case_text_of(point, record, old) ? old : old + 1);
  } catch (const CaseError&) {
    return case_text_of(point, record);  // not a case that the atlas wrote
  }
}

}  // namespace

std::vector<AtlasPoint> selected_points(const AtlasRequest& request) {
  std::vector<AtlasPoint> points;
  for (const auto& point : request.points) {
    if (point.id().find(request.only) != std::string::npos) points.push_back(point);
  }
  return points;
}

namespace {

using Entry = AtlasResult::Entry;

/// The selected points, with the records of an earlier run where they hold.
std::vector<Entry> entries_of(const AtlasRequest& request, const AtlasPart& part, const Journal& records) {
  std::vector<Entry> entries;
  for (const AtlasPoint& point : selected_points(request)) {
    Entry entry{.point = point, .record = {}};
    entry.record.id = point.id();
    entry.record.solver = part.solver;
    entry.record.tolerance = request.tolerance ? *request.tolerance : part.usual_tolerance(point);
    entry.record.time_limit_s = request.time_limit_s;
    if (!request.fresh) {
      if (const auto known = earlier(records, point, entry.record, part)) {
        entry.record = *known;
        entry.reused = true;
      }
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Solves the points without a record, the heaviest first, so that no thread is left with a long one at the end.
void solve_missing(std::vector<Entry>& entries, const AtlasRequest& request, const AtlasPart& part, Journal& records) {
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Entry &one = entries[a], &other = entries[b];
    if (one.reused != other.reused) return one.reused;
    return one.point.hertz_pressure_Pa() > other.point.hertz_pressure_Pa();
  });
  std::size_t done = 0;
  std::mutex reporting;
  in_threads(order.size(), request.threads, [&](std::size_t k) {
    Entry& entry = entries[order[k]];
    if (!entry.reused) {
      AtlasRecord solved = part.solve(entry.point, entry.record.tolerance, request.time_limit_s);
      solved.solver = entry.record.solver;
      entry.record = std::move(solved);
    }
    const std::lock_guard lock(reporting);
    if (!entry.reused) records.add(key_of(entry.point), json_of(entry.record));
    ++done;
    if (request.progress) request.progress(done, order.size(), entry.record, entry.reused);
  });
}

/// Rows in the order of the request, then the rows of `before` that belong to no point of the request.
AtlasTable merged(const AtlasRequest& request, const std::vector<Entry>& entries, const AtlasTable& before) {
  std::map<std::string, AtlasRow> rows;
  for (const AtlasRow& row : before.rows) rows[row.at("id")] = row;
  for (const Entry& entry : entries) rows[entry.record.id] = row_of(atlas_row(entry.point, entry.record));
  AtlasTable table;
  for (const AtlasPoint& point : request.points) {
    if (const auto at = rows.find(point.id()); at != rows.end()) {
      table.rows.push_back(at->second);
      rows.erase(at);
    }
  }
  for (const AtlasRow& row : before.rows) {
    if (rows.contains(row.at("id"))) table.rows.push_back(row);
  }
  return table;
}

/// Each file is replaced whole. A run that is interrupted between two files is completed by the next run.
void write_files(const std::filesystem::path& folder, const std::vector<Entry>& entries, const AtlasTable& table) {
  std::map<std::string, std::string> files;
  for (const Entry& entry : entries) {
    const std::string name = entry.record.id + ".toml";
    files[name] = versioned_text(folder / name, entry.point, entry.record);
  }
  files[std::string(atlas_digits_name)] = digits_text(table);
  files[std::string(atlas_csv_name)] = csv_text(table);
  for (const auto& [name, text] : files) {
    replace_file(folder / name, text);
  }
}

}  // namespace

std::vector<AtlasResult::Entry> recorded_entries(const AtlasRequest& request, const AtlasPart& part) {
  make_folder(request.folder);
  Journal records(request.folder / records_name / part.name, {.owner = "atlas " + part.name}, keys_of(request.points),
                  false);
  std::vector<Entry> entries = entries_of(request, part, records);
  solve_missing(entries, request, part, records);
  return entries;
}

void replace_file(const std::filesystem::path& file, const std::string& text) {
  if (atlas_text(file) != text) OutputFile(file, Replaces::file).commit(text);
}

AtlasResult run_atlas(const AtlasRequest& request, const RegisteredSolver& solver) {
  const Stopwatch watch;
  const auto csv = request.folder / atlas_csv_name;
  AtlasTable before;
  if (!request.only.empty() && atlas_text(csv)) before = read_atlas_table(csv);
  make_folder(request.folder);
  { const OutputFile writable(csv, Replaces::file); }  // refused before anything is computed

  AtlasResult result;
  result.entries = recorded_entries(
      request, {.name = "films",
                .solver = atlas_solver_version(solver),
                .usual_tolerance = [](const AtlasPoint& point) { return point.usual_tolerance(); },
                .solve = [&](const AtlasPoint& point, double tolerance,
                             double time_limit_s) { return solve_point(point, solver, tolerance, time_limit_s); },
                .has_digits = [](const AtlasRecord& record) { return record.has_digits(); }});
  const AtlasTable table = merged(request, result.entries, before);
  write_files(request.folder, result.entries, table);

  std::set<std::string> ids;
  for (const AtlasRow& row : table.rows) ids.insert(row.at("id"));
  for (const auto& file : atlas_files(request.folder)) {
    if (!ids.contains(file.stem().string())) result.left_over.push_back(file.filename().string());
  }
  result.wall_s = watch.seconds();
  return result;
}

}  // namespace ehd::verification
