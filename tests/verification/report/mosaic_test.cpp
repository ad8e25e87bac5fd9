// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/mosaic.hpp"

#include <stdexcept>

#include "tests/check.hpp"
#include "tests/verification/report/markup.hpp"

using namespace ehd::report;
using namespace ehd::verification::test;

namespace {

std::string tile(const std::string& id, double width, double height) {
  return picture({.id = id, .title = id, .description = "", .width = width, .height = height}, "<g></g>", Place::page);
}

const Picture frame{.id = "all", .title = "all", .description = ""};

}  // namespace

BOOST_AUTO_TEST_SUITE(report_mosaic)

BOOST_AUTO_TEST_CASE(tiles_stand_in_rows_that_do_not_overlap) {
  const std::string svg = mosaic(frame, "", {tile("a", 100, 50), tile("b", 200, 80), tile("c", 150, 30)}, 2);
  BOOST_TEST(unbalanced(svg) == "");
  BOOST_TEST(svg.starts_with("<?xml"));
  for (const char* placed : {"x=\"0\" y=\"0\" width=\"100\" height=\"50\"", "x=\"116\" y=\"0\" width=\"200\"",
                             "x=\"0\" y=\"96\" width=\"150\" height=\"30\"", "viewBox=\"0 0 316 126\""})
    BOOST_TEST(count_of(svg, placed) == 1u, placed << " is not in\n" << svg);
}

BOOST_AUTO_TEST_CASE(a_heading_moves_the_tiles_down_and_widens_the_picture) {
  const std::string svg = mosaic(frame, "A *long* heading", {tile("a", 40, 50)}, 1);
  BOOST_TEST(count_of(svg, "x=\"0\" y=\"24\"") == 1u);
  BOOST_TEST(count_of(svg, "viewBox=\"0 0 40 74\"") == 0u);
}

BOOST_AUTO_TEST_CASE(what_is_no_picture_is_refused) {
  BOOST_CHECK_THROW((void)mosaic(frame, "", {}, 2), std::invalid_argument);
  BOOST_CHECK_THROW((void)mosaic(frame, "", {tile("a", 1, 1)}, 0), std::invalid_argument);
  BOOST_CHECK_THROW((void)mosaic(frame, "", {"<p></p>"}, 1), std::invalid_argument);
  BOOST_CHECK_THROW((void)mosaic(frame, "", {"<svg ></svg>"}, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
