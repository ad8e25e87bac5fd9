// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a case file, checked before the TOML parser sees them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ehd {

/// What a TOML file is for, in messages.
enum class TomlFile { of_case, of_sweep, case_in_memory };

/// The file's text without a byte order mark. Throws CaseError for a file that is missing, a directory or device,
/// unreadable, larger than 64 KiB, empty, binary (control characters) or not UTF-8. Refuses also: non-ASCII characters
/// outside strings and comments, and lines that begin with a bracket but are no table (toml++ 3.3.0 misbehaves on
/// both); lines longer than 2000 bytes (thousands of nested keys would exhaust the parser's stack).
[[nodiscard]] std::string read_case_text(const std::filesystem::path& file, TomlFile what = TomlFile::of_case);

/// The same of bytes in memory; `file` names them in messages.
[[nodiscard]] std::string checked_case_text(std::string bytes, const std::filesystem::path& file,
                                            TomlFile what = TomlFile::of_case);

/// How messages name standard input. No case file has this name: it is no id.
inline constexpr const char* standard_input = "standard input";
/// What stands on standard input, up to just above the largest size that checked_case_text takes.
[[nodiscard]] std::string text_of_standard_input();

/// An id, so that every file system, shell and table takes it.
inline constexpr const char* allowed_in_id =
    "letters, digits, dot, dash and underscore, beginning with a letter or a digit";
[[nodiscard]] bool is_id(std::string_view text);

/// The name of a file without .toml. Throws CaseError where it is no id.
[[nodiscard]] std::string id_of_file(const std::filesystem::path& file);

/// The lines of a text, without line ends (LF or CRLF).
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

}  // namespace ehd
