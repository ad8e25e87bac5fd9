// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody else's program, run by the shell in a process group of its own, with a time limit.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ehd::judging {

struct CommandEnd {
  std::optional<int> exit_code = {};  ///< absent: not started, or killed by a signal or by the time limit
  std::string words;                  ///< "exit code 3", "ended by Killed", "ended by the time limit of 10 s", ...
  std::string last_line;              ///< of standard error, one printable line; empty where there is none
  double wall_s = 0;                  ///< with the start of the shell and of the program
};

/// `/bin/sh -c command`: standard input and output are /dev/null. What the command leaves running is killed with its
/// group. Where the system gives no process, the words say so.
[[nodiscard]] CommandEnd run_command(const std::string& command, double time_limit_s);

/// The time of a command that does nothing: the shortest of a few; empty where none could be started.
[[nodiscard]] std::optional<double> idle_call_s();

/// A word for the shell.
[[nodiscard]] std::string shell_quoted(const std::string& word);

}  // namespace ehd::judging
