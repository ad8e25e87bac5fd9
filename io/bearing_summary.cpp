// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"

namespace ehd {

namespace {

constexpr double um_per_m = 1e6, MPa_per_Pa = 1e-6, N_per_um = 1e-6;

const RollerRow& most_loaded(const BearingResult& result) {
  return *std::max_element(
      result.rollers.begin(), result.rollers.end(),
      [](const RollerRow& one, const RollerRow& other) { return one.inner.force_N < other.inner.force_N; });
}

/// The smallest value of a member over both contacts of the loaded rollers.
std::optional<double> smallest_of(const BearingResult& result, std::optional<double> ContactRow::*member) {
  const double largest = most_loaded(result).inner.force_N;
  std::optional<double> smallest;
  for (const RollerRow& roller : result.rollers) {
    if (!bearing::is_loaded(roller.inner.force_N, largest)) continue;
    for (const ContactRow* at : {&roller.inner, &roller.outer})
      if (at->*member) smallest = std::min(smallest.value_or(*(at->*member)), *(at->*member));
  }
  return smallest;
}

/// The numbers of one law. Without errors, six digits stand for a dry law that is solved to rounding.
struct Column {
  const BearingCase& body;
  const BearingResult& result;
  const BearingErrors* errors;
  std::optional<double> full_torque_N_m;  ///< by the law ehd, where it is beside

  [[nodiscard]] std::string displacement() const {
    const double um = um_per_m * result.displacement_m;
    return errors ? with_absolute_error(um, um_per_m * errors->displacement_m) : plain(um);
  }
  [[nodiscard]] std::string largest_load() const {
    const double force_N = most_loaded(result).inner.force_N;
    return errors ? with_absolute_error(force_N, errors->largest_force_N) : plain(force_N);
  }
  /// p_H grows with the root of the force.
  [[nodiscard]] std::string largest_pressure() const {
    const RollerRow& roller = most_loaded(result);
    if (!roller.inner.hertz_pressure_Pa) return "-";
    const double MPa =
        MPa_per_Pa * std::max(*roller.inner.hertz_pressure_Pa, roller.outer.hertz_pressure_Pa.value_or(0));
    return errors ? with_error(MPa, errors->largest_force_N / roller.inner.force_N / 2) : plain(MPa, 5);
  }
  [[nodiscard]] std::string load_zone() const {
    const auto zone = geometric_load_zone_deg(result, body.geometry.clearance_m);
    return zone ? fmt::format("{:.1f} to {:.1f}", zone->first, zone->second) : "-";
  }
  [[nodiscard]] std::string loaded() const {
    return fmt::format("{} of {}", loaded_rollers(result.rollers), result.rollers.size());
  }
  [[nodiscard]] std::string smallest_film() const {
    const auto film_m = smallest_of(result, &ContactRow::film_minimum_m);
    if (!film_m) return "-";
    const double um = um_per_m * *film_m;
    return errors && errors->smallest_film ? with_error(um, errors->smallest_film) : plain(um, 3);
  }
  [[nodiscard]] std::string lambda_ratio() const {
    const auto ratio = smallest_of(result, &ContactRow::lambda_ratio);
    return ratio ? plain(*ratio, 3) : "-";
  }
  /// A fitted law lets go of rollers that ehd loads: its error is the distance from ehd.
  [[nodiscard]] std::string torque() const {
    if (!result.torque) return "-";
    const double torque_N_m = result.torque->torque_N_m;
    if (!result.fit) return with_error(torque_N_m, result.torque->error);
    return full_torque_N_m ? with_absolute_error(torque_N_m, std::abs(torque_N_m - *full_torque_N_m))
                           : plain(torque_N_m, 3);
  }
  [[nodiscard]] std::string stiffness() const { return plain(N_per_um * result.stiffness_N_per_m[0][0], 4); }
};

}  // namespace

std::string summary_table(const BearingCase& body, const std::vector<BearingResult>& results,
                          const ErrorsOfLaws& errors) {
  std::vector<std::vector<std::string>> rows{{""},
                                             {"displacement [um]"},
                                             {"largest roller load [N]"},
                                             {"its maximum pressure, Hertz [MPa]"},
                                             {"load zone [deg]"},
                                             {"rollers loaded"},
                                             {"smallest film [um]"},
                                             {"lambda ratio"},
                                             {"stiffness along the load [N/um]"},
                                             {"rolling torque [N m]"}};
  std::optional<double> full_torque_N_m;
  for (const BearingResult& result : results)
    if (result.law == bearing::Law::ehd && result.torque) full_torque_N_m = result.torque->torque_N_m;
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const auto known = errors.find(result.law);
    const Column column{.body = body,
                        .result = result,
                        .errors = known == errors.end() ? nullptr : &known->second,
                        .full_torque_N_m = full_torque_N_m};
    const std::vector<std::string> cells{std::string(to_string(result.law)),
                                         column.displacement(),
                                         column.largest_load(),
                                         column.largest_pressure(),
                                         column.load_zone(),
                                         column.loaded(),
                                         column.smallest_film(),
                                         column.lambda_ratio(),
                                         column.stiffness(),
                                         column.torque()};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(cells[i]);
  }
  if (rows.front().size() == 1) return "";
  // A row that no law has a number for is left out.
  std::erase_if(rows, [](const auto& row) {
    return std::all_of(row.begin() + 1, row.end(), [](const std::string& cell) { return cell == "-"; });
  });
  return aligned(rows, 1, "  ") + "\n";
}

}  // namespace ehd
