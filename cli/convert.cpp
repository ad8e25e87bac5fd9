// SPDX-License-Identifier: GPL-3.0-or-later
// ehd convert: one contact in all scalings. Nothing is solved.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/scalings.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/faults.hpp"
#include "io/json.hpp"
#include "io/near_miss.hpp"
#include "io/result_head.hpp"
#include "io/tables.hpp"

namespace ehd::cli {

namespace {

struct ConvertOptions {
  std::vector<std::string> numbers;
  std::optional<std::string> json;
};

const char* const convert_examples = R"(
Examples:
  ehd convert M=20 L=10                                  Moes to Hertz scaling
  ehd convert M=20 L=0                                   the same for an isoviscous fluid, alpha = 0
  ehd convert W=3e-5 U_mean=1e-11 G=5000                 Dowson and Hamrock to Moes
  ehd convert lambda=1.51425 alpha_p_H=2.832             Kostreva to Moes
  ehd convert load_N_per_m=1e5 reduced_radius_m=0.01 reduced_modulus_Pa=2.2e11 \
              speed_sum_m_per_s=3 viscosity_Pa_s=0.02 alpha_per_Pa=2e-8
  ehd convert M=20 L=10 reduced_radius_m=0.01 reduced_modulus_Pa=2.2e11 alpha_per_Pa=2e-8

Give the numbers that you know, each once. The table has all that follows from them, and names what stays open. A number
that the ones before it already fix is refused.)";

/// "did you mean NAME (what it is)? ", without the brackets where the name was only mistyped. A key of a case is
/// described in the words of the case's keys.
std::string meant_by(const std::string& given, const std::vector<std::string>& names) {
  const std::string name = near_miss(given, names);
  if (name.empty() || is_mistyped(given, name)) return did_you_mean(given, names);
  std::string_view meaning;
  for (const ScaledNumber& row : scaled_numbers())
    if (row.name == name) meaning = row.meaning;
  for (const CaseKey& key : find_case_table("conditions")->keys)
    if (key.name == name) meaning = key.what();
  return fmt::format("did you mean {} ({})? ", name, meaning);
}

std::vector<GivenNumber> numbers_of(const std::vector<std::string>& texts) {
  std::vector<std::string> names;
  for (const ScaledNumber& row : scaled_numbers()) names.emplace_back(row.name);
  std::vector<GivenNumber> given;
  const auto read = [&](const std::string& text) {
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UsageError(fmt::format("convert: {}: is unknown; {}allowed is NAME=NUMBER with a name out of {}", name,
                                   meant_by(name, names), list(names)));
    if (equals == std::string::npos)
      throw UsageError(fmt::format("convert: {}: has no value; allowed is {}=NUMBER", name, name));
    const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    const Interval allowed{
        .low = 0, .high = std::numeric_limits<double>::max(), .open_low = !scaled_numbers()[row].may_vanish()};
    given.push_back({.name = name, .value = parse_number(name, text.substr(equals + 1), allowed)});
  };
  Faults faults;
  for (const std::string& text : texts) {
    try {
      read(text);
    } catch (const UsageError& error) {
      faults.add("ehd: " + std::string(error.what()));
    }
  }
  faults.refuse();
  return given;
}

int convert(const ConvertOptions& options) {
  const auto values = in_all_scalings(numbers_of(options.numbers));
  JsonTarget target(options.json);
  Json json = result_head("ehd-convert-1");
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> open;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ScaledNumber& row = scaled_numbers()[i];
    put(json, std::string(row.name), values[i]);
    if (values[i])
      rows.push_back({std::string(row.name) + (row.unit.empty() ? "" : fmt::format(" [{}]", row.unit)),
                      plain(*values[i], 8), std::string(row.meaning)});
    else
      open.emplace_back(row.name);
  }
  target.commit(json);
  if (target.to_standard_output()) return success;
  constexpr std::size_t all_columns = 3;
  std::string text = aligned(rows, all_columns, "");
  if (!open.empty()) text += wrapped("not fixed by these numbers: " + list(open), "  ");
  print(text);
  return success;
}

}  // namespace

void describe_convert(Command& command) {
  auto options = std::make_shared<ConvertOptions>();
  command.summary("One contact in all scalings: SI, Moes, Dowson and Hamrock, Kostreva");
  command.examples(convert_examples);
  command.list("NUMBERS", options->numbers, "NAME=NUMBER, by the names that cases and results have").required();
  command.text("--json", options->json, "the numbers as JSON into a file, or - for standard output");
  command.runs([options] { return convert(*options); });
}

}  // namespace ehd::cli
