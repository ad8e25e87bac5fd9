// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

#include "bearing/equilibrium.hpp"
#include "bearing/geometry.hpp"
#include "contact/text.hpp"
#include "io/bearing_notes.hpp"
#include "io/tables.hpp"
#include "workflow/bearing_of_case.hpp"

namespace ehd {

using bearing::LinearFit;

namespace {

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

/// An entry of a matrix below this part of its trace is rounding.
constexpr double negligible_entry = 1e-12;
/// A mean displacement across the load below this part of that along it is rounding.
constexpr double negligible_displacement = 1e-9;

/// The rollers that a table shows: one of each mirrored pair, with the text of its azimuth.
std::vector<std::pair<std::size_t, std::string>> shown_rollers(const std::vector<RollerRow>& rollers) {
  std::vector<double> azimuths;
  for (const RollerRow& roller : rollers) azimuths.push_back(roller.azimuth_deg);
  std::vector<std::pair<std::size_t, std::string>> shown;
  for (const bearing::RollerGroup& group : bearing::mirror_groups(azimuths)) {
    const auto first = static_cast<std::size_t>(group.members.front());
    shown.emplace_back(first, azimuth_text(group, azimuths[first]));
  }
  std::sort(shown.begin(), shown.end(), [&](const auto& one, const auto& other) {
    return std::abs(azimuths[one.first]) < std::abs(azimuths[other.first]);
  });
  return shown;
}

/// Decimals for at least three digits, and at least so many.
int three_digits(double value, int decimals) {
  const int of_three = value > 0 ? 2 - static_cast<int>(std::floor(std::log10(value))) : 0;
  return std::max(decimals, of_three);
}

/// So many decimals, but no digit behind the first one of the absolute error: 8800 of 8756 with an error of 420.
std::string cut_at_error(double value, double error, int decimals) {
  const int place = error > 0 ? -static_cast<int>(std::floor(std::log10(error))) : decimals;
  if (place >= 0) return fixed(value, std::min(decimals, place));
  const double unit = std::pow(10, -place);
  return fixed(unit * std::round(value / unit), 0);
}

std::string name_of(const BearingResult& result) { return std::string(to_string(result.law)); }

/// The table after an empty line; nothing where it has no row below its head.
std::string below_line(const Rows& rows) { return rows.size() > 1 ? "\n" + aligned_in_parts(rows, 1, "  ") : ""; }

std::string heading(const Case& bearing_case) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const bearing::Geometry& geometry = body.geometry;
  const bearing::Speeds speeds = speeds_of(body);
  return fmt::format("{}: {}\n  radial load {} N, clearance {}, sum speed {} m/s, centrifugal force {} N a roller\n\n",
                     bearing_case.id, bearing_case.title, plain(body.operation.radial_load_N),
                     micrometre(body.geometry.clearance_m), plain(bearing::sum_speed_m_per_s(geometry, speeds), 4),
                     plain(bearing::centrifugal_force_N(geometry, speeds), 4));
}

/// A column of the rollers' table: its head, its unit, and the cell of a roller at the inner contact.
struct RollerColumn {
  const char *head, *unit;
  std::function<std::string(const ContactRow& inner)> cell;
};

/// Whether a law with films has no error budget: then no more than three digits are shown.
bool unstated(const BearingResult& result) { return needs_film(result.law) && !result.errors; }

/// A force of a roller, in the digits that its error leaves.
std::string force_text(const BearingResult& result, double force_N) {
  constexpr double three_digits_from_N = 100;
  const bool whole = unstated(result) && largest_force_N(result) >= three_digits_from_N;
  const std::optional<BearingErrors>& known = result.errors;
  return cut_at_error(force_N, known ? known->any_force_N : 0, whole ? 0 : 1);
}

/// The columns of one law. Where a roller carries next to nothing, its pressure is rounding and its film is the gap
/// that the ring leaves. p_H grows with the root of the force; a film varies at most as its reciprocal, which a rigid
/// contact's does.
std::vector<RollerColumn> columns_of(const BearingResult& result) {
  const double largest = largest_force_N(result);
  const bool three = unstated(result);
  const std::optional<BearingErrors>& known = result.errors;
  const double error_N = known ? known->any_force_N : 0, film_error = known ? known->smallest_film.value_or(0) : 0;
  const auto if_loaded = [largest, three](const ContactRow& inner, const std::optional<double>& value, double unit,
                                          int least_decimals, double error) -> std::string {
    if (!value || !bearing::is_loaded(inner.force_N, largest) || !(error < 1)) return "-";
    const double shown = unit * *value;
    return cut_at_error(shown, error * shown, three_digits(shown, three ? 0 : least_decimals));
  };
  const auto of_force = [error_N](const ContactRow& inner) { return error_N / inner.force_N; };
  const auto of_film = [=](const ContactRow& inner) { return film_error + of_force(inner); };
  std::vector<RollerColumn> columns{
      {"f_i", "N", [&result](const ContactRow& inner) { return force_text(result, inner.force_N); }},
      {"p_H", "MPa", [=](const ContactRow& inner) {
         const double of_root = 1 - std::sqrt(1 - std::min(of_force(inner), 1.0));
         return if_loaded(inner, inner.hertz_pressure_Pa, 1e-6, 0, of_root);
       }}};
  if (!needs_film(result.law)) return columns;
  columns.push_back({"h_i", "um", [=](const ContactRow& inner) {
                       return if_loaded(inner, inner.film_minimum_m, 1e6, 3, of_film(inner));
                     }});
  const bool rough = std::any_of(result.rollers.begin(), result.rollers.end(),
                                 [](const RollerRow& roller) { return roller.inner.lambda_ratio.has_value(); });
  if (rough)
    columns.push_back({"lambda", "", [=](const ContactRow& inner) {
                         return if_loaded(inner, inner.lambda_ratio, 1, 2, of_film(inner));
                       }});
  return columns;
}

/// The inner contact of each roller, for every law that has a balance.
std::string rollers_table(const std::vector<BearingResult>& results,
                          const std::function<std::vector<RollerColumn>(const BearingResult&)>& columns) {
  const std::string indent = "  ";
  std::string text;
  Rows azimuths, rows;
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const auto shown = shown_rollers(result.rollers);
    if (azimuths.empty()) {
      azimuths = {{"psi"}, {"deg"}};
      for (const auto& [j, azimuth] : shown) azimuths.push_back({azimuth});
      rows = azimuths;
    }
    const auto add_to = [&](Rows table) {
      std::string law = name_of(result) + ": ";
      for (const RollerColumn& column : columns(result)) {
        table[0].push_back(std::exchange(law, "") + column.head);
        table[1].emplace_back(column.unit);
        std::size_t row = 2;
        for (const auto& [j, azimuth] : shown) table[row++].push_back(column.cell(result.rollers[j].inner));
      }
      return table;
    };
    Rows wider = add_to(rows);
    // The columns of a law stay together.
    if (rows != azimuths && table_width(wider, indent) > widest_table) {
      text += aligned(rows, 1, indent) + "\n";
      wider = add_to(azimuths);
    }
    rows = std::move(wider);
  }
  return azimuths.empty() ? "" : text + aligned(rows, 1, indent);
}

