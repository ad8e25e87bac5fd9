// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv.hpp"

#include <boost/test/unit_test.hpp>

using namespace ehd;

BOOST_AUTO_TEST_SUITE(csv)

BOOST_AUTO_TEST_CASE(a_text_that_a_spreadsheet_would_run_gets_an_apostrophe) {
  BOOST_TEST(csv_cell("=1+1") == "'=1+1");
  BOOST_TEST(csv_cell("@SUM(A1)") == "'@SUM(A1)");
  BOOST_TEST(csv_cell("-cmd|'x'") == "'-cmd|'x'");
  BOOST_TEST(csv_cell("+1,2") == "\"'+1,2\"");
  BOOST_TEST(csv_cell("a=b") == "a=b");
}

BOOST_AUTO_TEST_CASE(a_number_stays_as_it_is) {
  for (const char* number : {"-4", "+2.5", "-1e-300", "0.1", "-.5"}) BOOST_TEST(csv_cell(number) == number);
  BOOST_TEST(csv_cell("-") == "'-");
}

BOOST_AUTO_TEST_CASE(commas_quotation_marks_and_line_feeds_are_quoted) {
  BOOST_TEST(csv_line({"a,b", "c\"d", "e\nf", "g"}) == "\"a,b\",\"c\"\"d\",\"e\nf\",g\n");
}

BOOST_AUTO_TEST_CASE(no_cell_of_a_comment_is_run) {
  BOOST_TEST(csv_comment("Case: a,=1+1,@b, -2") == "# Case: a, =1+1, @b, -2\n");
  BOOST_TEST(csv_comment("two\nlines") == "# two\\nlines\n");
}

BOOST_AUTO_TEST_SUITE_END()
