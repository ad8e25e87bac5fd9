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
    made.push_back({.key = key, .value = toml_value(setting.substr(equals + 1)), .option = "--set " + setting});
  }
  return made;
}

/// Whether the file without what is set would be read. Standard input is not there a second time.
bool is_sound_alone(const std::string& name) {
  if (name == "-") return true;
  try {
    (void)read_named_case(name, {});
    return true;
  } catch (const CaseError&) {
    return false;
  }
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
    if (settings.empty() || !is_sound_alone(name)) throw;
    std::vector<std::string> lines{error.what()};
    lines.insert(lines.end(), error.more().begin(), error.more().end());
    for (std::string& line : lines)  // a key of the file that contradicts what is set, or one that is now missing
      if (!line.starts_with("ehd: --set "))
        line += one_line(fmt::format(" (with --set {})", fmt::join(settings, " --set ")));
    throw CaseError(lines);
  }
}

void CaseChanges::put_into(Json& object) const {
  for (const Substitution& substitution : substitutions_of(settings))
    std::visit([&](const auto& value) { object["set"][substitution.key] = value; }, substitution.value);
}

}  // namespace ehd::cli
