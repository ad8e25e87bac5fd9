// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/substitution.hpp"

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "contact/conditions.hpp"
#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "workflow/case.hpp"

using namespace ehd;

BOOST_AUTO_TEST_SUITE(substitution)

BOOST_AUTO_TEST_CASE(a_text_of_the_command_line_is_the_value_that_toml_would_have) {
  BOOST_CHECK(toml_value("14") == TomlValue(std::int64_t{14}));
  BOOST_CHECK(toml_value("+14") == TomlValue(std::int64_t{14}));
  BOOST_CHECK(toml_value("5e-6") == TomlValue(5e-6));
  BOOST_CHECK(toml_value("-4.0") == TomlValue(-4.0));
  BOOST_CHECK(toml_value("barus") == TomlValue(std::string("barus")));
  BOOST_CHECK(toml_value("\"flooded\"") == TomlValue(std::string("flooded")));
  BOOST_CHECK(toml_value("[2000, 12e3]") == TomlValue(std::vector<double>{2000, 12000}));
  BOOST_CHECK(toml_value("[ -1 ,2.5 ]") == TomlValue(std::vector<double>{-1, 2.5}));
  BOOST_CHECK(toml_value("[1,]") == TomlValue(std::vector<double>{1}));
  BOOST_CHECK(toml_value(" 14 ") == TomlValue(std::int64_t{14}));
  BOOST_CHECK(toml_value("18446744073709551616") == TomlValue(18446744073709551616.0));
  BOOST_CHECK(toml_value("'barus'") == TomlValue(std::string("barus")));
  BOOST_CHECK(toml_value("\"L\xC3\xA4ufer\"") == TomlValue(std::string("L\xC3\xA4ufer")));
  for (const char* text : {"[", "]", "[]x", "[,1]", "[1 2]", "[a]", "[0x1]", "0x14", "20.", ".5", "020", "1d1", "true",
                           "1\nb = 2", "{ a = 1 }", "1979-05-27", "-"})
    BOOST_CHECK_MESSAGE(toml_value(text) == TomlValue(std::string(text)), text);
  BOOST_TEST(toml_text(std::vector<double>{2000, 1e-6}) == "[2000.0, 1e-06]");
  BOOST_CHECK(toml_value("5 um") == TomlValue(std::string("5 um")));
  BOOST_CHECK(toml_value("") == TomlValue(std::string()));
  BOOST_CHECK(toml_value("\"") == TomlValue(std::string("\"")));
}

// Agreement: a number is the same, or refused, in a file and behind --set.
BOOST_AUTO_TEST_CASE(a_number_is_read_alike_from_a_file_and_from_the_command_line) {
  const auto text_with = [](const std::string& M) {
    return "id = \"one\"\nversion = 1\ntitle = \"x\"\nsource = \"own\"\n[moes]\nM = " + M +
           "\nL = 10.0\n[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n"
           "[domain]\ninlet = \"flooded\"\n";
  };
  const auto M_of = [](const std::string& text, const std::vector<Substitution>& set) -> std::optional<double> {
    try {
      const Case one = read_case(text, "one.toml", set);
      return std::get<MoesGroups>(std::get<ContactCase>(one.body).statement).M;
    } catch (const CaseError&) {
      return std::nullopt;
    }
  };
  const std::optional<double> refused;
  const std::vector<std::pair<std::string, std::optional<double>>> rows{
      {"20", 20},         {"20.0", 20},          {"+20", 20},
      {"2e1", 20},        {"2E+1", 20},          {"0.5", 0.5},
      {"200e-1", 20},     {"1_000", 1000},       {" 20 ", 20},
      {"20 # c", 20},     {"0x14", refused},     {"0o24", refused},
      {"0b11", refused},  {"0x", refused},       {"0x1p4", refused},
      {"20.", refused},   {".5", refused},       {"+.5", refused},
      {"20.e0", refused}, {"020", refused},      {"2d1", refused},
      {"1e400", refused}, {"1e-400", refused},   {"inf", refused},
      {"nan", refused},   {"infinity", refused}, {"+-20", refused},
      {"1,5", refused},   {"1e1,2e1", refused},  {"20 N", refused},
      {"'20'", refused},  {"\"20\"", refused},   {"true", refused},
      {"[20]", refused},  {"-0", refused},       {"_20", refused},
      {"20_", refused},   {"1__0", refused},     {"9223372036854775808", refused},
      {"", refused}};
  for (const auto& [number, value] : rows) {
    const std::optional<double> in_file = M_of(text_with(number), {});
    const std::optional<double> set =
        M_of(text_with("7.0"), {{.key = "moes.M", .value = toml_value(number), .option = "--set moes.M=" + number}});
    BOOST_TEST((in_file == value), number << " in a file");
    BOOST_TEST((set == value), number << " behind --set");
  }
}

BOOST_AUTO_TEST_SUITE_END()
