// SPDX-License-Identifier: GPL-3.0-or-later
// What every refusal of a file promises, whatever the file is.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "contact/text.hpp"

namespace ehd::verification::promises {

/// "nan" and "inf" as words outside quotation marks.
inline bool names_no_number(std::string_view text) {
  std::string word;
  bool quoted = false;
  for (const char c : std::string(text) + " ") {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      word += c;
      continue;
    }
    if (!quoted && (word == "nan" || word == "inf")) return true;
    word.clear();
    if (c == '"') quoted = !quoted;
  }
  return false;
}

/// What is wrong with a refusal, "" where nothing is: one printable line, "FILE: ..." or "FILE:LINE: ..." with a line
/// that exists, ending in what is allowed or required.
inline std::string broken_by_refusal(const std::string& message, const std::string& file, std::string_view bytes) {
  constexpr std::size_t longest_message = 1000;  // a screen of it; the reader shortens what it quotes
  if (one_line(message) != message) return "the refusal is not one line of printable text: " + one_line(message);
  if (message.size() > longest_message) return "the refusal is longer than a screen: " + message;
  if (!message.starts_with(file + ":")) return "the refusal does not begin with its file: " + message;
  std::string_view rest = std::string_view(message).substr(file.size() + 1);
  if (!rest.starts_with(' ')) {
    long line = 0;
    std::size_t digits = 0;
    for (; digits < rest.size() && digits < 7 && rest[digits] >= '0' && rest[digits] <= '9'; ++digits)
      line = 10 * line + (rest[digits] - '0');
    if (digits == 0 || !rest.substr(digits).starts_with(": ")) return "neither FILE: nor FILE:LINE: " + message;
    if (line < 1 || line > 1 + std::count(bytes.begin(), bytes.end(), '\n')) return "no such line: " + message;
    rest = rest.substr(digits + 1);
  }
  const auto allowed = std::max(rest.rfind("; allowed "), rest.rfind("; required "));
  const auto last = rest.rfind("; ");
  if (last == std::string_view::npos) return "the refusal does not say what is allowed: " + message;
  // A statement's error words its remedy freely ("; state both alpha_per_Pa and z").
  if (names_no_number(rest.substr(allowed == std::string_view::npos ? last : std::min(allowed, last))))
    return "what is allowed is no number: " + message;
  return "";
}

}  // namespace ehd::verification::promises
