// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/svg.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include "tests/check.hpp"

using namespace ehd::report;

BOOST_AUTO_TEST_SUITE(report_svg)

BOOST_AUTO_TEST_CASE(text_cannot_end_an_element_or_an_attribute) {
  BOOST_TEST(escaped("<a href=\"x\">'&'</a>") == "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  BOOST_TEST(escaped("\u00b5m") == "\u00b5m");
  BOOST_TEST(escaped(std::string("a\x01z\xffq")) == "a z\uFFFDq");  // neither is allowed in XML
}

BOOST_AUTO_TEST_CASE(coordinates_are_short_and_never_nan) {
  BOOST_TEST(pixels(12.5) == "12.5");
  BOOST_TEST(pixels(3) == "3");
  BOOST_TEST(pixels(-0.001) == "0");
  BOOST_TEST(pixels(100) == "100");
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW((void)pixels(value), std::logic_error);
}

BOOST_AUTO_TEST_CASE(numbers_have_a_true_minus_and_powers_of_ten) {
  BOOST_TEST(number_markup(-0.25) == "\u22120.25");
  BOOST_TEST(number_markup(1e-7) == "10^{\u22127}");
  BOOST_TEST(number_markup(1e-4) == "10^{\u22124}");  // as 1e-5 beside it
  BOOST_TEST(number_markup(-2.5e-4) == "\u22122.5\u2009\u00b7\u200910^{\u22124}");
  BOOST_TEST(number_markup(1e-3) == "0.001");
  BOOST_TEST(number_markup(0) == "0");
  BOOST_TEST(markup_to_text(number_markup(2.5e9)) == "2.5\u2009\u00b7\u200910^9");
  BOOST_TEST(number_markup(std::numeric_limits<double>::quiet_NaN()) == "?");
}

BOOST_AUTO_TEST_CASE(markup_sets_symbols_in_italics_and_comes_back_to_the_line) {
  BOOST_TEST(markup_to_html("*P* = *p*/*p*_{H}") == "<i>P</i> = <i>p</i>/<i>p</i><sub>H</sub>");
  BOOST_TEST(markup_to_html("10^{-3} < 1") == "10<sup>-3</sup> &lt; 1");
  const std::string svg = markup_to_svg("*h R*/*b*^{2} [m]");
  BOOST_TEST(svg.find("font-style=\"italic\">h R</tspan>") != std::string::npos);
  // What goes up by 0.36 em of the line (0.48 of the small type) comes down again.
  BOOST_TEST(svg.find("dy=\"-0.48em\" font-size=\"75%\">2</tspan>") != std::string::npos);
  // librsvg drops a blank that begins a tspan.
  BOOST_TEST(svg.find("</tspan> <tspan dy=\"0.36em\">[m]</tspan>") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(text_from_a_file_is_no_markup) {
  for (const std::string text : {"a*b*c", "x_{1}", "2^{3}", "back\\slash", "brace}"}) {
    BOOST_TEST(markup_to_text(literal(text)) == text);
    BOOST_TEST(markup_to_html(literal(text)) == text);
  }
}

BOOST_AUTO_TEST_CASE(widths_grow_with_the_text_and_ignore_markup) {
  BOOST_TEST(text_width("reference.uniform", 12) > text_width("fast", 12));
  BOOST_TEST(text_width("*P*", 12) == text_width("P", 12));
  BOOST_TEST(text_width("x_{1}", 12) < text_width("x1", 12));
  BOOST_TEST(text_width("fast", 24) == 2 * text_width("fast", 12));
}

BOOST_AUTO_TEST_CASE(a_picture_alone_is_white_and_knows_its_colours) {
  const Picture frame{"an-id", "A <title>", "what is seen", 100, 50};
  const std::string file = picture(frame, "<g/>", Place::file), page = picture(frame, "<g/>", Place::page);
  BOOST_TEST(file.starts_with("<?xml"));
  BOOST_TEST(file.find("var(") == std::string::npos);  // many programs do not know CSS variables
  BOOST_TEST(file.find("fill=\"#ffffff\"") != std::string::npos);
  BOOST_TEST(file.find("xmlns=\"http://www.w3.org/2000/svg\"") != std::string::npos);
  BOOST_TEST(page.find("<style>") == std::string::npos);
  for (const auto& one : {file, page}) {
    BOOST_TEST(one.find("role=\"img\"") != std::string::npos);
    BOOST_TEST(one.find("aria-labelledby=\"an-id-title an-id-desc\"") != std::string::npos);
    BOOST_TEST(one.find(">A &lt;title&gt;</title>") != std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END()
