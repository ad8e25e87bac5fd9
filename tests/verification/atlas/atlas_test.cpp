// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/atlas.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/content_hash.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/store.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"
#include "tests/verification/atlas/made_atlas.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(atlas_atlas)

using namespace made_atlas;

BOOST_AUTO_TEST_CASE(a_run_writes_a_table_and_cases_that_agree) {
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 6);
  BOOST_TEST(result.left_over.empty());
  const AtlasTable table = read_atlas_table(request.folder / "atlas.csv");
  BOOST_REQUIRE(table.rows.size() == 6u);
  for (std::size_t i = 0; i < 6; ++i) BOOST_TEST(table.rows[i].at("id") == request.points[i].id());
  BOOST_TEST(atlas_files(request.folder).size() == 6u);
  BOOST_TEST(atlas_disagreements(request.folder).empty());
  BOOST_TEST(test::read(request.folder / "digits.txt") == digits_text(table));
  BOOST_TEST(digits_text(table).find("1000") != std::string::npos);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(request.folder))
    BOOST_TEST(entry.path().string().find(".partial") == std::string::npos);
  const std::string summary = human_summary(result);
  for (const char* text : {"6 points, 6 solved now", "6 with 9 digits or more", "0 without", "1 are numerical tests"})
    BOOST_TEST(summary.find(text) != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(an_interrupted_run_goes_on_with_what_is_missing) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  request.threads = 1;
  fake.fails_at = 4;
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), std::runtime_error);
  BOOST_TEST(!std::filesystem::exists(request.folder / "atlas.csv"));
  fake.fails_at = 0;
  fake.solves = 0;
  std::size_t reused = 0, calls = 0;
  request.progress = [&](std::size_t done, std::size_t all, const AtlasRecord&, bool old) {
    BOOST_TEST(done == ++calls);
    BOOST_TEST(all == 6u);
    reused += old ? 1 : 0;
  };
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 3);
  BOOST_TEST(reused == 3u);
  BOOST_TEST(calls == 6u);
  BOOST_TEST(atlas_disagreements(request.folder).empty());

  // Once more: nothing to solve, and nothing is written.
  const std::string csv = test::read(request.folder / "atlas.csv");
  const auto written = std::filesystem::last_write_time(request.folder / "atlas.csv");
  (void)run_atlas(request_in(folder), fake.solver());
  BOOST_TEST(fake.solves == 3);
  BOOST_TEST(test::read(request.folder / "atlas.csv") == csv);
  BOOST_TEST((std::filesystem::last_write_time(request.folder / "atlas.csv") == written));
}

BOOST_AUTO_TEST_CASE(a_record_holds_until_the_question_or_the_solver_changes) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  const auto solves_of = [&](const AtlasRequest& asked, const RegisteredSolver& solver) {
    fake.solves = 0;
    (void)run_atlas(asked, solver);
    return fake.solves.load();
  };
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  BOOST_TEST(solves_of(request, fake.solver()) == 0);
  request.time_limit_s = 60;
  BOOST_TEST(solves_of(request, fake.solver()) == 0);  // none had run out of time
  request.tolerance = 1e-6;
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  request.tolerance = {};
  request.fresh = true;
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  request.fresh = false;
  // One damaged record, one that stands in another's place.
  {
    std::vector<HashNumber> keys;
    for (const AtlasPoint& point : request.points) keys.push_back(hash_number(content_hash(point.id())).value());
    Journal records(request.folder / ".progress/films", {.owner = "atlas films"}, keys, false);
    records.add(content_hash(request.points[0].id()), "{");
    records.add(content_hash(request.points[5].id()), records.row(content_hash(request.points[4].id())));
  }
  BOOST_TEST(solves_of(request, fake.solver()) == 2);
  BOOST_TEST(solves_of(request, fake.solver()) == 0);
  // Another solver: its solves differ in one bit.
  RegisteredSolver other = fake.solver();
  other.solve = [solve = other.solve](const Problem& problem, const Request& asked) {
    Solution solution = solve(problem, asked);
    double& film = solution.observables.at(Quantity::film_minimum).value;
    film = std::nextafter(film, 1e9);
    return solution;
  };
  BOOST_TEST(solves_of(request, other) == 6);
}

BOOST_AUTO_TEST_CASE(a_point_that_ran_out_of_time_is_solved_again_with_more) {
  const test::Folder folder;
  Fake fake;
  RegisteredSolver slow = fake.solver();
  slow.solve = [solve = slow.solve](const Problem& problem, const Request& asked) {
    Solution solution = solve(problem, asked);
    if (problem.groups.M == 1000) solution.record.status = StopReason::limit_reached;
    return solution;
  };
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, slow);
  fake.solves = 0;
  request.time_limit_s = 10;
  (void)run_atlas(request, slow);
  BOOST_TEST(fake.solves == 0);
  request.time_limit_s = 100;
  (void)run_atlas(request, slow);
  BOOST_TEST(fake.solves == 1);
}

