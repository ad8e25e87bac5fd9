// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stored_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "bearing/law_table.hpp"
#include "io/contact_json.hpp"
#include "io/sweep_table.hpp"

namespace ehd {

namespace {

void require(bool right, const char* what) {
  if (!right) throw StoredRowError(what);
}

/// The member of an object, or StoredRowError.
const Json& member(const Json& of, const char* key) {
  const auto at = of.is_object() ? of.find(key) : of.end();
  if (!of.is_object() || at == of.end()) throw StoredRowError(fmt::format("{} is missing", key));
  return *at;
}

bool holds_null(const Json& json) {
  if (json.is_structured()) return std::any_of(json.begin(), json.end(), holds_null);
  return json.is_null();
}

void check_text(const Json& result, const char* key) {
  if (result.contains(key) && !result[key].is_string()) throw StoredRowError(fmt::format("{} is no text", key));
}

/// An object of numbers, with `required` among them.
void check_numbers(const Json& json, const char* required) {
  require(member(json, required).is_number(), "a contact or a roller has no number where one is required");
  for (const auto& [key, value] : json.items())
    if (!value.is_number()) throw StoredRowError(fmt::format("{} is no number", key));
}

void check_rollers(const Json& rollers) {
  require(rollers.is_array(), "rollers is no list");
  for (const Json& roller : rollers) {
    require(member(roller, "azimuth_deg").is_number(), "azimuth_deg is no number");
    for (const char* raceway : {"inner", "outer"}) check_numbers(member(roller, raceway), "force_N");
  }
}

void check_fit(const Json& fit) {
  for (const char* raceway : {"inner", "outer"}) {
    const Json& range = member(member(fit, raceway), "load_N");
    require(range.is_array() && range.size() == 2 && range[0].is_number() && range[1].is_number(),
            "the load_N of a fit is no pair of numbers");
  }
}

void check_result(const Sweep& sweep, const Json& result) {
  require(result.is_object(), "a result is no object");
  const Json& status = member(result, "status");
  require(status.is_string() && stop_reason_from(status.get_ref<const std::string&>()), "a status is unknown");
  for (const char* key : {"law", "why", "reason"}) check_text(result, key);
  if (result.contains("rollers")) check_rollers(result["rollers"]);
  if (result.contains("fit")) check_fit(result["fit"]);
  if (result.contains("notes")) {
    const Json& notes = result["notes"];
    require(notes.is_array() && std::all_of(notes.begin(), notes.end(), [](const Json& n) { return n.is_string(); }),
            "notes is no list of texts");
  }
  if (const std::string wrong = wrong_csv_entry(sweep, result); !wrong.empty()) throw StoredRowError(wrong);
}

/// A bearing has a result for each law, in the order of the sweep where it names them; a contact has one.
void check_results(const Sweep& sweep, const Json& results) {
  require(results.is_array() && !results.empty(), "results is no list of results");
  for (const Json& result : results) check_result(sweep, result);
  if (!sweep.bearing) return require(results.size() == 1, "a contact has more than one result");
  std::set<std::string> laws;
  for (const Json& result : results) {
    const std::string law = member(result, "law").get<std::string>();
    require(bearing::law_from(law) && laws.insert(law).second, "a law is unknown or there twice");
  }
  if (sweep.laws.empty()) return;
  require(results.size() == sweep.laws.size(), "the results are not those of the sweep's laws");
  for (std::size_t i = 0; i < results.size(); ++i)
    require(results[i]["law"] == to_string(sweep.laws[i]), "the results are not those of the sweep's laws");
}

}  // namespace

StoredRow read_stored_row(const Sweep& sweep, std::size_t row, const std::string& hash, const std::string& kept) {
  StoredRow read;
  try {
    read.json = json_from(kept);
  } catch (const JsonError& wrong) {
    throw StoredRowError(wrong.what());
  }
  require(kept.starts_with("{\"keys\":") && read.json.size() == 3, "the row is no object of keys, hash and results");
  Json keys = Json::object();
  for (const Substitution& one : sweep.values_of(row)) keys[one.key] = to_json(one.value);
  require(read.json["keys"] == keys, "the keys are those of another row");
  require(member(read.json, "hash") == hash, "the hash is that of another row");
  check_results(sweep, member(read.json, "results"));
  require(!holds_null(read.json), "the row holds null");
  read.text = fmt::format("{{\"row\":{},{}", row, std::string_view(kept).substr(1));
  read.json["row"] = row;
  return read;
}

}  // namespace ehd
