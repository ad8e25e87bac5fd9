// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/contact_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"

namespace ehd {

namespace {
constexpr std::string_view observe_word = "observe ";
}

std::string stage::observe(Quantity quantity) { return std::string(observe_word).append(to_string(quantity)); }

Wanted wanted_by(const Plan& plan) {
  Wanted wanted;
  for (const std::string_view stage : plan.run)
    if (stage.starts_with(observe_word)) wanted.insert(quantity_from(stage.substr(observe_word.size())).value());
  return wanted;
}

namespace {

Plan plan_dry(const Wanted& wanted) {
  Plan plan;
  plan.decide(stage::hertz);
  plan.decide(stage::dry);
  plan.decide(stage::groups, "a dry contact has no speed and no viscosity: M and L do not exist");
  for (const auto& name : {stage::viscosity, stage::density}) plan.decide(name, "a dry contact has no lubricant");
  for (const auto& name : {stage::fft_plan, stage::solve, stage::grids})
    plan.decide(name, "the dry contact is known in closed form (Hertz)");
  for (const Quantity quantity : all_quantities) {
    const char* const missing = exists_when_dry(quantity) ? "" : "does not exist in a dry contact";
    plan.decide(stage::observe(quantity), wanted.count(quantity) ? missing : "not asked for");
  }
  plan.decide(stage::formulas, "a dry contact has no film");
  return plan;
}

std::string why_no_viscosity(const Problem& problem) {
  if (!is_trivial(problem.viscosity)) return "";
  return problem.groups.L == 0 ? "L = 0: the viscosity does not change, no exponential is evaluated"
                               : "isoviscous: no exponential is evaluated";
}

std::string why_no_density(const Problem& problem, const Lubricant& lubricant) {
  if (!is_trivial(problem.density)) return "";
  return lubricant.density == DensityLaw::incompressible ? "incompressible: no density is evaluated"
                                                         : "L = 0: no density is evaluated, since p_H -> 0";
}

/// "film.minimum and film.central, 1e-3", "film.central, 1e-6", "film.minimum, 1e-3, and film.central, 1e-6".
std::string asked_films(const FilmTolerances& asked) {
  const std::string minimum(to_string(Quantity::film_minimum)), central(to_string(Quantity::film_central));
  if (asked.minimum == asked.central) return fmt::format("{} and {}, {}", minimum, central, plain(asked.tightest()));
  if (!asked.central) return fmt::format("{}, {}", minimum, plain(*asked.minimum));
  if (!asked.minimum) return fmt::format("{}, {}", central, plain(*asked.central));
  return fmt::format("{}, {}, and {}, {}", minimum, plain(*asked.minimum), central, plain(*asked.central));
}

/// Where a film has a tolerance but is not wanted: the wanted quantities that it serves.
std::string why_asked(const FilmTolerances& asked, const Wanted& wanted) {
  std::string films, served;
  const auto add = [](std::string& names, Quantity one, std::string_view between) {
    names.append(names.empty() ? "" : between).append(to_string(one));
  };
  Wanted unwanted;
  if (asked.minimum && !wanted.contains(Quantity::film_minimum)) unwanted.insert(Quantity::film_minimum);
  if (asked.central && !wanted.contains(Quantity::film_central)) unwanted.insert(Quantity::film_central);
  for (const Quantity film : unwanted) add(films, film, " and ");
  for (const Quantity quantity : wanted) {
    const bool follows = std::ranges::any_of(unwanted, [&](Quantity film) { return serves(film, quantity); });
    if (follows) add(served, quantity, ", ");
  }
  return served.empty() ? "" : fmt::format(" ({} for {})", films, served);
}

void decide_grids(Plan& plan, const Request& request, const Wanted& wanted) {
  if (request.nodes) {
    const std::string given = fmt::format("the number of intervals is given, {}", *request.nodes);
    plan.decide(stage::grids, given);
    plan.decide(stage::finer, given);
  } else {
    plan.decide(stage::grids);
    plan.decide(stage::finer, "a coarser grid already meets the tolerance of " + asked_films(request.tolerance) +
                                  why_asked(request.tolerance, wanted));
  }
}

}  // namespace

Request request_for(const Request& request, const Wanted& wanted) {
  Request served = request;
  if (!serves(Quantity::film_minimum, wanted)) served.tolerance.minimum.reset();
  if (!serves(Quantity::film_central, wanted)) served.tolerance.central.reset();
  return served.tolerance.any() ? served : request;
}

Plan plan_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                  const Wanted& wanted) {
  if (contact.dry()) return plan_dry(wanted);
  const Nondimensional reading = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);

  Plan plan;
  plan.decide(stage::groups);
  plan.decide(stage::hertz,
              reading.scales && reading.scales->half_width_m ? "" : "the statement fixes no length in metres");
  plan.decide(stage::dry, "the contact is lubricated");
  plan.decide(stage::viscosity, why_no_viscosity(reading.problem));
  plan.decide(stage::density, why_no_density(reading.problem, *contact.lubricant));
  plan.decide(stage::fft_plan, solver.uses_fft ? "" : solver.name + " multiplies by a dense matrix");
  plan.decide(stage::solve);
  decide_grids(plan, request_for(request, wanted), wanted);
  for (const Quantity quantity : all_quantities)
    plan.decide(stage::observe(quantity), wanted.count(quantity) ? "" : "not asked for");
  const bool any_film = std::any_of(wanted.begin(), wanted.end(), is_film);
  plan.decide(stage::formulas, any_film ? "" : "no film is asked for");
  return plan;
}

}  // namespace ehd
