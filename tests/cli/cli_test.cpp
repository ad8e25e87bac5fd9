// SPDX-License-Identifier: GPL-3.0-or-later
// The program as a process: exit codes and streams.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/film_table_text.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"
#include "verification/studies/statement_study.hpp"

using namespace ehd;
using namespace ehd::verification;
using nlohmann::json;

namespace {

std::string heading(const std::string& id) {
  return "id = \"" + id + "\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n";
}

/// The file of a dry contact without expectations.
std::string dry_case(const test::Folder& folder, const std::string& id) {
  const std::string conditions =
      "[conditions]\nload_N_per_m = 1.2e5\nreduced_radius_m = 1.1e-2\nreduced_modulus_Pa = 2.3e11\n";
  return folder.write(id + ".toml", heading(id) + conditions).string();
}

/// A character in UTF-8 is a column.
long columns_of(const std::string& line) {
  return std::count_if(line.begin(), line.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
}

/// Arguments, and what the line on standard error says.
using Rows = std::vector<std::pair<std::string, std::string>>;

void check_refused(const test::Folder& folder, const Rows& rows) {
  BOOST_REQUIRE(!rows.empty());
  for (const auto& [arguments, phrase] : rows) test::check_refused(folder, arguments, phrase);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cli)

BOOST_AUTO_TEST_CASE(a_solve_prints_a_table_and_exits_with_0) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve own-moes-5-5 --tolerance 1e-2");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.err == "");
  for (const char* text : {"film.minimum", "Moes", "converged", "Dowson & Higginson", "cost"})
    BOOST_CHECK_MESSAGE(ended.out.find(text) != std::string::npos, text << " is not in the table");
  BOOST_TEST(ended.out.find('\033') == std::string::npos);  // no colour into a file
}

// Sources are citations, and not wrapped.
BOOST_AUTO_TEST_CASE(tables_are_at_most_100_columns_wide) {
  const test::Folder folder;
  const std::string source = EHD_SOURCE_DIR;
  const std::string seven_laws =
      "/tests/outputs/inputs/roller-bearing.toml --law hertz --law iso --law lundberg "
      "--law tripp --law houpert --law ehd-linear --law ehd";
  for (const std::string& command : std::vector<std::string>{
           "solve own-moes-5-5 --tolerance 1e-5",
           "bearing na4908 --details",
           "cases",
           "plan na4908",
           "compare own-moes-5-5 --tolerance 1e-2",
           "compare own-moes-20-10 --tolerance 1e-6",
           "response own-moes-5-5 --omega 0.1",
           "solve steel-roller",
           "bearing na4908 --law hertz --law iso --law ehd-linear --law ehd --details",
           "bearing " + source + seven_laws,
           "judge " + source + "/cases/submissions/line-contact-py.json",
           "bench --quick --part batch --part cost",
           "stress --quick --part e",
           "bearing harris-209 --cage-positions 12",
           "maps",
           "maps --motion",
           "cases --atlas",
           "statements",
           "verify --quick --rung 11",
           "convert M=20 L=10",
           "solve " + source + "/examples/cylinder-on-plate.toml",
           "convert M=20 L=10 reduced_radius_m=0.01 reduced_modulus_Pa=2.2e11 alpha_per_Pa=2e-8"}) {
    std::istringstream lines(test::ehd_run(folder, command).out);
    int seen = 0;
    for (std::string line; std::getline(lines, line); ++seen) {
      BOOST_CHECK_MESSAGE(columns_of(line) <= 100, command << ": " << columns_of(line) << " columns: " << line);
    }
    BOOST_TEST(seen > 5, command);
  }
}

// With more bearings a datum has more columns. They go on below.
BOOST_AUTO_TEST_CASE(the_output_of_three_bearings_is_at_most_100_columns_wide) {
  const test::Folder folder;
  std::istringstream lines(test::ehd_run(folder, "bearing na4908 na4908-2.5um na4908-10um").out);
  int heads = 0;
  for (std::string line; std::getline(lines, line);) {
    heads += line.starts_with("  datum ") ? 1 : 0;
    BOOST_TEST(columns_of(line) <= 100, line);
  }
  BOOST_TEST(heads == 4);  // two parts for each law with films
}

BOOST_AUTO_TEST_CASE(the_papers_statements_are_printed_for_its_bearing_alone) {
  const test::Folder folder;
  const std::string paper = test::ehd_run(folder, "bearing na4908 na4908-2.5um na4908-10um").out;
  BOOST_TEST(paper.find("The paper's statements") != std::string::npos);
  std::string own = "bearing";
  for (const std::string clearance : {"5", "10", "20"}) {
    std::string text = test::read(std::string(EHD_SOURCE_DIR) + "/examples/roller-bearing.toml");
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"roller-bearing", "own-" + clearance},
                                   {"clearance_m = 10e-6", "clearance_m = " + clearance + "e-6"}}) {
      BOOST_REQUIRE(text.find(from) != std::string::npos);
      text.replace(text.find(from), from.size(), to);
    }
    own += " '" + folder.write("own-" + clearance + ".toml", text).string() + "'";
  }
  const auto ended = test::ehd_run(folder, own);
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.out.find("paper") == std::string::npos, ended.out);
}

BOOST_AUTO_TEST_CASE(rollers_that_overlap_are_named_before_the_numbers) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "bearing na4908 --law hertz --law iso --set bearing.rollers=40");
  BOOST_TEST(ended.exit_code == 0);
  const auto said =
      ended.out.find("\n  hertz, iso: rollers over the most that fit = 1.212 is above 1: the rollers overlap\n");
  BOOST_TEST(said < ended.out.find("displacement"), ended.out);
  BOOST_TEST(ended.out.find("overlap", said + 100) == std::string::npos, ended.out);
}

