// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the temporary files of this process, where a signal handler can read them.
#pragma once

#include <string>

namespace ehd {

/// The note of one temporary file or folder. remove_temporary_files() removes it while the note exists. There is room
/// for 64 notes with names up to 4095 bytes. A file beyond that has no note; the next run with the same output removes
/// it.
class TemporaryNote {
 public:
  TemporaryNote() = default;
  explicit TemporaryNote(const std::string& name);
  ~TemporaryNote() { forget(); }
  TemporaryNote(TemporaryNote&& other) noexcept;
  TemporaryNote& operator=(TemporaryNote&& other) noexcept;
  TemporaryNote(const TemporaryNote&) = delete;
  TemporaryNote& operator=(const TemporaryNote&) = delete;

 private:
  void forget();
  int place_ = -1;
};

/// Removes every file with a note, then every folder with a note that is empty. For a signal handler that ends the
/// process: calls only what a handler may call, and from then on no note is written.
void remove_temporary_files() noexcept;

}  // namespace ehd
