// SPDX-License-Identifier: GPL-3.0-or-later
// The strict reader of sweep files: read_sweep.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_reader.hpp"
#include "io/case_text.hpp"
#include "io/faults.hpp"
#include "io/find_case.hpp"
#include "io/near_miss.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_films.hpp"
#include "io/sweep_source.hpp"
#include "io/sweep_values.hpp"
#include "workflow/parallel.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

void read_case_of_sweep(const SweepSource& source, Sweep& sweep) {
  const std::string allowed = "the id of a case, or a path to its file from the folder of the sweep";
  const toml::node* node = source.root().get("case");
  if (!node) source.missing("case", allowed);
  const std::string name = source.text("case", *node, allowed);
  if (name.empty()) source.fail("case", *node, "is empty; allowed is " + allowed);
  const bool path = name.find('/') != std::string::npos || std::filesystem::path(name).extension() == ".toml";
  try {
    sweep.case_file = path ? sweep.file.parent_path() / name : find_case(name);
    sweep.case_text = read_case_text(sweep.case_file);
    const Case plain_case = read_case(sweep.case_text, sweep.case_file);
    sweep.case_id = plain_case.id;
    sweep.bearing = std::holds_alternative<BearingCase>(plain_case.body);
  } catch (const CaseError& error) {
    source.fail("case", *node, error.what());
  }
}

/// Whether the sweep's case is a bearing; absent where the case could not be read.
using OfBearing = std::optional<bool>;

void read_laws(const SweepSource& source, OfBearing of_bearing, Sweep& sweep) {
  const toml::node* node = source.root().get("laws");
  if (!node) return;
  const std::string allowed = "a list of laws out of " + bearing::names_of(bearing::Laws::all);
  if (of_bearing == false)
    source.fail("laws", *node, "belongs to the sweep of a bearing; allowed is no laws for a contact");
  const toml::array* array = node->as_array();
  if (!array) source.fail_type("laws", *node, allowed);
  if (array->empty()) source.fail("laws", *node, "is empty; allowed is " + allowed);
  std::vector<std::string> names;
  for (const bearing::LawRow& row : bearing::law_rows()) names.emplace_back(row.name);
  Faults faults;
  for (const toml::node& entry : *array)
    (void)faults.none_in([&] {
      const std::string word = source.text("laws", entry, allowed);
      const auto law = bearing::law_from(word);
      if (!law)
        source.fail("laws", entry, fmt::format("is unknown; {}allowed is {}", did_you_mean(word, names), allowed));
      if (std::find(sweep.laws.begin(), sweep.laws.end(), *law) != sweep.laws.end())
        source.fail("laws", entry, "is a duplicate; allowed is each law once");
      sweep.laws.push_back(*law);
    });
  faults.refuse();
}

void read_solver(const SweepSource& source, Sweep& sweep) {
  const toml::node* node = source.root().get("solver");
  if (!node) return;
  sweep.solver = source.text("solver", *node, "one of " + solver_names());
  if (!find_solver(sweep.solver)) source.fail("solver", *node, is_unknown(sweep.solver, solver_names()));
}

void read_tolerance(const SweepSource& source, OfBearing of_bearing, Sweep& sweep) {
  const toml::node* node = source.root().get("tolerance");
  if (!node) return;
  if (of_bearing == true)
    source.fail(
        "tolerance", *node,
        "belongs to the sweep of a contact; allowed is no tolerance in the sweep of a bearing, which sets that of "
        "its contacts");
  const std::string allowed = "a number, more than 0 and up to " + plain(loosest_tolerance);
  const auto value = number_of(*node);
  if (!value) source.fail_type("tolerance", *node, allowed);
  if (!(*value > 0 && *value <= loosest_tolerance))
    source.fail("tolerance", *node, "is out of range; allowed is " + allowed);
  sweep.tolerance = *value;
}

void read_combine(const SweepSource& source, Sweep& sweep) {
  const std::vector<std::string> ways{"product", "zip"};
  const toml::node* node = source.root().get("combine");
  if (!node) source.missing("combine", quoted_list(ways));
  sweep.combine = source.choice("combine", *node, ways) == "zip" ? Combine::zip : Combine::product;
}

/// The keys in the order of the file: toml++ keeps a table by name.
std::vector<SweptKey> keys_in_order(const SweepSource& source, const toml::table& table) {
  std::vector<SweptKey> keys;
  for (auto&& [key, values] : table) {
    const std::string name(key.str());
    const toml::node& node = values;
    keys.push_back({.key = name, .values = {}, .line = line_of(node), .text = source.written(node)});
  }
  const auto place = [&table](const SweptKey& one) {
    const auto& begin = table.get(one.key)->source().begin;
    return std::pair{begin.line, begin.column};
  };
  std::sort(keys.begin(), keys.end(),
            [&](const SweptKey& one, const SweptKey& other) { return place(one) < place(other); });
  return keys;
}

