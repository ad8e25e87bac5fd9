// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON files of a folder as the report reads them. A wrong type is an error; an absent entry is not.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/json.hpp"

namespace ehd::report {

/// A file that cannot be read. what() is one line: "FILE: the problem; the requirement".
class ReportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A JSON value and its path, which messages name. An absent or null value is an empty View, and so are its members. A
/// value of another type than the one asked for throws ReportError.
class View {
 public:
  View() = default;
  View(const Json& json, std::string path) : json_(json.is_null() ? nullptr : &json), path_(std::move(path)) {}

  [[nodiscard]] bool exists() const { return json_ != nullptr; }
  /// "results.json: claims[3]: verdict"; empty for an empty View.
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool has(const std::string& key) const { return (*this)[key].exists(); }
  [[nodiscard]] View operator[](const std::string& key) const;  ///< of an object
  [[nodiscard]] std::vector<View> list() const;
  [[nodiscard]] std::vector<std::pair<std::string, View>> members() const;
  [[nodiscard]] std::optional<double> number() const;
  [[nodiscard]] std::optional<bool> flag() const;
  [[nodiscard]] std::string text() const;
  /// Numbers of a list; NaN for null.
  [[nodiscard]] std::vector<double> numbers() const;
  /// Plain text for a table: a string itself, a number to `digits` digits, "yes" or "no".
  [[nodiscard]] std::string cell(int digits = 6) const;

  // The same of a member.
  [[nodiscard]] std::vector<View> list(const std::string& key) const { return (*this)[key].list(); }
  [[nodiscard]] std::optional<double> number(const std::string& key) const { return (*this)[key].number(); }
  [[nodiscard]] std::optional<bool> flag(const std::string& key) const { return (*this)[key].flag(); }
  [[nodiscard]] std::string text(const std::string& key) const { return (*this)[key].text(); }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const { return (*this)[key].numbers(); }
  [[nodiscard]] std::string cell(const std::string& key, int digits = 6) const { return (*this)[key].cell(digits); }

 private:
  [[noreturn]] void refuse(const char* required) const;
  const Json* json_ = nullptr;
  std::string path_;
};

/// results.json is required; bench.json and stress.json are optional.
struct Documents {
  Json results;
  Json bench, stress;  ///< null where absent
};

/// Throws ReportError: no such folder, no results.json, a file that is no JSON object, another schema; and CaseError
/// for what text_of_file refuses.
[[nodiscard]] Documents read_documents(const std::filesystem::path& folder);

}  // namespace ehd::report
