// SPDX-License-Identifier: GPL-3.0-or-later
// A new case can be read as it stands, and names every key; docs/case-format.md has the key tables.
#include "io/case_template.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "bearing/geometry.hpp"
#include "io/case_keys.hpp"
#include "io/case_reader.hpp"
#include "io/case_text.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

bool has_line(const std::string& text, const std::string& beginning) {
  for (const std::string& line : lines_of(text))
    if (line.starts_with(beginning) || line.starts_with("# " + beginning)) return true;
  return false;
}

/// The case with the comment sign removed from the lines of one key.
std::string with_key(std::string text, const std::string& key) {
  const auto at = text.find("\n# " + key + " = ");
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, key);
  return text.erase(at + 1, 2);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_template)

BOOST_AUTO_TEST_CASE(a_new_case_passes_the_reader) {
  const Case contact = read_case(ehd::case_template(CaseKind::contact, "mine"), "mine.toml");
  const auto& body = std::get<ContactCase>(contact.body);
  BOOST_TEST(body.oil.has_value());
  BOOST_TEST(std::holds_alternative<Conditions>(body.statement));
  const Case bearing = read_case(ehd::case_template(CaseKind::bearing, "my.bearing-2"), "my.bearing-2.toml");
  BOOST_TEST(std::get<BearingCase>(bearing.body).lubricant->oil.has_value());
}

BOOST_AUTO_TEST_CASE(every_type_of_bearing_has_a_template_that_says_how_it_is_stated) {
  const auto in_one_line = [](std::string text) {
    for (std::size_t at = 0; (at = text.find("\n#   ")) != std::string::npos;) text.replace(at, 5, " ");
    return text;
  };
  std::set<std::string_view> names;
  for (const BearingType& type : bearing_types) {
    BOOST_TEST(names.insert(type.name).second, type.name);
    const std::string text = bearing_template(type, "mine");
    BOOST_CHECK_NO_THROW((void)read_case(text, "mine.toml"));
    BOOST_TEST(in_one_line(text).find(type.stated) != std::string::npos, type.name);
    for (const std::string& line : lines_of(text)) BOOST_TEST(line.size() <= 100u, line);
  }
  BOOST_TEST(names.size() >= 10u);
}

BOOST_AUTO_TEST_CASE(a_template_of_needles_has_needles) {
  // ISO 3096: needles are 2.5 to 10 times as long as thick, and no thicker than 6 mm. Other rollers are short.
  constexpr double least_slenderness = 2.5, largest_slenderness = 10, thickest_m = 6e-3;
  int needles = 0;
  for (const BearingType& type : bearing_types) {
    const bool of_needles = type.what.find("needle") != std::string_view::npos;
    const auto geometry = std::get<BearingCase>(read_case(bearing_template(type, "mine"), "mine.toml").body).geometry;
    const double slender = geometry.length_m / geometry.roller_diameter_m;
    const bool is_needle =
        slender >= least_slenderness && slender <= largest_slenderness && geometry.roller_diameter_m <= thickest_m;
    BOOST_TEST(is_needle == of_needles, type.name);
    BOOST_TEST(geometry.rollers <= bearing::most_rollers(geometry.pitch_diameter_m, geometry.roller_diameter_m));
    needles += of_needles ? 1 : 0;
  }
  BOOST_TEST(needles == 4);
}

BOOST_AUTO_TEST_CASE(keys_that_mean_something_else_in_a_type_say_so_and_a_full_complement_is_full) {
  for (const BearingType& type : bearing_types) {
    const std::string text = bearing_template(type, "mine");
    const auto geometry = std::get<BearingCase>(read_case(text, "mine.toml").body).geometry;
    const auto has = [&](const std::string& remark) {
      return text.find(fmt::format("# {}: {}", type.name, remark)) != std::string::npos;
    };
    const double room = std::numbers::pi / std::asin(geometry.roller_diameter_m / geometry.pitch_diameter_m);
    BOOST_TEST((geometry.rollers <= room && geometry.rollers + 1 > room) == type.full_complement, type.name);
    BOOST_TEST(has(type.rows > 1 ? "of one row; without a cage" : "without a cage") == type.full_complement, type.name);
    BOOST_TEST(has(fmt::format("of one row: 1/{} of the bearing's load", type.rows)) == (type.rows > 1), type.name);
    if (!type.clearance.empty()) BOOST_TEST(has(std::string(type.clearance)), type.name);
  }
}

BOOST_AUTO_TEST_CASE(a_new_case_names_every_key_of_its_kind_with_unit_and_meaning) {
  int keys = 0;
  for (const CaseKind kind : {CaseKind::contact, CaseKind::bearing}) {
    const std::string text = ehd::case_template(kind, "mine");
    for (const CaseTable& table : case_tables()) {
      if (!(kind == CaseKind::contact ? table.in_contact : table.in_bearing)) continue;
      if (!table.name.empty())
        BOOST_CHECK_MESSAGE(text.find(fmt::format("[{}]", table.name)) != std::string::npos, table.name);
      for (const CaseKey& key : table.keys) {
        if (key.bearing_only && kind == CaseKind::contact) continue;
        BOOST_CHECK_MESSAGE(has_line(text, fmt::format("{} = ", key.name)), key.name);
        const std::string first_words = std::string(key.meaning).substr(0, 20);
        BOOST_CHECK_MESSAGE(has_line(text, first_words), key.name << ": " << first_words);
        ++keys;
      }
    }
    for (const std::string& line : lines_of(text)) BOOST_TEST(line.size() <= 100u, line);
  }
  BOOST_TEST(keys >= 70);
}

BOOST_AUTO_TEST_CASE(optional_keys_may_be_taken_in_as_they_stand) {
  const std::string bearing = ehd::case_template(CaseKind::bearing, "mine");
  for (const char* key : {"first_azimuth_deg", "ring_thickness_m", "roughness_m", "alpha_per_Pa", "z", "p0_Pa",
                          "viscosity_index", "density_15C_kg_per_m3"})
    BOOST_CHECK_NO_THROW((void)read_case(with_key(bearing, key), "mine.toml"));
}

BOOST_AUTO_TEST_CASE(the_example_of_an_expectation_may_be_taken_in_as_it_stands) {
  for (const CaseKind kind : {CaseKind::contact, CaseKind::bearing}) {
    std::string text = ehd::case_template(kind, "mine");
    const auto at = text.find("\n# [[expect]]\n");
    BOOST_REQUIRE(at != std::string::npos);
    const std::string expect = text.substr(at);
    text = text.substr(0, at) + "\n[[expect]]\n";
    for (const char* key : {"quantity", "law", "value", "scaling", "uncertainty", "kind"}) {
      if (kind == CaseKind::contact && std::string(key) == "law") continue;
      const std::string line = fmt::format("\n# {} = ", key);
      const auto from = expect.find(line);
      BOOST_REQUIRE_MESSAGE(from != std::string::npos, key);
      text += expect.substr(from + 3, expect.find('\n', from + 1) - from - 2);
    }
    BOOST_TEST(read_case(text, "mine.toml").expectations.size() == 1u, text);
  }
}

BOOST_AUTO_TEST_CASE(the_page_on_the_case_format_has_the_key_tables_as_they_are) {
  const std::string page = test::read(std::string(EHD_SOURCE_DIR) + "/docs/case-format.md");
  BOOST_TEST(page.find(case_key_tables()) != std::string::npos,
             "docs/case-format.md differs from `ehd new keys`; to remake it: make results");
}

BOOST_AUTO_TEST_SUITE_END()
