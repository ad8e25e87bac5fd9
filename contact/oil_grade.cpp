// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/oil_grade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/text.hpp"

namespace ehd {

namespace {

constexpr std::array<double, 20> grades{2,   3,   5,   7,   10,  15,  22,   32,   46,   68,
                                        100, 150, 220, 320, 460, 680, 1000, 1500, 2200, 3200};
/// Midpoints of the first four grades [mm2/s]; the midpoint of every other grade is its number.
constexpr std::array<double, 4> first_midpoints{2.2, 3.2, 4.6, 6.8};

/// L = a Y^2 + b Y + c of an oil with index 0, and H = d Y^2 + e Y + f of one with index 100: their viscosities at 40
/// C, where both have Y at 100 C [mm2/s]. A row holds from `from` to the next one.
struct IndexRow {
  double from, a, b, c, d, e, f;
};
constexpr std::array<IndexRow, 16> index_rows{{
    {2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077},
    {3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183},
    {4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119},
    {5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557},
    {6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656},
    {7.0, 0.01191, 21.475, -72.87, 0.79762, -0.7321, 14.61},
    {7.7, 0.41858, 16.1558, -56.04, 0.05794, 10.5156, -28.24},
    {9.0, 0.88779, 7.5527, -16.6, 0.26665, 6.7015, -10.81},
    {12.0, 0.7672, 10.7972, -38.18, 0.20073, 8.4658, -22.49},
    {15.0, 0.97305, 5.3135, -2.2, 0.28889, 5.9741, -4.93},
    {18.0, 0.97256, 5.25, -0.98, 0.24504, 7.416, -16.73},
    {22.0, 0.91413, 7.4759, -21.82, 0.20323, 9.1267, -34.23},
    {28.0, 0.87031, 9.7157, -50.77, 0.18411, 10.1015, -46.75},
    {40.0, 0.84703, 12.6752, -133.31, 0.17029, 11.4866, -80.62},
    {55.0, 0.85921, 11.1009, -83.19, 0.1713, 11.368, -76.94},
    {70.0, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947},
}};
static_assert(index_rows.front().from == least_with_index);

const IndexRow& index_row_at(double Y) {
  const auto next =
      std::find_if(index_rows.begin(), index_rows.end(), [&](const IndexRow& row) { return row.from > Y; });
  return *(next - 1);
}

/// D341's range [mm2/s].
constexpr double least_viscosity = 0.21, largest_viscosity = 2e7;
constexpr double kelvin = 273.15;

/// Z of D341: the viscosity plus a term that matters below 2 mm2/s only.
double walther_Z(double viscosity) {
  return viscosity + 0.7 + std::exp(-1.47 - 1.84 * viscosity - 0.51 * viscosity * viscosity);
}

/// log log Z, over which D341's lines are straight.
double walther_ordinate(double viscosity) { return std::log10(std::log10(walther_Z(viscosity))); }

/// The x in [low, high] where an increasing function reaches `value`, to the last digit.
template <class Function>
double where_reached(const Function& function, double value, double low, double high) {
  for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
    (function(middle) < value ? low : high) = middle;
  return high;
}

}  // namespace

std::span<const double> iso_viscosity_grades() { return grades; }

std::optional<double> midpoint_of_grade_mm2_per_s(double grade) {
  const auto* const at = std::find(grades.begin(), grades.end(), grade);
  if (at == grades.end()) return std::nullopt;
  const auto place = static_cast<std::size_t>(at - grades.begin());
  return place < first_midpoints.size() ? first_midpoints[place] : grade;
}

std::optional<double> viscosity_index(double viscosity_40C_mm2_per_s, double viscosity_100C_mm2_per_s) {
  const double U = viscosity_40C_mm2_per_s, Y = viscosity_100C_mm2_per_s;
  if (!(Y >= least_with_index)) return std::nullopt;
  const IndexRow& row = index_row_at(Y);
  const double L = row.a * Y * Y + row.b * Y + row.c, H = row.d * Y * Y + row.e * Y + row.f;
  if (U >= H) return 100 * (L - U) / (L - H);
  const double N = std::log10(H / U) / std::log10(Y);
  return 100 + (std::pow(10, N) - 1) / 0.00715;
}

std::optional<double> viscosity_100C_mm2_per_s(double viscosity_40C_mm2_per_s, double index) {
  const double U = viscosity_40C_mm2_per_s;
  const auto index_at = [&](double Y) { return *viscosity_index(U, Y); };
  if (!(U > least_with_index) || index_at(least_with_index) > index || index_at(U) < index) return std::nullopt;
  return where_reached(index_at, index, least_with_index, U);
}

std::optional<double> viscosity_at_mm2_per_s(double viscosity_40C_mm2_per_s, double viscosity_100C_mm2_per_s,
                                             double temperature_C) {
  const auto log_temperature = [](double celsius) { return std::log10(celsius + kelvin); };
  const double at_40C = walther_ordinate(viscosity_40C_mm2_per_s), at_100C = walther_ordinate(viscosity_100C_mm2_per_s);
  const double share =
      (log_temperature(temperature_C) - log_temperature(40)) / (log_temperature(100) - log_temperature(40));
  const double ordinate = at_40C + share * (at_100C - at_40C);
  if (!(ordinate >= walther_ordinate(least_viscosity) && ordinate <= walther_ordinate(largest_viscosity)))
    return std::nullopt;
  return where_reached(walther_ordinate, ordinate, least_viscosity, largest_viscosity);
}

double oil_density_kg_per_m3(double density_15C_kg_per_m3, double temperature_C) {
  constexpr double K_1 = 0.6278;  // kg/m3 per kelvin
  const double expansion = K_1 / density_15C_kg_per_m3 * (temperature_C - 15);
  return density_15C_kg_per_m3 * std::exp(-expansion * (1 + 0.8 * expansion));
}

std::optional<double> wooster_alpha_per_Pa(double viscosity_Pa_s) {
  const double alpha = (0.6 + 0.965 * std::log10(1e3 * viscosity_Pa_s)) * 1e-8;
  return alpha > 0 ? std::optional(alpha) : std::nullopt;
}

std::vector<std::string> notes_of(const GradedOil& oil, const std::vector<std::string>& more) {
  const auto shown = [](double value) { return plain(value, 4); };
  std::string stated = "oil";
  if (oil.iso_vg) stated += " ISO VG " + shown(*oil.iso_vg);
  if (oil.viscosity_index)
    stated += std::string(oil.iso_vg ? "," : "") + " viscosity index " + shown(*oil.viscosity_index);
  std::vector<std::string> notes{
      fmt::format("{}: {} mm2/s at 40 \u00b0C, {} at 100 \u00b0C{}; at {} \u00b0C {} mm2/s (ASTM D341) times {} kg/m3 "
                  "(ASTM D1250) is "
                  "eta_0 = {} Pa s",
                  stated, shown(oil.viscosity_40C_mm2_per_s), shown(oil.viscosity_100C_mm2_per_s),
                  oil.iso_vg ? " (ASTM D2270)" : "", shown(oil.temperature_C), shown(oil.viscosity_mm2_per_s),
                  shown(oil.density_kg_per_m3), shown(oil.viscosity_Pa_s))};
  if (oil.estimated_alpha_per_Pa)
    notes.push_back("alpha = " + shown(*oil.estimated_alpha_per_Pa) +
                    " 1/Pa is estimated from eta_0 for a mineral oil (Wooster 1937), perhaps 20 % off, which moves a "
                    "film by some 10 %; state alpha_per_Pa where it is known");
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

}  // namespace ehd
