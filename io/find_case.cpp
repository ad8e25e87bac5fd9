// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/find_case.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "contact/text.hpp"
#include "io/case_reader.hpp"

#ifndef EHD_CASES_FOLDER
#define EHD_CASES_FOLDER "cases"
#endif

namespace ehd {

std::filesystem::path cases_folder() {
  const char* folder = std::getenv("EHD_CASES");
  return folder && *folder ? std::filesystem::path(folder) : std::filesystem::path(EHD_CASES_FOLDER);
}

namespace {

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(cases_folder(), error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->path().extension() == ".toml") files.push_back(entry->path());
  }
  if (error)
    throw CaseError(one_line(cases_folder().string() +
                             ": the folder of the benchmark cases cannot be listed; EHD_CASES may name another"));
  std::sort(files.begin(), files.end());
  return files;
}

/// The folders in cases/, by name: collections such as cases/atlas. Their cases are found by id as well.
std::vector<std::filesystem::path> case_subfolders() {
  std::vector<std::filesystem::path> folders;
  std::error_code error, unknown;
  std::filesystem::directory_iterator entry(cases_folder(), error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->is_directory(unknown)) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace

std::filesystem::path find_case(const std::string& path_or_id) {
  std::error_code error;
  const std::filesystem::path path(path_or_id);
  if (path_or_id.find('/') != std::string::npos || path.extension() == ".toml") return path;
  const auto in_cases = cases_folder() / (path_or_id + ".toml");
  if (std::filesystem::is_regular_file(std::filesystem::status(in_cases, error))) return in_cases;
  for (const auto& folder : case_subfolders()) {
    const auto below = folder / (path_or_id + ".toml");
    if (std::filesystem::is_regular_file(std::filesystem::status(below, error))) return below;
  }
  if (std::filesystem::exists(std::filesystem::status(path, error))) return path;
  throw CaseError(one_line(path_or_id + ": there is no such case; allowed is a path to a case file, or an id that "
                                        "`ehd cases` lists"));
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto& file : case_files()) cases.push_back(read_case(file));
  return cases;
}

}  // namespace ehd
