// SPDX-License-Identifier: GPL-3.0-or-later
// ehd solve: one contact, from a case file or from options.
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/case_choice.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/picture_file.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/nondimensional.hpp"
#include "contact/oil_laws.hpp"
#include "io/case_keys.hpp"
#include "io/contact_json.hpp"
#include "io/file_text.hpp"
#include "io/near_miss.hpp"
#include "io/output_file.hpp"
#include "io/profile_csv.hpp"
#include "io/tables.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::cli {

namespace {

struct SolveOptions {
  std::optional<std::string> case_name;
  std::optional<std::string> M, L, inlet, viscosity, density, alpha, z, p0;
  std::string solver = default_solver().name;
  std::vector<std::string> quantities;
  std::optional<std::string> json, profile, plot, wisdom;
  RequestOptions request;
  CaseChanges changes;
};

const char* const solve_examples = R"(
Examples:
  ehd solve own-moes-20-10                              a benchmark case by its id
  ehd solve my-contact.toml --tolerance 1e-4            a case file
  ehd solve my-contact.toml --set lubricant.temperature_C=80
  ehd new contact | ehd solve -                         a case from standard input
  ehd solve --M 20 --L 10                               Barus, incompressible, fully flooded
  ehd solve --M 20 --L 10 --viscosity roelands --density dowson-higginson \
            --alpha-per-Pa 2.2e-8 --z 0.68 --p0-Pa 1.96e8 --inlet -4
  ehd solve own-moes-20-10 --solver reference --json -  the result as JSON on standard output
  ehd solve steel-roller --profile profile.csv          pressure and film over X
  ehd solve steel-roller --plot profile.svg             the same as a figure

Exit code: 0 converged; 1 not converged (the status says how); 2 bad input or usage.)";

