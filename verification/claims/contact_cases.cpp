// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 3, 6, 8 and 10 for each contact case. Both solvers converge within the requested tolerance, keep load and flux,
// agree within their reported errors, and meet every number that the case expects.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "contact/estimate.hpp"
#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/contact_run.hpp"

namespace ehd::verification {

namespace {

constexpr double asked_tolerance = 1e-3;

/// The relative error that a solver reports. Where it reports none: the error that its own grids show, and the
/// truncation that it reports for the central film.
struct SolverError {
  std::optional<double> value;
  std::string from;
};

SolverError stated_or_shown_error(const ContactRun& run, Quantity quantity, const Measured& measured,
                                  double formal_order) {
  if (measured.error) return {measured.error, "reported"};
  std::vector<double> values;
  for (const auto& grid : run.solution.record.grids)
    if (const Reading* seen = observed(grid.observed, quantity)) values.push_back(seen->value);
  if (values.size() < 2) return {std::nullopt, "neither reported nor seen on two grids"};
  const double shown = estimate(values, formal_order).error;
  return {shown + run.solution.record.film_central.truncation, "of the solver's own grids"};
}

/// `asked`, or where it reports no pressure maximum a tighter run that does: one that may be a spike is reported from
/// four grids on.
ContactRun reporting(const Case& contact_case, const ContactRun& asked, const RegisteredSolver* solver,
                     const std::string& quantity) {
  if (!solver || !converged(asked.solution) || quantity_from(quantity) != Quantity::pressure_maximum) return asked;
  if (asked.solution.observables.contains(Quantity::pressure_maximum)) return asked;
  for (const double tolerance : {asked_tolerance / 10, asked_tolerance / 100}) {
    ContactRun tighter = run_contact(contact_case, *solver, {.tolerance = tolerance});
    if (converged(tighter.solution) && tighter.solution.observables.contains(Quantity::pressure_maximum))
      return tighter;
  }
  return asked;
}

Findings judge_expectations(const Case& contact_case, const ContactRun& asked, const RegisteredSolver* solver) {
  Findings found;
  const std::string name = solver ? solver->name : "closed form";
  for (const Expectation& expectation : contact_case.expectations) {
    Sentence says{.id = fmt::format("{}/{}/{}/{}", contact_case.id, name, expectation.quantity,
                                    expectation.waiting ? "waiting" : expectation.digits),
                  .rung = solver ? 10 : 3,
                  .statement = fmt::format("{} meets {} = {} of {}", name, expectation.quantity, expectation.digits,
                                           contact_case.id),
                  .case_id = contact_case.id,
                  .solver = solver ? solver->name : ""};
    if (expectation.waiting) {
      says.statement = fmt::format("{} waits for the digits of {}", contact_case.id, expectation.quantity);
      found.skipped.push_back({says, "the source's number is not available here"});
      continue;
    }
    const ContactRun run = reporting(contact_case, asked, solver, expectation.quantity);
    const auto measured = converged(run.solution) ? measure(run, expectation) : std::nullopt;
    if (expectation.kind == ExpectationKind::fit) {
      says.statement = fmt::format("{} beside the regression {} = {}", name, expectation.quantity, expectation.digits);
      found.skipped.push_back(
          {says, measured
                     ? fmt::format("a regression neither passes nor fails; computed {}, {} % off",
                                   plain(measured->value), plain(100 * (measured->value / expectation.value - 1), 2))
                     : "a regression neither passes nor fails; not computed: " + how_it_ended(run.solution)});
      continue;
    }
    const auto quantity = quantity_from(expectation.quantity);
    if (!measured && converged(run.solution) && quantity == Quantity::pressure_spike) {
      found.skipped.push_back(
          {says, name + " reports no spike: its height is reported with its uncertainty or not at all"});
      continue;
    }
    if (!measured || !quantity) {
      found.claims.push_back(claim_value(says, nothing, expectation.value, 0,
                                         Tolerance::required(asked_tolerance, "nothing was measured"),
                                         how_it_ended(run.solution)));
      continue;
    }
    const SolverError error = solver
                                  ? stated_or_shown_error(run, *quantity, *measured, solver->description.formal_order)
                                  : SolverError{0.0, "exact"};
    if (!error.value) {
      found.claims.push_back(claim_value(says, measured->value, expectation.value, nothing,
                                         Tolerance::discretisation(0, 1), "error " + error.from));
      continue;
    }
    found.claims.push_back(
        claim_value(says, measured->value, expectation.value, 0,
                    Tolerance::discretisation(*error.value + expectation.uncertainty, 1),
                    fmt::format("tolerance = error {} ({}) + uncertainty of the expectation {}", plain(*error.value, 2),
                                error.from, plain(expectation.uncertainty, 2))));
  }
  return found;
}

void append(Findings& found, Findings more) {
  for (auto& one : more.claims) found.claims.push_back(std::move(one));
  for (auto& one : more.skipped) found.skipped.push_back(std::move(one));
}

void judge_end(Findings& found, const Case& contact_case, const ContactRun& run) {
  const std::string prefix = contact_case.id + "/" + run.solver;
  const auto says = [&](const std::string& what, const std::string& statement) {
    return Sentence{.id = prefix + "/" + what,
                    .rung = 6,
                    .statement = fmt::format("{} {} on {}", run.solver, statement, contact_case.id),
                    .case_id = contact_case.id,
                    .solver = run.solver};
  };
  found.claims.push_back(claim_fact(says("converged", "ends converged at tolerance 1e-3"), converged(run.solution),
                                    "a solve at --tolerance 1e-3 ends converged", how_it_ended(run.solution)));
  for (const Quantity film : judged_films)
    found.claims.push_back(claim(says(fmt::format("{}/error", to_string(film)),
                                      fmt::format("reports an error of {} within 1e-3", to_string(film))),
                                 error_of(reading(run.solution, film)), 0,
                                 Tolerance::required(asked_tolerance, "--tolerance 1e-3 asks for it")));
  // The tolerance of the films serves for load and flux too: film ~ load^-0.1, film ~ flux.
  for (const auto& [quantity, what] :
       {std::pair{Quantity::load_error, "carries the load"}, std::pair{Quantity::flux_variation, "keeps the flux"}})
    found.claims.push_back(claim(says(std::string(to_string(quantity)), std::string(what) + " to 1e-3"),
                                 value_of(reading(run.solution, quantity)), 0,
                                 Tolerance::required(asked_tolerance, "--tolerance 1e-3 asks as much of the films")));
}

void judge_agreement(Findings& found, const Case& contact_case, const ContactRun& one, const ContactRun& two) {
  for (const Quantity film : judged_films) {
    const Reading *a = reading(one.solution, film), *b = reading(two.solution, film);
    const bool known = a && b && a->error && b->error;
    found.claims.push_back(
        claim_value({.id = fmt::format("{}/{}-{}/{}", contact_case.id, one.solver, two.solver, to_string(film)),
                     .rung = 8,
                     .statement = fmt::format("{} and {} agree on {} of {} within the errors that they report",
                                              one.solver, two.solver, to_string(film), contact_case.id),
                     .case_id = contact_case.id,
                     .solver = one.solver + ", " + two.solver},
                    value_of(b), value_of(a), 0,
                    Tolerance::discretisation(known ? *a->error + *b->error * std::abs(b->value / a->value) : 0, 1),
                    known ? "" : how_it_ended(one.solution) + "; " + how_it_ended(two.solution)));
  }
}

Findings judge_contact(const Case& contact_case) {
  const RegisteredSolver &certified = remembered(certified_solver().name), &usual = remembered(default_solver().name);
  if (std::get<ContactCase>(contact_case.body).dry())
    return judge_expectations(contact_case, run_contact(contact_case, certified, Request{}), nullptr);
  const auto& expected = contact_case.expectations;
  // Where every expectation waits for its number, the case's parameters are placeholders: there is nothing to solve.
  if (!expected.empty() && std::all_of(expected.begin(), expected.end(), [](const auto& one) { return one.waiting; }))
    return judge_expectations(contact_case, {}, &certified);
  Findings found;
  std::vector<ContactRun> runs;
  for (const RegisteredSolver* solver : {&certified, &usual}) {
    runs.push_back(run_contact(contact_case, *solver, {.tolerance = asked_tolerance}));
    judge_end(found, contact_case, runs.back());
    append(found, judge_expectations(contact_case, runs.back(), solver));
  }
  judge_agreement(found, contact_case, runs[0], runs[1]);
  return found;
}

/// The tightest digits that a case expects, as a relative half unit.
double finest_digits(const Case& contact_case) {
  double finest = 1;
  for (const Expectation& expectation : contact_case.expectations)
    if (!expectation.waiting) finest = std::min(finest, expectation.uncertainty);
  return finest;
}

/// A case with more digits than the tolerance 1e-3 can test is solved again by the reference, to the digits that it
/// declares: films to ten digits (half a unit of the tenth, 5e-11); spikes, and films by Barus' law, whose spike is
/// narrower, to seven.
Findings judge_certified(const Case& contact_case) {
  const RegisteredSolver& solver = remembered(certified_solver().name);
  const auto& contact = std::get<ContactCase>(contact_case.body);
  const bool barus = contact.lubricant->viscosity == ViscosityLaw::barus;
  const double tolerance = barus ? 1e-7 : 5e-11, asked = barus ? 1e-8 : tolerance, spike_tolerance = 1e-7;
  constexpr double spike_digits = 1e-6;  // a spike with fewer digits is narrower than its coordinates can resolve
  constexpr double longest_s = 100;      // the slowest case takes 12 s; a solver that has become wrong may never end
  const ContactRun run = run_contact(contact_case, solver, {.tolerance = asked, .time_limit_s = longest_s});
  Findings found = judge_expectations(contact_case, run, &solver);
  for (auto& claim : found.claims) claim.says.id += "/certified";
  for (auto& row : found.skipped) row.says.id += "/certified";
  const auto within = [&](Quantity quantity, double bound) {
    found.claims.push_back(claim(
        {.id = contact_case.id + "/certified/" + std::string(to_string(quantity)),
         .rung = 6,
         .statement =
             fmt::format("{} knows {} of {} to {}", solver.name, to_string(quantity), contact_case.id, plain(bound)),
         .case_id = contact_case.id,
         .solver = solver.name},
        error_of(reading(run.solution, quantity)), 0,
        Tolerance::required(bound, "the digits that README.md says of `reference`"), how_it_ended(run.solution)));
  };
  for (const Quantity film : judged_films) within(film, tolerance);
  for (const Expectation& expectation : contact_case.expectations)
    if (expectation.quantity == to_string(Quantity::pressure_spike) && expectation.uncertainty < spike_digits)
      within(Quantity::pressure_spike, spike_tolerance);
  return found;
}

/// One solve whose stated errors must hold the case's films: on one grid for solvers that judge_contact does not run,
/// at a rough tolerance for both main ones.
struct BarRun {
  const char* solver;
  std::optional<double> tolerance;
  std::optional<int> nodes;

