// SPDX-License-Identifier: GPL-3.0-or-later
// Stating a case: --set, standard input, ehd new, ehd convert.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;
using nlohmann::json;

namespace {

/// The stiffness xx of a law in motion and its bracket, from "ehd-linear 0 4.0(2)e2"; no error without a bracket.
struct Bracketed {
  double value = 0;
  std::optional<double> error;
};
Bracketed stiffness_in_motion(const std::string& out, const std::string& law) {
  const std::regex row(law + R"( +0 +([0-9.]+)(?:\(([0-9]+)\))?(?:e([0-9]+))?)");
  const std::string rows = out.substr(out.find("in motion"));
  std::smatch found;
  BOOST_REQUIRE(std::regex_search(rows, found, row));
  const std::string digits = found[1];
  const auto point = digits.find('.');
  const double unit = std::pow(10, found[3].matched ? std::stoi(found[3]) : 0);
  const double last = point == std::string::npos ? unit : unit * std::pow(10, -double(digits.size() - point - 1));
  return {std::stod(digits) * unit, found[2].matched ? std::optional(std::stoi(found[2]) * last) : std::nullopt};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_cli)

BOOST_AUTO_TEST_CASE(set_gives_one_key_another_value_and_the_result_says_so) {
  const test::Folder folder;
  const auto ended =
      test::ehd_run(folder, "solve own-moes-5-5 --set moes.M=6 --set domain.inlet=flooded --tolerance 1e-2 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["groups"]["M"] == 6);
  BOOST_TEST(result["set"]["moes.M"] == 6);
  BOOST_TEST(result["set"]["domain.inlet"] == "flooded");
  const auto stated = test::ehd_run(folder, "solve own-moes-5-5 --tolerance 1e-2 --json -");
  BOOST_TEST(!json::parse(stated.out).contains("set"));
}

BOOST_AUTO_TEST_CASE(set_gives_a_key_that_holds_a_list_another_list) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "bearing na4908 --law ehd-linear --set 'fit.load_N=[2500, 11e3]' --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST((result["set"]["fit.load_N"] == json{2500.0, 11000.0}));
  BOOST_TEST((result["fit"]["inner"]["load_N"] == json{2500.0, 11000.0}));
}

BOOST_AUTO_TEST_CASE(every_command_that_reads_a_case_takes_set) {
  const test::Folder folder;
  for (const char* arguments : {"plan own-moes-5-5 --set moes.M=7 --json -",
                                "bearing iso-6-rollers --law iso --set bearing.clearance_m=5e-6 --json -",
                                "response own-moes-5-5 --set moes.M=6 --tolerance 1e-4 --json -",
                                "compare own-moes-5-5 --set moes.M=6 --solver fast --tolerance 1e-2 --json -"}) {
    const auto ended = test::ehd_run(folder, arguments);
    BOOST_CHECK_MESSAGE(ended.exit_code == 0, arguments << ": " << ended.err);
    const json result = json::parse(ended.out, nullptr, false);
    const json& first = result.is_array() ? result[0] : result;
    BOOST_CHECK_MESSAGE(first.contains("set"), arguments);
  }
  const auto films = test::ehd_run(
      folder, "export films own-moes-5-5 --set lubricant.viscosity=isoviscous --M 5:6 --L 5:6 --tolerance 1e-2");
  BOOST_TEST(films.exit_code == 2);  // what is set is what is read
}

BOOST_AUTO_TEST_CASE(what_cannot_be_set_is_refused_with_the_nearest_key) {
  const test::Folder folder;
  const std::vector<std::pair<std::string, std::string>> rows{
      {"bearing na4908 --set bearing.clearence_m=5e-6", "did you mean clearance_m?"},
      {"bearing na4908 --set bearing.clearence_m=5e-6",
       "ehd: --set bearing.clearence_m=5e-6: is unknown in [bearing]; did you"},
      {"solve own-moes-5-5 --set title=x", "--set title=x: cannot be given another value; allowed is table.key with"},
      {"bearing na4908 --set clearance_m=5e-6", "did you mean bearing.clearance_m?"},
      {"bearing na4908 --set bearing.clearance_m", "has no value; allowed is KEY=VALUE"},
      {"bearing na4908 --set bearing.rollers=3.5", "is a number; allowed is an integer"},
      {"solve own-moes-5-5 --set moes.M=-1", "ehd: --set moes.M=-1: is negative; allowed is 0.001 to 1e6"},
      {"solve own-moes-5-5 --set moes.M=1,0e5",
       "ehd: --set moes.M=1,0e5: has a comma in a number; allowed is a point, 1.0e5"},
      {"solve --M 1,5 --L 5", "ehd: --M = 1,5: has a comma in a number; allowed is a point, 1.5"},
      {"solve --M 2 --L 5 --inlet -1,5", "ehd: --inlet = -1,5: has a comma in a number; allowed is a point, -1.5"},
      {"solve --M 2 --L 5 --tolerance 1e-3,5",
       "ehd: --tolerance = 1e-3,5: has a comma in a number; allowed is one point, before the exponent"},
      {"compare own-moes-5-5 --solver fast --tolerance 1e-2,1e-3",
       "ehd: --tolerance = 1e-2,1e-3: has a comma, and is not one number; allowed is a number, more than 0"},
      {"solve own-moes-5-5 --nodes 64,128",
       "--nodes = 64,128: has a comma, and is not one number; allowed is an integer"},
      {"solve own-moes-5-5 --set moes.M=1e1,2e1",
       "--set moes.M=1e1,2e1: has a comma, and is not one number; allowed is a number, 0.001 to 1e6"},
      {"bearing na4908 --set bearing.clearance_m", "ehd: --set bearing.clearance_m: has no value; allowed is KEY="},
      {"bearing na4908 --set =5e-6", "ehd: --set =5e-6: has no key; allowed is KEY=VALUE"},
      {"bearing na4908 --set bearing.rollers=19 --set 'bearing.rollers = 20'",
       "ehd: --set bearing.rollers = 20: sets bearing.rollers again, after --set bearing.rollers=19; allowed is each"},
      {"solve own-moes-5-5 --set moes.M=20.", "--set moes.M=20.: is no number in TOML; allowed is a number, 0.001 to"},
      {"judge -", "-: standard input is not read here; allowed is a submission"},
      {"sweep -", "-: standard input is not read here; allowed is a sweep file"},
      {"plan own-moes-5-5 --json a --json b", "ehd: --json: is given more than once; ehd plan --help shows what is"},
      {"solve own-moes-5-5 --set moes.M=[1,2]", "ehd: --set moes.M=[1,2]: is a list; allowed is a number"},
      {"solve own-moes-5-5 --set moes.M=0x1", "moes.M=0x1: is no decimal number; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set moes.M=-0b1", "moes.M=-0b1: is no decimal number; allowed is a number, 0.001 to 1e6"},
      {"bearing na4908 --set bearing.rolers=0x15",
       "bearing.rolers=0x15: is unknown in [bearing]; did you mean rollers?"},
      {"solve own-moes-5-5 --set moes.M=+1e400", "moes.M=+1e400: is out of range; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set moes.M=9223372036854775808", "is out of range; allowed is 0.001 to 1e6"},
      {"bearing na4908 --set bearing.clearance_m=+-5e-6", "+-5e-6: is a text; allowed is a number, -0.1 to 0.1"},
      {"solve --M +-5 --L 5", "ehd: --M = +-5: is not a number; allowed is a number, 0.001 to 1e6"},
      {"plan own-moes-5-5 --json ''", "ehd: \"\": cannot be written (the name is empty)"},
      {"solve own-moes-5-5 --set moes.M=1d1", "moes.M=1d1: is no number; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set moes.M=1e", "moes.M=1e: is no number; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set 'moes.M=1 000'", "moes.M=1 000: is no number; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set moes.M=", "moes.M=: is empty; allowed is a number, 0.001 to 1e6"},
      {"solve own-moes-5-5 --set 'moes.M=5 N'", "moes.M=5 N: has a unit, which belongs to the key's name"},
      {"bearing na4908 --set bearing.rollers=0x15", "is no decimal number; allowed is an integer, 3 to 400"},
      {"bearing na4908 --set bearing.rollers=9223372036854775808", "is out of range; allowed is an integer, 3 to 400"},
      {"bearing na4908 --set bearing.rollers=1,5", "has a comma in a number; allowed is a point, 1.5"},
      {"bearing na4908 --set 'fit.load_N=[2000]'", "ehd: --set fit.load_N=[2000]: "},
      {"solve own-moes-5-5 --set moes.M=1 --set moes.M=2", "allowed is each key once"},
      {"solve --M 5 --L 5 --set moes.M=1", "required is a CASE"},
      {"bearing na4908 --set operation.speed_rpm=0", "ehd: --set operation.speed_rpm=0: leaves the rings at rest"},
      {"solve own-moes-5-5 --set conditions.load_N_per_m=1",
       "ehd: --set conditions.load_N_per_m=1: states the problem again, beside [moes]"},
      {"bearing na4908 --set operation.inner_speed_rpm=1", " (with --set operation.inner_speed_rpm=1)"},
      {"bearing na4908 --set lubricant.iso_vg=46", "temperature_C: is missing; required is a number, -50 to 150 (with"},
  };
  for (const auto& [arguments, phrase] : rows) test::check_refused(folder, arguments, phrase);
  BOOST_TEST(test::ehd_run(folder, "plan own-moes-5-5 --nodes +64").exit_code == 0);
}

BOOST_AUTO_TEST_CASE(a_case_is_read_from_standard_input) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "new contact | '" EHD_PROGRAM "' solve - --tolerance 1e-2 --json -");
  BOOST_REQUIRE_MESSAGE(ended.exit_code == 0, ended.err);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["case"] == "my-contact");
  BOOST_TEST(result["lubricant"]["iso_vg"] == 68);
  BOOST_TEST(result["lubricant"]["viscosity_Pa_s"].get<double>() > 0);
  test::check_refused(folder, "solve - < /dev/null", "standard input: is empty");
  test::check_refused(folder, "solve - < /", "standard input: is a directory; allowed is a case file");
}