/// One error for the forces of all rollers, of every law that states one.
std::string error_of_forces(const std::vector<BearingResult>& results) {
  std::string text;
  for (const BearingResult& result : results) {
    const std::optional<BearingErrors>& known = result.errors;
    if (result.rollers.empty() || !known || !std::isfinite(known->any_force_N)) continue;
    text += fmt::format("{}{} N ({})", text.empty() ? "\n  every f_i is known to " : ", ",
                        plain(number_in(rounded_up(known->any_force_N, 2))), name_of(result));  // 420, not 4.2e2
  }
  return text.empty() ? text : text + "\n";
}

/// The displacement of a contact or of the ring across the load, in the digits that the error of the displacement
/// leaves.
std::string displacement_text(const BearingResult& result, double um, double error_um, int decimals) {
  if (std::isnan(error_um)) return plain(um, unstated_digits);
  return needs_film(result.law) ? cut_at_error(um, error_um, decimals) : fixed(um, decimals);
}

/// The absolute error of a displacement; NaN where a law with films has none.
double error_of_displacement_um(const BearingResult& result) {
  const std::optional<BearingErrors>& known = result.errors;
  return known ? 1e6 * known->displacement_m : needs_film(result.law) ? std::nan("") : 0;
}

/// The approach of each roller to the inner raceway. A fitted law is also as wrong as it is far from ehd.
std::vector<RollerColumn> approach_column(const BearingResult& result, const BearingResult* full) {
  const double own_um = error_of_displacement_um(result);
  const bool beside = result.fit && full && full->rollers.size() == result.rollers.size();
  return {{"delta_i", "um", [&result, own_um, full = beside ? full : nullptr](const ContactRow& inner) {
             double error_um = own_um;
             for (std::size_t j = 0; full && j < result.rollers.size(); ++j)
               if (&result.rollers[j].inner == &inner)
                 error_um += 1e6 * std::abs(inner.displacement_m - full->rollers[j].inner.displacement_m);
             return displacement_text(result, 1e6 * inner.displacement_m, error_um, 3);
           }}};
}

