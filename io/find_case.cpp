// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/find_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/case_text.hpp"
#include "io/near_miss.hpp"

#ifndef EHD_CASES_FOLDER
#define EHD_CASES_FOLDER "cases"
#endif

namespace ehd {

namespace {

/// Beside the program, where it is installed: PREFIX/bin/ehd and PREFIX/share/ehd/cases.
std::optional<std::filesystem::path> installed_cases() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const auto cases = program.parent_path().parent_path() / "share/ehd/cases";
  return std::filesystem::is_directory(cases, error) ? std::optional(cases) : std::nullopt;
}

}  // namespace

std::filesystem::path cases_folder() {
  const char* folder = std::getenv("EHD_CASES");
  if (folder && *folder) return folder;
  return installed_cases().value_or(EHD_CASES_FOLDER);
}

namespace {

/// What cases/ holds, by name, as far as it can be listed.
std::vector<std::filesystem::directory_entry> entries_of_cases(std::error_code& error) {
  std::vector<std::filesystem::directory_entry> entries;
  std::filesystem::directory_iterator entry(cases_folder(), error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) entries.push_back(*entry);
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

std::filesystem::path find_case(const std::string& path_or_id) {
  if (path_or_id.empty())
    throw CaseError(fmt::format("\"\": a CASE has a name; allowed is a path to a case file, or {}", allowed_id));
  std::error_code error;
  const std::filesystem::path path(path_or_id);
  if (path_or_id.find('/') != std::string::npos || path.extension() == ".toml") return path;
  const auto in_cases = cases_folder() / (path_or_id + ".toml");
  if (std::filesystem::is_regular_file(std::filesystem::status(in_cases, error))) return in_cases;
  for (const auto& entry : entries_of_cases(error)) {  // collections such as cases/atlas
    const auto below = entry.path() / (path_or_id + ".toml");
    if (std::filesystem::is_regular_file(std::filesystem::status(below, error))) return below;
  }
  if (std::filesystem::exists(std::filesystem::status(path, error))) return path;
  throw CaseError(one_line(fmt::format("{}: there is no such case; {}allowed is a path to a case file, or {}",
                                       path_or_id, did_you_mean_case(path_or_id), allowed_id)));
}

std::string did_you_mean_case(const std::string& id) {
  std::error_code error;
  std::vector<std::string> ids;
  for (const auto& entry : entries_of_cases(error))
    if (entry.path().extension() == ".toml") ids.push_back(entry.path().stem().string());
  return did_you_mean(id, ids);
}

Case read_named_case(const std::string& path_id_or_dash, const std::vector<Substitution>& substitutions) {
  if (path_id_or_dash == "-") return read_case(text_of_standard_input(), standard_input, substitutions);
  const std::filesystem::path file = find_case(path_id_or_dash);
  return read_case(read_case_text(file), file, substitutions);
}

std::vector<Case> all_cases() {
  std::error_code error;
  const auto entries = entries_of_cases(error);
  if (error)
    throw CaseError(one_line(cases_folder().string() +
                             ": the folder of the benchmark cases cannot be listed; EHD_CASES may name another"));
  std::vector<Case> cases;
  for (const auto& entry : entries)
    if (entry.path().extension() == ".toml") cases.push_back(read_case(entry.path()));
  return cases;
}

}  // namespace ehd