BOOST_AUTO_TEST_CASE(an_inlet_cut_too_near_to_the_contact_is_named_with_one_that_is_solved) {
  const test::Folder folder;
  const auto near = test::ehd_run(folder, "solve --M 20 --L 10 --inlet -1.0000001");
  BOOST_TEST(near.exit_code == 1);
  BOOST_TEST(near.err.find("cut at X = -1.0000001, too near to the contact: contacts cut at X = -1.01 and") !=
                 std::string::npos,
             near.err);
  BOOST_TEST(test::ehd_run(folder, "solve --M 20 --L 10 --inlet -1.01").exit_code == 0);
}

BOOST_AUTO_TEST_CASE(a_new_bearing_is_balanced_as_it_stands_and_never_overwritten) {
  const test::Folder folder;
  const auto file = folder.path() / "mine.toml";
  BOOST_TEST(test::ehd_run(folder, "new bearing " + file.string()).exit_code == 0);
  const std::string text = test::read(file);
  BOOST_TEST(text.find("id = \"mine\"") != std::string::npos);
  test::check_refused(folder, "new contact " + file.string(), "exists, and is never overwritten");
  BOOST_TEST(test::read(file) == text);
  const auto balanced = test::ehd_run(folder, "bearing " + file.string() + " --law hertz");
  BOOST_TEST(balanced.exit_code == 0);
  const auto two_rows = test::ehd_run(folder, "new bearing --type NN");
  BOOST_TEST(two_rows.out.find("# NN: two rows") != std::string::npos);
  BOOST_TEST(test::ehd_run(folder, "new types").out.find("NUP") != std::string::npos);
  test::check_refused(folder, "new bearing --type NM", "is unknown; allowed is NU, NJ");
  test::check_refused(folder, "new contact --type NU", "allowed is WHAT = bearing with it");
  test::check_refused(folder, "new types types.toml", "allowed is no FILE with it");
  test::check_refused(folder, "new ring", "is unknown; did you mean bearing? allowed is contact, bearing, keys");
  test::check_refused(folder, "new bearing " + (folder.path() / "mine.txt").string(), "allowed is NAME.toml");
  const std::string capital = (folder.path() / "CAPITAL.TOML").string();
  BOOST_TEST(test::ehd_run(folder, "new contact " + capital).exit_code == 0);
  BOOST_TEST(test::ehd_run(folder, "solve " + capital + " --tolerance 1e-2").exit_code == 0);
}

