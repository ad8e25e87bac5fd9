// SPDX-License-Identifier: GPL-3.0-or-later
// Film formulas, and inlets cut at X = -4, against the certified films of the atlas, over M and L. The films are read
// from cases/atlas/atlas.csv; nothing is solved. The formulas are published fits: for comparison only, never judged.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "contact/quantities.hpp"
#include "verification/atlas/atlas.hpp"

namespace ehd::verification {

/// A number with its uncertainty: relative for a film, absolute for a ratio.
struct MapValue {
  double value = 0;
  double error = 0;
};

/// A formula at one point of the atlas.
struct MapFormula {
  std::string name;
  Quantity of = Quantity::film_minimum;
  double moes = 0;       ///< the formula's film, Moes units
  double deviation = 0;  ///< formula/certified - 1
};

/// M, L and laws, flooded and with the inlet cut at X = -4.
struct MapPoint {
  AtlasPoint at;
  std::optional<MapValue> minimum, central, couette;   ///< certified, flooded, Moes units; absent: not known to 1e-4
  std::optional<MapValue> minimum_cost, central_cost;  ///< film cut at -4 over flooded - 1; absent for M < 2
  std::vector<MapFormula> formulas;                    ///< of the films that are known

  /// The minimum, the central or the Couette film.
  [[nodiscard]] const std::optional<MapValue>& film(Quantity quantity) const;
  /// What the cut inlet costs: of one of judged_films.
  [[nodiscard]] const std::optional<MapValue>& cost(Quantity film) const;
};

struct FilmMaps {
  std::string source;
  std::vector<double> M, L;  ///< increasing
  std::vector<MapPoint> points;
};

/// The power laws of U, W and G need a G besides M and L: usual_G of contact/film_formulas.hpp.
[[nodiscard]] FilmMaps film_maps(const AtlasTable& table);
/// The same from a folder; throws CaseError where there is no atlas.csv, or one of another kind.
[[nodiscard]] FilmMaps film_maps(const std::filesystem::path& folder);

inline constexpr double close_formula = 0.05;  ///< "within 5 %"
inline constexpr double poor_formula = 0.30;   ///< "30 % or more off"

/// In percent: two digits, fewer where fewer are known, none below 0.01: "+1.3". "0" where the value is within its own
/// (absolute) error.
[[nodiscard]] std::string known_percent(const MapValue& fraction);

/// For every formula of `quantity` the deviations in percent over M and L, and for each L the M where it is close and
/// where it is poor; then what an inlet cut at -4 costs. `quantity`: a film, the central film with the
/// Couette film; absent: all. Of the Couette film alone there is no cut inlet. `laws`: barus or roelands; L = 0 is
/// isoviscous in both.
[[nodiscard]] std::string human_maps(const FilmMaps& maps, std::optional<Quantity> quantity, AtlasLaws laws);

/// A line for each formula and point, after a header line; all quantities and laws.
[[nodiscard]] std::string formula_maps_csv(const FilmMaps& maps);
/// A line for each film and point that has a cut inlet too.
[[nodiscard]] std::string inlet_maps_csv(const FilmMaps& maps);

}  // namespace ehd::verification
