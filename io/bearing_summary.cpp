// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/geometry.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"

namespace ehd {

namespace {

constexpr double um_per_m = 1e6, MPa_per_Pa = 1e-6, N_per_um = 1e-6;
constexpr double rounding_deg = 1e-6;  // a load zone that lies less askew is symmetric

/// The numbers of one law. A dry law is solved to rounding: six digits. A law with films has three where no error is
/// known.
struct Column {
  const BearingCase& body;
  const BearingResult& result;
  const BearingResult* full;  ///< the result of the law ehd; null where the table has none

  [[nodiscard]] std::string without_error(double value, int digits_of_dry = 6) const {
    return plain(value, needs_film(result.law) ? unstated_digits : digits_of_dry);
  }
  [[nodiscard]] std::string displacement() const {
    const double um = um_per_m * result.displacement_m;
    return result.errors ? with_absolute_error(um, um_per_m * result.errors->displacement_m) : without_error(um);
  }
  [[nodiscard]] std::string largest_load() const {
    const double force_N = largest_force_N(result);
    return result.errors ? with_absolute_error(force_N, result.errors->largest_force_N) : without_error(force_N);
  }
  /// p_H grows with the root of the force: an error e of the force may lower p_H by 1 - sqrt(1 - e).
  [[nodiscard]] std::string largest_pressure() const {
    const auto place = largest_pressure_place(result);
    if (!place) return "-";
    const ContactRow& contact = contact_at(*place);
    const double MPa = MPa_per_Pa * *contact.hertz_pressure_Pa;
    if (!result.errors) return without_error(MPa, 5);
    const double force_error = result.errors->largest_force_N / contact.force_N;
    return force_error < 1 ? with_error(MPa, 1 - std::sqrt(1 - force_error)) : "-";
  }
  [[nodiscard]] const ContactRow& contact_at(const ContactPlace& place) const {
    return result.rollers[place.roller].at(place.raceway);
  }
  [[nodiscard]] std::string text_of(const std::optional<ContactPlace>& place) const {
    if (!place) return "-";
    std::vector<double> azimuths;
    for (const RollerRow& one : result.rollers) azimuths.push_back(one.azimuth_deg);
    for (const bearing::RollerGroup& group : bearing::mirror_groups(azimuths))
      for (const int member : group.members)
        if (static_cast<std::size_t>(member) == place->roller)
          return fmt::format("{}, {}", azimuth_text(group, azimuths[place->roller]), to_string(place->raceway));
    return "-";
  }
  [[nodiscard]] std::string load_zone() const {
    const double clearance_m = body.geometry.clearance_m;
    const auto zone = geometric_load_zone_deg(result, clearance_m);
    if (!zone) return "-";
    const auto error_deg = load_zone_error_deg(result, clearance_m);
    const auto text = [&](double end) {
      return error_deg ? with_absolute_error(end, *error_deg) : fmt::format("{:.1f}", end);
    };
    if (std::abs(zone->first + zone->second) > rounding_deg)
      return fmt::format("{} to {}", text(zone->first), text(zone->second));
    return "+-" + text(zone->second);
  }
  [[nodiscard]] std::string loaded() const {
    return fmt::format("{} of {}", loaded_rollers(result.rollers), result.rollers.size());
  }
  [[nodiscard]] std::string smallest_film() const {
    const auto place = smallest_film_place(result);
    return place ? with_film_error(um_per_m * *contact_at(*place).film_minimum_m) : "-";
  }
  /// There is one roughness: the smallest ratio is that of the smallest film. It counts as exact.
  [[nodiscard]] std::string lambda_ratio() const {
    const auto place = smallest_film_place(result);
    const auto ratio = place ? contact_at(*place).lambda_ratio : std::nullopt;
    return ratio ? with_film_error(*ratio) : "-";
  }
  [[nodiscard]] std::string with_film_error(double value) const {
    return result.errors && result.errors->smallest_film ? with_error(value, result.errors->smallest_film)
                                                         : plain(value, 3);
  }
  [[nodiscard]] static std::string stated(double value, const std::optional<double>& error) {
    return error && std::isfinite(*error) ? with_error(value, error) : plain(value, unstated_digits);
  }
  [[nodiscard]] std::string torque() const {
    if (!result.torque) return "-";
    const auto error = torque_error(result, full);
    return stated(result.torque->torque_N_m, error);
  }
  [[nodiscard]] std::string stiffness() const {
    const double along = N_per_um * result.stiffness_N_per_m[0][0];
    if (!needs_film(result.law)) return plain(along, 4);
    if (!knows_stiffness(result, full)) return "-";
    const auto error = stiffness_error(result, full);
    return stated(along, error);
  }
};

}  // namespace

std::string azimuth_text(const bearing::RollerGroup& group, double azimuth_deg) {
  return group.members.size() > 1 ? "+-" + plain(std::abs(azimuth_deg), 5) : plain(azimuth_deg, 5);
}

std::string summary_table(const BearingCase& body, const std::vector<BearingResult>& results) {
  std::vector<std::vector<std::string>> rows{{""},
                                             {"displacement [um]"},
                                             {"largest roller load [N]"},
                                             {"its maximum pressure, Hertz [MPa]"},
                                             {"  at psi [deg], raceway"},
                                             {"load zone [deg]"},
                                             {"rollers loaded, above 1 %"},
                                             {"smallest film [um]"},
                                             {"lambda ratio"},
                                             {"  at psi [deg], raceway"},
                                             {"stiffness along the load [N/um]"},
                                             {"rolling torque [N m]"}};
  const BearingResult* full = full_relation_in(results);
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const Column column{.body = body, .result = result, .full = full};
    const std::vector<std::string> cells{std::string(to_string(result.law)),
                                         column.displacement(),
                                         column.largest_load(),
                                         column.largest_pressure(),
                                         column.text_of(largest_pressure_place(result)),
                                         column.load_zone(),
                                         column.loaded(),
                                         column.smallest_film(),
                                         column.lambda_ratio(),
                                         column.text_of(smallest_film_place(result)),
                                         column.stiffness(),
                                         column.torque()};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(cells[i]);
  }
  if (rows.front().size() == 1) return "";
  // A row that no law has a number for is left out.
  std::erase_if(rows, [](const auto& row) {
    return std::all_of(row.begin() + 1, row.end(), [](const std::string& cell) { return cell == "-"; });
  });
  return aligned_in_parts(rows, 1, "  ") + "\n";
}

}  // namespace ehd
