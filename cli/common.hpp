// SPDX-License-Identifier: GPL-3.0-or-later
// What the subcommands share: options of a solve, usage errors, streams.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "contact/solver.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

enum ExitCode { success = 0, not_met = 1, bad_input = 2 };

/// Wrong usage: what() is the one line for standard error; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "OPTION = VALUE: message", the way every refused option is worded.
[[nodiscard]] UsageError option_error(const std::string& option, const std::string& value, const std::string& message);

/// Runs a subcommand's body and returns the exit code. Wrong input (CaseError, UsageError, OutputError, StatementError)
/// ends in one line on standard error and exit code 2, lack of memory in one line and exit code 1.
[[nodiscard]] int run_guarded(const std::function<int()>& body);

/// Texts as given on the command line, read strictly: option names the culprit in the UsageError.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);
[[nodiscard]] int parse_integer(const std::string& option, const std::string& text);

/// --tolerance | --nodes, --max-iterations, --time-limit, as texts until they are checked.
struct RequestOptions {
  std::optional<std::string> tolerance, nodes, max_iterations, time_limit;
  void add_to(Command& command, bool with_accuracy = true);
  /// Throws UsageError: not finite, not positive, fewer than 16 nodes, both tolerance and nodes.
  [[nodiscard]] Request request() const;
};

/// Throws UsageError for an unknown name.
[[nodiscard]] const RegisteredSolver& solver_named(const std::string& name);
[[nodiscard]] Wanted quantities_named(const std::vector<std::string>& names);

/// Throws UsageError where that many intervals do not fit into memory.
void require_memory(const RegisteredSolver& solver, const Request& request);

/// One place that a command reads or writes, with how to call it: the option, or "the case".
struct NamedFile {
  std::string name;
  std::filesystem::path path;
};
/// Throws UsageError where an output is an input or another output, however the two are spelled, or is "-", which means
/// standard output for --json alone. Call before any work.
void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// A line on standard error while something runs, on a terminal only; removed at the end.
class Progress {
 public:
  Progress() = default;
  ~Progress() { show(""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(const std::string& line);

 private:
  std::size_t shown_ = 0;
};

/// Standard output is a terminal, NO_COLOR is not set and TERM is not "dumb".
[[nodiscard]] bool styled_output();

/// Writes to standard output and checks that it arrived; throws OutputError.
void print(const std::string& text);
/// One line on standard error.
void complain(const std::string& line);

/// --output DIR: a folder with those above it, made where they do not exist. What is still empty at the end goes again,
/// so that a refused call leaves nothing.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& name);  ///< throws UsageError
  ~OutputFolder() { remove_empty(); }
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void remove_empty();
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;
};

/// --json FILE|-: opens the file before the work begins.
class JsonTarget {
 public:
  explicit JsonTarget(const std::optional<std::string>& option);
  [[nodiscard]] bool asked() const { return asked_; }
  [[nodiscard]] bool to_standard_output() const { return asked_ && !file_; }
  void write(const Json& json);

 private:
  bool asked_ = false;
  std::optional<OutputFile> file_;
};

}  // namespace ehd::cli
