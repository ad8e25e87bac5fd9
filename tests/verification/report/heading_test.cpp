// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/heading.hpp"

#include <numeric>
#include <string>
#include <vector>

#include "tests/check.hpp"

using namespace ehd::report;
using ehd::verification::Tolerance;

BOOST_AUTO_TEST_SUITE(report_heading)

// The widths that the font file states (DejaVu 2.37, DejaVuSans-Bold.ttf), at 12 pixels.
BOOST_AUTO_TEST_CASE(a_width_is_that_of_dejavu_sans_bold_rounded_up) {
  const struct {
    std::string text;
    double width;
  } headings[] = {{"Contact force of each roller; the external load points down", 397.833984375},
                  {"Contact force over the azimuth", 210.685546875}};
  for (const auto& [text, width] : headings) {
    BOOST_TEST(heading_width(text) >= width);
    EHD_CHECK((heading_width(text) - width) / static_cast<double>(text.size()),
              Tolerance::required(0.12, "a character is rounded up by at most a hundredth of 12 pixels"));
  }
  BOOST_TEST(heading_width("*P* = 2") == heading_width("P = 2"));
}

BOOST_AUTO_TEST_CASE(a_heading_that_fits_stays_whole) {
  const std::string text = "Force, and more; all of it";
  BOOST_TEST(heading_lines(text, heading_width(text)) == std::vector<std::string>{text},
             boost::test_tools::per_element());
  BOOST_TEST(heading_lines("", 100).empty());
}

BOOST_AUTO_TEST_CASE(a_heading_is_broken_between_clauses_else_between_words) {
  const std::vector<std::string> clauses{"Contact force of each roller;", "the external load points down"},
      words{"Contact force of each", "roller of the bearing"};
  BOOST_TEST(heading_lines(clauses[0] + " " + clauses[1], 300) == clauses, boost::test_tools::per_element());
  BOOST_TEST(heading_lines(words[0] + " " + words[1], 160) == words, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(every_line_fits_and_no_character_is_lost) {
  const std::string heading =
      "a \\_ *h R* at x_{12} of " + std::string(50, 'W') + " and\u00b5\u03b1\u00b5 more, the end*";
  for (const double width : {40.0, 60.0, 90.0, 200.0, 400.0}) {
    const std::vector<std::string> lines = heading_lines(heading, width);
    for (const std::string& line : lines) BOOST_TEST(heading_width(line) <= width, line);
    const auto without_blanks = [](std::string text) {
      std::erase(text, ' ');
      return text;
    };
    BOOST_TEST(without_blanks(std::accumulate(lines.begin(), lines.end(), std::string())) == without_blanks(heading));
  }
}

BOOST_AUTO_TEST_CASE(each_line_has_its_place) {
  const Heading one = heading_of("One", 200, 13), two = heading_of("One line of words; and another", 200, 13);
  BOOST_TEST(one.svg == "<text x=\"8\" y=\"13\" class=\"head\">One</text>");
  BOOST_TEST(one.more == 0);
  BOOST_TEST(two.svg.find("<text x=\"8\" y=\"29\" class=\"head\">and another</text>") != std::string::npos);
  BOOST_TEST(two.more == 16);
}

BOOST_AUTO_TEST_SUITE_END()
