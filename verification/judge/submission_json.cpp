// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/file_text.hpp"
#include "io/json.hpp"
#include "io/near_miss.hpp"
#include "verification/judge/submission.hpp"
#include "verification/report/document.hpp"

namespace ehd::judging {

namespace {

using report::View;

constexpr FileKind json_kind{.name = "a submission (JSON with schema ehd-submission-1, or .csv)",
                             .most_bytes = 16 << 20};
constexpr std::size_t longest_text = 200;  // bytes of a name, a version, an address
constexpr double longest_wall_s = 1e9;

/// Refuses a key that is none of the known ones and, `or_quantity`, no quantity's name. Throws CaseError.
void require_known(const View& object, const std::vector<std::string>& known, bool or_quantity = false) {
  for (const auto& [key, value] : object.members()) {
    if (!value.exists()) throw refusal(value.path(), "is null; allowed is a value, or no key");
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    if (or_quantity && quantity_from(key)) continue;
    std::vector<std::string> names = known;
    if (or_quantity)
      for (const QuantityRow& row : quantity_table()) names.emplace_back(row.name);
    throw refusal(object.path(), fmt::format("{}: is unknown; {}allowed is {}{}", shortened(key, longest_text),
                                             did_you_mean(key, names), list(known),
                                             or_quantity ? ", and quantities such as film.minimum" : ""));
  }
}

/// One line without control characters: pages and terminals print it.
std::string line_in(const View& object, const std::string& key, bool required = false) {
  const View entry = object[key];
  if (required && !entry.exists()) throw refusal(object.path(), key + ": is missing; required is a text");
  const std::string text = entry.text();
  if (one_line(text) != text) throw refusal(entry.path(), "has a control character; allowed is one line of UTF-8");
  if (text.size() > longest_text) throw refusal(entry.path(), "is too long; allowed is up to 200 bytes");
  if (required && text.empty()) throw refusal(entry.path(), "is empty; required is a text");
  return text;
}

int version_in(const View& result) {
  const auto version = result.number("version");
  if (!version) throw refusal(result.path(), "version: is missing; required is the version of the case");
  if (!(*version >= 1 && *version <= std::numeric_limits<int>::max() && *version == std::floor(*version)))
    throw refusal(result.path(), "version = " + plain(*version) + ": is no version; allowed is an integer above 0");
  return static_cast<int>(*version);
}

/// A file beside the submission or below it, and nothing else: a submission may come from anybody.
std::optional<std::filesystem::path> profile_in(const View& result, const std::filesystem::path& submission) {
  const std::string name = line_in(result, "profile");
  if (!result.has("profile")) return std::nullopt;
  const std::filesystem::path path(name);
  bool inside = !name.empty() && path.is_relative();
  for (const auto& part : path) inside = inside && part != "..";
  if (!inside)
    throw refusal(result.path(), "profile = " + name + ": is elsewhere; allowed is a file beside the submission");
  return submission.parent_path() / path;
}

SubmittedResult result_from(const View& entry, const std::filesystem::path& file) {
  require_known(entry, {"case", "version", "scaling", "stated_error", "wall_s", "profile"}, true);
  SubmittedResult result{.case_id = line_in(entry, "case", true), .numbers = {}, .place = entry.path()};
  require_case_id(result.place, result.case_id);
  result.version = version_in(entry);
  const Scaling scaling = submitted_scaling(result.place, line_in(entry, "scaling", true));
  const auto stated = entry.number("stated_error");
  for (const auto& [key, value] : entry.members()) {
    if (!quantity_from(key)) continue;
    SubmittedNumber number{
        .quantity = submitted_quantity(result.place, key), .value = *value.number(), .scaling = scaling};
    if (is_film(number.quantity)) number.stated_error = stated;
    require_number(result.place, number);
    result.numbers.push_back(number);
  }
  result.wall_s = entry.number("wall_s");
  if (result.wall_s && !(*result.wall_s >= 0 && *result.wall_s <= longest_wall_s))
    throw refusal(result.place, "wall_s = " + plain(*result.wall_s) + ": is out of range; allowed is 0 to 1e9");
  result.profile = profile_in(entry, file);
  if (result.numbers.empty() && !result.profile)
    throw refusal(result.place, "has no quantity; required is one such as film.minimum, or a profile");
  return result;
}

Submission submission_from(const View& root, const std::filesystem::path& file) {
  const std::vector<std::string> keys{"schema", "solver", "hardware", "results"};
  if (!root.has("schema")) require_known(root, keys);  // it may be mistyped
  const std::string schema = line_in(root, "schema", true);
  if (schema != submission_schema)
    throw refusal(root.path(),
                  fmt::format("schema = {}: {}", schema, is_unknown(schema, std::string(submission_schema))));
  require_known(root, keys);
  const View solver = root["solver"];
  if (!solver.exists()) throw refusal(root.path(), "solver: is missing; required is an object with a name");
  require_known(solver, {"name", "version", "url"});
  Submission made{.file = file,
                  .name = line_in(solver, "name", true),
                  .version = line_in(solver, "version"),
                  .url = line_in(solver, "url"),
                  .hardware = line_in(root, "hardware"),
                  .results = {}};
  const auto results = root.list("results");
  if (results.empty()) throw refusal(root.path(), "results: is missing or empty; required is a list of results");
  if (results.size() > most_results)
    throw refusal(root.path(), "results: has more than 10000 entries; allowed is one a case");
  std::set<std::string> seen;
  for (const View& entry : results) {
    made.results.push_back(result_from(entry, file));
    if (!seen.insert(made.results.back().case_id).second)
      throw refusal(entry.path(), "case = " + made.results.back().case_id + ": is there twice; allowed is once");
  }
  return made;
}

}  // namespace

Submission read_submission_json(const std::filesystem::path& file) {
  try {
    const std::string text = submitted_text(file, json_kind);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw JsonError("is no JSON: the file is empty");
    const Json json = json_from(text);
    return submission_from(View(json, file.string()), file);
  } catch (const JsonError& wrong) {
    throw refusal(file.string(), std::string(wrong.what()) + "; required is " + std::string(json_kind.name));
  } catch (const report::ReportError& wrong) {
    throw CaseError(one_line(wrong.what()));
  }
}

}  // namespace ehd::judging
