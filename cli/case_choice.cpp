// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/case_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/find_case.hpp"
#include "io/substitution.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

/// Throws UsageError for a text without '=', and for a key that is there twice.
std::vector<Substitution> substitutions_of(const std::vector<std::string>& settings) {
  std::vector<Substitution> made;
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos)
      throw option_error("--set", setting, "has no value; allowed is KEY=VALUE, like bearing.clearance_m=5e-6");
    const std::string key = setting.substr(0, equals);
    if (std::any_of(made.begin(), made.end(), [&](const Substitution& other) { return other.key == key; }))
      throw option_error("--set", setting, "sets " + key + " again; allowed is each key once");
    made.push_back({.key = key, .value = toml_value(setting.substr(equals + 1))});
  }
  return made;
}

/// A line "FILE: key = value: message" or "key: message" about what --set gave: the mistake stands on the command line.
std::string naming_option(const std::string& line, const std::vector<Substitution>& substitutions,
                          const std::vector<std::string>& settings) {
  for (std::size_t i = 0; i < substitutions.size(); ++i) {
    const Substitution& one = substitutions[i];
    const std::string value = fmt::format(": {} = {}: ", one.key.substr(one.key.rfind('.') + 1), toml_text(one.value));
    const auto at = line.find(value);
    const bool of_key = line.starts_with(one.key + ": ");
    if (!of_key && at == std::string::npos) continue;
    const std::size_t subject = of_key ? one.key.size() + 2 : at + value.size();
    return fmt::format("ehd: --set {}: {}", one_line(settings[i]), line.substr(subject));
  }
  return line;
}

}  // namespace

void CaseChanges::add_to(Command& command) {
  command
      .list("--set", settings,
            "another value for one key of the case (repeatable): bearing.clearance_m=5e-6; ehd sweep takes several "
            "values")
      .called("KEY=VALUE");
}

Case CaseChanges::read(const std::string& name) const {
  const std::vector<Substitution> substitutions = substitutions_of(settings);
  try {
    Case one = read_named_case(name, substitutions);
    for (const std::string& setting : settings) {  // as it was typed: 1e4, not 10000.0
      const auto equals = setting.find('=');
      one.title += fmt::format(", {} = {}", setting.substr(0, equals), one_line(setting.substr(equals + 1)));
    }
    return one;
  } catch (const CaseError& error) {
    std::vector<std::string> lines{naming_option(error.what(), substitutions, settings)};
    for (const std::string& line : error.more()) lines.push_back(naming_option(line, substitutions, settings));
    throw CaseError(lines);
  }
}

void CaseChanges::put_into(Json& object) const {
  for (const Substitution& substitution : substitutions_of(settings))
    std::visit([&](const auto& value) { object["set"][substitution.key] = value; }, substitution.value);
}

}  // namespace ehd::cli
