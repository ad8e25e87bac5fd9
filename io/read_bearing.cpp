// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_bearing.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_faults.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"
#include "io/read_oil.hpp"

namespace ehd {

namespace {

constexpr double narrowest_fit = 1.01;  // high over low: one load determines no line

/// Rollers may overlap: many of them approach Sjovall's integral.
bearing::Geometry read_geometry(const CaseTree& tree) {
  bearing::Geometry geometry;
  geometry.rollers = integer(tree, "bearing.rollers");
  geometry.pitch_diameter_m = number(tree, "bearing.pitch_diameter_m");
  geometry.roller_diameter_m = number(tree, "bearing.roller_diameter_m");
  if (!(geometry.roller_diameter_m < geometry.pitch_diameter_m))
    tree.fail("bearing.roller_diameter_m",
              "is not smaller than the pitch circle; allowed is less than pitch_diameter_m = " +
                  plain(geometry.pitch_diameter_m));
  geometry.length_m = number(tree, "bearing.length_m");
  geometry.clearance_m = number(tree, "bearing.clearance_m");
  geometry.density_kg_per_m3 = number(tree, "bearing.density_kg_per_m3");
  geometry.first_azimuth_deg = number_or_standard(tree, "bearing.first_azimuth_deg");
  return geometry;
}

/// Speeds are stated as that of the ring that turns, or as those of both rings.
void read_speeds(const CaseTree& tree, BearingOperation& operation) {
  const std::string inner = "operation.inner_speed_rpm", outer = "operation.outer_speed_rpm";
  const std::string one = "operation.speed_rpm", rotating = "bearing.rotating";
  const std::string allowed = fmt::format("{} with {}, or {} and {}", rotating, one, inner, outer);
  if (tree.has(inner) || tree.has(outer)) {
    for (const auto& key : {one, rotating}) {
      if (tree.has(key)) tree.fail(key, "contradicts the speeds of both rings; allowed is " + allowed);
    }
    operation.inner_speed_rpm = number(tree, inner);
    operation.outer_speed_rpm = number(tree, outer);
    return;
  }
  if (!tree.has(one)) tree.fail(one, "is missing; required is " + allowed);
  const double speed = number(tree, one);
  if (!tree.has(rotating)) tree.fail(rotating, "is missing; required is " + allowed);
  const bool inner_turns = word(tree, rotating) == "inner";
  (inner_turns ? operation.inner_speed_rpm : operation.outer_speed_rpm) = speed;
}

/// An error of the lubricant alone shows on any contact. M and L of the roller contacts are not known yet.
void check_lubricant(const CaseTree& tree, const BearingCase& bearing) {
  constexpr double some_N = 1;  // where the bearing carries none
  const double load_N = bearing.operation.radial_load_N;
  const Conditions any{.load_N_per_m = (load_N > 0 ? load_N : some_N) / bearing.geometry.length_m,
                       .reduced_radius_m = bearing.geometry.roller_diameter_m / 2,
                       .reduced_modulus_Pa = bearing.modulus_Pa / (1 - bearing.poisson * bearing.poisson),
                       .speed_sum_m_per_s = 1,
                       .viscosity_Pa_s = bearing.lubricant->viscosity_Pa_s};
  try {
    (void)nondimensionalise(any, bearing.lubricant->lubricant, Flooded{});
  } catch (const StatementError& error) {
    if (error.key().starts_with("lubricant.")) fail_statement(tree, error.key(), error);
  }
}

BearingLubricant read_bearing_oil(const CaseTree& tree) {
  const std::string viscosity = "lubricant.viscosity_Pa_s";
  const OilOfCase oil = read_oil(tree);
  refuse_beside_grade(tree, viscosity);
  return {.lubricant = oil.lubricant,
          .viscosity_Pa_s = oil.grade ? oil.grade->viscosity_Pa_s : number(tree, viscosity),
          .oil = oil.grade};
}

Datum read_datum(const CaseTree& tree) {
  const auto load = maybe_number(tree, "datum.load_N");
  const auto x0 = maybe_number(tree, "datum.x0_m");
  const std::string law = tree.has("datum") ? word(tree, "datum.law") : std::string(PalmgrenDatum::name);
  if (law == PalmgrenDatum::name) return PalmgrenDatum{.load_N = load};
  if (law == LundbergDatum::name) return LundbergDatum{};
  if (!x0)
    tree.fail("datum.x0_m", "is missing; required with law = \"x0\" is a length, " + interval_of("datum.x0_m").text());
  return LengthDatum{.x0_m = *x0};
}

std::pair<double, double> read_fit_loads(const CaseTree& tree, const CaseNode& node) {
  const std::string key = "fit.load_N";
  const CaseKey& row = row_of_case_key(key);
  const std::string allowed = "; allowed is " + text_of(row.allowed);
  const auto* pair = std::get_if<std::vector<CaseNode>>(&node.content);
  if (!pair) tree.fail(key, "is " + node.type + allowed);
  if (pair->size() != 2) tree.fail(key, fmt::format("holds {} values{}", pair->size(), allowed));
  const Interval& forces = std::get<allowed::Pair>(row.allowed).each;
  const double low = number_in(tree, key, pair->front(), forces);
  const double high = number_in(tree, key, pair->back(), forces);
  if (!(low < high)) tree.fail(key, "is not increasing" + allowed);
  if (!(high >= narrowest_fit * low)) tree.fail(key, "spans less than 1 %" + allowed + ", high at least 1 % above low");
  return {low, high};
}

FitRange read_fit(const CaseTree& tree) {
  FitRange fit;
  if (tree.has("fit.points")) fit.points = integer(tree, "fit.points");
  if (const CaseNode* loads = tree.find("fit.load_N")) fit.load_N = read_fit_loads(tree, *loads);
  return fit;
}

}  // namespace

BearingCase read_bearing(const CaseTree& tree) {
  refuse_unknown(tree);
  BearingCase bearing;
  bearing.geometry = read_geometry(tree);
  bearing.ring_thickness_m = maybe_number(tree, "bearing.ring_thickness_m");
  bearing.roughness_m = maybe_number(tree, "bearing.roughness_m");
  read_speeds(tree, bearing.operation);
  bearing.operation.radial_load_N = number(tree, "operation.radial_load_N");
  bearing.modulus_Pa = number(tree, "material.modulus_Pa");
  bearing.poisson = number(tree, "material.poisson");
  if (tree.has("lubricant")) {
    bearing.lubricant = read_bearing_oil(tree);
    check_lubricant(tree, bearing);
  }
  bearing.datum = read_datum(tree);
  bearing.fit = read_fit(tree);
  return bearing;
}

}  // namespace ehd