/// What each law cost.
std::string cost_table(const std::vector<BearingResult>& results) {
  Rows rows{{"law", "balance error", "contacts solved", "from memory", "time s"}};
  for (const BearingResult& result : results) {
    const bool balanced = !result.rollers.empty();
    rows.push_back({name_of(result), balanced ? plain(result.balance_error, 2) : "-",
                    std::to_string(result.contact_solves), std::to_string(result.contact_recalls),
                    plain(result.wall_s, 2)});
  }
  return below_line(rows);
}

/// Lateral displacement, load zone and stiffness of the ring. The error along the load is that of all entries of the
/// stiffness; a fitted law is also as wrong as it is far from ehd.
std::string ring_table(const std::vector<BearingResult>& results) {
  const BearingResult* full = full_relation_in(results);
  Rows rows{{"ring", "lateral um", "loaded rollers from deg", "to", "stiffness N/um: xx", "yy", "xy"}};
  for (const BearingResult& result : results) {
    if (result.rollers.empty()) continue;
    const auto& K = result.stiffness_N_per_m;
    const auto& zone = result.load_zone_deg;
    const int digits = needs_film(result.law) ? unstated_digits : 5;
    const bool fitted = result.fit && full;
    const BearingResult& source = fitted ? *full : result;
    const double along = source.stiffness_N_per_m[0][0] * stiffness_error(source, full).value_or(std::nan(""));
    const double lateral_m = result.displacement_lateral_m;
    const bool rounding = std::abs(lateral_m) <= negligible_displacement * std::abs(result.displacement_m);
    const double error_um = result.errors            ? 1e6 * result.errors->displacement_lateral_m
                            : needs_film(result.law) ? std::nan("")
                                                     : 0;
    rows.push_back({name_of(result), rounding ? "0" : displacement_text(result, 1e6 * lateral_m, error_um, 4),
                    zone ? plain(zone->first, 5) : "-", zone ? plain(zone->second, 5) : "-"});
    const bool known = knows_stiffness(result, full);
    for (const auto& [r, s] : {std::pair{0U, 0U}, {1U, 1U}, {0U, 1U}}) {
      const double value = K[r][s], error = along + (fitted ? std::abs(value - full->stiffness_N_per_m[r][s]) : 0);
      rows.back().push_back(!known                                          ? "-"
                            : std::abs(value) <= negligible_entry * K[0][0] ? "0"
                            : std::isfinite(error) ? cut_at_error(1e-6 * value, 1e-6 * error, 4)
                                                   : plain(1e-6 * value, digits));
    }
  }
  return below_line(rows);
}

/// A stiffness or damping in the digits that its absolute error leaves; of a number known better than that, five.
std::string known_digits(double value, double absolute_error) {
  constexpr int most_digits = 5;
  constexpr double half_unit = 0.5e-4;  // of the fifth digit of 1.0000
  return absolute_error < half_unit * std::abs(value) ? plain(value, most_digits)
                                                      : with_absolute_error(value, absolute_error);
}

/// The same of an entry of a matrix; 0 where no digit is known.
std::string entry(double value, double absolute_error) {
  return std::abs(value) <= absolute_error ? "0" : known_digits(value, absolute_error);
}

/// The absolute error of an entry: `error` is relative to the trace.
double error_of_entry(const bearing::Matrix2& matrix, double error) {
  const double size = std::max(std::abs(matrix[0][0] + matrix[1][1]), std::abs(matrix[0][0]));
  return size * std::max(error, negligible_entry);
}

/// xx, yy and xy of a matrix of the ring; "-" where not even the first digit of xx or yy is known. A fitted law is also
/// as wrong as it is far from ehd, and as ehd itself may be off. `full` is the motion by ehd; where the table has none,
/// a fitted law has no stated error.
Row entries(const bearing::Matrix2& matrix, double unit, double error, bool fitted, const bearing::RingMotion* full) {
  const double own = error_of_entry(matrix, error) + (full ? error_of_entry(full->stiffness_N_per_m, full->error) : 0);
  Row cells;
  for (const auto& [r, s] : {std::pair{0U, 0U}, {1U, 1U}, {0U, 1U}}) {
    const double value = matrix[r][s], away = full ? std::abs(value - full->stiffness_N_per_m[r][s]) : 0;
    if (fitted && !full && std::abs(value) > own)
      cells.push_back(plain(unit * value, unstated_digits));
    else if (!std::isfinite(own) || (r == s && own + away > std::abs(value) / 2))
      cells.emplace_back("-");
    else
      cells.push_back(entry(unit * value, unit * (own + away)));
  }
  return cells;
}

