// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of sweeps share: two sweeps, files that are read back, and results without their times.
#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "tests/files.hpp"

namespace ehd::verification::test {

/// Six bearings, two of them at each speed; three laws.
inline const char* const small_sweep = R"(case = "na4908"
laws = ["hertz", "ehd-linear", "ehd"]
combine = "product"
[keys]
"operation.radial_load_N" = [20e3, 50e3]
"operation.speed_rpm" = [2500.0, 5000.0, 7500]
)";

inline const char* const dry_sweep = R"(case = "na4908"
laws = ["hertz", "iso"]
combine = "product"
[keys]
"operation.radial_load_N" = { from = 1e3, to = 5e4, points = 5, spacing = "logarithmic" }
"bearing.clearance_m" = [0.0, 2.5e-6, 1e-5]
)";

inline std::string head(const std::string& rest) { return "case = \"na4908\"\n" + rest; }
inline std::string keys(const std::string& rest) { return head("combine = \"product\"\n[keys]\n" + rest); }

struct Files {
  std::string csv, json;
  explicit Files(const std::filesystem::path& folder)
      : csv(read(folder / "rows.csv")), json(read(folder / "rows.json")) {}
  bool operator==(const Files&) const = default;
};

inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

inline std::vector<std::string> lines_of_text(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Removes times, as the sweep does; written here again.
inline Json without_times(Json json) {
  for (const char* key : {"wall_s", "planning_s", "total_s", "stage_s"})
    if (json.is_object()) json.erase(key);
  if (json.is_structured())
    for (auto& inner : json) inner = without_times(inner);
  return json;
}

}  // namespace ehd::verification::test
