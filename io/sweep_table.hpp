// SPDX-License-Identifier: GPL-3.0-or-later
// The two tables of a sweep: rows.csv and rows.json.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "io/sweep_file.hpp"

namespace ehd {

/// The header of rows.csv, and a row's lines, from its object in rows.json.
[[nodiscard]] std::string csv_header(const Sweep& sweep);
[[nodiscard]] std::string csv_lines(const Sweep& sweep, const Json& row);

/// Rows with a law that did not converge.
struct Failures {
  std::size_t rows = 0;
  std::string first = {};  ///< failure_of the first one

  void add(const std::optional<std::string>& failure);
};

/// Writes rows.csv and rows.json into the folder. `row_of`: a kept row; called from up to `threads` threads.
/// `sweep_hash` names the whole sweep. Throws OutputError.
[[nodiscard]] Failures write_table(const Sweep& sweep, const std::string& sweep_hash,
                                   const std::filesystem::path& folder,
                                   const std::function<std::string(std::size_t row)>& row_of, unsigned threads);

}  // namespace ehd
