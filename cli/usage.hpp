// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong usage: messages and exit codes.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "io/case_keys.hpp"

namespace ehd::cli {

enum ExitCode { success = 0, not_met = 1, bad_input = 2 };

/// Wrong usage: what() is the one line for standard error; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "OPTION = VALUE: message", for every refused option.
[[nodiscard]] UsageError option_error(const std::string& option, const std::string& value, const std::string& message);

/// "OPTION = VALUE: is unknown; did you mean ...? allowed is ALLOWED", a list of words: "one, two".
[[nodiscard]] UsageError unknown_word_error(const std::string& option, const std::string& value,
                                            const std::string& allowed);

/// Runs a subcommand's body and returns the exit code. Wrong input (CaseError, UsageError, OutputError, StatementError)
/// ends in one line on standard error and exit code 2, lack of memory in one line and exit code 1. `without_memory`:
/// what the user may do about that lack.
[[nodiscard]] int run_guarded(const std::function<int()>& body, const std::string& without_memory = "");

/// A number of the command line: the whole text must be one, inside the range. The UsageError names the option and what
/// is allowed.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text, const Interval& range);
[[nodiscard]] int parse_integer(const std::string& option, const std::string& text, const allowed::Integer& range);

}  // namespace ehd::cli
