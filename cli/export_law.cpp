// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/export_law.hpp"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "bearing/law_table.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/law_export_text.hpp"
#include "io/output_file.hpp"
#include "workflow/law_export.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

using LawWriter = std::function<std::string(const LawExport& law)>;
LawWriter law_writer_named(const std::string& format, const CaseChanges& changes) {
  if (format == "csv") return law_export_csv;
  if (format == "json")
    return [changes](const LawExport& law) {
      Json json = to_json(law);
      changes.put_into(json);
      return json_text(json);
    };
  if (format == "c") return law_export_c;
  if (format == "matlab") return law_export_matlab;
  throw unknown_word_error("--format", format, "csv, json, c, matlab");
}

bearing::Raceway raceway_named(const std::optional<std::string>& name) {
  if (!name) throw UsageError("export law: --raceway is missing; allowed is inner, outer");
  if (const auto raceway = word_from<bearing::Raceway>(*name)) return *raceway;
  throw unknown_word_error("--raceway", *name, "inner, outer");
}

LawExportRequest request_of(const LawExportOptions& options) {
  if (const auto tabulated = to_string(bearing::Law::ehd); options.law && *options.law != tabulated)
    throw option_error("--law", *options.law,
                       fmt::format("has no table: only {0} is tabulated, the other laws are formulas (ehd bearing "
                                   "--json has their numbers); allowed is {0}",
                                   tabulated));
  LawExportRequest request{.raceway = raceway_named(options.raceway)};
  if (options.knots) request.knots = parse_integer("--knots", *options.knots, {.low = 4, .high = 10000});
  return request;
}

/// A table whose damping is this much worse than the law's own needs a word: its header is easily overlooked.
constexpr double poor_table_of_damping = 0.05;
constexpr int knots_for_damping = 200;  ///< they resolve the place near M = 0.8 where the damping nearly vanishes

void warn_of_damping(const LawExport& law, int knots) {
  const double error = law.table.errors.damping.value_or(0);
  if (error <= poor_table_of_damping || knots >= knots_for_damping) return;
  complain(
      fmt::format("ehd: export law: {}: between its {} knots the table misses the damping by up to {} %; --knots "
                  "{} resolves it",
                  law.case_id, knots, plain(100 * error, 2), knots_for_damping));
}

}  // namespace

int export_law(const LawExportOptions& options) {
  const LawWriter write = law_writer_named(options.format, options.changes);
  const LawExportRequest request = request_of(options);
  const Case one = options.changes.read(options.case_name);
  if (!std::holds_alternative<BearingCase>(one.body))
    throw case_error(one, "", "this is a contact; allowed is a bearing case");
  require_distinct(files_of({one}), {{"--output", options.output.value_or("")}});
  std::optional<OutputFile> file = opened(options.output);
  RequestOptions limits;
  limits.time_limit = options.time_limit;
  const double limit_s = limits.request().time_limit_s;
  const Deadline deadline = deadline_in(options.time_limit_total);
  Request solves = bearing_contact_request();
  ResponseRequest responses = bearing_response_request();
  solves.time_limit_s = responses.time_limit_s = limit_s;
  Progress progress;
  // How many contacts a law needs is not known beforehand.
  const auto counted = [&progress, &one](const std::string& what, auto solve) {
    return [&progress, &one, what, solve, done = 0](const Problem& problem, const auto& asked) mutable {
      progress.show(fmt::format("{}: {} {} ...", one.id, what, ++done));
      return solve(problem, asked);
    };
  };
  ContactMemory memory(counted("contact", deadline.limiting(default_solver().solve)), solves);
  memory.respond_by(counted("response", deadline.limiting(bearing_responder())), responses);
  try {
    const LawExport law = export_law(one, request, memory);
    progress.show("");
    warn_of_damping(law, request.knots);
    if (file) {
      file->append(write(law));
      file->commit();
      for (const std::string& line : law_export_words(law)) print(line + "\n");
    } else {
      print(write(law));
    }
    if (law.status == StopReason::converged) return success;
    complain(fmt::format("ehd: export law: {}: {}: {}", one.id, to_string(law.status), law.why));
    return not_met;
  } catch (const LawFailure& failure) {
    progress.show("");
    complain(fmt::format("ehd: export law: {}: {}", one.id, failure.what()));
    return not_met;
  }
}

}  // namespace ehd::cli
