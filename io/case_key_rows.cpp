// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the table of case keys: ranges, words, and every key of every table.
#include <array>
#include <string>
#include <vector>

#include "bearing/law_table.hpp"
#include "contact/nondimensional.hpp"
#include "contact/oil_grade.hpp"
#include "contact/oil_laws.hpp"
#include "io/case_keys.hpp"
#include "workflow/case.hpp"

namespace ehd {

namespace {

// The bounds of physical quantities are wide on purpose: no product of them overflows or underflows, and no real
// contact or bearing lies outside.
constexpr Interval lengths{.low = 1e-9, .high = 1e6};                          // m
constexpr Interval clearances{.low = -1e-1, .high = 1e-1};                     // m; negative: preload
constexpr Interval moduli{.low = 1e3, .high = 1e15};                           // Pa
constexpr Interval pressures{.low = 1e3, .high = 1e15};                        // Pa
constexpr Interval line_loads{.low = 1e-6, .high = 1e12};                      // N/m
constexpr Interval forces{.low = 1e-9, .high = 1e12};                          // N
constexpr Interval loads{.low = 1e-9, .high = 1e12, .or_zero = true};          // N; a bearing may turn without load
constexpr Interval speeds{.low = 1e-12, .high = 1e6};                          // m/s
constexpr Interval turning{.low = 1e-9, .high = 1e7, .or_zero = true};         // rpm of the ring that `rotating` names
constexpr Interval signed_turning{.low = -1e7, .high = 1e7};                   // rpm
constexpr Interval viscosities{.low = 1e-12, .high = 1e9};                     // Pa s
constexpr Interval coefficients{.low = 1e-15, .high = 1e-3, .or_zero = true};  // 1/Pa
constexpr Interval exponents{.low = 1e-3, .high = 10};
constexpr Interval densities{.low = 1e-3, .high = 1e6};             // kg/m3
constexpr Interval kinematic_viscosities{.low = 0.3, .high = 1e5};  // mm2/s
constexpr Interval indices{.low = -100, .high = 400};
// The range of ASTM D1250 for lubricating oils.
constexpr Interval oil_temperatures{.low = -50, .high = 150};  // C
constexpr Interval oil_densities{.low = 800, .high = 1164};    // kg/m3
constexpr Interval azimuths{.low = -360, .high = 360};         // degrees
constexpr Interval poisson_ratios{.low = -1, .high = 0.5, .open_low = true};
constexpr Interval M_range{.low = smallest_M, .high = largest_M};
// Below 1e-12 no result depends on L any more, and p_H in Pa would leave the range of numbers.
constexpr Interval L_range{.low = 1e-12, .high = largest_L, .or_zero = true};
constexpr Interval lambda_range{.low = 1e-12, .high = 1e7};  // wider than M_range, which is checked as well
constexpr Interval alpha_p_H_range{.low = 1e-12, .high = 1e6, .or_zero = true};
constexpr Interval relative_uncertainties{.low = 0, .high = 1};
constexpr allowed::Integer versions{.low = 1, .high = 1000000};
constexpr allowed::Integer rollers{.low = 3, .high = 400};
constexpr allowed::Integer fit_points{.low = 3, .high = 200};
constexpr allowed::Inlet inlets{.word = "flooded", .farthest = -1e6, .edge = -1};  // X = -1: the edge of the contact

template <class Rows>
std::vector<std::string> names_of_rows(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}
std::vector<std::string> viscosity_names() { return names_of_rows(viscosity_laws()); }
std::vector<std::string> density_names() { return names_of_rows(density_laws()); }
std::vector<std::string> law_names() { return names_of_rows(bearing::law_rows()); }
std::vector<std::string> ring_names() {
  return {std::string(to_string(bearing::Raceway::inner)), std::string(to_string(bearing::Raceway::outer))};
}
std::vector<std::string> datum_names() {
  return {std::string(PalmgrenDatum::name), std::string(LundbergDatum::name), std::string(LengthDatum::name)};
}
std::vector<std::string> status_names() { return {"waiting"}; }
std::vector<std::string> scaling_names() {
  std::vector<std::string> names;
  for (const Scaling scaling : all_scalings) names.emplace_back(to_string(scaling));
  return names;
}
std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const ExpectationKind kind : all_expectation_kinds) names.emplace_back(to_string(kind));
  return names;
}

