// SPDX-License-Identifier: GPL-3.0-or-later
// ehd judge, ehd compare --external and ehd cases ID: what they write and how they end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

namespace {

namespace test = ehd::verification::test;
using nlohmann::json;

const std::string submission_text = R"({"schema": "ehd-submission-1", "solver": {"name": "n"}, "results": [
  {"case": "own-barus-5-5", "version": 1, "scaling": "hertz", "film.minimum": 0.2469, "stated_error": 1e-3}]})";

std::string quoted(const std::filesystem::path& file) { return "'" + file.string() + "'"; }

/// A program that answers every case with the films of own-barus-5-5, and says something.
std::string answering(const test::Folder& folder, int exit_code) {
  const auto answer = folder.write("answer.json", submission_text);
  return fmt::format("\"mine=cp {} {{out}} && grep -q lambda {{case}} && echo said {{tolerance}} >&2; exit {}\"",
                     quoted(answer), exit_code);
}

const std::string compared = "compare own-barus-5-5 --solver fast --tolerance 1e-2 --json - --external ";

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_cli)

BOOST_AUTO_TEST_CASE(a_submission_is_judged_in_words_and_as_json) {
  const test::Folder folder;
  const auto file = folder.write("mine.json", submission_text);
  const auto words = test::ehd_run(folder, "judge " + quoted(file));
  BOOST_TEST(words.exit_code == 0);
  BOOST_TEST(words.out.find("missing") != std::string::npos);
  const auto ended =
      test::ehd_run(folder, fmt::format("judge {} --json - --badge {} --output {}", quoted(file),
                                        quoted(folder.path() / "b.svg"), quoted(folder.path() / "page")));
  BOOST_TEST(ended.exit_code == 0);
  const json judgement = json::parse(ended.out);
  BOOST_TEST(judgement["schema"] == "ehd-judgement-1");
  BOOST_TEST(judgement["cases"].size() == 10u);
  BOOST_TEST(judgement["honesty"]["met"] == 1);
  BOOST_TEST(test::read(folder.path() / "b.svg").starts_with("<svg"));
  BOOST_TEST(test::read(folder.path() / "page" / "judge.html").find("own-barus-5-5") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_failed_gate_ends_with_1_and_a_bad_file_with_2) {
  const test::Folder folder;
  // Hertz' pressure: the film between the bodies is flat. `bent` raises every third node. The first row says that P is
  // cut there.
  const auto write_profile = [&](double bent, double times = 1) {
    std::string profile = "X,P,H,P_unresolved\n";
    for (int i = 0; i <= 40; ++i) {
      const double X = -1 + i / 20.0, P = times * std::sqrt(std::max(0.0, 1 - X * X));
      profile += fmt::format("{},{},{},{}\n", X, P, i % 3 == 0 ? 1 + bent : 1, i == 0 ? 1 : 0);
    }
    (void)folder.write("p.csv", profile);
  };
  write_profile(0);
  std::string text = submission_text;
  text.replace(text.find("\"stated_error\": 1e-3"), 20, "\"profile\": \"p.csv\"");
  const auto file = folder.write("mine.json", text);
  const auto held = test::ehd_run(folder, "judge " + quoted(file) + " --json -");
  BOOST_TEST(held.exit_code == 0);
  write_profile(0.3);
  const auto failed = test::ehd_run(folder, "judge " + quoted(file) + " --json -");
  BOOST_TEST(failed.exit_code == 1);
  BOOST_TEST(failed.err.find("a gate of a profile failed") != std::string::npos);
  BOOST_TEST(json::parse(failed.out)["gates_hold"] == false);
  write_profile(0, 1.3);
  BOOST_TEST(test::ehd_run(folder, "judge " + quoted(file)).exit_code == 1);

  test::check_refused(folder, "judge", "a FILE is missing");
  test::check_refused(folder, "judge nowhere.json", "there is no such file");
  test::check_refused(folder, "judge " + quoted(folder.path()), "is a directory");
  test::check_refused(folder, "judge /dev/zero", "is not a regular file");
  test::check_refused(folder, fmt::format("judge {} --json {}", quoted(file), quoted(file)), "is the same file");
  const auto badge = folder.path() / "b.txt";
  test::check_refused(folder, fmt::format("judge {} --badge {}", quoted(file), quoted(badge)),
                      "b.txt: ends in .txt; allowed is .svg");
  BOOST_TEST(!std::filesystem::exists(badge));
  const auto capital = folder.path() / "B.SVG";
  (void)test::ehd_run(folder, fmt::format("judge {} --badge {}", quoted(file), quoted(capital)));
  BOOST_TEST(std::filesystem::exists(capital));
  (void)folder.write("bad.json", "{\"schema\": \"other\"}");
  test::check_refused(folder, "judge " + quoted(folder.path() / "bad.json"), "allowed is ehd-submission-1");
}

BOOST_AUTO_TEST_CASE(the_page_has_every_kept_submission_also_a_csv_but_no_profile) {
  const test::Folder folder, cases;
  const std::string source = std::string(EHD_SOURCE_DIR) + "/cases";
  for (const auto& entry : std::filesystem::directory_iterator(source))
    if (entry.path().extension() == ".toml")
      std::filesystem::copy_file(entry.path(), cases.path() / entry.path().filename());
  std::filesystem::create_directory(cases.path() / "submissions");
  BOOST_REQUIRE(::setenv("EHD_CASES", cases.path().c_str(), 1) == 0);
  const std::string output = "judge --output " + quoted(folder.path() / "page");
  test::check_refused(folder, output, "submissions: holds no submission; required is one, or a FILE");

  (void)cases.write("submissions/by-csv.csv",
                    "case,version,quantity,value,scaling\nown-barus-5-5,1,film.minimum,0.2469,hertz\n");
  std::string with_profile = submission_text, profile = "X,P,H\n";
  for (int i = 0; i <= 40; ++i)
    profile += fmt::format("{},{},1\n", -1 + i / 20.0, std::sqrt(std::max(0.0, 1 - std::pow(-1 + i / 20.0, 2))));
  with_profile.replace(with_profile.find("\"stated_error\": 1e-3"), 20, "\"profile\": \"./p.csv\"");
  (void)cases.write("submissions/p.csv", profile);
  (void)cases.write("submissions/with-profile.json", with_profile);
  const auto ended = test::ehd_run(folder, output);
  BOOST_TEST(ended.exit_code == 0, ended.err);
  BOOST_TEST(ended.out == (folder.path() / "page" / "judge.html").string() + "\n");
  const std::string page = test::read(folder.path() / "page" / "judge.html");
  BOOST_TEST(page.find("by-csv.csv") != std::string::npos);
  BOOST_TEST(page.find("with-profile.json") != std::string::npos);

  test::check_refused(folder, output + " --json -", "--json = -: belongs to given submissions; required is a FILE");
  test::check_refused(folder, "judge", "--output DIR for a page of those in cases/submissions");
  ::unsetenv("EHD_CASES");
}

BOOST_AUTO_TEST_CASE(another_program_is_compared_by_what_it_leaves) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, compared + answering(folder, 0));
  BOOST_TEST(ended.exit_code == 0);
  const json mine = json::parse(ended.out)[0]["runs"].back();
  BOOST_TEST(mine["solver"] == "mine");
  BOOST_TEST(mine["status"] == "converged");
  BOOST_TEST(mine["external"]["exit_code"] == 0);
  BOOST_TEST(mine["external"]["last_line"] == "said 0.01");
  BOOST_TEST(mine["external"]["wall_s"] >= 0.0);
  EHD_CHECK(ehd::error(mine["achieved_error"]["film.minimum"].get<double>(), 0.2469 / 0.246708437314 - 1),
            ehd::verification::Tolerance::round_off(1e5));

  const auto loose = test::ehd_run(folder, compared + answering(folder, 1));
  BOOST_TEST(loose.exit_code == 1);
  BOOST_TEST(json::parse(loose.out)[0]["runs"].back()["status"] == "tolerance-not-met");
}

