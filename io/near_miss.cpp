// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/near_miss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace ehd {

std::string in_small_letters(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

namespace {

constexpr std::size_t most_differences = 2;
constexpr std::size_t shortest_part = 4;      // from the middle of a name, or one of its words: units are shorter
constexpr std::size_t shortest_word = 2;      // between "_", the only one of a key: vg for iso_vg
constexpr std::size_t shortest_start = 3;     // of a word: dia for diameter
constexpr std::size_t longest_compared = 60;  // no name is longer; a longer word would cost time for nothing

/// Characters to insert, remove or replace, and neighbours to swap, until one text is the other.
std::size_t distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> two_before, before(to.size() + 1), row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    two_before = std::exchange(before, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      row[j + 1] = std::min({row[j] + 1, before[j + 1] + 1, before[j] + (from[i] == to[j] ? 0 : 1)});
      if (i > 0 && j > 0 && from[i] == to[j - 1] && from[i - 1] == to[j])
        row[j + 1] = std::min(row[j + 1], two_before[j - 1] + 1);
    }
  }
  return row.back();
}

/// The shortest name where `has_part` holds; empty where there is none.
template <class Predicate>
std::string shortest_where(const std::vector<std::string>& names, const Predicate& has_part) {
  std::string found;
  for (const std::string& name : names)
    if (has_part(name) && (found.empty() || name.size() < found.size())) found = name;
  return found;
}

/// "load_N_per_m": load, n, per, m.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words{""};
  for (const char c : in_small_letters(name)) {
    if (c == '_')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// How many words of the given one the name has too, some as their beginning; 0 where only units are common.
std::size_t common_words(const std::vector<std::string>& given, const std::vector<std::string>& name) {
  std::size_t common = 0;
  bool more_than_units = false;
  for (const std::string& word : given) {
    const bool there = std::any_of(name.begin(), name.end(), [&](const std::string& other) {
      return other == word || (word.size() >= shortest_start && other.starts_with(word));
    });
    if (!there) continue;
    ++common;
    more_than_units = more_than_units || word.size() >= shortest_part;
  }
  return more_than_units ? common : 0;
}

/// The shortest of the names that have most words of the given one; empty where none has any.
std::string of_most_common_words(const std::string& given, const std::vector<std::string>& names) {
  std::string found;
  std::size_t most = 0;
  for (const std::string& name : names) {
    const std::size_t common = common_words(words_of(given), words_of(name));
    if (common > most || (common == most && most > 0 && name.size() < found.size()))
      std::tie(most, found) = std::pair(common, name);
  }
  return found;
}

/// The only name that has a short word between its "_": iso_vg for vg. Empty where none or several have it.
std::string only_with(const std::string& short_word, const std::vector<std::string>& names) {
  std::string found;
  for (const std::string& name : names) {
    const std::vector<std::string> words = words_of(name);
    if (std::find(words.begin(), words.end(), in_small_letters(short_word)) == words.end()) continue;
    if (!found.empty()) return "";
    found = name;
  }
  return found;
}

/// "5" or "0e5" behind a comma: the rest of a number.
bool ends_number(std::string_view text) {
  const auto digits = text.find_first_not_of("0123456789");
  if (text.empty() || digits == 0) return false;
  if (digits == std::string::npos) return true;
  if (text[digits] != 'e' && text[digits] != 'E') return false;
  std::string_view exponent = text.substr(digits + 1);
  if (exponent.starts_with('-') || exponent.starts_with('+')) exponent.remove_prefix(1);
  return !exponent.empty() && exponent.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::string near_miss(const std::string& typed, const std::vector<std::string>& names) {
  if (typed.empty() || typed.size() > longest_compared) return "";
  const std::string word = in_small_letters(typed);
  std::string nearest;
  std::size_t least = most_differences + 1;
  for (const std::string& name : names) {
    const std::size_t apart = distance(word, in_small_letters(name));
    const std::size_t letters = apart == 1 ? std::max(word.size(), name.size()) : word.size();
    if (apart < least && 2 * apart < letters) std::tie(least, nearest) = std::pair(apart, name);
  }
  const auto at = [&word](const std::string& name) { return in_small_letters(name).find(word); };
  const std::string begun = shortest_where(names, [&at](const std::string& name) { return at(name) == 0; });
  const bool is_start = !begun.empty() && word.size() >= shortest_start;  // --tol: --tolerance, and not --L
  if (!nearest.empty() && !(is_start && least == most_differences)) return nearest;
  if (!begun.empty()) return begun;
  if (word.size() < shortest_part) return word.size() >= shortest_word ? only_with(word, names) : "";
  nearest = shortest_where(names, [&at](const std::string& name) { return at(name) != std::string::npos; });
  return nearest.empty() ? of_most_common_words(word, names) : nearest;
}

bool is_mistyped(const std::string& word, const std::string& name) {
  return word.size() <= longest_compared &&
         distance(in_small_letters(word), in_small_letters(name)) <= most_differences;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string meant = near_miss(word, names);
  return meant.empty() ? "" : "did you mean " + meant + "? ";
}

std::string is_unknown(const std::string& word, const std::string& allowed) {
  std::vector<std::string> items, bare;
  for (std::size_t begin = 0; begin < allowed.size();) {
    const std::size_t end = std::min(allowed.find(", ", begin), allowed.size());
    items.push_back(allowed.substr(begin, end - begin));
    bare.push_back(items.back());
    std::erase(bare.back(), '"');
    begin = end + 2;
  }
  const auto at = std::find(bare.begin(), bare.end(), near_miss(word, bare));
  const std::string meant =
      at == bare.end() ? "" : fmt::format("did you mean {}? ", items[static_cast<std::size_t>(at - bare.begin())]);
  return fmt::format("is unknown; {}allowed is {}", meant, allowed);
}

std::string comma_in_number(std::string_view text) {
  const auto comma = text.find_first_not_of("+-.eE_0123456789");
  if (comma == 0 || comma == std::string_view::npos || text[comma] != ',') return "";
  const std::string_view rest = text.substr(comma + 1);
  if (!ends_number(rest)) return "";
  const std::string_view whole = text.substr(0, comma);
  const auto has_exponent = [](std::string_view part) { return part.find_first_of("eE") != std::string_view::npos; };
  if (has_exponent(whole) && has_exponent(rest)) return "";  // two numbers: 1e-2,1e-3
  if (whole.find_first_of(".eE") != std::string_view::npos)
    return "has a comma in a number; allowed is one point, before the exponent";
  return fmt::format("has a comma in a number; allowed is a point, {}.{}", whole, rest);
}

std::string_view without_plus(std::string_view number) {
  return number.substr(number.starts_with('+') && !number.starts_with("+-") ? 1 : 0);
}

bool begins_exponent(std::string_view text) {
  if (text.empty() || std::string_view("eEdD").find(text.front()) == std::string_view::npos) return false;
  return text.size() == 1 || std::string_view("+-0123456789").find(text[1]) != std::string_view::npos;
}

}  // namespace ehd