constexpr std::array heading_keys{
    CaseKey{.name = "id",
            .allowed = allowed::Text{"the file's name without .toml"},
            .meaning = "the name of the case; its file is called the same",
            .example = "\"ID\""},
    CaseKey{.name = "version", .allowed = versions, .meaning = "counts changes of the case's numbers", .example = "1"},
    CaseKey{.name = "title",
            .allowed = allowed::Text{"a title"},
            .meaning = "one line for tables and reports",
            .example = "\"TITLE\""},
    CaseKey{.name = "source",
            .allowed = allowed::Text{"\"own\", or \"bibkey, the exact place\""},
            .meaning = "where the case is from; bibkey is an entry of references.bib",
            .example = "\"own\""},
};

constexpr std::array moes_keys{
    CaseKey{
        .name = "M", .allowed = M_range, .meaning = "load group W U_s^(-1/2), with the sum speed", .example = "20.0"},
    CaseKey{.name = "L",
            .allowed = L_range,
            .meaning = "lubricant group G U_s^(1/4), with the sum speed",
            .example = "10.0"},
};

constexpr std::array conditions_keys{
    CaseKey{.name = "load_N_per_m",
            .unit = "N/m",
            .allowed = line_loads,
            .meaning = "load per length of the contact",
            .example = "1.0e5"},
    CaseKey{.name = "reduced_radius_m",
            .unit = "m",
            .allowed = lengths,
            .meaning = "R with 1/R = 1/R_1 + 1/R_2, concave negative",
            .example = "1.0e-2"},
    CaseKey{.name = "reduced_modulus_Pa",
            .unit = "Pa",
            .allowed = moduli,
            .meaning = "E', not Young's modulus: 2/E' = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2",
            .example = "2.2e11"},
    CaseKey{.name = "speed_sum_m_per_s",
            .unit = "m/s",
            .allowed = speeds,
            .need = Need::sometimes,
            .condition = "the contact is lubricated",
            .meaning = "u_s = u_1 + u_2, the sum of the surface speeds, not the mean; a dry contact may have 0",
            .example = "3.0",
            .in_new = true},
    CaseKey{.name = "viscosity_Pa_s",
            .unit = "Pa s",
            .allowed = viscosities,
            .need = Need::sometimes,
            .condition = "the contact is lubricated, and its oil not stated by grade",
            .meaning = "eta_0, the viscosity at ambient pressure",
            .example = "0.02"},
};

constexpr std::array hertz_keys{
    CaseKey{.name = "lambda", .allowed = lambda_range, .meaning = "6 eta_0 u_s R^2/(b^3 p_H)", .example = "1.51425"},
    CaseKey{.name = "alpha_p_H",
            .allowed = alpha_p_H_range,
            .meaning = "pressure coefficient times Hertz pressure",
            .example = "2.832"},
};

