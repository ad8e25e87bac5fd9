// SPDX-License-Identifier: GPL-3.0-or-later
// ehd judge: anybody's solver, in any language, against the certified digits.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "verification/judge/first_cases.hpp"
#include "verification/judge/judgement.hpp"
#include "verification/judge/judgement_text.hpp"
#include "verification/report/judge_page.hpp"

namespace ehd::cli {

namespace {

struct JudgeOptions {
  std::vector<std::string> files;
  std::optional<std::string> json, badge, output;
};

const char* const judge_examples = R"(
Examples:
  ehd judge mine.json                        digits by case and regime, stated errors, gates, hints
  ehd judge mine.csv --json -                the same as JSON
  ehd judge mine.json --badge digits.svg
  ehd judge mine.json --output out/judge     out/judge/judge.html, beside the submissions of cases/submissions

A submission is JSON with schema ehd-submission-1, or CSV with the columns case, version, quantity, value, scaling:
docs/judge.md. A number scores -log10 of its relative error, up to the digits that the case certifies.

The first ten cases, from easy to hard, and what each tests (ehd cases ID --json: a case as JSON):
)";

const char* const judge_exit_codes = R"(
Exit code: 0 judged; 1 a gate of a profile failed; 2 a bad file or usage.)";

std::string judge_help() {
  std::string text = judge_examples;
  for (const judging::FirstCase& first : judging::first_cases)
    text += fmt::format("  {:<23}  {}\n", first.id, first.tests);
  return text + judge_exit_codes;
}

constexpr const char* page_name = "judge.html";

std::filesystem::path submissions_folder() { return cases_folder() / "submissions"; }

/// The submissions that stand in cases/submissions, by name. A CSV that one of them names as its profile is none.
std::vector<judging::Submission> kept_submissions() {
  std::vector<std::filesystem::path> json, csv;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(submissions_folder(), none)) {
    if (entry.path().extension() == ".json") json.push_back(entry.path());
    if (judging::is_csv(entry.path())) csv.push_back(entry.path());
  }
  std::vector<judging::Submission> kept;
  std::set<std::filesystem::path> profiles;
  for (const auto& file : json) {
    kept.push_back(judging::read_submission(file));
    for (const auto& result : kept.back().results)
      if (result.profile) profiles.insert(result.profile->lexically_normal());
  }
  for (const auto& file : csv)
    if (!profiles.contains(file.lexically_normal())) kept.push_back(judging::read_submission(file));
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return kept;
}

judging::Judgement judged(const judging::Submission& submission) {
  Progress progress;
  const auto show = [&](const std::string& id, std::size_t done, std::size_t all) {
    progress.step(done, all, fmt::format("{}: {} ...", id, submission.file.string()));
  };
  return judging::judgement_of(submission, {.progress = show});
}

void write_page(OutputFolder& folder, const std::vector<std::string>& files,
                const std::vector<judging::Submission>& kept, std::vector<Json> judgements) {
  const auto is_given = [&](const std::filesystem::path& one) {
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
      std::error_code none;
      return std::filesystem::equivalent(file, one, none);
    });
  };
  const std::size_t own = judgements.size();
  for (const judging::Submission& one : kept)
    if (!is_given(one.file)) judgements.push_back(judging::to_json(judged(one)));
  folder.write(page_name, report::judge_page(judgements, own));
  folder.commit();
}

/// Refuses what stands beside submissions only, and judging where there is none.
void require_submissions(const JudgeOptions& options) {
  if (options.files.empty() && !options.output)
    throw UsageError(
        "judge: a FILE is missing; required is a submission, or --output DIR for a page of those in cases/submissions");
  if (options.badge && options.files.size() != 1)
    throw option_error("--badge", *options.badge, "belongs to one submission; allowed is one FILE with it");
  const std::string ending = ending_of(options.badge.value_or(""));
  if (!ending.empty() && ending != ".svg")
    throw option_error("--badge", *options.badge, "ends in " + ending + "; allowed is .svg");
  if (options.json && options.files.empty())
    throw option_error("--json", *options.json, "belongs to given submissions; required is a FILE with it");
}

int judge(const JudgeOptions& options) {
  require_submissions(options);
  std::vector<NamedFile> inputs;
  for (const std::string& file : options.files) inputs.push_back({"the submission " + file, file});
  require_distinct(inputs, {{"--json", options.json.value_or("")}, {"--badge", options.badge.value_or("")}});
  JsonTarget json(options.json);
  std::optional<OutputFile> badge = opened(options.badge);
  OutputFolder folder(options.output);
  folder.open({page_name});
  const auto kept = options.output ? kept_submissions() : std::vector<judging::Submission>();
  if (options.files.empty() && kept.empty())
    throw UsageError(submissions_folder().string() + ": holds no submission; required is one, or a FILE");

  std::vector<Json> judgements;
  bool gates_hold = true;
  for (const std::string& file : options.files) {
    const judging::Judgement one = judged(judging::read_submission(file));
    if (!one.gates_hold()) complain("ehd: judge: " + file + ": a gate of a profile failed");
    gates_hold = gates_hold && one.gates_hold();
    judgements.push_back(judging::to_json(one));
    if (!json.to_standard_output()) print((judgements.size() > 1 ? "\n" : "") + judging::human_text(one));
  }
  if (badge) badge->append(report::judge_badge(judgements.front()));
  if (!judgements.empty())
    json.commit(judgements.size() == 1 ? judgements.front() : Json(judgements), {address_of(badge)});
  if (options.output) write_page(folder, options.files, kept, judgements);
  if (options.files.empty()) print((folder.path() / page_name).string() + "\n");
  return gates_hold ? success : not_met;
}

}  // namespace

void describe_judge(Command& command) {
  auto options = std::make_shared<JudgeOptions>();
  command.summary("Anybody's solver against the certified digits");
  command.examples(judge_help());
  command.list("FILE", options->files, "submissions (JSON or CSV)");
  command.text("--json", options->json, "the judgement as JSON into a file, or - for standard output").called("FILE");
  command.text("--badge", options->badge, "a one-line picture of the digits (SVG)").called("FILE");
  command.text("--output", options->output, "a page of these and of the kept submissions, DIR/judge.html")
      .called("DIR");
  command.runs([options] { return judge(*options); });
}

}  // namespace ehd::cli
