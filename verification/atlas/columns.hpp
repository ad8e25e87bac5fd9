// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities of the atlas: columns of atlas.csv and expectations of the case files.
#pragma once

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

/// The atlas does not have the pressure maximum (the spike, or near 1), the approach (-H_0), and the self-checks, which
/// belong to a solution.
inline constexpr std::array columns_of_values = {
    AtlasColumn{"H_min", Quantity::film_minimum},     AtlasColumn{"H_cen", Quantity::film_central},
    AtlasColumn{"H_couette", Quantity::film_couette}, AtlasColumn{"X_exit", Quantity::pressure_exit},
    AtlasColumn{"H_0", Quantity::film_offset, true},  AtlasColumn{"rolling_force", Quantity::rolling_force},
    AtlasColumn{"P_spike", Quantity::pressure_spike}, AtlasColumn{"X_spike", std::nullopt, true},
};

}  // namespace ehd::verification
