// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_run.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <fstream>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>

#include "contact/text.hpp"
#include "io/bearing_json.hpp"
#include "io/case_reader.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/sha256.hpp"
#include "io/store.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/contact_cache.hpp"
#include "workflow/contact_memory.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/parallel.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

constexpr const char* schema = "ehd-sweep-1";

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

// ---- What a row is made of -----------------------------------------------------------------------------------------

namespace {

/// Two builds of a commit with changes on top, or of a tree without git, are told apart by the program's own bytes.
std::string program_identity() {
  const Json json = provenance();
  std::string identity =
      json.contains("commit") ? json["commit"].get<std::string>() : json["version"].get<std::string>();
  if (json.contains("commit") && !json["dirty"].get<bool>()) return identity;
  std::ostringstream bytes;
  bytes << std::ifstream("/proc/self/exe", std::ios::binary).rdbuf();
  return identity + " " + sha256(bytes.str());
}

/// provenance() without what two shards of one build may differ in.
Json build_provenance() {
  Json json = provenance();
  for (const char* of_the_machine : {"cpu", "cores", "date"}) json.erase(of_the_machine);
  return json;
}

/// Times out of a result, at any depth.
void strip_times(Json& json) {
  if (json.is_object())
    for (const char* time : {"wall_s", "planning_s", "stage_s"}) json.erase(time);
  if (json.is_structured())
    for (auto& inner : json) strip_times(inner);
}

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string row_hash(const Sweep& sweep, const SweepRequest& request, std::size_t row) {
  static const std::string program = program_identity();
  std::string content = std::string(schema) + "\n" + program + "\n" + sweep.solver + "\n" +
                        std::to_string(request.max_iterations) + " " + number_text(request.time_limit_s) + "\n";
  content += number_text(sweep.bearing ? *ContactMemory::bearing_request().tolerance : sweep.tolerance) + "\n";
  for (const bearing::Law law : sweep.laws) content += std::string(to_string(law)) + " ";
  content += "\n" + sweep.case_id + "\n";
  for (const Substitution& one : sweep.values_of(row)) content += one.key + " = " + toml_text(one.value) + "\n";
  return sha256(content + sweep.case_text);
}

std::vector<std::size_t> rows_of(const Sweep& sweep, const Shard& shard) {
  std::vector<std::size_t> rows;
  for (std::size_t row = shard.number - 1; row < sweep.rows(); row += shard.of) rows.push_back(row);
  return rows;
}

// ---- The table -----------------------------------------------------------------------------------------------------

namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string{c};
  return quoted + "\"";
}

/// The value at a path of an object, empty where there is none.
std::string csv_value(const Json& json, const std::vector<const char*>& path) {
  const Json* at = &json;
  for (const char* key : path) {
    if (!at->is_object() || !at->contains(key)) return "";
    at = &(*at)[key];
  }
  return at->is_string() ? csv_cell(at->get<std::string>()) : at->is_number() ? at->dump() : "";
}

struct ContactColumn {
  const char* name;
  std::vector<const char*> path;
};

const std::vector<ContactColumn>& contact_columns() {
  static const std::vector<ContactColumn> columns{
      {"M", {"groups", "M"}},
      {"L", {"groups", "L"}},
      {"hertz_pressure_Pa", {"groups", "hertz_pressure_Pa"}},
      {"film_minimum_hertz", {"film", "minimum", "hertz"}},
      {"film_minimum_moes", {"film", "minimum", "moes"}},
      {"film_minimum_m", {"film", "minimum", "m"}},
      {"film_minimum_error", {"film", "minimum", "error"}},
      {"film_central_hertz", {"film", "central", "hertz"}},
      {"film_central_moes", {"film", "central", "moes"}},
      {"film_central_m", {"film", "central", "m"}},
      {"film_central_error", {"film", "central", "error"}},
      {"film_offset_hertz", {"film", "offset", "hertz"}},
      {"pressure_maximum_hertz", {"pressure", "maximum", "hertz"}},
      {"approach_hertz", {"approach", "hertz"}},
      {"approach_m", {"approach", "m"}},
      {"load_error", {"load_error"}},
      {"nodes", {"cost", "nodes"}},
  };
  return columns;
}

