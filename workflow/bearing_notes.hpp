// SPDX-License-Identifier: GPL-3.0-or-later
// The notes of a bearing result: every sentence that a reader of a result should know, with its numbers.
#pragma once

#include <string>
#include <vector>

#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/geometry.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_result.hpp"

namespace ehd::note {

using Notes = std::vector<std::string>;

[[nodiscard]] std::string datum(const std::string& name, const bearing::BothRaceways<double>& x0_m);
[[nodiscard]] std::string palmgren_at(double load_N);  ///< the name of a datum
inline constexpr const char* no_force_for_palmgren =
    "x_0 = l, since the dry rollers carry nothing that palmgren's law could be met at";

[[nodiscard]] std::string lateral_force(double force_N);
/// `unraised_N`: where the range would begin without the limit M.
[[nodiscard]] std::string raised_fit(double M, const char* raceway, double from_N, double part_of_dry,
                                     double unraised_N);
[[nodiscard]] std::string no_films(const std::string& why);
[[nodiscard]] std::string no_variant(const std::string& why);
/// `rollers`: of the law without the cut. `on_jump`: rollers stand on the jump of the cut law. `radial`: the variant
/// is balanced in the radial form, for want of a balance in the plane.
[[nodiscard]] std::string variant(const VariantResult& cut, const std::vector<RollerRow>& rollers, bool on_jump,
                                  bool radial);
[[nodiscard]] std::string curve(const bearing::FilmCurve& curve, const std::vector<RollerRow>& rollers,
                                ContactRow RollerRow::*raceway, const char* name);
[[nodiscard]] std::string missed_contacts(std::size_t count);

/// The remarks of nondimensionalise at the mean load but those on pressure, which are made of each roller's own.
void add_lubricant(Notes& notes, const BearingSetup& setup);
/// Where contacts carry a force outside the range of their fit.
void add_fit_range(Notes& notes, const bearing::LinearFit& fit, const std::vector<RollerRow>& rollers,
                   ContactRow RollerRow::*raceway, const char* name);
/// Where the highest pressure is above what steel bears, or a film thinner than the roughness.
void add_limits(Notes& notes, const std::vector<RollerRow>& rollers);

}  // namespace ehd::note
