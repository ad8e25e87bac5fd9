// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/quantities.hpp"

#include <algorithm>

#include "contact/hertz.hpp"
#include "contact/observables.hpp"
#include "contact/solution.hpp"

namespace ehd {

namespace {

/// Kostreva's film is h_K = 2 H and his offset k = 2 H_0. His pressures and lengths are Hertz'.
constexpr double kostreva_film = 2, kostreva_pressure = 1;

constexpr std::array<QuantityRow, quantity_count> table{{
    {.quantity = Quantity::film_minimum,
     .kind = QuantityKind::film,
     .name = "film.minimum",
     .meaning = "smallest film thickness",
     .unit = "h R/b^2",
     .served_by = ServedBy::minimum,
     .in_moes_units = true,
     .SI = SIScale::film,
     .kostreva_factor = kostreva_film,
     .json_entry = "film.minimum",
     .json_value = "hertz",
     .observe = observed::film_minimum,
     .budget = &SolveRecord::film_minimum},
    {.quantity = Quantity::film_central,
     .kind = QuantityKind::film,
     .name = "film.central",
     .meaning = "film thickness at X = 0",
     .unit = "h R/b^2",
     .served_by = ServedBy::central,
     .in_moes_units = true,
     .SI = SIScale::film,
     .kostreva_factor = kostreva_film,
     .json_entry = "film.central",
     .json_value = "hertz",
     .observe = observed::film_central,
     .budget = &SolveRecord::film_central},
    {.quantity = Quantity::film_couette,
     .kind = QuantityKind::film,
     .name = "film.couette",
     .meaning = "flux over speed: rho H at the exit",
     .unit = "h R/b^2",
     .served_by = ServedBy::central,
     .in_moes_units = true,
     .SI = SIScale::film,
     .kostreva_factor = kostreva_film,
     .json_entry = "film.couette",
     .json_value = "hertz",
     .observe = observed::film_couette},
    {.quantity = Quantity::film_offset,
     .kind = QuantityKind::offset,
     .name = "film.offset",
     .meaning = "the constant H_0 of the film equation",
     .unit = "h R/b^2",
     .error = ErrorKind::absolute,
     .served_by = ServedBy::central,
     .kostreva_factor = kostreva_film,
     .json_entry = "film.offset",
     .json_value = "hertz",
     .observe = observed::film_offset,
     .when_dry = [] { return Reading{.value = hertz::dry_offset()}; }},
    {.quantity = Quantity::pressure_maximum,
     .kind = QuantityKind::pressure_peak,
     .name = "pressure.maximum",
     .meaning = "largest pressure",
     .unit = "p/p_H",
     .SI = SIScale::pressure,
     .kostreva_factor = kostreva_pressure,
     .json_entry = "pressure.maximum",
     .json_value = "hertz",
     .observe = observed::pressure_maximum,
     .when_dry = [] { return Reading{.value = 1, .place = 0.0}; }},
    {.quantity = Quantity::pressure_spike,
     .kind = QuantityKind::pressure_peak,
     .name = "pressure.spike",
     .meaning = "height of the pressure spike",
     .unit = "p/p_H",
     .SI = SIScale::pressure,
     .kostreva_factor = kostreva_pressure,
     .json_entry = "pressure.spike",
     .json_value = "hertz",
     .observe = observed::pressure_spike},
    {.quantity = Quantity::pressure_exit,
     .kind = QuantityKind::exit,
     .name = "pressure.exit",
     .meaning = "place X* where the pressure ends",
     .unit = "x/b",
     .SI = SIScale::length,
     .kostreva_factor = kostreva_pressure,
     .json_entry = "pressure.exit_x",
     .observe = observed::pressure_exit,
     .when_dry = [] { return Reading{.value = 1}; }},
    {.quantity = Quantity::approach,
     .kind = QuantityKind::approach,
     .name = "approach",
     .meaning = "approach of the bodies with datum b: -H_0",
     .unit = "delta R/b^2",
     .error = ErrorKind::absolute,
     .served_by = ServedBy::central,
     .SI = SIScale::film,
     .json_entry = "approach",
     .json_value = "hertz",
     .observe = observed::approach,
     .when_dry = [] { return Reading{.value = -hertz::dry_offset()}; }},
    {.quantity = Quantity::rolling_force,
     .kind = QuantityKind::force,
     .name = "rolling_force",
     .meaning = "|Int H dP/dX dX|/2",
     .unit = "F R/(p_H b^2), F a force per length",
     .SI = SIScale::force,
     .json_entry = "rolling_force",
     .json_value = "dimensionless",
     .observe = observed::rolling_force},
    {.quantity = Quantity::load_error,
     .kind = QuantityKind::self_check,
     .name = "load_error",
     .meaning = "|2/pi Int P dX - 1|",
     .unit = "1",
     .json_entry = "load_error",
     .observe = observed::load_error},
    {.quantity = Quantity::flux_variation,
     .kind = QuantityKind::self_check,
     .name = "flux_variation",
     .meaning = "largest difference between the flux and the flux at the exit, relative",
     .unit = "1",
     .json_entry = "flux_variation",
     .observe = observed::flux_variation},
}};

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].quantity != static_cast<Quantity>(i)) return false;
  }
  return true;
}
static_assert(in_order_of_the_enum(), "each quantity has one row, in the order of the enum");

}  // namespace

const std::array<QuantityRow, quantity_count>& quantity_table() { return table; }

const QuantityRow& row_of(Quantity quantity) { return table[static_cast<std::size_t>(quantity)]; }

std::string_view to_string(Quantity quantity) { return row_of(quantity).name; }

std::optional<Quantity> quantity_from(std::string_view text) { return word_from<Quantity>(text); }

bool has_absolute_error(Quantity quantity) { return row_of(quantity).error == ErrorKind::absolute; }
bool is_film(Quantity quantity) { return row_of(quantity).kind == QuantityKind::film; }
bool is_pressure_peak(Quantity quantity) { return row_of(quantity).kind == QuantityKind::pressure_peak; }
bool is_self_check(Quantity quantity) { return row_of(quantity).kind == QuantityKind::self_check; }
bool exists_when_dry(Quantity quantity) { return row_of(quantity).when_dry != nullptr; }

std::string names_of_quantities(bool (*holds)(Quantity)) {
  std::string names;
  for (const QuantityRow& row : table) {
    if (!holds(row.quantity)) continue;
    if (!names.empty()) names += ", ";
    names += row.name;
  }
  return names;
}

bool serves(Quantity film, Quantity quantity) {
  switch (row_of(quantity).served_by) {
    case ServedBy::minimum: return film == Quantity::film_minimum;
    case ServedBy::central: return film == Quantity::film_central;
    case ServedBy::both: return true;
  }
  return true;
}

bool serves(Quantity film, const Wanted& wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](Quantity quantity) { return serves(film, quantity); });
}

const Wanted& want_everything() {
  static const Wanted all(all_quantities.begin(), all_quantities.end());
  return all;
}

}  // namespace ehd
