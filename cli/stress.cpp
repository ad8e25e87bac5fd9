// SPDX-License-Identifier: GPL-3.0-or-later
// ehd stress: numerical stability under starts, precision, rounding, condition and extreme inputs.
#include "verification/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/interruption.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/json.hpp"
#include "verification/bench/timing.hpp"

namespace ehd::cli {

namespace {

struct StressOptions {
  std::vector<std::string> parts;
  std::optional<std::string> output, threads;
  bool quick = false;
};

const char* const stress_examples = R"(
Examples:
  ehd stress --output out/stress     every part, in half an hour; leaves out/stress/stress.json
  ehd stress --quick                 a small form of each, in a minute on two idle cores
  ehd stress --part d --part e       two parts

Parts: a box (every load and material), b starts (random first states), c precision (double against long double and
34 digits), d rounding (the four rounding modes), e condition (inputs moved by one ulp and by 1e-8), f grids (2^4 to
2^20 intervals), g extremes (random and impossible inputs, limits), h repeatability (the same bits again), i random
bearings (every force law), j motion (random stiffness and damping), k films (stated errors at random contacts). After
Ctrl-C or SIGTERM, stress.json has the finished parts, and the others as inconclusive. Exit code: 0 every part that ran
passes; 1 one fails or is inconclusive; 2 wrong usage.)";

/// Writes the finished parts; the others are inconclusive. Returns the line for standard error.
std::string keep_parts(std::vector<verification::stress::Part> parts,
                       const std::vector<const verification::stress::PartEntry*>& chosen,
                       const verification::stress::Scope& scope, OutputFolder& folder,
                       const verification::Stopwatch& watch) {
  const std::size_t finished = parts.size();
  if (folder.path().empty() || finished == 0) return "ehd: stress: interrupted; nothing is kept";
  for (std::size_t k = finished; k < chosen.size(); ++k) parts.push_back(interrupted_part(*chosen[k], scope));
  folder.write("stress.json", json_text(to_json(parts, watch.seconds())));
  folder.commit();
  return fmt::format("ehd: stress: interrupted; {} has {} of {} parts", (folder.path() / "stress.json").string(),
                     finished, chosen.size());
}

/// Runs the parts one after the other and prints each. A signal keeps those that are finished.
std::vector<verification::stress::Part> run_parts(const std::vector<const verification::stress::PartEntry*>& chosen,
                                                  verification::stress::Scope scope, OutputFolder& folder,
                                                  const verification::Stopwatch& watch) {
  using namespace verification::stress;
  std::vector<Part> results;
  std::mutex mutex;  // of the results
  const KeepWhenInterrupted kept([&, scope] {
    const std::lock_guard lock(mutex);
    return keep_parts(results, chosen, scope, folder, watch);
  });
  Progress progress;
  for (const PartEntry* entry : chosen) {
    scope.progress = [&](const std::string& what) {
      progress.step(results.size(), chosen.size(), fmt::format("({}) {}: {}", entry->id, entry->name, what));
    };
    scope.show("...");
    Part part = run_part(*entry, scope);
    progress.show("");
    KeepWhenInterrupted::before_recording();
    {
      const std::lock_guard lock(mutex);
      results.push_back(std::move(part));
    }
    print(human_text(results.back()));
  }
  return results;
}

int stress(const StressOptions& options) {
  using namespace verification::stress;
  std::vector<const PartEntry*> chosen;
  for (const auto& text : options.parts) {
    const PartEntry* part = find_part(text);
    if (!part) throw option_error("--part", text, "is unknown; allowed is a to k, or the name of a part");
    if (std::find(chosen.begin(), chosen.end(), part) == chosen.end()) chosen.push_back(part);
  }
  if (chosen.empty()) {
    for (const PartEntry& part : parts()) chosen.push_back(&part);
  }
  Scope scope{.quick = options.quick};
  scope.threads = thread_count(options.threads);

  OutputFolder folder(options.output);
  folder.open({"stress.json"});
  const verification::Stopwatch watch;
  const std::vector<Part> results = run_parts(chosen, scope, folder, watch);
  if (results.size() > 1) print(human_summary(results));
  folder.write("stress.json", json_text(to_json(results, watch.seconds())));
  folder.commit();
  if (all_passed(results)) return success;
  std::string open;
  for (const Part& part : results) {
    if (part.verdict != verification::Verdict::pass)
      open += fmt::format("{}{} {}", open.empty() ? "" : ", ", part.id, part.name);
  }
  complain("ehd: stress: not passed: " + open);
  return not_met;
}

}  // namespace

void describe_stress(Command& command) {
  auto options = std::make_shared<StressOptions>();
  command.summary("Numerical stability: starts, precision, rounding, condition, extremes");
  command.examples(stress_examples);
  command.text("--output", options->output, "folder for stress.json").called("DIR");
  command.list("--part", options->parts, "a to k, or its name (repeatable; all)").called("PART");
  command.text("--threads", options->threads, "threads (as many as there are cores)").called("N");
  command.flag("--quick", options->quick, "a small form of every part");
  command.runs([options] { return stress(*options); });
}

}  // namespace ehd::cli
