// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a file that the program reads as a whole. Kind and size are checked first: a pipe would block, and
// /dev/zero has no end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ehd {

/// What a reader asks for.
struct FileKind {
  std::string_view name;          ///< in messages: "a case file (TOML)"
  std::uintmax_t most_bytes = 0;  ///< a larger file is refused
};

/// "there is no such file", "is a directory", "is not a regular file", "cannot be read (why)"; empty for a regular file
/// that may be read.
[[nodiscard]] std::string fault_of_file(const std::filesystem::path& file);

/// Throws CaseError, "FILE: the fault; allowed is KIND": a fault of the file, or more than most_bytes.
[[nodiscard]] std::string text_of_file(const std::filesystem::path& file, const FileKind& kind);

/// The same, and nothing where there is no such file.
[[nodiscard]] std::optional<std::string> text_if_there(const std::filesystem::path& file, const FileKind& kind);

}  // namespace ehd