BOOST_AUTO_TEST_CASE(another_program_that_fails_is_a_row_with_its_reason) {
  const test::Folder folder;
  const auto run_of = [&](const std::string& command, const std::string& more = "") {
    const auto ended = test::ehd_run(folder, fmt::format("{}\"mine={}\"{}", compared, command, more));
    BOOST_TEST(ended.exit_code == 1);
    BOOST_TEST(ended.error_lines() == 1);
    json one = json::parse(ended.out)[0]["runs"].back();
    BOOST_TEST(ended.err == "ehd: own-barus-5-5: mine at 0.01: " + one["reason"].get<std::string>() + "\n");
    return one;
  };
  json mine = run_of("test {case} && test -n {out} && echo 'no \\033[31m luck' >&2; exit 7");
  BOOST_TEST(mine["status"] == "diverged");
  BOOST_TEST(mine["external"]["exit_code"] == 7);
  BOOST_TEST(mine["external"]["last_line"].get<std::string>().find('\033') == std::string::npos);
  BOOST_TEST(mine["reason"].get<std::string>().starts_with("it left no submission; exit code 7: no "));
  // Octave has a word behind every exit of a script.
  mine = run_of(
      "printf 'no luck\\nerror: ignoring const execution_exception& while preparing to exit\\n\\n' >&2; : {case} "
      "{out}; "
      "exit 7");
  BOOST_TEST(mine["external"]["last_line"] == "no luck");
  mine = run_of("cp {case} {out}");
  BOOST_TEST(mine["status"] == "diverged");
  BOOST_TEST(mine["reason"].get<std::string>().find("allowed is ehd-submission-1") != std::string::npos);
  mine = run_of("sleep 60; cat {case} {out}", " --time-limit 1");
  BOOST_TEST(mine["status"] == "limit-reached");
  BOOST_TEST(!mine["external"].contains("exit_code"));
  BOOST_TEST(mine["external"]["wall_s"] >= 1.0);
  mine = run_of("kill -9 \\$\\$; cat {case} {out}");
  BOOST_TEST(mine["status"] == "diverged");

  // The files of the exchange are gone: a message names them by their words.
  const auto refused = test::ehd_run(folder, compared + "'mine=echo no >{out}; echo {case} is hard >&2; exit 3'");
  BOOST_TEST(refused.out.find("ehd-external-") == std::string::npos, refused.out);
  BOOST_TEST(refused.out.find("its submission is refused: {out}") != std::string::npos, refused.out);
  BOOST_TEST(refused.out.find("{case} is hard") != std::string::npos, refused.out);
  test::check_refused(folder, "compare own-barus-5-5 --external 'a b {case} {out}'", "has no name");
  test::check_refused(folder, "compare own-barus-5-5 --external 'fast=true {case} {out}'", "has the name of another");
  test::check_refused(folder,
                      "compare own-barus-5-5 --external 'a=true {case} {out}' --external 'a=false {case} {out}'",
                      "has the name of another");
  test::check_refused(folder, "compare own-barus-5-5 --external 'mine=prog {case}'", "has no {out}");
}

