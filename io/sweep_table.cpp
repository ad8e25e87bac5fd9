// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "contact/quantities.hpp"
#include "contact/text.hpp"
#include "io/csv.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/stored_row.hpp"
#include "io/sweep_row.hpp"
#include "workflow/parallel.hpp"

namespace ehd {

namespace {

/// So many rows are made at a time, over threads. This bounds the memory.
constexpr std::size_t block = 256;

std::string json_number(const std::optional<double>& value) { return value ? Json(*value).dump() : ""; }

/// The entry at a path of an object, "film.minimum.hertz". Null pointer: there is no such entry. JSON's null, which is
/// neither text nor number: something on the path is no object.
const Json* entry_at(const Json& json, std::string_view path) {
  static const Json no_entry;
  const Json* at = &json;
  while (!path.empty()) {
    const std::string key(path.substr(0, path.find('.')));
    path.remove_prefix(std::min(path.size(), key.size() + 1));
    if (!at->is_object()) return &no_entry;
    const auto found = at->find(key);
    if (found == at->end()) return nullptr;
    at = &*found;
  }
  return at;
}

std::string reason_cell(const Json& result) { return csv_cell(one_line(converged(result) ? "" : reason_of(result))); }

/// A column of rows.csv behind the row's own keys: its cell from a result in rows.json.
struct Column {
  std::string name;
  std::function<std::string(const Json& result)> cell;
  std::string path = {};  ///< where the cell is an entry of the result
  bool text = false;      ///< that entry is a text, else a number
};
using Columns = std::vector<Column>;

Column at_path(std::string name, const std::string& path) {
  const auto cell = [path](const Json& result) {
    const Json* entry = entry_at(result, path);
    return entry ? entry->dump() : "";
  };
  return {.name = std::move(name), .cell = cell, .path = path};
}

Column text_at(const std::string& path) {
  const auto cell = [path](const Json& result) {
    const Json* entry = entry_at(result, path);
    return entry ? csv_cell(entry->get<std::string>()) : "";
  };
  return {.name = path, .cell = cell, .path = path, .text = true};
}

// ---- Columns of a contact

/// The quantities that are columns, and which values of their entries in the result's JSON. "": the entry is the value.
/// All others are in rows.json alone. New columns belong after `reason`, so that older ones keep their places.
struct InCsv {
  Quantity quantity;
  std::vector<std::string_view> values;
};
const InCsv quantities_in_csv[] = {
    {Quantity::film_minimum, {"hertz", "moes", "m", "error"}},
    {Quantity::film_central, {"hertz", "moes", "m", "error"}},
    {Quantity::film_offset, {"hertz"}},
    {Quantity::pressure_maximum, {"hertz"}},
    {Quantity::approach, {"hertz", "m"}},
    {Quantity::load_error, {""}},
};

Columns contact_columns() {
  Columns columns{text_at("solver"), text_at("status"), at_path("M", "groups.M"), at_path("L", "groups.L"),
                  at_path("hertz_pressure_Pa", "groups.hertz_pressure_Pa")};
  for (const auto& [quantity, values] : quantities_in_csv)
    for (const std::string_view value : values) {
      const std::string path =
          std::string(row_of(quantity).json_entry) + (value.empty() ? "" : "." + std::string(value));
      std::string name = path;
      std::replace(name.begin(), name.end(), '.', '_');
      columns.push_back(at_path(std::move(name), path));
    }
  columns.push_back(at_path("nodes", "cost.nodes"));
  columns.push_back({.name = "reason", .cell = reason_cell});
  return columns;
}

// ---- Columns of a bearing

const Json& rollers_of(const Json& result) {
  static const Json none = Json::array();
  return result.contains("rollers") ? result["rollers"] : none;
}

/// The roller whose inner contact carries most, the first one of equals; null where there are no rollers.
const Json* most_loaded(const Json& result) {
  const Json* most = nullptr;
  for (const Json& roller : rollers_of(result))
    if (!most || roller["inner"]["force_N"].get<double>() > (*most)["inner"]["force_N"].get<double>()) most = &roller;
  return most;
}

/// The extreme of a key over all contacts that have it.
template <class Choose>
Column extreme(std::string name, const char* key, Choose choose) {
  return {.name = std::move(name), .cell = [key, choose](const Json& result) {
            std::optional<double> found;
            for (const Json& roller : rollers_of(result))
              for (const char* raceway : {"inner", "outer"}) {
                if (!roller[raceway].contains(key)) continue;
                const double here = roller[raceway][key].template get<double>();
                found = choose(found.value_or(here), here);
              }
            return json_number(found);
          }};
}

double smaller(double a, double b) { return std::min(a, b); }
double larger(double a, double b) { return std::max(a, b); }

std::string largest_force(const Json& result) {
  const Json* roller = most_loaded(result);
  return roller ? json_number((*roller)["inner"]["force_N"].get<double>()) : "";
}

std::string azimuth_of_largest_force(const Json& result) {
  const Json* roller = most_loaded(result);
  return roller ? json_number((*roller)["azimuth_deg"].get<double>()) : "";
}

/// Contacts of both raceways that carry a force outside the range of their fit; empty for a law without a fit.
std::string fit_used_outside(const Json& result) {
  if (!result.contains("fit") || rollers_of(result).empty()) return "";
  std::size_t outside = 0;
  for (const Json& roller : rollers_of(result))
    for (const char* raceway : {"inner", "outer"}) {
      const double force_N = roller[raceway]["force_N"].get<double>();
      const Json& range = result["fit"][raceway]["load_N"];
      outside += force_N > 0 && !(force_N >= range[0].get<double>() && force_N <= range[1].get<double>());
    }
  return std::to_string(outside);
}

/// Columns that were added later stand after `reason`, so that older columns keep their places.
Columns bearing_columns() {
  return {text_at("law"),
          text_at("status"),
          at_path("displacement_m", "displacement_m"),
          {.name = "largest_force_N", .cell = largest_force},
          {.name = "largest_force_azimuth_deg", .cell = azimuth_of_largest_force},
          extreme("film_minimum_m", "film_minimum_m", smaller),
          extreme("hertz_pressure_maximum_Pa", "hertz_pressure_Pa", larger),
          at_path("loaded_rollers", "loaded_rollers"),
          at_path("balance_error", "balance_error"),
          at_path("contacts", "cost.contact_solves"),
          {.name = "reason", .cell = reason_cell},
          at_path("displacement_lateral_m", "displacement_lateral_m"),
          at_path("datum_inner_x0_m", "datum.inner_x0_m"),
          at_path("datum_outer_x0_m", "datum.outer_x0_m"),
          {.name = "fit_used_outside", .cell = fit_used_outside},
          extreme("lambda_ratio_minimum", "lambda_ratio", smaller),
          at_path("displacement_error_m", "errors.displacement_m"),
          at_path("displacement_lateral_error_m", "errors.displacement_lateral_m"),
          at_path("largest_force_error_N", "errors.largest_force_N"),
          at_path("film_minimum_error", "errors.smallest_film_relative")};
}

const Columns& columns_of(const Sweep& sweep) {
  static const Columns contact = contact_columns(), bearing = bearing_columns();
  return sweep.bearing ? bearing : contact;
}

/// provenance() without what two shards of one build may differ in.
Json build_provenance() {
  Json json = provenance();
  for (const char* of_the_machine : {"cpu", "cores", "date"}) json.erase(of_the_machine);
  return json;
}

std::string head_of_json(const Sweep& sweep, const std::string& sweep_hash) {
  Json stated = sweep.to_json();
  stated["hash"] = sweep_hash;
  return fmt::format("{{\"schema\":{},\n\"provenance\":{},\n\"sweep\":{},\n\"rows\":[", Json(sweep_schema).dump(),
                     build_provenance().dump(), stated.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// A row's lines in rows.csv, from its object in rows.json.
std::string csv_lines(const Sweep& sweep, const Json& row) {
  std::string begin = row["row"].dump();
  for (const SweptKey& one : sweep.keys) {
    const Json& value = row["keys"][one.key];
    begin += "," + (value.is_string() ? csv_cell(value.get<std::string>()) : value.dump());
  }
  std::string lines;
  for (const Json& result : row["results"]) {
    lines += begin;
    for (const Column& column : columns_of(sweep)) lines += "," + column.cell(result);
    lines += "\n";
  }
  return lines;
}

}  // namespace

std::string csv_header(const Sweep& sweep) {
  std::string header = "row";
  for (const SweptKey& one : sweep.keys) header += "," + csv_cell(one.key);
  for (const Column& column : columns_of(sweep)) header += "," + column.name;
  return header + "\n";
}

std::string wrong_csv_entry(const Sweep& sweep, const Json& result) {
  for (const Column& column : columns_of(sweep)) {
    const Json* entry = column.path.empty() ? nullptr : entry_at(result, column.path);
    if (entry && !(column.text ? entry->is_string() : entry->is_number()))
      return column.path + (column.text ? " is no text" : " is no number");
  }
  return "";
}

void Failures::add(const std::optional<std::string>& failure) {
  if (!failure) return;
  if (++rows == 1) first = *failure;
  if (failure->find(Deadline::not_run) != std::string::npos) ++not_run;
}

Failures write_table(const Sweep& sweep, const std::string& sweep_hash, const std::filesystem::path& folder,
                     const std::function<StoredRow(std::size_t row)>& row_of, unsigned threads) {
  OutputFile csv(folder / "rows.csv", Replaces::file), json(folder / "rows.json", Replaces::file);
  json.append(head_of_json(sweep, sweep_hash));
  csv.append(csv_header(sweep));
  struct Written {
    std::string object, lines;
    std::optional<std::string> failure;
  };
  Failures failures;
  for (std::size_t first = 0; first < sweep.rows(); first += block) {
    std::vector<Written> rows(std::min(block, sweep.rows() - first));
    in_threads(rows.size(), threads, [&](std::size_t i) {
      StoredRow row = row_of(first + i);
      rows[i].object = std::move(row.text);
      rows[i].failure = failure_of(row.json);
      rows[i].lines = csv_lines(sweep, row.json);
    });
    std::string objects, lines;
    for (const Written& row : rows) {
      objects += (&row == &rows.front() && first == 0 ? "\n" : ",\n") + row.object;
      lines += row.lines;
      failures.add(row.failure);
    }
    json.append(objects);
    csv.append(lines);
  }
  json.append("\n]}\n");
  commit_together({&json, &csv});
  return failures;
}

}  // namespace ehd
