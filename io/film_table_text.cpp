// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/film_table_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/contact_json.hpp"
#include "io/csv.hpp"
#include "io/program_text.hpp"
#include "io/provenance.hpp"

namespace ehd {

namespace {

/// What a file says about x and y.
constexpr const char* film_table_s =
    "(ln M - low)/(high - low), where low and high are ln M at the edges: sums of edge coefficient T_j(y)";
constexpr const char* film_table_x = "even: 2 s - 1; root-low: 2 sqrt(s) - 1; root-high: 1 - 2 sqrt(1 - s)";
constexpr const char* film_table_y = "2 (ln(1 + L) - ln(1 + L_low))/(ln(1 + L_high) - ln(1 + L_low)) - 1";
constexpr int oil_digits = 8;  // of a constant in the heading; the JSON has all

Json inlet_json(const Inlet& inlet) {
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  return cut ? Json(cut->x) : Json("flooded");
}

Json errors_json(const FilmTable& table) {
  Json films = Json::object();
  for (std::size_t k = 0; k < table_film_count; ++k) {
    Json film = Json::object();
    film["shift"] = table_shift(table_films[k]);
    film["stated_error"] = table.errors[k].stated;
    film["found_error"] = table.errors[k].found;
    film["solve_error"] = table.errors[k].solves;
    films[std::string(to_string(table_films[k]))] = std::move(film);
  }
  return films;
}

Json panel_json(const FilmPanel& panel) {
  Json json = Json::object();
  const PanelShape& shape = panel.shape;
  json["L"] = {shape.L_low, shape.L_high};
  json["edges"] = {{"low", shape.low}, {"high", shape.high}};
  json["map"] = to_string(shape.map);
  if (panel.x_first > -1 || panel.x_last < 1) json["solved_x"] = {panel.x_first, panel.x_last};
  json["degrees"] = {{"M", panel.degree_M}, {"L", panel.degree_L}};
  const std::size_t row = static_cast<std::size_t>(panel.degree_L) + 1;
  for (std::size_t k = 0; k < table_film_count; ++k) {
    Json& rows = json["coefficients"][std::string(to_string(table_films[k]))];
    const auto& c = panel.coefficients[k];
    for (std::size_t first = 0; first < c.size(); first += row)
      rows.push_back(std::vector<double>(c.begin() + static_cast<std::ptrdiff_t>(first),
                                         c.begin() + static_cast<std::ptrdiff_t>(first + row)));
  }
  return json;
}

/// The edges of a panel, then its films.
std::string csv_lines_of(const FilmPanel& panel, std::size_t number) {
  const PanelShape& shape = panel.shape;
  const std::string begin = fmt::format("{},{},{},{},", number, shape.L_low, shape.L_high, to_string(shape.map));
  std::string text;
  const auto add_edge = [&](const char* name, const std::vector<double>& edge) {
    for (std::size_t j = 0; j < edge.size(); ++j) text += begin + fmt::format("{},0,0,{},{}\n", name, j, edge[j]);
  };
  add_edge("edge.low", shape.low);
  add_edge("edge.high", shape.high);
  for (std::size_t k = 0; k < table_film_count; ++k) {
    const std::string film = fmt::format("{}{},{},", begin, to_string(table_films[k]), table_shift(table_films[k]));
    auto c = panel.coefficients[k].begin();
    for (int i = 0; i <= panel.degree_M; ++i)
      for (int j = 0; j <= panel.degree_L; ++j) text += film + fmt::format("{},{},{}\n", i, j, *c++);
  }
  return text;
}

std::string edge_words(const std::vector<double>& edge) {
  const auto [least, most] = ends_of(edge);
  return edge.size() == 1 ? plain(least) : fmt::format("a curve ({} to {})", plain(least, 3), plain(most, 3));
}

/// The errors that a table has next to the bend in place of the others.
std::string bend_words(const BendErrors& bend) {
  std::string words = fmt::format("Within about {} in ln M of the bend: ", plain(bend.gap));
  if (!bend.stated) return words + "no error is known";
  for (std::size_t k = 0; k < table_film_count; ++k)
    words +=
        fmt::format("{}{} {}", k > 0 ? ", " : "stated errors ", to_string(table_films[k]), plain((*bend.stated)[k], 2));
  return words;
}

std::string oil_words(const FilmTable& table) {
  const Json oil = to_json(table.lubricant);
  std::string words =
      fmt::format("viscosity {}, density {}", to_string(table.lubricant.viscosity), to_string(table.lubricant.density));
  for (const auto& [key, value] : oil.items())
    if (value.is_number()) words += fmt::format(", {} = {}", key, plain(value.get<double>(), oil_digits));
  const auto* cut = std::get_if<TruncatedAt>(&table.inlet);
  return words + (cut ? ", inlet at X = " + plain(cut->x) : ", flooded");
}

}  // namespace

Json to_json(const FilmTable& table) {
  Json json = Json::object();
  json["schema"] = film_table_schema;
  json["provenance"] = provenance();
  json["case"] = table.case_id;
  json["version"] = table.version;
  json["title"] = table.title;
  json["solver"] = table.solver;
  json["status"] = to_string(table.status);
  if (!table.reason.empty()) json["reason"] = table.reason;
  json["lubricant"] = to_json(table.lubricant);
  json["inlet"] = inlet_json(table.inlet);
  json["range"] = {{"M", {table.range.M_low, table.range.M_high}}, {"L", {table.range.L_low, table.range.L_high}}};
  json["tolerance"] = table.tolerance;
  json["s"] = film_table_s;
  json["x"] = film_table_x;
  json["y"] = film_table_y;
  json["film"] = "shift + exp(sum of c_ij T_i(x) T_j(y)), in units of b^2/R";
  json["films"] = errors_json(table);
  if (table.at_bend) {
    json["at_bend"]["gap_ln_M"] = table.at_bend->gap;
    for (std::size_t k = 0; k < table_film_count && table.at_bend->stated; ++k)
      json["at_bend"]["stated_error"][std::string(to_string(table_films[k]))] = (*table.at_bend->stated)[k];
  }
  json["panels"] = Json::array();
  for (const FilmPanel& panel : table.panels) json["panels"].push_back(panel_json(panel));
  json["cost"] = {{"solves", table.solves}, {"held_out", table.held_out}};
  return json;
}

std::vector<std::string> film_table_words(const FilmTable& table) {
  std::vector<std::string> lines{
      fmt::format("Films of {} (version {}) over M {} to {}, L {} to {}: {}", table.case_id, table.version,
                  plain(table.range.M_low), plain(table.range.M_high), plain(table.range.L_low),
                  plain(table.range.L_high), to_string(table.status)),
      "Case: " + table.title, "Oil: " + oil_words(table), fmt::format("Made by {}, solver {}", made_by(), table.solver),
      fmt::format("{} solves, and {} held-out ones that found the errors; asked for {}", table.solves, table.held_out,
                  plain(table.tolerance))};
  for (const FilmPanel& panel : table.panels)
    lines.push_back(fmt::format("Panel L {} to {}, M {} to {}: degree {} in M, {} in L", plain(panel.shape.L_low),
                                plain(panel.shape.L_high), edge_words(panel.shape.low), edge_words(panel.shape.high),
                                panel.degree_M, panel.degree_L));
  for (std::size_t k = 0; k < table_film_count; ++k)
    lines.push_back(fmt::format("{}: stated error {}, found {}", to_string(table_films[k]),
                                plain(table.errors[k].stated, 2), plain(table.errors[k].found, 2)));
  if (table.at_bend) lines.push_back(bend_words(*table.at_bend));
  lines.push_back(
      "Errors are relative; of the offset absolute up to 1 above the dry offset, then relative to that rise.");
  return lines;
}

std::string film_table_csv(const FilmTable& table) {
  std::string text = fmt::format("# schema: {}\n", film_table_schema);
  for (const std::string& line : film_table_words(table)) text += csv_comment(line);
  text += fmt::format("# s = {}\n# x = {}\n# y = {}\n", film_table_s, film_table_x, film_table_y);
  text += "# film = shift + exp(sum of coefficient T_i(x) T_j(y)), in units of b^2/R\n";
  text += csv_line({"panel", "L_low", "L_high", "map", "of", "shift", "i", "j", "coefficient"});
  for (std::size_t p = 0; p < table.panels.size(); ++p) text += csv_lines_of(table.panels[p], p);
  return text;
}

}  // namespace ehd