/// The rollers of one law in a line of the table: the most loaded inner contact, the thinnest film and the highest
/// pressure of all contacts.
std::string bearing_cells(const Json& result) {
  std::optional<double> force_N, azimuth_deg, film_m, pressure_Pa;
  std::size_t loaded = 0;
  const Json none = Json::array();
  const Json& rollers = result.contains("rollers") ? result["rollers"] : none;
  for (const Json& roller : rollers) {
    const double inner_N = roller["inner"]["force_N"].get<double>();
    loaded += inner_N > 0;
    if (!force_N || inner_N > *force_N) {
      force_N = inner_N;
      azimuth_deg = roller["azimuth_deg"].get<double>();
    }
    for (const char* raceway : {"inner", "outer"}) {
      const Json& contact = roller[raceway];
      if (contact.contains("film_minimum_m")) {
        const double one = contact["film_minimum_m"].get<double>();
        film_m = std::min(film_m.value_or(one), one);
      }
      if (contact.contains("hertz_pressure_Pa")) {
        const double one = contact["hertz_pressure_Pa"].get<double>();
        pressure_Pa = std::max(pressure_Pa.value_or(one), one);
      }
    }
  }
  const auto cell = [](const std::optional<double>& value) { return value ? "," + Json(*value).dump() : ","; };
  return "," + csv_value(result, {"displacement_m"}) + cell(force_N) + cell(azimuth_deg) + cell(film_m) +
         cell(pressure_Pa) + "," + (rollers.empty() ? "" : std::to_string(loaded)) + "," +
         csv_value(result, {"balance_error"}) + "," + csv_value(result, {"cost", "contact_solves"});
}

/// What was added later, behind every other column: where the ring goes across, the datum, use of the line outside its
/// fit (contacts that carry a force outside, of both raceways; of ehd-linear alone), the thinnest film over the
/// roughness.
std::string later_bearing_cells(const Json& result) {
  std::optional<double> ratio;
  std::size_t outside = 0;
  const Json none = Json::array();
  const Json& rollers = result.contains("rollers") ? result["rollers"] : none;
  const bool fitted = result.contains("fit") && !rollers.empty();
  for (const Json& roller : rollers)
    for (const char* raceway : {"inner", "outer"}) {
      const Json& contact = roller[raceway];
      if (contact.contains("lambda_ratio")) {
        const double one = contact["lambda_ratio"].get<double>();
        ratio = std::min(ratio.value_or(one), one);
      }
      if (!fitted) continue;
      const double force_N = contact["force_N"].get<double>();
      const Json& range = result["fit"][raceway]["load_N"];
      outside += force_N > 0 && !(force_N >= range[0].get<double>() && force_N <= range[1].get<double>());
    }
  return "," + csv_value(result, {"displacement_lateral_m"}) + "," + csv_value(result, {"datum", "inner_x0_m"}) + "," +
         csv_value(result, {"datum", "outer_x0_m"}) + "," + (fitted ? std::to_string(outside) : "") + "," +
         (ratio ? Json(*ratio).dump() : "");
}

bool converged(const Json& result) { return result["status"] == to_string(StopReason::converged); }

/// Why a result is not what was asked for; bearings and contacts name it differently.
std::string reason_of(const Json& result) {
  for (const char* key : {"why", "reason"})
    if (result.contains(key)) return result[key].get<std::string>();
  if (converged(result) || !result.contains("notes") || result["notes"].empty()) return "";
  return result["notes"].back().get<std::string>();
}

}  // namespace

std::string csv_header(const Sweep& sweep) {
  std::string header = "row";
  for (const SweptKey& one : sweep.keys) header += "," + csv_cell(one.key);
  if (sweep.bearing) {
    header +=
        ",law,status,displacement_m,largest_force_N,largest_force_azimuth_deg,film_minimum_m,"
        "hertz_pressure_maximum_Pa,loaded_rollers,balance_error,contacts";
  } else {
    header += ",solver,status";
    for (const ContactColumn& column : contact_columns()) header += std::string(",") + column.name;
  }
  header += ",reason";
  if (sweep.bearing)
    header += ",displacement_lateral_m,datum_inner_x0_m,datum_outer_x0_m,fit_used_outside,lambda_ratio_minimum";
  return header + "\n";
}

