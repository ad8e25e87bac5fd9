// SPDX-License-Identifier: GPL-3.0-or-later
// The table of bearing quantities: every number that a case may expect of a bearing, with its name, its unit and how it
// is read from a result. The case reader and `measure` iterate over it. A new quantity is one row in
// bearing_quantities.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bearing/geometry.hpp"

namespace ehd {

struct BearingResult;
struct ContactRow;
struct Expectation;

struct BearingQuantityRow {
  using OfRing = std::optional<double> (*)(const BearingResult&);
  using OfContact = std::optional<double> (*)(const ContactRow&);
  /// In case files: of the ring, "displacement"; of a contact, what follows "roller.N.inner." or "roller.N.outer.".
  std::string_view name;
  std::string_view meaning;
  std::string_view unit;
  std::variant<OfRing, OfContact> read;  ///< empty where the result does not have the quantity
  [[nodiscard]] bool of_contact() const { return std::holds_alternative<OfContact>(read); }
};

[[nodiscard]] std::span<const BearingQuantityRow> bearing_quantities();

/// One quantity of one bearing.
struct BearingQuantity {
  const BearingQuantityRow* row = nullptr;
  int roller = 0;  ///< 1, 2, …; 0 for a quantity of the ring
  bearing::Raceway raceway = bearing::Raceway::inner;
};

/// "displacement", "roller.3.inner.force", …; absent for a name that the table does not have.
[[nodiscard]] std::optional<BearingQuantity> bearing_quantity_from(std::string_view name);
/// "displacement, roller.N.inner.force (N from 1), roller.N.outer.force, …" for messages.
[[nodiscard]] std::string names_of_bearing_quantities();

/// The value that the expectation's law gives for its quantity, in SI; absent where there is none.
[[nodiscard]] std::optional<double> measure(const std::vector<BearingResult>& results, const Expectation& expectation);

}  // namespace ehd
