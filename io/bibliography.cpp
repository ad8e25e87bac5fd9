// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bibliography.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "io/file_text.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

std::string without_braces(std::string text) {
  std::erase_if(text, [](char c) { return c == '{' || c == '}'; });
  while (!text.empty() && (text.back() == ',' || text.back() == ' ')) text.pop_back();
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

}  // namespace

std::string BibliographyEntry::citation() const {
  const auto field = [&](const std::string& name) {
    const auto at = fields.find(name);
    return at == fields.end() ? std::string() : at->second;
  };
  std::string line = field("author");
  for (auto at = line.find(" and "); at != std::string::npos; at = line.find(" and ", at)) {
    const bool last = line.find(" and ", at + 1) == std::string::npos;
    line.replace(at, 5, last ? " & " : ", ");
  }
  if (const auto at = line.find(" & others"); at != std::string::npos) line.replace(at, 9, " et al.");
  if (!field("year").empty()) line += " (" + field("year") + ")";
  if (!field("title").empty()) line += ", " + field("title");
  if (!field("version").empty()) line += ", version " + field("version");
  if (!field("journal").empty()) line += fmt::format(", {} {}", field("journal"), field("volume"));
  if (!field("pages").empty()) {
    std::string pages = field("pages");
    if (const auto dashes = pages.find("--"); dashes != std::string::npos) pages.replace(dashes, 2, "-");
    line += ", " + pages;
  }
  if (!field("doi").empty()) line += ", doi " + field("doi");
  return line;
}

Bibliography read_bibliography(const std::filesystem::path& file) {
  constexpr FileKind kind{.name = "the bibliography of the cases (BibTeX)", .most_bytes = 1 << 20};
  std::istringstream stream(text_of_file(file, kind));
  Bibliography bibliography;
  BibliographyEntry entry;
  std::string line;
  while (std::getline(stream, line)) {
    if (line.starts_with('@')) {
      const auto brace = line.find('{');
      entry = {};
      entry.key = without_braces(line.substr(std::min(brace, line.size())));
    }
    if (entry.key.empty()) continue;
    entry.text += line + "\n";
    const auto equals = line.find(" = ");
    if (!line.starts_with('@') && equals != std::string::npos) {
      const std::string name = without_braces(line.substr(0, equals));
      entry.fields[name] = without_braces(line.substr(equals + 3));
    }
    if (line == "}") {
      bibliography[entry.key] = entry;
      entry = {};
    }
  }
  return bibliography;
}

std::string bibliography_key(const std::string& source) { return source.substr(0, source.find(',')); }

}  // namespace ehd
