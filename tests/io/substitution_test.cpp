// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/substitution.hpp"

#include "tests/check.hpp"

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
  for (const char* text : {"[", "]", "[]x", "[1,]", "[,1]", "[ ]", "[1 2]", "[a]"})
    BOOST_CHECK_MESSAGE(toml_value(text) == TomlValue(std::string(text)), text);
  BOOST_TEST(toml_text(std::vector<double>{2000, 1e-6}) == "[2000.0, 1e-06]");
  BOOST_CHECK(toml_value("5 um") == TomlValue(std::string("5 um")));
  BOOST_CHECK(toml_value("") == TomlValue(std::string()));
  BOOST_CHECK(toml_value("\"") == TomlValue(std::string("\"")));
}

BOOST_AUTO_TEST_SUITE_END()
