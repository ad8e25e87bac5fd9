// SPDX-License-Identifier: GPL-3.0-or-later
// The table of quantities: one row for each number that can be read off a solved contact. A row holds everything that
// readers, writers, tables and judges need to know about the quantity. A new quantity is a value of the enum, a row in
// quantities.cpp, and a function in observables.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "contact/enum_words.hpp"

namespace ehd {

struct Fields;
struct Reading;
struct ErrorBudget;
struct SolveRecord;

enum class Quantity {
  film_minimum,
  film_central,
  film_couette,
  film_offset,
  pressure_maximum,
  pressure_spike,
  pressure_exit,
  approach,
  rolling_force,
  load_error,
  flux_variation,
};

inline constexpr std::size_t quantity_count = word_count<Quantity>();
inline constexpr auto all_quantities = all_words<Quantity>;

enum class QuantityKind {
  film,           ///< a film thickness; always positive
  offset,         ///< H_0; may have either sign
  pressure_peak,  ///< the maximum of the pressure or the height of its spike
  exit,           ///< the place X* where the pressure ends
  approach,
  force,
  self_check,  ///< measures an error of the solution itself; a case cannot expect a value of it
};

/// The error of an offset or an approach is absolute, because the value may vanish. All others are relative.
enum class ErrorKind { relative, absolute };

/// The films whose tolerance also decides how well a quantity is known.
enum class ServedBy { minimum, central, both };

/// The factor from Hertz units to SI.
enum class SIScale {
  none,      ///< the quantity is not reported in SI
  film,      ///< b^2/R [m]
  length,    ///< b [m]
  pressure,  ///< p_H [Pa]
  force,     ///< p_H b^2/R [N/m]
};

/// Everything that the program knows about one quantity.
struct QuantityRow {
  Quantity quantity;
  QuantityKind kind;
  std::string_view name;     ///< in case files: "film.minimum"
  std::string_view meaning;  ///< in a few words, for help texts
  std::string_view unit;     ///< of Reading::value, in Hertz scaling
  ErrorKind error = ErrorKind::relative;
  ServedBy served_by = ServedBy::both;
  bool in_moes_units = false;                  ///< (h/R) U_s^(-1/2) is also reported
  SIScale SI = SIScale::none;                  ///< how the quantity is reported in SI
  std::optional<double> kostreva_factor = {};  ///< value in Kostreva's scaling over the value in Hertz units, if any
  std::string_view json_entry;                 ///< where the result's JSON has the quantity; dots separate the levels
  std::string_view json_value = {};  ///< key of Reading::value inside that entry; empty: the entry is the value
  /// Reads the quantity off the fields. Empty where the fields do not have it.
  std::optional<Reading> (*observe)(const Fields& fields);
  /// The exact value in Hertz' solution without a lubricant; null where that has none.
  Reading (*when_dry)() = nullptr;
  /// Where the record of a solve keeps the parts of the error; null for most quantities.
  ErrorBudget SolveRecord::*budget = nullptr;
};

/// The table, in the order of the enum.
[[nodiscard]] const std::array<QuantityRow, quantity_count>& quantity_table();
[[nodiscard]] const QuantityRow& row_of(Quantity quantity);

[[nodiscard]] std::string_view to_string(Quantity quantity);  ///< "film.minimum", …
[[nodiscard]] std::optional<Quantity> quantity_from(std::string_view text);

[[nodiscard]] bool has_absolute_error(Quantity quantity);
[[nodiscard]] bool is_film(Quantity quantity);           ///< film.minimum, film.central, film.couette
[[nodiscard]] bool is_pressure_peak(Quantity quantity);  ///< pressure.maximum, pressure.spike
[[nodiscard]] bool is_self_check(Quantity quantity);     ///< load_error, flux_variation
[[nodiscard]] bool exists_when_dry(Quantity quantity);

/// The names of all quantities for which `holds`, separated by commas: for messages that list what is allowed.
[[nodiscard]] std::string names_of_quantities(bool (*holds)(Quantity));

/// The two films that a tolerance is about. Every solver states their errors.
inline constexpr std::array judged_films{Quantity::film_minimum, Quantity::film_central};

/// The quantities that a caller asks for. All others are not computed.
using Wanted = std::set<Quantity>;
/// The tolerance of `film`, one of judged_films, decides how well the quantity is known.
[[nodiscard]] bool serves(Quantity film, Quantity quantity);
/// The same of at least one of these quantities.
[[nodiscard]] bool serves(Quantity film, const Wanted& wanted);
[[nodiscard]] const Wanted& want_everything();

}  // namespace ehd
