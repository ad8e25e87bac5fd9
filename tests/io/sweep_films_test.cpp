// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps whose films come from a table.
#include <cmath>
#include <string>
#include <vector>

#include "io/sweep_file.hpp"
#include "io/sweep_run.hpp"
#include "io/sweep_shards.hpp"
#include "tests/check.hpp"
#include "tests/io/sweeps.hpp"
#include "workflow/registry.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::test;

namespace {

/// Contacts of one oil whose films come from a table.
std::string table_sweep(const std::string& rest = "") {
  return "case = \"own-moes-20-10-flooded\"\nfilms = \"table\"\ntolerance = 1e-3\ncombine = \"product\"\n" + rest +
         "[table]\nM = [15, 40]\nL = [7, 10.0]\n[keys]\n\"moes.M\" = [15, 21.0, 33.3, 40]\n\"moes.L\" = [7.5, 10]\n";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sweep_films)

BOOST_AUTO_TEST_CASE(a_row_with_films_from_a_table_says_so_and_agrees_with_a_solve) {
  const Folder folder;
  const Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  const SweepCost cost = run_sweep(tabled, {}, folder.path() / "out");
  BOOST_TEST(cost.failures.rows == 0u);
  BOOST_TEST(cost.saved() >= 0);
  const auto json = nlohmann::json::parse(Files(folder.path() / "out").json);
  BOOST_TEST(json["sweep"]["films"] == "table");
  BOOST_TEST((json["sweep"]["table"]["M"] == std::vector<double>{15, 40}));
  BOOST_REQUIRE(json["rows"].size() == 8u);
  for (const auto& row : json["rows"]) {
    const auto& result = row["results"][0];
    BOOST_TEST(result["solver"] == "table");
    BOOST_TEST(result["notes"].back().get<std::string>().find("a table over M 15 to 40, L 7 to 10") !=
               std::string::npos);
    BOOST_TEST(!result.contains("pressure"));
    const Problem problem =
        problem_of(tabled.table->oil, {row["keys"]["moes.M"].get<double>(), row["keys"]["moes.L"].get<double>()});
    const Solution solved = default_solver().solve(problem, {.tolerance = 1e-5});
    for (const Quantity film : table_films) {
      const auto& entry = result["film"][std::string(to_string(film)).substr(5)];
      const double truth = solved.observables.at(film).value, stated = entry["error"].get<double>();
      const double unit = has_absolute_error(film) ? 1 : truth;
      BOOST_TEST(!entry.contains("errors"));  // the table knows the whole error, not its parts
      EHD_CHECK(stated, Tolerance::required(1e-3, "the tolerance of the sweep"));
      EHD_CHECK(std::abs(entry["hertz"].get<double>() - truth) / unit,
                Tolerance::required(stated, "the row states it"));
    }
  }
  const auto lines = lines_of_text(Files(folder.path() / "out").csv);
  for (std::size_t i = 1; i < lines.size(); ++i) BOOST_TEST(lines[i].find(",table,converged,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_row_from_a_table_tells_of_the_oil_as_a_solve_does) {
  const Folder folder;
  (void)folder.write("graded.toml",
                     "id = \"graded\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1e5\n"
                     "reduced_radius_m = 1e-2\nreduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 3\n[lubricant]\n"
                     "iso_vg = 68\ntemperature_C = 60\nviscosity = \"roelands\"\ndensity = \"dowson-higginson\"\n"
                     "[domain]\ninlet = \"flooded\"\n");
  const auto result_of = [&](const std::string& films) {
    const Sweep sweep =
        read_sweep(folder.write("s.toml", "case = \"graded.toml\"\ncombine = \"product\"\ntolerance = 1e-2\n" + films +
                                              "[keys]\n\"conditions.load_N_per_m\" = [1e5]\n"));
    (void)run_sweep(sweep, {}, folder.path() / "out");
    return nlohmann::json::parse(Files(folder.path() / "out").json)["rows"][0]["results"][0];
  };
  const auto solved = result_of(""), tabled = result_of("films = \"table\"\n[table]\nM = [5, 20]\nL = [9, 12.0]\n");
  BOOST_REQUIRE(solved.contains("lubricant"));
  BOOST_TEST(tabled["lubricant"] == solved["lubricant"]);
  BOOST_TEST(tabled["notes"][0] == solved["notes"][0]);
}

BOOST_AUTO_TEST_CASE(rows_from_a_table_do_not_depend_on_threads_or_shards) {
  const Folder folder;
  const Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  (void)run_sweep(tabled, {.threads = 1}, folder.path() / "one");
  (void)run_sweep(tabled, {.threads = 3}, folder.path() / "three");
  for (const std::size_t number : {1u, 2u}) (void)run_shard(tabled, {}, folder.path() / "parts", {number, 2});
  (void)merge_shards(tabled, {}, folder.path() / "parts");
  BOOST_CHECK(Files(folder.path() / "one") == Files(folder.path() / "three"));
  BOOST_CHECK(Files(folder.path() / "one") == Files(folder.path() / "parts"));
}

BOOST_AUTO_TEST_CASE(the_range_of_a_table_is_in_the_hash_of_a_row) {
  const Folder folder;
  Sweep tabled = read_sweep(folder.write("s.toml", table_sweep()));
  const std::string hash = row_hash(tabled, {}, 0);
  tabled.table->range.M_high = 41;
  BOOST_TEST(row_hash(tabled, {}, 0) != hash);
  tabled.table.reset();
  BOOST_TEST(row_hash(tabled, {}, 0) != hash);
}

BOOST_AUTO_TEST_CASE(what_a_table_cannot_give_is_refused_before_anything_is_computed) {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& phrase) {
    const auto says = [&](const CaseError& error) {
      const std::string what = error.what();
      const bool right = what.find(phrase) != std::string::npos && what.find('\n') == std::string::npos;
      BOOST_CHECK_MESSAGE(right, phrase << " is not in: " << what);
      return true;
    };
    BOOST_CHECK_EXCEPTION((void)read_sweep(folder.write("s.toml", text)), CaseError, says);
  };
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = table_sweep();
    return text.replace(text.find(from), from.size(), to);
  };
  refused(changed("[15, 21.0", "[14, 21.0"), "M = 14, L = 7.5 is outside the table; allowed is M 15 to 40, L 7 to 10");
  refused(changed("\"moes.L\" = [7.5, 10]", "\"moes.L\" = [7.5, 10.5]"), "L = 10.5 is outside the table");
  refused(table_sweep() + "\"lubricant.z\" = [0.68, 0.6]\n", "the oil or the inlet differs from the table's");
  refused(table_sweep() + "\"domain.inlet\" = [-4.0]\n", "the oil or the inlet differs from the table's");
  refused(changed("films = \"table\"", "films = \"solve\""), "belongs to films = \"table\"");
  refused(changed("films = \"table\"", "films = \"sheet\""), "films = \"sheet\"");
  refused(changed("M = [15, 40]\n", ""),
          "[table]: M is missing; required is [LOW, HIGH] with 0.001 <= LOW < HIGH <= 1e6");
  refused(changed("M = [15, 40]", "M = [40, 15]"), "is no range; allowed is [LOW, HIGH]");
  refused(changed("M = [15, 40]", "M = 15"), "allowed is [LOW, HIGH]");
  refused(changed("[table]\nM = [15, 40]\nL = [7, 10.0]\n", ""), "[table]");
  refused(changed("L = [7, 10.0]", "L = [7, 10.0]\nN = 3"), "N");
  refused(table_sweep("solver = \"reference\"\n"), "is made by fast");
  refused(head("films = \"table\"\ncombine = \"zip\"\n[keys]\n\"bearing.clearance_m\" = [0.0]\n"),
          "belongs to the sweep of a contact");
}

BOOST_AUTO_TEST_SUITE_END()