BOOST_AUTO_TEST_CASE(a_new_case_that_the_shell_writes_into_a_file_has_its_name) {
  const test::Folder folder;
  const std::string program = "'" EHD_PROGRAM "' ";
  for (const auto& [what, compute] :
       {std::pair{"contact", "solve --tolerance 1e-2"}, {"bearing", "bearing --law hertz"}}) {
    const std::string file = (folder.path() / fmt::format("redirected-{}.toml", what)).string();
    const auto ended =
        test::ehd_run(folder, fmt::format("new {} > '{}' && {}{} '{}'", what, file, program, compute, file));
    BOOST_TEST(ended.exit_code == 0, ended.err);
    BOOST_TEST(test::read(file).find(fmt::format("id = \"redirected-{}\"", what)) != std::string::npos);
  }
  const std::string there = "--version > /dev/null && cd '" + folder.path().string() + "' && " + program;
  for (const std::string into : {"| cat", "> case.txt; cat case.txt"})
    BOOST_TEST(
        test::ehd_run(folder, there + "new contact " + into).out.find("id = \"my-contact\"") != std::string::npos,
        into);
  for (const std::string what : {"keys", "types"})
    BOOST_TEST(test::ehd_run(folder, there + "new " + what + " > 'two words.toml'").exit_code == 0, what);
  test::check_refused(
      folder,
      "--version > /dev/null && (cd '" + folder.path().string() + "' && " + program + "new contact > 'two words.toml')",
      "the file's name without .toml is no id");
}

