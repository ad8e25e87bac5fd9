// SPDX-License-Identifier: GPL-3.0-or-later
// Kept rows of a sweep, read back. tests/faults/rows.py puts wrong ones into journals and runs the program on them.
#include "io/stored_row.hpp"

#include <boost/test/unit_test.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/sweep_row.hpp"
#include "tests/files.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/registry.hpp"

using namespace ehd;
using verification::test::Folder;

namespace {

/// A sweep of one key, the text of its row 1 as compute_row makes it, and its hash.
struct Kept {
  Folder folder;
  Sweep sweep;
  std::string hash, text;
  explicit Kept(const std::string& file) : sweep(read_sweep(folder.write("s.toml", file))) {
    const auto cache = std::make_shared<ContactCache>(with_fallback(find_solver(sweep.solver)->solve));
    hash = row_hash(sweep, {}, 1);
    text = compute_row(sweep, {}, 1, hash, cache).text;
  }
};

const char* dry_bearing_rows = R"(case = "na4908"
laws = ["hertz", "iso"]
combine = "zip"
[keys]
"operation.radial_load_N" = [1e3, 2e3]
)";
const char* line_rows = R"(case = "na4908"
laws = ["ehd-linear"]
combine = "zip"
[keys]
"operation.radial_load_N" = [1e4, 2e4]
)";
const char* contact_rows = R"(case = "own-moes-5-5"
tolerance = 1e-2
combine = "zip"
[keys]
"moes.M" = [5.0, 6.0]
)";

std::string row_refusal(const Kept& kept, const std::string& text) {
  try {
    (void)read_stored_row(kept.sweep, 1, kept.hash, text);
  } catch (const StoredRowError& error) {
    return error.what();
  }
  return "read";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stored_row)

BOOST_AUTO_TEST_CASE(a_row_that_was_computed_is_read_back) {
  for (const char* file : {dry_bearing_rows, line_rows, contact_rows}) {
    const Kept kept(file);
    const StoredRow row = read_stored_row(kept.sweep, 1, kept.hash, kept.text);
    BOOST_TEST(row.text == "{\"row\":1," + kept.text.substr(1));
    BOOST_TEST((nlohmann::json(row.json) == nlohmann::json::parse(row.text)));  // "row" stands elsewhere
    BOOST_CHECK_THROW((void)read_stored_row(kept.sweep, 0, kept.hash, kept.text), StoredRowError);
  }
}

BOOST_AUTO_TEST_CASE(a_row_with_a_wrong_body_is_refused) {
  const Kept kept(dry_bearing_rows);
  BOOST_TEST(row_refusal(kept, "{\"results\":[{}]}") != "read");
  BOOST_TEST(row_refusal(kept, " " + kept.text) != "read");
  const Json right = Json::parse(kept.text);
  const std::vector<std::function<void(Json&)>> changes{
      [](Json& row) { row["results"] = Json::array({Json::object()}); },
      [](Json& row) { row["results"][0]["status"] = "fine"; },
      [](Json& row) { row["results"][0]["law"] = "ehd"; },
      [](Json& row) { row["results"].erase(1); },
      [](Json& row) { row["results"][0]["rollers"][2]["outer"].erase("force_N"); },
      [](Json& row) { row["results"][0]["rollers"][2]["inner"]["force_N"] = "=1+1"; },
      [](Json& row) { row["results"][0]["displacement_m"] = nullptr; },
      [](Json& row) { row["results"][0]["cost"] = 1; },
      [](Json& row) {
        row["results"][0]["fit"] = {{"inner", Json::object()}};
      },
      [](Json& row) { row["results"][0]["notes"] = {1}; },
      [](Json& row) { row["keys"]["operation.radial_load_N"] = 3e3; },
      [](Json& row) { row["hash"] = "0"; },
      [](Json& row) { row["more"] = 1; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Json wrong = right;
    changes[i](wrong);
    BOOST_TEST(row_refusal(kept, wrong.dump()) != "read", "change " << i);
  }
  BOOST_TEST(row_refusal(kept, right.dump()) == "read");
}

BOOST_AUTO_TEST_SUITE_END()
