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

struct StoredRow;  // io/stored_row

/// The header of rows.csv.
[[nodiscard]] std::string csv_header(const Sweep& sweep);

/// What is wrong with the entries that rows.csv shows of a result, by their types; empty where nothing is.
[[nodiscard]] std::string wrong_csv_entry(const Sweep& sweep, const Json& result);

/// Rows with a law that did not converge.
struct Failures {
  std::size_t rows = 0;
  std::size_t not_run = 0;  ///< of these rows, left out by the deadline
  std::string first = {};   ///< failure_of the first one

  void add(const std::optional<std::string>& failure);
};

/// Writes rows.csv and rows.json into the folder. `row_of` is called from up to `threads` threads.
/// `sweep_hash` names the whole sweep. Throws OutputError.
[[nodiscard]] Failures write_table(const Sweep& sweep, const std::string& sweep_hash,
                                   const std::filesystem::path& folder,
                                   const std::function<StoredRow(std::size_t row)>& row_of, unsigned threads);

}  // namespace ehd
