// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "contact/quantities.hpp"
#include "contact/text.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/sweep_row.hpp"
#include "workflow/parallel.hpp"

namespace ehd {

namespace {

constexpr const char* schema = "ehd-sweep-1";
/// So many rows are made at a time, over threads. This bounds the memory.
constexpr std::size_t block = 256;

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string{c};
  return quoted + "\"";
}

std::string number_cell(const std::optional<double>& value) { return value ? Json(*value).dump() : ""; }

/// The value at a path of an object, "film.minimum.hertz"; empty where there is none.
std::string value_at(const Json& json, std::string_view path) {
  const Json* at = &json;
  while (!path.empty()) {
    const std::string key(path.substr(0, path.find('.')));
    path.remove_prefix(std::min(path.size(), key.size() + 1));
    if (!at->is_object() || !at->contains(key)) return "";
    at = &(*at)[key];
  }
  return at->is_string() ? csv_cell(at->get<std::string>()) : at->is_number() ? at->dump() : "";
}

std::string reason_cell(const Json& result) { return csv_cell(one_line(converged(result) ? "" : reason_of(result))); }

/// A column of rows.csv behind the row's own keys: its cell from a result in rows.json.
struct Column {
  std::string name;
  std::function<std::string(const Json& result)> cell;
};
using Columns = std::vector<Column>;

Column at_path(std::string name, std::string path) {
  return {std::move(name), [path = std::move(path)](const Json& result) { return value_at(result, path); }};
}

// ---- Columns of a contact

/// The quantities of the table, each with the values of its entry in the result's JSON. "": the entry is the value.
struct QuantityColumns {
  Quantity quantity;
  std::vector<std::string_view> values;
};

const std::vector<QuantityColumns>& quantities() {
  static const std::vector<QuantityColumns> list{{Quantity::film_minimum, {"hertz", "moes", "m", "error"}},
                                                 {Quantity::film_central, {"hertz", "moes", "m", "error"}},
                                                 {Quantity::film_offset, {"hertz"}},
                                                 {Quantity::pressure_maximum, {"hertz"}},
                                                 {Quantity::approach, {"hertz", "m"}},
                                                 {Quantity::load_error, {""}}};
  return list;
}

Columns contact_columns() {
  Columns columns{at_path("solver", "solver"), at_path("status", "status"), at_path("M", "groups.M"),
                  at_path("L", "groups.L"), at_path("hertz_pressure_Pa", "groups.hertz_pressure_Pa")};
  for (const auto& [quantity, values] : quantities())
    for (const std::string_view value : values) {
      const std::string path =
          std::string(row_of(quantity).json_entry) + (value.empty() ? "" : "." + std::string(value));
      std::string name = path;
      std::replace(name.begin(), name.end(), '.', '_');
      columns.push_back(at_path(std::move(name), path));
    }
  columns.push_back(at_path("nodes", "cost.nodes"));
  columns.push_back({"reason", reason_cell});
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
  return {std::move(name), [key, choose](const Json& result) {
            std::optional<double> found;
            for (const Json& roller : rollers_of(result))
              for (const char* raceway : {"inner", "outer"}) {
                if (!roller[raceway].contains(key)) continue;
                const double here = roller[raceway][key].template get<double>();
                found = choose(found.value_or(here), here);
              }
            return number_cell(found);
          }};
}

double smaller(double a, double b) { return std::min(a, b); }
double larger(double a, double b) { return std::max(a, b); }

std::string largest_force(const Json& result) {
  const Json* roller = most_loaded(result);
  return roller ? number_cell((*roller)["inner"]["force_N"].get<double>()) : "";
}

std::string azimuth_of_largest_force(const Json& result) {
  const Json* roller = most_loaded(result);
  return roller ? number_cell((*roller)["azimuth_deg"].get<double>()) : "";
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
  return {at_path("law", "law"),
          at_path("status", "status"),
          at_path("displacement_m", "displacement_m"),
          {"largest_force_N", largest_force},
          {"largest_force_azimuth_deg", azimuth_of_largest_force},
          extreme("film_minimum_m", "film_minimum_m", smaller),
          extreme("hertz_pressure_maximum_Pa", "hertz_pressure_Pa", larger),
          at_path("loaded_rollers", "loaded_rollers"),
          at_path("balance_error", "balance_error"),
          at_path("contacts", "cost.contact_solves"),
          {"reason", reason_cell},
          at_path("displacement_lateral_m", "displacement_lateral_m"),
          at_path("datum_inner_x0_m", "datum.inner_x0_m"),
          at_path("datum_outer_x0_m", "datum.outer_x0_m"),
          {"fit_used_outside", fit_used_outside},
          extreme("lambda_ratio_minimum", "lambda_ratio", smaller)};
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
  return "{\"schema\":" + Json(schema).dump() + ",\n\"provenance\":" + build_provenance().dump() +
         ",\n\"sweep\":" + stated.dump(-1, ' ', false, Json::error_handler_t::replace) + ",\n\"rows\":[";
}

}  // namespace

std::string csv_header(const Sweep& sweep) {
  std::string header = "row";
  for (const SweptKey& one : sweep.keys) header += "," + csv_cell(one.key);
  for (const Column& column : columns_of(sweep)) header += "," + column.name;
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
    lines += begin;
    for (const Column& column : columns_of(sweep)) lines += "," + column.cell(result);
    lines += "\n";
  }
  return lines;
}

void Failures::add(const std::optional<std::string>& failure) {
  if (!failure) return;
  if (++rows == 1) first = *failure;
}

Failures write_table(const Sweep& sweep, const std::string& sweep_hash, const std::filesystem::path& folder,
                     const std::function<std::string(std::size_t row)>& row_of, unsigned threads) {
  OutputFile csv(folder / "rows.csv"), json(folder / "rows.json");
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
      rows[i].object = numbered_row(first + i, row_of(first + i));
      const Json parsed = Json::parse(rows[i].object);
      rows[i].failure = failure_of(parsed);
      rows[i].lines = csv_lines(sweep, parsed);
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
  json.commit();
  csv.commit();
  return failures;
}

}  // namespace ehd