/// Stiffness and damping of the ring at each frequency.
std::string dynamics_table(const std::vector<BearingResult>& results) {
  const auto ehd = std::find_if(results.begin(), results.end(), [](const BearingResult& result) {
    return result.law == bearing::Law::ehd && !result.dynamics.empty();
  });
  Rows rows{{"in motion", "Hz", "stiffness N/um: xx", "yy", "xy", "damping N s/m: xx", "yy", "xy"}};
  std::string remark;
  for (const BearingResult& result : results) {
    for (std::size_t k = 0; k < result.dynamics.size(); ++k) {
      const DynamicRow& at = result.dynamics[k];
      const bool fitted = result.fit.has_value();
      const auto* full = fitted && ehd != results.end() ? &ehd->dynamics[k].ring : nullptr;
      if (full)
        remark = wrapped(fmt::format("  errors of {} in motion: also by the standard deviation of its K, so that they "
                                     "are larger than that of the stiffness along the load",
                                     name_of(result)),
                         "  ");
      Row row{name_of(result), plain(at.frequency_Hz)};
      const auto add = [&](const Row& cells) { row.insert(row.end(), cells.begin(), cells.end()); };
      add(entries(at.ring.stiffness_N_per_m, 1e-6, at.ring.error, fitted, full));
      if (at.ring.damping_N_s_per_m)
        add(entries(*at.ring.damping_N_s_per_m, 1, *at.ring.damping_error, false, nullptr));
      else
        add({"-", "-", "-"});
      rows.push_back(std::move(row));
    }
  }
  return below_line(rows) + remark;
}

/// Stiffness and damping of the contacts around the bearing, at the first frequency, by laws that know damping.
std::string contacts_in_motion(const BearingResult& result) {
  if (result.dynamics.empty() || !result.dynamics.front().ring.damping_N_s_per_m) return "";
  const DynamicRow& at = result.dynamics.front();
  Rows rows{{"psi deg", "f_i N", "inner: N/um", "N s/m", "outer: N/um", "N s/m"}};
  for (const auto& [j, azimuth] : shown_rollers(result.rollers)) {
    const bearing::RollerMotion& roller = at.rollers[j];
    std::vector<std::string> row{azimuth, force_text(result, result.rollers[j].inner.force_N)};
    for (const bearing::ContactMotion* contact : {&roller.inner, &roller.outer}) {
      const auto add = [&row](bool known, double value, double error) {
        row.push_back(known && std::isfinite(error) ? known_digits(value, error) : "-");
      };
      add(knows_motion(result, nullptr, 0), 1e-6 * contact->stiffness_N_per_m, 1e-6 * contact->stiffness_error);
      add(knows_damping(at), *contact->damping_N_s_per_m, contact->damping_error);
    }
    rows.push_back(std::move(row));
  }
  return fmt::format("\n  contacts in motion, {}, {} Hz\n{}", name_of(result), plain(at.frequency_Hz),
                     aligned(rows, 1, "  "));
}

/// The ring over the positions of the cage, where the request has any. The error of a balance is that of the first
/// position.
std::string cage_table(const std::vector<BearingResult>& results) {
  Rows rows{{"cage turning", "positions", "displacement um: mean", "peak to peak", "lateral um: mean", "peak to peak",
             "largest f_i N"}};
  for (const BearingResult& result : results) {
    if (result.rollers.empty() || !result.cage) continue;
    const auto& along = result.cage->displacement_m;
    const auto& across = result.cage->displacement_lateral_m;
    const std::optional<BearingErrors>& known = result.errors;
    const auto with = [&](double value, double BearingErrors::*error, double unit) {
      return known ? with_absolute_error(unit * value, unit * ((*known).*error))
                   : plain(unit * value, needs_film(result.law) ? unstated_digits : 6);
    };
    // Between two positions: twice the error of one.
    const auto difference = [&](double um) {
      if (!known) return plain(um, 3);
      const double error_um = 2e6 * known->displacement_m;
      return um > 2 * error_um ? with_absolute_error(um, error_um) : "< " + rounded_up(um + error_um, 2);
    };
    // Across the load the error differs much from position to position, and none is known of all.
    const int across_digits = needs_film(result.law) ? unstated_digits : 6;
    const bool across_is_rounding = std::abs(across.mean) <= negligible_displacement * std::abs(along.mean);
    rows.push_back({name_of(result), std::to_string(result.cage->positions),
                    with(along.mean, &BearingErrors::displacement_m, 1e6), difference(1e6 * along.peak_to_peak),
                    across_is_rounding ? "0" : plain(1e6 * across.mean, across_digits),
                    plain(1e6 * across.peak_to_peak, unstated_digits),
                    with(result.cage->largest_force_N, &BearingErrors::largest_force_N, 1)});
  }
  return below_line(rows);
}