std::string csv_lines(const Sweep& sweep, const Json& row) {
  std::string begin = row["row"].dump();
  for (const SweptKey& one : sweep.keys) {
    const Json& value = row["keys"][one.key];
    begin += "," + (value.is_string() ? csv_cell(value.get<std::string>()) : value.dump());
  }
  std::string lines;
  for (const Json& result : row["results"]) {
    std::string line =
        begin + "," + csv_value(result, {sweep.bearing ? "law" : "solver"}) + "," + csv_value(result, {"status"});
    if (sweep.bearing) {
      line += bearing_cells(result);
    } else {
      for (const ContactColumn& column : contact_columns()) line += "," + csv_value(result, column.path);
    }
    const std::string why = converged(result) ? "" : reason_of(result);
    lines += line + "," + csv_cell(one_line(why)) + (sweep.bearing ? later_bearing_cells(result) : "") + "\n";
  }
  return lines;
}

// ---- The run -------------------------------------------------------------------------------------------------------

namespace {

/// A row as it is kept: all of its object in rows.json but its number.
struct ComputedRow {
  std::string text;
  long needed = 0;
};

ComputedRow compute(const Sweep& sweep, const SweepRequest& request, std::size_t row, const std::string& hash,
                    const std::shared_ptr<ContactCache>& shared) {
  const Case row_case = sweep.case_of(row);
  ComputedRow computed;
  Json json = Json::object();
  json["keys"] = Json::object();
  for (const Substitution& one : sweep.values_of(row)) json["keys"][one.key] = to_json(one.value);
  json["hash"] = hash;
  json["results"] = Json::array();
  if (sweep.bearing) {
    Request limits = ContactMemory::bearing_request();
    limits.max_iterations = request.max_iterations;
    limits.time_limit_s = request.time_limit_s;
    // A memory of the row's own: what it counts, and whether it holds contacts that missed their tolerance, is then of
    // this row. Solves are shared behind it.
    ContactMemory memory(shared, limits);
    for (const BearingResult& result : run_bearing(row_case, sweep.request_of(row_case), memory))
      json["results"].push_back(to_json(result));
    computed.needed = memory.solves();
  } else {
    Request asked;
    asked.tolerance = sweep.tolerance;
    asked.max_iterations = request.max_iterations;
    asked.time_limit_s = request.time_limit_s;
    const ContactRun run = run_contact(row_case, *find_solver(sweep.solver), asked);
    json["results"].push_back(to_json(run));
    computed.needed = run.plan.runs(stage::solve) ? 1 : 0;
  }
  strip_times(json["results"]);
  computed.text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return computed;
}

struct Hashes {
  std::vector<std::string> of_row;
  std::string of_sweep;
};

Hashes hashes_of(const Sweep& sweep, const SweepRequest& request) {
  Hashes hashes;
  std::string all;
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    hashes.of_row.push_back(row_hash(sweep, request, row));
    all += hashes.of_row.back();
  }
  hashes.of_sweep = sha256(all);
  return hashes;
}

/// {"row": 7, …} of a kept row.
std::string numbered(std::size_t row, const std::string& kept) {
  return "{\"row\":" + std::to_string(row) + "," + kept.substr(1);
}

void note_failure(const Json& row, SweepCost& cost) {
  for (const Json& result : row["results"]) {
    if (converged(result)) continue;
    ++cost.failed;
    if (cost.first_failure.empty()) {
      const std::string law = result.contains("law") ? result["law"].get<std::string>() + ": " : "";
      const std::string why = reason_of(result);
      cost.first_failure = "row " + row["row"].dump() + ": " + law + result["status"].get<std::string>() +
                           (why.empty() ? "" : ": " + why);
    }
    return;
  }
}

