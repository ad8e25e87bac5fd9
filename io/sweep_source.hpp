// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a sweep file and the messages about it. For source files only: the parser's header is large.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/toml.hpp"

namespace ehd {

/// A sweep file as read. All messages are CaseErrors with the file and a line.
class SweepSource {
 public:
  explicit SweepSource(const std::filesystem::path& file);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// A node's value as the file has it.
  [[nodiscard]] std::string written(const toml::node& node) const { return text_of(node, lines_); }

  [[noreturn]] void fail(int line, const std::string& subject, const std::string& message) const;
  /// "key = value: message", at the node's line.
  [[noreturn]] void fail(const std::string& key, const toml::node& node, const std::string& message) const;
  /// "key = value is an integer; allowed is ..."
  [[noreturn]] void fail_type(const std::string& key, const toml::node& node, const std::string& allowed) const;
  [[noreturn]] void missing(const std::string& key, const std::string& required) const;

  /// Refuses all unknown keys, in the order of the file.
  void require_known(const toml::table& table, const std::string& of, const std::vector<std::string>& allowed) const;
  /// The text at a node, or a failure.
  [[nodiscard]] std::string text(const std::string& key, const toml::node& node, const std::string& allowed) const;
  /// One of the texts in `allowed`.
  [[nodiscard]] std::string choice(const std::string& key, const toml::node& node,
                                   const std::vector<std::string>& allowed) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  std::vector<std::string> lines_;
  toml::table root_;
};

/// The number at a node, integer or not.
[[nodiscard]] std::optional<double> number_of(const toml::node& node);

}  // namespace ehd
