// SPDX-License-Identifier: GPL-3.0-or-later
// ehd bench: the cost of the solvers: work against precision, cost against size, many contacts over threads.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/interruption.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/json.hpp"
#include "io/provenance.hpp"
#include "verification/bench/answer_cost.hpp"
#include "verification/bench/batch_bench.hpp"
#include "verification/bench/box_bench.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "verification/bench/first_solve.hpp"
#include "verification/bench/response_cost.hpp"
#include "verification/bench/work_precision.hpp"
#include "verification/report/schemas.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

constexpr double usual_time_limit_s = 30;

struct BenchOptions {
  std::vector<std::string> parts, cases, solvers;
  std::optional<std::string> output;
  RequestOptions limits;
  bool quick = false;
};

const char* const bench_examples = R"(
Examples:
  ehd bench --output out/bench                  every part, in 10 to 15 minutes
  ehd bench --quick                             a short set of each, in a minute on idle cores
  ehd bench --part work-precision --case own-moes-20-10 --solver fast --solver reference
  ehd bench --part scaling
  ehd bench --part batch
  ehd bench --part convolution                  c, the yardstick of all times on this machine: a second
  ehd bench --part first                        the first solve of a process and a later one: a second
  ehd bench --part cost                         what each answer of fast costs, in ms and in c: half a minute
  ehd bench --part response                     what stiffness and damping cost: a minute
  ehd bench --part box --solver fast            232 contacts, with true values: five minutes on two cores

Parts: work-precision (run time and work against achieved error), scaling (cost and memory against the number of
intervals), batch (many contacts over threads), cost (what each answer costs in ms and c: a film, both films, many
contacts, a bearing, a process), response (what a frequency costs beyond the steady state, and a bearing's stiffness and
damping beyond its balance); only where they are named, box (times and errors over all loads and materials),
convolution (c, one padded FFT convolution of n = 512) and first (what the first solve of a process costs beside a later
one: planning, new memory). DIR/bench.json holds the parts of this run;
DIR/work_precision.csv, DIR/scaling.csv and DIR/box.csv hold the tables. A solve that fails is a row with its reason.
After Ctrl-C or SIGTERM, the files hold the finished parts, and bench.json names those that are left out.

Exit code: 0 the tables are complete; 1 no run could be judged, or results depend on the number of threads; 2 wrong
usage.)";

constexpr const char* work_precision = "work-precision";
constexpr const char* scaling = "scaling";
constexpr const char* batch = "batch";
constexpr const char* box = "box";
constexpr const char* convolution = "convolution";
constexpr const char* first_solves = "first";
constexpr const char* answer_cost = "cost";
constexpr const char* response_cost = "response";
constexpr const char* all_parts[] = {work_precision, scaling, batch,       answer_cost,
                                     response_cost,  box,     convolution, first_solves};
constexpr const char* usual_parts[] = {work_precision, scaling, batch, answer_cost, response_cost};

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

/// The solvers for scaling, batch and box. Many contacts, or a million intervals, would take dense solvers too long.
std::vector<const RegisteredSolver*> with_fft(std::vector<const RegisteredSolver*> solvers) {
  std::erase_if(solvers, [](const RegisteredSolver* solver) { return solver->dense(); });
  return solvers;
}

/// Throws UsageError.
std::vector<std::string> parts_named(const std::vector<std::string>& names) {
  if (names.empty()) return {std::begin(usual_parts), std::end(usual_parts)};
  for (const auto& name : names) {
    if (std::find(std::begin(all_parts), std::end(all_parts), name) == std::end(all_parts))
      throw unknown_word_error("--part", name, fmt::format("{}", fmt::join(all_parts, ", ")));
  }
  return names;
}

/// One run: its options, its files and its results so far.
class Bench {
 public:
  /// Throws UsageError; opens the files.
  explicit Bench(const BenchOptions& options)
      : parts_(parts_named(options.parts)),
        solvers_(chosen_solvers(options.solvers)),
        fft_solvers_(with_fft(solvers_)),
        quick_(options.quick) {
    require_options_of_parts(options);
    const Request limits = options.limits.request();
    if (options.limits.time_limit) time_limit_s_ = limits.time_limit_s;
    if (asked(work_precision))
      cases_ = verification::contacts_named(options.cases.empty() ? verification::work_precision_cases(quick_)
                                                                  : options.cases);
    folder_.emplace(options.output);
    folder_->open({"bench.json"});
    if (asked(work_precision)) folder_->open({"work_precision.csv"});
    if (asked(box)) folder_->open({"box.csv"});
    if (asked(scaling)) folder_->open({"scaling.csv"});
  }

