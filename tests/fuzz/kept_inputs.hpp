// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are kept of fuzzing, through the promises that fuzzing checks.
#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/files.hpp"

namespace ehd::verification::test {

/// Every file of a folder and its folders, by name; none where there is no such folder.
[[nodiscard]] inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Checks `broken` ("" for no broken promise) of every file; their number.
template <class Broken>
std::size_t keep_promises(const std::filesystem::path& folder, Broken broken) {
  const auto files = files_in(folder);
  for (const auto& file : files) {
    const std::string promise = broken(read(file));
    BOOST_CHECK_MESSAGE(promise.empty(), file.filename().string() << ": " << promise);
  }
  return files.size();
}

}  // namespace ehd::verification::test
