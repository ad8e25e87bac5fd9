// SPDX-License-Identifier: GPL-3.0-or-later
// A CSV that somebody else's program wrote, row by row: a header, then as many cells a row, quoted as RFC 4180 has it.
// Beyond that, lines may end with CR alone, blanks around a cell do not count, and blank lines are left out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/file_text.hpp"
#include "workflow/case.hpp"

namespace ehd::judging {

class CsvReader {
 public:
  /// Reads the file and its header. Names of columns end at a blank: "X [x/b]" is X. Throws CaseError.
  CsvReader(const std::filesystem::path& file, const FileKind& kind, std::size_t most_rows);

  /// The place of a column; throws CaseError where a required one is missing, size() where another one is.
  [[nodiscard]] std::size_t column(const std::string& name, bool required = true) const;
  [[nodiscard]] std::size_t size() const { return header_.size(); }
  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }

  /// Goes to the next row that is not empty; false at the end. Throws CaseError: too many rows, a quotation mark where
  /// none belongs.
  [[nodiscard]] bool next();
  /// Throws CaseError where the row has another number of cells than the header.
  void require_all_cells() const;
  [[nodiscard]] const std::string& cell(std::size_t column) const { return cells_[column]; }
  /// A finite number. Throws CaseError.
  [[nodiscard]] double number(std::size_t column) const;

  [[nodiscard]] std::string place() const;  ///< "FILE:LINE", where the row begins
  /// "FILE:LINE: column = value: what"
  [[nodiscard]] CaseError refuse(std::size_t column, const std::string& what) const;

 private:
  [[nodiscard]] bool read_row();
  [[nodiscard]] std::string read_cell();
  [[nodiscard]] std::string read_quoted();
  [[nodiscard]] bool ends_cell() const;
  void skip_blanks();
  bool skip_line_end();
  std::filesystem::path file_;
  std::string text_;
  std::size_t at_ = 0, rows_ = 0, most_rows_ = 0;
  int line_ = 1, row_line_ = 0;  ///< where at_ is; where the row begins
  std::vector<std::string> header_, cells_;
};

}  // namespace ehd::judging
