// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_plan.hpp"

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"

namespace ehd {

std::string stage::observe(Quantity quantity) { return "observe " + std::string(to_string(quantity)); }

bool exists_in_dry_contact(Quantity quantity) {
  return quantity == Quantity::film_offset || quantity == Quantity::pressure_maximum ||
         quantity == Quantity::pressure_exit || quantity == Quantity::approach;
}

Wanted wanted_by(const Plan& plan) {
  Wanted wanted;
  for (const Quantity quantity : all_quantities) {
    if (plan.runs(stage::observe(quantity))) wanted.insert(quantity);
  }
  return wanted;
}

namespace {

class Planner {
 public:
  /// Runs the stage, unless there is a reason to skip it.
  void decide(std::string_view stage, const std::string& why_skipped = "") {
    if (why_skipped.empty()) {
      plan_.run.emplace_back(stage);
    } else {
      plan_.skipped.push_back({std::string(stage), why_skipped});
    }
  }
  [[nodiscard]] Plan plan() && { return std::move(plan_); }

 private:
  Plan plan_;
};

Plan plan_dry(const Wanted& wanted) {
  Planner planner;
  planner.decide(stage::hertz);
  planner.decide(stage::dry);
  planner.decide(stage::groups, "a dry contact has no speed and no viscosity: M and L do not exist");
  for (const auto& name : {stage::viscosity, stage::density}) planner.decide(name, "a dry contact has no lubricant");
  for (const auto& name : {stage::fft_plan, stage::solve, stage::grids})
    planner.decide(name, "the dry contact is known in closed form (Hertz)");
  for (const Quantity quantity : all_quantities) {
    planner.decide(stage::observe(quantity), !wanted.count(quantity)            ? "not asked for"
                                             : !exists_in_dry_contact(quantity) ? "does not exist in a dry contact"
                                                                                : "");
  }
  planner.decide(stage::formulas, "a dry contact has no film");
  return std::move(planner).plan();
}

}  // namespace

Plan plan_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                  const Wanted& wanted) {
  if (contact.dry()) return plan_dry(wanted);
  const Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
  const Problem& problem = reading.problem;
  const bool no_pressure = problem.groups.L == 0;

  Planner planner;
  planner.decide(stage::groups);
  planner.decide(stage::hertz,
                 reading.scales && reading.scales->half_width_m ? "" : "the statement fixes no length in metres");
  planner.decide(stage::dry, "the contact is lubricated");
  planner.decide(stage::viscosity, !is_trivial(problem.viscosity) ? ""
                                   : no_pressure ? "L = 0: the viscosity does not change, no exponential is evaluated"
                                                 : "isoviscous: no exponential is evaluated");
  planner.decide(stage::density, !is_trivial(problem.density) ? ""
                                 : contact.lubricant->density == DensityLaw::incompressible
                                     ? "incompressible: no density is evaluated"
                                     : "L = 0: no density is evaluated, since p_H -> 0");
  planner.decide(stage::fft_plan, solver.uses_fft ? "" : solver.name + " multiplies by a dense matrix");
  planner.decide(stage::solve);
  if (request.nodes) {
    planner.decide(stage::grids, "the number of intervals is given, " + std::to_string(*request.nodes));
    planner.decide(stage::finer, "the number of intervals is given, " + std::to_string(*request.nodes));
  } else {
    planner.decide(stage::grids);
    planner.decide(stage::finer, "film.minimum and film.central are asked for within " +
                                     plain(request.tolerance.value_or(0)) + ", no better");
  }
  for (const Quantity quantity : all_quantities) {
    planner.decide(stage::observe(quantity), wanted.count(quantity) ? "" : "not asked for");
  }
  const bool film = wanted.count(Quantity::film_minimum) || wanted.count(Quantity::film_central) ||
                    wanted.count(Quantity::film_couette);
  planner.decide(stage::formulas, film ? "" : "no film is asked for");
  return std::move(planner).plan();
}

}  // namespace ehd
