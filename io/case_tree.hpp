// SPDX-License-Identifier: GPL-3.0-or-later
// A case file as a tree: the nodes of its TOML text by dotted path, with the line of each. Unknown keys are found here.
// What the values mean is known to read_contact, read_bearing and expectations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/substitution.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// What messages call a text without a file and without an id. A text with an id stands for the file "ID.toml".
inline constexpr const char* nameless_case = "case";

/// One value of the file.
struct CaseNode {
  std::string type;  ///< "a table", "an integer", "a text", … for messages
  /// Empty for a table, a boolean, a date or time: no key of a case holds one.
  std::variant<std::monostate, std::int64_t, double, std::string, std::vector<CaseNode>> content = {};
  [[nodiscard]] std::optional<double> number() const;  ///< integer or not
};

/// A key that io/case_keys does not have.
struct UnknownKey {
  int line = 0;
  std::string message;  ///< the whole line of the error
  std::string meant;    ///< the path of the key that it may have been meant to be; empty where nothing is near
};

class CaseTree {
 public:
  /// `text` as checked_case_text leaves it. Substituted values pass every check that the file's own would; messages
  /// about them name no line, but the option that gave them. With substitutions the file's [[expect]] tables are left
  /// out, since they hold for the file's own numbers. Throws CaseError for text that is not TOML, and for a
  /// substitution of a key that io/case_keys does not have.
  CaseTree(const std::string& text, const std::filesystem::path& file,
           const std::vector<Substitution>& substitutions = {});

  /// By path: "id", "moes", "moes.M"; the [[expect]] tables are "expect.0", "expect.1", … Null where there is none.
  [[nodiscard]] const CaseNode* find(std::string_view path) const;
  [[nodiscard]] bool has(std::string_view path) const { return find(path) != nullptr; }
  /// 0 where a substitution made the table.
  [[nodiscard]] int line_of(const std::string& path) const { return places_.places.at(path).line; }
  /// The unknown keys, in the order of the file. A case that has some is refused.
  [[nodiscard]] const std::vector<UnknownKey>& unknown() const { return unknown_; }
  /// How many [[expect]] tables there are.
  [[nodiscard]] std::size_t expectations() const { return expectations_; }

  /// A Case that holds only the file, the place of each key (places), and the options that gave keys (given).
  [[nodiscard]] const Case& places() const { return places_; }
  /// Moves places and options into the case that was read. Call last: the tree can then neither be read nor refuse.
  void move_places_to(Case& made) &&;
  /// Throws the CaseError "FILE:LINE: key = value: message".
  [[noreturn]] void fail(std::string_view path, const std::string& message) const;

 private:
  void put(std::string path, CaseNode node, CasePlace place);
  void substitute(const Substitution& substitution);

  Case places_;
  std::map<std::string, CaseNode, std::less<>> nodes_;
  std::size_t expectations_ = 0;
  std::vector<UnknownKey> unknown_;
  friend class TreeBuilder;
};

}  // namespace ehd
