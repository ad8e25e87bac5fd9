// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/oil_laws.hpp"

#include <utility>

namespace ehd {

namespace {

template <ViscosityFormula Law>
Viscosity made_from(const LawInputs& inputs) {
  return Law::from(inputs);
}

template <ViscosityFormula... Laws, std::size_t... Places>
constexpr std::array<ViscosityLawRow, sizeof...(Laws)> rows_of(const std::variant<Laws...>*,
                                                               std::index_sequence<Places...>) {
  return {ViscosityLawRow{
      .law = static_cast<ViscosityLaw>(Places), .name = Laws::name, .keys = Laws::keys, .from = made_from<Laws>}...};
}

/// One row for each alternative of the variant, made from the members of the law's struct.
constexpr auto viscosity_table =
    rows_of(static_cast<const Viscosity*>(nullptr), std::make_index_sequence<viscosity_law_count>{});

constexpr bool is_row(ViscosityLaw law, std::string_view name) {
  return viscosity_table[static_cast<std::size_t>(law)].name == name;
}
static_assert(word_count<ViscosityLaw>() == viscosity_law_count, "each viscosity law is a word and a struct");
static_assert(is_row(ViscosityLaw::isoviscous, Isoviscous::name) && is_row(ViscosityLaw::barus, Barus::name) &&
                  is_row(ViscosityLaw::roelands, Roelands::name),
              "the enum ViscosityLaw has the order of the variant Viscosity");

constexpr std::array<DensityLawRow, density_law_count> density_table{{
    {.law = DensityLaw::incompressible, .name = Incompressible::name, .per_Pa = Incompressible{}},
    {.law = DensityLaw::dowson_higginson, .name = "dowson-higginson", .per_Pa = dowson_higginson_per_Pa()},
    {.law = DensityLaw::dowson_higginson_1977,
     .name = "dowson-higginson-1977",
     .per_Pa = dowson_higginson_1977_per_Pa()},
}};

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < density_table.size(); ++i) {
    if (density_table[i].law != static_cast<DensityLaw>(i)) return false;
  }
  return true;
}
static_assert(in_order_of_the_enum(), "each density law has one row, in the order of the enum");

}  // namespace

const std::array<ViscosityLawRow, viscosity_law_count>& viscosity_laws() { return viscosity_table; }
const std::array<DensityLawRow, density_law_count>& density_laws() { return density_table; }

const ViscosityLawRow& row_of(ViscosityLaw law) { return viscosity_table[static_cast<std::size_t>(law)]; }
const DensityLawRow& row_of(DensityLaw law) { return density_table[static_cast<std::size_t>(law)]; }

std::string piezoviscous_names() {
  std::string names;
  for (const ViscosityLawRow& row : viscosity_table) {
    if (row.keys.alpha_per_Pa) names += (names.empty() ? "" : " or ") + std::string(row.name);
  }
  return names;
}

std::string_view to_string(ViscosityLaw law) { return row_of(law).name; }
std::string_view to_string(DensityLaw law) { return row_of(law).name; }

std::optional<ViscosityLaw> viscosity_law_from(std::string_view text) { return word_from<ViscosityLaw>(text); }
std::optional<DensityLaw> density_law_from(std::string_view text) { return word_from<DensityLaw>(text); }

}  // namespace ehd
