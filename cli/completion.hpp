// SPDX-License-Identifier: GPL-3.0-or-later
// Completion of the command line by a shell, made from the options that the program itself has.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ehd::cli {

/// What may follow a subcommand, or the program itself (the first, without a name).
struct CommandWords {
  std::string name;
  std::vector<std::string> options;
  std::vector<std::string> with_case = {};   ///< options whose value is a case
  std::vector<std::string> with_value = {};  ///< options with another value
  bool takes_cases = false;                  ///< the ids of the benchmark cases are words too
  std::string first = {};                    ///< the words that the first argument may be, "one, two"
  /// Options whose value is one of some words, "one, two".
  std::vector<std::pair<std::string, std::string>> with_word = {};
};

inline constexpr const char* completion_shells = "bash, zsh";

/// A script for bash, or for zsh. Throws UsageError for another shell.
[[nodiscard]] std::string completion_script(const std::string& program, const std::vector<CommandWords>& commands,
                                            const std::string& shell);

}  // namespace ehd::cli
