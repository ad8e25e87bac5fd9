// SPDX-License-Identifier: GPL-3.0-or-later
// A commented case to start from, and the keys of a case as tables in Markdown: both made from io/case_keys.
#pragma once

#include <string>
#include <string_view>

#include "io/bearing_types.hpp"

namespace ehd {

enum class CaseKind { contact, bearing };

/// A valid case file: every key of that kind of case with its meaning, unit and default. Optional keys, and other ways
/// to state the problem, are comments.
[[nodiscard]] std::string case_template(CaseKind kind, const std::string& id);

/// The template of a bearing, with comments that say how this type is stated, and what its keys mean. A full complement
/// has as many rollers as fit.
[[nodiscard]] std::string bearing_template(const BearingType& type, const std::string& id);

/// A table in Markdown for each table of a case. docs/case-format.md has them.
[[nodiscard]] std::string case_key_tables();

}  // namespace ehd
