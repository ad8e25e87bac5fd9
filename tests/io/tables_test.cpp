// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tables.hpp"

#include <boost/test/unit_test.hpp>

using namespace ehd;

BOOST_AUTO_TEST_SUITE(tables)

BOOST_AUTO_TEST_CASE(columns_are_as_wide_as_their_widest_cell) {
  BOOST_TEST(aligned({{"M", "film"}, {"20", "0.07"}}, 1, "  ") == "  M   film\n  20  0.07\n");
  BOOST_TEST(table_width({{"M", "film"}, {"20", "0.07"}}, "  ") == 10u);
}

BOOST_AUTO_TEST_CASE(columns_that_do_not_fit_follow_below_behind_the_first_one) {
  const std::string wide(60, 'x'), title(20, 't');
  const std::vector<std::vector<std::string>> rows{{title, wide, "fits", wide}, {"a", "b", "c", "d"}};
  BOOST_TEST(table_width(rows, "") > widest_table);
  const std::string pad(59, ' '), key(19, ' ');
  BOOST_TEST(aligned_in_parts(rows, 1) == title + "  " + wide + "  fits\na" + key + "  " + pad + "b     c\n\n" + title +
                                              "  " + wide + "\na" + key + "  " + pad + "d\n");
}

BOOST_AUTO_TEST_CASE(a_column_that_fits_nowhere_stands_alone) {
  const std::string wide(120, 'x');
  BOOST_TEST(aligned_in_parts({{"key", wide, "b"}}, 1) == "key  " + wide + "\n\nkey  b\n");
}

BOOST_AUTO_TEST_CASE(a_long_line_is_wrapped_between_its_words) {
  BOOST_TEST(wrapped("  short", "    ") == "  short\n");
  const std::string words(50, 'x');
  BOOST_TEST(wrapped(words + " " + words + " y", "  ") == words + "\n  " + words + " y\n");
  BOOST_TEST(wrapped(words + " " + words.substr(1), "  ") == words + " " + words.substr(1) + "\n");  // 100 characters
  BOOST_TEST(wrapped("  " + words + words, "  ") == "  " + words + words + "\n");
}

BOOST_AUTO_TEST_SUITE_END()
