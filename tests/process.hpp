// SPDX-License-Identifier: GPL-3.0-or-later
// The program run as its users run it.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/files.hpp"

namespace ehd::verification::test {

struct Ended {
  int exit_code = -1;  ///< -1: killed by a signal
  std::string out, err;
  [[nodiscard]] long error_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

[[nodiscard]] inline bool holds_null(const nlohmann::json& json) {
  return json.is_structured() ? std::any_of(json.begin(), json.end(), holds_null) : json.is_null();
}

/// No JSON that the program writes holds null: what is unknown is absent. A text that is no JSON passes.
inline void check_without_null(const std::string& what, const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const bool null = json.is_structured() && holds_null(json);
  BOOST_CHECK_MESSAGE(!null, what << " holds null");
}

/// The files *.json in a folder, with the times when they were written.
[[nodiscard]] inline std::map<std::filesystem::path, std::filesystem::file_time_type> json_files(const Folder& folder) {
  std::map<std::filesystem::path, std::filesystem::file_time_type> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    if (entry.path().extension() == ".json" && entry.is_regular_file()) files[entry.path()] = entry.last_write_time();
  return files;
}

/// `ehd ARGUMENTS`, as a shell would read them. Every JSON that it writes, here or into the folder, is searched for
/// null.
[[nodiscard]] inline Ended ehd_run(const Folder& folder, const std::string& arguments) {
  const auto out = folder.path() / "stdout.txt", err = folder.path() / "stderr.txt";
  const std::string command = fmt::format("'{}' {} > '{}' 2> '{}'", EHD_PROGRAM, arguments, out.string(), err.string());
  const auto before = json_files(folder);
  const int status = std::system(command.c_str());
  Ended ended{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .out = read(out), .err = read(err)};
  check_without_null("the output of ehd " + arguments, ended.out);
  for (const auto& [file, time] : json_files(folder))
    if (const auto old = before.find(file); old == before.end() || old->second != time)
      check_without_null(file.filename().string() + " of ehd " + arguments, read(file));
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
