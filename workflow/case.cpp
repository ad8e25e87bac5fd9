// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/case.hpp"

#include "contact/text.hpp"

namespace ehd {

namespace {

/// The keys above the first table; every other key without a dot is a table.
bool is_heading(const std::string& key) { return key == "id" || key == "version" || key == "title" || key == "source"; }

std::string table_text(const std::string& path) {
  return path.starts_with("expect") ? std::string("[[expect]]") : "[" + path + "]";
}

}  // namespace

std::string_view to_string(ExpectationKind kind) {
  switch (kind) {
    case ExpectationKind::exact: return "exact";
    case ExpectationKind::published: return "published";
    case ExpectationKind::computed: return "computed";
    case ExpectationKind::fit: return "fit";
  }
  return "";
}

std::string_view to_string(Scaling scaling) {
  switch (scaling) {
    case Scaling::hertz: return "hertz";
    case Scaling::moes: return "moes";
    case Scaling::SI: return "SI";
    case Scaling::kostreva: return "kostreva";
  }
  return "";
}

std::optional<ExpectationKind> expectation_kind_from(std::string_view text) { return word_from<ExpectationKind>(text); }

std::optional<Scaling> scaling_from(std::string_view text) { return word_from<Scaling>(text); }

CaseError case_error(const Case& where, const std::string& key, const std::string& message) {
  if (const auto option = where.given.find(key); option != where.given.end())
    return CaseError(one_line("ehd: " + option->second + ": " + message));
  const auto dot = key.rfind('.');
  const std::string table = dot == std::string::npos ? "" : key.substr(0, dot);
  const std::string name = dot == std::string::npos ? key : key.substr(dot + 1);

  std::string subject = key;
  int line = 0;
  if (const auto at = where.places.find(key); at != where.places.end()) {
    line = at->second.line;
    const std::string& text = at->second.text;
    subject = key.empty() ? "" : text.empty() ? table_text(key) : name + " = " + text;
  } else if (const auto above = where.places.find(table); above != where.places.end()) {  // a missing key
    line = above->second.line;
    const bool whole_table = table.empty() && !is_heading(key);
    subject = whole_table ? table_text(key) : table.empty() ? name : table_text(table) + " " + name;
  } else if (const auto root = where.places.find(""); root != where.places.end()) {  // a missing table with its key
    line = root->second.line;
    subject = table_text(table) + " " + name;
  }
  std::string text = where.file.string();
  if (line > 0) text += (text.empty() ? "line " : ":") + std::to_string(line);
  if (!text.empty()) text += ": ";
  if (!subject.empty()) text += subject + ": ";
  return CaseError(one_line(text + message));
}

}  // namespace ehd