  [[nodiscard]] int run() {
    json_["schema"] = report::bench_schema.name;
    json_["provenance"] = provenance();
    for (const RegisteredSolver& solver : solvers()) json_["looks"][solver.name] = solver.look;
    json_["settings"] = {{"quick", quick_}, {"time_limit_s", time_limit_s_}, {"parts", parts_}};
    measure_parts();
    write_files();
    return sound_ ? success : not_met;
  }

 private:
  [[nodiscard]] bool asked(const char* part) const {
    return std::find(parts_.begin(), parts_.end(), part) != parts_.end();
  }

  void require_options_of_parts(const BenchOptions& options) const {
    if (!options.cases.empty() && !asked(work_precision))
      throw option_error("--case", options.cases.front(), "belongs to the part work-precision, which is not run");
    if (!asked(work_precision) && fft_solvers_.empty())
      throw option_error("--solver", solvers_.front()->name,
                         "uses no FFT; allowed in scaling, batch, box, first and cost are those that do");
  }

  /// A signal keeps the parts that are finished.
  void measure_parts() {
    const KeepWhenInterrupted kept([this] { return keep_finished(); });
    // Scaling runs first, while this process is small: its child processes begin with the memory of this one.
    if (asked(scaling) && !fft_solvers_.empty()) measure_scaling();
    if (asked(first_solves) && !fft_solvers_.empty()) measure_first();  // before this process plans a transform
    if (asked(convolution)) measure_convolution();
    if (asked(batch) && !fft_solvers_.empty()) measure_batch();
    if (asked(box) && !fft_solvers_.empty()) measure_box();
    if (asked(answer_cost) && !fft_solvers_.empty()) measure_cost();
    if (asked(response_cost)) measure_response();
    if (asked(work_precision)) measure_work_precision();
  }

  /// Records and prints a part: its entry in bench.json and its table in a file of its own, where it has one.
  void finish_part(const char* part, const std::string& table, const char* key, Json entry,
                   const std::string& csv_name = {}, std::string csv = {}) {
    KeepWhenInterrupted::before_recording();
    {
      const std::lock_guard lock(recording_);
      finished_.emplace_back(part);
      json_[key] = std::move(entry);
      if (!csv_name.empty()) tables_[csv_name] = std::move(csv);
    }
    progress_.show("");
    print(table);
  }

  void write_files() {
    for (const auto& [name, csv] : tables_) folder_->write(name, csv);
    folder_->write("bench.json", json_text(json_));
    folder_->commit();
  }

  /// In another thread. Names the parts that are not finished. Returns the line for standard error.
  std::string keep_finished() {
    const std::lock_guard lock(recording_);
    if (folder_->path().empty() || finished_.empty()) return "ehd: bench: interrupted; nothing is kept";
    Json left_out = Json::array();
    for (const std::string& part : parts_)
      if (std::find(finished_.begin(), finished_.end(), part) == finished_.end()) left_out.push_back(part);
    json_["settings"]["left_out"] = left_out;
    write_files();
    return fmt::format("ehd: bench: interrupted; {} has {} of {} parts", (folder_->path() / "bench.json").string(),
                       finished_.size(), parts_.size());
  }

  void measure_scaling() {
    auto request = verification::usual_scaling(fft_solvers_, quick_);
    request.time_limit_s = time_limit_s_;
    request.progress = show_;
    const auto rows = run_scaling(request);
    finish_part(scaling, human_table(rows), "scaling", to_json(rows), "scaling.csv", verification::scaling_csv(rows));
    if (std::none_of(rows.begin(), rows.end(), [](const auto& row) { return row.status.has_value(); })) {
      complain("ehd: bench: not one size was measured: " + (rows.empty() ? "there is none" : rows.front().reason));
      sound_ = false;
    }
  }

  void measure_convolution() {
    constexpr verification::Repetition many{.least = 200, .least_s = 0.05, .enough_s = 0.5, .most = 100000};
    const double c_s = verification::convolution_s(verification::unit_intervals, many);
    constexpr double micro = 1e6;
    finish_part(
        convolution,
        fmt::format("c = {:.2f} us: one padded convolution of n = {}\n", micro * c_s, verification::unit_intervals),
        "convolution", {{"nodes", verification::unit_intervals}, {"c_s", c_s}});
  }