BOOST_AUTO_TEST_CASE(compare_marks_errors_above_the_tolerance_asked_for) {
  const test::Folder folder;
  const auto run_of = [&](const std::string& films, int exit_code = 0, const std::string& asked = "1e-2") {
    const auto answer =
        folder.write("answer.json", R"({"schema": "ehd-submission-1", "solver": {"name": "n"}, "results": [)"
                                    R"({"case": "own-barus-5-5", "version": 1, "scaling": "hertz", )" +
                                        films + "}]}");
    const std::string command = fmt::format(
        "compare own-barus-5-5 --solver fast --tolerance {} --external \"mine=cp {} {{out}}; test {{case}}\"", asked,
        quoted(answer));
    const auto words = test::ehd_run(folder, command), data = test::ehd_run(folder, command + " --json -");
    for (const auto& ended : {words, data}) BOOST_TEST(ended.exit_code == exit_code);
    const auto row = words.out.substr(words.out.find("  mine"));
    struct Told {
      std::string row, out, err;
      json run;
    };
    return Told{row.substr(0, row.find('\n')), words.out, words.err, json::parse(data.out)[0]["runs"].back()};
  };
  const std::string legend = "! above the tolerance asked for\n";

  const auto met = run_of(R"("film.minimum": 0.2469, "film.central": 0.3241, "stated_error": 1e-2)");
  BOOST_TEST(met.out.find('!') == std::string::npos, met.out);
  BOOST_TEST((met.run["within_tolerance"] == json{{"film.minimum", true}, {"film.central", true}}));

  const auto missed = run_of(R"("film.minimum": 0.27, "film.central": 0.3241, "stated_error": 1e-3)");
  BOOST_TEST(missed.row.find("0.094!") != std::string::npos, missed.row);
  BOOST_TEST(std::count(missed.row.begin(), missed.row.end(), '!') == 1);
  BOOST_TEST(missed.out.find(legend) != std::string::npos, missed.out);
  BOOST_TEST((missed.run["within_tolerance"] == json{{"film.minimum", false}, {"film.central", true}}));
  BOOST_TEST(missed.run["status"] == "converged");  // as its exit code says

  const auto states_more = run_of(R"("film.minimum": 0.2469, "film.central": 0.3241, "stated_error": 0.5)");
  BOOST_TEST(std::count(states_more.row.begin(), states_more.row.end(), '!') == 2);
  BOOST_TEST(states_more.out.find(legend) != std::string::npos);

  // The digits are known to 2e-12: they tell nothing of a tolerance below that.
  const auto untold = run_of(R"("film.minimum": 0.246708437314, "film.central": 0.3241)", 1, "1e-12");
  BOOST_TEST((untold.run["within_tolerance"] == json{{"film.central", false}}));

  const auto in_moes = run_of(R"("film.minimum": 3.141, "film.central": 4.126)");
  BOOST_TEST(in_moes.err.find("own-barus-5-5: mine at 0.01: the films fit the scaling \"moes\"") != std::string::npos,
             in_moes.err);
  BOOST_TEST(in_moes.run["external"]["hints"].size() == 1u);
  BOOST_TEST(!met.run["external"].contains("hints"));

  const auto no_film = run_of(R"("pressure.exit": 1.1)", 1);
  BOOST_TEST(no_film.run["status"] == "diverged");
  BOOST_TEST(no_film.err.find("has neither film.minimum nor film.central") != std::string::npos, no_film.err);
}

