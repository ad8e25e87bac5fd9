// SPDX-License-Identifier: GPL-3.0-or-later
// The TOML parser for all readers: a tree or one clear line, and the line and text of each node. Only source files
// include this header, because the parser's own header is large.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ehd {

/// `text` as checked_case_text leaves it. Throws CaseError, "FILE:LINE: source: what is wrong; what is allowed".
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

/// The keys of a table that are not among `allowed`, with their nodes, in the order of the file.
[[nodiscard]] std::vector<std::pair<std::string, const toml::node*>> unknown_keys(
    const toml::table& table, const std::vector<std::string>& allowed);

/// The integer of a node; null for all else, and for one that is written as 0x14, 0o24 or 0b10100: numbers of a case
/// are decimal.
[[nodiscard]] const toml::value<std::int64_t>* decimal_integer(const toml::node& node);

/// "a table", "a text", "an integer", …; "no decimal number" for 0x14
[[nodiscard]] std::string type_of(const toml::node& node);

/// The line of a node; 1 for a node that is not from the file.
[[nodiscard]] int line_of(const toml::node& node);

/// The value as it stands in the file, its first line, shortened; `lines` as lines_of gives them.
[[nodiscard]] std::string text_of(const toml::node& node, const std::vector<std::string>& lines);

}  // namespace ehd
