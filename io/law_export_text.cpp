// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/law_export_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/rheology.hpp"
#include "contact/text.hpp"
#include "io/bearing_notes.hpp"
#include "io/contact_json.hpp"
#include "io/csv.hpp"
#include "io/program_text.hpp"
#include "io/provenance.hpp"

namespace ehd {

namespace {

constexpr const char* law_schema = "ehd-law-1";

/// A column of the table, as every form lists them.
struct Column {
  const char* name;
  const std::vector<double>* values;
};

std::vector<Column> columns_of(const bearing::TabulatedLaw& table) {
  std::vector<Column> columns{{"delta_m", &table.approach_m},
                              {"force_N", &table.force_N.values},
                              {"stiffness_N_per_m", &table.force_N.slopes},
                              {"film_minimum_m", &table.film_minimum_m.values},
                              {"film_slope", &table.film_minimum_m.slopes}};
  if (const auto& damping = table.damping_N_s_per_m) {
    columns.push_back({"damping_N_s_per_m", &damping->values});
    columns.push_back({"damping_slope", &damping->slopes});
  }
  return columns;
}

std::string oil_of(const LawExport& law) {
  const Lubricant& oil = law.lubricant;
  std::string words = fmt::format("{} Pa s, {}, {}", plain(law.contact.viscosity_Pa_s), to_string(oil.viscosity),
                                  to_string(oil.density));
  if (oil.alpha_per_Pa) words += fmt::format(", alpha {} 1/Pa", plain(*oil.alpha_per_Pa));
  if (oil.z) words += fmt::format(", z {}", plain(*oil.z));
  return words;
}

constexpr const char* how_to_interpolate =
    "Between two knots ln(force), ln(film) and damping are cubic Hermite polynomials of delta (value and slope at both "
    "knots); the stiffness is the derivative of the force.";

}  // namespace

std::string law_export_prefix(const LawExport& law) {
  return fmt::format("ehd_{}_{}", identifier(law.case_id), to_string(law.raceway));
}

std::vector<std::string> law_export_words(const LawExport& law) {
  const bearing::TableErrors& errors = law.table.errors;
  const std::string ring(to_string(law.raceway));
  std::vector<std::string> lines{
      fmt::format("Contact force law ehd of {} (version {}), {} raceway, whole length of {}", law.case_id, law.version,
                  ring, millimetre(law.contact.length_m)),
      "Case: " + law.title,
      fmt::format("Made by {}", made_by()),
      fmt::format("delta: approach of roller and ring, datum x_0 = {} m; negative where the film is thicker than the "
                  "dry approach",
                  law.datum_m),
      fmt::format("Contact: reduced radius {}, E' = {} Pa, sum speed {} m/s; oil: {}",
                  millimetre(law.contact.reduced_radius_m), plain(law.contact.reduced_modulus_Pa),
                  plain(law.contact.speed_sum_m_per_s), oil_of(law)),
      fmt::format("{} knots over {} to {} N; the balance has {} to {} N", law.table.approach_m.size(),
                  plain(law.lightest_N, 4), plain(law.heaviest_N, 5), plain(law.balance_lightest_N, 4),
                  plain(law.balance_heaviest_N, 5)),
      how_to_interpolate,
      fmt::format("Errors of the law, relative: force {}, stiffness {}, film {}{}", error_text(law.force_error),
                  error_text(law.stiffness_error), error_text(law.film_error),
                  law.damping_error ? ", damping " + plain(*law.damping_error, 2) : ""),
      fmt::format("Errors of the table, found between the knots: force {}, stiffness {}, film {}{}",
                  plain(errors.force, 2), plain(errors.stiffness, 2), plain(errors.film, 2),
                  errors.damping ? ", damping " + plain(*errors.damping, 2) : "")};
  lines.push_back(law.no_damping.empty() ? "Damping: of slow motion, omega -> 0"
                                         : "Damping: not known; " + law.no_damping);
  if (law.status != StopReason::converged)
    lines.push_back(fmt::format("Status: {}; {}", to_string(law.status), law.why));
  return lines;
}

std::string law_export_csv(const LawExport& law) {
  const std::vector<Column> columns = columns_of(law.table);
  std::string text = fmt::format("# schema: {}\n", law_schema);
  for (const std::string& line : law_export_words(law)) text += csv_comment(line);
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.name);
  text += csv_line(names);
  for (std::size_t k = 0; k < law.table.approach_m.size(); ++k) {
    std::vector<std::string> cells;
    for (const Column& column : columns) cells.push_back(exact_number((*column.values)[k]));
    text += csv_line(cells);
  }
  return text;
}

Json to_json(const LawExport& law) {
  const bearing::TableErrors& found = law.table.errors;
  Json json = Json::object();
  json["schema"] = law_schema;
  json["provenance"] = provenance();
  json["case"] = law.case_id;
  json["version"] = law.version;
  json["title"] = law.title;
  json["raceway"] = to_string(law.raceway);
  json["law"] = to_string(bearing::Law::ehd);
  json["status"] = to_string(law.status);
  if (!law.why.empty()) json["reason"] = law.why;
  put(json, "datum_x0_m", law.datum_m);
  put(json["contact"], "length_m", law.contact.length_m);
  put(json["contact"], "reduced_radius_m", law.contact.reduced_radius_m);
  put(json["contact"], "reduced_modulus_Pa", law.contact.reduced_modulus_Pa);
  put(json["contact"], "speed_sum_m_per_s", law.contact.speed_sum_m_per_s);
  put(json["contact"], "viscosity_Pa_s", law.contact.viscosity_Pa_s);
  json["lubricant"] = to_json(law.lubricant);
  put(json, "range_N", {law.lightest_N, law.heaviest_N});
  put(json, "balance_N", {law.balance_lightest_N, law.balance_heaviest_N});
  json["interpolation"] = how_to_interpolate;
  Json of_law, of_table;
  put(of_law, "force", law.force_error);
  put(of_law, "stiffness", law.stiffness_error);
  put(of_law, "film", law.film_error);
  put(of_law, "damping", law.damping_error);
  put(of_table, "force", found.force);
  put(of_table, "stiffness", found.stiffness);
  put(of_table, "film", found.film);
  put(of_table, "damping", found.damping);
  json["errors"] = {{"law", of_law}, {"table", of_table}};
  if (!law.no_damping.empty()) json["no_damping"] = law.no_damping;
  for (const Column& column : columns_of(law.table)) json["knots"][column.name] = *column.values;
  return json;
}

}  // namespace ehd
