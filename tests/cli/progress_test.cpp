// SPDX-License-Identifier: GPL-3.0-or-later
// The line that shows how far a command has come. What a terminal sees of it: terminal.py.
#include "cli/progress.hpp"

#include <optional>
#include <string>
#include <vector>

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

BOOST_AUTO_TEST_CASE(a_time_left_that_is_not_known_is_not_shown) {
  using ehd::cli::step_line_until;
  BOOST_TEST(step_line_until(1, 4, "second", {}, 5) == "1/4, 5 s: second");
  BOOST_TEST(step_line_until(1, 4, "second", 12, 5) == "1/4, 5 s, about 7 s left: second");
  BOOST_TEST(step_line_until(1, 4, "second", 12, 13) == "1/4, 13 s: second");
}

// Runs of a certified solver take a hundred times as long as those of a quick one. They do not count alike.
BOOST_AUTO_TEST_CASE(the_time_left_is_that_of_runs_by_the_same_solver) {
  using ehd::cli::time_left_s;
  using Runs = std::vector<ehd::cli::PlannedRun>;
  const auto left = [](const Runs& runs) { return time_left_s(runs).value_or(-1); };  // -1: not known
  const auto slow = [](std::optional<double> took_s = {}) {
    return ehd::cli::PlannedRun{.solver = "slow", .took_s = took_s};
  };
  const auto quick = [](std::optional<double> took_s = {}) {
    return ehd::cli::PlannedRun{.solver = "quick", .quick = true, .took_s = took_s};
  };
  const ehd::cli::PlannedRun other{.solver = "other"};
  BOOST_TEST(left({slow(), slow(), quick()}) == -1);
  BOOST_TEST(left({quick(0.1), slow(), slow()}) == -1);
  BOOST_TEST(left({quick(0.1), slow(8.0), slow()}) == 8);
  BOOST_TEST(left({quick(0.1), slow(2.0), slow(8.0), slow(), slow()}) == 16);  // tighter ones take longer
  BOOST_TEST(left({slow(8.0), slow(), quick(), quick()}) == 8);                // quick ones take next to nothing
  BOOST_TEST(left({slow(8.0), other}) == -1);
  BOOST_TEST(left({slow(8.0), quick(0.5), quick()}) == 0.5);
  const ehd::cli::PlannedRun also_quick{.solver = "also quick", .quick = true};
  BOOST_TEST(left({quick(0.1), also_quick}) == -1);  // beside another quick one it counts
}

BOOST_AUTO_TEST_CASE(a_long_title_leaves_the_id_and_the_solver) {
  using ehd::cli::running_line;
  BOOST_TEST(running_line("solving", "own-moes-1000-20", "reference", "Very heavy load") ==
             "solving own-moes-1000-20 with reference: Very heavy load ...");
  BOOST_TEST(running_line("solving", "M = 20, L = 10", "fast", "") == "solving M = 20, L = 10 with fast ...");
  const std::string line = running_line("solving", std::string(200, 'x'), "reference.uniform", std::string(200, 'y'));
  BOOST_TEST(line.find(" with reference.uniform: ") < 60u);
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