BOOST_AUTO_TEST_CASE(a_bearing_shows_its_summary_first_and_costs_only_with_details) {
  const test::Folder folder;
  const auto brief = test::ehd_run(folder, "bearing iso-6-rollers --law iso");
  BOOST_TEST(brief.out.find("largest roller load [N]") < brief.out.find("f_i"));
  BOOST_TEST(brief.out.find("balance error") == std::string::npos);
  const auto details = test::ehd_run(folder, "bearing iso-6-rollers --law iso --details");
  BOOST_TEST(details.out.find("balance error") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_fitted_line_has_the_same_error_without_the_law_that_it_is_fitted_to) {
  const test::Folder folder;
  const std::string bearing =
      std::string("bearing ") + EHD_SOURCE_DIR + "/examples/roller-bearing.toml --law ehd-linear";
  const auto line_of = [&](const std::string& arguments) {
    const std::string out = test::ehd_run(folder, arguments).out;
    const auto at = out.find("largest roller load");
    return out.substr(at, out.find('\n', at) - at);
  };
  const std::string alone = line_of(bearing), beside = line_of(bearing + " --law ehd");
  const std::string number = alone.substr(alone.find_last_of(' ') + 1);
  BOOST_TEST(number.find('(') != std::string::npos, alone);
  BOOST_TEST(beside.find(" " + number) != std::string::npos, beside);
}

BOOST_AUTO_TEST_CASE(one_error_is_stated_for_the_forces_of_all_rollers) {
  const test::Folder folder;
  const std::string bearing =
      std::string("bearing ") + EHD_SOURCE_DIR + "/examples/roller-bearing.toml --law ehd-linear --law ehd";
  const std::string text = test::ehd_run(folder, bearing).out;
  const json results = json::parse(test::ehd_run(folder, bearing + " --json -").out);
  const auto error_of = [](const json& result) {
    double sum_N = 0;
    for (const json& row : result["error_budget"])
      if (row["source"] != "datum") sum_N += row["any_force_N"].get<double>();
    return sum_N;
  };
  const double of_line = error_of(results[0]), of_ehd = error_of(results[1]);
  BOOST_TEST(text.find(fmt::format("\n\n  every f_i is known to {} N (ehd-linear), {} N (ehd)\n",
                                   rounded_up(of_line, 2), rounded_up(of_ehd, 2))) != std::string::npos,
             text);
  for (std::size_t j = 0; j < results[0]["rollers"].size(); ++j) {
    const auto force_N = [&](std::size_t law) { return results[law]["rollers"][j]["inner"]["force_N"].get<double>(); };
    BOOST_TEST(std::abs(force_N(0) - force_N(1)) < of_line);
  }
}

BOOST_AUTO_TEST_CASE(a_line_alone_says_that_its_distance_is_not_known) {
  const test::Folder folder;
  const std::string bearing = "bearing na4908 --law ehd-linear", note = "how far the line is off is not known";
  BOOST_TEST(test::ehd_run(folder, bearing).out.find(note) != std::string::npos);
  BOOST_TEST(test::ehd_run(folder, bearing + " --law ehd").out.find(note) == std::string::npos);
  // With this datum ehd was asked for, and finds no balance.
  const auto failed = test::ehd_run(folder, bearing + " --law ehd --set datum.law=x0 --set datum.x0_m=3e-5");
  BOOST_TEST(failed.out.find(note + ", because the law ehd has no balance\n") != std::string::npos, failed.out);
}

BOOST_AUTO_TEST_CASE(a_curve_with_a_gap_that_nothing_judged_is_not_converged) {
  const test::Folder folder;
  const std::string bearing =
      "bearing na4908 --law ehd --max-iterations 34 --set operation.radial_load_N=80000 --details";
  const auto run = test::ehd_run(folder, bearing);
  BOOST_TEST(run.exit_code == 1);
  BOOST_TEST(run.err.find("ehd: limit-reached: the limit on iterations or time ended contacts of the film curves; ") !=
                 std::string::npos,
             run.err);
  BOOST_TEST((run.out + run.err).find("between two points of a film curve") != std::string::npos, run.out + run.err);
  // Its errors are not known, so no more than three digits are shown.
  for (const char* row :
       {"displacement [um]                      8.23\n", "largest roller load [N]              1.44e4\n",
        "rolling torque [N m]                   7.84\n"})
    BOOST_TEST(run.out.find(row) != std::string::npos, row << run.out);
  BOOST_TEST(run.out.find("inf") == std::string::npos, run.out);
  // The JSON names the numbers that have no bound, so that nobody takes the sum of the others for the error.
  const json result = json::parse(test::ehd_run(folder, bearing + " --json -").out);
  BOOST_TEST(result["status"] == "limit-reached");
  int without = 0;
  for (const json& row : result["error_budget"])
    for (const char* key : {"displacement_m", "largest_force_N", "any_force_N"}) {
      const json names = row.value("unknown", json::array());
      const bool named = std::find(names.begin(), names.end(), key) != names.end();
      BOOST_TEST(named == !row.contains(key), row.dump());
      without += named;
    }
  BOOST_TEST(without > 0);
}

BOOST_AUTO_TEST_CASE(motion_whose_error_exceeds_it_is_a_dash) {
  const test::Folder folder;
  const std::string bearing = std::string("bearing ") + EHD_SOURCE_DIR + "/examples/roller-bearing.toml --law ehd";
  const std::string text = test::ehd_run(folder, bearing + " --dynamic --frequency 1e3 --frequency 1e7").out;
  std::istringstream row(text.substr(text.find("ehd         1e7")));
  const std::vector<std::string> cells(std::istream_iterator<std::string>(row), {});
  const std::vector<std::string> wanted{"ehd", "1e7", "-", "-", "-", "-", "-", "-"};  // xx, yy, xy
  BOOST_TEST(std::equal(wanted.begin(), wanted.end(), cells.begin()), text);
}

BOOST_AUTO_TEST_CASE(a_table_has_no_empty_columns) {
  const test::Folder folder;
  const auto head_of = [&](const std::string& quantity) {
    const std::string out = test::ehd_run(folder, "solve --M 20 --L 5 --quantity " + quantity).out;
    const auto at = out.find("Hertz");
    return out.substr(at, out.find('\n', at) - at);
  };
  BOOST_TEST(head_of("film.offset") == "Hertz");
  BOOST_TEST(head_of("film.minimum").find("Moes") != std::string::npos);
  BOOST_TEST(head_of("film.minimum").find("at X") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_chosen_pressure_has_a_number_or_the_solve_says_why_not) {
  const test::Folder folder;
  const auto solved = [&](const std::string& arguments) { return test::ehd_run(folder, "solve " + arguments); };
  const test::Ended without = solved("--M 5 --L 2 --quantity pressure.spike");
  BOOST_TEST(without.exit_code == 0);
  BOOST_TEST(without.out.find("pressure.spike: the pressure has no peak behind its maximum on") != std::string::npos,
             without.out);
  const std::string sharp = "--M 200 --L 15 --tolerance 1e-2";
  const test::Ended unknown = solved(sharp + " --quantity pressure.spike");
  BOOST_TEST(unknown.exit_code == 1);
  BOOST_TEST(unknown.out.find("tolerance-not-met") != std::string::npos, unknown.out);
  BOOST_TEST(unknown.out.find("pressure.spike is not known well enough") != std::string::npos, unknown.out);
  BOOST_TEST(solved(sharp).exit_code == 0);  // nobody chose the spike
  // At (2, 14) the spike is the maximum itself.
  BOOST_TEST(solved("--M 2 --L 14 --tolerance 1e-4 --quantity pressure.spike").exit_code == 1);
  const test::Ended dry = solved("dry-steel --quantity film.minimum");
  BOOST_TEST(dry.exit_code == 0);
  BOOST_TEST(dry.out.find("film.minimum does not exist in a dry contact") != std::string::npos, dry.out);
}

BOOST_AUTO_TEST_CASE(a_profile_shows_a_known_pressure_whatever_was_chosen) {
  const test::Folder folder;
  const std::string csv = (folder.path() / "p.csv").string(), json = (folder.path() / "p.json").string();
  const std::string files = " --profile " + csv + " --json " + json;
  const auto profile = [&](const std::string& chosen) {
    BOOST_TEST(test::ehd_run(folder, "solve --M 5 --L 7 --tolerance 1e-6" + files + chosen).exit_code == 0, chosen);
    return test::read(csv);
  };
  for (const char* chosen : {"", " --quantity film.minimum --quantity film.central", " --quantity pressure.spike"}) {
    BOOST_TEST((profile(chosen).find("P_unresolved") == std::string::npos), chosen);
    BOOST_TEST(nlohmann::json::parse(test::read(json))["fields"]["pressure_resolved"].get<bool>(), chosen);
  }
  BOOST_TEST(test::ehd_run(folder, "solve dry-steel --quantity approach" + files).exit_code == 0);
  BOOST_TEST(test::read(csv).find("P_unresolved") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_stiffness_of_a_fitted_law_in_motion_is_as_wrong_as_it_is_far_from_ehd) {
  const test::Folder folder;
  const std::string bearing =
      std::string("bearing ") + EHD_SOURCE_DIR +
      "/examples/roller-bearing.toml --dynamic --set operation.radial_load_N=900 --law ehd-linear";
  BOOST_TEST(!stiffness_in_motion(test::ehd_run(folder, bearing).out, "ehd-linear").error);
  const std::string both = test::ehd_run(folder, bearing + " --law ehd").out;
  const Bracketed fitted = stiffness_in_motion(both, "ehd-linear"), ehd = stiffness_in_motion(both, "ehd");
  BOOST_REQUIRE((fitted.error && ehd.error));
  BOOST_TEST(std::abs(fitted.value - ehd.value) < *fitted.error + *ehd.error, both);
  BOOST_TEST(*fitted.error > 2 * *ehd.error);
}

BOOST_AUTO_TEST_CASE(a_thin_film_of_a_roller_has_three_digits) {
  const test::Folder folder;
  const std::string slow =
      std::string("bearing ") + EHD_SOURCE_DIR + "/examples/roller-bearing.toml --set operation.speed_rpm=20 --law ehd";
  const std::string out = test::ehd_run(folder, slow).out;
  BOOST_TEST(std::regex_search(out, std::regex(R"(\n  0 +[0-9]+ +[0-9]+ +0\.00[1-9][0-9]{2}\n)")), out);
}

BOOST_AUTO_TEST_CASE(every_fault_of_the_keys_is_a_line_of_its_own) {
  const test::Folder folder;
  const auto file = folder.write("mine.toml", "[moes]\nM = 5\nLL = 5\n");
  const auto ended = test::ehd_run(folder, "solve " + file.string());
  BOOST_TEST(ended.exit_code == 2);
  // LL; id, version, title, source; L; [lubricant] with viscosity and density, [domain] with inlet
  BOOST_TEST(ended.error_lines() == 11);
  BOOST_TEST(ended.out == "");
}

BOOST_AUTO_TEST_CASE(every_wrong_value_is_a_line_of_its_own) {
  const test::Folder folder;
  const std::string heading = "id = \"mine\"\nversion = 0\ntitle = \"t\"\nsource = \"own\"\n";
  const std::string values =
      "[conditions]\nload_N_per_m = -1e5\nreduced_radius_m = \"1 cm\"\nreduced_modulus_Pa = 2.2e11\n"
      "speed_sum_m_per_s = 0\nviscosity_Pa_s = 0.02\n[lubricant]\nviscosity = \"baruss\"\n"
      "density = \"incompressible\"\nalpha_per_Pa = 2\n[domain]\ninlet = 4\n";
  const std::vector<std::pair<std::string, int>> named{{"version", 2},
                                                       {"load_N_per_m", 6},
                                                       {"reduced_radius_m", 7},
                                                       {"speed_sum_m_per_s", 9},
                                                       {"viscosity = ", 12},
                                                       {"alpha_per_Pa", 14},
                                                       {"inlet", 16}};
  const auto file = folder.write("mine.toml", heading + values);
  const auto ended = test::ehd_run(folder, "solve " + file.string());
  BOOST_TEST(ended.exit_code == 2);
  BOOST_TEST(ended.error_lines() == named.size(), ended.err);
  std::size_t last = 0;
  for (const auto& [key, line] : named) {
    const auto at = ended.err.find(fmt::format("mine.toml:{}: {}", line, key));
    BOOST_TEST(at != std::string::npos, key << " in " << ended.err);
    BOOST_TEST(at >= last, key);
    last = at;
  }
  // Beside an unknown key, wrong values are named too.
  (void)folder.write("mine.toml", heading + "colour = 3\n" + values);
  BOOST_TEST(test::ehd_run(folder, "solve " + file.string()).error_lines() == named.size() + 1);
  // A dry contact may rest: its speed of 0 is not wrong beside another fault.
  (void)folder.write("mine.toml", heading +
                                      "[conditions]\nload_N_per_m = -1\nreduced_radius_m = 1e-2\n"
                                      "reduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 0\n");
  BOOST_TEST(test::ehd_run(folder, "solve " + file.string()).error_lines() == 2u);
}

BOOST_AUTO_TEST_CASE(all_wrong_cases_and_numbers_of_a_command_are_named_at_once) {
  const test::Folder folder;
  for (const auto& [arguments, phrases] : {
           std::pair{"cases na490 own-moes-5-5 own-moes-5-6 --json",
                     std::vector{"na490: there is no such case; did you mean na4908?",
                                 "own-moes-5-6: there is no such case; did you mean own-moes-5-5?"}},
           {"bearing na490 own-moes-5-5", {"na490: there is no such case", "own-moes-5-5.toml"}},
           {"compare own-moes-5-6 na4908", {"own-moes-5-6: there is no such case", "na4908.toml"}},
           {"convert l=10 M=x Q=3",
            {"ehd: convert: l: is unknown", "ehd: M = x: is not", "ehd: convert: Q: is unknown"}},
       }) {
    const test::Ended ended = test::ehd_run(folder, arguments);
    BOOST_TEST(ended.exit_code == 2);
    BOOST_TEST(ended.out == "");
    BOOST_CHECK_MESSAGE(ended.error_lines() == static_cast<long>(phrases.size()), ended.err);
    for (const char* phrase : phrases)
      BOOST_CHECK_MESSAGE(ended.err.find(phrase) != std::string::npos, phrase << " is not in: " << ended.err);
  }
}

BOOST_AUTO_TEST_CASE(an_inlet_in_quotation_marks_is_explained) {
  const test::Folder folder;
  test::check_refused(folder, "solve own-moes-5-5 --set 'domain.inlet=\"-4\"'",
                      "is a text; a number has no quotation marks, -4; allowed is \"flooded\", or X = x/b");
  test::check_refused(folder, "solve own-moes-5-5 --set domain.inlet=floded",
                      "is unknown; did you mean flooded? allowed is \"flooded\"");
  test::check_refused(folder, "solve own-moes-5-5 --set domain.inlet=nowhere", "is unknown; allowed is \"flooded\"");
  test::check_refused(folder, "solve own-moes-5-5 --set 'domain.inlet=\"-4,5\"'", "has a comma in a number");
}

// The title of the file may say another value.
BOOST_AUTO_TEST_CASE(the_title_says_what_is_changed) {
  const test::Folder folder;
  const auto ended =
      test::ehd_run(folder, "solve own-moes-20-10 --tolerance 1e-2 --set domain.inlet=-6 --set moes.M=2e1");
  BOOST_TEST(ended.out.starts_with("own-moes-20-10: Moderate load, Roelands, compressible, inlet cut at X = -4 "
                                   "(changed: domain.inlet = -6, moes.M = 2e1)\n"),
             ended.out);
  BOOST_TEST(ended.out.find("(published fits for flooded inlets, for comparison only") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(near_misses_of_options_commands_and_cases_are_named) {
  const test::Folder folder;
  test::check_refused(folder, "solve own-moes-5-5 --tolerence 1e-3", "--tolerence: unknown; did you mean --tolerance?");
  test::check_refused(folder, "bear na4908", "did you mean bearing?");
  test::check_refused(folder, "solve own-moes-5-6", "did you mean own-moes-5-5?");
}

BOOST_AUTO_TEST_CASE(near_misses_of_words_are_named) {
  const test::Folder folder;
  for (const auto& [arguments, says] :
       {std::pair{"solve own-moes-5-5 --solver fst", "--solver = fst: is unknown; did you mean fast? allowed is"},
        {"bearing na4908 --law ehdlinear", "--law = ehdlinear: is unknown; did you mean ehd-linear? allowed is"},
        {"solve steel-roller --set lubricant.viscosity=baruss", "is unknown; did you mean \"barus\"? allowed is"},
        {"new baering", "WHAT = baering: is unknown; did you mean bearing? allowed is contact, bearing, keys"},
        {"export film own-moes-5-5", "export: WHAT = film: is unknown; did you mean films? allowed is films, law"},
        {"export lw na4908", "export: WHAT = lw: is unknown; did you mean law? allowed is films, law"},
        {"export law na4908 --raceway iner",
         "--raceway = iner: is unknown; did you mean inner? allowed is inner, outer"},
        {"bearing na4908 --form plan", "--form = plan: is unknown; did you mean plane? allowed is plane, radial"},
        {"export films own-moes-5-5 --M 1:9 --L 3:12 --format jsn", "did you mean json?"},
        {"bench --part coste", "--part = coste: is unknown; did you mean cost? allowed is"},
        {"solve --M 20 --L 10 --density dowson-higinson", "did you mean dowson-higginson?"},
        {"bearing na4908 --set bearing.load_N=1e4", "did you mean operation.radial_load_N (radial load F_r)?"},
        {"convert l=10", "l: is unknown; did you mean L?"},
        {"convert m=20 L=10",
         "m: is unknown; did you mean M? allowed is NAME=NUMBER with a name out of M, L, lambda, alpha_p_H, W, U_mean, "
         "G"},
        {"convert u=1e-11", "u: is unknown; did you mean U_mean (Dowson and Hamrock: eta_0 u_s/(2E'R), mean speed)?"},
        {"convert Q=20",
         "Q: is unknown; allowed is NAME=NUMBER with a name out of M, L, lambda, alpha_p_H, W, U_mean, G"},
        {"solve --m 20 --L 10", "--m: unknown; did you mean --M?"}})
    test::check_refused(folder, arguments, says);
}

BOOST_AUTO_TEST_CASE(alpha_of_nothing_is_refused_with_what_is_allowed) {
  const test::Folder folder;
  test::check_refused(folder, "solve steel-roller --set lubricant.alpha_per_Pa=0",
                      "p_0; allowed is a number above 0, or viscosity = \"isoviscous\"");
}

BOOST_AUTO_TEST_CASE(a_contact_is_converted_there_and_back) {
  const test::Folder folder;
  const auto there = test::ehd_run(folder, "convert M=20 L=10 --json -");
  BOOST_REQUIRE(there.exit_code == 0);
  const json groups = json::parse(there.out);
  BOOST_TEST(!groups.contains("W"));
  const auto back = test::ehd_run(folder, fmt::format("convert lambda={} alpha_p_H={} --json -",
                                                      groups["lambda"].dump(), groups["alpha_p_H"].dump()));
  EHD_CHECK(error(json::parse(back.out)["L"].get<double>(), 10), verification::Tolerance::round_off(64, 30));
  const auto table = test::ehd_run(folder, "convert M=20 L=10");
  BOOST_TEST(table.out.find("not fixed by these numbers: W, U_mean") != std::string::npos);
  test::check_refused(folder, "convert M=20 lambda=1",
                      "lambda: the numbers before it fix it already, at 0.00925275; allowed is without one of these");
  BOOST_TEST(json::parse(there.out)["M"].dump() == "20.0");  // as stated, not through logarithms
  const auto in_si = test::ehd_run(folder,
                                   "convert load_N_per_m=2e5 reduced_radius_m=0.01 reduced_modulus_Pa=2e11 "
                                   "speed_sum_m_per_s=4 viscosity_Pa_s=0.05 alpha_per_Pa=2e-8");
  BOOST_TEST(in_si.out.find("eta_0 u_s\n") != std::string::npos, in_si.out);
  test::check_refused(folder, "convert U=1e-11", "did you mean U_mean (Dowson and Hamrock: ");
  test::check_refused(folder, "convert M", "has no value");
  BOOST_TEST(json::parse(test::ehd_run(folder, "convert M=20 L=0 --json -").out)["alpha_p_H"] == 0.0);
  test::check_refused(folder, "convert M=0 L=10", "M = 0: is out of range");
  test::check_refused(folder, "convert M=x", "is not a number");
}

BOOST_AUTO_TEST_SUITE_END()
