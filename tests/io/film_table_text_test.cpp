// SPDX-License-Identifier: GPL-3.0-or-later
// The three forms of a table, each read back by means of its own and held against the table's own evaluator.
#include "io/film_table_text.hpp"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "io/film_table_c.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/made_table.hpp"

using namespace ehd;
using namespace ehd::verification;
using ehd::testing::corner_table;
using ehd::testing::made_table;

namespace {

std::vector<MoesGroups> points(int count, const FilmRange& in) {
  std::vector<MoesGroups> points{{in.M_low, in.L_low}, {in.M_high, in.L_high}, {7, 9}};
  for (int i = 3; i < count; ++i)
    points.push_back({.M = in.M_low * std::pow(in.M_high / in.M_low, std::fmod(0.618 * i, 1)),
                      .L = in.L_low + std::fmod(0.7548 * i, 1) * (in.L_high - in.L_low)});
  return points;
}

/// Sums of up to 300 terms in another order, through an exponential of up to -7.
Tolerance rounding_of_a_sum() { return Tolerance::round_off(300, 10); }

/// T_n(t) = cos(n arccos t), which is no recurrence.
double chebyshev_at(int n, double t) { return std::cos(n * std::acos(std::fmin(1, std::fmax(-1, t)))); }

double chebyshev_sum_of(const nlohmann::json& coefficients, double t) {
  double sum = 0;
  for (std::size_t j = 0; j < coefficients.size(); ++j)
    sum += coefficients[j].get<double>() * chebyshev_at(static_cast<int>(j), t);
  return sum;
}

double coordinate(double value, double low, double high) { return 2 * (value - low) / (high - low) - 1; }

/// The first panel that holds the contact, and the place in it, as the file defines them.
std::tuple<nlohmann::json, double, double> place_in_json(const nlohmann::json& json, const MoesGroups& at) {
  for (const auto& panel : json["panels"]) {
    const double L_low = panel["L"][0], L_high = panel["L"][1];
    if (at.L < L_low || at.L > L_high) continue;
    const double y = coordinate(std::log(1 + at.L), std::log(1 + L_low), std::log(1 + L_high));
    const double low = chebyshev_sum_of(panel["edges"]["low"], y), high = chebyshev_sum_of(panel["edges"]["high"], y);
    if (std::log(at.M) > high + 1e-12) continue;
    const double s = std::fmin(1, std::fmax(0, (std::log(at.M) - low) / (high - low)));
    const double x = panel["map"] == "even"       ? 2 * s - 1
                     : panel["map"] == "root-low" ? 2 * std::sqrt(s) - 1
                                                  : 1 - 2 * std::sqrt(1 - s);
    return {panel, x, y};
  }
  BOOST_FAIL("no panel holds M = " << at.M << ", L = " << at.L);
  return {};
}

/// Compiles the C form of a table and compares it with the table.
void check_c_form(FilmTable table) {
  const test::Folder folder;
  table.title = "a PREFIX */ #error /* of a stranger";
  const std::string prefix = film_table_c_prefix(table);
  BOOST_TEST(prefix == "ehd_made_oil_1_5");
  const std::string text = film_table_c(table);
  BOOST_TEST(text.find("a PREFIX") != std::string::npos);
  (void)folder.write("films.c", text);
  // Reads M and L; prints, for each film, the status, the value and the derivatives.
  (void)folder.write("main.c",
                     "#include <stdio.h>\nint " + prefix +
                         "_film(int film, double M, double L, double *value, double *by_M, double *by_L);\n"
                         "extern const double " +
                         prefix +
                         "_error[4];\n"
                         "int main(void)\n{\n  double M, L;\n  while (scanf(\"%lf %lf\", &M, &L) == 2) {\n"
                         "    int film;\n    for (film = 0; film < 5; ++film) {\n"
                         "      double value = 0, by_M = 0, by_L = 0;\n      const int status = " +
                         prefix +
                         "_film(film, M, L, &value, &by_M, &by_L);\n"
                         "      printf(\"%d %.17g %.17g %.17g %.17g\\n\", status, value, by_M, by_L, film < 4 ? " +
                         prefix + "_error[film] : 0.0);\n    }\n  }\n  return 0;\n}\n");
  std::string input;
  auto all = points(1000, table.range);
  all.push_back({table.range.M_low * 0.999, 10});
  all.push_back({20, table.range.L_high * 1.001});
  all.push_back({testing::not_a_number, 10});
  for (const MoesGroups& at : all) {
    std::ostringstream both;
    both.precision(17);
    both << at.M << " " << at.L << "\n";
    input += both.str();
  }
  (void)folder.write("points.txt", input);
  const std::string at = "cd '" + folder.path().string() + "' && ";
  BOOST_REQUIRE(
      std::system((at + "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror films.c main.c -lm -o films").c_str()) == 0);
  BOOST_REQUIRE(std::system((at + "./films < points.txt > out.txt").c_str()) == 0);
  std::istringstream out(test::read(folder.path() / "out.txt"));
  for (const MoesGroups& point : all) {
    const auto truth = films_at(table, point);
    for (std::size_t k = 0; k < 5; ++k) {
      int status = -1;
      double value = 0, by_M = 0, by_L = 0, stated = 0;
      BOOST_REQUIRE(out >> status >> value >> by_M >> by_L >> stated);
      BOOST_TEST(status == (k == 4 ? 2 : truth ? 0 : 1));
      if (status != 0) continue;
      const double film = (*truth)[k].value - table_shift(table_films[k]);  // what is rounded
      EHD_CHECK(std::abs(value - (*truth)[k].value) / film, rounding_of_a_sum());
      EHD_CHECK(std::abs(by_M - (*truth)[k].by_M) * point.M / film, rounding_of_a_sum());
      EHD_CHECK(std::abs(by_L - (*truth)[k].by_L) * (1 + point.L) / film, rounding_of_a_sum());
      BOOST_TEST(stated == table.errors[k].stated);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(film_table_text)

BOOST_AUTO_TEST_CASE(the_json_says_what_the_table_is) {
  const FilmTable table = made_table();
  const auto json = nlohmann::json::parse(json_text(to_json(table)));
  for (const char* key : {"schema", "provenance", "case", "version", "solver", "status", "lubricant", "inlet", "range",
                          "tolerance", "s", "x", "y", "films", "panels", "cost"})
    BOOST_CHECK_MESSAGE(json.contains(key), key << " is missing");
  BOOST_TEST(json["schema"] == film_table_schema);
  BOOST_TEST(json["case"] == "made-oil-1.5");
  BOOST_TEST(json["version"] == 7);
  BOOST_TEST(json["inlet"] == "flooded");
  BOOST_TEST(json["lubricant"]["z"] == 0.67);
  BOOST_TEST(json["lubricant"]["alpha_per_Pa"] == 2.1e-8);
  BOOST_TEST(json["lubricant"]["p0_Pa"] == 1.9e8);
}

BOOST_AUTO_TEST_CASE(the_json_alone_gives_the_films) {
  for (const FilmTable& table : {made_table(), corner_table()}) {
    const auto json = nlohmann::json::parse(json_text(to_json(table)));
    for (const MoesGroups& at : points(50, table.range)) {
      const auto truth = *films_at(table, at);
      const auto [panel, x, y] = place_in_json(json, at);
      for (std::size_t k = 0; k < table_film_count; ++k) {
        const std::string name(to_string(table_films[k]));
        const auto& rows = panel["coefficients"][name];
        BOOST_TEST(rows.size() == panel["degrees"]["M"].get<std::size_t>() + 1);
        BOOST_TEST(rows[0].size() == panel["degrees"]["L"].get<std::size_t>() + 1);
        double sum = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
          sum += chebyshev_sum_of(rows[i], y) * chebyshev_at(static_cast<int>(i), x);
        const double film = json["films"][name]["shift"].get<double>() + std::exp(sum);
        EHD_CHECK(error(film, truth[k].value), rounding_of_a_sum());
        BOOST_TEST(json["films"][name]["stated_error"] == table.errors[k].stated);
        BOOST_TEST(json["films"][name]["found_error"] == table.errors[k].found);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_csv_has_a_comment_with_the_oil_a_header_and_a_line_for_each_coefficient) {
  const FilmTable table = corner_table();
  std::istringstream text(film_table_csv(table));
  std::string line, comments;
  while (std::getline(text, line) && line.starts_with("#")) comments += line + "\n";
  for (const char* words : {film_table_schema, "made-oil-1.5", "roelands", "z = 0.67", "stated error", "found"})
    BOOST_CHECK_MESSAGE(comments.find(words) != std::string::npos, words << " is not in " << comments);
  BOOST_TEST(line == "panel,L_low,L_high,map,of,shift,i,j,coefficient");
  const auto check_next = [&](std::string_view of, double coefficient) {
    BOOST_REQUIRE(std::getline(text, line));
    BOOST_TEST(line.find(of) != std::string::npos);
    BOOST_TEST(std::stod(line.substr(line.rfind(',') + 1)) == coefficient);
  };
  for (const FilmPanel& panel : table.panels) {
    for (const double c : panel.shape.low) check_next("edge.low", c);
    for (const double c : panel.shape.high) check_next("edge.high", c);
    for (std::size_t k = 0; k < table_film_count; ++k)
      for (const double c : panel.coefficients[k]) check_next(to_string(table_films[k]), c);
  }
  BOOST_TEST(!std::getline(text, line));
}

BOOST_AUTO_TEST_CASE(the_c_form_compiles_without_warnings_and_agrees_to_rounding) {
  check_c_form(made_table());
  check_c_form(corner_table());
}

BOOST_AUTO_TEST_SUITE_END()
