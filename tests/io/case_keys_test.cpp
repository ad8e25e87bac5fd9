// SPDX-License-Identifier: GPL-3.0-or-later
// The table of case keys and the reader say the same.
#include "io/case_keys.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <variant>

#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// Cases that have every table between them.
const std::vector<std::string> sample_ids{"own-moes-20-10", "steel-roller", "kostreva-100lb-500rpm", "na4908"};

std::string refusal(const std::string& id, const std::string& key, const TomlValue& value) {
  const auto file = find_case(id);
  std::vector<Substitution> substitutions{{key, value}};
  // An oil that is stated by its grade needs a temperature beside it.
  if (key.ends_with("iso_vg") || key.ends_with("mm2_per_s")) substitutions.push_back({"lubricant.temperature_C", 60.0});
  try {
    (void)read_case(test::read(file), file, substitutions);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

/// Calls visit(table, key, path) for every key of the tables that can be substituted.
template <class Visit>
void for_each_substitutable_key(const Visit& visit) {
  for (const CaseTable& table : case_tables()) {
    if (!is_substitutable(table)) continue;
    for (const CaseKey& key : table.keys) visit(table, key, fmt::format("{}.{}", table.name, key.name));
  }
}

/// The first sample that has the table and may have the key; empty where there is none.
std::string sample_with(const CaseTable& table, const CaseKey& key) {
  for (const std::string& id : sample_ids) {
    const Case sample = read_case(find_case(id));
    const bool of_bearing = std::holds_alternative<BearingCase>(sample.body);
    if (sample.places.contains(std::string(table.name)) && (of_bearing || !key.bearing_only)) return id;
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_keys)

BOOST_AUTO_TEST_CASE(each_key_stands_once_and_says_what_it_means) {
  std::set<std::string_view> tables;
  for (const CaseTable& table : case_tables()) {
    BOOST_TEST(tables.insert(table.name).second, table.name);
    BOOST_TEST(!table.meaning.empty(), table.name);
    BOOST_TEST((table.in_contact || table.in_bearing), table.name);
    std::set<std::string_view> names;
    for (const CaseKey& key : table.keys) {
      BOOST_TEST_CONTEXT(table.name << " " << key.name) {
        BOOST_TEST(names.insert(key.name).second);
        BOOST_TEST(!key.meaning.empty());
        BOOST_TEST(!text_of(key.allowed).empty());
        BOOST_TEST((key.need == Need::sometimes) == !key.condition.empty());
        BOOST_TEST((key.need == Need::never) == (key.standard.has_value() || !key.otherwise.empty()));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_row_is_found_by_the_path_of_its_key) {
  BOOST_TEST(row_of_case_key("id").name == "id");
  BOOST_TEST(row_of_case_key("lubricant.z").name == "z");
  BOOST_TEST(row_of_case_key("expect.12.value").name == "value");
  BOOST_CHECK_THROW((void)row_of_case_key("lubricant.y"), std::logic_error);
  BOOST_CHECK_THROW((void)row_of_case_key("nonsense"), std::logic_error);
}

BOOST_AUTO_TEST_CASE(a_number_outside_its_interval_is_refused_with_the_interval) {
  int checked = 0;
  for_each_substitutable_key([&](const CaseTable& table, const CaseKey& key, const std::string& path) {
    const auto* interval = std::get_if<Interval>(&key.allowed);
    const std::string id = sample_with(table, key);
    if (!interval || id.empty()) return;
    for (const double outside : {1.01 * interval->high, interval->low - 1}) {
      const std::string message = refusal(id, path, outside);
      // Other checks come first for keys that contradict this sample.
      if (message.find("contradicts") != std::string::npos) continue;
      BOOST_CHECK_MESSAGE(message.find("allowed is " + interval->text()) != std::string::npos,
                          path << " = " << outside << ": " << message);
      ++checked;
    }
  });
  BOOST_TEST(checked >= 40);
}

BOOST_AUTO_TEST_CASE(another_type_is_refused_with_what_the_row_allows) {
  int checked = 0;
  for_each_substitutable_key([&](const CaseTable& table, const CaseKey& key, const std::string& path) {
    const std::string id = sample_with(table, key);
    const bool wants_text = std::holds_alternative<allowed::Word>(key.allowed);
    if (id.empty()) return;
    const std::string message =
        refusal(id, path, wants_text ? TomlValue(std::int64_t{7}) : TomlValue(std::string("nonsense")));
    if (message.find("contradicts") != std::string::npos) return;
    BOOST_CHECK_MESSAGE(message.find(text_of(key.allowed)) != std::string::npos, path << ": " << message);
    ++checked;
  });
  BOOST_TEST(checked >= 25);
}

BOOST_AUTO_TEST_SUITE_END()
