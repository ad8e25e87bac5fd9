// SPDX-License-Identifier: GPL-3.0-or-later
// What a subcommand writes: standard output, lines on standard error, files and folders.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/output_file.hpp"

namespace ehd {
struct Case;
}

namespace ehd::cli {

/// A file that a command reads or writes, and its name in messages: the option, or "the case".
struct NamedFile {
  std::string name;
  std::filesystem::path path;
};
/// The files of cases, each named "the case ID".
[[nodiscard]] std::vector<NamedFile> files_of(const std::vector<Case>& cases);
/// Throws UsageError where an output is the same file as an input or as another output, also by another path, and where
/// an output other than --json is "-". Outputs with an empty path are left out. Call before any work.
void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// The ending of a file's name in small letters: ".svg".
[[nodiscard]] std::string ending_of(const std::filesystem::path& name);

/// Opens the file that an option names, if the option was given. Call before any work, so that a file that cannot be
/// written is found before the computation. Throws OutputError.
[[nodiscard]] std::optional<OutputFile> opened(const std::optional<std::string>& name);
/// Null where there is no file.
[[nodiscard]] inline OutputFile* address_of(std::optional<OutputFile>& file) { return file ? &*file : nullptr; }

/// Standard output is a terminal, NO_COLOR is not set and TERM is not "dumb".
[[nodiscard]] bool styled_output();

/// Opens /dev/null for each standard stream that the caller closed, so that reading and writing there still fail. Else
/// the next file would get the stream's number, and text for the stream would go into that file. Call at the begin of
/// the program.
void hold_closed_streams();

/// Writes to standard output and checks that it arrived; throws OutputError.
void print(const std::string& text);
/// One line on standard error. Of a line of more than 4000 bytes the middle is left out.
void complain(const std::string& line);

/// --output DIR: a folder and its files. The folder and those above it are made where they do not exist, and removed at
/// the end where they are still empty, so that a refused call leaves nothing. Without the option, nothing is written.
class OutputFolder {
 public:
  explicit OutputFolder(const std::optional<std::string>& option);  ///< throws OutputError
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Opens files before the work begins, so that a folder that cannot be written is found before the computation.
  /// Throws OutputError.
  void open(const std::vector<std::string>& names);
  /// The text of a file that was opened. Throws OutputError.
  void write(const std::string& name, const std::string& text);
  /// The files that have a text appear, together. Throws OutputError.
  void commit();

 private:
  void remove_empty();
  std::filesystem::path path_;  ///< empty without the option
  std::vector<std::filesystem::path> made_;
  std::map<std::string, OutputFile> files_;
};

/// --json FILE|-: opens the file before the work begins.
class JsonTarget {
 public:
  explicit JsonTarget(const std::optional<std::string>& option);
  [[nodiscard]] bool asked() const { return asked_; }
  [[nodiscard]] bool to_standard_output() const { return asked_ && !file_; }
  /// The JSON appears, together with the other files that have a text. Throws OutputError.
  void commit(const Json& json, const std::vector<OutputFile*>& others = {});

 private:
  bool asked_ = false;
  std::optional<OutputFile> file_;
};

}  // namespace ehd::cli
