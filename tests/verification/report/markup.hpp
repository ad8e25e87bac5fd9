// SPDX-License-Identifier: GPL-3.0-or-later
// Enough of XML and HTML to see that elements close in order.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

namespace ehd::verification::test {

[[nodiscard]] inline std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++count;
  return count;
}

/// Empty where every element ends, in order, and no attribute is cut short; otherwise what is wrong.
[[nodiscard]] inline std::string unbalanced(const std::string& text) {
  const std::set<std::string> empty{"meta", "link", "br", "wbr", "input"};
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    if (text.compare(at, 2, "<?") == 0 || text.compare(at, 2, "<!") == 0) {
      at = text.find('>', at);
      continue;
    }
    std::size_t end = at + 1;
    for (bool quoted = false; end < text.size() && (quoted || text[end] != '>'); ++end) {
      if (text[end] == '"') quoted = !quoted;
      if (quoted && text[end] == '<') return "an attribute with < in it near " + text.substr(at, 60);
    }
    if (end >= text.size()) return "an element without end: " + text.substr(at, 60);
    const bool closes = text[at + 1] == '/', alone = text[end - 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = text.substr(begin, text.find_first_of(" />\n", begin) - begin);
    at = end + 1;
    if (closes) {
      if (open.empty() || open.back() != name)
        return fmt::format("</{}> closes {}", name, open.empty() ? "nothing" : "<" + open.back() + ">");
      open.pop_back();
    } else if (!alone && !empty.contains(name)) {
      open.push_back(name);
      if (name == "script" || name == "style") {  // no markup inside
        at = text.find("</" + name, at);
        if (at == std::string::npos) return "<" + name + "> does not end";
      }
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

}  // namespace ehd::verification::test
