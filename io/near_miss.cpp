// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/near_miss.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace ehd {

namespace {

constexpr std::size_t most_differences = 2;
constexpr std::size_t shortest_part = 4;      // from the middle of a name
constexpr std::size_t longest_compared = 60;  // no name is longer; a longer word would cost time for nothing

/// Characters to insert, remove or replace until one text is the other.
std::size_t distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

/// The shortest name where `has_part` holds; empty where there is none.
template <class Predicate>
std::string shortest(const std::vector<std::string>& names, const Predicate& has_part) {
  std::string found;
  for (const std::string& name : names)
    if (has_part(name) && (found.empty() || name.size() < found.size())) found = name;
  return found;
}

}  // namespace

std::string near_miss(const std::string& word, const std::vector<std::string>& names) {
  if (word.size() > longest_compared) return "";
  std::string nearest;
  std::size_t least = std::min(most_differences + 1, (word.size() + 1) / 2);
  for (const std::string& name : names) {
    const std::size_t apart = distance(word, name);
    if (apart < least) std::tie(least, nearest) = std::pair(apart, name);
  }
  if (!nearest.empty()) return nearest;
  nearest = shortest(names, [&](const std::string& name) { return name.starts_with(word); });
  if (!nearest.empty() || word.size() < shortest_part) return nearest;
  return shortest(names, [&](const std::string& name) { return name.find(word) != std::string::npos; });
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string meant = near_miss(word, names);
  return meant.empty() ? "" : "did you mean " + meant + "? ";
}

}  // namespace ehd