constexpr std::array bearing_keys{
    CaseKey{.name = "rollers", .allowed = rollers, .meaning = "number of rollers Z", .example = "14"},
    CaseKey{.name = "pitch_diameter_m",
            .unit = "m",
            .allowed = lengths,
            .meaning = "diameter of the pitch circle",
            .example = "0.065"},
    CaseKey{.name = "roller_diameter_m",
            .unit = "m",
            .allowed = lengths,
            .meaning = "diameter of a roller, smaller than the pitch circle",
            .example = "0.010"},
    CaseKey{.name = "length_m",
            .unit = "m",
            .allowed = lengths,
            .meaning = "effective contact length of a roller",
            .example = "0.0096"},
    CaseKey{.name = "clearance_m",
            .unit = "m",
            .allowed = clearances,
            .meaning = "diametral clearance; negative: preload",
            .example = "10e-6"},
    CaseKey{.name = "rotating",
            .allowed = allowed::Word{ring_names},
            .need = Need::sometimes,
            .condition = "operation.speed_rpm is stated",
            .meaning = "the ring that turns",
            .example = "\"inner\"",
            .in_new = true},
    CaseKey{.name = "density_kg_per_m3",
            .unit = "kg/m3",
            .allowed = densities,
            .meaning = "density of the rollers, for the centrifugal force",
            .example = "7860.0"},
    CaseKey{.name = "first_azimuth_deg",
            .unit = "degrees",
            .allowed = azimuths,
            .need = Need::never,
            .standard = 0,
            .meaning = "angle from the load to roller 1",
            .example = "0.0"},
    CaseKey{.name = "ring_thickness_m",
            .unit = "m",
            .allowed = lengths,
            .need = Need::sometimes,
            .condition = "a contact force law needs it",
            .meaning = "thickness of the outer ring, in contact approaches alone",
            .example = "0.005"},
    CaseKey{.name = "roughness_m",
            .unit = "m",
            .allowed = lengths,
            .need = Need::never,
            .otherwise = "no lambda ratios",
            .meaning = "composite roughness, for lambda ratios",
            .example = "1.0e-7"},
};

constexpr std::array operation_keys{
    CaseKey{.name = "speed_rpm",
            .unit = "rpm",
            .allowed = turning,
            .need = Need::sometimes,
            .condition = "bearing.rotating is stated",
            .meaning = "speed of the ring that turns",
            .example = "3000.0",
            .in_new = true},
    CaseKey{.name = "inner_speed_rpm",
            .unit = "rpm",
            .allowed = signed_turning,
            .need = Need::sometimes,
            .condition = "the speed of the outer ring is stated",
            .meaning = "speed of the inner ring, with sign",
            .example = "3000.0"},
    CaseKey{.name = "outer_speed_rpm",
            .unit = "rpm",
            .allowed = signed_turning,
            .need = Need::sometimes,
            .condition = "the speed of the inner ring is stated",
            .meaning = "speed of the outer ring, with sign",
            .example = "0.0"},
    CaseKey{.name = "radial_load_N", .unit = "N", .allowed = loads, .meaning = "radial load F_r", .example = "4450.0"},
};

constexpr std::array material_keys{
    CaseKey{.name = "modulus_Pa",
            .unit = "Pa",
            .allowed = moduli,
            .meaning = "Young's modulus of rollers and rings",
            .example = "2.06e11"},
    CaseKey{.name = "poisson",
            .allowed = poisson_ratios,
            .meaning = "Poisson's ratio of rollers and rings",
            .example = "0.3"},
};

