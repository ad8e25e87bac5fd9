// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_oil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/oil_laws.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_tree.hpp"
#include "io/case_values.hpp"

namespace ehd {

namespace {

constexpr const char* iso_vg = "lubricant.iso_vg";
constexpr const char* at_40C = "lubricant.viscosity_40C_mm2_per_s";
constexpr const char* at_100C = "lubricant.viscosity_100C_mm2_per_s";
constexpr const char* index_key = "lubricant.viscosity_index";
constexpr const char* temperature = "lubricant.temperature_C";
constexpr const char* density = "lubricant.density_15C_kg_per_m3";
constexpr std::array grade_keys{iso_vg, at_40C, at_100C};
constexpr std::array keys_beside_grade{temperature, index_key, density};

constexpr const char* two_ways = "allowed is iso_vg, or viscosity_40C_mm2_per_s with viscosity_100C_mm2_per_s";

/// The first key that states the grade.
std::string_view grade_key(const CaseTree& tree) {
  for (const char* key : grade_keys)
    if (tree.has(key)) return key;
  return "";
}

Lubricant read_laws(const CaseTree& tree) {
  Lubricant lubricant;
  lubricant.viscosity = *viscosity_law_from(word(tree, "lubricant.viscosity"));
  lubricant.density = *density_law_from(word(tree, "lubricant.density"));
  lubricant.alpha_per_Pa = maybe_number(tree, "lubricant.alpha_per_Pa");
  lubricant.z = maybe_number(tree, "lubricant.z");
  lubricant.p0_Pa = number_or_standard(tree, "lubricant.p0_Pa");
  return lubricant;
}

/// Keys that make no sense together. Their values have been checked before.
void require_one_way(const CaseTree& tree) {
  if (!states_grade(tree)) {
    for (const char* key : keys_beside_grade)
      if (tree.has(key)) tree.fail(key, std::string("belongs to an oil that is stated by its grade; ") + two_ways);
    return;
  }
  if (tree.has(iso_vg)) {
    for (const char* key : {at_40C, at_100C})
      if (tree.has(key)) tree.fail(key, std::string("contradicts iso_vg, which sets it; ") + two_ways);
    return;
  }
  if (tree.has(index_key))
    tree.fail(index_key, "contradicts the two viscosities, which set it; allowed is with iso_vg");
  for (const char* key : {at_40C, at_100C}) (void)required(tree, key);
}

/// "viscosity_index of at least 378, or ": the smallest whole index that gives 2 mm2/s or more at 100 C. Empty where it
/// is above the largest index of a case.
std::string higher_index(double viscosity_40C_mm2_per_s) {
  const double least = std::ceil(viscosity_index(viscosity_40C_mm2_per_s, least_with_index).value());
  return interval_of(index_key).contains(least) ? fmt::format("viscosity_index of at least {}, or ", plain(least)) : "";
}

/// The viscosities at 40 and 100 C.
void read_viscosities(const CaseTree& tree, GradedOil& oil) {
  if (!oil.iso_vg) {
    oil.viscosity_40C_mm2_per_s = number(tree, at_40C);
    oil.viscosity_100C_mm2_per_s = number(tree, at_100C);
    if (!(oil.viscosity_100C_mm2_per_s < oil.viscosity_40C_mm2_per_s))
      tree.fail(at_100C, "is not below the viscosity at 40 C; allowed is less than viscosity_40C_mm2_per_s = " +
                             plain(oil.viscosity_40C_mm2_per_s));
    oil.viscosity_index = viscosity_index(oil.viscosity_40C_mm2_per_s, oil.viscosity_100C_mm2_per_s);
    return;
  }
  oil.viscosity_40C_mm2_per_s = *midpoint_of_grade_mm2_per_s(*oil.iso_vg);
  oil.viscosity_index = number_or_standard(tree, index_key);
  const auto follows = viscosity_100C_mm2_per_s(oil.viscosity_40C_mm2_per_s, *oil.viscosity_index);
  if (!follows)
    tree.fail(iso_vg, fmt::format("with viscosity index {} would have less than 2 mm2/s at 100 C, where ASTM D2270 "
                                  "defines no index; allowed is {}viscosity_40C_mm2_per_s with "
                                  "viscosity_100C_mm2_per_s in its place",
                                  plain(*oil.viscosity_index), higher_index(oil.viscosity_40C_mm2_per_s)));
  oil.viscosity_100C_mm2_per_s = *follows;
}

std::optional<GradedOil> read_grade(const CaseTree& tree) {
  // Values first, so that a wrong one is named whatever stands beside it.
  GradedOil oil{.iso_vg = maybe_one_of(tree, iso_vg)};
  for (const char* key : {at_40C, at_100C, index_key, temperature, density}) (void)maybe_number(tree, key);
  require_one_way(tree);
  if (!states_grade(tree)) return std::nullopt;
  read_viscosities(tree, oil);
  oil.temperature_C = number(tree, temperature);
  oil.density_15C_kg_per_m3 = number_or_standard(tree, density);
  const auto viscosity =
      viscosity_at_mm2_per_s(oil.viscosity_40C_mm2_per_s, oil.viscosity_100C_mm2_per_s, oil.temperature_C);
  if (!viscosity)
    tree.fail(temperature,
              "leaves the range of ASTM D341; allowed is a temperature at which the oil has 0.21 to 2e7 "
              "mm2/s");
  oil.viscosity_mm2_per_s = *viscosity;
  oil.density_kg_per_m3 = oil_density_kg_per_m3(oil.density_15C_kg_per_m3, oil.temperature_C);
  oil.viscosity_Pa_s = 1e-6 * oil.viscosity_mm2_per_s * oil.density_kg_per_m3;
  return oil;
}

}  // namespace

OilOfCase read_oil(const CaseTree& tree) {
  OilOfCase oil{.lubricant = read_laws(tree), .grade = read_grade(tree)};
  const LawKeys keys = row_of(oil.lubricant.viscosity).keys;
  const bool follows_from_z = keys.z && oil.lubricant.z;
  if (!oil.grade || !keys.alpha_per_Pa || oil.lubricant.alpha_per_Pa || follows_from_z) return oil;
  const std::string key = "lubricant.alpha_per_Pa";
  oil.grade->estimated_alpha_per_Pa = wooster_alpha_per_Pa(oil.grade->viscosity_Pa_s);
  if (!oil.grade->estimated_alpha_per_Pa)
    tree.fail(key,
              fmt::format("is missing, and the estimate for mineral oils ends above eta_0 = {} Pa s; required is {}",
                          plain(oil.grade->viscosity_Pa_s, 3), text_of(row_of_case_key(key).allowed)));
  oil.lubricant.alpha_per_Pa = oil.grade->estimated_alpha_per_Pa;
  return oil;
}

std::string key_beside_grade(const CaseTree& tree) {
  for (const std::string key : keys_beside_grade)
    if (tree.has(key)) return key.substr(key.find('.') + 1);
  return "";
}

bool is_grade_key(std::string_view key) { return std::ranges::find(grade_keys, key) != grade_keys.end(); }

bool states_grade(const CaseTree& tree) { return !grade_key(tree).empty(); }

void refuse_beside_grade(const CaseTree& tree, std::string_view viscosity_key) {
  if (states_grade(tree) && tree.has(viscosity_key))
    tree.fail(viscosity_key, "contradicts the oil's grade in [lubricant], which sets eta_0; allowed is one of the two");
}

void refuse_grade_beside(const CaseTree& tree, const std::string& statement) {
  if (states_grade(tree))
    tree.fail(grade_key(tree), fmt::format("contradicts [{}], whose groups contain eta_0 already; allowed is an oil's "
                                           "grade with [conditions], or in a bearing case",
                                           statement));
}

}  // namespace ehd
