// SPDX-License-Identifier: GPL-3.0-or-later
// ehd verify: the verification suite.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/interruption.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/duration.hpp"
#include "io/json.hpp"
#include "verification/studies/figures/figures.hpp"
#include "verification/suite.hpp"
#include "verification/traceability.hpp"

namespace ehd::cli {

namespace {

struct VerifyOptions {
  std::optional<std::string> rung, case_id, output, random_runs, time_limit_total;
  bool quick = false, all = false, trace = false;
};

const char* const verify_examples = R"(
Examples:
  ehd verify                            every rung, every case
  ehd verify --quick                    without the slow topics, in two minutes on two idle cores
  ehd verify --rung 7 --all             one rung, each claim with its numbers
  ehd verify --case own-moes-20-10
  ehd verify --random-runs 50 --rung 8  error bars at 50 random runs of each law set, in six minutes
  ehd verify --output out/verify        leaves out/verify/results.json

After the time of --time-limit-total no topic begins. Solves end at their next iteration, and topics that are not
finished are left out; nothing bounds what a topic does between solves (a few seconds). After Ctrl-C or SIGTERM,
results.json has the finished topics. Either way, it is no success.

Rungs: 0 inputs, 1 kernel, 2 operator, 3 elasticity, 4 Reynolds, 5 coupled, 6 solvers, 7 twins, 8 grids, 9 regimes,
10 published, 11 bearing. Exit code: 0 every claim passes, or all are skipped, each with its reason; 1 a claim fails or
is inconclusive; 2 wrong usage.)";

verification::SuiteRequest suite_request(const VerifyOptions& options) {
  verification::SuiteRequest request;
  if (options.rung) {
    request.rung = parse_integer("--rung", *options.rung, {.low = 0, .high = verification::rungs - 1});
  }
  request.case_id = options.case_id;
  request.quick = options.quick;
  if (options.random_runs)
    request.random_runs = parse_integer("--random-runs", *options.random_runs, {.low = 1, .high = 10000});
  request.deadline = deadline_in(options.time_limit_total);
  return request;
}

/// What a report draws; null without --output, and where the time for everything has passed.
Json figures_of(const verification::SuiteRequest& request, bool asked) {
  if (!asked || request.deadline.passed()) return {};
  verification::FiguresRequest pictures{.rung = request.rung,
                                        .case_id = request.case_id,
                                        .quick = request.quick,
                                        .threads = request.threads,
                                        .deadline = request.deadline};
  Progress progress;
  pictures.progress = [&](std::size_t done, std::size_t all, const std::string& name) {
    progress.step(done, all, "figures: " + name);
  };
  return verification::figures(pictures);
}

/// The line until the next topic ends: its times go on.
Progress::Line line_after(const verification::SuiteProgress& topic) {
  return [topic, begin = std::chrono::steady_clock::now()](double) {
    const double since_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double left_s = topic.left_s - since_s;
    return fmt::format("verify {}/{}, {}{}: {} ended", topic.done, topic.all, duration(topic.elapsed_s + since_s),
                       left_s > 0 ? fmt::format(", about {} left", duration(left_s)) : "", topic.name);
  };
}

/// Writes the topics that are finished, without figures. Returns the line for standard error.
std::string keep_topics(const verification::SuiteRun& run, OutputFolder& folder) {
  const verification::SuiteResult result = run.stopped();
  const std::size_t all = result.topics.size(), finished = all - result.not_run;
  if (folder.path().empty() || finished == 0) return "ehd: verify: interrupted; nothing is kept";
  folder.write("results.json", json_text(to_json(result)));
  folder.commit();
  return fmt::format("ehd: verify: interrupted; {} has {} of {} topics", (folder.path() / "results.json").string(),
                     finished, all);
}

int verify(const VerifyOptions& options) {
  verification::SuiteRequest request = suite_request(options);
  OutputFolder folder(options.output);
  folder.open({"results.json"});
  verification::SuiteResult result;
  Json figures;
  try {
    Progress progress;
    request.progress = [&](const verification::SuiteProgress& now) { progress.show(line_after(now)); };
    progress.show("verify: the first topic ...");
    verification::SuiteRun run(request);
    const KeepWhenInterrupted kept([&] { return keep_topics(run, folder); });
    result = run.judge();
    progress.show("");
    figures = figures_of(request, options.output.has_value());
  } catch (const verification::NothingSelected& nothing) {
    throw UsageError(nothing.what());
  }
  if (options.output) {
    Json json = to_json(result);
    if (!figures.is_null()) json["figures"] = figures;
    folder.write("results.json", json_text(json));
    folder.commit();
  }
  print(human_summary(result, options.all));
  if (options.trace) print("\n" + human_trace(trace(verification::traceable_parts(), {result.claims, result.skipped})));
  if (result.success()) {
    if (options.output && figures.is_null()) complain("ehd: verify: no time was left for the report's figures");
    return success;
  }
  if (result.not_run > 0) {
    complain(
        fmt::format("ehd: verify: the time for everything is too short; {} topics were not run, or not to their end",
                    result.not_run));
    return not_met;
  }
  std::size_t standing = 0;
  for (const auto& claim : result.claims) standing += claim.verdict == verification::Verdict::pass ? 1 : 0;
  complain(
      fmt::format("ehd: verify: {} of {} claims do not stand", result.claims.size() - standing, result.claims.size()));
  return not_met;
}

}  // namespace

void describe_verify(Command& command) {
  auto options = std::make_shared<VerifyOptions>();
  command.summary("Run the verification suite");
  command.examples(verify_examples);
  command.text("--rung", options->rung, "one rung of the ladder, 0 to 11");
  command.text("--case", options->case_id, "one case: an id, or a path to a TOML file").called("CASE");
  command.flag("--quick", options->quick, "leave out the slow cases");
  command.flag("--all", options->all, "print every claim, not only those that do not stand");
  command.flag("--trace", options->trace, "print which claims support which part of the work");
  command.text("--random-runs", options->random_runs, "random runs for each law set (10)");
  command.text("--output", options->output, "folder for results.json");
  add_time_limit_total(command, options->time_limit_total);
  command.runs([options] { return verify(*options); });
}

}  // namespace ehd::cli
