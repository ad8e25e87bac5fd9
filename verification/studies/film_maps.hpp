// SPDX-License-Identifier: GPL-3.0-or-later
// What the atlas says of the film formulas, and of inlets cut at X = -4, over M and L. Read from cases/atlas/atlas.csv;
// nothing is solved. Formulas are regressions: a deviation is shown, never judged.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/atlas/atlas.hpp"

namespace ehd::verification {

/// A number with its uncertainty: of a film relative, of a ratio absolute.
struct MapValue {
  double value = 0;
  double error = 0;
};

/// A formula at one point of the atlas.
struct MapFormula {
  std::string name;
  std::string of;        ///< "film.minimum" | "film.central" | "film.couette"
  double moes = 0;       ///< the formula's film, Moes units
  double deviation = 0;  ///< formula/certified - 1
};

/// M, L and laws, flooded, with the same point cut at X = -4 beside it.
struct MapPoint {
  AtlasPoint at;
  std::optional<MapValue> minimum, central, couette;   ///< certified, flooded, Moes units; absent: not known to 1e-4
  std::optional<MapValue> minimum_cost, central_cost;  ///< film cut at -4 over flooded - 1; absent for M < 2
  std::vector<MapFormula> formulas;                    ///< of the films that are known

  [[nodiscard]] const std::optional<MapValue>& film(std::string_view quantity) const;  ///< "film.minimum" …
};

struct FilmMaps {
  std::string source;
  std::vector<double> M, L;  ///< increasing
  std::vector<MapPoint> points;
};

/// The power laws of U, W, G need a G where M and L alone are given: usual_G of contact/film_formulas.hpp.
[[nodiscard]] FilmMaps film_maps(const AtlasTable& table);
/// The same from a folder; throws CaseError where there is no atlas.csv, or one of another kind.
[[nodiscard]] FilmMaps film_maps(const std::filesystem::path& folder);

inline constexpr double close_formula = 0.05;  ///< "within 5 %"
inline constexpr double poor_formula = 0.30;   ///< "30 % or more off"

/// In percent, two digits (none below 0.01) and no more than are known: "+1.3"; "0" where the value is within its own
/// (absolute) error.
[[nodiscard]] std::string known_percent(const MapValue& fraction);

/// Deviations in percent over M and L of every formula of `quantity` ("film.minimum"; "film.central", which has the
/// Couette film with it), for each L the M where it is close and where it is poor, then what an inlet at -4 costs.
/// Empty quantity: both. `laws`: barus or roelands; L = 0 is isoviscous in both.
[[nodiscard]] std::string human_maps(const FilmMaps& maps, std::string_view quantity, AtlasLaws laws);

/// A line a formula and point, a header line first; all quantities and laws.
[[nodiscard]] std::string formula_maps_csv(const FilmMaps& maps);
/// A line a film and point with a cut inlet beside it.
[[nodiscard]] std::string inlet_maps_csv(const FilmMaps& maps);

}  // namespace ehd::verification
