// SPDX-License-Identifier: GPL-3.0-or-later
// What every reader of a TOML file here needs of the parser: a tree or one clear line, and what stands where. For
// source files only: the parser's header is large.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ehd {

/// `text` as checked_case_text leaves it. Throws CaseError, "FILE:LINE: source: what is wrong; what is allowed".
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

/// "a table", "a text", "an integer", …
[[nodiscard]] std::string type_of(const toml::node& node);

/// The line of a node, 1 for one that was made here.
[[nodiscard]] int line_of(const toml::node& node);

/// The value as it stands in the file, its first line, shortened; `lines` as lines_of gives them.
[[nodiscard]] std::string text_of(const toml::node& node, const std::vector<std::string>& lines);

}  // namespace ehd
