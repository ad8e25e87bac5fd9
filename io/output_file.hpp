// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/temporary_files.hpp"

namespace ehd {

/// A file cannot be written: what() names the file and says why.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What may stand under the name already. A file of a folder that the program fills is never a pipe: opening one waits
/// for a reader, perhaps for ever.
enum class Replaces { file, file_or_device };

/// A file that appears at commit, with the mode of the file that it replaces. The constructor already opens a temporary
/// file beside it, so that a path that cannot be written is refused before anything is computed (OutputError). It also
/// removes temporary files of the same output whose writer was killed. Devices and pipes (/dev/stdout) are written
/// directly, or refused.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path, Replaces replaces = Replaces::file_or_device);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// Writes the next piece of the text. Throws OutputError; the old file is then still there.
  void append(const std::string& text);
  /// The file is on the disk when this returns. Throws OutputError.
  void commit();
  void commit(const std::string& text) {
    append(text);
    commit();
  }

 private:
  friend void commit_together(const std::vector<OutputFile*>& files);
  void open_temporary();
  void settle();             ///< the text is on the disk
  void appear();             ///< under its name
  void withdraw() noexcept;  ///< after appear(): the file that was there before is back
  void finish() noexcept;    ///< the file that was there before is gone

  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty when done, or for a device
  /// exchanged: temporary_ names the file that was there before. replaced: that file is gone.
  enum class Appeared { not_yet, as_new, exchanged, replaced } appeared_ = Appeared::not_yet;
  TemporaryNote note_;
  int descriptor_ = -1;
  bool written_ = false;
};

/// Makes a folder and those above it, where they do not exist. Throws OutputError, which names the file that is in the
/// way.
void make_folder(const std::filesystem::path& folder);

/// A file that does not exist yet. Throws OutputError where it does, and then leaves it as it is.
void write_new_file(const std::filesystem::path& path, const std::string& text);

/// Commits those of the files that have a text: all texts are on the disk before the first file appears, and SIGINT and
/// SIGTERM wait until the last one has. Where one cannot appear, those before it are as they were (on a file system
/// that cannot exchange two names, one that replaced a file stays). A null pointer is no file. Throws OutputError.
void commit_together(const std::vector<OutputFile*>& files);

}  // namespace ehd
