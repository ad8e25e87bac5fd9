// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 9: the corners of Moes' diagram, approached.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/blok.hpp"
#include "verification/exact/ertel_grubin.hpp"
#include "verification/exact/martin.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/grid_study.hpp"

namespace ehd::verification {

namespace {

/// A film in Moes units with the solver's own relative error; NaN where the solve did not end as converged.
struct Film {
  double moes = nothing;
  double error = nothing;
};

struct Films {
  Film minimum, central, couette;
  std::string ended;
};

/// Barus (isoviscous at L = 0), incompressible, flooded.
Films films_at(const RegisteredSolver& solver, MoesGroups moes, double tolerance) {
  const Solution solution = remembered(solver.name).solve(problem_at(moes, false, Flooded{}), {.tolerance = tolerance});
  const double unit = moes_film_per_hertz_film(moes.M);
  // A solver need not state an error of the Couette film. That of the central film serves, because both are one flux.
  const double central_error = solution.record.film_central.total();
  const auto film = [&](Quantity quantity) {
    const Reading* seen = reading(solution, quantity);
    return seen ? Film{seen->value * unit, seen->error.value_or(central_error)} : Film{};
  };
  return {.minimum = film(Quantity::film_minimum),
          .central = film(Quantity::film_central),
          .couette = film(Quantity::film_couette),
          .ended = how_it_ended(solution)};
}

/// Rigid and isoviscous. A pressure of given load and shape deforms by a fixed length, at most one Hertz unit of film;
/// Martin's film is .96/M^2 in that unit. So the film departs from Martin's by c1 M^2 + c2 M^4 + ..., all |c| <= 1.
Findings judge_martin(const RegisteredSolver& solver) {
  constexpr double heavier = 0.2, lighter = 0.1, tolerance = 1e-5;
  const Films films[] = {films_at(solver, {heavier, 0}, tolerance), films_at(solver, {lighter, 0}, tolerance)};
  const auto departure = [&](int i, double M) {
    return films[i].minimum.moes / exact::MartinContact(M).moes_minimum - 1;
  };
  const double far = departure(0, heavier), near = departure(1, lighter);
  const double uncertainty = (films[0].minimum.error + 4 * films[1].minimum.error) / 3;
  const std::string note = fmt::format("departures {} at M = 0.2, {} at 0.1; {}, {}", plain(far, 4), plain(near, 4),
                                       films[0].ended, films[1].ended);
  const auto says = [&](const std::string& what, const std::string& statement) {
    return Sentence{.id = fmt::format("regimes/martin/{}/{}", solver.name, what),
                    .rung = 9,
                    .statement = solver.name + "'s " + statement,
                    .solver = solver.name};
  };
  Findings found;
  found.claims.push_back(claim_value(
      says("limit", "minimum film over Martin's goes to 1 as M vanishes"), 1 + (4 * near - far) / 3, 1, uncertainty,
      Tolerance::asymptotic(heavier * heavier * lighter * lighter,
                            "extrapolated from M = 0.2 and 0.1, which leaves at most (0.2 x 0.1)^2"),
      note));
  found.claims.push_back(claim_value(
      says("order", "minimum film departs from Martin's like M^2"), std::log2(far / near), 2,
      (films[0].minimum.error / std::abs(far) + films[1].minimum.error / std::abs(near)) / std::numbers::ln2 / 2,
      Tolerance::asymptotic(4 * heavier * heavier, "the next term: M^2 of the first, times its own constant over c1"),
      note));
  // rho H at the exit over the smallest film is 1.2257 for the rigid contact.
  found.claims.push_back(
      claim_value(says("couette", "Couette film at M = 0.1 is Martin's 3/M, within the departure of the minimum"),
                  films[1].couette.moes, 3 / lighter, films[1].couette.error,
                  Tolerance::asymptotic(lighter * lighter, "the departure: M^2 at most"), note));
  return found;
}

/// Full solutions lie above the Ertel-Grubin film by percentages that fall with M and L.
Findings judge_ertel_grubin() {
  struct Row {
    double M, L;
    const char* percent;
  };
  Findings found;
  for (const Row row : {Row{20, 5, "21"}, Row{20, 10, "9"}, Row{200, 10, "7"}, Row{200, 15, "4"}}) {
    const Films films = films_at(default_solver(), {row.M, row.L}, 1e-3);
    const double above = 100 * (films.central.moes / exact::ertel_grubin_film(row.M, row.L) - 1);
    const std::string point = fmt::format("{}-{}", plain(row.M), plain(row.L));
    Claim judged = claim({.id = "regimes/ertel-grubin/" + point,
                          .rung = 9,
                          .statement = fmt::format("the central film at M-L = {} lies {} % above Ertel and Grubin's",
                                                   point, row.percent),
                          .solver = default_solver().name},
                         std::abs(above - std::stod(row.percent)), 100 * films.central.error,
                         Tolerance::calibrated(0.5, "half a unit of the literature's percentage"), films.ended);
    judged.measured = above;
    judged.expected = std::stod(row.percent);
    found.claims.push_back(judged);
  }
  return found;
}

/// Isoviscous elastic: films times M^(1/5) that another program computed. It states 0.1 % up to M = 20 and 0.3 % at
/// 200, which is also taken at 400. It prints more digits.
Findings judge_isoviscous_elastic() {
  struct Row {
    double M, couette, minimum, uncertainty;
  };
  Findings found;
  for (const Row row : {Row{20, 2.584, 2.048, 1e-3}, Row{50, 2.534, 2.013, 3e-3}, Row{100, 2.514, 2.000, 3e-3},
                        Row{200, 2.5045, 1.994, 3e-3}, Row{400, 2.498, 1.991, 3e-3}}) {
    const Films films = films_at(default_solver(), {row.M, 0}, 1e-4);
    const double scale = std::pow(row.M, 0.2);
    for (const bool minimum : {false, true}) {
      const Film& film = minimum ? films.minimum : films.couette;
      const double expected = minimum ? row.minimum : row.couette;
      const std::string name = minimum ? "minimum" : "Couette";
      found.claims.push_back(
          claim_value({.id = fmt::format("regimes/isoviscous-elastic/{}/{}", plain(row.M), name),
                       .rung = 9,
                       .statement = fmt::format("the isoviscous elastic {} film times M^(1/5) at M = {} is {}", name,
                                                plain(row.M), plain(expected)),
                       .solver = default_solver().name},
                      film.moes * scale, expected, 0, Tolerance::discretisation(film.error + row.uncertainty, 1),
                      fmt::format("tolerance = reported error {} + the uncertainty of the computed films; {}",
                                  plain(film.error, 2), films.ended)));
    }
  }
  return found;
}

/// A film along a sequence of contacts that goes to a limit.
struct Approach {
  std::vector<GridValue> values;  ///< the parameter that grows, and the film over its expected power
  double error = 0;               ///< relative, the largest
  std::string ended;              ///< of the solves that did not converge
};

/// The limit, extrapolated by the remainder's leading power from the last two values. Its error: the next power is not
/// known, and a slow one leaves as much as the last change of the limit. The bound is twice that change, and the
/// solves' own errors as the extrapolation enlarges them.
struct Limit {
  double value = nothing, error = nothing, order = nothing;
};
Limit limit_of(const Approach& approach, double order) {
  const auto& v = approach.values;
  const std::size_t m = v.size();
  if (m < 4 || !approach.ended.empty()) return {};
  const auto by = [&](std::size_t i) {
    const double factor = std::expm1(order * std::log(v[i].cells / v[i - 1].cells));
    return v[i].value + (v[i].value - v[i - 1].value) / factor;
  };
  const GridStudy study = study_grids(v, order, 0);
  if (study.trend != Trend::asymptotic) return {};
  const double noise = approach.error * (1 + 2 / std::expm1(order * std::log(v[m - 1].cells / v[m - 2].cells)));
  return {by(m - 1), 2 * std::abs(by(m - 1) / by(m - 2) - 1) + noise, *study.observed_order};
}

/// M -> infinity at L = 0: films x M^(1/5). The remainder falls like the length of the inlet zone over that of the
/// contact, M^(-4/5).
Findings judge_isoviscous_elastic_limit() {
  constexpr double remainder = 0.8, tolerance = 1e-9;
  Approach couette, minimum, central;
  for (const double M : {250, 500, 1000, 2000, 4000, 8000, 16000}) {
    const Films films = films_at(certified_solver(), {M, 0}, tolerance);
    const double scale = std::pow(M, 0.2);
    for (auto [approach, film] :
         {std::pair{&couette, films.couette}, {&minimum, films.minimum}, {&central, films.central}}) {
      if (!std::isfinite(film.moes)) approach->ended += fmt::format("M = {} {}; ", plain(M), films.ended);
      approach->values.push_back({M, film.moes * scale});
      approach->error = worse(approach->error, film.error);
    }
  }
  struct Row {
    const char* name;
    const Approach* approach;
    const char* near;
    std::string digits;
  };
  Findings found;
  const Limit flux = limit_of(couette, remainder);
  for (const Row& row :
       {Row{"Couette", &couette, "2.49", couette_limit}, Row{"minimum", &minimum, "1.98", smallest_limit}}) {
    const Limit limit = limit_of(*row.approach, remainder);
    const std::string note =
        fmt::format("{} +- {}, remainder M^-{}, M = 250 ... 16000; {}", plain(limit.value, 9),
                    plain(limit.value * limit.error, 2), plain(limit.order, 5), row.approach->ended);
    const auto says = [&](const std::string& what, const std::string& statement) {
      return Sentence{.id = fmt::format("regimes/isoviscous-elastic-limit/{}/{}", row.name, what),
                      .rung = 9,
                      .statement = statement,
                      .solver = certified_solver().name};
    };
    const std::string film = "isoviscous elastic " + std::string(row.name) + " film times M^(1/5)";
    found.claims.push_back(claim_value(
        says("order", "the " + film + " goes to its limit like M^(-4/5)"), limit.order, remainder, 0,
        Tolerance::asymptotic(0.01, "the next power is a further M^(-2/5) or smaller, 2 % at 16000"), note));
    found.claims.push_back(claim_value(
        says("printed", fmt::format("the limit of the {} is the one that README.md prints, {}", film, row.digits)),
        limit.value, std::stod(row.digits), limit.error, Tolerance::published_digits(row.digits), note));
    Claim known = claim(
        says("digits", fmt::format("the limit of the {}, {} ..., is known to five digits or more", film, row.near)),
        limit.error, 0, Tolerance::required(5e-6, "half a unit of the fifth digit and better than three digits"), note);
    known.measured = limit.value;
    known.finding = true;
    found.claims.push_back(known);
  }
  const Limit middle = limit_of(central, remainder);
  found.claims.push_back(claim_value({.id = "regimes/isoviscous-elastic-limit/central",
                                      .rung = 9,
                                      .statement = "central and Couette film have one limit as M grows",
                                      .solver = certified_solver().name},
                                     middle.value, flux.value, middle.error + flux.error,
                                     Tolerance::required(5e-6, "half a unit of the fifth digit"), ""));
  return found;
}

/// At a fixed load M = 1 the film grows with L like Blok's. The deflection stays, so that the remainder falls like
/// 1/film, L^(-2/3). (M -> 0 first is Martin's limit.)
Findings judge_blok() {
  constexpr double M = 1, tolerance = 1e-4;
  const exact::Blok blok;
  Findings found;
  std::vector<double> L, couette, minimum;
  double error = 0;
  std::string ended;
  for (const double stiff : {25.0, 35.0, 50.0, 70.0}) {
    const Films films = films_at(certified_solver(), {M, stiff}, tolerance);
    if (!std::isfinite(films.couette.moes)) ended += fmt::format("L = {} {}; ", plain(stiff), films.ended);
    const double scale = std::pow(stiff, -2.0 / 3);
    L.push_back(stiff);
    couette.push_back(films.couette.moes * scale / blok.couette - 1);
    minimum.push_back(films.minimum.moes * scale / blok.minimum - 1);
    error = worse(error, films.couette.error, films.minimum.error);
  }
  for (const bool smallest : {false, true}) {
    const auto& above = smallest ? minimum : couette;
    const std::string name = smallest ? "minimum" : "Couette";
    bool falls = true;
    std::string note = "above Blok's by";
    for (std::size_t i = 0; i < above.size(); ++i) {
      note += fmt::format(" {} (L = {})", percent(above[i], 3), plain(L[i]));
      falls = falls && above[i] > error && (i == 0 || above[i] < above[i - 1] - 2 * error);
    }
    const double order = -std::log(above.back() / above.front()) / std::log(L.back() / L.front());
    note += fmt::format("; like L^-{}; {}", plain(order, 3), ended);
    found.claims.push_back(claim_fact({.id = "regimes/blok/" + name,
                                       .rung = 9,
                                       .statement = "at M = 1 the " + name + " film comes down to Blok's as L grows",
                                       .solver = certified_solver().name},
                                      falls && ended.empty(), "the rigid piezoviscous limit", note));
    if (smallest) continue;
    const double limit = above[3] + (above[3] - above[1]) / std::expm1(2.0 / 3 * std::log(L[3] / L[1]));
    const double next = std::pow(L[1] * L[3], -2.0 / 3);
    found.claims.push_back(
        claim_value({.id = "regimes/blok/limit",
                     .rung = 9,
                     .statement = "at M = 1 the Couette film over Blok's goes to 1 as L grows",
                     .solver = certified_solver().name},
                    1 + limit, 1, 3 * error,
                    Tolerance::asymptotic(next,
                                          "extrapolated from L = 35 and 70 by s = L^(-2/3), which leaves c s_1 s_2 of "
                                          "the next term c s^2, with c of order one"),
                    note));
  }
  return found;
}

/// The central film lies above Ertel and Grubin's, by a remainder that falls with M and with L.
Findings judge_ertel_grubin_trend() {
  constexpr double tolerance = 1e-4;
  const double all_M[] = {20, 50, 200, 1000}, all_L[] = {5, 10, 20};
  double above[3][4], error = 0;
  std::string note = "above by", ended;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Films films = films_at(certified_solver(), {all_M[j], all_L[i]}, tolerance);
      above[i][j] = films.central.moes / exact::ertel_grubin_film(all_M[j], all_L[i]) - 1;
      if (!std::isfinite(above[i][j]))
        ended += fmt::format("M = {}, L = {} {}; ", plain(all_M[j]), plain(all_L[i]), films.ended);
      error = worse(error, films.central.error);
      note += " " + percent(above[i][j], 3);
    }
    note += i < 2 ? ";" : "";
  }
  bool positive = true, with_M = true, with_L = true;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      positive = positive && above[i][j] > 2 * error;
      with_M = with_M && (j == 0 || above[i][j] < above[i][j - 1] - 2 * error);
      with_L = with_L && (i == 0 || above[i][j] < above[i - 1][j] - 2 * error);
    }
  }
  note += " at M = 20, 50, 200, 1000 for L = 5; 10; 20. " + ended;
  Findings found;
  const auto fact = [&](const std::string& what, const std::string& statement, bool holds) {
    found.claims.push_back(claim_fact({.id = "regimes/ertel-grubin-trend/" + what,
                                       .rung = 9,
                                       .statement = statement,
                                       .solver = certified_solver().name},
                                      holds && ended.empty(),
                                      "the inlet model's limit of heavy loads and steep viscosities", note));
  };
  fact("above", "central films lie above Ertel and Grubin's", positive);
  fact("load", "the excess of a central film over Ertel and Grubin's falls as M grows", with_M);
  fact("viscosity", "the excess of a central film over Ertel and Grubin's falls as L grows", with_L);
  return found;
}

}  // namespace

std::vector<Topic> regime_topics() {
  return {{.name = "Martin limit", .rungs = {9}, .judge = [] { return judge_martin(certified_solver()); }},
          {.name = "Martin limit", .rungs = {9}, .judge = [] { return judge_martin(default_solver()); }},
          {.name = "Ertel-Grubin", .rungs = {9}, .judge = judge_ertel_grubin},
          {.name = "Ertel-Grubin", .rungs = {9}, .slow = true, .judge = judge_ertel_grubin_trend, .expected_s = 12},
          {.name = "Blok limit", .rungs = {9}, .slow = true, .judge = judge_blok},
          {.name = "isoviscous elastic", .rungs = {9}, .judge = judge_isoviscous_elastic},
          {.name = "isoviscous elastic limit", .rungs = {9}, .judge = judge_isoviscous_elastic_limit}};
}

}  // namespace ehd::verification
