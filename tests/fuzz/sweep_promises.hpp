// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader of sweep files promises of ANY bytes: one refusal in one line, or a sweep whose rows are cases or are
// refused in one line.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/sweep_file.hpp"
#include "io/sweep_table.hpp"
#include "tests/files.hpp"
#include "tests/fuzz/refusal.hpp"

namespace ehd::verification::promises {

inline std::string sweep_broken(std::string_view bytes) {
  static const test::Folder folder;
  const auto file = folder.write("fuzz.toml", bytes);
  try {
    const Sweep sweep = read_sweep_statement(file);
    const std::size_t rows = sweep.rows();
    if (rows == 0 || rows > most_rows) return "a sweep of " + std::to_string(rows) + " rows";
    if (sweep.to_json().dump().empty() || !csv_header(sweep).starts_with("row,")) return "no header";
    constexpr std::size_t enough = 4;  // a hostile sweep has as many rows as are allowed
    for (std::size_t row = 0; row < std::min(rows, enough); ++row) (void)sweep.case_of(row);
    (void)sweep.case_of(rows - 1);
  } catch (const CaseError& refusal) {
    return broken_by_refusal(refusal.what(), file.string(), bytes);
  }
  return "";
}

}  // namespace ehd::verification::promises