// EHD_CASES may name a folder without a bibliography. A mistyped source of a case there is named, once there is one.
BOOST_AUTO_TEST_CASE(the_source_of_a_case_is_looked_up_where_there_is_a_bibliography) {
  const test::Folder folder;
  std::string text = test::read(std::filesystem::path(EHD_SOURCE_DIR) / "cases/kostreva-100lb-500rpm.toml");
  text.replace(text.find("source = \"kostreva1984"), 22, "source = \"kostreva1948");
  (void)folder.write("kostreva-100lb-500rpm.toml", text);
  const std::string id = "kostreva-100lb-500rpm", cases = "cases " + id;
  const auto run = [&](const std::string& arguments) {
    const char* before = std::getenv("EHD_CASES");
    const std::string kept = before ? before : "";
    ::setenv("EHD_CASES", folder.path().c_str(), 1);
    const auto ended = test::ehd_run(folder, arguments);
    kept.empty() ? ::unsetenv("EHD_CASES") : ::setenv("EHD_CASES", kept.c_str(), 1);
    return ended;
  };
  for (const std::string& arguments : {std::string("cases"), cases}) {
    const auto listed = run(arguments);
    BOOST_TEST(listed.exit_code == 0, listed.err);
    BOOST_TEST(listed.out.find("has no references.bib") != std::string::npos, listed.out);
  }
  BOOST_TEST(run(cases + " --bibtex").out.find("@misc{ehd-" + id) != std::string::npos);
  const auto no_sources = run("cases --bibtex");
  BOOST_TEST(no_sources.exit_code == 2);
  BOOST_TEST(no_sources.err.find("references.bib: there is no such file") != std::string::npos, no_sources.err);

  (void)folder.write("references.bib", "@article{kostreva1984,\n  title = {One},\n}\n");
  const auto listed = run(cases);
  BOOST_TEST(listed.exit_code == 0, listed.err);
  BOOST_TEST(listed.out.find("kostreva1948: is not in references.bib; did you mean kostreva1984?") != std::string::npos,
             listed.out);
  const auto cited = run(cases + " --bibtex");
  BOOST_TEST(cited.exit_code == 2);
  BOOST_TEST(cited.out == "");
  BOOST_TEST(cited.err.find(id + ".toml:") != std::string::npos, cited.err);
  BOOST_TEST(cited.err.find("has no entry in ") != std::string::npos, cited.err);
  BOOST_TEST(cited.err.find("did you mean kostreva1984?") != std::string::npos, cited.err);
}

