// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program_text.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/provenance.hpp"
#include "io/version.hpp"

namespace ehd {

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string exact_number(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string braced(const std::vector<double>& values) {
  std::string text = "{";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + exact_number(value);
  return text + "}";
}

std::string identifier(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

std::string in_c_comment(const std::string& text) {
  std::string line;
  for (const char c : one_line(text)) {
    const char before = line.empty() ? ' ' : line.back();
    if ((before == '*' && c == '/') || (before == '/' && c == '*')) line += ' ';
    line += c;
  }
  return line;
}

std::string with_prefix(std::string text, const std::string& prefix) {
  constexpr std::string_view word = "PREFIX";
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + prefix.size()))
    text.replace(at, word.size(), prefix);
  return text;
}

std::string made_by() {
  const Json json = provenance();
  return fmt::format("ehd {}, {}, {}", json["version"].get<std::string>(), commit_words(std::string::npos),
                     json["date"].get<std::string>());
}

}  // namespace ehd