/// The straight lines of ehd-linear.
std::string fit_table(const bearing::BothRaceways<LinearFit>& fits) {
  Rows rows{{"fit", "K N/m", "dF N", "residual N", "standard deviation N", "of K N/m", "of dF N", "N from", "to"}};
  const auto add = [&rows](const char* name, const LinearFit& fit) {
    rows.push_back({name, plain(fit.K_N_per_m, 5), fixed(fit.dF_N, 1), fixed(fit.residual_N, 1),
                    fixed(fit.standard_deviation_N, 1), plain(fit.K_deviation_N_per_m, 2), fixed(fit.dF_deviation_N, 1),
                    plain(fit.points.front().force_N, 5), plain(fit.points.back().force_N, 5)});
  };
  add("inner", fits.inner);
  add("outer", fits.outer);
  return below_line(rows);
}

std::string failures(const std::vector<BearingResult>& results) {
  std::string text;
  for (const BearingResult& result : results)
    if (result.rollers.empty()) text += fmt::format("\n  {}: no balance: {}\n", name_of(result), result.why);
  return text;
}

/// Each note once, with the laws that have it, in the order in which the notes appear.
template <class Notes>
std::vector<std::pair<std::string, std::string>> laws_of_each(const std::vector<BearingResult>& results,
                                                              const Notes& notes_of_one) {
  std::vector<std::pair<std::string, std::string>> laws_of_notes;
  for (const BearingResult& result : results)
    for (const std::string& note : notes_of_one(result)) {
      const auto known =
          std::find_if(laws_of_notes.begin(), laws_of_notes.end(), [&](const auto& one) { return one.first == note; });
      if (known == laws_of_notes.end())
        laws_of_notes.emplace_back(note, name_of(result));
      else
        known->second += ", " + name_of(result);
    }
  return laws_of_notes;
}

/// "notes on ehd-linear, ehd", and these notes.
std::string remarks(const std::vector<BearingResult>& results, bool details) {
  const auto laws_of_notes =
      laws_of_each(results, [&](const BearingResult& result) { return remarks_of(result, details); });
  std::vector<std::string> headings;
  for (const auto& [note, laws] : laws_of_notes)
    if (std::find(headings.begin(), headings.end(), laws) == headings.end()) headings.push_back(laws);
  std::string text;
  for (const std::string& heading : headings) {
    text += fmt::format("\n  notes on {}\n", heading);
    for (const auto& [note, laws] : laws_of_notes)
      if (laws == heading) text += wrapped("    - " + note, "      ");
  }
  return text;
}

/// Before the numbers that they are about.
std::string warnings(const std::vector<BearingResult>& results) {
  std::string text;
  for (const auto& [warning, laws] : laws_of_each(results, warnings_of))
    text += wrapped(fmt::format("  {}: {}", laws, warning), "    ");
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results, const BearingView& view) {
  std::string text = heading(bearing_case) + warnings(results) +
                     summary_table(std::get<BearingCase>(bearing_case.body), results) +
                     rollers_table(results, [&](const BearingResult& result) { return columns_of(result); }) +
                     error_of_forces(results);
  const BearingResult* full = full_relation_in(results);
  const auto approaches = [&](const BearingResult& result) { return approach_column(result, full); };
  if (view.details)
    text += fmt::format("\n{}{}{}", rollers_table(results, approaches), cost_table(results), ring_table(results));
  text += cage_table(results) + dynamics_table(results);
  for (const BearingResult& result : results) text += contacts_in_motion(result);
  for (const BearingResult& result : results) {
    if (view.details && result.fit) text += fit_table(*result.fit);
  }
  return text + failures(results) + remarks(results, view.details);
}

}  // namespace ehd
