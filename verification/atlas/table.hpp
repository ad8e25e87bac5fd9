// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the atlas: atlas.csv, digits.txt and a case file for each point. docs/atlas.md explains the
// columns.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/atlas/record.hpp"

namespace ehd::verification {

inline constexpr std::string_view atlas_csv_name = "atlas.csv", atlas_digits_name = "digits.txt";

/// The case file of a point. A point without digits waits for them.
[[nodiscard]] std::string case_text_of(const AtlasPoint& point, const AtlasRecord& record, int version = 1);

[[nodiscard]] const std::vector<std::string>& atlas_columns();
/// Cells in the order of atlas_columns(), empty where nothing is known.
[[nodiscard]] std::vector<std::string> atlas_row(const AtlasPoint& point, const AtlasRecord& record);

/// Cells of one row by column name.
using AtlasRow = std::map<std::string, std::string>;
[[nodiscard]] AtlasRow row_of(const std::vector<std::string>& cells);

/// atlas.csv.
struct AtlasTable {
  std::vector<AtlasRow> rows;
};
[[nodiscard]] std::string csv_text(const AtlasTable& table);
/// Throws CaseError, "FILE:LINE: column = value: the fault; the allowed values", for a file that `ehd atlas` did not
/// write: every number must be finite and in its range, every law known.
[[nodiscard]] AtlasTable read_atlas_table(const std::filesystem::path& csv);

/// Numbers of digits known of H_min and H_cen over M and L, a table for each law set and inlet.
[[nodiscard]] std::string digits_text(const AtlasTable& table);

/// cases/atlas
[[nodiscard]] std::filesystem::path atlas_folder();
/// atlas-*.toml of a folder, by name; none where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> atlas_files(const std::filesystem::path& folder);

/// Differences between atlas.csv and the case files beside it, a sentence each: problem, values, uncertainties, and
/// points that only one of the two has.
[[nodiscard]] std::vector<std::string> atlas_disagreements(const std::filesystem::path& folder);

/// A file that `ehd atlas` wrote; nothing where there is none. Throws CaseError.
[[nodiscard]] std::optional<std::string> atlas_text(const std::filesystem::path& file);

}  // namespace ehd::verification
