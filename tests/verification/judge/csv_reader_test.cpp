// SPDX-License-Identifier: GPL-3.0-or-later
// Cells as RFC 4180 quotes them, and texts that only look like it.
#include "verification/judge/csv_reader.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/files.hpp"

namespace ehd::judging {

namespace {

constexpr FileKind any_csv{.name = "a CSV", .most_bytes = 1 << 20};

/// The columns, then the cells of each row.
std::vector<std::vector<std::string>> cells_in(std::string_view text, std::size_t most_rows = 100) {
  const verification::test::Folder folder;
  CsvReader csv(folder.write("a.csv", text), any_csv, most_rows);
  std::vector<std::vector<std::string>> all{csv.header()};
  while (csv.next()) {
    csv.require_all_cells();
    all.emplace_back();
    for (std::size_t column = 0; column < csv.size(); ++column) all.back().push_back(csv.cell(column));
  }
  return all;
}

/// The message behind the name of the file; a text that is read fails the test.
std::string csv_refusal(std::string_view text, std::size_t most_rows = 100) {
  try {
    (void)cells_in(text, most_rows);
  } catch (const CaseError& error) {
    const std::string message = error.what(), name = "a.csv";
    BOOST_TEST(message.find('\n') == std::string::npos);
    return message.substr(message.find(name) + name.size());
  }
  BOOST_ERROR("read: " << text);
  return "";
}

using Rows = std::vector<std::vector<std::string>>;

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_csv_reader)

BOOST_AUTO_TEST_CASE(quoted_cells_hold_what_separates_others) {
  const Rows plain{{"a", "b"}, {"1", "x"}};
  for (const char* text :
       {"a,b\n1,x\n", "\"a\",\"b\"\n\"1\",\"x\"\n", "a,b\r\n\"1\",x", "a,b\r\"1\",x\r",
        " a ,\"b\"\t\n\n 1 , \"x\" \n\n", "\xEF\xBB\xBF\"a\",b\n1,x\n", "\"a [m, s]\",\"b \"\"c\"\"\"\n1,x\n"})
    BOOST_CHECK_MESSAGE(cells_in(text) == plain, text);
  BOOST_TEST((cells_in("a,b\n\"1,2\",\"say \"\"x\"\"\"\n") == Rows{{"a", "b"}, {"1,2", "say \"x\""}}));
  BOOST_TEST((cells_in("a,b\n\"1\r\n\n2\",\"\"\n3,\n") == Rows{{"a", "b"}, {"1\r\n\n2", ""}, {"3", ""}}));
  BOOST_TEST((cells_in("a,b\n\"\"\"\",\" x \"\n") == Rows{{"a", "b"}, {"\"", " x "}}));
}

BOOST_AUTO_TEST_CASE(a_quotation_mark_where_none_belongs_is_refused_with_its_line) {
  const auto refused = [](std::string_view text, const std::string& says) {
    const std::string message = csv_refusal(text);
    BOOST_CHECK_MESSAGE(message.starts_with(says), says << " does not begin: " << message);
  };
  refused("a,b\n1,\"x\n2,y\n", ":2: has a quotation mark that nothing closes");
  refused("\"", ":1: has a quotation mark that nothing closes");
  refused("a,b\n1,\"\"\"\n", ":2: has a quotation mark that nothing closes");
  refused("a,b\n1,2\n\"1\",\"x\"y\n", ":3: has text behind a closing quotation mark");
  refused("a,b\n\"1\"\"2\"3,x\n", ":2: has text behind a closing quotation mark");
  refused("a,b\n1,x\"y\"\n", ":2: has a quotation mark within a cell");
  // The row after a cell of three lines.
  refused("a,b\n\"1\n2\n3\",x\n4\n", ":5: has 1 cells");
  refused("a,b\n\"1\n2\",x,y\n", ":2: has 3 cells; allowed are 2, as the header has, and no decimal comma");
  refused("a,b\n" + std::string(1 << 19, ','), ":2: has more than 1000 columns; allowed are up to 64");
  BOOST_TEST(csv_refusal("a,b\n\"1\n2\",x\n\n3,y\n", 1).starts_with(":5: has more than 1 rows"));
}

BOOST_AUTO_TEST_CASE(other_separators_and_encodings_are_named) {
  BOOST_TEST(csv_refusal("a;b\n1,5;2,5\n").starts_with(":1: has semicolons between its cells; required are commas"));
  BOOST_TEST(csv_refusal("a\tb\n1\t2\n").starts_with(":1: has tabs between its cells; required are commas"));
  BOOST_TEST(csv_refusal(std::string_view("\xFF\xFE\x61\0,\0b\0", 8)).starts_with(": is binary, or UTF-16"));
  for (const char* blank : {"", "\xEF\xBB\xBF", " \r\n\t\n"})
    BOOST_TEST(csv_refusal(blank) == ": is empty; required is a CSV");
}

BOOST_AUTO_TEST_CASE(numbers_are_decimal_and_finite) {
  const verification::test::Folder folder;
  const auto number = [&](const std::string& cell) {
    CsvReader csv(folder.write("n.csv", "a\n" + cell + "\n"), any_csv, 1);
    BOOST_REQUIRE(csv.next());
    return csv.number(csv.column("a"));
  };
  const auto refused = [&](const std::string& cell, const std::string& says) {
    try {
      (void)number(cell);
      BOOST_ERROR("a number: " << cell);
    } catch (const CaseError& error) {
      const std::string message = error.what();
      BOOST_CHECK_MESSAGE(message.find("n.csv:2: a = ") != std::string::npos, message);
      BOOST_CHECK_MESSAGE(message.find(says) != std::string::npos, says << " is not in: " << message);
    }
  };
  for (const char* half : {"0.5", "+0.5", "\"0.5\"", "\"+5E-1\"", ".5", "5e-1"}) BOOST_TEST(number(half) == 0.5);
  for (const char* none : {"\"0,5\"", "50%", "5.0D-1", "0x1p-1", "+-0.5", "++0.5", "0.5(2)", "0_5", "=0.5", "\"\"",
                           "\" 0.5\"", "\"0.5\n\"", "1 000"})
    refused(none, "is not a number; allowed is a decimal number, such as 1.5e-3");
  for (const char* none : {"nan", "-inf", "Infinity"}) refused(none, "is not finite");
  for (const char* none : {"1e999", "1e-999"}) refused(none, "is out of range");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace ehd::judging
