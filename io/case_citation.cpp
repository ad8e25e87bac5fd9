// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_citation.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <system_error>
#include <variant>

#include "contact/text.hpp"
#include "io/find_case.hpp"
#include "io/problem_json.hpp"
#include "io/provenance.hpp"
#include "io/result_head.hpp"
#include "io/version.hpp"

namespace ehd {

namespace {

/// Plain text inside braces of BibTeX.
std::string tex(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '%':
      case '&':
      case '#':
      case '_':
      case '$':
      case '{':
      case '}': escaped += std::string("\\") + c; break;
      case '^': escaped += "\\textasciicircum{}"; break;
      case '~': escaped += "\\textasciitilde{}"; break;
      case '\\': escaped += "\\textbackslash{}"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

/// "film.minimum = 0.0741427 (hertz, relative uncertainty 6.7e-13), ..."
std::string digits_of(const Case& any) {
  std::string text;
  for (const Expectation& one : any.expectations) {
    if (one.waiting) continue;
    if (!text.empty()) text += ", ";
    // Half the last digit of a fit says nothing about how far the fit is from the solution.
    const bool fit = one.kind == ExpectationKind::fit;
    text += fmt::format("{}{} = {} ({}, {}{})", one.quantity, one.law.empty() ? "" : " by " + one.law, one.digits,
                        to_string(one.scaling), to_string(one.kind),
                        fit ? "" : ", relative uncertainty " + plain(one.uncertainty, 2));
  }
  return text.empty() ? "waits for digits that nobody here has read" : text;
}

std::string entry_of(const Case& any) {
  const std::string id = fmt::format("{}@{}", any.id, any.version);
  const Json head = result_head("");
  constexpr std::size_t shown_of_commit = 12;
  std::string entry = fmt::format("@misc{{ehd-{}-v{},\n", any.id, any.version);
  const auto field = [&](const std::string& name, const std::string& text) {
    entry += fmt::format("  {}{} = {{{}}},\n", name, std::string(12 - name.size(), ' '), text);
  };
  field("author", "{The ehd authors}");
  field("title", fmt::format("{{Benchmark case {}: {}}}", tex(id), tex(any.title)));
  if (const std::string year = commit_year(); !year.empty()) field("year", year);
  const bool in_atlas = any.file.parent_path().filename() == "atlas";
  field("howpublished", fmt::format("ehd, version {}, {}, cases/{}{}.toml", head["provenance"].value("version", ""),
                                    commit_words(shown_of_commit), in_atlas ? "atlas/" : "", tex(any.id)));
  field("note", fmt::format("{}; source of the case: {}", tex(digits_of(any)), tex(any.source)));
  return entry + "}\n";
}

Json expectation_json(const Expectation& one) {
  Json json{{"quantity", one.quantity}};
  if (!one.law.empty()) json["law"] = one.law;
  if (one.waiting) {
    json["status"] = "waiting";
    return json;
  }
  json["digits"] = one.digits;
  put(json, "value", one.value);
  json["scaling"] = to_string(one.scaling);
  put(json, "uncertainty", one.uncertainty);
  json["kind"] = to_string(one.kind);
  return json;
}

}  // namespace

std::string bibtex_of_cases(const std::vector<Case>& cases, const Bibliography& bibliography) {
  std::string text;
  std::set<std::string> keys{"own"};  // this software
  for (const Case& any : cases) {
    text += entry_of(any) + "\n";
    keys.insert(bibliography_key(any.source));
  }
  std::string sources;
  for (const std::string& key : keys)
    if (const auto entry = bibliography.find(key); entry != bibliography.end())
      sources += (sources.empty() ? "" : "\n") + entry->second.text;
  return text + sources;
}

bool is_benchmark_case(const Case& any) {
  std::error_code no_folder, no_cases;
  const auto folder = std::filesystem::canonical(std::filesystem::absolute(any.file).parent_path(), no_folder);
  const auto cases = std::filesystem::canonical(cases_folder(), no_cases);
  return !no_folder && !no_cases && (folder == cases || folder.parent_path() == cases);
}

std::string bibtex_of_sources(const Bibliography& bibliography) {
  std::string text;
  for (const auto& [key, entry] : bibliography) text += (text.empty() ? "" : "\n") + entry.text;
  return text;
}

Json cases_json(const std::vector<Case>& cases) {
  Json json = result_head("ehd-cases-1");
  json["cases"] = Json::array();
  for (const Case& any : cases) {
    Json one{{"case", any.id}, {"version", any.version}, {"title", any.title}, {"source", any.source}};
    if (std::holds_alternative<ContactCase>(any.body)) one["problem"] = problem_json(any);
    if (const auto* bearing = std::get_if<BearingCase>(&any.body)) one["inputs"] = bearing_inputs_json(*bearing);
    one["expect"] = Json::array();
    for (const Expectation& expectation : any.expectations) one["expect"].push_back(expectation_json(expectation));
    json["cases"].push_back(one);
  }
  return json;
}

}  // namespace ehd
