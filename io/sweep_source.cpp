// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_text.hpp"
#include "io/faults.hpp"
#include "io/near_miss.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

constexpr std::size_t longest_key = 60;  // of an unknown key in a message

}  // namespace

std::optional<double> number_of(const toml::node& node) {
  if (const auto* whole = decimal_integer(node)) return static_cast<double>(whole->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  return std::nullopt;
}

SweepSource::SweepSource(const std::filesystem::path& file)
    : file_(file),
      text_(read_case_text(file, TomlFile::of_sweep)),
      lines_(lines_of(text_)),
      root_(parse_toml(text_, file)) {}

void SweepSource::fail(int line, const std::string& subject, const std::string& message) const {
  throw CaseError(
      one_line(fmt::format("{}:{}: {}{}", file_.string(), line, subject.empty() ? "" : subject + ": ", message)));
}

void SweepSource::fail(const std::string& key, const toml::node& node, const std::string& message) const {
  const std::string value = written(node);
  fail(line_of(node), key + (node.is_table() && value.empty() ? "" : " = " + value), message);
}

void SweepSource::fail_type(const std::string& key, const toml::node& node, const std::string& allowed) const {
  fail(key, node, fmt::format("is {}; allowed is {}", type_of(node), allowed));
}

void SweepSource::missing(const std::string& key, const std::string& required) const {
  fail(1, key, "is missing; required is " + required);
}

void SweepSource::require_known(const toml::table& table, const std::string& of,
                                const std::vector<std::string>& allowed) const {
  Faults faults;
  for (const auto& [key, node] : unknown_keys(table, allowed))
    (void)faults.none_in([&, &key = key, &node = node] {
      fail(shortened(key, longest_key), *node,
           fmt::format("is unknown{}; {}allowed is {}", of, did_you_mean(key, allowed), list(allowed)));
    });
  faults.refuse();
}

std::string SweepSource::text(const std::string& key, const toml::node& node, const std::string& allowed) const {
  const auto* value = node.as_string();
  if (!value) fail_type(key, node, allowed);
  return value->get();
}

std::string SweepSource::choice(const std::string& key, const toml::node& node,
                                const std::vector<std::string>& allowed) const {
  std::string chosen = text(key, node, quoted_list(allowed));
  if (std::find(allowed.begin(), allowed.end(), chosen) == allowed.end())
    fail(key, node, is_unknown(chosen, quoted_list(allowed)));
  return chosen;
}

}  // namespace ehd
