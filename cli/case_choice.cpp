// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/case_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/find_case.hpp"
#include "io/substitution.hpp"
#include "workflow/case.hpp"

namespace ehd::cli {

namespace {

std::string without_spaces_around(const std::string& text) {
  const auto begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// KEY and VALUE as they were typed, without spaces around them. Throws UsageError where one of them is missing.
std::pair<std::string, std::string> key_and_value(const std::string& setting) {
  const auto equals = setting.find('=');
  std::string key = without_spaces_around(setting.substr(0, equals));
  if (key.empty() || equals == std::string::npos)
    throw UsageError(fmt::format("--set {}: has no {}; allowed is KEY=VALUE, like bearing.clearance_m=5e-6", setting,
                                 key.empty() ? "key" : "value"));
  return {std::move(key), without_spaces_around(setting.substr(equals + 1))};
}

/// Throws UsageError for a text that is not KEY=VALUE, and for a key that is there twice.
std::vector<Substitution> substitutions_of(const std::vector<std::string>& settings) {
  std::vector<Substitution> made;
  for (const std::string& setting : settings) {
    const auto [key, value] = key_and_value(setting);
    const auto is_it = [&key = key](const Substitution& other) { return other.key == key; };
    if (const auto before = std::find_if(made.begin(), made.end(), is_it); before != made.end())
      throw UsageError(
          fmt::format("--set {}: sets {} again, after {}; allowed is each key once", setting, key, before->option));
    made.push_back({.key = key, .value = toml_value(value), .option = "--set " + setting});
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
    // The title says what the file states, which may be what is changed.
    const char* before = " (changed: ";
    for (const std::string& setting : settings) {  // as it was typed: 1e4, not 10000.0
      const auto [key, value] = key_and_value(setting);
      one.title += fmt::format("{}{} = {}", std::exchange(before, ", "), key, one_line(value));
    }
    if (!settings.empty()) one.title += ")";
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
