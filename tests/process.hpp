// SPDX-License-Identifier: GPL-3.0-or-later
// The program run as its users run it.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <string>

#include "tests/files.hpp"

namespace ehd::verification::test {

struct Ended {
  int exit_code = -1;  ///< -1: killed by a signal
  std::string out, err;
  [[nodiscard]] long error_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// `ehd ARGUMENTS`, as a shell would read them.
[[nodiscard]] inline Ended ehd_run(const Folder& folder, const std::string& arguments) {
  const auto out = folder.path() / "stdout.txt", err = folder.path() / "stderr.txt";
  const std::string command =
      std::string("'") + EHD_PROGRAM + "' " + arguments + " > '" + out.string() + "' 2> '" + err.string() + "'";
  const int status = std::system(command.c_str());
  Ended ended{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .out = read(out), .err = read(err)};
  return ended;
}

/// Wrong usage ends with exit code 2, with one line on standard error, which says `phrase`, and with nothing else.
inline void check_refused(const Folder& folder, const std::string& arguments, const std::string& phrase) {
  const Ended ended = ehd_run(folder, arguments);
  BOOST_TEST_CONTEXT("ehd " << arguments) {
    BOOST_TEST(ended.exit_code == 2);
    BOOST_TEST(ended.out == "");
    BOOST_CHECK_MESSAGE(ended.error_lines() == 1, "not one line: " << ended.err);
    BOOST_CHECK_MESSAGE(ended.err.find(phrase) != std::string::npos, phrase << " is not in: " << ended.err);
  }
}

}  // namespace ehd::verification::test
