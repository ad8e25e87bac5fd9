// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_text.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "contact/text.hpp"
#include "io/file_text.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

constexpr std::uintmax_t largest_file = 64 * 1024;  // a case has about 1 KiB, a sweep with long lists a few
constexpr std::size_t longest_line = 2000;
constexpr std::size_t longest_quote = 60;  // of a line in a message

FileKind kind_of(TomlFile what) {
  const char* name = "a case file (TOML), or the id of a benchmark case";
  if (what == TomlFile::of_sweep) name = "a sweep file (TOML)";
  if (what == TomlFile::case_in_memory) name = "the text of a case file (TOML)";
  return {.name = name, .most_bytes = largest_file};
}

[[noreturn]] void refuse(const std::filesystem::path& file, int line, const std::string& what) {
  throw CaseError(one_line(fmt::format("{}{}: {}", file.string(), line > 0 ? fmt::format(":{}", line) : "", what)));
}

/// Follows TOML character by character, to tell strings and comments from the rest.
class Lexer {
 public:
  [[nodiscard]] bool in_text() const { return state_ != State::plain; }
  /// A printable ASCII character that changes nothing here.
  [[nodiscard]] bool passes(char c) const {
    if (c < ' ' || c > '~') return false;
    if (state_ == State::string) return c != quote_ && c != '\\';
    return state_ == State::comment || (c != '#' && c != '"' && c != '\'');
  }

  /// Consumes one character at the beginning of `rest`; returns the bytes consumed.
  std::size_t step(std::string_view rest) {
    const char c = rest.front();
    switch (state_) {
      case State::plain:
        if (c == '#') state_ = State::comment;
        if (c == '"' || c == '\'') {
          quote_ = c;
          multiline_ = starts_with_three(rest, c);
          state_ = State::string;
          return multiline_ ? 3 : 1;
        }
        return 1;
      case State::comment:
        if (c == '\n') state_ = State::plain;
        return 1;
      case State::string:
        if (c == '\\' && quote_ == '"' && rest.size() > 1 && rest[1] != '\n') return 2;
        if (c == '\n' && !multiline_) state_ = State::plain;  // unterminated: the parser will say so
        if (c == quote_ && !multiline_) state_ = State::plain;
        if (multiline_ && starts_with_three(rest, quote_)) {
          state_ = State::plain;
          std::size_t quotes = 3;  // up to two quotes may stand before the closing three
          while (quotes < 5 && quotes < rest.size() && rest[quotes] == quote_) ++quotes;
          return quotes;
        }
        return 1;
    }
    return 1;
  }

 private:
  enum class State { plain, comment, string };
  static bool starts_with_three(std::string_view rest, char c) {
    return rest.size() >= 3 && rest[0] == c && rest[1] == c && rest[2] == c;
  }
  State state_ = State::plain;
  char quote_ = '"';
  bool multiline_ = false;
};

/// Whether a line that begins with a bracket goes on with a name, as [table] and [[table]] do. toml++ 3.3.0 does not
/// check this: "[ = 1" ends the program in an assertion.
bool is_header(std::string_view line) {
  std::size_t i = line.starts_with("[[") ? 2 : 1;
  while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
  if (i == line.size()) return false;
  const char c = line[i];
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '"' || c == '\'';
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.emplace_back(line);
    begin = end + 1;
  }
  return lines;
}

std::string read_case_text(const std::filesystem::path& file, TomlFile what) {
  return checked_case_text(text_of_file(file, kind_of(what)), file, what);
}

std::string text_of_standard_input() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) == 0 && S_ISDIR(status.st_mode))  // reading it looks like an empty file
    refuse(standard_input, 0, fmt::format("is a directory; allowed is {}", kind_of(TomlFile::of_case).name));
  std::string bytes(largest_file + 1, '\0');
  std::cin.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::cin.gcount()));
  return bytes;
}

bool is_id(std::string_view text) {
  const auto begins = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  const auto belongs = [&](char c) { return begins(c) || c == '.' || c == '-' || c == '_'; };
  return !text.empty() && begins(text.front()) && std::all_of(text.begin(), text.end(), belongs);
}

std::string id_of_file(const std::filesystem::path& file) {
  const std::string id = file.stem().string();
  if (is_id(id)) return id;
  refuse(file, 0, fmt::format("the file's name without .toml is no id; allowed is {}", allowed_in_id));
}

std::string checked_case_text(std::string text, const std::filesystem::path& file, TomlFile what) {
  const auto allowed = [what] { return fmt::format("; allowed is {}", kind_of(what).name); };
  // Checked first: the other faults of an image or a program do not matter.
  if (text.find('\0') != std::string::npos) refuse(file, 0, "is binary" + allowed());
  if (text.size() > largest_file)
    refuse(file, 0, fmt::format("is larger than {} KiB", largest_file / 1024) + allowed());
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) refuse(file, 0, "is empty" + allowed());

  int line = 1;
  std::size_t line_begin = 0;
  bool blank_so_far = true;  // on this line
  Lexer lexer;
  for (std::size_t i = 0; i < text.size();) {
    if (!blank_so_far && i - line_begin <= longest_line && lexer.passes(text[i])) {  // most of a file
      ++i;
      continue;
    }
    const std::string_view rest = std::string_view(text).substr(i);
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool line_end = text[i] == '\n' || (text[i] == '\r' && rest.starts_with("\r\n"));
    if ((byte < 0x20 && text[i] != '\t' && !line_end) || byte == 0x7F)
      refuse(file, line,
             "holds the control character " + one_line(rest.substr(0, 1)) + "; allowed is plain text (TOML)");
    const std::size_t length = byte < 0x80 ? 1 : utf8_length(rest);
    if (length == 0)
      refuse(file, line,
             "holds the byte " + one_line(rest.substr(0, 1)) + ", which is not UTF-8; allowed is UTF-8 text");
    if (length > 1 && !lexer.in_text())
      refuse(file, line,
             "holds '" + one_line(rest.substr(0, length)) + "' outside a string or comment; allowed is ASCII there");
    if (i - line_begin > longest_line)
      refuse(file, line, fmt::format("is a line of more than {} bytes; allowed are shorter lines", longest_line));
    const bool begins = blank_so_far && text[i] != ' ' && text[i] != '\t' && !line_end;
    if (begins && text[i] == '[' && !lexer.in_text()) {
      const std::string_view rest_of_line = rest.substr(0, rest.find_first_of("\r\n"));
      if (!is_header(rest_of_line))
        refuse(file, line, shortened(rest_of_line, longest_quote) + ": is no table; allowed is [name] or [[name]]");
    }
    if (begins) blank_so_far = false;
    // A multi-byte character is one step; an escape or a run of quotes may be several bytes, all ASCII but the one
    // after a backslash, which is left for the next round.
    std::size_t step = length;
    if (length == 1) {
      step = lexer.step(rest);
      if (rest.front() == '\\' && step == 2 && static_cast<unsigned char>(rest[1]) >= 0x80) step = 1;
    }
    if (text[i] == '\n') {
      ++line;
      line_begin = i + 1;
      blank_so_far = true;
    }
    i += step;
  }
  return text;
}

}  // namespace ehd
