// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claim.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "contact/interruption.hpp"
#include "io/json.hpp"
#include "tests/check.hpp"
#include "verification/claims/topics.hpp"
#include "verification/suite.hpp"
#include "workflow/case.hpp"

namespace {

using namespace ehd;
using namespace ehd::verification;

const double unknown_value = std::nan("");

Sentence sentence(const std::string& id) {
  return {.id = id, .rung = 6, .statement = "something holds", .case_id = "some-case", .solver = "some.solver"};
}

const Tolerance one_percent = Tolerance::required(0.01, "here");

/// A folder of cases of its own, named by EHD_CASES while it lives.
class CaseFolder {
 public:
  CaseFolder() : path_(std::filesystem::temp_directory_path() / ("ehd-claims-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
    if (const char* before = std::getenv("EHD_CASES")) before_ = before;
    ::setenv("EHD_CASES", path_.c_str(), 1);
  }
  ~CaseFolder() {
    std::filesystem::remove_all(path_);
    if (before_.empty()) {
      ::unsetenv("EHD_CASES");
    } else {
      ::setenv("EHD_CASES", before_.c_str(), 1);
    }
  }
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;

  void write(const std::string& id, const std::string& text) const { std::ofstream(path_ / (id + ".toml")) << text; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::string before_;
};

std::string dry_case(const std::string& id, const std::string& offset) {
  return "id = \"" + id + "\"\nversion = 1\ntitle = \"dry\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1.2e5\n" +
         "reduced_radius_m = 1.1e-2\nreduced_modulus_Pa = 2.3e11\n[[expect]]\nquantity = \"film.offset\"\nvalue = \"" +
         offset + "\"\nscaling = \"hertz\"\nkind = \"exact\"\n";
}

/// (5,5), Barus, incompressible, inlet -4: H_min = .246708437314 (computed to 10 digits or more).
std::string contact_case(const std::string& id, const std::string& minimum) {
  return "id = \"" + id + "\"\nversion = 1\ntitle = \"contact\"\nsource = \"own\"\n[moes]\nM = 5.0\nL = 5.0\n" +
         "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n[domain]\ninlet = -4.0\n[[expect]]\n" +
         "quantity = \"film.minimum\"\nvalue = \"" + minimum + "\"\nscaling = \"hertz\"\nkind = \"computed\"\n";
}

int exit_code(const std::string& arguments) {
  const int status = std::system(fmt::format("'{}' {} > /dev/null 2>&1", EHD_PROGRAM, arguments).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::size_t count(const SuiteResult& result, Verdict verdict) {
  std::size_t number = 0;
  for (const Claim& one : result.claims) number += one.verdict == verdict ? 1 : 0;
  return number;
}

const Claim* find(const SuiteResult& result, const std::string& id) {
  for (const Claim& one : result.claims) {
    if (one.says.id == id) return &one;
  }
  return nullptr;
}

/// What a topic with one claim, which passes, has for a judge.
std::function<Findings()> claims_called(const std::string& id) {
  return [id] { return Findings{.claims = {claim_fact(sentence(id), true, "here")}, .skipped = {}}; };
}

}  // namespace

BOOST_AUTO_TEST_SUITE(claim)

BOOST_AUTO_TEST_CASE(the_note_of_a_claim_does_not_end_in_a_separator) {
  BOOST_TEST(ehd::verification::claim(sentence("a"), 0, 0, one_percent, "one; two; ").note == "one; two");
  BOOST_TEST(claim_finding(sentence("a"), "one (two); ").note == "one (two)");
  BOOST_TEST(claim_fact(sentence("a"), true, "here", "; ").note == "");
}

BOOST_AUTO_TEST_CASE(a_value_is_judged_relative_to_what_is_expected) {
  const Claim near = claim_value(sentence("near"), 0.2518, 0.25, 0.001, one_percent);
  EHD_CHECK(error(near.error, 0.0072), Tolerance::round_off(8, 1000));
  BOOST_TEST((near.verdict == Verdict::pass));
  EHD_CHECK(error(near.margin(), 1 - 0.82), Tolerance::round_off(8, 1000));
  BOOST_TEST((claim_value(sentence("undecided"), 0.2518, 0.25, 0.005, one_percent).verdict == Verdict::inconclusive));
  BOOST_TEST((claim_value(sentence("far"), 0.26, 0.25, 0.001, one_percent).verdict == Verdict::fail));
  // The error is absolute where 0 is expected.
  EHD_CHECK(error(claim_value(sentence("zero"), -0.003, 0, 0, one_percent).error, 0.003), Tolerance::round_off(2));
}

BOOST_AUTO_TEST_CASE(an_unconverged_solve_never_passes) {
  int rows = 0;
  for (const double expected : {0.25, 0.0, unknown_value}) {
    for (const double uncertainty : {0.0, 0.5, unknown_value}) {
      BOOST_TEST(
          (claim_value(sentence("nan"), unknown_value, expected, uncertainty, one_percent).verdict != Verdict::pass));
      ++rows;
    }
  }
  BOOST_TEST(rows == 9);
  SuiteResult result;
  result.claims.push_back(claim_value(sentence("nan"), unknown_value, 1, 0, one_percent));
  BOOST_TEST(!result.success());
}

BOOST_AUTO_TEST_CASE(a_suite_without_claims_is_no_success) { BOOST_TEST(!SuiteResult{}.success()); }

BOOST_AUTO_TEST_CASE(facts_stand_or_fall_and_findings_stand) {
  BOOST_TEST((claim_fact(sentence("yes"), true, "here").verdict == Verdict::pass));
  BOOST_TEST((claim_fact(sentence("no"), false, "here").verdict == Verdict::fail));
  const Claim finding = claim_finding(sentence("finding"), "8752 N beside 9285 N");
  BOOST_TEST((finding.verdict == Verdict::pass));
  BOOST_TEST(finding.finding);
}

BOOST_AUTO_TEST_CASE(json_has_every_field_and_never_null) {
  const Json full = to_json(claim_value(sentence("full"), 0.2518, 0.25, 0.001, one_percent, "a note"));
  for (const char* key : {"id", "rung", "statement", "case", "solver", "measured", "expected", "error", "uncertainty",
                          "tolerance", "verdict", "margin", "note"}) {
    BOOST_TEST_CONTEXT(key) { BOOST_TEST(full.contains(key)); }
  }
  for (const char* key : {"value", "basis", "reason"}) BOOST_TEST(full["tolerance"].contains(key));
  BOOST_TEST(full["verdict"] == "pass");
  BOOST_TEST(full["rung"] == 6);
  const Json unknown = to_json(claim_value(sentence("nan"), unknown_value, 0.25, 0, one_percent));
  BOOST_TEST(!unknown.contains("measured"));
  BOOST_TEST(!unknown.contains("error"));
  BOOST_TEST(unknown["verdict"] == "inconclusive");
  BOOST_TEST(json_text(unknown).find("null") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_lowest_rungs_stand_in_the_suite_itself) {
  int rows = 0;
  for (const int rung : {0, 1, 2, 4}) {
    const SuiteResult result = run_suite({.rung = rung, .case_id = {}, .quick = true, .threads = 1, .progress = {}});
    BOOST_TEST_CONTEXT("rung " << rung) {
      BOOST_TEST(result.success());
      for (const Claim& one : result.claims) BOOST_TEST(one.says.rung == rung);
    }
    ++rows;
  }
  BOOST_TEST(rows == 4);
}

BOOST_AUTO_TEST_CASE(a_case_that_cannot_be_read_is_a_failing_claim_and_the_others_are_judged) {
  const CaseFolder folder;
  folder.write("good", dry_case("good", "-0.5965736"));
  folder.write("bad", "id = \"bad\"\nversion = \n");
  const SuiteResult result = run_suite({.rung = 0, .case_id = {}, .quick = false, .threads = 2, .progress = {}});
  const Claim* bad = find(result, "bad/read");
  BOOST_REQUIRE(bad);
  BOOST_TEST((bad->verdict == Verdict::fail));
  BOOST_TEST(bad->note.find("bad.toml:2") != std::string::npos);
  BOOST_TEST(count(result, Verdict::fail) == 1U);
  BOOST_TEST(!result.success());
  const SuiteResult dry = run_suite({.rung = {}, .case_id = "good", .quick = false, .threads = 1, .progress = {}});
  BOOST_TEST(dry.claims.size() == 1U);
  BOOST_TEST(dry.success());
}

BOOST_AUTO_TEST_CASE(a_wrong_expectation_fails) {
  const CaseFolder folder;
  folder.write("dry-wrong", dry_case("dry-wrong", "-0.5971701"));
  const SuiteResult dry = run_suite({.rung = {}, .case_id = "dry-wrong", .quick = false, .threads = 1, .progress = {}});
  BOOST_TEST(count(dry, Verdict::fail) == 1U);
  BOOST_TEST(!dry.success());

  // One per cent beside the truth, ten times what was asked of the solvers.
  folder.write("right", contact_case("right", "0.246708437314"));
  folder.write("wrong", contact_case("wrong", "0.24917552"));
  const SuiteResult right = run_suite({.rung = 10, .case_id = "right", .quick = false, .threads = 1, .progress = {}});
  const SuiteResult wrong = run_suite({.rung = 10, .case_id = "wrong", .quick = false, .threads = 1, .progress = {}});
  BOOST_TEST(right.claims.size() == 3U);  // both solvers, and the reference once more for so many digits
  BOOST_TEST(right.success());
  BOOST_TEST(count(wrong, Verdict::fail) == 3U);
}

BOOST_AUTO_TEST_CASE(names_that_repeat_are_numbered_and_no_claim_is_lost) {
  const auto throws = []() -> Findings { throw std::runtime_error("nothing works"); };
  const auto topics = [&] {
    return std::vector<Topic>{{.name = "box", .rungs = {6}, .slow = true, .judge = claims_called("box/a")},
                              {.name = "box", .rungs = {6}, .slow = true, .judge = throws},
                              {.name = "box", .rungs = {6}, .slow = false, .judge = throws},
                              {.name = "other", .rungs = {6}, .slow = false, .judge = claims_called("same")},
                              {.name = "another", .rungs = {6}, .slow = false, .judge = claims_called("same")}};
  };
  const SuiteRequest whole{.rung = 6, .case_id = {}, .quick = false, .threads = 1, .progress = {}};
  const SuiteResult result = run_topics(whole, topics(), {});
  for (const char* id : {"box/a", "same"}) {
    const Claim* one = find(result, id);
    BOOST_REQUIRE(one);
    BOOST_TEST((one->verdict == Verdict::pass));
  }
  for (const char* id : {"box 2/ran", "box 3/ran", "same/unique"}) {
    const Claim* one = find(result, id);
    BOOST_REQUIRE_MESSAGE(one, id);
    BOOST_TEST((one->verdict == Verdict::fail));
  }
  BOOST_TEST(find(result, "same 2"));
  BOOST_TEST(result.claims.size() == 6U);
  BOOST_TEST(!result.success());

  SuiteRequest quick = whole;
  quick.quick = true;
  const SuiteResult short_one = run_topics(quick, topics(), {});
  BOOST_REQUIRE(short_one.skipped.size() == 2U);
  BOOST_TEST(short_one.skipped[0].says.id == "box");
  BOOST_TEST(short_one.skipped[1].says.id == "box 2");
  BOOST_TEST(short_one.topics.at(2).name == "box 3");
}

BOOST_AUTO_TEST_CASE(a_topic_that_lacks_memory_is_inconclusive_and_says_so) {
  const auto judge = []() -> Findings { throw std::bad_alloc(); };
  const SuiteResult result =
      run_topics({.rung = 6, .threads = 1}, {{.name = "large", .rungs = {6}, .slow = false, .judge = judge}}, {});
  const Claim* one = find(result, "large/ran");
  BOOST_REQUIRE(one);
  BOOST_TEST((one->verdict == Verdict::inconclusive));
  BOOST_TEST(one->note == "memory is exhausted");
  BOOST_TEST(!result.success());
}

BOOST_AUTO_TEST_CASE(topics_after_the_deadline_are_skipped_and_the_suite_does_not_succeed) {
  const auto judge = [] { return Findings{.claims = {claim_fact(sentence("one"), true, "here")}, .skipped = {}}; };
  const std::vector<Topic> topics{{.name = "early", .rungs = {6}, .slow = false, .judge = judge}};
  constexpr double passed_s = -1;
  const SuiteResult late = run_topics({.rung = 6, .threads = 1, .deadline = Deadline(passed_s)}, topics, {});
  BOOST_TEST(late.claims.empty());
  BOOST_REQUIRE(late.skipped.size() == 1U);
  BOOST_TEST(late.skipped[0].why == Deadline::not_run);
  BOOST_TEST(late.not_run == 1U);
  BOOST_TEST(!late.success());
  BOOST_TEST(run_topics({.rung = 6, .threads = 1}, topics, {}).success());
}

// Its findings may be those of solves that were ended.
BOOST_AUTO_TEST_CASE(a_topic_that_has_not_ended_by_the_deadline_is_left_out_and_its_solves_end) {
  const Deadline deadline(0.5);
  long asked = 0;
  const auto judge = [&] {
    while (!interrupted()) ++asked;
    return Findings{.claims = {claim_fact(sentence("late"), true, "here")}, .skipped = {}};
  };
  const std::vector<Topic> topics{
      {.name = "late", .rungs = {6}, .slow = false, .judge = judge},
      {.name = "early", .rungs = {6}, .slow = false, .judge = claims_called("early"), .expected_s = 0.2}};
  const SuiteResult cut = run_topics({.rung = 6, .threads = 1, .deadline = deadline}, topics, {});
  BOOST_TEST(asked > 0);
  BOOST_TEST(find(cut, "early"));
  BOOST_TEST(cut.claims.size() == 1u);
  BOOST_REQUIRE(cut.skipped.size() == 1u);
  BOOST_TEST(cut.skipped[0].says.id == "late");
  BOOST_TEST(cut.skipped[0].why == Deadline::out_of_time);
  BOOST_TEST(cut.not_run == 1u);
  BOOST_TEST(!cut.success());
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_keeps_what_is_finished_and_is_no_success) {
  std::optional<SuiteResult> stopped;
  const SuiteRun* running = nullptr;
  const auto judge = [&] {  // another thread looks while this topic is judged
    std::jthread([&] { stopped = running->stopped(); }).join();
    return claims_called("second")();
  };
  SuiteRun run({.rung = 6, .threads = 1},
               {{.name = "first", .rungs = {6}, .slow = false, .judge = claims_called("first")},
                {.name = "second", .rungs = {6}, .slow = false, .judge = judge}},
               {});
  running = &run;
  const SuiteResult whole = run.judge();
  BOOST_TEST(whole.success());
  BOOST_REQUIRE(stopped.has_value());
  BOOST_TEST(find(*stopped, "first"));
  BOOST_TEST(stopped->claims.size() == 1u);
  BOOST_REQUIRE(stopped->skipped.size() == 1u);
  BOOST_TEST(stopped->skipped[0].says.id == "second");
  BOOST_TEST(stopped->not_run == 1u);
  BOOST_TEST(!stopped->success());
  const Json summary = to_json(*stopped)["summary"];
  BOOST_TEST(summary["success"] == false);
  BOOST_TEST(summary["stopped"] == true);
  BOOST_TEST(!to_json(whole)["summary"].contains("stopped"));
  const SuiteResult before_figures = run.stopped();  // every claim passes, and it is no success all the same
  BOOST_TEST(before_figures.not_run == 0u);
  BOOST_TEST(!before_figures.success());
}

BOOST_AUTO_TEST_CASE(filters_that_leave_nothing_are_refused) {
  const CaseFolder folder;
  folder.write("good", dry_case("good", "-0.5965736"));
  BOOST_CHECK_THROW((void)run_suite({.rung = 7, .case_id = "good", .quick = false, .threads = 1, .progress = {}}),
                    NothingSelected);
  BOOST_CHECK_THROW((void)run_suite({.rung = {}, .case_id = "absent", .quick = false, .threads = 1, .progress = {}}),
                    CaseError);
}

BOOST_AUTO_TEST_CASE(the_program_ends_with_the_agreed_exit_codes) {
  const CaseFolder folder;
  folder.write("good", dry_case("good", "-0.5965736"));
  folder.write("wrong", dry_case("wrong", "-0.5971701"));
  const std::string out = (folder.path() / "out").string();
  BOOST_TEST(exit_code("verify --case good --output '" + out + "'") == 0);
  BOOST_TEST(std::filesystem::exists(out + "/results.json"));
  BOOST_TEST(exit_code("verify --case wrong") == 1);
  BOOST_TEST(exit_code("verify --case absent") == 2);
  BOOST_TEST(exit_code("verify --rung 12") == 2);
  BOOST_TEST(exit_code("verify --rung -1") == 2);
  BOOST_TEST(exit_code("verify --rung seven") == 2);
  BOOST_TEST(exit_code("verify --rung 7 --case good") == 2);
  BOOST_TEST(exit_code("verify --case good --output '" + (folder.path() / "good.toml").string() + "'") == 2);

  std::ifstream file(out + "/results.json");
  const Json results = Json::parse(file);
  for (const char* key : {"schema", "provenance", "claims"}) BOOST_TEST(results.contains(key));
  for (const char* key : {"compiler", "flags", "libraries", "date"}) BOOST_TEST(results["provenance"].contains(key));
  BOOST_TEST(results["claims"].size() == 1U);
  BOOST_TEST(results["claims"][0]["case"] == "good");
}

BOOST_AUTO_TEST_SUITE_END()