// On 64 intervals the Couette film is 0.9 % from that of 512: two digits are known, and no error is.
BOOST_AUTO_TEST_CASE(a_number_without_an_error_says_so_and_has_three_digits) {
  const test::Folder folder;
  const auto coarse = test::ehd_run(folder, "solve --M 20 --L 10 --nodes 64");
  BOOST_TEST(coarse.out.find("0.103 (error unknown)  5.23 (error unknown)\n") != std::string::npos);
  const auto dry = test::ehd_run(folder, "solve dry-steel");  // a closed form
  BOOST_TEST(dry.out.find("(error unknown)") == std::string::npos);
  BOOST_TEST(dry.out.find("-0.596573590279973") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(json_on_standard_output_stands_alone_and_is_read_back) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve --M 5 --L 5 --inlet -4 --tolerance 1e-2 --json -");
  BOOST_TEST(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["status"] == "converged");
  BOOST_TEST(result["solver"] == "fast");
  BOOST_TEST(!result.contains("case"));
  EHD_CHECK(result["film"]["minimum"]["error"].get<double>(), Tolerance::required(1e-2, "the tolerance asked for"));
}

BOOST_AUTO_TEST_CASE(a_solve_that_does_not_converge_exits_with_1_and_says_so_beside_the_json) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve own-moes-20-10 --max-iterations 1 --json -");
  BOOST_TEST(ended.exit_code == 1);
  BOOST_TEST(ended.error_lines() == 1);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["status"] != "converged");
}

BOOST_AUTO_TEST_CASE(a_grid_that_cannot_see_the_inlet_zone_is_no_solution) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve own-moes-1000-10 --solver fast.uniform --nodes 256 --json -");
  BOOST_TEST(ended.exit_code == 1);
  BOOST_TEST(json::parse(ended.out)["status"] != "converged");
}

BOOST_AUTO_TEST_CASE(wisdom_is_written_read_again_and_refused_where_it_is_none) {
  const test::Folder folder;
  const auto wisdom = folder.path() / "wisdom.txt", text = folder.path() / "text.txt";
  const auto solve = [&](const std::string& rest) {
    return test::ehd_run(folder, "solve own-moes-5-5 --tolerance 1e-2 --json - " + rest);
  };
  const auto plain = solve(""), first = solve("--wisdom " + wisdom.string()),
             second = solve("--wisdom " + wisdom.string());
  for (const auto* ended : {&plain, &first, &second}) BOOST_REQUIRE(ended->exit_code == 0);
  BOOST_TEST(std::filesystem::file_size(wisdom) > 0u);
  const double film = json::parse(plain.out)["film"]["central"]["hertz"];
  const double again = json::parse(second.out)["film"]["central"]["hertz"];
  // Other plans round otherwise; Newton stops at the same step and passes a small part of it on.
  EHD_CHECK(error(again, film), verification::Tolerance::round_off(1e4, 1e2));
  std::ofstream(text) << "no wisdom\n";
  for (const auto& name : {text, folder.path()}) {
    const auto refused = solve("--wisdom " + name.string());
    BOOST_TEST(refused.exit_code == 2);
    BOOST_TEST(refused.error_lines() == 1);
  }
}

BOOST_AUTO_TEST_CASE(the_error_of_a_film_is_the_sum_of_its_parts) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve own-moes-5-5-flooded --tolerance 1e-3 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json film = json::parse(ended.out)["film"];
  for (const char* which : {"minimum", "central"}) {
    const json& parts = film[which]["errors"];
    const double sum =
        parts["discretisation"].get<double>() + parts["iteration"].get<double>() + parts["truncation"].get<double>();
    BOOST_TEST(parts["truncation"].get<double>() > 0);
    BOOST_TEST(parts["iteration"].get<double>() > 0);
    EHD_CHECK(error(sum, film[which]["error"].get<double>()), verification::Tolerance::round_off(4));
  }
}

BOOST_AUTO_TEST_CASE(files_are_written_beside_the_table) {
  const test::Folder folder;
  const auto result = folder.path() / "result.json", profile = folder.path() / "profile.csv";
  const auto ended = test::ehd_run(folder, fmt::format("solve own-moes-5-5 --tolerance 1e-2 --json {} --profile {}",
                                                       result.string(), profile.string()));
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.out.find("film.minimum") != std::string::npos);
  BOOST_TEST(json::parse(test::read(result))["case"] == "own-moes-5-5");
  BOOST_TEST(test::read(profile).starts_with(
      "X [x/b],P [p/p_H],H [h R/b^2],rho [rho/rho_0],eta [eta/eta_0],H_error [relative],P_unresolved [maximum not "
      "known; 1: cut at 1.5],P_error [relative in L2]\n"));
}

BOOST_AUTO_TEST_CASE(the_total_time_holds_the_planning_that_wall_s_leaves_out) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve own-moes-5-5 --tolerance 1e-2 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json cost = json::parse(ended.out)["cost"];
  const double wall_s = cost["wall_s"], planning_s = cost["planning_s"];
  BOOST_TEST(wall_s > 0);
  BOOST_TEST(planning_s > 0);
  EHD_CHECK(error(cost["total_s"], wall_s + planning_s), verification::Tolerance::round_off(2));
}

BOOST_AUTO_TEST_CASE(a_dry_case_is_exact_and_has_no_groups_and_no_film) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "solve dry-steel --json -");
  BOOST_TEST(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["status"] == "converged");
  BOOST_TEST(!result["groups"].contains("M"));
  BOOST_TEST(!result["film"].contains("minimum"));
  EHD_CHECK(error(result["film"]["offset"]["hertz"], -0.5965736), Tolerance::published_digits("0.5965736"));
  BOOST_TEST(result["cost"]["fft_plans"] == 0);
}

