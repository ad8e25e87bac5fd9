// SPDX-License-Identifier: GPL-3.0-or-later
// ehd atlas: the certified solutions over M and L, with the digits that are known.
#include "verification/atlas/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/interruption.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/duration.hpp"
#include "verification/atlas/motion.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

/// A point of the atlas of motion has up to 32 numbers; the slowest took 40 s of an idle processor.
constexpr double motion_time_limit_s = 200;

struct AtlasOptions {
  std::optional<std::string> output, tolerance, time_limit, threads, only;
  bool fresh = false, motion = false;
};

const char* const atlas_examples = R"(
Examples:
  ehd atlas --output out/atlas             the whole atlas
  ehd atlas --output out/atlas --only roelands-m20-
                                           the points with this in their id; the others stay as they are
  ehd atlas                                the whole atlas, in the place of the digits in cases/atlas
  ehd atlas --motion                       stiffness, damping and waviness: kappa.csv, waviness.csv
  ehd atlas --only barus --fresh           solved again; the results of an earlier run are not used

An interrupted run continues where it ended: every solved point leaves a record in DIR/.progress. The record is valid
until the solver or the tolerance changes, or the time limit of a point that ran out of time. A point that is not known
to 1e-4 is listed without digits. Exit code: 0 the atlas is written; 1 no point has digits; 2 bad input or usage.)";

/// One line a point on standard error.
std::string progress_line(std::size_t done, std::size_t all, const verification::AtlasRecord& record, bool motion) {
  const auto known = [&](const char* name) -> std::string {
    const auto at = record.readings.find(name);
    if (at == record.readings.end()) return "none";
    return with_absolute_error(at->second.value, at->second.error);
  };
  return fmt::format("[{:>{}}/{}] {}: {}, {}, {} s", done, fmt::formatted_size("{}", all), all, record.id,
                     to_string(record.status),
                     motion ? fmt::format("kappa_0 {}, kappa_1 {}", known("stiffness 0"), known("damping 0"))
                            : fmt::format("H_min {}, H_cen {}", known("H_min"), known("H_cen")),
                     plain(record.wall_s, 3));
}

/// Results that are known less well must not replace the digits that stand in the program's own cases.
void require_own_folder(const AtlasOptions& options, double time_limit_s, double usual_time_limit_s) {
  if (options.output) return;
  const auto refuse = [](const char* name, const std::string& value) {
    throw option_error(name, value,
                       "may leave fewer digits than stand in cases/atlas; allowed is another folder with it, --output");
  };
  if (options.tolerance) refuse("--tolerance", *options.tolerance);
  if (options.time_limit && time_limit_s < usual_time_limit_s) refuse("--time-limit", *options.time_limit);
}

int atlas(const AtlasOptions& options) {
  RequestOptions limits;
  limits.tolerance = options.tolerance;
  limits.time_limit = options.time_limit;
  const Request checked = limits.request();

  verification::AtlasRequest request;
  request.points = options.motion ? verification::motion_points() : verification::atlas_points();
  request.only = options.only.value_or("");
  if (options.tolerance) {
    request.tolerance = checked.tolerance.tightest();
    if (*request.tolerance > verification::atlas_worst_error)
      throw option_error(
          "--tolerance", *options.tolerance,
          "is too loose for digits; allowed is a number > 0, up to " + plain(verification::atlas_worst_error));
  }
  if (options.motion) request.time_limit_s = motion_time_limit_s;
  require_own_folder(options, checked.time_limit_s, request.time_limit_s);
  if (options.time_limit) request.time_limit_s = checked.time_limit_s;
  request.threads = thread_count(options.threads);
  request.fresh = options.fresh;
  if (verification::selected_points(request).empty())
    throw option_error("--only", request.only,
                       "is in no id; allowed is a part of an id like " + request.points.back().id());
  if (options.output && options.output->empty()) throw option_error("--output", "", "is empty; allowed is a folder");
  request.folder = options.output ? std::filesystem::path(*options.output) : verification::atlas_folder();

  const auto begin = std::chrono::steady_clock::now();
  std::size_t reused_so_far = 0;
  bool told = false;
  request.progress = [&](std::size_t done, std::size_t all, const verification::AtlasRecord& record, bool reused) {
    reused_so_far += reused ? 1 : 0;
    if (!told && reused_so_far > 0 && (!reused || done == all)) {
      complain(fmt::format("{} of {} points are known from an earlier run", reused_so_far, all));
      told = true;
    }
    if (reused) return;
    const double passed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double left_s = passed_s * static_cast<double>(all - done) / static_cast<double>(done - reused_so_far);
    complain(fmt::format("{}{}", progress_line(done, all, record, options.motion),
                         done < all ? fmt::format(", about {} left", duration(left_s)) : ""));
  };
  say_when_interrupted("ehd: atlas: interrupted; the solved points are kept, and the same command goes on from there");
  const auto result = options.motion ? verification::run_motion_atlas(request, certified_solver())
                                     : verification::run_atlas(request, certified_solver());
  print(options.motion ? human_motion_summary(result) : human_summary(result));
  const bool any = std::any_of(result.entries.begin(), result.entries.end(), [&](const auto& entry) {
    return options.motion ? !entry.record.readings.empty() : entry.record.has_digits();
  });
  if (any) return success;
  complain(fmt::format("ehd: atlas: not one of {} points is known to 1e-4", result.entries.size()));
  return not_met;
}

}  // namespace

void describe_atlas(Command& command) {
  auto options = std::make_shared<AtlasOptions>();
  command.summary("Solve the atlas of line contacts");
  command.examples(atlas_examples);
  command.text("--output", options->output, "folder for atlas.csv, digits.txt and the case files (cases/atlas)")
      .called("DIR");
  command.flag("--motion", options->motion, "stiffness, damping and waviness instead of the films at rest");
  command
      .text("--tolerance", options->tolerance,
            "relative error allowed in the minimum and central film (1e-10; Barus 1e-9), or in kappa and amplitudes "
            "(1e-5)")
      .called("T");
  command.text("--time-limit", options->time_limit, "seconds for each solve (30), or each point in motion (200)")
      .called("S");
  command.text("--threads", options->threads, "points solved side by side (as many as there are cores)").called("N");
  command.text("--only", options->only, "only points with this in their id").called("SUBSTRING");
  command.flag("--fresh", options->fresh, "solve every point again");
  command.runs([options] { return atlas(*options); });
}

}  // namespace ehd::cli