/// The values of one key.
std::vector<TomlValue> values_of(const SweepSource& source, const std::string& name, const toml::node& values) {
  // key.with.dots without quotation marks is a table to TOML.
  if (const toml::table* inner = values.as_table(); inner && name.find('.') == std::string::npos) {
    const std::string meant =
        inner->empty() ? "operation.radial_load_N" : name + '.' + std::string(inner->begin()->first.str());
    source.fail(line_of(values), name,
                fmt::format("is a table; allowed is the whole key in quotation marks, as \"{}\"", meant));
  }
  return swept_values(source, name, values);
}

/// Equal numbers of values for zip, and not too many rows.
void require_countable(const SweepSource& source, const Sweep& sweep) {
  const SweptKey& first = sweep.keys.front();
  std::size_t rows = 1;
  for (const SweptKey& one : sweep.keys) {
    const std::string subject = one.key + " = " + one.text;
    if (sweep.combine == Combine::zip) {
      if (one.values.size() != first.values.size())
        source.fail(one.line, subject,
                    fmt::format("has {} values where {} has {}; allowed with zip are equal numbers", one.values.size(),
                                first.key, first.values.size()));
      rows = one.values.size();
    } else {
      rows *= one.values.size();
    }
    if (rows > most_rows)
      source.fail(one.line, subject, fmt::format("makes more than {} rows; allowed is up to that many", most_rows));
  }
}

void read_keys(const SweepSource& source, Sweep& sweep) {
  const std::string allowed = "[keys] with a list or a range for at least one key of the case";
  const toml::node* node = source.root().get("keys");
  if (!node) source.missing("[keys]", allowed);
  const toml::table* table = node->as_table();
  if (!table) source.fail_type("keys", *node, allowed);
  sweep.keys_line = line_of(*node);
  if (table->empty()) source.fail(sweep.keys_line, "[keys]", "is empty; allowed is " + allowed);
  sweep.keys = keys_in_order(source, *table);
  Faults faults;
  for (SweptKey& one : sweep.keys)
    (void)faults.none_in([&] { one.values = values_of(source, one.key, *table->get(one.key)); });
  faults.refuse();
  require_countable(source, sweep);
}

}  // namespace

Sweep read_sweep_statement(const std::filesystem::path& file) {
  const SweepSource source(file);
  Sweep sweep;
  sweep.file = file;
  sweep.id = id_of_file(file);
  if (const toml::node* id = source.root().get("id"); id && !source.root().get("case"))
    source.fail("id", *id, "belongs to a case; allowed is a sweep, which names its case: case = \"ID or FILE\"");
  const std::vector<std::string> known{"case", "laws", "solver", "tolerance", "films", "table", "combine", "keys"};
  std::set<std::string> meant;
  for (const auto& [key, node] : unknown_keys(source.root(), known)) meant.insert(near_miss(key, known));
  Faults faults;
  // A key that is missing is not named where an unknown one was probably meant to be it.
  const auto sound = [&](const std::string& key, const auto& read) {
    return (source.root().get(key) || !meant.contains(key)) && faults.none_in(read);
  };
  (void)faults.none_in([&] { source.require_known(source.root(), "", known); });
  const bool case_is_known = sound("case", [&] { read_case_of_sweep(source, sweep); });
  const OfBearing of_bearing = case_is_known ? OfBearing(sweep.bearing) : std::nullopt;
  (void)sound("laws", [&] { read_laws(source, of_bearing, sweep); });
  const bool solver_is_known = sound("solver", [&] { read_solver(source, sweep); });
  (void)sound("tolerance", [&] { read_tolerance(source, of_bearing, sweep); });
  if (case_is_known && solver_is_known) (void)sound("films", [&] { read_films(source, sweep); });
  (void)sound("combine", [&] { read_combine(source, sweep); });
  (void)sound("keys", [&] { read_keys(source, sweep); });
  faults.refuse();
  return sweep;
}

void require_cases(const Sweep& sweep, const std::vector<std::size_t>& rows, unsigned threads) {
  std::mutex mutex;
  std::atomic<std::size_t> first = rows.size();
  std::optional<CaseError> refusal;
  in_threads(rows.size(), threads, [&](std::size_t i) {
    if (i > first) return;
    try {
      (void)sweep.case_of(rows[i]);
    } catch (const CaseError& error) {
      const std::lock_guard lock(mutex);
      if (i > first) return;
      first = i;
      refusal = error;
    }
  });
  if (refusal) throw CaseError(*refusal);
}

Sweep read_sweep(const std::filesystem::path& file) {
  Sweep sweep = read_sweep_statement(file);
  std::vector<std::size_t> rows(sweep.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  require_cases(sweep, rows, 0);
  return sweep;
}

}  // namespace ehd