BOOST_AUTO_TEST_CASE(a_wrong_command_line_is_refused) {
  const test::Folder folder;
  const std::string bad =
      folder
          .write("bad.toml",
                 "id = \"bad\"\nversion = 1\nx = 2\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = "
                 "1e5\nreduced_radius_m = 0.01\nreduced_modulus_Pa = 2e11\n")
          .string();
  const Rows rows{
      {"frobnicate", "frobnicate"},
      {"--frobnicate", "frobnicate"},
      {"solve", "is missing"},
      {"solve no-such-case",
       "there is no such case; allowed is a path to a case file, or an id that `ehd cases` or `ehd "},
      {"solve " + bad, "bad.toml:3: x = 2: is unknown; allowed is"},
      {"solve " + folder.path().string(), "is a directory"},
      {"solve own-moes-5-5 own-moes-20-10",
       "own-moes-20-10: is one argument too many; allowed is one CASE; ehd solve "},
      {"export law na4908 na4908", "na4908: is one argument too many; allowed is WHAT, CASE; ehd export --help shows"},
      {"verify own-moes-5-5", "own-moes-5-5: is one argument too many; allowed is options alone; ehd verify --help"},
      {"solve own-moes-5-5 --M 3 --L 4", "exclude each other"},
      {"solve own-moes-5-5 --frobnicate", "ehd: --frobnicate: unknown; ehd solve --help shows what is allowed"},
      {"solve own-moes-5-5 --tolerence 1e-3", "ehd: --tolerence: unknown; did you mean --tolerance?"},
      {"solve own-moes-5-5 --tolerence=1e-3", "ehd: --tolerence: unknown; did you mean --tolerance?"},
      {"solv own-moes-5-5", "ehd: solv: unknown; did you mean solve?"},
      {"frobnicate --help", "ehd: frobnicate: unknown; ehd --help shows what is allowed"},
      {"frobnicate solve", "ehd: frobnicate: stands before solve; allowed is behind it, ehd solve --help shows what"},
      {"--tolerance 1e-3 solve own-moes-5-5", "--tolerance: stands before solve; allowed is behind it"},
      {"help frobnicate", "ehd: help: unknown; ehd --help shows what is allowed"},
      {"-- solve own-moes-5-5", "ehd: --: is no subcommand; ehd --help shows what is allowed"},
      {"solve ''", "a CASE has a name; allowed is"},
      {"verify --case na4908 --rung 1", "nothing to verify for --rung 1 --case na4908; allowed here is --rung "},
      {"atlas --tolerance 1e-4", "--tolerance = 1e-4: may leave fewer digits than stand in cases/atlas; allowed is"},
      {"atlas --time-limit 1",
       "--time-limit = 1: may leave fewer digits than stand in cases/atlas; allowed is another"},
      {"compare own-barus-5-5 --external 'mine=run {tol} {out}'",
       "has no {case}, {tol} is unknown, did you mean {tolerance}?; allowed is NAME='command {case} {out} "
       "{tolerance}'"},
      {"compare own-barus-5-5 --external \"mine=awk '{print}' {out}\"", "has no {case}; allowed is NAME="},
      {"compare own-barus-5-5 --external 'my solver=run {case} {out}'",
       "has a name with other characters than letters"},
      {"solve own-moes-5-5 --tolerance 1e-3 --nodes 64", "exclude each other"},
      {"solve own-moes-5-5 --tolerance-central 1e-3 --tolerance 1e-3",
       "--tolerance-central and --tolerance exclude each other"},
      {"solve own-moes-5-5 --tolerance-minimum 1e-3 --nodes 64", "--tolerance-minimum and --nodes exclude each other"},
      {"solve own-moes-5-5 --tolerance-central 0", "--tolerance-central"},
      {"solve own-moes-5-5 --quantity film.minimum --tolerance-central 1e-6",
       "--tolerance-central = 1e-6: is of a film that the chosen film.minimum does not need; leave it "
       "out, or add --quantity film.central"},
      {"plan own-moes-5-5 --quantity film.couette --tolerance-minimum 1e-6 --tolerance-central 1e-6",
       "--tolerance-minimum = 1e-6: is of a film that the chosen film.couette does not need"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(an_option_outside_its_range_is_refused) {
  const test::Folder folder;
  const Rows rows{
      {"solve own-moes-5-5 --solver magic", "is unknown; allowed is reference"},
      {"solve own-moes-5-5 --tolerance 0", "is out of range; allowed is a number, more than 0 to 1"},
      {"solve own-moes-5-5 --tolerance -1e-3", "is out of range"},
      {"solve own-moes-5-5 --tolerance 1.5", "is out of range; allowed is a number, more than 0 to 1"},
      {"compare own-moes-5-5 --tolerance 1.5", "is out of range; allowed is a number, more than 0 to 1"},
      {"solve own-moes-5-5 --tolerance abc", "is not a number; allowed is a number, more than 0 to 1"},
      {"solve own-moes-5-5 --tolerance nan", "is not finite"},
      {"solve own-moes-5-5 --tolerance inf", "is not finite"},
      {"solve own-moes-5-5 --tolerance 1e999", "is out of range"},
      {"solve own-moes-5-5 --tolerance", "--tolerance"},
      {"solve own-moes-5-5 --tolerance 1e-3 --tolerance 1e-4", "--tolerance"},
      {"solve own-moes-5-5 --nodes 15", "is out of range; allowed is an integer, 16 to 2147483647"},
      {"solve own-moes-5-5 --nodes 64.5", "is not an integer"},
      {"solve own-moes-5-5 --nodes 99999999999", "is out of range; allowed is an integer, 16 to 2147483647"},
      {"solve own-moes-5-5 --nodes 2000000000 --solver reference", "would not fit into memory"},
      {"solve own-moes-5-5 --quantity film.maximum", "is unknown; did you mean film.minimum? allowed is film.minimum"},
      {"solve own-moes-5-5 --max-iterations 0", "is out of range"},
      {"solve own-moes-5-5 --time-limit 0", "is out of range"},
      {"bearing na4908 --time-limit-total 0", "is out of range; allowed is a number, more than 0"},
      {"verify --time-limit-total x", "is not a number"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_written_or_is_the_case_is_refused) {
  const test::Folder folder;
  const std::string dry = dry_case(folder, "dry");
  const std::string dry_otherwise = (folder.path() / "." / "dry.toml").string();
  const std::string fluid =
      folder
          .write("fluid.toml", heading("fluid") +
                                   "[moes]\nM = 5.5\nL = 4.5\n[lubricant]\nviscosity = \"barus\"\n"
                                   "density = \"incompressible\"\n[domain]\ninlet = -4.0\n")
          .string();
  const std::string absent = (folder.path() / "absent" / "file").string();
  const Rows rows{
      {"solve own-moes-5-5 --json " + absent, "cannot be written"},
      {"solve own-moes-5-5 --profile " + folder.path().string(), "it is a directory"},
      {"solve own-moes-5-5 --profile -", "--profile = -: is no file; allowed is a file's name"},
      {"solve own-moes-5-5 --wisdom -", "--wisdom = -: is no file; allowed is a file's name"},
      {"solve own-moes-5-5 --json a --profile a", "--profile = a: is the same file as --json"},
      {"solve own-moes-5-5 --json a.json --profile ./a.json", "--profile = ./a.json: is the same file as --json"},
      {fmt::format("solve {} --json {}", dry, dry), "is the same file as the case"},
      {fmt::format("solve {} --profile {}", dry, dry_otherwise), "is the same file as the case"},
      {fmt::format("compare {} --json {}", fluid, fluid), "is the same file as the case fluid"},
      {fmt::format("plan {} --json {}", dry, dry), "is the same file as the case"},
      {"solve own-moes-5-5 --json ''", "cannot be written"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(a_contact_stated_by_options_is_refused_like_a_case) {
  const test::Folder folder;
  const Rows rows{
      {"solve --M 20", "--L is missing"},
      {"solve --M 20 --L 10 --json", "ehd: --json: has no value; ehd solve --help shows what is allowed"},
      {"solve --L 20", "--M is missing"},
      {"solve --M twenty --L 10", "is not a number"},
      {"solve --M 1e308 --L 10", "is out of range"},
      {"solve --M -5 --L 10", "ehd: --M = -5: is out of range; allowed is a number, 0.001 to 1e6"},
      {"solve --M 20 --L 5e-324", "is out of range"},
      {"solve --M 20 --L 10 --inlet 0.5", "does not lie before the contact"},
      {"solve --M 20 --L 10 --viscosity magic", "is unknown; allowed is isoviscous"},
      {"solve --M 20 --L 10 --viscosity isoviscous", "--viscosity = isoviscous: contradicts --L = 10; allowed"},
      {"solve --M 20 --L 10 --viscosity roelands", "--viscosity = roelands: needs pressures in Pa"},
      {"solve --M 20 --L 10 --viscosity roelands", "required is --alpha-per-Pa"},
      {"solve --M 20 --L 10 --viscosity roelands --alpha-per-Pa 2e-8", "required is --z, a number, 0.001 to 10"},
      {"solve --M 20 --L 10 --density dowson-higginson", "--density = dowson-higginson: needs pressures in Pa"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(wrong_usage_of_other_subcommands_is_refused) {
  const test::Folder folder;
  const Rows rows{
      {"compare", "a CASE is missing"},
      {"compare own-moes-5-5 no-such-case", "there is no such case"},
      {"compare dry-steel", "is a dry contact"},
      {"compare own-moes-5-5 --solver magic", "is unknown"},
      {"verify --random-runs 0", "--random-runs = 0: is out of range; allowed is an integer, 1 to 10000"},
      {"compare own-moes-5-5 --tolerance x", "is not a number"},
      {"cases extra", "extra"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(a_table_of_films_that_cannot_be_is_refused) {
  const test::Folder folder;
  const std::string range = " --M 10:100 --L 3:12";
  const Rows rows{
      {"export", "WHAT"},
      {"export films", "CASE"},
      {"export bearing na4908", "WHAT = bearing: is unknown; allowed is films, law"},
      {"export law na4908", "--raceway is missing; allowed is inner, outer"},
      {"export films own-moes-5-5 --M 5:6 --L 5:6 --law ehd",
       "--law = ehd: belongs to export law; allowed is without it"},
      {"export law na4908 --raceway middle", "--raceway = middle: is unknown; allowed is inner, outer"},
      {"export law na4908 --raceway inner --law hertz", "--law = hertz: has no table"},
      {"export law na4908 --raceway inner --knots 3", "--knots = 3: is out of range"},
      {"export law na4908 --raceway inner --format xml", "--format = xml: is unknown; allowed is csv, json, c, matlab"},
      {"export law na4908 --raceway inner --M 2:3", "--M = 2:3: belongs to export films"},
      {"export films own-moes-5-5 --raceway inner --M 2:3 --L 2:3", "--raceway = inner: belongs to export law"},
      {"export law own-moes-5-5 --raceway inner", "this is a contact; allowed is a bearing case"},
      {"export law harris-209 --raceway inner", "[lubricant]: is missing; law ehd needs it"},
      {"export films own-moes-5-5 --M 10:100", "--L is missing; allowed is LOW:HIGH with 0 <= LOW < HIGH <= 100"},
      {"export films own-moes-5-5 --L 3:12", "--M is missing; allowed is LOW:HIGH with 0.001 <= LOW < HIGH <= 1e6"},
      {"export films own-moes-5-5 --M 10 --L 3:12", "--M = 10: is no range"},
      {"export films own-moes-5-5 --M 10:9 --L 3:12", "--M = 10:9: is empty"},
      {"export films own-moes-5-5 --M 0:9 --L 3:12", "--M = 0:9: is no range"},
      {"export films own-moes-5-5 --M 1:nan --L 3:12", "--M = 1:nan: is no range"},
      {"export films own-moes-5-5 --M 1:9 --L 3:101", "--L = 3:101: is no range"},
      {"export films own-moes-5-5 --format xml" + range, "--format = xml: is unknown; allowed is csv, json, c"},
      {"export films own-moes-5-5 --tolerance 0" + range, "--tolerance = 0: is out of range"},
      {"export films own-moes-5-5 --max-solves 56" + range,
       "--max-solves = 56: is out of range; allowed is an integer, 57 to"},
      {"export films own-moes-5-5 --output ''" + range, "the name is empty"},
      {"export films dry-steel" + range, "is dry and has no film; allowed is a case with [lubricant]"},
      {"export films own-isoviscous-10-0" + range, "viscosity = \"isoviscous\": has no film that depends on L"},
      {"export films no-such-case" + range, "there is no such case"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(a_table_of_films_goes_to_standard_output_or_into_a_file) {
  const test::Folder folder;
  const std::string films = "export films na4908 --M 20:40 --L 6:9 --tolerance 1e-2 --format ";
  const auto printed = test::ehd_run(folder, films + "json");
  BOOST_TEST(printed.exit_code == 0);
  BOOST_TEST(printed.err == "");
  const json table = json::parse(printed.out);
  BOOST_TEST(table["schema"] == film_table_schema);
  BOOST_TEST(table["case"] == "na4908");
  BOOST_TEST(table["status"] == "converged");
  BOOST_TEST(table["lubricant"]["z"].get<double>() > 0);  // from eta_0: the case states alpha alone
  BOOST_TEST(table["lubricant"]["alpha_per_Pa"] == 2e-8);
  const auto file = folder.path() / "films.c";
  const auto written = test::ehd_run(folder, fmt::format("{}c --output '{}'", films, file.string()));
  BOOST_TEST(written.exit_code == 0);
  BOOST_TEST(written.out.find("stated error") != std::string::npos);
  BOOST_TEST(test::read(file).find("int ehd_na4908_film(") != std::string::npos);
  BOOST_TEST(test::read(file).find("alpha_per_Pa = 2e-8, z = 0.68") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_table_of_films_stands_beside_the_formulas) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "maps --table");
  BOOST_TEST(ended.exit_code == 0);
  std::istringstream lines(ended.out);
  int of_table = 0, of_formulas = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("film.") == std::string::npos) continue;
    const double largest = std::stod(line.substr(line.rfind(' ')));
    const bool table = line.find("this table") != std::string::npos;
    (table ? of_table : of_formulas) += 1;
    BOOST_TEST((table ? largest <= 0.01 : largest > 1), line);  // percent; asked for 1e-4
  }
  BOOST_TEST(of_table == 3);
  BOOST_TEST(of_formulas == 7);
  test::check_refused(folder, "maps --table --quantity film.minimum", "--table excludes");
}

BOOST_AUTO_TEST_CASE(a_table_of_films_that_misses_its_tolerance_says_by_how_much) {
  const test::Folder folder;
  // A solve needs time, and none is left.
  const auto late = test::ehd_run(folder, "export films own-moes-5-5 --M 2:1000 --L 3:20 --time-limit-total 1e-3");
  BOOST_TEST(late.exit_code == 1);
  BOOST_TEST(late.out == "");
  BOOST_TEST(late.error_lines() == 1);
  BOOST_TEST(late.err.find("there is no table") != std::string::npos);
  const auto missed = test::ehd_run(
      folder, "export films own-moes-5-5 --M 5:60 --L 3:12 --tolerance 1e-4 --max-solves 114 --format json");
  BOOST_TEST(missed.exit_code == 1);
  BOOST_TEST(missed.error_lines() == 1);
  BOOST_TEST(missed.err.find("tolerance-not-met: the stated error of ") != std::string::npos);
  const json table = json::parse(missed.out);
  BOOST_TEST(table["status"] == "tolerance-not-met");
  double worst = 0;
  for (const auto& film : table["films"]) worst = std::max(worst, film["stated_error"].get<double>());
  BOOST_TEST(worst > 1e-4);
}

BOOST_AUTO_TEST_CASE(an_exported_law_states_its_oil_with_the_numbers_that_follow) {
  const test::Folder folder;
  const auto law = test::ehd_run(folder, "export law na4908 --raceway inner --knots 4 --format json");
  BOOST_REQUIRE(law.exit_code == 0);
  const json oil = json::parse(law.out)["lubricant"];
  BOOST_TEST(oil["alpha_per_Pa"] == 2e-8);
  // z = alpha p_0/(ln eta_0 + 9.67)
  EHD_CHECK(ehd::error(oil["z"].get<double>(), 2e-8 * 1.9613e8 / (std::log(0.02) + 9.67)),
            ehd::verification::Tolerance::round_off(16));
  const auto table = test::ehd_run(folder, "export law na4908 --raceway inner --knots 4");
  BOOST_TEST(table.out.find("oil: 0.02 Pa s, roelands, dowson-higginson, alpha 2e-8 1/Pa, z 0.681246") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_table_that_misses_the_damping_says_so) {
  const test::Folder folder;
  const auto coarse = test::ehd_run(folder, "export law na4908 --raceway inner");
  BOOST_TEST(coarse.exit_code == 0);
  BOOST_TEST(coarse.err.find("misses the damping by up to 3") != std::string::npos, coarse.err);
  BOOST_TEST(coarse.error_lines() == 1);
  BOOST_TEST(test::ehd_run(folder, "export law na4908 --raceway inner --knots 200").err == "");
}

BOOST_AUTO_TEST_CASE(the_csv_of_a_bearing_numbers_the_rollers_and_is_not_there_without_any) {
  const test::Folder folder;
  const auto file = folder.path() / "loads.csv";
  const std::string rough =
      "bearing na4908 --law ehd-linear --set bearing.roughness_m=1e-7 --csv '" + file.string() + "'";
  BOOST_TEST(test::ehd_run(folder, rough).exit_code == 0);
  std::istringstream lines(test::read(file));
  std::string head, first;
  std::getline(lines, head);
  std::getline(lines, first);
  BOOST_TEST(head.ends_with(",roller,inner_lambda_ratio,outer_lambda_ratio,file"));
  BOOST_TEST(first.find(",1,3.6") != std::string::npos, first);  // 0.364 um over 0.1 um
  BOOST_TEST(first.ends_with("na4908.toml"));
  std::filesystem::remove(file);
  const auto late =
      test::ehd_run(folder, "bearing na4908 --law ehd --time-limit-total 1e-3 --csv '" + file.string() + "'");
  BOOST_TEST(late.exit_code == 1);
  BOOST_TEST(late.err.find("nothing balanced, and no CSV is written") != std::string::npos);
  BOOST_TEST(!std::filesystem::exists(file));
}

BOOST_AUTO_TEST_CASE(a_bearing_or_a_plan_that_lacks_something_is_refused) {
  const test::Folder folder;
  const std::string resting =
      folder
          .write("resting.toml",
                 heading("resting") +
                     "[bearing]\nrollers = 21\npitch_diameter_m = 0.053\nroller_diameter_m = 0.005\nlength_m = 0.121\n"
                     "clearance_m = 2.5e-6\ndensity_kg_per_m3 = 7850.0\nrotating = \"outer\"\n[operation]\n"
                     "speed_rpm = 0.0\nradial_load_N = 50.0e3\n[material]\nmodulus_Pa = 2.06e11\npoisson = 0.3\n"
                     "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\nviscosity_Pa_s = 0.02\n"
                     "alpha_per_Pa = 2.0e-8\n")
          .string();
  const Rows rows{
      {"solve na4908", "na4908.toml:"},
      {"plan", "CASE"},
      {"plan no-such-case", "there is no such case"},
      {"plan own-moes-5-5 --law hertz", "--law belongs to a bearing"},
      {"plan na4908 --solver fast", "belong to a contact"},
      {"plan na4908 --law magic", "is unknown"},
      {"plan harris-209 --law ehd", "is missing; law ehd needs it"},
      {"plan " + resting, "resting.toml:14: speed_rpm = 0.0: leaves the rings at rest"},
      {"bearing " + resting, "resting.toml:14: speed_rpm = 0.0: leaves the rings at rest"},
      {"bearing na4908 --law tripp", "[bearing] ring_thickness_m: is missing; law tripp needs it at the outer raceway"},
      {"plan na4908 --law houpert", "allowed without: hertz, iso, lundberg"},
      {"bearing na4908 --law hertz --form cubic", "--form = cubic: is unknown; allowed is plane, radial"},
      {"bearing na4908 --law hertz --frequency 50", "--frequency = 50: belongs to --dynamic; allowed is both"},
      {"bearing na4908 --law hertz --dynamic --frequency -1", "--frequency = -1: is out of range"},
      {"bearing na4908 --law hertz --dynamic --frequency nan", "--frequency = nan: is "},
      {"bearing na4908 --law hertz --cage-positions 1",
       "--cage-positions = 1: is out of range; allowed is an integer, 2 to 10000"},
      {"plan own-moes-5-5 --nodes 2000000000 --solver reference", "would not fit into memory"},
  };
  check_refused(folder, rows);
}

BOOST_AUTO_TEST_CASE(without_a_solution_no_profile_is_written_and_that_is_said) {
  const test::Folder folder;
  const auto profile = folder.write("profile.csv", "old");
  const auto ended =
      test::ehd_run(folder, "solve own-moes-20-10 --max-iterations 1 --json - --profile " + profile.string());
  BOOST_TEST(ended.exit_code == 1);
  const json result = json::parse(ended.out);
  BOOST_TEST(ended.error_lines() == 1);
  const bool written = test::read(profile) != "old";
  const bool said = ended.err.find("no profile is written") != std::string::npos;
  BOOST_TEST(written != said);
  if (result["status"] == "diverged") BOOST_TEST(said);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_judged_is_skipped_with_a_reason_and_exit_code_0) {
  const test::Folder folder;
  const std::string dry = dry_case(folder, "silent");
  for (const std::string& selection : {std::string("--case venner1991-waiting"), "--case " + dry}) {
    const auto ended = test::ehd_run(folder, "verify " + selection);
    BOOST_TEST_CONTEXT("ehd verify " << selection) {
      BOOST_TEST(ended.exit_code == 0);
      BOOST_TEST(ended.err == "");
      BOOST_TEST(ended.out.find("  skipped  ") != std::string::npos);
      BOOST_TEST(ended.out.find("nothing could be judged: ") != std::string::npos);
    }
  }
}

// x_0 of the default datum is not finite there. ehd_run finds null in any JSON.
BOOST_AUTO_TEST_CASE(a_datum_that_is_not_finite_is_absent) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder,
                                   "bearing na4908 --set material.modulus_Pa=1e15 "
                                   "--set lubricant.viscosity=isoviscous --law ehd --json -");
  const json result = json::parse(ended.out);
  BOOST_TEST(result["law"] == "ehd");
  BOOST_TEST(result["datum"].empty());
}

// L does not depend on the load: no contact of this bearing can be solved.
BOOST_AUTO_TEST_CASE(an_oil_too_thick_for_any_film_is_bad_input) {
  const test::Folder folder;
  const std::string cold = "bearing na4908 --set lubricant.viscosity_Pa_s=500";
  const auto ended = test::ehd_run(folder, cold);
  BOOST_TEST(ended.exit_code == 2);
  BOOST_TEST(ended.error_lines() == 1, ended.err);
  BOOST_TEST(
      ended.err.find("at the inner raceway L = 274.003 is out of range; allowed is 0 to 100") != std::string::npos,
      ended.err);
  BOOST_TEST(test::ehd_run(folder, cold + " --law hertz").exit_code == 0);
}

BOOST_AUTO_TEST_CASE(without_time_for_everything_what_is_finished_is_kept_and_the_rest_is_named) {
  const test::Folder folder;
  const auto bearing = test::ehd_run(folder, "bearing na4908 --law hertz --law ehd --time-limit-total 1e-6 --json -");
  BOOST_TEST(bearing.exit_code == 1);
  BOOST_TEST(bearing.error_lines() == 1, bearing.err);
  const json laws = json::parse(bearing.out);
  BOOST_TEST(laws[0]["status"] == "converged");
  BOOST_TEST(laws[1]["status"] == "limit-reached");
  const std::string output = (folder.path() / "out").string();
  const auto verify = test::ehd_run(folder, "verify --quick --rung 1 --time-limit-total 1e-6 --output " + output);
  BOOST_TEST(verify.exit_code == 1);
  BOOST_TEST(verify.error_lines() == 1, verify.err);
  BOOST_TEST(verify.err.find("topics were not run") != std::string::npos, verify.err);
  BOOST_TEST(json::parse(test::read(output + "/results.json"))["summary"]["not_run"] > 0);
  BOOST_TEST(test::ehd_run(folder, "report " + output).exit_code == 0);
}

BOOST_AUTO_TEST_CASE(a_refused_verify_leaves_no_folder) {
  const test::Folder folder;
  const auto above = folder.path() / "out";
  const std::string output = " --output " + (above / "verify").string();
  for (const char* selection : {"--case no-such-case", "--rung 7 --case own-moes-5-5", "--rung 12"}) {
    BOOST_TEST(test::ehd_run(folder, "verify " + (selection + output)).exit_code == 2);
    BOOST_TEST(!std::filesystem::exists(above));
  }
  BOOST_TEST(test::ehd_run(folder, "verify --rung 3" + output + "/").exit_code == 0);
  BOOST_TEST(std::filesystem::exists(above / "verify" / "results.json"));
}

BOOST_AUTO_TEST_CASE(a_file_in_the_way_of_a_folder_is_named) {
  const std::string sweep = "sweep " EHD_SOURCE_DIR "/examples/sweeps/contact-moes.toml";
  const Rows rows{{"atlas --only roelands-m1-l5-", "out/.progress"},
                  {sweep, "out/rows"},
                  {sweep + " --shard 1/2", "out/shards"},
                  {"verify --rung 3", "out"}};
  for (const auto& [arguments, name] : rows) {
    const test::Folder folder;
    const auto output = folder.path() / "out", in_the_way = folder.path() / name;
    std::filesystem::create_directories(in_the_way.parent_path());
    (void)folder.write(name, "a file");
    test::check_refused(folder, arguments + " --output " + output.string(),
                        in_the_way.string() + ": is no folder, and a folder is needed there; allowed is to move or");
    BOOST_TEST(test::read(in_the_way) == "a file");
  }
}

// A link that leads nowhere is refused by name, and stays.
BOOST_AUTO_TEST_CASE(a_link_in_the_way_of_a_folder_is_named_and_left_alone) {
  const test::Folder folder;
  const auto link = folder.path() / "link", loop = folder.path() / "loop";
  std::filesystem::create_symlink(folder.path() / "away" / "disk", link);
  std::filesystem::create_symlink("loop", loop);
  const std::string nowhere = link.string() + ": is a link to " + (folder.path() / "away" / "disk").string();
  for (const std::string command : {"verify --rung 3", "sweep " EHD_SOURCE_DIR "/examples/sweeps/contact-moes.toml"}) {
    for (const char* below : {"", "/below"})
      test::check_refused(folder, command + " --output " + link.string() + below,
                          nowhere + ", which does not exist, and a folder is needed there; allowed is to move or");
    test::check_refused(folder, command + " --output " + loop.string(),
                        loop.string() + ": is a link to loop, which cannot be followed (");
    BOOST_TEST(std::filesystem::is_symlink(link), command);
    BOOST_TEST(std::filesystem::is_symlink(loop), command);
  }
}

BOOST_AUTO_TEST_CASE(an_id_is_preferred_to_a_file_of_that_name_unless_it_is_written_as_a_path) {
  const test::Folder folder;
  (void)folder.write("dry-steel", "no case");
  const std::string here = "'" + folder.path().string() + "'";
  const std::string program = "'" + std::string(EHD_PROGRAM) + "'";
  const auto in_folder = [&](const std::string& name) {
    return std::system(fmt::format("cd {} && {} plan {} > /dev/null 2>&1", here, program, name).c_str());
  };
  BOOST_TEST(in_folder("dry-steel") == 0);
  BOOST_TEST(in_folder("./dry-steel") != 0);
}

BOOST_AUTO_TEST_CASE(help_and_version_are_printed_with_exit_code_0) {
  const test::Folder folder;
  for (const char* arguments : {"", "--help", "solve --help", "compare --help", "cases --help", "plan --help"}) {
    const auto ended = test::ehd_run(folder, arguments);
    BOOST_TEST(ended.exit_code == 0);
    BOOST_TEST(ended.err == "");
    BOOST_CHECK_MESSAGE(ended.out.find("Examples:") != std::string::npos, "no examples: ehd " << arguments);
  }
  const auto version = test::ehd_run(folder, "--version");
  BOOST_TEST(version.exit_code == 0);
  BOOST_TEST(version.out.starts_with("ehd "));
  for (const char* part : {"FFTW 3.", "\ncompiler ", "\nflags ", "\nlibraries ", "CLI11 ", "Eigen 3.", "GSL 2.", "fmt ",
                           "nlohmann_json 3.", "tomlplusplus ", "xxhash 0."})
    BOOST_CHECK_MESSAGE(version.out.find(part) != std::string::npos, part << " is not in " << version.out);
}

BOOST_AUTO_TEST_CASE(the_help_of_statements_names_every_choice_of_the_study) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "statements --help");
  for (const std::string_view choice : verification::open_choices)
    BOOST_TEST(ended.out.find(choice) != std::string::npos, choice << " is not in: " << ended.out);
}

BOOST_AUTO_TEST_CASE(help_is_at_most_a_hundred_columns_wide) {
  const test::Folder folder;
  const auto check_page = [&](const std::string& arguments) {
    const std::string page = test::ehd_run(folder, arguments).out;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);)
      BOOST_CHECK_MESSAGE(line.size() <= 100, "ehd " << arguments << ", " << line.size() << " columns: " << line);
    return page;
  };
  const std::string page = check_page("--help");
  std::istringstream list(page.substr(page.find("Subcommands:\n")));
  int subcommands = 0;
  for (std::string line; std::getline(list, line) && !line.empty();) {
    if (!line.starts_with("  ") || line[2] == ' ') continue;  // the heading, or a line that goes on
    check_page(line.substr(2, line.find(' ', 2) - 2) + " --help");
    ++subcommands;
  }
  BOOST_TEST(subcommands >= 17);
}

BOOST_AUTO_TEST_CASE(the_cases_are_listed_with_how_to_cite_them) {
  const test::Folder folder;
  const auto list = test::ehd_run(folder, "cases");
  BOOST_TEST(list.exit_code == 0);
  BOOST_TEST(list.out.find("own-moes-20-10") != std::string::npos);
  BOOST_TEST(list.out.find("Int. J. Num. Meth. Fluids 4, 377-397") != std::string::npos);
  const auto bibtex = test::ehd_run(folder, "cases --bibtex");
  BOOST_TEST(bibtex.exit_code == 0);
  BOOST_TEST(bibtex.out.find("@article{kostreva1984,") != std::string::npos);
  BOOST_TEST(bibtex.out.find("@misc{ertelgrubin,") != std::string::npos);  // a source of claims alone
  BOOST_TEST(list.out.find("biboulet-houpert-rigid") != std::string::npos);
  for (const char* kind : {"  exact  ", "  fit  ", "  computed  ", "  waiting  "})
    BOOST_CHECK_MESSAGE(list.out.find(kind) != std::string::npos, kind << "is no kind in the list");
}

BOOST_AUTO_TEST_CASE(a_plan_says_what_is_skipped_and_why) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "plan own-isoviscous-10-0 --json -");
  BOOST_TEST(ended.exit_code == 0);
  const json plan = json::parse(ended.out)["plan"];
  BOOST_TEST(plan["skipped"].dump().find("no exponential is evaluated") != std::string::npos);
  const auto bearing = test::ehd_run(folder, "plan na4908 --law hertz");
  BOOST_TEST(bearing.exit_code == 0);
  BOOST_TEST(bearing.out.find("skipped, and why") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(compare_marks_what_did_not_converge) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "compare own-moes-5-5 --solver fast --tolerance 1e-2 --tolerance 1e-15");
  BOOST_TEST(ended.exit_code == 1);
  BOOST_TEST(ended.out.find("fast*") != std::string::npos, ended.out);
  BOOST_TEST(ended.out.find("* not converged") != std::string::npos, ended.out);
}

BOOST_AUTO_TEST_CASE(solvers_are_compared_by_the_error_that_they_achieve) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "compare own-moes-5-5 --tolerance 1e-2 --tolerance 1e-3 --json -");
  BOOST_TEST(ended.exit_code == 0);
  const json comparison = json::parse(ended.out);
  BOOST_REQUIRE(comparison.size() == 1u);
  BOOST_REQUIRE(comparison[0]["runs"].size() == 4u);  // reference and fast, two tolerances each
  for (const auto& run : comparison[0]["runs"]) {
    const double tolerance = run["tolerance"];
    EHD_CHECK(run["achieved_error"]["film.minimum"].get<double>(),
              Tolerance::required(tolerance, "interface.md: --tolerance T asks for an error <= T"));
    EHD_CHECK(run["achieved_error"]["film.central"].get<double>(),
              Tolerance::required(tolerance, "interface.md: --tolerance T asks for an error <= T"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