constexpr std::array lubricant_keys{
    CaseKey{.name = "viscosity",
            .allowed = allowed::Word{viscosity_names},
            .meaning = "the law eta(p)",
            .example = "\"roelands\""},
    CaseKey{.name = "density",
            .allowed = allowed::Word{density_names},
            .meaning = "the law rho(p)",
            .example = "\"dowson-higginson\""},
    CaseKey{.name = "alpha_per_Pa",
            .unit = "1/Pa",
            .allowed = coefficients,
            .need = Need::sometimes,
            .condition = "a law needs pressures in Pa and the oil has no grade",
            .meaning = "pressure coefficient of the viscosity at ambient pressure",
            .example = "2.0e-8"},
    CaseKey{.name = "z",
            .allowed = exponents,
            .need = Need::sometimes,
            .condition = "viscosity = \"roelands\" and eta_0 is unknown",
            .meaning = "Roelands' exponent",
            .example = "0.68"},
    CaseKey{.name = "p0_Pa",
            .unit = "Pa",
            .allowed = pressures,
            .need = Need::never,
            .standard = roelands_pressure_Pa,
            .meaning = "Roelands' reference pressure",
            .example = "1.9613e8"},
    CaseKey{.name = "viscosity_Pa_s",
            .unit = "Pa s",
            .allowed = viscosities,
            .need = Need::sometimes,
            .condition = "the oil is not stated by its grade",
            .bearing_only = true,
            .meaning = "eta_0, the viscosity at ambient pressure",
            .example = "0.02"},
    CaseKey{.name = "iso_vg",
            .allowed = allowed::OneOf{iso_viscosity_grades},
            .need = Need::never,
            .otherwise = "eta_0 is stated",
            .meaning = "the oil's grade of ISO 3448, which sets eta_0; 2 and 3 have no viscosity index (ASTM D2270), 5 "
                       "has one from 378, 7 from 75: for others state the viscosities at 40 and 100 \u00b0C",
            .example = "68",
            .in_new = true},
    CaseKey{.name = "viscosity_index",
            .allowed = indices,
            .need = Need::never,
            .standard = 95,
            .meaning = "viscosity index of ASTM D2270, with iso_vg",
            .example = "95.0"},
    CaseKey{.name = "viscosity_40C_mm2_per_s",
            .unit = "mm2/s",
            .allowed = kinematic_viscosities,
            .need = Need::sometimes,
            .condition = "viscosity_100C_mm2_per_s is stated",
            .meaning = "kinematic viscosity at 40 \u00b0C, in place of iso_vg",
            .example = "68.0"},
    CaseKey{.name = "viscosity_100C_mm2_per_s",
            .unit = "mm2/s",
            .allowed = kinematic_viscosities,
            .need = Need::sometimes,
            .condition = "viscosity_40C_mm2_per_s is stated",
            .meaning = "kinematic viscosity at 100 \u00b0C",
            .example = "8.5"},
    CaseKey{.name = "temperature_C",
            .unit = "\u00b0C",
            .allowed = oil_temperatures,
            .need = Need::sometimes,
            .condition = "the oil is stated by its grade",
            .meaning = "temperature of the oil where it enters the contact",
            .example = "60.0",
            .in_new = true},
    CaseKey{.name = "density_15C_kg_per_m3",
            .unit = "kg/m3",
            .allowed = oil_densities,
            .need = Need::never,
            .standard = 870,
            .meaning = "density of the oil at 15 \u00b0C",
            .example = "870.0"},
};

constexpr std::array domain_keys{
    CaseKey{.name = "inlet",
            .unit = "b",
            .allowed = inlets,
            .meaning = "where the domain begins: fully flooded, or cut at X = x/b; b is the Hertz half width",
            .example = "\"flooded\""},
};

constexpr std::array datum_keys{
    CaseKey{.name = "law",
            .allowed = allowed::Word{datum_names},
            .meaning = "where the approach of a contact with film counts from",
            .example = "\"palmgren\""},
    CaseKey{.name = "load_N",
            .unit = "N",
            .allowed = forces,
            .need = Need::never,
            .otherwise = "the largest roller load of the dry balance",
            .meaning = "with law = \"palmgren\": the force at which the approach meets the hertz law",
            .example = "1000.0"},
    CaseKey{.name = "x0_m",
            .unit = "m",
            .allowed = lengths,
            .need = Need::sometimes,
            .condition = "law = \"x0\"",
            .meaning = "the length x_0 itself",
            .example = "0.01"},
};

constexpr std::array fit_keys{
    CaseKey{.name = "load_N",
            .unit = "N",
            .allowed = allowed::Pair{forces},
            .need = Need::never,
            .otherwise = "0.2 to 1.2 times the largest dry roller load, or higher, so that no M is below 0.01",
            .meaning = "contact forces over which ehd-linear fits its line",
            .example = "[300.0, 2000.0]"},
    CaseKey{.name = "points",
            .allowed = fit_points,
            .need = Need::never,
            .standard = FitRange{}.points,
            .meaning = "number of solved contacts in the fit",
            .example = "6"},
};

