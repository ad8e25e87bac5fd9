// SPDX-License-Identifier: GPL-3.0-or-later
// ehd bench: what the solvers cost. Work against precision, cost against size, many contacts over threads.
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common.hpp"
#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "io/provenance.hpp"
#include "io/tables.hpp"
#include "verification/bench/batch_bench.hpp"
#include "verification/bench/box_bench.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "verification/bench/work_precision.hpp"

namespace ehd::cli {

namespace {

constexpr int schema = 1;
constexpr double usual_time_limit_s = 30;

struct BenchOptions {
  std::vector<std::string> parts, cases, solvers;
  std::optional<std::string> output;
  RequestOptions limits;
  bool quick = false;
};

const char* examples = R"(
Examples:
  ehd bench --output out/bench                  every part, in a quarter of an hour
  ehd bench --quick                             a short set of each, in under a minute
  ehd bench --part work-precision --case own-moes-20-10 --solver fast --solver reference
  ehd bench --part scaling
  ehd bench --part batch
  ehd bench --part box --solver fast            232 contacts, with truths: five minutes on two cores

Parts: work-precision (run time and work against achieved error), scaling (cost and memory against the number of
intervals), batch (many contacts over threads), and, where it is asked for, box (times and errors over all loads and
materials). DIR/bench.json holds the parts of this run; work-precision leaves DIR/work_precision.csv too, scaling
DIR/scaling.csv, box DIR/box.csv. A solve that fails is a row with its reason. Exit code: 0 the tables
are there; 1 not one run could be judged, or results depend on the number of threads; 2 wrong usage.)";

constexpr const char* work_precision = "work-precision";
constexpr const char* scaling = "scaling";
constexpr const char* batch = "batch";
constexpr const char* box = "box";
constexpr const char* all_parts[] = {work_precision, scaling, batch, box};
constexpr const char* usual_parts[] = {work_precision, scaling, batch};

std::vector<const RegisteredSolver*> chosen_solvers(const std::vector<std::string>& names) {
  std::vector<const RegisteredSolver*> chosen;
  if (names.empty()) {
    for (const auto& solver : solvers()) chosen.push_back(&solver);
  }
  for (const auto& name : names) {
    const RegisteredSolver* solver = &solver_named(name);
    if (std::find(chosen.begin(), chosen.end(), solver) == chosen.end()) chosen.push_back(solver);
  }
  return chosen;
}

/// Those that a part is about: a batch of contacts, or a million intervals, is not for dense solvers.
std::vector<const RegisteredSolver*> with_fft(std::vector<const RegisteredSolver*> solvers) {
  std::erase_if(solvers, [](const RegisteredSolver* solver) { return !solver->uses_fft; });
  return solvers;
}

int bench(const BenchOptions& options) {
  std::vector<std::string> parts = options.parts;
  for (const auto& part : parts) {
    if (std::find(std::begin(all_parts), std::end(all_parts), part) == std::end(all_parts))
      throw option_error("--part", part, "is unknown; allowed is work-precision, scaling, batch, box");
  }
  if (parts.empty()) parts.assign(std::begin(usual_parts), std::end(usual_parts));
  const auto asked = [&](const char* part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
  const auto solvers = chosen_solvers(options.solvers);
  const auto fft_solvers = with_fft(solvers);
  if (!options.cases.empty() && !asked(work_precision))
    throw option_error("--case", options.cases.front(), "belongs to the part work-precision, which is not run");
  if (!asked(work_precision) && fft_solvers.empty())
    throw option_error("--solver", solvers.front()->name,
                       "uses no FFT; allowed in scaling, batch and box are those that do");
  Request limits = options.limits.request();
  if (!options.limits.time_limit) limits.time_limit_s = usual_time_limit_s;

  verification::WorkPrecisionRequest precision{.cases = {}, .solvers = solvers};
  if (asked(work_precision))
    precision.cases = verification::contacts_named(
        options.cases.empty() ? verification::work_precision_cases(options.quick) : options.cases);

  // Opened before the work begins: a folder that cannot be written is bad input, not a lost run.
  std::optional<OutputFolder> folder;
  std::optional<OutputFile> json_file, work_csv, scaling_csv, box_csv;
  if (options.output) {
    folder.emplace(*options.output);
    json_file.emplace(folder->path() / "bench.json");
    if (asked(work_precision)) work_csv.emplace(folder->path() / "work_precision.csv");
    if (asked(box)) box_csv.emplace(folder->path() / "box.csv");
    if (asked(scaling)) scaling_csv.emplace(folder->path() / "scaling.csv");
  }

  Progress progress;
  const auto show = [&](const std::string& what) { progress.show("bench " + what); };
  Json json;
  json["schema"] = schema;
  json["provenance"] = provenance();
  json["settings"] = {{"quick", options.quick}, {"time_limit_s", limits.time_limit_s}, {"parts", parts}};
  bool sound = true;
  // First, while this process is small: its children begin with what it holds.
  if (asked(scaling) && !fft_solvers.empty()) {
    auto request = verification::usual_scaling(fft_solvers, options.quick);
    request.time_limit_s = limits.time_limit_s;
    request.progress = show;
    const auto rows = run_scaling(request);
    json["scaling"] = to_json(rows);
    if (scaling_csv) scaling_csv->commit(verification::scaling_csv(rows));
    progress.show("");
    print(human_table(rows));
  }
  if (asked(batch) && !fft_solvers.empty()) {
    verification::BatchRequest request{.solvers = fft_solvers, .problems = verification::batch_problems(options.quick)};
    request.time_limit_s = limits.time_limit_s;
    const unsigned cores = std::max(2u, std::thread::hardware_concurrency());
    for (unsigned threads = 4; threads <= cores; threads *= 2) request.threads.push_back(threads);
    request.progress = show;
    const auto rows = run_batch(request);
    json["batch"] = to_json(rows);
    progress.show("");
    print(human_table(rows));
    if (!std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.same_results; })) {
      complain("ehd: bench: results depend on the number of threads");
      sound = false;
    }
  }
  if (asked(box) && !fft_solvers.empty()) {
    verification::BoxRequest request{.solvers = fft_solvers, .contacts = verification::bench_contacts(options.quick)};
    request.truth = find_solver("reference");
    request.time_limit_s = limits.time_limit_s;
    request.threads = std::max(1u, std::thread::hardware_concurrency());
    request.progress = show;
    const auto rows = verification::run_box_bench(request);
    json["box"] = to_json(rows);
    if (box_csv) box_csv->commit(verification::box_csv(rows));
    progress.show("");
    print(human_table(rows));
  }
  if (asked(work_precision)) {
    precision.quick = options.quick;
    precision.time_limit_s = limits.time_limit_s;
    precision.progress = show;
    const auto result = run_work_precision(precision);
    json["work_precision"] = to_json(result);
    if (work_csv) work_csv->commit(verification::work_precision_csv(result));
    progress.show("");
    print(human_table(result));
    if (!result.anything_judged()) {
      complain("ehd: bench: not one run could be judged");
      sound = false;
    }
  }
  if (json_file) json_file->commit(json_text(json));
  return sound ? success : not_met;
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand("bench", "Run time and work against achieved error; scaling; many contacts");
  command->footer(examples);
  command->add_option("--output", options->output, "folder for bench.json, work_precision.csv and scaling.csv")
      ->type_name("DIR");
  command->add_option("--part", options->parts, "work-precision, scaling, batch or box (repeatable; all but box)")
      ->type_name("PART")
      ->allow_extra_args(false);
  command->add_option("--case", options->cases, "a contact case for work-precision (repeatable; the benchmark's own)")
      ->type_name("CASE")
      ->allow_extra_args(false);
  command->add_option("--solver", options->solvers, "one of " + solver_names() + " (repeatable; all)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--time-limit", options->limits.time_limit, "seconds for each solve (30)")->type_name("S");
  command->add_flag("--quick", options->quick, "a short set of everything");
  command->callback([options, &exit_code] { run_guarded(exit_code, [&] { return bench(*options); }); });
}

}  // namespace ehd::cli
