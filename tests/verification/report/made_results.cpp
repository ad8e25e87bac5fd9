// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/report/made_results.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "io/json.hpp"

namespace ehd::verification::test {

namespace {

Json provenance() {
  return {{"version", "0.1.0"},
          {"commit", "0123456789abcdef0123456789abcdef01234567"},
          {"dirty", true},
          {"compiler", "g++ made up"},
          {"flags", "-O3"},
          {"libraries", {{"Eigen", "3.4.0"}, {"FFTW", "3.3"}}},
          {"cpu", "made up"},
          {"cores", 2},
          {"date", "2020-01-02T03:04:05Z"}};
}

Json claim(const std::string& id, int rung, const std::string& verdict, double margin) {
  return {{"id", id},
          {"rung", rung},
          {"statement", "statement of " + id},
          {"case", "made-20-10"},
          {"version", 1},
          {"solver", "fast"},
          {"topic", "made"},
          {"measured", 1.01},
          {"expected", 1.0},
          {"error", (1 - margin) * 0.1},
          {"uncertainty", 0.0},
          {"tolerance", {{"value", 0.1}, {"basis", "required"}, {"reason", "made up"}}},
          {"verdict", verdict},
          {"margin", margin}};
}

Json film(double value) { return {{"hertz", value}, {"moes", 50 * value}, {"x", 0.9}, {"error", 1e-5}}; }

Json contact_case(const std::string& id, double height) {
  Json one{{"id", id},
           {"version", 1},
           {"title", "Half a circle of pressure"},
           {"source", "own"},
           {"viscosity", "barus"},
           {"density", "incompressible"},
           {"inlet", "flooded"},
           {"M", 20.0},
           {"L", 10.0},
           {"p_H_Pa", 1.1e9},
           {"half_width_m", 3e-4},
           {"solvers", Json::array()}};
  constexpr int nodes = 81;
  std::vector<double> X, P, H, dP, dH;
  for (int i = 0; i < nodes; ++i) {
    const double x = -2 + 3.2 * i / (nodes - 1);
    X.push_back(x);
    P.push_back(std::sqrt(std::max(0.0, 1 - x * x)));
    H.push_back(height + std::pow(std::max(0.0, std::abs(x) - 1), 1.5));
    dP.push_back(1e-5 * std::sin(9 * x));
    dH.push_back(1e-6 * std::cos(7 * x));
  }
  for (const char* solver : {"reference", "fast"})
    one["solvers"].push_back({{"solver", solver},
                              {"tolerance", 1e-4},
                              {"status", "converged"},
                              {"wall_s", 0.01},
                              {"work_units", 30.0},
                              {"nodes", 256},
                              {"film", {{"minimum", film(0.8 * height)}, {"central", film(height)}}},
                              {"pressure", {{"maximum", {{"hertz", 1.0}}}}},
                              {"X", X},
                              {"P", P},
                              {"H", H}});
  one["difference"] = {{"of", "fast - reference"}, {"X", X}, {"P", dP}, {"H_relative", dH}, {"stated", 2e-5}};
  return one;
}

Json convergence(const std::string& id, const std::string& quantity, double order) {
  Json points = Json::array();
  for (int n = 64; n <= 1024; n *= 2)
    points.push_back({{"n", n}, {"error", 3 * std::pow(n, -order)}, {"uncertainty", 1e-6}});
  return {{"id", id},
          {"title", id},
          {"solver", "fast.uniform"},
          {"case", "made-20-10"},
          {"quantity", quantity},
          {"abscissa", "intervals"},
          {"declared_order", 2.0},
          {"fitted_order", order},
          {"kind", "algebraic"},
          {"points", points}};
}

/// `count` points whose error falls by a digit every 10 unknowns.
Json geometric(const std::string& id, int count) {
  Json study = convergence(id, "film.minimum", 0);
  study["solver"] = "reference";
  study["case"] = id;
  study["kind"] = "geometric";
  study["abscissa"] = "unknowns";
  for (const char* key : {"declared_order", "fitted_order", "points"}) study.erase(key);
  for (int i = 1; i <= count; ++i)
    study["points"].push_back({{"n", 10 * i}, {"error", std::pow(10, -i)}, {"uncertainty", 1e-12}});
  return study;
}

Json maps() {
  const std::vector<double> M{0.1, 1, 10, 100, 1000}, L{0, 5, 10, 20}, M_of_axis{0.1, 1, 10, 100, 1000, 5000};
  Json points = Json::array();
  for (const char* laws : {"isoviscous", "barus", "roelands"}) {
    for (const double l : L) {
      if ((l == 0) != (std::string(laws) == "isoviscous")) continue;
      for (const double m : M) {
        const double h = 3 * std::pow(m, -0.3) * (1 + 0.1 * l);
        Json one{{"laws", laws},
                 {"M", m},
                 {"L", l},
                 {"numerical_test", l * std::sqrt(m) > 250},
                 {"p_H_Pa", 2e7 * l * std::sqrt(m)},
                 {"film_minimum_moes", h},
                 {"film_minimum_error", 1e-9},
                 {"film_central_moes", 1.2 * h},
                 {"film_central_error", 1e-9},
                 {"formulas",
                  {{{"name", "Made formula"},
                    {"quantity", "film.minimum"},
                    {"moes", 1.1 * h},
                    {"deviation", 0.2 * std::log10(m) - 0.02 * l}}}},
                 {"fast",
                  {{"status", "converged"},
                   {"tolerance", 1e-3},
                   {"newton_iterations", 10 + 3 * std::log10(m)},
                   {"krylov_iterations", 40.0},
                   {"work_units", 20 + l},
                   {"wall_s", 1e-3 * (1 + l)},
                   {"nodes", 256},
                   {"deviation_minimum", 1e-5},
                   {"deviation_central", -2e-6 * (1 + l)}}}};
        if (m >= 2) {
          one["inlet_cost_minimum"] = -0.2 / m;
          one["inlet_cost_central"] = -0.3 / m;
        }
        points.push_back(one);
      }
    }
  }
  return {{"M", M_of_axis}, {"L", L}, {"source", "made"}, {"points", points}};  // nothing is known at the last M
}

Json bearing(const std::string& id, double clearance_m) {
  Json one{{"id", id},
           {"version", 1},
           {"title", "A made bearing"},
           {"clearance_m", clearance_m},
           {"radial_load_N", 5e4},
           {"speed_rpm", 5000.0},
           {"laws", Json::array()}};
  for (const auto& [law, soft] : {std::pair<const char*, double>{"hertz", 0.0}, {"ehd-linear", 0.05}, {"ehd", 0.08}}) {
    Json rollers = Json::array();
    constexpr int count = 16;
    for (int i = 0; i < count; ++i) {
      const double azimuth = 360.0 * i / count,
                   opening = std::cos(azimuth * std::numbers::pi / 180) * (1 - soft) - 1e5 * clearance_m;
      const Json contact{{"force_N", 9000 * std::max(0.0, opening + soft)},
                         {"displacement_m", 3e-6 * opening},
                         {"film_minimum_m", 4e-7},
                         {"hertz_pressure_Pa", 1e9}};
      rollers.push_back({{"azimuth_deg", azimuth}, {"inner", contact}, {"outer", contact}});
    }
    one["laws"].push_back({{"law", law}, {"status", "converged"}, {"displacement_m", 5e-6}, {"rollers", rollers}});
    if (law == std::string("ehd-linear"))
      one["laws"].back()["fit"]["inner"] = {{"K_N_per_m", 3e9}, {"dF_N", 1100.0}, {"residual_N", 90.0}};
  }
  return one;
}

void add_claims(Json& results) {
  results["claims"] = {claim("inputs/units", 0, "pass", 0.9), claim("twins/agree", 7, "pass", 0.02),
                       claim("grids/fails", 8, "fail", -0.5), claim("grids/unclear", 8, "inconclusive", -0.01)};
  results["claims"][2]["note"] = hostile_text;
  results["skipped"] = {
      {{"id", "published/waits"}, {"rung", 10}, {"statement", "a printed digit"}, {"why", "nobody has read it"}}};
  results["rungs"] = Json::array();
  const char* names[] = {"inputs",  "kernel", "operator", "elasticity", "Reynolds",  "coupled",
                         "solvers", "twins",  "grids",    "regimes",    "published", "bearing"};
  for (int rung = 0; rung < 12; ++rung)
    results["rungs"].push_back({{"rung", rung},
                                {"name", names[rung]},
                                {"pass", rung == 0 || rung == 7 ? 1 : 0},
                                {"fail", rung == 8 ? 1 : 0},
                                {"inconclusive", rung == 8 ? 1 : 0},
                                {"skipped", rung == 10 ? 1 : 0}});
  results["rungs"][7].update({{"worst_margin", 0.02}, {"worst_claim", "twins/agree"}});
  results["summary"] = {{"pass", 2},      {"fail", 1},     {"inconclusive", 1}, {"skipped", 1},   {"success", false},
                        {"wall_s", 12.5}, {"quick", true}, {"threads", 2},      {"selection", ""}};
  results["traceability"] = {{{"part", "README"},
                              {"text", "both solvers agree"},
                              {"claims", 1},
                              {"pass", 1},
                              {"fail", 0},
                              {"inconclusive", 0},
                              {"skipped", 0},
                              {"patterns", {"twins/*"}},
                              {"ids", {"twins/agree"}}}};
  results["topics"] = {{{"name", "quick one"}, {"wall_s", 0.01}}, {{"name", "slow one"}, {"wall_s", 10.0}}};
}

Json statements() {
  return {{{"letter", "a"}, {"law", "ehd"}, {"statement", "loads are similar"}, {"holds", true}, {"numbers", "-4 %"}},
          {{"letter", "c"},
           {"law", "ehd"},
           {"statement", "EHD is close to Hertz"},
           {"holds", false},
           {"numbers", "-5.5 %"}}};
}

Json statement_study() {
  return {{"summary",
           {{{"letter", "a"}, {"law", "ehd"}, {"holds", 1}, {"of", 2}, {"exceptions", "not with viscosity 0.1 Pa s"}}}},
          {"rows",
           {{{"factor", "viscosity"},
             {"value", "0.1 Pa s"},
             {"law", "ehd"},
             {"statements",
              {{{"letter", "a"}, {"holds", false}, {"values", {{"change", 0.012}}}, {"numbers", "+1.2 %"}},
               {{"letter", "c"},
                {"holds", true},
                {"values", {{"middle", 0.004}, {"largest", 0.03}}},
                {"numbers", "+3 %"}}}},
             {"x0_all_hold_m", {{2e-4, 6e-4}}}}}}};
}

Json dynamics() {
  const Json contacts = {0.0, 90.0, 180.0}, damping = {1200.0, 3900.0, 400.0}, stiffness = {3.2e9, 1.5e9, 3e7};
  return {{{"id", "made-tight"},
           {"contacts",
            {{"azimuth_deg", contacts},
             {"inner_stiffness_N_per_m", stiffness},
             {"inner_damping_N_s_per_m", damping},
             {"outer_stiffness_N_per_m", stiffness},
             {"outer_damping_N_s_per_m", damping}}},
           {"ring",
            {{"frequency_Hz", {10.0, 1000.0}},
             {"stiffness_error", {1e-4, 1e-3}},
             {"damping_error", {1e-2, 1e-2}},
             {"along_stiffness_N_per_m", {8.8e9, 8.7e9}},
             {"along_damping_N_s_per_m", {5700.0, 5600.0}},
             {"across_stiffness_N_per_m", {9.8e9, 9.7e9}},
             {"across_damping_N_s_per_m", {10700.0, 10600.0}}}},
           {"frequency_of_changes_Hz", 100.0},
           {"over_clearance",
            {{"clearance_um", {0.0, 10.0}},
             {"along_stiffness_N_per_m", {8.8e9, 7.9e9}},
             {"along_damping_N_s_per_m", {5700.0, 5100.0}},
             {"across_stiffness_N_per_m", {9.8e9, 4.1e9}},
             {"across_damping_N_s_per_m", {10700.0, 9300.0}}}},
           {"over_speed",
            {{"part_of_speed", {0.5, 1.0}},
             {"along_stiffness_N_per_m", {8.7e9, 8.8e9}},
             {"along_damping_N_s_per_m", {8100.0, 5700.0}},
             {"across_stiffness_N_per_m", {9.7e9, 9.8e9}},
             {"across_damping_N_s_per_m", {15200.0, 10700.0}}}}}};
}

Json force_laws() {
  Json laws = Json::array();
  for (const char* law : {"hertz", "ehd"})
    laws.push_back({{"id", "made-tight"},
                    {"raceway", "inner"},
                    {"law", law},
                    {"displacement_m", {-1e-6, 0.0, 1e-6, 2e-6}},
                    {"force_N", {0.0, 10.0, 3000.0, 7000.0}},
                    {"film_minimum_m", {1e-6, 8e-7, 5e-7, 4e-7}}});
  return laws;
}

Json cost_of_motion() {
  Json frequencies = Json::array();
  for (const double L : {5.0, 10.0})
    frequencies.push_back({{"solver", "fast"},
                           {"M", 20.0},
                           {"L", L},
                           {"tolerance", 1e-4},
                           {"status", "converged"},
                           {"steady_s", 1e-3},
                           {"slow_s", 2e-3},
                           {"frequency_s", 1e-4 * L},
                           {"c_s", 2e-6},
                           {"nodes", 512},
                           {"stated", 1e-5},
                           {"achieved", 1e-6 * L}});
  return {{"frequencies", frequencies},
          {"bearings",
           {{{"bearing", "made-tight"},
             {"balance_s", 0.02},
             {"dynamic_s", 0.05},
             {"contact_solves", 30},
             {"responses", 25}}}}};
}

}  // namespace

/// results.json with every part.
Json made_results() {
  Json results{{"schema", 2}, {"provenance", provenance()}};
  add_claims(results);
  Json& figures = results["figures"];
  figures["cases"] = {contact_case("made-20-10", 0.08), contact_case("made-light", 2.0)};
  figures["cases"][1]["title"] = hostile_text;
  figures["convergence"] = {convergence("minimum", "film.minimum", 1.9), convergence("central", "film.central", 2.0),
                            convergence("minimum/own", "film.minimum", 2.0), geometric("made-five", 5),
                            geometric("made-two", 2)};
  figures["maps"] = maps();
  figures["bearing"] = {bearing("made-tight", 0), bearing("made-loose", 2.5e-6), bearing("made-wide", 1e-5)};
  const auto budget_row = [](const char* source, const char* kind, double displacement_m) {
    return Json{{"source", source},
                {"of", "every contact"},
                {"kind", kind},
                {"displacement_m", displacement_m},
                {"largest_force_N", 6.7},
                {"any_force_N", 6.8},
                {"smallest_film_relative", 9.5e-4}};
  };
  Json& laws = figures["bearing"][0]["laws"];
  laws[1]["error_budget"] = {budget_row("fit", "difference", 2e-7), budget_row("contact solver", "bound", 1e-9),
                             budget_row("datum", "difference", 1e-6)};
  // {row} alone is a list of one for gcc and a copy of the row for clang.
  laws[2]["error_budget"] = Json::array({budget_row("interpolation", "bound", 2.6e-9)});
  const auto errors = [](double displacement_m, double largest_force_N, double film) {
    return Json{{"displacement_m", displacement_m},
                {"displacement_lateral_m", 0.0},
                {"largest_force_N", largest_force_N},
                {"any_force_N", 6.8},
                {"smallest_film_relative", film}};
  };
  laws[1]["errors"] = errors(2.01e-7, 13.4, 1.9e-3);
  laws[2]["errors"] = errors(2.6e-9, 6.7, 9.5e-4);
  figures["statements"] = statements();
  figures["statement_study"] = statement_study();
  figures["dynamics"] = dynamics();
  figures["force_law"] = force_laws();
  figures["times"] = {{{"name", "bearing"}, {"wall_s", 12.0}},
                      {{"name", "dynamics"}, {"wall_s", 33.0}},
                      {{"name", "convergence"}, {"wall_s", 180.0}}};
  return results;
}

namespace {

Json runs_of_bench() {
  Json rows = Json::array();
  for (const auto& [solver, order, cost] :
       {std::tuple<const char*, double, double>{"reference", 6, 1e-2}, {"fast", 2, 1e-3}}) {
    for (const int nodes : {64, 128, 256, 512}) {
      Json row{{"case", "made-20-10"},
               {"solver", solver},
               {"nodes", nodes},
               {"status", "converged"},
               {"cost", {{"wall_s", cost * nodes / 64}}}};
      for (const char* quantity : {"film.minimum", "film.central", "pressure"})
        row[quantity] = {{"achieved", 0.1 * std::pow(nodes / 32.0, -order)},
                         {"truth_error", 1e-12},
                         {"bound_only", nodes == 512 && order > 2}};
      rows.push_back(row);
    }
  }
  rows.push_back({{"case", "made-20-10"},
                  {"solver", "fast"},
                  {"tolerance", 1e-9},
                  {"status", "not-run"},
                  {"reason", "expected to reach the time limit"}});
  return rows;
}

Json bench_at_equal_error() {
  Json equal = Json::array();
  for (const double level : {1e-2, 1e-3, 1e-4})
    equal.push_back({{"quantity", "film.central"},
                     {"case", "made-20-10"},
                     {"level", level},
                     {"quickest", Json::array()},
                     {"ratios", {{"reference/fast", 1e-2 / level}}}});
  return equal;
}

Json scaling_of_bench() {
  Json scaling = Json::array();
  for (const int nodes : {256, 1024, 4096})
    scaling.push_back({{"solver", "fast"},
                       {"M", 20.0},
                       {"L", 10.0},
                       {"nodes_asked", nodes},
                       {"status", "converged"},
                       {"nodes", nodes},
                       {"wall_s", 1e-5 * nodes},
                       {"ns_per_n_log2_n", 100.0},
                       {"time_per_unit", 10.0},
                       {"peak_bytes", 1e3 * nodes}});
  return scaling;
}

}  // namespace

Json made_bench() {
  return {{"schema", 1},
          {"provenance", provenance()},
          {"response", cost_of_motion()},
          {"looks", {{"reference", 1}, {"fast", 2}}},
          {"work_precision",
           {{"solvers", {"reference", "fast"}},
            {"cpu_share", 0.99},
            {"c_s", 5e-6},
            {"truths", {{{"case", "made-20-10"}, {"solver", "reference"}, {"film.minimum", {{"error", 1e-12}}}}}},
            {"rows", runs_of_bench()},
            {"at_equal_error", bench_at_equal_error()},
            {"coverage",
             {{{"quantity", "film.central"},
               {"solver", "fast"},
               {"covered", 4},
               {"missed", 0},
               {"undecided", 0},
               {"median_excess", 12.0}}}}}},
          {"scaling", scaling_of_bench()},
          {"cost",
           {{{"asked", "both films to 1e-3"},
             {"of", "box"},
             {"number", 24},
             {"not_converged", 0},
             {"contact_solves", 24},
             {"mean_s", 6e-3},
             {"median_s", 5e-3},
             {"of_95_percent_s", 1e-2},
             {"slowest_s", 2e-2},
             {"c_s", 5e-6}}}},
          {"batch",
           {{{"solver", "fast"},
             {"tolerance", 1e-3},
             {"problems", 16},
             {"converged", 16},
             {"threads", 2},
             {"wall_s", 0.1},
             {"speed_up", 1.9},
             {"same_results", true}}}}};
}

Json made_stress() {
  return {{"schema", 1},
          {"provenance", provenance()},
          {"parts",
           {{{"id", "a"},
             {"name", "box"},
             {"question", "Does every contact end?"},
             {"verdict", "pass"},
             {"summary", "all 4 do"},
             {"tolerance", {{"value", 0.1}, {"basis", "required"}, {"reason", "made up"}}},
             {"columns",
              {{{"name", "M"}, {"unit", ""}}, {{"name", "time"}, {"unit", "s"}}, {{"name", "status"}, {"unit", ""}}}},
             {"rows", {{0.05, 0.1, "converged"}, {5000, "", "tolerance-not-met"}}},
             {"failures", Json::array()},
             {"wall_s", 1.5}}}},
          {"wall_s", 1.5},
          {"success", true}};
}

}  // namespace ehd::verification::test
