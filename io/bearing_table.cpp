// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bearing/geometry.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"
#include "workflow/bearing_of_case.hpp"

namespace ehd {

using bearing::LinearFit;

namespace {

/// The rollers that a table shows: one of each mirrored pair, with the text of its azimuth.
std::vector<std::pair<std::size_t, std::string>> shown_rollers(const std::vector<RollerRow>& rollers) {
  std::vector<double> azimuths;
  for (const RollerRow& roller : rollers) azimuths.push_back(roller.azimuth_deg);
  std::vector<std::pair<std::size_t, std::string>> shown;
  for (const bearing::RollerGroup& group : bearing::mirror_groups(azimuths)) {
    const auto first = static_cast<std::size_t>(group.members.front());
    shown.emplace_back(first, (group.members.size() > 1 ? "+-" : "") +
                                  plain(group.members.size() > 1 ? std::abs(azimuths[first]) : azimuths[first], 5));
  }
  std::sort(shown.begin(), shown.end(), [&](const auto& one, const auto& other) {
    return std::abs(azimuths[one.first]) < std::abs(azimuths[other.first]);
  });
  return shown;
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// What the ring does, a line a law; and over the cage's positions, where they were asked for.
std::string human_ring(const std::vector<BearingResult>& results) {
  std::vector<std::vector<std::string>> ring{
      {"ring", "lateral um", "load zone deg", "to", "stiffness N/um: xx", "yy", "xy"}};
  std::vector<std::vector<std::string>> turn{{"cage turning", "positions", "displacement um: mean", "peak to peak",
                                              "lateral um: mean", "peak to peak", "largest Q_i N"}};
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const std::string law(to_string(result.law));
    const auto& K = result.stiffness_N_per_m;
    const auto& zone = result.load_zone_deg;
    ring.push_back({law, fixed(1e6 * result.displacement_lateral_m, 4), zone ? plain(zone->first, 5) : "-",
                    zone ? plain(zone->second, 5) : "-", plain(1e-6 * K[0][0], 5), plain(1e-6 * K[1][1], 5),
                    std::abs(K[0][1]) <= 1e-12 * K[0][0] ? "0" : plain(1e-6 * K[0][1], 5)});
    if (!result.cage) continue;
    const auto& along = result.cage->displacement_m;
    const auto& across = result.cage->displacement_lateral_m;
    turn.push_back({law, std::to_string(result.cage->positions), fixed(1e6 * along.mean, 4),
                    plain(1e6 * along.peak_to_peak, 3), fixed(1e6 * across.mean, 4),
                    plain(1e6 * across.peak_to_peak, 3), fixed(result.cage->largest_force_N, 1)});
  }
  std::string text;
  if (ring.size() > 1) text += "\n" + aligned(ring, 1, "  ");
  if (turn.size() > 1) text += "\n" + aligned(turn, 1, "  ");
  return text;
}

}  // namespace

std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  std::string text = bearing_case.id + ": " + bearing_case.title + "\n";
  text += "  radial load " + plain(body.operation.radial_load_N) + " N, clearance " +
          micrometre(body.geometry.clearance_m) + ", sum speed " +
          plain(bearing::sum_speed_m_per_s(geometry_of(body), speeds_of(body)), 4) + " m/s, centrifugal force " +
          plain(bearing::centrifugal_force_N(geometry_of(body), speeds_of(body)), 4) + " N a roller\n\n";

  // Rollers: psi, then Q_i, delta_i and film of every law.
  std::vector<std::string> head{"psi"}, units{"deg"};
  std::vector<const BearingResult*> with_rows;
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    with_rows.push_back(&result);
    head.insert(head.end(), {std::string(to_string(result.law)) + ": Q_i", "delta_i"});
    units.insert(units.end(), {"N", "um"});
    if (needs_film(result.law)) {
      head.emplace_back("h_i");
      units.emplace_back("um");
    }
  }
  if (!with_rows.empty()) {
    std::vector<std::vector<std::string>> rows{head, units};
    for (const auto& [j, azimuth] : shown_rollers(with_rows.front()->rollers)) {
      std::vector<std::string> row{azimuth};
      for (const BearingResult* result : with_rows) {
        const ContactRow& inner = result->rollers[j].inner;
        row.push_back(fixed(inner.force_N, 1));
        row.push_back(fixed(1e6 * inner.displacement_m, 3));
        if (needs_film(result->law)) row.push_back(inner.film_minimum_m ? fixed(1e6 * *inner.film_minimum_m, 3) : "-");
      }
      rows.push_back(row);
    }
    text += aligned(rows, 1, "  ") + "\n";
  }

  std::vector<std::vector<std::string>> summary{
      {"law", "displacement um", "balance error", "contacts solved", "from memory", "time s"}};
  for (const BearingResult& result : results) {
    const bool fine = !result.rollers.empty();
    summary.push_back({std::string(to_string(result.law)), fine ? fixed(1e6 * result.displacement_m, 4) : "-",
                       fine ? plain(result.balance_error, 2) : "-", std::to_string(result.contact_solves),
                       std::to_string(result.contact_recalls), plain(result.wall_s, 2)});
  }
  text += aligned(summary, 1, "  ");

  text += human_ring(results);

  for (const BearingResult& result : results) {
    if (!result.fit) continue;
    std::vector<std::vector<std::string>> fits{
        {"fit", "K N/m", "dF N", "residual N", "standard deviation N", "of K N/m", "of dF N", "N from", "to"}};
    const auto add = [&fits](const char* name, const LinearFit& fit) {
      fits.push_back({name, plain(fit.K_N_per_m, 5), fixed(fit.dF_N, 1), fixed(fit.residual_N, 1),
                      fixed(fit.standard_deviation_N, 1), plain(fit.K_deviation_N_per_m, 2),
                      fixed(fit.dF_deviation_N, 1), plain(fit.points.front().force_N, 5),
                      plain(fit.points.back().force_N, 5)});
    };
    add("inner", result.fit->inner);
    add("outer", result.fit->outer);
    text += "\n" + aligned(fits, 1, "  ");
  }
  for (const BearingResult& result : results) {
    if (!result.why.empty()) text += "\n  " + std::string(to_string(result.law)) + ": no balance: " + result.why + "\n";
    if (result.notes.empty()) continue;
    text += "\n  notes on " + std::string(to_string(result.law)) + "\n";
    for (const std::string& note : result.notes) text += "    - " + note + "\n";
  }
  return text;
}

}  // namespace ehd
