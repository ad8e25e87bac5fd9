// SPDX-License-Identifier: GPL-3.0-or-later
// The finished rows of a run, a sweep's or the atlas's, in a file that only grows: one line a row, with its checksum. A
// run that is killed loses no more than the line that it was writing. The rows stay in the file; memory holds their
// places.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/content_hash.hpp"
#include "io/output_file.hpp"

namespace ehd {

/// What a journal holds: which part of which run. The unsharded run is part 1 of 1.
struct JournalHeader {
  std::string owner;  ///< a sweep's hash, or the part of the atlas
  std::size_t shard = 1, of = 1;
};

class Journal {
 public:
  /// Opens the journal in `folder` for a run; makes the folder where there is none. Keeps the rows whose hashes are in
  /// `wanted`, and removes damaged lines and all other rows. Throws OutputError where the folder
  /// cannot be written, its journal is no regular file, or another run is at work there.
  Journal(const std::filesystem::path& folder, const JournalHeader& header, std::vector<HashNumber> wanted, bool fresh);

  /// Reads a journal for a merge, and changes nothing. Keeps the rows in `wanted`. Throws OutputError where a line is
  /// damaged, or where the header belongs to another run or shard.
  Journal(const std::filesystem::path& folder, const JournalHeader& header, std::vector<HashNumber> wanted);

  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] bool holds(const std::string& hash) const;
  /// The row's text as it was added. Throws OutputError where the file has changed meanwhile.
  [[nodiscard]] std::string row(const std::string& hash) const;
  /// Drops the row, so that it is computed again. Its line stays; of two lines with one hash the last one counts.
  void forget(const std::string& hash) { places_.at(index_of(hash).value()).bytes = 0; }
  /// One line without line feeds. Throws OutputError. Not from several threads at once. The line survives the end of
  /// the process at once. A power failure may lose the lines of the last 0.2 s, and the last line until this object
  /// ends.
  void add(const std::string& hash, const std::string& text);

 private:
  struct Place {
    std::size_t begin = 0, bytes = 0;  ///< no bytes: the row is not there
  };
  struct Read {
    bool whole = true;         ///< nothing but wanted rows, each line with its checksum
    std::string header;        ///< empty where there is none
    std::size_t bad_line = 0;  ///< first damaged line, from 1; 0: none
  };
  /// Index of a wanted row; absent where it is not wanted.
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view hash) const;
  Read read();
  void rewrite(const std::string& header);
  void open_file(int flags);
  void require_file_or_none() const;
  void sync();

  std::filesystem::path folder_, file_;
  int lock_ = -1, descriptor_ = -1;
  std::size_t end_ = 0;
  std::vector<HashNumber> wanted_;  ///< in order, each once
  std::vector<Place> places_;       ///< of the wanted rows
  std::chrono::steady_clock::time_point synced_ = {};
  bool unsynced_ = false;  ///< a line may not be on the disk yet
};

}  // namespace ehd
