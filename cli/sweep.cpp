// SPDX-License-Identifier: GPL-3.0-or-later
// ehd sweep: a case over lists and ranges of its keys.
#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "cli/interruption.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/duration.hpp"
#include "io/sweep_file.hpp"
#include "io/sweep_run.hpp"
#include "io/sweep_shards.hpp"

namespace ehd::cli {

namespace {

struct SweepOptions {
  std::string file;
  std::optional<std::string> output, threads, shard;
  std::optional<std::string> time_limit_total;
  bool fresh = false, merge = false, keep_limits = false;
  RequestOptions limits;
};

const char* const sweep_examples = R"(
A sweep file:
  case = "na4908"                     # an id, or a path from the folder of this file
  laws = ["hertz", "ehd"]             # of a bearing; of a contact: solver, tolerance
  combine = "product"                 # or "zip"
  films = "table"                     # of a contact; with [table] M = [2, 1000], L = [2.5, 20]
  [keys]                              # any key of the case that is a number or a text
  "operation.radial_load_N" = { from = 1e3, to = 5e4, points = 20, spacing = "logarithmic" }
  "bearing.clearance_m" = [0.0, 2.5e-6, 1e-5]
  "datum.load_N" = [9289.0]           # one x_0; the default follows each row's own load

Examples:
  ehd sweep examples/sweeps/na4908-load-clearance.toml       rows.csv and rows.json into out/sweep/na4908-load-clearance
  ehd sweep FILE --output DIR --threads 1
  ehd sweep FILE --output DIR --shard 2/8                    the second of eight parts, on any machine
  ehd sweep FILE --output DIR --merge                        the same files from all eight
  parallel ehd sweep FILE --output DIR --shard {}/8 ::: 1 2 3 4 5 6 7 8

Finished rows are kept: the same command goes on where it was interrupted, and a sweep that has grown computes what
is new. A row that lacked time or memory is tried again, unless --keep-limits is given.
Exit code: 0 all rows converged; 1 one did not, its line has the status and the reason; 2 bad input or usage.)";

/// K/N. Throws UsageError.
Shard shard_from(const std::string& text) {
  const auto slash = text.find('/');
  constexpr const char* allowed = "K/N with 1 <= K <= N, as 2/8";
  if (slash == std::string::npos) throw option_error("--shard", text, std::string("is no part; allowed is ") + allowed);
  int number = 0, of = 0;
  try {
    constexpr ehd::allowed::Integer any{.low = 1, .high = std::numeric_limits<int>::max()};
    number = parse_integer("--shard", text.substr(0, slash), any);
    of = parse_integer("--shard", text.substr(slash + 1), any);
  } catch (const UsageError&) {
    throw option_error("--shard", text, std::string("is no part; allowed is ") + allowed);
  }
  if (number > of) throw option_error("--shard", text, std::string("is out of range; allowed is ") + allowed);
  return {static_cast<std::size_t>(number), static_cast<std::size_t>(of)};
}

/// A progress bar with the time left, estimated from the rows computed in this run.
class Bar {
 public:
  explicit Bar(std::string name) : name_(std::move(name)), begin_(Clock::now()), shown_(begin_) {}
  void show(std::size_t known, std::size_t all, std::size_t computed) {
    const auto now = Clock::now();
    constexpr auto pause = std::chrono::milliseconds(100);
    if (computed > 0 && known < all && now - shown_ < pause) return;
    shown_ = now;
    constexpr std::size_t width = 24;
    const std::size_t full = all > 0 ? width * known / all : width;
    std::string line =
        fmt::format("[{}{}] {}/{} rows", std::string(full, '#'), std::string(width - full, ' '), known, all);
    if (computed > 0 && known < all) {
      const double passed = std::chrono::duration<double>(now - begin_).count();
      line += ", " + duration(passed * static_cast<double>(all - known) / static_cast<double>(computed)) + " left";
    }
    progress_.show(line + "  " + name_);
  }
  void clear() { progress_.show(""); }

