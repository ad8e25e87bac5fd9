// SPDX-License-Identifier: GPL-3.0-or-later
// The compiler counts the words of an enum as a reader does.
#include "contact/enum_words.hpp"

#include <boost/test/unit_test.hpp>

#include "contact/quantities.hpp"

using namespace ehd;

namespace {

enum class Colour { red, green_2, blue_1977 };  // a digit at the end of a word is no number

}  // namespace

BOOST_AUTO_TEST_SUITE(enum_words)

BOOST_AUTO_TEST_CASE(a_value_without_a_word_is_none) {
  BOOST_TEST(is_word<Colour::red>());
  BOOST_TEST(is_word<Colour::blue_1977>());
  BOOST_TEST(!is_word<static_cast<Colour>(3)>());
  BOOST_TEST(!is_word<static_cast<Colour>(-1)>());
}

BOOST_AUTO_TEST_CASE(words_are_counted_and_listed_in_order) {
  BOOST_TEST(word_count<Colour>() == 3U);
  BOOST_TEST((all_words<Colour> == std::array{Colour::red, Colour::green_2, Colour::blue_1977}));
  BOOST_TEST((all_words<ErrorKind> == std::array{ErrorKind::relative, ErrorKind::absolute}));
  BOOST_TEST(word_count<SIScale>() == 5U);
}

BOOST_AUTO_TEST_SUITE_END()
