// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: a program with subcommands, and the options of each. Built on CLI11, which command_line.cpp alone
// includes: the library costs 15 s of compile time in every source that does.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ehd::cli {

/// The words that an option's value may be, "one, two", for those that have such a list.
using WordsOfOptions = std::map<const CLI::Option*, std::string>;

/// One option, for settings besides its name and help text.
class Option {
 public:
  Option(CLI::Option& option, WordsOfOptions& words) : option_(option), words_(words) {}

  Option& called(const std::string& value_name);  ///< the name of its value in the help: "--output DIR"
  Option& required();
  Option& showing_default();  ///< the help shows the value that the variable holds now: "TEXT=fast"
  /// The shell offers these words, "one, two": as the value of an option, or in the place of the first argument.
  Option& completed_by(const std::string& words);

 private:
  CLI::Option& option_;
  WordsOfOptions& words_;
};

/// One subcommand: its options write into variables that must live until the command line has run. A name that begins
/// with "--" is an option, any other a positional argument.
class Command {
 public:
  /// `exit_code` receives what the work returns, `words` those of the options.
  Command(CLI::App& app, int& exit_code, WordsOfOptions& words) : app_(app), exit_code_(exit_code), words_(words) {}

  void summary(const std::string& line);   ///< shown in `ehd --help`, and first in the command's own help
  void examples(const std::string& text);  ///< shown below the options

  Option text(const std::string& name, std::string& value, const std::string& help);
  Option text(const std::string& name, std::optional<std::string>& value, const std::string& help);
  /// An option takes one value each time and may be repeated; a positional argument takes all that are there.
  Option list(const std::string& name, std::vector<std::string>& values, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  /// The work of the command; returns the exit code of the program. What `body` throws is handled as in run_guarded.
  void runs(std::function<int()> body);

 private:
  CLI::App& app_;
  int& exit_code_;
  WordsOfOptions& words_;
};

struct Subcommand {
  std::string name;
  std::function<void(Command&)> describe;  ///< defines its options and its work
};

struct Program {
  std::string name;
  std::function<std::string()> version;  ///< what --version prints behind the name
  std::string summary, examples;
  std::vector<Subcommand> subcommands;  ///< in the order of the help
};

/// Reads the arguments, runs the subcommand that they choose, and returns its exit code. Wrong usage is one line on
/// standard error and exit code 2; help and version are printed with exit code 0. Throws OutputError.
[[nodiscard]] int run_command_line(const Program& program, int argc, char** argv);

}  // namespace ehd::cli
