// SPDX-License-Identifier: GPL-3.0-or-later
// The line that shows how far a command has come. What a terminal sees of it: terminal.py.
#include "cli/progress.hpp"

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(progress)

BOOST_AUTO_TEST_CASE(the_time_goes_on_between_two_steps_and_the_time_left_goes_down) {
  using ehd::cli::step_line;
  BOOST_TEST(step_line(0, 4, "first", 0, 3) == "0/4, 3 s: first");
  BOOST_TEST(step_line(1, 4, "second", 5, 5) == "1/4, 5 s, about 15 s left: second");
  BOOST_TEST(step_line(1, 4, "second", 5, 9) == "1/4, 9 s, about 11 s left: second");
  BOOST_TEST(step_line(1, 4, "second", 5, 21) == "1/4, 21 s: second");  // longer than was expected
  BOOST_TEST(step_line(4, 4, "end", 20, 20) == "4/4, 20 s: end");
}

BOOST_AUTO_TEST_CASE(without_a_terminal_nothing_is_shown) {
  const test::Folder folder;
  for (const char* arguments : {"solve own-moes-5-5", "verify --rung 0"}) {
    const auto ended = test::ehd_run(folder, arguments);
    BOOST_TEST(ended.exit_code == 0);
    BOOST_TEST(ended.err == "", arguments);
  }
}

BOOST_AUTO_TEST_SUITE_END()
