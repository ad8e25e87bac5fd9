// SPDX-License-Identifier: GPL-3.0-or-later
// ehd solve: one contact, from a case file or from options.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/contact_json.hpp"
#include "io/find_case.hpp"
#include "io/output_file.hpp"
#include "io/profile_csv.hpp"
#include "io/tables.hpp"
#include "verification/report/report.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd::cli {

namespace {

struct SolveOptions {
  std::optional<std::string> case_name;
  std::optional<std::string> M, L, inlet, viscosity, density, alpha, z, p0;
  std::string solver = default_solver().name;
  std::vector<std::string> quantities;
  std::optional<std::string> json, profile, plot, wisdom;
  RequestOptions request;
};

const char* const solve_examples = R"(
Examples:
  ehd solve own-moes-20-10                              a benchmark case by its id
  ehd solve my-contact.toml --tolerance 1e-4            a case file
  ehd solve --M 20 --L 10                               Barus, incompressible, fully flooded
  ehd solve --M 20 --L 10 --viscosity roelands --density dowson-higginson \
            --alpha-per-Pa 2.2e-8 --z 0.68 --p0-Pa 1.96e8 --inlet -4
  ehd solve own-moes-20-10 --solver reference --json -  the result as JSON on standard output
  ehd solve steel-roller --profile profile.csv          pressure and film over X
  ehd solve steel-roller --plot profile.svg             the same as a figure

Exit code: 0 converged; 1 not converged (the status says how); 2 bad input or usage.)";

/// Checks the inputs of the laws. The messages name options; those of nondimensionalise would name the keys of a file.
void require_laws_possible(const SolveOptions& options, const Lubricant& lubricant) {
  if (lubricant.viscosity == ViscosityLaw::isoviscous)
    throw option_error("--viscosity", *options.viscosity,
                       "contradicts --L = " + *options.L + "; allowed is barus or roelands, or --L 0");
  const bool roelands = lubricant.viscosity == ViscosityLaw::roelands;
  if (!lubricant.alpha_per_Pa) {
    constexpr const char* needs =
        "needs pressures in Pa, which the groups alone leave open; required is --alpha-per-Pa";
    if (roelands) throw option_error("--viscosity", *options.viscosity, needs);
    if (lubricant.density != DensityLaw::incompressible) throw option_error("--density", *options.density, needs);
  }
  if (roelands && !lubricant.z)
    throw option_error("--viscosity", *options.viscosity, "needs Roelands' exponent; required is --z");
}

template <class Laws>
std::string names_of(const Laws& laws) {
  std::string names;
  for (const auto& law : laws) names += (names.empty() ? "" : ", ") + std::string(law.name);
  return names;
}

/// The contact that the options state. Throws UsageError.
ContactCase contact_from(const SolveOptions& options) {
  ContactCase contact;
  const double M = parse_number("--M", *options.M), L = parse_number("--L", *options.L);
  if (!(M >= smallest_M && M <= largest_M))
    throw option_error("--M", *options.M, "is out of range; allowed is 1e-3 to 1e6");
  constexpr double smallest_L = 1e-12;  // below it p_H in Pa leaves the range of numbers
  if (!(L == 0 || (L >= smallest_L && L <= largest_L)))
    throw option_error("--L", *options.L, "is out of range; allowed is 0, or 1e-12 to 100");
  contact.statement = MoesGroups{.M = M, .L = L};

  Lubricant lubricant;
  if (options.viscosity) {
    const auto law = viscosity_law_from(*options.viscosity);
    if (!law)
      throw option_error("--viscosity", *options.viscosity, "is unknown; allowed is " + names_of(viscosity_laws()));
    lubricant.viscosity = *law;
  }
  if (options.density) {
    const auto law = density_law_from(*options.density);
    if (!law) throw option_error("--density", *options.density, "is unknown; allowed is " + names_of(density_laws()));
    lubricant.density = *law;
  }
  const auto number_within = [](const char* option, const std::string& text, double low, double high) {
    const double value = parse_number(option, text);
    if (!(value >= low && value <= high))
      throw option_error(option, text, "is out of range; allowed is " + plain(low) + " to " + plain(high));
    return value;
  };
  if (options.alpha) lubricant.alpha_per_Pa = number_within("--alpha-per-Pa", *options.alpha, 1e-15, 1e-3);
  if (options.z) lubricant.z = number_within("--z", *options.z, 1e-3, 10);
  if (options.p0) lubricant.p0_Pa = number_within("--p0-Pa", *options.p0, 1e3, 1e15);
  contact.lubricant = lubricant;

  contact.inlet = Flooded{};
  if (options.inlet && *options.inlet != "flooded") {
    const double x = parse_number("--inlet", *options.inlet);
    if (!(x < -1 && x >= -1e6))
      throw option_error("--inlet", *options.inlet,
                         "does not lie before the contact; allowed is flooded, or X = x/b from -1e6 to less than -1");
    contact.inlet = TruncatedAt{x};
  }

  if (L > 0) require_laws_possible(options, lubricant);
  (void)nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);  // refuses what is not possible
  return contact;
}

