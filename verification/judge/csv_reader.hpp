// SPDX-License-Identifier: GPL-3.0-or-later
// A CSV that somebody else's program wrote, row by row: a header, then as many cells a row; no quotation marks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
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

  /// Goes to the next row that is not empty; false at the end. Throws CaseError: another number of cells, too many
  /// rows.
  [[nodiscard]] bool next();
  [[nodiscard]] std::string cell(std::size_t column) const { return std::string(cells_[column]); }
  /// A finite number. Throws CaseError.
  [[nodiscard]] double number(std::size_t column) const;

  [[nodiscard]] std::string place() const;  ///< "FILE:LINE"
  /// "FILE:LINE: column = value: what"
  [[nodiscard]] CaseError refuse(std::size_t column, const std::string& what) const;

 private:
  [[nodiscard]] bool next_line();
  void split();
  std::filesystem::path file_;
  std::string text_;
  std::size_t at_ = 0, rows_ = 0, most_rows_ = 0;
  int line_ = 0;
  std::string_view current_;
  std::vector<std::string> header_;
  std::vector<std::string_view> cells_;
};

}  // namespace ehd::judging