  void measure_first() {
    verification::FirstSolveRequest request{.solvers = fft_solvers_};
    if (quick_) request.contacts.resize(1);
    request.time_limit_s = time_limit_s_;
    request.progress = show_;
    const auto rows = verification::run_first_solves(request);
    finish_part(first_solves, human_table(rows), "first", to_json(rows));
    const auto failed = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return !row.why.empty(); });
    if (failed != rows.end()) {
      complain(fmt::format("ehd: bench: a first solve by {}: {}", failed->solver, failed->why));
      sound_ = false;
    }
  }

  void measure_batch() {
    verification::BatchRequest request{.solvers = fft_solvers_, .problems = verification::batch_problems(quick_)};
    request.time_limit_s = time_limit_s_;
    const unsigned cores = std::max(2u, std::thread::hardware_concurrency());
    for (unsigned threads = 4; threads <= cores; threads *= 2) request.threads.push_back(threads);
    request.progress = show_;
    const auto rows = run_batch(request);
    finish_part(batch, human_table(rows), "batch", to_json(rows));
    if (!std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.same_results; })) {
      complain("ehd: bench: results depend on the number of threads");
      sound_ = false;
    }
  }

  void measure_box() {
    verification::BoxRequest request{.solvers = fft_solvers_, .contacts = verification::bench_contacts(quick_)};
    request.truth = &certified_solver();
    request.time_limit_s = time_limit_s_;
    request.threads = std::max(1u, std::thread::hardware_concurrency());
    request.progress = show_;
    const auto rows = verification::run_box_bench(request);
    finish_part(box, human_table(rows), "box", to_json(rows), "box.csv", verification::box_csv(rows));
  }

  void measure_cost() {
    verification::AnswerCostRequest request{.solver = fft_solvers_.front(), .quick = quick_};
    request.time_limit_s = time_limit_s_;
    request.program = std::filesystem::read_symlink("/proc/self/exe");
    request.progress = show_;
    const auto rows = verification::run_answer_costs(request);
    finish_part(answer_cost, human_table(rows), "cost", to_json(rows));
    const auto failed = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return !row.why.empty(); });
    if (failed != rows.end()) {
      complain(fmt::format("ehd: bench: {}: {}", failed->asked, failed->why));
      sound_ = false;
    }
  }

  /// Of every solver that has a response.
  void measure_response() {
    verification::ResponseCostRequest request{.quick = quick_, .time_limit_s = time_limit_s_};
    request.progress = show_;
    const auto cost = verification::run_response_costs(request);
    finish_part(response_cost, human_table(cost), "response", to_json(cost));
  }

  void measure_work_precision() {
    verification::WorkPrecisionRequest request{.cases = cases_, .solvers = solvers_};
    request.quick = quick_;
    request.time_limit_s = time_limit_s_;
    request.progress = show_;
    const auto result = run_work_precision(request);
    finish_part(work_precision, human_table(result), "work_precision", to_json(result), "work_precision.csv",
                verification::work_precision_csv(result));
    if (!result.anything_judged()) {
      complain("ehd: bench: not one run could be judged");
      sound_ = false;
    }
  }

  std::vector<std::string> parts_;
  std::vector<const RegisteredSolver*> solvers_, fft_solvers_;
  bool quick_ = false;
  double time_limit_s_ = usual_time_limit_s;
  std::vector<Case> cases_;             ///< of work-precision
  std::optional<OutputFolder> folder_;  ///< made after all options are checked
  Progress progress_;
  std::mutex recording_;  ///< of what is finished
  std::vector<std::string> finished_;
  std::map<std::string, std::string> tables_;  ///< CSV, by the name of the file
  std::function<void(const std::string&)> show_ = [this](const std::string& what) {
    progress_.step(finished_.size(), parts_.size(), "bench " + what);
  };
  Json json_;
  bool sound_ = true;
};

}  // namespace

void describe_bench(Command& command) {
  auto options = std::make_shared<BenchOptions>();
  command.summary("Run time and work against achieved error; scaling; many contacts");
  command.examples(bench_examples);
  command.text("--output", options->output, "folder for bench.json, work_precision.csv and scaling.csv").called("DIR");
  command
      .list("--part", options->parts,
            "work-precision, scaling, batch, cost, response, box, convolution or first (repeatable; the first five)")
      .called("PART");
  command.list("--case", options->cases, "a contact case for work-precision (repeatable; the benchmark's own)")
      .called("CASE");
  command.list("--solver", options->solvers, "one of " + solver_names() + " (repeatable; all)")
      .called("NAME")
      .completed_by(solver_names());
  command.text("--time-limit", options->limits.time_limit, "seconds for each solve (30)").called("S");
  command.flag("--quick", options->quick, "a short set of everything");
  command.runs([options] { return Bench(*options).run(); });
}

}  // namespace ehd::cli
