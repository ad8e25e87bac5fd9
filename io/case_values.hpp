// SPDX-License-Identifier: GPL-3.0-or-later
// One value of a case, checked against its row in io/case_keys. Each function throws a CaseError that names the key,
// its line, what is wrong and what is allowed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "contact/conditions.hpp"

namespace ehd {

class CaseTree;
struct CaseNode;
struct Interval;
class StatementError;

/// A number in the interval of the key's row, or in `interval`.
[[nodiscard]] double number(const CaseTree& tree, std::string_view key);
[[nodiscard]] std::optional<double> maybe_number(const CaseTree& tree, std::string_view key);
[[nodiscard]] std::optional<double> maybe_number(const CaseTree& tree, std::string_view key, const Interval& interval);
/// The default of the row where the file has no such key.
[[nodiscard]] double number_or_standard(const CaseTree& tree, std::string_view key);
/// A number that is part of the key's value.
[[nodiscard]] double number_in(const CaseTree& tree, std::string_view key, const CaseNode& node,
                               const Interval& interval);
/// One of the few numbers of the key's row.
[[nodiscard]] std::optional<double> maybe_one_of(const CaseTree& tree, std::string_view key);
[[nodiscard]] int integer(const CaseTree& tree, std::string_view key);

/// One line of text without control characters: tables and bibliographies print it.
[[nodiscard]] std::string text(const CaseTree& tree, std::string_view key);
/// The same with other words for what is allowed, which only a refusal makes.
[[nodiscard]] std::string text(const CaseTree& tree, std::string_view key, const std::function<std::string()>& allowed);
/// One of the words in the key's row.
[[nodiscard]] std::string word(const CaseTree& tree, std::string_view key);

/// Where the oil begins: the word or the number in the key's row.
[[nodiscard]] Inlet inlet(const CaseTree& tree, std::string_view key);

/// Refuses a value that the key's row does not allow. A pair of numbers is left to its reader.
void check_value(const CaseTree& tree, std::string_view key);

/// The node of a key that must be there.
[[nodiscard]] const CaseNode& required(const CaseTree& tree, std::string_view key);
/// Refuses the key with the sentence of nondimensionalise. Adds what is allowed where that sentence does not have it.
[[noreturn]] void fail_statement(const CaseTree& tree, std::string_view key, const StatementError& error);
/// The interval in the key's row.
[[nodiscard]] const Interval& interval_of(std::string_view key);

}  // namespace ehd