/// Computes the rows that the journal does not hold, over threads.
SweepCost compute_missing(const Sweep& sweep, const SweepRequest& request, const Hashes& hashes,
                          const std::vector<std::size_t>& rows, SweepJournal& journal) {
  const auto begin = Clock::now();
  SweepCost cost{.rows = rows.size()};
  std::set<std::string> taken;  // equal rows are computed once
  std::vector<std::size_t> missing;
  for (const std::size_t row : rows)
    if (!journal.holds(hashes.of_row[row]) && taken.insert(hashes.of_row[row]).second) missing.push_back(row);
  const std::size_t known = rows.size() - missing.size();
  if (request.progress) request.progress(known, rows.size(), 0);

  const auto shared = std::make_shared<ContactCache>(with_fallback(find_solver(sweep.solver)->solve));
  std::mutex mutex;
  in_threads(missing.size(), request.threads, [&](std::size_t i) {
    const auto row_begin = Clock::now();
    const ComputedRow computed = compute(sweep, request, missing[i], hashes.of_row[missing[i]], shared);
    const double row_s = seconds_since(row_begin);
    const std::lock_guard lock(mutex);
    journal.add(hashes.of_row[missing[i]], computed.text);
    cost.rows_s += row_s;
    cost.needed += computed.needed;
    ++cost.computed;
    if (request.progress) request.progress(known + cost.computed, rows.size(), cost.computed);
  });
  cost.solves = sweep.bearing ? shared->solves() : cost.needed;
  cost.threads = request.threads > 0 ? request.threads : std::max(1u, std::thread::hardware_concurrency());
  cost.wall_s = seconds_since(begin);
  return cost;
}

/// rows.csv and rows.json, from rows as `row_of` has them.
void write_table(const Sweep& sweep, const Hashes& hashes, const std::filesystem::path& folder,
                 const std::function<std::string(std::size_t row)>& row_of, unsigned threads, SweepCost& cost) {
  OutputFile csv(folder / "rows.csv"), json(folder / "rows.json");
  std::string lines = csv_header(sweep);
  Json stated = sweep.to_json();
  stated["hash"] = hashes.of_sweep;
  std::string objects = "{\"schema\":" + Json(schema).dump() + ",\n\"provenance\":" + build_provenance().dump() +
                        ",\n\"sweep\":" + stated.dump(-1, ' ', false, Json::error_handler_t::replace) + ",\n\"rows\":[";
  // A block of rows at a time: over threads, and no more of them in memory.
  constexpr std::size_t block = 256;
  struct Written {
    std::string object, lines;
    SweepCost failure;
  };
  for (std::size_t first = 0; first < sweep.rows(); first += block) {
    std::vector<Written> rows(std::min(block, sweep.rows() - first));
    in_threads(rows.size(), threads, [&](std::size_t i) {
      rows[i].object = numbered(first + i, row_of(first + i));
      const Json parsed = Json::parse(rows[i].object);
      note_failure(parsed, rows[i].failure);
      rows[i].lines = csv_lines(sweep, parsed);
    });
    for (const Written& row : rows) {
      objects += (&row == &rows.front() && first == 0 ? "\n" : ",\n") + row.object;
      lines += row.lines;
      cost.failed += row.failure.failed;
      if (cost.first_failure.empty()) cost.first_failure = row.failure.first_failure;
    }
    json.append(objects);
    csv.append(lines);
    objects.clear();
    lines.clear();
  }
  json.append(objects + "\n]}\n");
  csv.append(lines);
  json.commit();
  csv.commit();
}

std::filesystem::path shards_folder(const std::filesystem::path& folder) { return folder / "shards"; }
std::string shard_name(const Shard& shard) { return std::to_string(shard.number) + "-of-" + std::to_string(shard.of); }

void write_cost(const SweepCost& cost, const std::filesystem::path& folder) {
  OutputFile file(folder / "cost.json");
  Json json = to_json(cost);
  json["provenance"] = provenance();
  file.commit(json_text(json));
}

std::set<std::string> hashes_of_rows(const Hashes& hashes, const std::vector<std::size_t>& rows) {
  std::set<std::string> wanted;
  for (const std::size_t row : rows) wanted.insert(hashes.of_row[row]);
  return wanted;
}

}  // namespace

Json to_json(const SweepCost& cost) {
  Json json = Json::object();
  json["rows"] = cost.rows;
  json["computed"] = cost.computed;
  json["failed"] = cost.failed;
  json["contact_solves"] = cost.solves;
  json["contact_solves_saved"] = cost.saved();
  json["threads"] = cost.threads;
  put(json, "wall_s", cost.wall_s);
  put(json, "rows_s", cost.rows_s);
  return json;
}

