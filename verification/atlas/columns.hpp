// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities of the atlas: columns of atlas.csv and expectations of the case files.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "contact/quantities.hpp"

namespace ehd::verification {

/// A column; NAME_error follows it.
struct AtlasColumn {
  std::string_view name;
  std::optional<Quantity> quantity;  ///< none for the place of the spike, which no case expects
  bool absolute = false;             ///< NAME_error is absolute

  [[nodiscard]] std::string error_name() const { return std::string(name) + "_error"; }
};

inline constexpr std::array columns_of_values = {
    AtlasColumn{"H_min", Quantity::film_minimum},     AtlasColumn{"H_cen", Quantity::film_central},
    AtlasColumn{"H_couette", Quantity::film_couette}, AtlasColumn{"X_exit", Quantity::pressure_exit},
    AtlasColumn{"H_0", Quantity::film_offset, true},  AtlasColumn{"rolling_force", Quantity::rolling_force},
    AtlasColumn{"P_spike", Quantity::pressure_spike}, AtlasColumn{"X_spike", std::nullopt, true},
};

/// A visit: a new quantity does not compile until it is decided here whether the atlas has it.
constexpr bool is_in_atlas(Quantity quantity) {
  switch (quantity) {
    case Quantity::film_minimum:
    case Quantity::film_central:
    case Quantity::film_couette:
    case Quantity::film_offset:
    case Quantity::pressure_spike:
    case Quantity::pressure_exit:
    case Quantity::rolling_force: return true;
    case Quantity::pressure_maximum:  // the spike, or near 1
    case Quantity::approach:          // -H_0
    case Quantity::load_error:        // of a solution, not of the contact
    case Quantity::flux_variation: return false;
  }
  return false;
}

static_assert(std::all_of(all_quantities.begin(), all_quantities.end(),
                          [](Quantity quantity) {
                            const auto is_its = [=](const AtlasColumn& column) { return column.quantity == quantity; };
                            return std::count_if(columns_of_values.begin(), columns_of_values.end(), is_its) ==
                                   (is_in_atlas(quantity) ? 1 : 0);
                          }),
              "each quantity that is in the atlas has one column");

}  // namespace ehd::verification
