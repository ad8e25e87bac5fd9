// SPDX-License-Identifier: GPL-3.0-or-later
// Every word of an enum that a table explains has its row. The compiler does not see a word that was added at the end
// of an enum, so the words are counted in the header.
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "bearing/law_table.hpp"
#include "contact/oil_laws.hpp"
#include "contact/quantities.hpp"

namespace {

/// The number of words in `enum class name { … };` of a header.
std::size_t words_of(const std::string& header, const std::string& name) {
  std::ifstream file(std::string(EHD_SOURCE_DIR) + "/" + header);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string without_comments = std::regex_replace(text, std::regex("//[^\n]*"), "");
  std::smatch found;
  BOOST_REQUIRE_MESSAGE(
      std::regex_search(without_comments, found, std::regex("enum class " + name + " \\{([^}]*)\\};")),
      header << " has no enum " << name);
  const std::string words = found[1];
  const std::regex word("[A-Za-z_0-9]+");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(words.begin(), words.end(), word), std::sregex_iterator()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tables)

BOOST_AUTO_TEST_CASE(every_word_has_a_row) {
  BOOST_CHECK_EQUAL(words_of("contact/quantities.hpp", "Quantity"), ehd::quantity_table().size());
  BOOST_CHECK_EQUAL(words_of("contact/conditions.hpp", "ViscosityLaw"), ehd::viscosity_laws().size());
  BOOST_CHECK_EQUAL(words_of("contact/conditions.hpp", "DensityLaw"), ehd::density_laws().size());
  BOOST_CHECK_EQUAL(words_of("bearing/law_table.hpp", "Law"), ehd::bearing::law_rows().size());
}

BOOST_AUTO_TEST_CASE(comments_are_no_words) {
  BOOST_CHECK_EQUAL(words_of("contact/quantities.hpp", "ErrorKind"), 2);  // on one line
  BOOST_CHECK_EQUAL(words_of("contact/quantities.hpp", "SIScale"), 4);    // a comment behind each
}

BOOST_AUTO_TEST_SUITE_END()
