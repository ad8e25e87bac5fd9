// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/film_maps.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

const MapPoint* find(const FilmMaps& maps, AtlasLaws laws, double M, double L) {
  for (const MapPoint& point : maps.points)
    if (point.at.laws == laws && point.at.M == M && point.at.L == L) return &point;
  return nullptr;
}

const MapFormula* find(const MapPoint& point, const std::string& name, Quantity of) {
  for (const MapFormula& formula : point.formulas)
    if (formula.name == name && formula.of == of) return &formula;
  return nullptr;
}

/// A table of one flooded point and its cut, with films of round numbers.
AtlasTable two_rows(const std::string& cut_error) {
  AtlasTable table;
  for (const bool flooded : {true, false}) {
    std::map<std::string, std::string> row;
    for (const auto& column : atlas_columns()) row[column] = "";
    row["laws"] = "roelands";
    row["M"] = "20";
    row["L"] = "10";
    row["inlet"] = flooded ? "flooded" : "-4";
    row["H_min"] = flooded ? "0.08" : "0.06";
    row["H_min_error"] = flooded ? "1e-5" : cut_error;
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(studies_film_maps)

BOOST_AUTO_TEST_CASE(a_deviation_is_the_formula_over_the_certified_film) {
  const FilmMaps maps = ehd::verification::film_maps(two_rows("2e-5"));
  BOOST_REQUIRE(maps.points.size() == 1);
  const MapPoint& point = maps.points.front();
  BOOST_REQUIRE(point.minimum.has_value());
  BOOST_TEST(!point.central.has_value());
  const double moes = 0.08 * 8 * 20 / 3.14159265358979323846;
  EHD_CHECK(error(point.minimum->value, moes), Tolerance::round_off(8));
  // H_min/R = 3.07 U^0.71 G^0.57 W^-0.11 at M = W (2U)^(-1/2), L = G (2U)^(1/4), from the definitions.
  const double G = 5000, U = std::pow(10 / G, 4) / 2, W = 20 * std::sqrt(2 * U);
  const double hamrock = 3.07 * std::pow(U, 0.71) * std::pow(G, 0.57) * std::pow(W, -0.11) / std::sqrt(2 * U);
  const MapFormula* formula = find(point, "Hamrock & Jacobson 1984", Quantity::film_minimum);
  BOOST_REQUIRE(formula);
  EHD_CHECK(error(formula->deviation, hamrock / moes - 1), Tolerance::round_off(200));
  BOOST_TEST(find(point, "Dowson & Toyoda 1978", Quantity::film_central) == nullptr);  // that film is not known
}

BOOST_AUTO_TEST_CASE(the_cost_of_a_cut_is_relative_to_flooded_and_carries_both_errors) {
  const FilmMaps maps = ehd::verification::film_maps(two_rows("2e-5"));
  const auto& cost = maps.points.at(0).minimum_cost;
  BOOST_REQUIRE(cost.has_value());
  EHD_CHECK(error(cost->value, -0.25), Tolerance::round_off(8));
  EHD_CHECK(error(cost->error, 0.75 * 3e-5), Tolerance::round_off(16));
  BOOST_TEST(!maps.points.at(0).central_cost.has_value());
  BOOST_TEST(!ehd::verification::film_maps(two_rows("")).points.at(0).minimum_cost.has_value());
}

BOOST_AUTO_TEST_CASE(percents_have_the_digits_that_are_known) {
  BOOST_TEST(known_percent({0.013, 1e-9}) == "+1.3");
  BOOST_TEST(known_percent({-0.0047, 1e-9}) == "-0.47");
  BOOST_TEST(known_percent({-0.25, 1e-9}) == "-25");
  BOOST_TEST(known_percent({4e-5, 1e-9}) == "0");
  BOOST_TEST(known_percent({-1.6e-4, 2.2e-4}) == "0");  // within its own error
  BOOST_TEST(known_percent({6.9e-5, 1.2e-4}) == "0");
  BOOST_TEST(known_percent({1e-4, 1e-4}) == "0");
  BOOST_TEST(known_percent({0.0047, 2e-4}) == "+0.5");  // 0.47(2): the second digit is not known
  BOOST_TEST(known_percent({0.013, 2e-3}) == "+1");
}

BOOST_AUTO_TEST_CASE(a_cost_within_its_own_error_is_printed_as_none) {
  AtlasTable table = two_rows("2e-4");
  table.rows[1]["H_min"] = "0.079988";  // 1.5e-4 thinner, known to 2.1e-4
  const auto maps = ehd::verification::film_maps(table);
  BOOST_TEST(std::abs(maps.points.at(0).minimum_cost->value) > 1e-4);
  const std::string text = human_maps(maps, Quantity::film_minimum, AtlasLaws::roelands);
  const auto costs = text.substr(text.find("Inlet cut at"));
  BOOST_TEST(costs.find("0.0") == std::string::npos, costs);
  table.rows[1]["H_min_error"] = "1e-7";
  table.rows[0]["H_min_error"] = "1e-7";
  const std::string known =
      human_maps(ehd::verification::film_maps(table), Quantity::film_minimum, AtlasLaws::roelands);
  BOOST_TEST(known.find("-0.01", known.find("Inlet cut at")) != std::string::npos, known);
}

/// The median of the overview, of points whose film is a formula's over 1 + the deviations given.
BOOST_AUTO_TEST_CASE(the_median_of_an_even_number_is_the_mean_of_the_middle_two) {
  for (const auto& [deviations, median] : {std::pair{std::vector<double>{-0.10, 0.02, 0.04, 0.20}, "+3.0"},
                                           {std::vector<double>{-0.10, 0.02, 0.20}, "+2.0"}}) {
    FilmMaps maps;
    maps.source = "made up";
    maps.L = {10};
    for (const double deviation : deviations) {
      MapPoint point;
      point.at.laws = AtlasLaws::roelands;
      point.at.M = 10.0 + static_cast<double>(maps.points.size());
      point.at.L = 10;
      point.minimum = MapValue{1, 1e-9};
      point.formulas.push_back(
          {.name = "made", .of = Quantity::film_minimum, .moes = 1 + deviation, .deviation = deviation});
      maps.M.push_back(point.at.M);
      maps.points.push_back(point);
    }
    const std::string text = human_maps(maps, Quantity::film_minimum, AtlasLaws::roelands);
    const auto row = text.substr(text.rfind("\n  made "), 200);  // of the table's last part
    const auto line = row.substr(1, row.find('\n', 1) - 1);
    BOOST_TEST(line.find(std::string(" ") + median) != std::string::npos, line);
  }
}

BOOST_AUTO_TEST_CASE(the_atlas_has_maps_with_formulas_and_costs) {
  const FilmMaps maps = ehd::verification::film_maps(atlas_folder());
  BOOST_TEST(maps.M.size() == 16U);
  BOOST_TEST(maps.L.size() == 7U);
  const MapPoint* point = find(maps, AtlasLaws::roelands, 20, 10);
  BOOST_REQUIRE(point);
  // The claims formulas/agreement judge what these say at this contact.
  for (const char* name :
       {"Dowson & Higginson 1977", "Dowson & Higginson 1966", "Hamrock & Jacobson 1984", "Pan & Hamrock 1989"})
    BOOST_TEST(find(*point, name, Quantity::film_minimum), name);
  BOOST_TEST(point->minimum_cost.has_value());
  const MapPoint* light = find(maps, AtlasLaws::barus, 1, 5);
  BOOST_REQUIRE(light);
  BOOST_TEST(!light->minimum_cost.has_value());
}

BOOST_AUTO_TEST_CASE(the_command_prints_tables_and_leaves_two_files) {
  const test::Folder folder;
  const auto out = folder.path() / "maps";
  const auto ended = test::ehd_run(folder, "maps --quantity film.minimum --laws barus --output '" + out.string() + "'");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.err == "");
  for (const char* text : {"Pan & Hamrock 1989, film.minimum: deviation in percent", "within 5 % at M =",
                           "30 % or more", "barus", "Inlet cut at X = -4, film.minimum", "for comparison only"})
    BOOST_CHECK_MESSAGE(ended.out.find(text) != std::string::npos, text << " is not in the tables");
  BOOST_TEST(ended.out.find("film.central") == std::string::npos);
  const std::string formulas = test::read(out / "formula_maps.csv"), inlets = test::read(out / "inlet_maps.csv");
  // Flooded points with all digits: 96 of each law set with 7 formulas, 16 isoviscous with one; none is missing.
  BOOST_TEST(std::count(formulas.begin(), formulas.end(), '\n') > 1200);
  BOOST_TEST(std::count(inlets.begin(), inlets.end(), '\n') > 250);
  BOOST_TEST(formulas.find("roelands,20,10,0.810966,no,film.minimum,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_damaged_atlas_is_one_line_and_exit_code_2) {
  const test::Folder folder;
  std::filesystem::create_directories(folder.path() / "cases" / "atlas");
  const std::string whole = test::read(atlas_folder() / "atlas.csv");
  for (const auto& [before, now, says] :
       {std::tuple{",384.736414486,", ",abc,", "atlas.csv:3: H_min = abc: is not a number; allowed is"},
        {",384.736414486,", ",1e400,", "atlas.csv:3: H_min = 1e400: is out of range; allowed is"},
        {"isoviscous,0.05,0,", "rolands,0.05,0,", "atlas.csv:3: laws = rolands: is unknown; allowed is"}}) {
    std::string text = whole;
    const auto at = text.find(before);
    BOOST_REQUIRE(at != std::string::npos);
    text.replace(at, std::string(before).size(), now);
    (void)folder.write("cases/atlas/atlas.csv", text);
    const char* before_it = std::getenv("EHD_CASES");
    const std::string kept = before_it ? before_it : "";
    ::setenv("EHD_CASES", (folder.path() / "cases").c_str(), 1);
    test::check_refused(folder, "maps", says);
    kept.empty() ? ::unsetenv("EHD_CASES") : ::setenv("EHD_CASES", kept.c_str(), 1);
  }
}

BOOST_AUTO_TEST_CASE(wrong_usage_of_maps_is_one_line) {
  const test::Folder folder;
  for (const auto& [arguments, says] :
       {std::pair{"--quantity film.offset", "--quantity = film.offset: has no formula, and so no map; allowed is"},
        {"--laws mineral", "--laws = mineral: is unknown; allowed is roelands, barus"}})
    test::check_refused(folder, std::string("maps ") + arguments, says);
}

BOOST_AUTO_TEST_CASE(the_couette_film_has_a_map_of_its_own) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "maps --quantity film.couette");
  BOOST_TEST(ended.exit_code == 0);
  BOOST_TEST(ended.out.find("film.couette: deviation in percent") != std::string::npos, ended.out);
  for (const char* other : {"film.minimum", "film.central"}) BOOST_TEST(ended.out.find(other) == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