void require_one_problem(const SolveOptions& options) {
  const bool stated = options.M || options.L || options.inlet || options.viscosity || options.density ||
                      options.alpha || options.z || options.p0;
  if (options.case_name && stated)
    throw UsageError(
        "solve: a CASE and options that state a contact exclude each other; allowed is a CASE, or --M and "
        "--L");
  if (!options.case_name && !(options.M && options.L))
    throw UsageError(std::string("solve: ") +
                     (options.M   ? "--L is"
                      : options.L ? "--M is"
                                  : "the contact is") +
                     " missing; required is a CASE, or --M and --L (ehd solve --help shows examples)");
}

/// --wisdom FILE: the measurements of FFTW in earlier runs, or a new file. This run adds its own measurements.
void read_wisdom(const std::string& name) {
  std::string text;
  if (name.empty())
    throw UsageError("--wisdom names no file; allowed is a file that an earlier run wrote, or a new one");
  if (std::filesystem::exists(name)) {
    if (!std::filesystem::is_regular_file(name))
      throw option_error("--wisdom", name, "is no file; allowed is a file that an earlier run wrote, or a new one");
    std::ifstream file(name);
    std::ostringstream content;
    if (!(content << file.rdbuf()))
      throw option_error("--wisdom", name, "cannot be read; allowed is a file that an earlier run wrote, or a new one");
    text = content.str();
  }
  if (!measure_fft_plans(text))
    throw option_error("--wisdom", name,
                       "is no FFTW wisdom; allowed is a file that an earlier run wrote, or a new one");
}

/// Pressure and film over X, as a picture of its own.
std::string plot_of(const ContactRun& run, const std::string& title) {
  const Fields& fields = run.solution.fields;
  const std::optional<double> cut = pressure_cut(run.solution);
  Array P = fields.P;
  if (cut) P = P.min(*cut);
  const auto values = [](const auto& field) { return std::vector<double>(field.begin(), field.end()); };
  const report::ContactCurves curves{.name = run.solver.empty() ? "Hertz" : run.solver,
                                     .X = values(fields.X),
                                     .P = values(P),
                                     .H = values(fields.H),
                                     .P_cut = cut};
  report::Figure figure = report::contact_figure("contact", title, {curves});
  constexpr std::size_t fits = 80;
  figure.width = 560;
  figure.panels.front().height = 300;
  figure.panels.front().title = report::literal(shortened(one_line(title), fits));
  return report::draw(figure, report::Place::file);
}

/// The contact to solve: of a case, or stated by options.
struct Stated {
  std::optional<Case> from_case;
  ContactCase contact;
  std::string title;
};

/// Throws UsageError, CaseError.
Stated stated_by(const SolveOptions& options) {
  if (!options.case_name)
    return {.from_case = {},
            .contact = contact_from(options),
            .title = fmt::format("M = {}, L = {}", *options.M, *options.L)};
  Case one = read_case(find_case(*options.case_name));
  const auto* contact = std::get_if<ContactCase>(&one.body);
  if (!contact)
    throw case_error(one, "bearing", "is no contact; allowed is a contact case (ehd bearing solves this one)");
  return {.from_case = one, .contact = *contact, .title = one.id + ": " + one.title};
}

