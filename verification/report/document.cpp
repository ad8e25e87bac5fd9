// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/document.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "contact/text.hpp"
#include "io/file_text.hpp"
#include "io/json.hpp"
#include "verification/report/schemas.hpp"

namespace ehd::report {

void View::refuse(const char* required) const {
  throw ReportError(fmt::format("{}: is {}; required is {}", path_,
                                json_->is_array()    ? "a list"
                                : json_->is_object() ? "an object"
                                                     : "a " + std::string(json_->type_name()),
                                required));
}

View View::operator[](const std::string& key) const {
  if (!json_) return {};
  if (!json_->is_object()) refuse("an object");
  const auto at = json_->find(key);
  return at == json_->end() ? View{} : View(*at, path_ + ": " + key);
}

std::vector<View> View::list() const {
  std::vector<View> views;
  if (!json_) return views;
  if (!json_->is_array()) refuse("a list");
  for (std::size_t i = 0; i < json_->size(); ++i) views.emplace_back((*json_)[i], fmt::format("{}[{}]", path_, i));
  return views;
}

std::vector<std::pair<std::string, View>> View::members() const {
  std::vector<std::pair<std::string, View>> views;
  if (!json_) return views;
  if (!json_->is_object()) refuse("an object");
  for (const auto& [key, value] : json_->items()) views.emplace_back(key, View(value, path_ + ": " + key));
  return views;
}

std::optional<double> View::number() const {
  if (!json_) return std::nullopt;
  if (!json_->is_number()) refuse("a number");
  return json_->get<double>();
}

std::optional<bool> View::flag() const {
  if (!json_) return std::nullopt;
  if (!json_->is_boolean()) refuse("true or false");
  return json_->get<bool>();
}

std::string View::text() const {
  if (!json_) return "";
  if (!json_->is_string()) refuse("a text");
  return json_->get<std::string>();
}

std::vector<double> View::numbers() const {
  std::vector<double> values;
  for (const View& one : list()) values.push_back(one.number().value_or(std::numeric_limits<double>::quiet_NaN()));
  return values;
}

std::string View::cell(int digits) const {
  if (!json_) return "";
  if (json_->is_string()) return text();
  if (json_->is_boolean()) return *flag() ? "yes" : "no";
  if (json_->is_number()) return plain(*number(), digits);
  return json_->dump();
}

namespace {

/// The results of the whole suite, with figures, have 3.4 MB.
constexpr std::uintmax_t most_bytes = 64 << 20;

Json read_object(const std::filesystem::path& file, const FileSchema& schema, const char* made_by) {
  const std::string kind = std::string("a file that ") + made_by + " wrote";
  Json json;
  try {
    json = json_from(text_of_file(file, {.name = kind, .most_bytes = most_bytes}));
  } catch (const JsonError& wrong) {
    throw ReportError(fmt::format("{}: {}; required is {}", file.string(), one_line(wrong.what()), kind));
  }
  if (!json.is_object())
    throw ReportError(fmt::format("{}: is no JSON object; required is a file that {} wrote", file.string(), made_by));
  const auto found = json.find("schema");
  if (found == json.end())
    throw ReportError(
        fmt::format("{}: has no schema; required is {}, as {} writes it", file.string(), schema.name, made_by));
  if (*found != schema.name && *found != schema.number)
    throw ReportError(fmt::format("{}: has schema {}; required is {}, as {} writes it", file.string(),
                                  shortened(one_line(found->dump()), 60), schema.name, made_by));
  return json;
}

}  // namespace

Documents read_documents(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw ReportError(folder.string() + ": is no folder; required is one that ehd verify --output has filled");
  // A file that is there and cannot be read is not "absent".
  const auto there = [&](const char* name) {
    return std::filesystem::status(folder / name, error).type() != std::filesystem::file_type::not_found;
  };
  if (!there("results.json"))
    throw ReportError(fmt::format("{}: has no results.json; required is one that ehd verify --output {} makes",
                                  folder.string(), folder.string()));
  Documents documents;
  documents.results = read_object(folder / "results.json", results_schema, "ehd verify --output");
  if (there("bench.json")) documents.bench = read_object(folder / "bench.json", bench_schema, "ehd bench --output");
  if (there("stress.json"))
    documents.stress = read_object(folder / "stress.json", stress_schema, "ehd stress --output");
  return documents;
}

}  // namespace ehd::report