BOOST_AUTO_TEST_CASE(a_case_is_cited_shown_and_given_to_programs) {
  const test::Folder folder;
  const auto bibtex = test::ehd_run(folder, "cases kostreva-100lb-500rpm --bibtex");
  BOOST_TEST(bibtex.exit_code == 0);
  for (const char* part : {"@misc{ehd-kostreva-100lb-500rpm-v1,", "kostreva-100lb-500rpm@1", "1.14938",
                           "@article{kostreva1984,", "@misc{own,"})
    BOOST_CHECK_MESSAGE(bibtex.out.find(part) != std::string::npos, part << " is not in " << bibtex.out);
  BOOST_TEST(bibtex.out.find("martin1916") == std::string::npos);
  // The commit is that of --version, with "changed since" where the tree is changed.
  const std::string version = test::ehd_run(folder, "--version").out, before = "\ncommit     ";
  const auto at = version.find(before) + before.size();
  const std::string commit = version.substr(at, version.find('\n', at) - at);
  const auto comma = std::min(commit.find(','), commit.size());
  const std::string cited = commit == "no commit" ? commit : "commit " + commit.substr(0, 12) + commit.substr(comma);
  BOOST_TEST(bibtex.out.find(", " + cited + ", cases/") != std::string::npos, bibtex.out);
  const auto law = test::ehd_run(folder, "export law na4908 --raceway inner --knots 4");
  BOOST_TEST(law.out.find(commit + ", 20") != std::string::npos, law.out.substr(0, 400));
  // The year stands beside the commit, or there is neither.
  BOOST_TEST((bibtex.out.find(", commit ") != std::string::npos) ==
             (bibtex.out.find("\n  year         = {20") != std::string::npos));

  const auto shown = test::ehd_run(folder, "cases own-barus-5-5 --show");
  BOOST_TEST(shown.out == test::read(std::string(EHD_SOURCE_DIR) + "/cases/own-barus-5-5.toml"));

  const auto given = test::ehd_run(folder, "cases own-moes-20-10 own-barus-3-4-flooded na4908 dry-steel --json");
  const json cases = json::parse(given.out)["cases"];
  BOOST_REQUIRE(cases.size() == 4u);
  BOOST_TEST(cases[0]["problem"]["viscosity"]["law"] == "roelands");
  BOOST_TEST(cases[0]["problem"]["inlet"] == -4.0);
  BOOST_TEST(cases[0]["expect"].size() == 4u);
  BOOST_TEST(cases[1]["problem"]["inlet"] == "flooded");
  EHD_CHECK(ehd::error(cases[1]["problem"]["groups"]["lambda"], 3 * M_PI * M_PI / (8 * 9)),
            ehd::verification::Tolerance::round_off(20));
  BOOST_TEST(!cases[2].contains("problem"));
  BOOST_TEST(!cases[3]["problem"].contains("groups"));
  test::check_refused(folder, "cases own-barus-5-5 --show --json", "exclude each other");
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_benchmark_case_is_not_cited_as_one) {
  const test::Folder folder;
  const std::string cases = std::string(EHD_SOURCE_DIR) + "/cases";
  const auto copy = folder.write("own-moes-20-10.toml", test::read(cases + "/own-moes-20-10.toml"));
  test::check_refused(folder, "cases " + quoted(copy) + " --bibtex", "it is no benchmark case and has no entry");
  test::check_refused(folder, fmt::format("cases own-barus-5-5 {} --bibtex", quoted(copy)), "it is no benchmark case");
  BOOST_TEST(test::ehd_run(folder, "cases " + quoted(copy) + " --json").exit_code == 0);
  BOOST_TEST(test::ehd_run(folder, "cases '" + cases + "/own-moes-20-10.toml' --bibtex").exit_code == 0);
  BOOST_TEST(test::ehd_run(folder, "cases atlas-barus-m20-l10-flooded --bibtex").exit_code == 0);
}

BOOST_AUTO_TEST_CASE(the_citations_of_the_software_name_its_version) {
  const test::Folder folder;
  const std::string cff = test::read(std::string(EHD_SOURCE_DIR) + "/CITATION.cff");
  for (const char* key :
       {"cff-version: 1.2.0\n", "\nmessage: ", "\ntitle: ", "\nauthors:\n"})  // what the format requires
    BOOST_CHECK_MESSAGE(cff.find(key) != std::string::npos, key << " is not in CITATION.cff");
  const std::string before = "\nversion: ";
  const auto at = cff.find(before);
  BOOST_REQUIRE(at != std::string::npos);
  const std::string version = cff.substr(at + before.size(), cff.find('\n', at + 1) - at - before.size());
  BOOST_TEST(test::ehd_run(folder, "--version").out.find(" " + version) != std::string::npos);
  BOOST_TEST(test::ehd_run(folder, "cases own-barus-5-5 --bibtex").out.find("version = {" + version + "}") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