SweepCost run_sweep(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder) {
  const Hashes hashes = hashes_of(sweep, request);
  const std::vector<std::size_t> rows = rows_of(sweep, {});
  SweepJournal journal(folder / "rows", {.sweep = hashes.of_sweep}, hashes_of_rows(hashes, rows), request.fresh);
  { const OutputFile csv(folder / "rows.csv"), json(folder / "rows.json"); }  // refused before the work, not after
  const auto begin = Clock::now();
  SweepCost cost = compute_missing(sweep, request, hashes, rows, journal);
  write_table(
      sweep, hashes, folder, [&](std::size_t row) { return journal.row(hashes.of_row[row]); }, request.threads, cost);
  cost.wall_s = seconds_since(begin);
  write_cost(cost, folder);
  return cost;
}

SweepCost run_shard(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder,
                    const Shard& shard) {
  const Hashes hashes = hashes_of(sweep, request);
  const std::vector<std::size_t> rows = rows_of(sweep, shard);
  const auto own = shards_folder(folder) / shard_name(shard);
  SweepJournal journal(own, {.sweep = hashes.of_sweep, .shard = shard.number, .of = shard.of},
                       hashes_of_rows(hashes, rows), request.fresh);
  SweepCost cost = compute_missing(sweep, request, hashes, rows, journal);
  for (const std::size_t row : rows) note_failure(Json::parse(numbered(row, journal.row(hashes.of_row[row]))), cost);
  write_cost(cost, own);
  return cost;
}

namespace {

/// N of the shards K-of-N in the folder.
std::size_t shards_in(const std::filesystem::path& folder) {
  std::set<std::size_t> numbers;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const auto middle = name.find("-of-");
    if (middle == std::string::npos) continue;
    const char *begin = name.data() + middle + 4, *end = name.data() + name.size();
    std::size_t of = 0;
    if (const auto parsed = std::from_chars(begin, end, of); parsed.ec == std::errc() && parsed.ptr == end && of > 0)
      numbers.insert(of);
  }
  if (numbers.empty())
    throw OutputError(one_line(folder.string() + ": there are no shards to merge; run --shard 1/N to N/N with the same "
                                                 "--output before"));
  if (numbers.size() > 1)
    throw OutputError(one_line(folder.string() + ": shards of " + std::to_string(*numbers.begin()) + " and of " +
                               std::to_string(*numbers.rbegin()) +
                               " stand side by side; allowed is one division, and "
                               "the folders of the other must go"));
  return *numbers.begin();
}

}  // namespace

SweepCost merge_shards(const Sweep& sweep, const SweepRequest& request, const std::filesystem::path& folder) {
  const auto begin = Clock::now();
  const Hashes hashes = hashes_of(sweep, request);
  const std::size_t of = shards_in(shards_folder(folder));
  std::vector<std::unique_ptr<SweepJournal>> journals;
  for (std::size_t number = 1; number <= of; ++number) {
    const Shard shard{number, of};
    const auto own = shards_folder(folder) / shard_name(shard);
    const JournalHeader header{.sweep = hashes.of_sweep, .shard = number, .of = of};
    journals.push_back(std::make_unique<SweepJournal>(own, header));
    std::size_t known = 0;
    const std::vector<std::size_t> rows = rows_of(sweep, shard);
    for (const std::size_t row : rows) known += journals.back()->holds(hashes.of_row[row]);
    if (known < rows.size())
      throw OutputError(one_line((own / "journal").string() + ": the shard is not finished, it holds " +
                                 std::to_string(known) + " of " + std::to_string(rows.size()) +
                                 " rows; run again --shard " + std::to_string(number) + "/" + std::to_string(of)));
  }
  SweepCost cost{.rows = sweep.rows()};
  write_table(
      sweep, hashes, folder, [&](std::size_t row) { return journals[row % of]->row(hashes.of_row[row]); },
      request.threads, cost);
  cost.wall_s = seconds_since(begin);
  return cost;
}

}  // namespace ehd
