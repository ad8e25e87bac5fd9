// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/sweep_file.hpp"

namespace ehd {

namespace {

constexpr double largest_number = 1e300;  // its span to -1e300 is still a number
/// Keys that count things take integers only; 2^53 is where a double may skip one.
constexpr double largest_exact_integer = 9007199254740992.0;

constexpr const char* allowed_values =
    "a list of numbers or texts, or { from = A, to = B, points = N, spacing = \"linear\" or \"logarithmic\" }";

/// One end of a range.
struct End {
  double value = 0;
  bool whole = false;  ///< written as an integer
};

/// { from, to, points, spacing }, each part checked as it is read.
class RangeReader {
 public:
  RangeReader(const SweepSource& source, const std::string& key, const toml::table& range)
      : source_(source), key_(key), range_(range) {}

  [[nodiscard]] std::vector<TomlValue> values() const {
    source_.require_known(range_, " in the range of " + key_, {"from", "to", "points", "spacing"});
    const End from = end("from"), to = end("to");
    const std::size_t count = points(from, to);
    const bool logarithmic = is_logarithmic(from, to);
    std::vector<TomlValue> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(value(from, to, i, count, logarithmic));
    return values;
  }

 private:
  [[nodiscard]] std::string named(const char* name) const { return key_ + ": " + name; }

  [[nodiscard]] const toml::node& required(const char* name, const std::string& what) const {
    const toml::node* node = range_.get(name);
    if (!node) source_.fail(line_of(range_), key_, fmt::format("{} is missing; required is {}", name, what));
    return *node;
  }

  [[nodiscard]] End end(const char* name) const {
    const toml::node& node = required(name, "a number");
    const auto value = number_of(node);
    if (!value) source_.fail_type(named(name), node, "a number");
    if (!(std::abs(*value) <= largest_number))
      source_.fail(named(name), node, "is out of range; allowed is a number up to " + plain(largest_number));
    return {*value, node.is_integer()};
  }

  [[nodiscard]] std::size_t points(const End& from, const End& to) const {
    const std::string allowed = fmt::format("an integer, 1 to {}", most_rows);
    const toml::node& node = required("points", allowed);
    const auto* count = decimal_integer(node);
    if (!count) source_.fail_type(named("points"), node, allowed);
    if (count->get() < 1 || count->get() > static_cast<std::int64_t>(most_rows))
      source_.fail(named("points"), node, "is out of range; allowed is " + allowed);
    const auto points = static_cast<std::size_t>(count->get());
    if (points == 1 && from.value != to.value)
      source_.fail(named("points"), node,
                   "does not reach from one end to the other; allowed is 2 or more where from and to differ");
    return points;
  }

  [[nodiscard]] bool is_logarithmic(const End& from, const End& to) const {
    const std::vector<std::string> spacings{"linear", "logarithmic"};
    const toml::node& node = required("spacing", quoted_list(spacings));
    const bool logarithmic = source_.choice(named("spacing"), node, spacings) == "logarithmic";
    const bool through_zero = from.value == 0 || to.value == 0 || (from.value < 0) != (to.value < 0);
    if (logarithmic && through_zero)
      source_.fail(named("spacing"), node, "leads through zero; allowed is linear, or from and to of one sign");
    return logarithmic;
  }

  /// Both ends are met exactly. Whole numbers between whole ends stay integers.
  [[nodiscard]] static TomlValue value(const End& begin, const End& end, std::size_t i, std::size_t count,
                                       bool logarithmic) {
    const double from = begin.value, to = end.value;
    const double t = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    const double between = logarithmic ? from * std::pow(to / from, t) : from + (to - from) * t;
    const double x = i == 0 ? from : i + 1 == count ? to : between;
    if (begin.whole && end.whole && x == std::round(x) && std::abs(x) <= largest_exact_integer)
      return static_cast<std::int64_t>(x);
    return x;
  }

  const SweepSource& source_;
  const std::string& key_;
  const toml::table& range_;
};

}  // namespace

std::vector<TomlValue> swept_values(const SweepSource& source, const std::string& key, const toml::node& node) {
  if (const toml::table* range = node.as_table()) return RangeReader(source, key, *range).values();
  const toml::array* array = node.as_array();
  if (!array) source.fail_type(key, node, allowed_values);
  if (array->empty()) source.fail(key, node, fmt::format("is empty; allowed is {}", allowed_values));
  std::vector<TomlValue> values;
  for (const toml::node& entry : *array) {
    if (const auto* word = entry.as_string()) {
      values.emplace_back(word->get());
    } else if (const auto* whole = decimal_integer(entry)) {
      values.emplace_back(whole->get());
    } else if (const auto* real = entry.as_floating_point()) {
      values.emplace_back(real->get());
    } else {
      source.fail(key, entry, fmt::format("is {} in a list; allowed is {}", type_of(entry), allowed_values));
    }
  }
  return values;
}

}  // namespace ehd
