// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 10 and 11: numbers of the literature that make no case: values of formulas, tables, and computed films whose
// inlet is only known to lie "at -8 or wider". docs/literature.md says where each item of the literature is judged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bearing/approach_formulas.hpp"
#include "bearing/force_law.hpp"
#include "contact/film_formulas.hpp"
#include "contact/text.hpp"
#include "io/find_case.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/sjovall.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/film_maps.hpp"

namespace ehd::verification {

namespace {

Claim digits_claim(int rung, const std::string& id, const std::string& what, double value, const std::string& printed) {
  return claim_value({.id = id, .rung = rung, .statement = fmt::format("{} has the digits {}", what, printed)}, value,
                     std::stod(printed), 0, Tolerance::published_digits(printed));
}

// -- bearings -----------------------------------------------------------------------------------------------------

/// Teutsch & Sauer 2004, table 1, evaluated at D = 20, l = 30, d_m = 60, t = 6 mm, E = 2.031e5 MPa, nu = .3, Q = 10 kN.
Findings judge_approach_formulas() {
  using bearing::Raceway;
  const bearing::RollerContact contact{.force_N = 10e3,
                                       .length_m = 0.030,
                                       .roller_diameter_m = 0.020,
                                       .pitch_diameter_m = 0.060,
                                       .modulus_Pa = 2.031e11,
                                       .poisson = 0.3,
                                       .ring_thickness_m = 0.006};
  struct Row {
    const char *id, *what, *micrometres;
    double metres;
  };
  const Row rows[] = {
      {"palmgren", "Palmgren's approach", "10.061", bearing::palmgren_approach_m(contact)},
      {"kunert", "Kunert's approach", "11.269", bearing::kunert_approach_m(contact)},
      {"lundberg-inner", "Lundberg's approach, inner", "12.231", lundberg_approach_m(contact, Raceway::inner)},
      {"lundberg-outer", "Lundberg's approach, outer", "11.572", lundberg_approach_m(contact, Raceway::outer)},
      {"tripp-inner", "Tripp's approach, inner", "10.217", tripp_approach_m(contact, Raceway::inner)},
      {"tripp-outer", "Tripp's approach, outer", "8.026", tripp_approach_m(contact, Raceway::outer)},
      {"houpert-inner", "Houpert's approach, inner", "10.410", houpert_approach_m(contact, Raceway::inner)},
      {"houpert-outer", "Houpert's approach, outer", "8.733", houpert_approach_m(contact, Raceway::outer)}};
  Findings found;
  for (const Row& row : rows)
    found.claims.push_back(digits_claim(11, std::string("approach/") + row.id,
                                        std::string(row.what) + " at 10 kN [micrometres]", 1e6 * row.metres,
                                        row.micrometres));
  constexpr double per_mm = 1e-3;  // Q [N] = 8.06e4 l^(8/9) delta^(10/9), lengths in mm
  found.claims.push_back(digits_claim(11, "approach/palmgren-inverse",
                                      "the force of Palmgren's law at l = 1 mm and delta = 1 mm [N]",
                                      bearing::palmgren_law(per_mm).force(per_mm), "8.06e4"));
  // Not the printed 1.8864: the formula here has the exact constant, which the log kernel gives with x_0 = l.
  found.claims.push_back(claim_finding(
      {.id = "approach/lundberg-constant",
       .rung = 11,
       .statement = "Lundberg's printed constant 1.8864 against 2 ln 2 + 1/2"},
      fmt::format("2 ln 2 + 1/2 = {}: one in the printed last digit", plain(2 * std::numbers::ln2 + 0.5, 8))));
  return found;
}

Findings judge_sjovall() {
  const exact::SjovallIntegral integral;
  const std::pair<const char*, const char*> table[] = {
      {"0.1", "0.12641"},  {"0.2", "0.17317"},  {"0.3", "0.20496"}, {"0.4", "0.22804"}, {"0.5", "0.24480"},
      {"0.6", "0.25636"},  {"0.7", "0.26324"},  {"0.8", "0.26549"}, {"0.9", "0.26266"}, {"1", "0.25253"},
      {"1.25", "0.20867"}, {"1.67", "0.15951"}, {"2.5", "0.10831"}, {"5", "0.05490"}};
  Findings found;
  for (const auto& [eps, printed] : table)
    found.claims.push_back(digits_claim(11, std::string("sjovall/J_r/") + eps,
                                        std::string("Sjovall's J_r at eps = ") + eps + ", n = 10/9,",
                                        integral(std::stod(eps)), printed));
  found.claims.push_back(
      digits_claim(11, "sjovall/no-clearance", "1/J_r at eps = 0.5, n = 10/9,", 1 / integral(0.5), "4.0850"));
  const double tables = 1 / exact::SjovallIntegral{1.1}(0.5);
  found.claims.push_back(
      digits_claim(11, "sjovall/no-clearance-n-1.1", "1/J_r at eps = 0.5, n = 1.1,", tables, "4.0766"));
  found.claims.push_back(digits_claim(
      11, "sjovall/nsk", "1/J_r at eps = 0.5, n = 1.1 (NSK catalogue E728g, section 5.1),", tables, "4.08"));
  return found;
}

// -- film formulas ------------------------------------------------------------------------------------------------

/// The power laws as they are printed, digit by digit: c G^a U^u W^w, U of the mean speed; h/R, p/E' or x/R.
struct PrintedPower {
  const char *name, *of, *c, *G, *U, *W;
};
constexpr PrintedPower printed_powers[] = {
    {"Dowson & Higginson 1966", "film.minimum", "1.6", "0.6", "0.7", "-0.13"},
    {"Dowson & Higginson 1977", "film.minimum", "2.65", "0.54", "0.7", "-0.13"},
    {"Hamrock & Jacobson 1984", "film.minimum", "3.07", "0.57", "0.71", "-0.11"},
    {"Pan & Hamrock 1989", "film.minimum", "1.714", "0.568", "0.694", "-0.128"},
    {"Dowson & Toyoda 1978", "film.central", "3.06", "0.56", "0.69", "-0.10"},
    {"Pan & Hamrock 1989", "film.central", "2.922", "0.470", "0.692", "-0.166"},
    {"Pan & Hamrock 1989", "spike height", "0.648", "0.391", "0.275", "0.185"},
    {"Pan & Hamrock 1989", "spike place", "1.111", "0.077", "-0.021", "0.606"},
    {"Pan & Hamrock 1989", "place of the smallest film", "1.439", "0.026", "-0.011", "0.548"}};

/// Every power law against its printed digits, at three points, so that no wrong exponent hides in a constant.
Findings judge_printed_powers() {
  Findings found;
  for (const PrintedPower& printed : printed_powers) {
    double error = 0;
    for (const auto& [M, L, G] :
         {std::tuple(20.0, 10.0, 5000.0), std::tuple(3.0, 4.0, 3200.0), std::tuple(900.0, 17.0, 4100.0)}) {
      const double U_s = std::pow(L / G, 4), W = M * std::sqrt(U_s);
      const double power = std::stod(printed.c) * std::pow(G, std::stod(printed.G)) *
                           std::pow(U_s / 2, std::stod(printed.U)) * std::pow(W, std::stod(printed.W));
      const SpikeFormula spike = pan_hamrock_spike({.M = M, .L = L}, G);
      const double half_width = std::sqrt(8 * W / std::numbers::pi);  // b/R
      double computed = nothing;
      if (printed.of == std::string("spike height")) {
        computed = spike.height * std::sqrt(W / (2 * std::numbers::pi));  // p_H/E'
      } else if (printed.of == std::string("spike place")) {
        computed = spike.place * half_width;
      } else if (printed.of == std::string("place of the smallest film")) {
        computed = spike.minimum_place * half_width;
      } else {
        for (const FilmFormula& formula : film_formulas({.M = M, .L = L}, G))
          if (formula.name == printed.name && to_string(formula.of) == printed.of)
            computed = formula.moes_film * std::sqrt(U_s);
      }
      error = worse(error, std::abs(computed / power - 1));
    }
    const std::string law = fmt::format("{} G^{} U^{} W^{}", printed.c, printed.G, printed.U, printed.W);
    found.claims.push_back(
        claim({.id = fmt::format("formulas/printed/{}/{}", printed.name, printed.of),
               .rung = 10,
               .statement = fmt::format("{}, {}: evaluated as printed, {}", printed.name, printed.of, law)},
              error, 0, Tolerance::round_off(64, 10), "three points (M, L, G)"));
  }
  return found;
}

/// A formula is a fit: its film is never judged. Judged is only that the formula is evaluated as printed.
Findings judge_formulas() {
  Findings found;
  constexpr double computed = 3.784, half_digit = 0.0005;  // of the film, Moes units, and of the percentages below
  const std::pair<const char*, double> agreement[] = {{"Dowson & Higginson 1977", 1.3},
                                                      {"Dowson & Higginson 1966", 1.9},
                                                      {"Hamrock & Jacobson 1984", -2.9},
                                                      {"Pan & Hamrock 1989", -4.9}};
  const auto formulas = film_formulas({.M = 20, .L = 10}, usual_G);
  for (const auto& [name, percent] : agreement) {
    double deviation = nothing;
    for (const FilmFormula& formula : formulas)
      if (formula.name == name && formula.of == Quantity::film_minimum) deviation = formula.moes_film / computed - 1;
    Claim judged =
        claim({.id = std::string("formulas/agreement/") + name,
               .rung = 10,
               .statement = fmt::format("{} at (20,10), G = 5000, lies {} % from the computed H_min 3.784", name,
                                        plain(percent))},
              std::abs(deviation - percent / 100), 0,
              Tolerance::calibrated(half_digit + half_digit / computed, "half digits of the percentage and of 3.784"));
    judged.measured = 100 * deviation;
    judged.expected = percent;
    found.claims.push_back(std::move(judged));
  }
  const auto spike = pan_hamrock_spike({.M = 20, .L = 10}, usual_G);
  const Solution solution =
      remembered(certified_solver().name).solve(problem_at({20, 10}, true, Flooded{}), {.tolerance = 1e-4});
  const Reading *highest = observed(solution, Quantity::pressure_spike),
                *thinnest = observed(solution, Quantity::film_minimum);
  struct Row {
    const char *id, *what;
    double formula, computed;
  };
  for (const Row& row : {Row{"spike", "spike P", spike.height, value_of(highest)},
                         Row{"spike-place", "place X of the spike", spike.place, place_of(highest)},
                         Row{"minimum-place", "place X of the smallest film", spike.minimum_place, place_of(thinnest)}})
    found.skipped.push_back({{.id = std::string("formulas/pan-hamrock/") + row.id,
                              .rung = 10,
                              .statement = std::string("Pan & Hamrock's ") + row.what + " at (20,10), flooded"},
                             fmt::format("a regression neither passes nor fails; formula {}, computed {}",
                                         plain(row.formula, 4), plain(row.computed, 5))});
  return found;
}

/// The literature says of Moes' formula: "within 5 % of computed Barus incompressible films for M >= 2". The atlas
/// decides.
Findings judge_moes_statement() {
  const auto folder = atlas_folder();
  const Sentence says{.id = "formulas/moes-within-5-percent",
                      .rung = 10,
                      .statement = "Moes' formula lies within 5 % of Barus incompressible Couette films for M >= 2"};
  std::error_code missing;
  if (!std::filesystem::exists(folder / "atlas.csv", missing))
    return {.claims = {}, .skipped = {{says, "there is no atlas in " + cases_folder().string()}}};
  double worst = 0, arithmetic = 0;
  std::string where;
  int points = 0;
  constexpr double lightest = 2;
  for (const MapPoint& point : film_maps(folder).points) {
    for (const MapFormula& formula : point.formulas) {
      const auto& film = point.film(formula.of);
      arithmetic =
          worse(arithmetic, film ? std::abs(film->value * (1 + formula.deviation) / formula.moes - 1) : nothing);
    }
    if (point.at.laws == AtlasLaws::roelands || point.at.M < lightest) continue;
    for (const MapFormula& formula : point.formulas) {
      if (formula.of != Quantity::film_couette) continue;
      ++points;
      if (std::abs(formula.deviation) <= std::abs(worst)) continue;
      worst = formula.deviation;
      where = fmt::format("M = {}, L = {}", plain(point.at.M), plain(point.at.L));
    }
  }
  if (points == 0) return {.claims = {}, .skipped = {{says, "the atlas has no such film"}}};
  Sentence computed = says;
  computed.statement += std::string(": computed: ") + (std::abs(worst) <= close_formula ? "holds" : "does not hold");
  return {.claims = {claim_finding(computed, fmt::format("largest deviation {} % at {}, of {} points of the atlas",
                                                         plain(100 * worst, 3), where, points)),
                     claim({.id = "formulas/deviation-of-the-film",
                            .rung = 10,
                            .statement = "a map's deviation, applied to the certified film, gives the formula's film"},
                           arithmetic, 0, Tolerance::round_off(8, 4), "every formula at every point of the atlas")},
          .skipped = {}};
}

// -- films with an inlet "at -8 or wider" ---------------------------------------------------------------------------

/// A number that was computed with an inlet at -8 or wider. Films grow with the inlet's length, so that the number lies
/// between that of the contact cut at -8 and that of the flooded one, within its own uncertainty.
struct Between {
  std::string id, what;
  Quantity quantity;
  double value = 0;        ///< in the source
  double unit = 1;         ///< the source's value over the solvers' value
  double uncertainty = 0;  ///< relative; absolute for film.offset
  bool place = false;      ///< the number is the X of the quantity, for which solvers state no error
};

struct Ends {
  Solution cut, flooded;
};

Ends ends_of(MoesGroups moes, const Lubricant& lubricant) {
  const auto solve = [&](const Inlet& inlet) {
    return remembered(default_solver().name)
        .solve(nondimensionalise(moes, lubricant, inlet).problem, {.tolerance = 1e-5});
  };
  return {solve(TruncatedAt{-8}), solve(Flooded{})};
}

void judge_between(Findings& found, const Ends& ends, const Between& one) {
  const auto end = [&](const Solution& solution) -> std::pair<double, double> {
    const Reading* seen = reading(solution, one.quantity);
    if (!seen || !seen->error) return {nothing, nothing};
    if (one.place) return {place_of(seen), 0};
    return {seen->value * one.unit, *seen->error};
  };
  const auto [first, first_error] = end(ends.cut);
  const auto [second, second_error] = end(ends.flooded);
  const double scale = has_absolute_error(one.quantity) ? 1 : std::abs(one.value);
  const double low = std::min(first, second), high = std::max(first, second);
  const double outside = std::isfinite(first) && std::isfinite(second)
                             ? std::max({0.0, low - one.value, one.value - high}) / scale
                             : nothing;
  Claim judged =
      claim({.id = "computed/" + one.id,
             .rung = 10,
             .statement = one.what + ", computed with an inlet at -8 or wider, lies between cut at -8 and flooded",
             .case_id = {},
             .solver = default_solver().name},
            outside, 0, Tolerance::discretisation(one.uncertainty + std::max(first_error, second_error), 1),
            fmt::format("cut at -8 {}, flooded {}", plain(first, 6), plain(second, 6)));
  judged.measured = one.value < low ? low : std::min(one.value, high);
  judged.expected = one.value;
  found.claims.push_back(std::move(judged));
}

/// Barus, incompressible, Moes units.
struct BarusRow {
  double M, L;
  const char *minimum, *central;
};
constexpr BarusRow barus_films[] = {
    {1, 0, "3.0572", "3.2717"},   {1, 10, "5.3436", "5.6152"},   {2, 5, "3.6003", "4.5521"},
    {5, 0, "1.5900", "2.0356"},   {5, 5, "3.1739", "4.1776"},    {5, 10, "4.6323", "6.0726"},
    {10, 0, "1.3241", "1.6800"},  {10, 5, "2.8905", "3.8281"},   {10, 15, "5.5655", "7.3289"},
    {20, 0, "1.1246", "1.4204"},  {20, 5, "2.6355", "3.5055"},   {20, 10, "3.9747", "5.2764"},
    {20, 15, "5.1810", "6.8623"}, {50, 5, "2.3297", "3.1098"},   {50, 10, "3.5652", "4.7525"},
    {100, 0, "0.7963", "1.0014"}, {100, 10, "3.2715", "4.3716"}, {100, 15, "4.3111", "5.7503"},
    {200, 5, "1.9277", "2.5810"}, {200, 10, "2.9981", "4.0108"}, {200, 15, "3.9596", "5.2933"}};

/// The source gives 0.1 % for M <= 20 and 0.3 % at 200. It says nothing between; 0.3 % is taken there.
double uncertainty_at(double M) {
  constexpr double light = 1e-3, heavy = 3e-3, moderate_M = 20;
  return M <= moderate_M ? light : heavy;
}

Findings judge_barus_films() {
  Findings found;
  for (const BarusRow& row : barus_films) {
    const Ends ends = ends_of({row.M, row.L}, oil(false));
    const std::string point = fmt::format("{}-{}", plain(row.M), plain(row.L));
    for (const auto& [quantity, text] :
         {std::pair{Quantity::film_minimum, row.minimum}, {Quantity::film_central, row.central}})
      judge_between(found, ends,
                    {.id = fmt::format("barus/{}/{}", point, to_string(quantity)),
                     .what = fmt::format("{} = {} at M-L = {}", to_string(quantity), text, point),
                     .quantity = quantity,
                     .value = std::stod(text),
                     .unit = moes_film_per_hertz_film(row.M),
                     .uncertainty = uncertainty_at(row.M)});
  }
  return found;
}

/// M = 20, L = 10 in Hertz units, three fluids, and the rolling force T* M^(3/2).
Findings judge_three_fluids() {
  constexpr MoesGroups moes{20, 10};
  const Lubricant barus = oil(false), compressible = oil(true);
  Lubricant roelands = compressible;
  roelands.density = DensityLaw::incompressible;
  struct Number {
    Quantity quantity;
    const char* text;
  };
  struct Fluid {
    const char* name;
    Lubricant lubricant;
    std::vector<Number> numbers;
  };
  const std::vector<Fluid> fluids = {
      {"barus", barus, {{Quantity::film_minimum, ".07804"}, {Quantity::film_central, ".10360"}}},
      {"roelands", roelands, {{Quantity::film_minimum, ".07537"}, {Quantity::film_central, ".10018"}}},
      {"roelands-compressible",
       compressible,
       {{Quantity::film_minimum, ".07430"},
        {Quantity::film_central, ".08584"},
        {Quantity::film_couette, ".10267"},
        {Quantity::pressure_exit, "1.074"},
        {Quantity::film_offset, "-.50277"}}}};
  Findings found;
  for (const Fluid& fluid : fluids) {
    const Ends ends = ends_of(moes, fluid.lubricant);
    for (const Number& number : fluid.numbers) {
      // Few printed digits may be rounded by more than 0.1 %.
      const double digits = relative_half_unit(number.text);
      judge_between(
          found, ends,
          {.id = fmt::format("fluids/{}/{}", fluid.name, to_string(number.quantity)),
           .what = fmt::format("{} = {} of {} at (20,10)", to_string(number.quantity), number.text, fluid.name),
           .quantity = number.quantity,
           .value = std::stod(number.text),
           .unit = 1,
           .uncertainty = std::max(uncertainty_at(moes.M), digits)});
    }
  }
  judge_between(found, ends_of(moes, fluids.back().lubricant),
                {.id = "fluids/" + std::string(fluids.back().name) + "/film.minimum/x",
                 .what = "X = .9547 of the smallest film of " + std::string(fluids.back().name) + " at (20,10)",
                 .quantity = Quantity::film_minimum,
                 .value = 0.9547,
                 .uncertainty = uncertainty_at(moes.M),
                 .place = true});
  const Lubricant biboulet{
      .viscosity = ViscosityLaw::barus, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = 2.2e-8, .z = {}};
  judge_between(found, ends_of(moes, biboulet),
                {.id = "rolling-force/20-10",
                 .what = "the rolling force T* M^(3/2) = 1.4536 at (20,10)",
                 .quantity = Quantity::rolling_force,
                 .value = 1.4536,
                 .unit = std::pow(moes.M, 1.5),
                 .uncertainty = uncertainty_at(moes.M)});
  return found;
}

}  // namespace

std::vector<Topic> literature_topics() {
  return {{.name = "approach formulas", .rungs = {11}, .judge = judge_approach_formulas},
          {.name = "Sjovall's integral", .rungs = {11}, .judge = judge_sjovall},
          {.name = "printed power laws", .rungs = {10}, .judge = judge_printed_powers},
          {.name = "film formulas", .rungs = {10}, .judge = judge_formulas},
          {.name = "Moes' formula over the atlas", .rungs = {10}, .judge = judge_moes_statement},
          {.name = "computed films, inlet at -8 or wider", .rungs = {10}, .judge = judge_barus_films},
          {.name = "three fluids at (20,10)", .rungs = {10}, .judge = judge_three_fluids}};
}

}  // namespace ehd::verification
