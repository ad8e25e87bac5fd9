// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "contact/text.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

namespace {

constexpr std::size_t longest_cell = 60;  // bytes of a cell that a message repeats
constexpr std::size_t most_columns = 64;  // a profile of ours has 10
constexpr std::size_t most_cells = 1000;  // of a row that is refused: a file of commas alone would fill the memory
constexpr std::string_view line_ends = "\r\n", cell_ends = ",\r\n", blanks = " \t";

/// What a spreadsheet writes where the comma is its decimal sign.
std::string_view other_separator(const std::string& header) {
  if (header.find(';') != std::string::npos) return "semicolons";
  return header.find('\t') != std::string::npos ? "tabs" : "";
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file, const FileKind& kind, std::size_t most_rows)
    : file_(file), text_(submitted_text(file, kind)), most_rows_(most_rows) {
  if (!read_row()) throw refusal(file_.string(), "is empty; required is " + std::string(kind.name));
  if (cells_.size() > most_columns)
    throw refusal(place(), fmt::format("has {} columns; allowed are up to {}", cells_.size(), most_columns));
  if (const auto separator = other_separator(cells_.front()); cells_.size() == 1 && !separator.empty())
    throw refusal(place(), fmt::format("has {} between its cells; required are commas", separator));
  for (const std::string& cell : cells_) {
    const std::string name = cell.substr(0, cell.find(' '));
    if (std::find(header_.begin(), header_.end(), name) != header_.end())
      throw refusal(place(), "column " + shortened(name, longest_cell) + " is there twice; allowed is once");
    header_.push_back(name);
  }
}

std::size_t CsvReader::column(const std::string& name, bool required) const {
  const auto at = std::find(header_.begin(), header_.end(), name);
  if (required && at == header_.end())
    throw refusal(place(), "column " + name + " is missing; required is a header line that names it");
  return static_cast<std::size_t>(at - header_.begin());
}

bool CsvReader::ends_cell() const { return at_ == text_.size() || cell_ends.find(text_[at_]) != std::string::npos; }

void CsvReader::skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

/// CR LF, LF or CR. False where none is.
bool CsvReader::skip_line_end() {
  if (at_ == text_.size() || line_ends.find(text_[at_]) == std::string::npos) return false;
  at_ += text_.compare(at_, line_ends.size(), line_ends) == 0 ? line_ends.size() : 1;
  ++line_;
  return true;
}

/// The next row that is not blank. False at the end of the text.
bool CsvReader::read_row() {
  do skip_blanks();
  while (skip_line_end());
  if (at_ == text_.size()) return false;
  row_line_ = line_;
  cells_.clear();
  cells_.push_back(read_cell());
  while (at_ < text_.size() && text_[at_] == ',') {
    if (cells_.size() == most_cells)
      throw refusal(place(), fmt::format("has more than {} columns; allowed are up to {}", most_cells, most_columns));
    ++at_;
    cells_.push_back(read_cell());
  }
  (void)skip_line_end();
  return true;
}

std::string CsvReader::read_cell() {
  skip_blanks();
  if (at_ < text_.size() && text_[at_] == '"') {
    std::string cell = read_quoted();
    skip_blanks();
    if (ends_cell()) return cell;
    throw refusal(place(), "has text behind a closing quotation mark; allowed is a comma, or the end of the line");
  }
  const std::size_t begin = at_;
  at_ = std::min(text_.find_first_of(cell_ends, at_), text_.size());
  std::string cell = text_.substr(begin, at_ - begin);
  cell.erase(cell.find_last_not_of(blanks) + 1);
  if (cell.find('"') != std::string::npos)
    throw refusal(place(), "has a quotation mark within a cell; allowed are two around the whole cell");
  return cell;
}

/// From an opening quotation mark to behind the closing one. Two together are one of the cell.
std::string CsvReader::read_quoted() {
  const int opened = line_;
  std::string cell;
  ++at_;
  while (at_ < text_.size()) {
    const std::size_t begin = at_;
    if (skip_line_end()) {
      cell.append(text_, begin, at_ - begin);
    } else if (text_[at_] != '"') {
      cell += text_[at_++];
    } else if (text_.compare(at_, 2, "\"\"") == 0) {
      cell += '"';
      at_ += 2;
    } else {
      ++at_;
      return cell;
    }
  }
  throw refusal(fmt::format("{}:{}", file_.string(), opened),
                "has a quotation mark that nothing closes; required is another one behind the cell");
}

bool CsvReader::next() {
  if (!read_row()) return false;
  if (++rows_ > most_rows_)
    throw refusal(place(), fmt::format("has more than {0} rows; allowed are at most {0}", most_rows_));
  return true;
}

void CsvReader::require_all_cells() const {
  if (cells_.size() != header_.size())
    throw refusal(place(), fmt::format("has {} cells; allowed are {}, as the header has{}", cells_.size(),
                                       header_.size(), cells_.size() > header_.size() ? ", and no decimal comma" : ""));
}

double CsvReader::number(std::size_t column) const {
  std::string_view text = cells_[column];
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ptr != text.data() + text.size() || read.ec == std::errc::invalid_argument)
    throw refuse(column, "is not a number; allowed is a decimal number, such as 1.5e-3");
  if (read.ec != std::errc()) throw refuse(column, "is out of range; allowed is a number that a double holds");
  if (!std::isfinite(value)) throw refuse(column, "is not finite; allowed is a decimal number, such as 1.5e-3");
  return value;
}

std::string CsvReader::place() const { return fmt::format("{}:{}", file_.string(), row_line_); }

CaseError CsvReader::refuse(std::size_t column, const std::string& what) const {
  return refusal(place(), fmt::format("{} = {}: {}", header_[column], shortened(cells_[column], longest_cell), what));
}

}  // namespace ehd::judging
