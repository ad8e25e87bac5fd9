// SPDX-License-Identifier: GPL-3.0-or-later
// A case with lists or ranges for some of its keys: the file as a user writes it, its strict reader (sweep_reader.cpp),
// and its rows. docs/sweep.md lists the file's keys.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/json.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/case.hpp"
#include "workflow/film_table.hpp"
#include "workflow/film_table_oil.hpp"
#include "workflow/registry.hpp"

namespace ehd {

/// One key of the case with the values that it takes.
struct SweptKey {
  std::string key;  ///< "operation.radial_load_N"
  std::vector<TomlValue> values;
  int line = 0;      ///< of the sweep file
  std::string text;  ///< the values as written there
};

enum class Combine { product, zip };

/// films = "table": over this range, for this oil.
struct SweepTable {
  FilmRange range;
  TableOil oil;
};

struct Sweep {
  std::string id;              ///< the file's name without .toml
  std::filesystem::path file;  ///< as named by the user
  std::filesystem::path case_file;
  std::string case_text;
  std::string case_id;
  bool bearing = false;
  std::vector<bearing::Law> laws;  ///< as asked for; empty: as `ehd bearing` has them
  std::string solver{default_solver().name};
  double tolerance = 1e-3;               ///< of the films of a contact case; a bearing's contacts have their own
  std::optional<SweepTable> table = {};  ///< without it every row is solved
  Combine combine = Combine::product;
  std::vector<SweptKey> keys;  ///< in the order of the file; from row to row the last key changes fastest
  int keys_line = 0;

  [[nodiscard]] std::size_t rows() const;
  /// What row 0 … rows() - 1 puts into the case.
  [[nodiscard]] std::vector<Substitution> values_of(std::size_t row) const;
  /// The row's case, through the reader of case files. Throws CaseError with the sweep's line, the row and its keys.
  [[nodiscard]] Case case_of(std::size_t row) const;
  /// What run_bearing is asked for.
  [[nodiscard]] BearingRequest request_of(const Case& row_case) const;
  /// {"id", "case", "laws", "solver", "tolerance", "films", "table", "combine", "keys", "rows"}: what all rows have in
  /// common.
  [[nodiscard]] Json to_json() const;
};

/// More rows are refused: their hashes stand in memory. A million takes 82 MB (make sweep-million).
inline constexpr std::size_t most_rows = 1000000;

/// Reads the file, and no row's case. Throws CaseError.
[[nodiscard]] Sweep read_sweep_statement(const std::filesystem::path& file);

/// Reads the cases of these rows over threads (0: as many as there are cores), so that a wrong row is found before
/// anything is computed. Throws the CaseError of the first wrong one in the list.
void require_cases(const Sweep& sweep, const std::vector<std::size_t>& rows, unsigned threads);

/// The file and the cases of all rows. Throws CaseError.
[[nodiscard]] Sweep read_sweep(const std::filesystem::path& file);

[[nodiscard]] Json to_json(const TomlValue& value);

}  // namespace ehd