BOOST_AUTO_TEST_CASE(only_some_points_leaves_the_rows_and_files_of_the_others) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  const auto csv = request.folder / "atlas.csv";
  const AtlasTable before = read_atlas_table(csv);
  const std::string other_file = test::read(request.folder / (request.points[0].id() + ".toml"));
  fake.relative = 3e-9;
  fake.solves = 0;
  request.only = "roelands";
  request.fresh = true;
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 2);
  BOOST_TEST(result.entries.size() == 2u);
  BOOST_TEST(result.left_over.empty());
  const AtlasTable now = read_atlas_table(csv);
  BOOST_REQUIRE(now.rows.size() == 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    BOOST_TEST(now.rows[i].at("id") == before.rows[i].at("id"));
    BOOST_TEST((now.rows[i] == before.rows[i]) == (i < 4));
  }
  BOOST_TEST(test::read(request.folder / (request.points[0].id() + ".toml")) == other_file);
  BOOST_TEST(atlas_disagreements(request.folder).empty());
  // A changed number is a new version.
  BOOST_TEST(read_case(request.folder / (request.points[0].id() + ".toml")).version == 1);
  BOOST_TEST(read_case(request.folder / (request.points[4].id() + ".toml")).version == 2);
  fake.solves = 0;
  (void)run_atlas(request_in(folder), fake.solver());
  BOOST_TEST(fake.solves == 0);  // the records of the other points are still there
  (void)run_atlas(request, fake.solver());
  BOOST_TEST(read_case(request.folder / (request.points[4].id() + ".toml")).version == 2);

  // A table that is none is not overwritten.
  std::ofstream(csv) << "id,M\nmine,3\n";
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), CaseError);
  BOOST_TEST(test::read(csv) == "id,M\nmine,3\n");
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_the_number_of_threads) {
  std::vector<std::string> csv;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const test::Folder folder;
    Fake fake;
    AtlasRequest request = request_in(folder);
    request.points = atlas_points();
    request.threads = threads;
    (void)run_atlas(request, fake.solver());
    csv.push_back(test::read(request.folder / "atlas.csv") + test::read(request.folder / "digits.txt"));
  }
  BOOST_TEST(csv[0] == csv[1]);
  BOOST_TEST(csv[0] == csv[2]);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written_is_refused_before_anything_is_solved) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  request.folder = folder.write("file", "text");
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), OutputError);
  request.folder = folder.path() / "file" / "below";
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), OutputError);
  BOOST_TEST(fake.solves == 0);
  BOOST_TEST(test::read(folder.path() / "file") == "text");
}

BOOST_AUTO_TEST_CASE(wrong_usage_of_the_command_is_one_line_and_exit_code_2) {
  const test::Folder folder;
  const std::string file = folder.write("file", "text").string();
  const std::string damaged = (folder.path() / "damaged").string();
  std::filesystem::create_directory(damaged);
  (void)folder.write("damaged/atlas.csv", "id,M\n");
  const std::vector<std::pair<std::string, std::string>> rows{
      {"--only no-such-point", "--only = no-such-point: is in no id; allowed is a part of an id like atlas-"},
      {"--output ''", "--output = : is empty"},
      {"--output " + file, "file: is no folder, and a folder is needed there"},
      {"--output " + file + "/below", "file: is no folder, and a folder is needed there"},
      {"--only isoviscous-m0.05 --output " + damaged, "atlas.csv:1: id,M: other columns"},
      {"--tolerance 0", "is out of range; allowed is a number, more than 0 to 1"},
      {"--tolerance 1", "--tolerance = 1: is too loose for digits; allowed is a number > 0, up to 0.0001"},
      {"--tolerance abc", "is not a number"},
      {"--threads 0", "--threads = 0: is out of range; allowed is an integer, 1 to"},
      {"--threads -1", "--threads = -1: is out of range"},
      {"--threads two", "is not an integer"},
      {"--time-limit 0", "is out of range"},
      {"--frobnicate", "frobnicate"},
  };
  for (const auto& [arguments, phrase] : rows) {
    const std::string here = arguments.find("--output") == std::string::npos ? " --output " + damaged : "";
    test::check_refused(folder, "atlas " + arguments + here, phrase);
  }
}

BOOST_AUTO_TEST_CASE(an_interrupted_command_says_what_it_leaves) {
  const test::Folder folder;
  const std::string output = (folder.path() / "atlas").string(), err = (folder.path() / "err.txt").string();
  const std::string command = fmt::format(
      "timeout -s INT 0.8 '{}' atlas --threads 1 --only roelands-m5000-l30 --output '{}' > '{}.out' 2> '{}'",
      EHD_PROGRAM, output, output, err);
  BOOST_TEST(std::system(command.c_str()) != 0);
  BOOST_TEST(test::read(err) ==
             "ehd: atlas: interrupted; the solved points are kept, and the same command goes on from there\n");
  BOOST_TEST(!std::filesystem::exists(output + "/atlas.csv"));
  BOOST_TEST(test::read(output + ".out") == "");
}

BOOST_AUTO_TEST_CASE(a_point_made_by_the_command_is_a_case_by_its_id) {
  const test::Folder folder;
  const std::string cases = folder.path().string(), id = "atlas-isoviscous-m0.2-l0-flooded";
  const std::string output = fmt::format("atlas --only {} --tolerance 1e-6 --output {}/atlas", id, cases);
  const auto made = test::ehd_run(folder, output);
  BOOST_TEST(made.exit_code == 0, made.err);
  BOOST_TEST(made.error_lines() == 1, made.err);
  BOOST_TEST(made.out.find("1 points, 1 solved now") != std::string::npos, made.out);
  const auto again = test::ehd_run(folder, output);
  BOOST_TEST(again.err == "1 of 1 points are known from an earlier run\n");
  BOOST_TEST(again.out.find("1 points, 0 solved now, 1 from records") != std::string::npos, again.out);
  BOOST_REQUIRE(::setenv("EHD_CASES", cases.c_str(), 1) == 0);
  const auto solved = test::ehd_run(folder, "solve " + id + " --tolerance 1e-2 --json -");
  const auto listed = test::ehd_run(folder, "cases --atlas");
  ::unsetenv("EHD_CASES");
  BOOST_TEST(solved.exit_code == 0, solved.err);
  BOOST_TEST(Json::parse(solved.out)["case"] == id);
  BOOST_TEST(listed.exit_code == 0, listed.err);
  BOOST_TEST(listed.out.find(id) != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
