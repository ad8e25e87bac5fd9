// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/json.hpp"
#include "io/sweep_films.hpp"

namespace ehd {

namespace {

constexpr std::size_t longest_row = 300;  // of a row's values in a message

/// The swept key that a message of the case reader is about. The reader names a key without its table, or the table.
std::optional<std::size_t> key_in_message(const std::vector<SweptKey>& keys, const std::string& message) {
  const auto says = [&message](const std::string& words) { return message.find(words) != std::string::npos; };
  std::optional<std::size_t> by_table;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::string& key = keys[k].key;
    const auto dot = key.rfind('.');
    if (says(" " + key.substr(dot + 1) + " = ") || message.starts_with(key)) return k;
    if (!by_table && says("[" + key.substr(0, dot) + "]")) by_table = k;
  }
  return keys.size() == 1 ? std::optional<std::size_t>(0) : by_table;
}

}  // namespace

Json to_json(const TomlValue& value) {
  return std::visit([](const auto& content) { return Json(content); }, value);
}

std::size_t Sweep::rows() const {
  if (combine == Combine::zip) return keys.front().values.size();
  std::size_t rows = 1;
  for (const SweptKey& one : keys) rows *= one.values.size();
  return rows;
}

std::vector<Substitution> Sweep::values_of(std::size_t row) const {
  std::vector<Substitution> values(keys.size());
  std::size_t left = row;
  for (std::size_t k = keys.size(); k-- > 0;) {
    const std::size_t count = keys[k].values.size();
    values[k] = {.key = keys[k].key, .value = keys[k].values[combine == Combine::zip ? row : left % count]};
    left /= count;
  }
  return values;
}

BearingRequest Sweep::request_of(const Case& row_case) const {
  const auto& body = std::get<BearingCase>(row_case.body);
  return {.laws = laws.empty() ? default_laws(body) : laws, .explicitly = !laws.empty()};
}

Case Sweep::case_of(std::size_t row) const {
  const std::vector<Substitution> values = values_of(row);
  try {
    Case row_case = read_case(case_text, case_file, values);
    if (bearing) require_possible(row_case, request_of(row_case));
    if (table) require_in_table(*table, row_case);
    return row_case;
  } catch (const CaseError& error) {
    const std::string what = error.what();
    const std::optional<std::size_t> at = key_in_message(keys, what);
    std::string all;
    for (const Substitution& one : values)
      all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", one.key, toml_text(one.value));
    throw CaseError(one_line(fmt::format(
        "{}:{}: {}: row {} ({}) is no case: {}", file.string(), at ? keys[*at].line : keys_line,
        at ? keys[*at].key + " = " + toml_text(values[*at].value) : "[keys]", row, shortened(all, longest_row), what)));
  }
}

Json Sweep::to_json() const {
  Json json = Json::object();
  json["id"] = id;
  json["case"] = case_id;
  if (bearing) {
    json["laws"] = Json::array();
    for (const bearing::Law law : laws) json["laws"].push_back(to_string(law));
    if (laws.empty()) json["laws"] = "default";
  }
  json["solver"] = solver;
  if (!bearing) json["tolerance"] = tolerance;
  if (table) {
    json["films"] = "table";
    json["table"] = {{"M", {table->range.M_low, table->range.M_high}},
                     {"L", {table->range.L_low, table->range.L_high}}};
  }
  json["combine"] = combine == Combine::zip ? "zip" : "product";
  json["keys"] = Json::object();
  for (const SweptKey& one : keys) {
    Json values = Json::array();
    for (const TomlValue& value : one.values) values.push_back(ehd::to_json(value));
    json["keys"][one.key] = std::move(values);
  }
  json["rows"] = rows();
  return json;
}

}  // namespace ehd
