// SPDX-License-Identifier: GPL-3.0-or-later
// The table of case keys: every table and every key that a case file may have, with unit, allowed values, default and
// meaning. The reader, its checks for unknown keys, substitutions and messages iterate over it.
//
// To add a key: a row in case_key_rows.cpp, and the line that reads it (read_contact, read_bearing or expectations).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ehd {

/// The values that a number may have: low..high, and 0 where `or_zero`.
struct Interval {
  double low = 0;
  double high = 0;
  bool open_low = false;  ///< low itself is not allowed
  bool or_zero = false;   ///< 0 is allowed beside low..high
  [[nodiscard]] bool contains(double x) const;
  [[nodiscard]] std::string text() const;  ///< "0, or 1e-9 to 1e12"
};

/// The kinds of values of a key, beside a number in an Interval.
namespace allowed {
struct Integer {
  int low = 0, high = 0;
};
/// One of a few numbers.
struct OneOf {
  std::span<const double> (*numbers)();
};
/// [low, high] with low < high.
struct Pair {
  Interval each;
};
/// One of a few words.
struct Word {
  std::vector<std::string> (*words)();
};
/// One line of text, or a word that only the reader can check.
struct Text {
  std::string_view what;  ///< in messages
};
/// The word, or a number from `farthest` to less than `edge`.
struct Inlet {
  std::string_view word;
  double farthest = 0, edge = 0;
};
}  // namespace allowed
using Allowed = std::variant<Interval, allowed::Integer, allowed::OneOf, allowed::Pair, allowed::Word, allowed::Text,
                             allowed::Inlet>;

/// "a number, 0.001 to 1e6", "an integer, 3 to 400", "\"inner\", \"outer\"", …
[[nodiscard]] std::string text_of(const Allowed& allowed);

/// Whether a table must have a key.
enum class Need { always, sometimes, never };

struct CaseKey {
  std::string_view name;
  std::string_view unit = {};  ///< empty: a pure number or no number
  Allowed allowed;
  Need need = Need::always;
  std::string_view condition = {};      ///< when it must be there; for Need::sometimes
  std::optional<double> standard = {};  ///< the value without the key
  std::string_view otherwise = {};      ///< what holds without the key, where that is not a number
  bool bearing_only = false;            ///< the table stands in contact cases too, but without this key
  std::string_view meaning;
  std::string_view example;  ///< a value as TOML, for a new case
  bool in_new = false;  ///< a new case states it although not every case has to; the others stand there as comments
  /// What the key is: the meaning up to its first semicolon.
  [[nodiscard]] std::string_view what() const { return meaning.substr(0, meaning.find(';')); }
};

enum class TableRole {
  heading,      ///< the keys above the first table
  statement,    ///< states the problem; a case has exactly one
  companion,    ///< belongs to a statement
  expectation,  ///< [[expect]], any number of them
};

struct CaseTable {
  std::string_view name;  ///< empty for the heading
  TableRole role = TableRole::companion;
  bool in_contact = false, in_bearing = false;  ///< which kind of case may have it
  bool required = false;                        ///< every case of that kind has it
  std::string_view meaning;
  std::span<const CaseKey> keys;
};

/// Every table, the heading first.
[[nodiscard]] std::span<const CaseTable> case_tables();
/// Null for a name that no table has.
[[nodiscard]] const CaseTable* find_case_table(std::string_view name);
/// The row of "id", "moes.M" or "expect.3.value". Throws std::logic_error where the table has none.
[[nodiscard]] const CaseKey& row_of_case_key(std::string_view path);

/// Names in the order of the table, for checks and messages.
[[nodiscard]] std::vector<std::string> names_of_keys(const CaseTable& table, bool in_contact_case = false);
[[nodiscard]] std::vector<std::string> names_of_companions(bool of_bearing);
/// The tables with keys that can be given another value: all but the heading and [[expect]].
[[nodiscard]] bool is_substitutable(const CaseTable& table);

/// "a, b, c"
[[nodiscard]] std::string list(const std::vector<std::string>& items);
/// "\"a\", \"b\""
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& items);

}  // namespace ehd
