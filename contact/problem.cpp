// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/problem.hpp"

#include <iterator>

namespace ehd {

std::string_view to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::film_minimum: return "film.minimum";
    case Quantity::film_central: return "film.central";
    case Quantity::film_couette: return "film.couette";
    case Quantity::film_offset: return "film.offset";
    case Quantity::pressure_maximum: return "pressure.maximum";
    case Quantity::pressure_spike: return "pressure.spike";
    case Quantity::pressure_exit: return "pressure.exit";
    case Quantity::approach: return "approach";
    case Quantity::rolling_force: return "rolling_force";
    case Quantity::load_error: return "load_error";
    case Quantity::flux_variation: return "flux_variation";
  }
  return "";
}

std::optional<Quantity> quantity_from(std::string_view text) {
  for (const Quantity quantity : all_quantities) {
    if (text == to_string(quantity)) return quantity;
  }
  return std::nullopt;
}

Wanted want_everything() { return {std::begin(all_quantities), std::end(all_quantities)}; }

}  // namespace ehd
