// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "contact/nondimensional.hpp"
#include "workflow/registry.hpp"

namespace ehd::judging {

double relative_error(double value, double certified) {
  return certified == 0 ? std::abs(value) : std::abs(value / certified - 1);
}

double log_relative_error(double error, double uncertainty) {
  const double known = std::max({error, uncertainty, std::numeric_limits<double>::epsilon()});
  return std::max(0.0, -std::log10(known));
}

std::string_view to_string(Honesty honesty) {
  switch (honesty) {
    case Honesty::met: return "met";
    case Honesty::missed: return "missed";
    case Honesty::undecided: return "undecided";
  }
  return "";
}

Honesty honesty_of(double error, double uncertainty, double stated) {
  if (error + uncertainty <= stated) return Honesty::met;
  if (error - uncertainty > stated) return Honesty::missed;
  return Honesty::undecided;
}

CaseScales::CaseScales(const ContactCase& contact) {
  if (contact.dry()) {  // a closed form, no solve
    run_ = run_contact(contact, default_solver(), Request{});
  } else {
    const Nondimensional stated = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet);
    run_.groups = stated.problem.groups;
    run_.scales = stated.scales;
  }
}

std::optional<double> CaseScales::unit(Quantity quantity, Scaling scaling) const {
  const QuantityRow& row = row_of(quantity);
  if (scaling == Scaling::moes && !row.in_moes_units) return std::nullopt;
  ContactRun one = run_;  // measure() knows every scaling: here it measures 1
  one.solution.observables = {{quantity, Reading{.value = 1}}};
  const auto measured = measure(one, {.quantity = std::string(row.name), .law = {}, .digits = {}, .scaling = scaling});
  return measured ? std::optional(measured->value) : std::nullopt;
}

std::vector<Certified> certified_numbers(const Case& contact_case, const CaseScales& scales) {
  std::vector<Certified> numbers;
  for (const Quantity quantity : all_quantities) {
    const Expectation* best = nullptr;
    for (const Expectation& one : contact_case.expectations) {
      if (one.waiting || one.kind == ExpectationKind::fit || one.quantity != to_string(quantity)) continue;
      if (!best || one.uncertainty < best->uncertainty) best = &one;
    }
    const auto unit = best ? scales.unit(quantity, best->scaling) : std::nullopt;
    if (!unit) continue;
    numbers.push_back({.quantity = quantity,
                       .value = best->value / *unit,
                       .uncertainty = best->uncertainty,
                       .digits = best->digits,
                       .scaling = best->scaling,
                       .kind = best->kind});
  }
  return numbers;
}

}  // namespace ehd::judging