/// The failure of a run in one line.
std::string failure_of(const ContactRun& run, const std::string& title, const std::string& not_written) {
  const std::string& reason = run.solution.record.reason;
  std::string line = fmt::format("ehd: {}: {}", title, to_string(run.status()));
  if (!reason.empty()) line += ": " + reason;
  if (!not_written.empty()) line += fmt::format("; there is no solution, and no {} written", not_written);
  return line;
}

int solve(const SolveOptions& options) {
  require_one_problem(options);
  const auto& solver = solver_named(options.solver);
  const Request request = options.request.request();
  const Wanted wanted = quantities_named(options.quantities);
  const Stated stated = stated_by(options);
  if (!stated.contact.dry()) require_memory(solver, request);

  std::vector<NamedFile> inputs;
  if (stated.from_case) inputs.push_back({"the case", stated.from_case->file});
  require_distinct(inputs, {{"--json", options.json.value_or("")},
                            {"--profile", options.profile.value_or("")},
                            {"--plot", options.plot.value_or("")},
                            {"--wisdom", options.wisdom.value_or("")}});
  if (options.wisdom) read_wisdom(*options.wisdom);
  JsonTarget json(options.json);
  std::optional<OutputFile> wisdom = opened(options.wisdom), profile = opened(options.profile),
                            plot = opened(options.plot);

  ContactRun run;
  {
    Progress progress;
    progress.show(fmt::format("solving {} with {} ...", stated.title, solver.name));
    run = stated.from_case ? run_contact(*stated.from_case, solver, request, wanted)
                           : run_contact(stated.contact, solver, request, wanted);
  }
  json.write(to_json(run));
  if (wisdom) wisdom->commit(learned_fft_plans());
  const bool solution = run.status() != StopReason::diverged && run.solution.fields.X.size() > 0;
  if (profile && solution) profile->commit(profile_csv(run));
  if (plot && solution) plot->commit(plot_of(run, stated.title));
  if (!json.to_standard_output()) print(human_table(run, stated.title, styled_output()));
  if (run.status() == StopReason::converged) return success;
  std::string not_written;
  if (!solution)
    not_written = profile && plot ? "profile and no plot is" : profile ? "profile is" : plot ? "plot is" : "";
  complain(failure_of(run, stated.title, not_written));
  return not_met;
}

}  // namespace

void describe_solve(Command& command) {
  auto options = std::make_shared<SolveOptions>();
  command.summary("Solve one contact");
  command.examples(solve_examples);
  command.text("CASE", options->case_name, "a case file (TOML), or the id of a benchmark case");
  command.text("--M", options->M, "Moes load parameter, 1e-3 to 1e6 (instead of a CASE, with --L)");
  command.text("--L", options->L, "Moes material parameter, 0 to 100");
  command.text("--inlet", options->inlet, "flooded, or X = x/b where the domain begins (flooded)");
  command.text("--viscosity", options->viscosity, names_of(viscosity_laws()) + " (barus)");
  command.text("--density", options->density, names_of(density_laws()) + " (incompressible)");
  command.text("--alpha-per-Pa", options->alpha, "pressure coefficient of viscosity; sets p_H");
  command.text("--z", options->z, "Roelands' exponent");
  command.text("--p0-Pa", options->p0, "Roelands' reference pressure (1.9613e8)");
  command.text("--solver", options->solver, "one of " + solver_names()).showing_default();
  options->request.add_to(command);
  command.list("--quantity", options->quantities, "compute only this quantity (repeatable), e.g. film.minimum");
  command.text("--json", options->json, "the result as JSON into a file, or - for standard output");
  command.text("--profile", options->profile, "pressure, film, density and viscosity over X as CSV");
  command.text("--plot", options->plot, "pressure and film over X as a figure, SVG");
  command.text("--wisdom", options->wisdom,
               "let FFTW measure its plans, and keep what it learned in this file for later runs");
  command.runs([options] { return solve(*options); });
}

}  // namespace ehd::cli
