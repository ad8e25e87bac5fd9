// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "tests/files.hpp"
#include "tests/verification/atlas/made_atlas.hpp"
#include "verification/atlas/atlas.hpp"
#include "verification/atlas/table.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(atlas_table_reader)

using namespace made_atlas;

BOOST_AUTO_TEST_CASE(a_table_that_is_none_is_refused_with_its_line) {
  const test::Folder folder;
  std::string header;
  for (const auto& name : atlas_columns()) header += (header.empty() ? "" : ",") + name;
  std::vector<std::string> cells(atlas_columns().size(), "1");
  cells[2] = "twenty";
  std::string row;
  for (const auto& cell : cells) row += (row.empty() ? "" : ",") + cell;
  const std::pair<std::string, std::string> rows[] = {
      {"", "has no header"},
      {"a,b\n", "t.csv:1: a,b: other columns"},
      {"# c\n" + header + "\n1,2,3\n", "t.csv:3: 1,2,3: has 3 cells"},
      {fmt::format("{}\n{}\n", header, row), "t.csv:2: M = twenty: is not a number"},
  };
  for (const auto& [text, said] : rows) {
    const auto file = folder.write("t.csv", text);
    try {
      (void)read_atlas_table(file);
      BOOST_ERROR("not refused: " << text);
    } catch (const CaseError& refused) {
      BOOST_TEST(std::string(refused.what()).find(said) != std::string::npos, refused.what());
    }
  }
  BOOST_CHECK_THROW((void)read_atlas_table(folder.path() / "absent.csv"), CaseError);
}

BOOST_AUTO_TEST_CASE(a_damaged_cell_is_refused_with_its_line_and_column) {
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  const auto csv = request.folder / "atlas.csv";
  const AtlasTable table = read_atlas_table(csv);
  BOOST_REQUIRE(!table.rows.empty());
  const struct {
    const char *column, *value, *said;
  } edits[] = {
      {"H_min", "abc", "is not a number; allowed is a positive number"},
      {"id", "-m20-l10", "is no id; allowed is letters, digits, dot, dash and underscore, beginning with a letter"},
      {"H_min", "1e400", "is out of range; allowed is a positive number"},
      {"H_cen", "nan", "is not finite; allowed is a positive number"},
      {"H_cen", "inf", "is not finite; allowed is a positive number"},
      {"H_couette", "0", "is out of range; allowed is a positive number"},
      {"H_min", "-0.1", "is out of range; allowed is a positive number"},
      {"H_min_error", "1e-9x", "is not a number; allowed is a positive number"},
      {"H_min_error", "0", "is out of range; allowed is a positive number"},
      {"H_min_error", "", "is missing; allowed is a number and its uncertainty"},
      {"H_0", "nan", "is not finite; allowed is a number"},
      {"laws", "rolands", "is unknown; allowed is isoviscous, barus, roelands"},
      {"laws", "", "is unknown; allowed is isoviscous, barus, roelands"},
      {"M", "0", "is out of range; allowed is a number from 1e-3"},
      {"M", "nan", "is not finite; allowed is a number from 1e-3"},
      {"M", "", "is missing; allowed is a number from 1e-3"},
      {"L", "-3", "is out of range; allowed is a number from 0 to 100"},
      {"inlet", "4", "is unknown; allowed is flooded"},
      {"inlet", "", "is unknown; allowed is flooded"},
      {"numerical_test", "maybe", "is unknown; allowed is yes, no"},
  };
  for (const auto& edit : edits) {
    BOOST_TEST_CONTEXT(edit.column << " = " << edit.value) {
      std::string text;
      for (const auto& name : atlas_columns()) text += (text.empty() ? "" : ",") + name;
      auto row = table.rows.back();
      BOOST_REQUIRE(!row.at(edit.column).empty());
      row[edit.column] = edit.value;
      text += "\n";
      for (const auto& name : atlas_columns()) text += (name == "id" ? "" : ",") + row.at(name);
      const auto file = folder.write("damaged.csv", text + "\n");
      try {
        (void)read_atlas_table(file);
        BOOST_ERROR("not refused");
      } catch (const CaseError& refused) {
        const std::string says = fmt::format("damaged.csv:2: {} = {}: {}", edit.column, edit.value, edit.said);
        BOOST_TEST(std::string(refused.what()).find(says) != std::string::npos, refused.what());
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
