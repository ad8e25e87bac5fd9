// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace ehd {

/// A file cannot be written: what() names the file and says why.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that appears at commit. The constructor already opens a temporary file beside it, so
/// that a path that cannot be written is refused before anything is computed (OutputError). Devices and pipes
/// (/dev/stdout) are written directly.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// Throws OutputError; the old file is then still there.
  void commit(const std::string& text);

  /// The same in pieces, for text that does not fit into memory. The file appears at commit().
  void append(const std::string& text);
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty when done, or for a device
};

}  // namespace ehd