constexpr std::array expect_keys{
    CaseKey{.name = "quantity",
            .allowed = allowed::Text{"a quantity of a contact or a bearing"},
            .meaning = "what the number is of",
            .example = "\"film.minimum\""},
    CaseKey{.name = "law",
            .allowed = allowed::Word{law_names},
            .need = Need::sometimes,
            .condition = "the case is a bearing",
            .meaning = "the contact force law",
            .example = "\"hertz\""},
    CaseKey{
        .name = "value",
        .allowed = allowed::Text{"a text like \"0.07414\", whose digits count, or status = \"waiting\" in its place"},
        .need = Need::sometimes,
        .condition = "status is not stated",
        .meaning = "the number as it is printed",
        .example = "\"0.0741\""},
    CaseKey{.name = "scaling",
            .allowed = allowed::Word{scaling_names},
            .need = Need::sometimes,
            .condition = "value is stated",
            .meaning = "the units of value",
            .example = "\"hertz\""},
    CaseKey{.name = "uncertainty",
            .allowed = relative_uncertainties,
            .need = Need::never,
            .otherwise = "half a unit of the last digit of value",
            .meaning = "of value, relative",
            .example = "1e-3"},
    CaseKey{.name = "kind",
            .allowed = allowed::Word{kind_names},
            .need = Need::sometimes,
            .condition = "value is stated",
            .meaning = "how the number was found",
            .example = "\"published\""},
    CaseKey{.name = "status",
            .allowed = allowed::Word{status_names},
            .need = Need::never,
            .otherwise = "value is stated",
            .meaning = "waiting: the source of the number could not be obtained",
            .example = "\"waiting\""},
};

constexpr std::array rows_of_tables{
    CaseTable{.name = "",
              .role = TableRole::heading,
              .in_contact = true,
              .in_bearing = true,
              .meaning = "what the case is called and where it is from",
              .keys = heading_keys},
    CaseTable{.name = "moes",
              .role = TableRole::statement,
              .in_contact = true,
              .meaning = "a contact by its Moes groups",
              .keys = moes_keys},
    CaseTable{.name = "conditions",
              .role = TableRole::statement,
              .in_contact = true,
              .meaning = "a contact in SI; dry without [lubricant] and [domain]",
              .keys = conditions_keys},
    CaseTable{.name = "hertz",
              .role = TableRole::statement,
              .in_contact = true,
              .meaning = "a contact by its groups in Hertz scaling",
              .keys = hertz_keys},
    CaseTable{.name = "bearing",
              .role = TableRole::statement,
              .in_bearing = true,
              .meaning = "a cylindrical roller bearing",
              .keys = bearing_keys},
    CaseTable{.name = "operation",
              .in_bearing = true,
              .required = true,
              .meaning = "speeds and load",
              .keys = operation_keys},
    CaseTable{.name = "material",
              .in_bearing = true,
              .required = true,
              .meaning = "of rollers and rings",
              .keys = material_keys},
    CaseTable{.name = "lubricant",
              .in_contact = true,
              .in_bearing = true,
              .meaning = "the oil; without it a case is dry",
              .keys = lubricant_keys},
    CaseTable{.name = "domain", .in_contact = true, .meaning = "the domain of a contact", .keys = domain_keys},
    CaseTable{.name = "datum", .in_bearing = true, .meaning = "the datum of the approach", .keys = datum_keys},
    CaseTable{.name = "fit", .in_bearing = true, .meaning = "the line of ehd-linear", .keys = fit_keys},
    CaseTable{.name = "expect",
              .role = TableRole::expectation,
              .in_contact = true,
              .in_bearing = true,
              .meaning = "a number that a source gives for this case",
              .keys = expect_keys},
};

}  // namespace

std::span<const CaseTable> case_tables() { return rows_of_tables; }

}  // namespace ehd
