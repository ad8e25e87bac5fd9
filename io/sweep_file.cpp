// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/case_text.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "io/toml.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

constexpr double loosest_tolerance = 1;
constexpr double largest_number = 1e300;  // its span to -1e300 is still a number
constexpr std::size_t longest_row = 300;  // of a row's values in a message

std::string quoted(const std::vector<std::string>& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "\"" : ", \"") + item + "\"";
  return text;
}

class SweepReader {
 public:
  explicit SweepReader(const std::filesystem::path& file)
      : text_(read_case_text(file)), lines_(lines_of(text_)), root_(parse_toml(text_, file)) {
    sweep_.file = file;
    sweep_.id = file.stem().string();
  }

  [[nodiscard]] Sweep read() {
    require_known(root_, "", {"case", "laws", "solver", "tolerance", "combine", "keys"});
    read_case_of_sweep();
    read_how();
    read_keys();
    return std::move(sweep_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& subject, const std::string& message) const {
    throw CaseError(one_line(sweep_.file.string() + ":" + std::to_string(line) + ": " +
                             (subject.empty() ? "" : subject + ": ") + message));
  }
  [[noreturn]] void fail(const std::string& key, const toml::node& node, const std::string& message) const {
    const std::string value = text_of(node, lines_);
    fail(line_of(node), key + (node.is_table() && value.empty() ? "" : " = " + value), message);
  }
  [[noreturn]] void missing(const std::string& key, const std::string& required) const {
    fail(1, key, "is missing; required is " + required);
  }

  /// Names the first unknown key in the order of the file.
  void require_known(const toml::table& table, const std::string& of, const std::vector<std::string>& allowed) const {
    const toml::node* first = nullptr;
    std::string first_key;
    for (auto&& [key, node] : table) {
      if (std::find(allowed.begin(), allowed.end(), key.str()) != allowed.end()) continue;
      if (first && line_of(*first) <= line_of(node)) continue;
      first = &node;
      first_key = std::string(key.str());
    }
    if (!first) return;
    std::string names;
    for (const auto& name : allowed) names += (names.empty() ? "" : ", ") + name;
    fail(shortened(first_key, 60), *first, "is unknown" + of + "; allowed is " + names);
  }

  [[nodiscard]] std::string text(const std::string& key, const toml::node& node, const std::string& allowed) const {
    const auto* value = node.as_string();
    if (!value) fail(key, node, "is " + type_of(node) + "; allowed is " + allowed);
    return value->get();
  }

  [[nodiscard]] std::optional<double> number_of(const toml::node& node) const {
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    if (const auto* real = node.as_floating_point()) return real->get();
    return std::nullopt;
  }

  void read_case_of_sweep() {
    const std::string allowed = "the id of a case, or a path to its file from the folder of the sweep";
    const toml::node* node = root_.get("case");
    if (!node) missing("case", allowed);
    const std::string name = text("case", *node, allowed);
    if (name.empty()) fail("case", *node, "is empty; allowed is " + allowed);
    const bool path = name.find('/') != std::string::npos || std::filesystem::path(name).extension() == ".toml";
    try {
      sweep_.case_file = path ? sweep_.file.parent_path() / name : find_case(name);
      sweep_.case_text = read_case_text(sweep_.case_file);
      const Case plain_case = read_case(sweep_.case_text, sweep_.case_file);
      sweep_.case_id = plain_case.id;
      sweep_.bearing = std::holds_alternative<BearingCase>(plain_case.body);
    } catch (const CaseError& error) {
      fail("case", *node, error.what());
    }
  }

  void read_how() {
    if (const toml::node* node = root_.get("laws")) {
      const std::string allowed = "a list of laws out of " + bearing::names_of(bearing::Laws::all);
      if (!sweep_.bearing) fail("laws", *node, "belongs to the sweep of a bearing; allowed is no laws for a contact");
      const toml::array* array = node->as_array();
      if (!array) fail("laws", *node, "is " + type_of(*node) + "; allowed is " + allowed);
      if (array->empty()) fail("laws", *node, "is empty; allowed is " + allowed);
      for (const toml::node& entry : *array) {
        const auto law = bearing::law_from(text("laws", entry, allowed));
        if (!law) fail("laws", entry, "is unknown; allowed is " + allowed);
        if (std::find(sweep_.laws.begin(), sweep_.laws.end(), *law) != sweep_.laws.end())
          fail("laws", entry, "is a duplicate; allowed is each law once");
        sweep_.laws.push_back(*law);
      }
    }
    if (const toml::node* node = root_.get("solver")) {
      sweep_.solver = text("solver", *node, "one of " + solver_names());
      if (!find_solver(sweep_.solver)) fail("solver", *node, "is unknown; allowed is " + solver_names());
    }
    if (const toml::node* node = root_.get("tolerance")) {
      if (sweep_.bearing)
        fail("tolerance", *node,
             "belongs to the sweep of a contact; allowed is no tolerance for a bearing, whose "
             "contacts are solved to " +
                 plain(*ContactMemory::bearing_request().tolerance));
      const std::string allowed = "a number, more than 0 and up to " + plain(loosest_tolerance);
      const auto value = number_of(*node);
      if (!value) fail("tolerance", *node, "is " + type_of(*node) + "; allowed is " + allowed);
      if (!(*value > 0 && *value <= loosest_tolerance))
        fail("tolerance", *node, "is out of range; allowed is " + allowed);
      sweep_.tolerance = *value;
    }
    const std::vector<std::string> ways{"product", "zip"};
    const toml::node* node = root_.get("combine");
    if (!node) missing("combine", quoted(ways));
    const std::string way = text("combine", *node, quoted(ways));
    if (way != "product" && way != "zip") fail("combine", *node, "is unknown; allowed is " + quoted(ways));
    sweep_.combine = way == "zip" ? Combine::zip : Combine::product;
  }

  void read_keys() {
    const std::string allowed = "[keys] with a list or a range for at least one key of the case";
    const toml::node* node = root_.get("keys");
    if (!node) missing("[keys]", allowed);
    const toml::table* table = node->as_table();
    if (!table) fail("keys", *node, "is " + type_of(*node) + "; allowed is " + allowed);
    sweep_.keys_line = line_of(*node);
    if (table->empty()) fail(sweep_.keys_line, "[keys]", "is empty; allowed is " + allowed);
    for (auto&& [key, values] : *table) {
      const std::string name(key.str());
      // key.with.dots without quotation marks is a table to TOML.
      if (values.is_table() && name.find('.') == std::string::npos)
        fail(name, values, "is a table; allowed is the whole key in quotation marks, as \"operation.radial_load_N\"");
      sweep_.keys.push_back(
          {.key = name, .values = values_of(name, values), .line = line_of(values), .text = text_of(values, lines_)});
    }
    // toml++ keeps a table by name; here the file's order counts.
    const auto place = [table](const SweptKey& one) {
      const auto& begin = table->get(one.key)->source().begin;
      return std::pair{begin.line, begin.column};
    };
    std::sort(sweep_.keys.begin(), sweep_.keys.end(),
              [&](const SweptKey& one, const SweptKey& other) { return place(one) < place(other); });
    const SweptKey& first = sweep_.keys.front();
    std::size_t rows = 1;
    for (const SweptKey& one : sweep_.keys) {
      const std::string subject = one.key + " = " + one.text;
      if (sweep_.combine == Combine::zip) {
        if (one.values.size() != first.values.size())
          fail(one.line, subject,
               "has " + std::to_string(one.values.size()) + " values where " + first.key + " has " +
                   std::to_string(first.values.size()) + "; allowed with zip are equal numbers");
        rows = one.values.size();
      } else {
        rows *= one.values.size();
      }
      if (rows > most_rows)
        fail(one.line, subject, "makes more than " + std::to_string(most_rows) + " rows; allowed is up to that many");
    }
    require_case_of_every_row();
  }

  void require_case_of_every_row() const {
    for (std::size_t row = 0; row < sweep_.rows(); ++row) (void)sweep_.case_of(row);
  }

  [[nodiscard]] std::vector<TomlValue> values_of(const std::string& key, const toml::node& node) const {
    const std::string allowed =
        "a list of numbers or texts, or { from = A, to = B, points = N, spacing = \"linear\" or \"logarithmic\" }";
    if (const toml::table* range = node.as_table()) return range_of(key, *range);
    const toml::array* array = node.as_array();
    if (!array) fail(key, node, "is " + type_of(node) + "; allowed is " + allowed);
    if (array->empty()) fail(key, node, "is empty; allowed is " + allowed);
    std::vector<TomlValue> values;
    for (const toml::node& entry : *array) {
      if (const auto* word = entry.as_string()) {
        values.emplace_back(word->get());
      } else if (const auto* whole = entry.as_integer()) {
        values.emplace_back(whole->get());
      } else if (const auto* real = entry.as_floating_point()) {
        values.emplace_back(real->get());
      } else {
        fail(key, entry, "is " + type_of(entry) + " in a list; allowed is " + allowed);
      }
    }
    return values;
  }

  [[nodiscard]] std::vector<TomlValue> range_of(const std::string& key, const toml::table& range) const {
    require_known(range, " in the range of " + key, {"from", "to", "points", "spacing"});
    const auto end = [&](const char* name) {
      const toml::node* node = range.get(name);
      if (!node) fail(line_of(range), key, std::string(name) + " is missing; required is a number");
      const auto value = number_of(*node);
      if (!value) fail(key + ": " + name, *node, "is " + type_of(*node) + "; allowed is a number");
      if (!(std::abs(*value) <= largest_number))
        fail(key + ": " + name, *node, "is out of range; allowed is a number up to " + plain(largest_number));
      return std::pair{*value, node->is_integer()};
    };
    const auto [from, from_whole] = end("from");
    const auto [to, to_whole] = end("to");
    const std::string allowed = "an integer, 1 to " + std::to_string(most_rows);
    const toml::node* node = range.get("points");
    if (!node) fail(line_of(range), key, "points is missing; required is " + allowed);
    const auto* count = node->as_integer();
    if (!count) fail(key + ": points", *node, "is " + type_of(*node) + "; allowed is " + allowed);
    if (count->get() < 1 || count->get() > static_cast<std::int64_t>(most_rows))
      fail(key + ": points", *node, "is out of range; allowed is " + allowed);
    const auto points = static_cast<std::size_t>(count->get());
    if (points == 1 && from != to)
      fail(key + ": points", *node,
           "does not reach from one end to the other; allowed is 2 or more where from and to differ");

    const std::vector<std::string> spacings{"linear", "logarithmic"};
    const toml::node* spacing = range.get("spacing");
    if (!spacing) fail(line_of(range), key, "spacing is missing; required is " + quoted(spacings));
    const std::string how = text(key + ": spacing", *spacing, quoted(spacings));
    const bool logarithmic = how == "logarithmic";
    if (!logarithmic && how != "linear")
      fail(key + ": spacing", *spacing, "is unknown; allowed is " + quoted(spacings));
    if (logarithmic && (from == 0 || to == 0 || (from < 0) != (to < 0)))
      fail(key + ": spacing", *spacing, "leads through zero; allowed is linear, or from and to of one sign");

    std::vector<TomlValue> values;
    for (std::size_t i = 0; i < points; ++i) {
      const double t = points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0;
      const double between = logarithmic ? from * std::pow(to / from, t) : from + (to - from) * t;
      const double x = i == 0 ? from : i + 1 == points ? to : between;
      // Keys that count things take integers only; 2^53 is where a double may skip one.
      constexpr double exact = 9007199254740992.0;
      if (from_whole && to_whole && x == std::round(x) && std::abs(x) <= exact)
        values.emplace_back(static_cast<std::int64_t>(x));
      else
        values.emplace_back(x);
    }
    return values;
  }

  Sweep sweep_;
  std::string text_;
  std::vector<std::string> lines_;
  toml::table root_;
};

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
    return row_case;
  } catch (const CaseError& error) {
    const std::string what = error.what();
    // The case reader names a key without its table, or a table. The message shows the line of the swept key.
    std::string all;
    std::optional<std::size_t> by_key, by_table;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const std::string& key = keys[k].key;
      const auto dot = key.rfind('.');
      all += (all.empty() ? "" : ", ") + key + " = " + toml_text(values[k].value);
      if (!by_key && (what.find(" " + key.substr(dot + 1) + " = ") != std::string::npos || what.starts_with(key)))
        by_key = k;
      if (!by_table && what.find("[" + key.substr(0, dot) + "]") != std::string::npos) by_table = k;
    }
    if (!by_key) by_key = keys.size() == 1 ? std::optional<std::size_t>(0) : by_table;
    const SweptKey* const at = by_key ? &keys[*by_key] : nullptr;
    throw CaseError(one_line(file.string() + ":" + std::to_string(at ? at->line : keys_line) + ": " +
                             (at ? at->key + " = " + toml_text(values[*by_key].value) : "[keys]") + ": row " +
                             std::to_string(row) + " (" + shortened(all, longest_row) + ") is no case: " + what));
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

Sweep read_sweep(const std::filesystem::path& file) { return SweepReader(file).read(); }

}  // namespace ehd
