// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "contact/text.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

namespace {

constexpr std::size_t longest_cell = 60;  // bytes of a cell that a message repeats
constexpr std::size_t most_columns = 64;  // a profile of ours has 10

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto begin = std::min(text.find_first_not_of(blank), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(blank) + 1);
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file, const FileKind& kind, std::size_t most_rows)
    : file_(file), text_(text_of_file(file, kind)), most_rows_(most_rows) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  if (!next_line()) throw refusal(file_.string(), "is empty; required is " + std::string(kind.name));
  split();
  if (cells_.size() > most_columns)
    throw refusal(place(), fmt::format("has {} columns; allowed are up to {}", cells_.size(), most_columns));
  for (const std::string_view cell : cells_) {
    const std::string name(cell.substr(0, cell.find(' ')));
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

bool CsvReader::next_line() {
  while (at_ < text_.size()) {
    const auto end = std::min(text_.find('\n', at_), text_.size());
    current_ = trimmed(std::string_view(text_).substr(at_, end - at_));
    at_ = end + 1;
    ++line_;
    if (!current_.empty()) return true;
  }
  return false;
}

void CsvReader::split() {
  if (current_.find('"') != std::string_view::npos)
    throw refusal(place(), "has a quotation mark; allowed are plain cells between commas");
  cells_.clear();
  for (std::size_t begin = 0; begin <= current_.size();) {
    const auto end = std::min(current_.find(',', begin), current_.size());
    cells_.push_back(trimmed(current_.substr(begin, end - begin)));
    begin = end + 1;
  }
}

bool CsvReader::next() {
  if (!next_line()) return false;
  if (++rows_ > most_rows_)
    throw refusal(place(), "has more than " + std::to_string(most_rows_) + " rows; allowed are fewer");
  split();
  if (cells_.size() != header_.size())
    throw refusal(place(),
                  fmt::format("has {} cells; allowed are {}, as the header has", cells_.size(), header_.size()));
  return true;
}

double CsvReader::number(std::size_t column) const {
  std::string_view text = cells_[column];
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ptr != text.data() + text.size() || read.ec == std::errc::invalid_argument)
    throw refuse(column, "is not a number; allowed is a decimal number");
  if (read.ec != std::errc() || !std::isfinite(value))
    throw refuse(column, "is not finite; allowed is a number that a double holds");
  return value;
}

std::string CsvReader::place() const { return file_.string() + ":" + std::to_string(line_); }

CaseError CsvReader::refuse(std::size_t column, const std::string& what) const {
  return refusal(place(), fmt::format("{} = {}: {}", header_[column], shortened(cells_[column], longest_cell), what));
}

}  // namespace ehd::judging
