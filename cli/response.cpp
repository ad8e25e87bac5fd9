// SPDX-License-Identifier: GPL-3.0-or-later
// ehd response: stiffness and damping of a contact's film, and what the film leaves of a waviness.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/case_choice.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/solver.hpp"
#include "contact/text.hpp"
#include "io/response_text.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"
#include "workflow/response_run.hpp"

namespace ehd::cli {

namespace {

struct ResponseOptions {
  std::string case_name, solver = default_solver().name;
  std::vector<std::string> omegas, frequencies, wavelengths;
  std::optional<std::string> tolerance, slip, datum, json, csv;
  RequestOptions request;
  CaseChanges changes;
};

const char* const response_examples = R"(
Examples:
  ehd response own-moes-20-10                         stiffness at rest, and damping of slow motion
  ehd response own-moes-20-10 --solver reference      the same, certified
  ehd response own-moes-20-10 --omega 1 --omega 10    at Omega = omega b/u_m, u_m the mean speed
  ehd response steel-roller --frequency 100           at 100 Hz, where the case states a speed
  ehd response own-moes-20-10 --omega 1 --omega 2 --csv kappa.csv   kappa over Omega, for a plot
  ehd response own-moes-20-10 --wavelength 0.5 --slip 1   what is left of a waviness, wavelength in b

kappa = -W_1/H_01 in Hertz units: the load's change over that of the bodies' distance. A negative imaginary part is a
result: the contact is driven by its rolling. Frequencies that are not known within the tolerance end as
tolerance-not-met, with the highest one that is.

Exit code: 0 converged; 1 not converged (the status says how); 2 bad input or usage.)";

/// Allowed ranges. Inside them, a frequency or wave that no mesh resolves ends as tolerance-not-met.
constexpr Interval omega_range{.low = 0, .high = 1e9};
constexpr Interval frequency_range{.low = 0, .high = 1e12};
constexpr Interval wavelength_range{.low = 0.02, .high = 1e4};
constexpr Interval slip_range{.low = 0, .high = 2};
constexpr const char* pure_rolling = "1";
constexpr Interval tolerance_range{.low = 1e-13, .high = 1e-2};
constexpr Interval datum_range{.low = 1e-9, .high = 1e3};

const RegisteredSolver& responsive_solver(const std::string& name) {
  const RegisteredSolver& solver = solver_named(name);
  if (!solver.respond) throw option_error("--solver", name, "has no response; allowed is " + responsive_solver_names());
  return solver;
}

ResponseQuestion question_of(const ResponseOptions& options) {
  ResponseQuestion question{.solver = &responsive_solver(options.solver)};
  const Request limits = options.request.request();
  ResponseRequest& request = question.request;
  request.tolerance = options.tolerance ? parse_number("--tolerance", *options.tolerance, tolerance_range)
                                        : question.solver->response_tolerance;
  request.max_iterations = limits.max_iterations;
  request.time_limit_s = limits.time_limit_s;
  for (const auto& text : options.omegas) request.frequencies.push_back(parse_number("--omega", text, omega_range));
  for (const auto& text : options.frequencies)
    question.frequencies_Hz.push_back(parse_number("--frequency", text, frequency_range));
  const double slip = parse_number("--slip", options.slip.value_or(pure_rolling), slip_range);
  if (options.slip && options.wavelengths.empty())
    throw option_error("--slip", *options.slip, "belongs to a waviness; allowed with --wavelength");
  for (const auto& text : options.wavelengths)
    request.waviness.push_back({.wavelength = parse_number("--wavelength", text, wavelength_range), .slip = slip});
  if (request.frequencies.empty() && question.frequencies_Hz.empty() && request.waviness.empty())
    request.frequencies = {0};
  if (options.datum) question.datum_m = parse_number("--x0-m", *options.datum, datum_range);
  return question;
}

/// "1e-8 by reference, 1e-4 by fast".
std::string default_tolerances() {
  std::string text;
  for (const RegisteredSolver& solver : solvers())
    if (solver.respond)
      text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", plain(solver.response_tolerance), solver.name);
  return text;
}

int respond(const ResponseOptions& options) {
  ResponseQuestion question = question_of(options);
  const Case one = options.changes.read(options.case_name);
  if (!std::holds_alternative<ContactCase>(one.body))
    throw case_error(one, "bearing", "is no contact; allowed is a contact case");
  require_distinct({{"the case", one.file}},
                   {{"--json", options.json.value_or("")}, {"--csv", options.csv.value_or("")}});
  JsonTarget json(options.json);
  std::optional<OutputFile> csv = opened(options.csv);
  const std::string title = one.id + ": " + one.title;
  ResponseRun run;
  {
    Progress progress;
    progress.show(running_line("response of", one.id, question.solver->name, one.title));
    question.request.progress = [&, first_s = 0.0](std::size_t done, std::size_t all) mutable {
      if (all < 2) return;
      // The steady state took its time once.
      if (done == 0) first_s = progress.passed_s();
      const double each_s = done == 0 ? 0 : (progress.passed_s() - first_s) / static_cast<double>(done);
      progress.step(done, all, fmt::format("{} with {}: frequencies and waves", one.id, question.solver->name),
                    done == 0 ? std::nullopt : std::optional(each_s * static_cast<double>(all - done)));
    };
    run = run_response(one, question);
  }
  Json result = to_json(run);
  options.changes.put_into(result);
  if (csv) csv->append(response_csv(run));
  json.commit(result, {address_of(csv)});
  if (!json.to_standard_output()) print(human_table(run, title));
  if (run.response.status == StopReason::converged) return success;
  complain(fmt::format("ehd: {}: {}: {}", title, to_string(run.response.status), run.response.reason));
  return not_met;
}

}  // namespace

void describe_response(Command& command) {
  auto options = std::make_shared<ResponseOptions>();
  command.summary("Stiffness and damping of a contact's film, and the part of a waviness that passes it");
  command.examples(response_examples);
  command.text("CASE", options->case_name, "a contact case (TOML), the id of a benchmark case, or - for standard input")
      .required();
  command.text("--solver", options->solver, responsive_solver_names())
      .showing_default()
      .completed_by(responsive_solver_names());
  command
      .text("--tolerance", options->tolerance,
            "relative error allowed in kappa and in amplitudes (" + default_tolerances() + ")")
      .called("T");
  options->request.add_to(command, false);
  options->changes.add_to(command);
  command.list("--omega", options->omegas, "Omega = omega b/u_m (repeatable; 0 where nothing is asked for)");
  command.list("--frequency", options->frequencies, "in Hz (repeatable)");
  command.list("--wavelength", options->wavelengths, "of a waviness, in b (repeatable)");
  command.text("--slip", options->slip, "speed of the waviness over u_m, 0 to 2 (1, pure rolling)");
  command.text("--x0-m", options->datum, "datum of the approach, for stiffness in SI (the half width b)");
  command.text("--json", options->json, "the result as JSON into a file, or - for standard output");
  command
      .text("--csv", options->csv, "kappa over the frequencies as CSV, with stiffness and damping in SI; and the waves")
      .called("FILE");
  command.runs([options] { return respond(*options); });
}

}  // namespace ehd::cli
