// SPDX-License-Identifier: GPL-3.0-or-later
// The three forms of a table, each read back by means of its own and held against the table's own evaluator.
#include "io/film_table_text.hpp"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/film_table_c.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/made_table.hpp"

using namespace ehd;
using namespace ehd::verification;
using ehd::testing::made_range;
using ehd::testing::made_table;

namespace {

std::vector<MoesGroups> points(int count) {
  std::vector<MoesGroups> points{{made_range.M_low, made_range.L_low}, {made_range.M_high, made_range.L_high}, {7, 9}};
  for (int i = 3; i < count; ++i)
    points.push_back({.M = made_range.M_low * std::pow(made_range.M_high / made_range.M_low, std::fmod(0.618 * i, 1)),
                      .L = made_range.L_low + std::fmod(0.7548 * i, 1) * (made_range.L_high - made_range.L_low)});
  return points;
}

/// Sums of up to 300 terms in another order, through an exponential of up to -7.
Tolerance rounding_of_a_sum() { return Tolerance::round_off(300, 10); }

/// T_n(t) = cos(n arccos t), which is no recurrence.
double chebyshev_at(int n, double t) { return std::cos(n * std::acos(std::fmin(1, std::fmax(-1, t)))); }

double coordinate(double value, double low, double high) { return 2 * (value - low) / (high - low) - 1; }

}  // namespace

BOOST_AUTO_TEST_SUITE(film_table_text)

BOOST_AUTO_TEST_CASE(the_json_alone_gives_the_films) {
  const FilmTable table = made_table();
  const auto json = nlohmann::json::parse(json_text(to_json(table)));
  for (const char* key : {"schema", "provenance", "case", "version", "solver", "status", "lubricant", "inlet", "range",
                          "tolerance", "x", "y", "films", "panels", "cost"})
    BOOST_CHECK_MESSAGE(json.contains(key), key << " is missing");
  BOOST_TEST(json["schema"] == "ehd-films-1");
  BOOST_TEST(json["case"] == "made-oil-1.5");
  BOOST_TEST(json["version"] == 7);
  BOOST_TEST(json["inlet"] == "flooded");
  BOOST_TEST(json["lubricant"]["z"] == 0.67);
  BOOST_TEST(json["lubricant"]["alpha_per_Pa"] == 2.1e-8);
  BOOST_TEST(json["lubricant"]["p0_Pa"] == 1.9e8);
  for (const MoesGroups& at : points(50)) {
    const auto truth = *films_at(table, at);
    for (const auto& panel : json["panels"]) {
      if (at.M > panel["M"][1] || at.M < panel["M"][0] || (at.M == 7 && panel["M"][1] != 7)) continue;
      const double x =
          coordinate(std::log(at.M), std::log(panel["M"][0].get<double>()), std::log(panel["M"][1].get<double>()));
      const double y = coordinate(std::log(1 + at.L), std::log(1 + json["range"]["L"][0].get<double>()),
                                  std::log(1 + json["range"]["L"][1].get<double>()));
      for (std::size_t k = 0; k < table_film_count; ++k) {
        const std::string name(to_string(table_films[k]));
        const auto& rows = panel["coefficients"][name];
        BOOST_TEST(rows.size() == panel["degrees"]["M"].get<std::size_t>() + 1);
        BOOST_TEST(rows[0].size() == panel["degrees"]["L"].get<std::size_t>() + 1);
        double sum = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (std::size_t j = 0; j < rows[i].size(); ++j)
            sum +=
                rows[i][j].get<double>() * chebyshev_at(static_cast<int>(i), x) * chebyshev_at(static_cast<int>(j), y);
        const double film = json["films"][name]["shift"].get<double>() + std::exp(sum);
        EHD_CHECK(error(film, truth[k].value), rounding_of_a_sum());
        BOOST_TEST(json["films"][name]["stated_error"] == table.errors[k].stated);
        BOOST_TEST(json["films"][name]["found_error"] == table.errors[k].found);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_csv_has_a_comment_with_the_oil_a_header_and_a_line_for_each_coefficient) {
  const FilmTable table = made_table();
  std::istringstream text(film_table_csv(table));
  std::string line, comments;
  while (std::getline(text, line) && line.starts_with("#")) comments += line + "\n";
  for (const char* words : {"ehd-films-1", "made-oil-1.5", "roelands", "z = 0.67", "stated error", "found"})
    BOOST_CHECK_MESSAGE(comments.find(words) != std::string::npos, words << " is not in " << comments);
  BOOST_TEST(line == "M_low,M_high,L_low,L_high,film,shift,i,j,coefficient");
  for (const FilmPanel& panel : table.panels)
    for (std::size_t k = 0; k < table_film_count; ++k)
      for (int i = 0; i <= panel.degree_M; ++i)
        for (int j = 0; j <= panel.degree_L; ++j) {
          BOOST_REQUIRE(std::getline(text, line));
          BOOST_TEST(line.find(to_string(table_films[k])) != std::string::npos);
          const auto at = static_cast<std::size_t>(i * (panel.degree_L + 1) + j);
          BOOST_TEST(std::stod(line.substr(line.rfind(',') + 1)) == panel.coefficients[k][at]);
        }
  BOOST_TEST(!std::getline(text, line));
}

BOOST_AUTO_TEST_CASE(the_c_form_compiles_without_warnings_and_agrees_to_rounding) {
  const test::Folder folder;
  FilmTable table = made_table();
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
  auto all = points(1000);
  all.push_back({made_range.M_low * 0.999, 10});
  all.push_back({20, made_range.L_high * 1.001});
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

BOOST_AUTO_TEST_SUITE_END()