/// Checks the inputs of the laws. The messages name options; those of nondimensionalise would name the keys of a file.
void require_laws_possible(const SolveOptions& options, const Lubricant& lubricant) {
  const LawKeys keys = row_of(lubricant.viscosity).keys;
  if (!keys.alpha_per_Pa)
    throw option_error("--viscosity", *options.viscosity,
                       fmt::format("contradicts --L = {}; allowed is {}, or --L 0", *options.L, piezoviscous_names()));
  if (!lubricant.alpha_per_Pa) {
    const std::string needs = "needs pressures in Pa, which the groups alone leave open; required is --alpha-per-Pa, " +
                              text_of(row_of_case_key("lubricant.alpha_per_Pa").allowed);
    if (keys.p0_Pa) throw option_error("--viscosity", *options.viscosity, needs);
    if (lubricant.density != DensityLaw::incompressible) throw option_error("--density", *options.density, needs);
  }
  if (keys.z && !lubricant.z)
    throw option_error("--viscosity", *options.viscosity,
                       "needs Roelands' exponent; required is --z, " + text_of(row_of_case_key("lubricant.z").allowed));
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
  // Each option has the range of a key of case files.
  const auto number_like = [](const char* option, const std::string& text, const char* key) {
    return parse_number(option, text, std::get<Interval>(row_of_case_key(key).allowed));
  };
  const double M = number_like("--M", *options.M, "moes.M"), L = number_like("--L", *options.L, "moes.L");
  contact.statement = MoesGroups{.M = M, .L = L};

  Lubricant lubricant;
  if (options.viscosity) {
    const auto law = viscosity_law_from(*options.viscosity);
    if (!law) throw unknown_word_error("--viscosity", *options.viscosity, names_of(viscosity_laws()));
    lubricant.viscosity = *law;
  }
  if (options.density) {
    const auto law = density_law_from(*options.density);
    if (!law) throw unknown_word_error("--density", *options.density, names_of(density_laws()));
    lubricant.density = *law;
  }
  if (options.alpha) {  // it sets p_H, which 0 cannot
    Interval range = std::get<Interval>(row_of_case_key("lubricant.alpha_per_Pa").allowed);
    range.or_zero = false;
    lubricant.alpha_per_Pa = parse_number("--alpha-per-Pa", *options.alpha, range);
  }
  if (options.z) lubricant.z = number_like("--z", *options.z, "lubricant.z");
  if (options.p0) lubricant.p0_Pa = number_like("--p0-Pa", *options.p0, "lubricant.p0_Pa");
  contact.lubricant = lubricant;

  contact.inlet = Flooded{};
  if (options.inlet && *options.inlet != "flooded") {
    const CaseKey& row = row_of_case_key("domain.inlet");
    const auto& range = std::get<allowed::Inlet>(row.allowed);
    if (const std::string comma = comma_in_number(*options.inlet); !comma.empty())
      throw option_error("--inlet", *options.inlet, comma);
    constexpr double any = std::numeric_limits<double>::max();
    const auto refuse = [&](const char* what) {
      return option_error("--inlet", *options.inlet, std::string(what) + "; allowed is " + text_of(row.allowed));
    };
    double x = 0;
    try {
      x = parse_number("--inlet", *options.inlet, {.low = -any, .high = any});
    } catch (const UsageError&) {
      throw refuse("is unknown");
    }
    if (!(x < range.edge && x >= range.farthest)) throw refuse("does not lie before the contact");
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
  if (!options.case_name && options.changes.any())
    throw UsageError("solve: --set changes a key of a case, and there is none; required is a CASE");
  if (!options.case_name && !(options.M && options.L))
    throw UsageError(
        fmt::format("solve: {} missing; required is a CASE, or --M and --L (ehd solve --help shows examples)",
                    options.M   ? "--L is"
                    : options.L ? "--M is"
                                : "the contact is"));
}

/// --wisdom FILE: the measurements of FFTW in earlier runs, or a new file. This run adds its own measurements.
void read_wisdom(const std::string& name) {
  // What one run learns has a few KiB.
  constexpr FileKind kind{.name = "a file that an earlier run wrote, or a new one", .most_bytes = 16 << 20};
  const std::string allowed = "; allowed is " + std::string(kind.name);
  if (name.empty()) throw UsageError("--wisdom names no file" + allowed);
  const std::string text = text_if_there(name, kind).value_or("");
  const bool whole = text.find('\0') == std::string::npos;  // FFTW would read up to there
  if (!whole || !measure_fft_plans(text)) throw option_error("--wisdom", name, "is no FFTW wisdom" + allowed);
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
  Case one = options.changes.read(*options.case_name);
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
  options.request.require_wanted(wanted);
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
  std::optional<OutputFile> wisdom = opened(options.wisdom), profile = opened(options.profile);
  PictureFile plot(options.plot);

  ContactRun run;
  {
    Progress progress;
    const std::string id = stated.from_case ? stated.from_case->id : stated.title;
    progress.show(running_line("solving", id, solver.name, stated.from_case ? stated.from_case->title : ""));
    run = stated.from_case ? run_contact(*stated.from_case, solver, request, wanted)
                           : run_contact(stated.contact, solver, request, wanted);
  }
  if (!options.quantities.empty()) require_chosen(wanted, run);
  if (wisdom) wisdom->append(learned_fft_plans());
  const bool solution = run.status() != StopReason::diverged && run.solution.fields.X.size() > 0;
  if (profile && solution) profile->append(profile_csv(run));
  if (plot && solution) plot.write(contact_picture(run, stated.title));
  Json result = to_json(run);
  options.changes.put_into(result);
  json.commit(result, {address_of(wisdom), address_of(profile), plot.file()});
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
  command.text("CASE", options->case_name, "a case file (TOML), the id of a benchmark case, or - for standard input");
  command.text("--M", options->M, "Moes' load group, 1e-3 to 1e6 (instead of a CASE, with --L)");
  command.text("--L", options->L, "Moes' lubricant group, 0 to 100");
  command.text("--inlet", options->inlet, "flooded, or X = x/b where the domain begins (flooded)");
  command.text("--viscosity", options->viscosity, names_of(viscosity_laws()) + " (barus)");
  command.text("--density", options->density, names_of(density_laws()) + " (incompressible)");
  command.text("--alpha-per-Pa", options->alpha, "pressure coefficient of viscosity; sets p_H");
  command.text("--z", options->z, "Roelands' exponent");
  command.text("--p0-Pa", options->p0, "Roelands' reference pressure (1.9613e8)");
  command.text("--solver", options->solver, "one of " + solver_names()).showing_default().completed_by(solver_names());
  options->request.add_to(command);
  options->changes.add_to(command);
  command.list(
      "--quantity", options->quantities,
      "compute only this quantity, as finely as it needs (repeatable), e.g. film.minimum; a pressure that is not known "
      "well enough ends the solve as tolerance-not-met");
  command.text("--json", options->json, "the result as JSON into a file, or - for standard output");
  command.text("--profile", options->profile, "pressure, film, density and viscosity over X as CSV");
  command.text("--plot", options->plot, "pressure and film over the contact as a figure: FILE.svg or FILE.png");
  command.text("--wisdom", options->wisdom,
               "let FFTW measure its plans, and keep what it learned in this file for later runs");
  command.runs([options] { return solve(*options); });
}

}  // namespace ehd::cli
