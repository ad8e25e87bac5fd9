// SPDX-License-Identifier: GPL-3.0-or-later
// The contact force laws that a case can ask for: one row a law. Readers, help texts, messages, results and reports
// iterate over the table.
//
// To add a law: its formula in force_law (or approach_formulas), a name in the enum below, a row in law_table.cpp.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bearing/geometry.hpp"

namespace ehd::bearing {

class FilmCurve;
struct LawPair;
struct LinearFit;
struct RollerContact;

/// In the order in which results and messages list them.
enum class Law { hertz, iso, lundberg, tripp, houpert, ehd_linear, ehd };

using SharedCurve = std::shared_ptr<const FilmCurve>;

/// How the laws at the inner and the outer contact are made. The kind of maker says what a law needs: a dry law needs
/// the roller alone, the others need solved contacts.
using FromRoller = LawPair (*)(const RollerContact& contact);
using FromFits = LawPair (*)(const BothRaceways<LinearFit>& fits);
/// Throws std::domain_error for a datum that is too short (CurveLaw).
using FromCurves = LawPair (*)(const BothRaceways<SharedCurve>& curves, const BothRaceways<double>& datum_m);
using LawMaker = std::variant<FromRoller, FromFits, FromCurves>;

/// All there is to know about a law.
struct LawRow {
  Law law;
  std::string_view name;              ///< in cases, options and results
  std::string_view description;       ///< formula and source, one line
  bool needs_ring_thickness = false;  ///< RollerContact::ring_thickness_m, at the outer raceway
  bool is_default = false;            ///< balanced where nobody asks for particular laws
  LawMaker make;

  /// It needs a lubricant, and rings that move against each other.
  [[nodiscard]] bool needs_film() const { return !std::holds_alternative<FromRoller>(make); }
};

/// Every law, in the order of the enum.
[[nodiscard]] std::span<const LawRow> law_rows();
[[nodiscard]] const LawRow& row_of(Law law);

[[nodiscard]] std::string_view to_string(Law law);  ///< "hertz", ..., "houpert", "ehd-linear", "ehd"
[[nodiscard]] std::optional<Law> law_from(std::string_view text);
[[nodiscard]] bool needs_film(Law law);
[[nodiscard]] bool needs_ring_thickness(Law law);

/// A dry law at both raceways. Throws std::invalid_argument for a law with films.
[[nodiscard]] LawPair dry_laws(Law law, const RollerContact& contact);

/// Choices of laws.
enum class Laws { all, dry, dry_without_ring_thickness, from_fits, by_default, by_default_dry };
[[nodiscard]] std::vector<Law> laws_of(Laws which);
/// "hertz, iso, lundberg", for messages. `last`: what stands before the last name.
[[nodiscard]] std::string names_of(Laws which, std::string_view last = ", ");

}  // namespace ehd::bearing