 private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  Clock::time_point begin_, shown_;
  Progress progress_;
};

std::string summary(const Sweep& sweep, const SweepCost& cost, const std::string& what) {
  std::string laws;
  for (const bearing::Law law : sweep.laws) laws += (laws.empty() ? ", laws " : ", ") + std::string(to_string(law));
  std::string text = fmt::format("{}: {} rows of {}{}{}\n", sweep.id, cost.rows, sweep.case_id, laws, what);
  text += fmt::format("  rows computed {}, known before or equal to another {}{}, not converged {}\n", cost.computed,
                      cost.rows - cost.computed - cost.not_run,
                      cost.not_run > 0 ? fmt::format(", not run {}", cost.not_run) : "",
                      cost.failures.rows - cost.failures.not_run);
  if (cost.computed > 0)
    text += fmt::format(
        "  contact solves made {}, saved {} (rows that share a contact solve it once)\n  time {} on {}{}", cost.solves,
        cost.saved(), duration(cost.wall_s), cost.threads, cost.threads == 1 ? " thread\n" : " threads\n");
  return text;
}

int sweep(const SweepOptions& options) {
  SweepRequest request;
  const Request limits = options.limits.request();
  request.max_iterations = limits.max_iterations;
  request.time_limit_s = limits.time_limit_s;
  request.fresh = options.fresh;
  request.keep_limits = options.keep_limits;
  request.threads = thread_count(options.threads);
  std::optional<Shard> shard;
  if (options.shard) shard = shard_from(*options.shard);
  if (shard && options.merge) throw UsageError("--shard and --merge exclude each other; allowed is one of them");
  if (options.merge && options.fresh)
    throw UsageError("--merge and --fresh exclude each other; allowed is one of them");
  if (options.output && options.output->empty()) throw option_error("--output", "", "is empty; allowed is a folder");
  const Sweep asked = read_sweep_statement(options.file);
  if (!options.merge) require_cases(asked, rows_of(asked, shard.value_or(Shard{})), request.threads);
  const OutputFolder folder(options.output.value_or("out/sweep/" + asked.id));

  say_when_interrupted("ehd: sweep: interrupted; the finished rows are kept, and the same command goes on from there");
  Bar bar(asked.id);
  request.progress = [&bar](std::size_t known, std::size_t all, std::size_t computed) {
    bar.show(known, all, computed);
  };
  request.deadline = deadline_in(options.time_limit_total);
  SweepCost cost;
  std::string what;
  if (options.merge) {
    cost = merge_shards(asked, request, folder.path());
    what = ", merged";
  } else if (shard) {
    cost = run_shard(asked, request, folder.path(), *shard);
    what = fmt::format(", shard {} of {}", shard->number, shard->of);
  } else {
    cost = run_sweep(asked, request, folder.path());
  }
  bar.clear();
  std::string text = summary(asked, cost, what);
  if (!shard) text += "  " + (folder.path() / "rows.csv").string() + ", rows.json\n";
  print(text);
  if (cost.failures.rows == 0) return success;
  const std::size_t not_run = cost.failures.not_run, ended = cost.failures.rows - not_run;
  complain(fmt::format("ehd: sweep: {} of {} rows did not converge{}; {}", ended, cost.rows,
                       not_run > 0 ? fmt::format(", {} were not run", not_run) : "", cost.failures.first));
  return not_met;
}

}  // namespace

void describe_sweep(Command& command) {
  auto options = std::make_shared<SweepOptions>();
  command.summary("A case over lists and ranges of its keys, as CSV and JSON");
  command.examples(sweep_examples);
  command.text("FILE", options->file, "the sweep (TOML)").required();
  command.text("--output", options->output, "folder for the rows (out/sweep/ID)").called("DIR");
  command.text("--threads", options->threads, "rows computed side by side (as many as there are cores)").called("N");
  command.text("--shard", options->shard, "compute the K-th of N parts alone").called("K/N");
  command.flag("--merge", options->merge, "put finished shards together");
  command.flag("--fresh", options->fresh, "compute every row again");
  command.flag("--keep-limits", options->keep_limits,
               "do not try again the rows that lacked time or memory in an earlier run");
  options->limits.add_to(command, false);
  add_time_limit_total(command, options->time_limit_total);
  command.runs([options] { return sweep(*options); });
}

}  // namespace ehd::cli