  [[nodiscard]] std::string how() const {
    return nodes ? fmt::format(" on {} intervals", *nodes) : fmt::format(" asked for {}", plain(*tolerance));
  }
};
constexpr BarRun bar_runs[] = {{"fast.uniform", {}, 1024},
                               {"reference.linear", {}, 256},
                               {"reference.uniform", {}, 256},
                               {"reference", 1e-3, {}},
                               {"fast", 1e-2, {}},
                               {"fast", 1e-5, {}}};

Findings judge_stated_errors(const Case& contact_case) {
  Findings found;
  for (const BarRun& asked : bar_runs) {
    const RegisteredSolver& solver = remembered(asked.solver);
    const ContactRun run = run_contact(contact_case, solver, {.tolerance = asked.tolerance, .nodes = asked.nodes});
    if (solver.certified) {
      const double stated = run.solution.record.film_minimum.iteration;
      // At X = 0 a film is a difference of terms of size 1.
      const double by_rounding =
          std::numeric_limits<double>::epsilon() / value_of(observed(run.solution, Quantity::film_minimum));
      found.claims.push_back(claim_fact(
          {.id = fmt::format("{}/{}/stated/rounding", contact_case.id, solver.name),
           .rung = 8,
           .statement = fmt::format("the iteration error that {} states of {} is at least the rounding error of a film",
                                    solver.name, contact_case.id),
           .case_id = contact_case.id,
           .solver = solver.name},
          stated >= by_rounding, "eps/H_min", fmt::format("{} against {}", plain(stated, 2), plain(by_rounding, 2))));
    }
    for (const Expectation& expectation : contact_case.expectations) {
      if (!is_judged_film(expectation) || expectation.waiting || expectation.kind == ExpectationKind::fit) continue;
      // Also the stated error of a run that did not converge must hold.
      const auto measured = measure(run, expectation);
      const double stated = measured && measured->error ? *measured->error : nothing;
      const Sentence says{.id = fmt::format("{}/{}/stated{}/{}/{}", contact_case.id, solver.name,
                                            asked.tolerance ? "-" + plain(*asked.tolerance) : "", expectation.quantity,
                                            expectation.digits),
                          .rung = 8,
                          .statement = fmt::format("{}{} states an error that holds {} of {}", solver.name, asked.how(),
                                                   expectation.quantity, contact_case.id),
                          .case_id = contact_case.id,
                          .solver = solver.name};
      if (!measured && run.status() == StopReason::under_resolved) {
        found.skipped.push_back({says, "under-resolved, and no film is stated"});
        continue;
      }
      found.claims.push_back(claim_value(says, measured ? measured->value : nothing, expectation.value, 0,
                                         Tolerance::discretisation(stated + expectation.uncertainty, 1),
                                         fmt::format("stated {}; {}", plain(stated, 2), to_string(run.status()))));
    }
  }
  return found;
}

/// At high M the dense solver needs more than about a second.
bool is_slow(const Case& contact_case) {
  constexpr double moderate_M = 60;
  const auto& contact = std::get<ContactCase>(contact_case.body);
  if (contact.dry()) return false;
  return nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem.groups.M > moderate_M;
}

}  // namespace

std::vector<Topic> contact_topics(const std::vector<LoadedCase>& cases) {
  std::vector<Topic> topics;
  for (const LoadedCase& loaded : cases) {
    if (const auto* error = std::get_if<CaseError>(&loaded.content)) {
      topics.push_back(
          {.name = loaded.id,
           .rungs = {0},
           .case_id = loaded.id,
           .judge = [id = loaded.id, what = std::string(error->what())] {
             return Findings{
                 .claims = {claim_fact(
                     {.id = id + "/read", .rung = 0, .statement = "the case " + id + " can be read", .case_id = id},
                     false, "every file in cases/ is a case", what)},
                 .skipped = {}};
           }});
      continue;
    }
    const auto& contact_case = std::get<Case>(loaded.content);
    if (!std::holds_alternative<ContactCase>(contact_case.body)) continue;
    topics.push_back({.name = contact_case.id,
                      .rungs = {3, 6, 8, 10},
                      .case_id = contact_case.id,
                      .slow = is_slow(contact_case),
                      .judge = [contact_case] { return judge_contact(contact_case); }});
    constexpr double many_digits = 1e-7;
    if (std::get<ContactCase>(contact_case.body).dry() || finest_digits(contact_case) > many_digits) continue;
    topics.push_back({.name = contact_case.id + ", stated errors",
                      .rungs = {8},
                      .case_id = contact_case.id,
                      .slow = is_slow(contact_case),
                      .judge = [contact_case] { return judge_stated_errors(contact_case); }});
    topics.push_back({.name = contact_case.id + ", certified",
                      .rungs = {6, 10},
                      .case_id = contact_case.id,
                      .slow = is_slow(contact_case),
                      .judge = [contact_case] { return judge_certified(contact_case); }});
  }
  return topics;
}

}  // namespace ehd::verification
