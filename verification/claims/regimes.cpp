// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 9: the corners of Moes' diagram, approached.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "contact/scaling.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/ertel_grubin.hpp"
#include "verification/exact/martin.hpp"
#include "verification/registry.hpp"
#include "verification/text.hpp"

namespace ehd::verification {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A film in Moes units with the solver's own relative error; NaN where the solve did not end as converged.
struct Film {
  double moes = nothing;
  double error = nothing;
};

struct Films {
  Film minimum, central, couette;
  std::string ended;
};

/// Barus (or isoviscous at L = 0), incompressible, flooded.
Films films_at(const char* solver, MoesGroups moes, double tolerance) {
  const Lubricant lubricant{.viscosity = moes.L > 0 ? ViscosityLaw::barus : ViscosityLaw::isoviscous,
                            .density = DensityLaw::incompressible,
                            .alpha_per_Pa = {},
                            .z = {}};
  Request request;
  request.tolerance = tolerance;
  const Solution solution =
      find_solver(solver)->solve(nondimensionalise(moes, lubricant, Flooded{}).problem, request);
  Films films;
  films.ended = std::string(to_string(solution.record.status)) +
                (solution.record.reason.empty() ? "" : ": " + solution.record.reason);
  if (solution.record.status != StopReason::converged) return films;
  const double unit = moes_film_per_hertz_film(moes.M);
  // A solver need not state an error of the Couette film; it is as good as the central one, being the same flux.
  const double central_error = solution.record.film_central.total();
  const auto film = [&](Quantity quantity) {
    const auto at = solution.observables.find(quantity);
    if (at == solution.observables.end()) return Film{};
    return Film{at->second.value * unit, at->second.error.value_or(central_error)};
  };
  films.minimum = film(Quantity::film_minimum);
  films.central = film(Quantity::film_central);
  films.couette = film(Quantity::film_couette);
  return films;
}

/// Rigid isoviscous: deformation by a pressure of given load and shape is a fixed length, Martin's film grows like
/// 1/M^2 in those units, so the departure is c M^2 with the next term M^4.
Findings judge_martin(const char* solver) {
  constexpr double heavier = 0.2, lighter = 0.1, tolerance = 1e-5;
  const Films films[] = {films_at(solver, {heavier, 0}, tolerance), films_at(solver, {lighter, 0}, tolerance)};
  const auto departure = [&](int i, double M) { return films[i].minimum.moes / exact::MartinContact(M).moes_minimum - 1; };
  const double far = departure(0, heavier), near = departure(1, lighter);
  const double uncertainty = (films[0].minimum.error + 4 * films[1].minimum.error) / 3;
  const std::string note = "departures " + plain(far, 4) + " at M = 0.2, " + plain(near, 4) + " at 0.1; " +
                           films[0].ended + ", " + films[1].ended;
  const auto says = [&](const std::string& what, const std::string& statement) {
    return Sentence{.id = "regimes/martin/" + std::string(solver) + "/" + what,
                    .rung = 9,
                    .statement = statement,
                    .solver = solver};
  };
  Findings found;
  found.claims.push_back(claim_value(
      says("limit", std::string(solver) + "'s minimum film over Martin's goes to 1 as M vanishes"),
      1 + (4 * near - far) / 3, 1, uncertainty,
      Tolerance::asymptotic(far * far, "extrapolated from M = 0.2 and 0.1; the next term is M^4, the departure squared"),
      note));
  found.claims.push_back(claim_value(
      says("order", std::string(solver) + "'s minimum film departs from Martin's like M^2"), std::log2(far / near), 2,
      (films[0].minimum.error / std::abs(far) + films[1].minimum.error / std::abs(near)) / std::numbers::ln2 / 2,
      Tolerance::asymptotic(4 * std::abs(far), "the next term: relative to the first, a few times the departure"), note));
  // rho H at the exit over the smallest film is 1.2257 for the rigid contact.
  found.claims.push_back(
      claim_value(says("couette", std::string(solver) + "'s Couette film at M = 0.1 is Martin's 3/M, within the departure of the minimum"),
                  films[1].couette.moes, 3 / lighter, films[1].couette.error,
                  Tolerance::asymptotic(2 * std::abs(near), "twice the departure of the minimum film"), note));
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
    const Films films = films_at("fast", {row.M, row.L}, 1e-3);
    const double above = 100 * (films.central.moes / exact::ertel_grubin_film(row.M, row.L) - 1);
    const std::string point = plain(row.M) + "-" + plain(row.L);
    Claim judged = claim({.id = "regimes/ertel-grubin/" + point,
                          .rung = 9,
                          .statement = "the central film at M-L = " + point + " lies " + row.percent +
                                       " % above Ertel and Grubin's",
                          .solver = "fast"},
                         std::abs(above - std::stod(row.percent)), 100 * films.central.error,
                         Tolerance::calibrated(0.5, "half a unit of the literature's percentage"), films.ended);
    judged.measured = above;
    judged.expected = std::stod(row.percent);
    found.claims.push_back(judged);
  }
  return found;
}

/// Isoviscous elastic: films times M^(1/5), computed by another program, which is good to 0.1 % up to M = 20 and to 0.3 %
/// at 200 (more digits are printed).
Findings judge_isoviscous_elastic() {
  struct Row {
    double M, couette, minimum, uncertainty;
  };
  Findings found;
  for (const Row row : {Row{20, 2.584, 2.048, 1e-3}, Row{50, 2.534, 2.013, 3e-3}, Row{100, 2.514, 2.000, 3e-3},
                        Row{200, 2.5045, 1.994, 3e-3}}) {
    const Films films = films_at("fast", {row.M, 0}, 1e-4);
    const double scale = std::pow(row.M, 0.2);
    for (const bool minimum : {false, true}) {
      const Film& film = minimum ? films.minimum : films.couette;
      const double expected = minimum ? row.minimum : row.couette;
      const std::string name = minimum ? "minimum" : "Couette";
      found.claims.push_back(claim_value({.id = "regimes/isoviscous-elastic/" + plain(row.M) + "/" + name,
                                          .rung = 9,
                                          .statement = "the isoviscous elastic " + name + " film times M^(1/5) at M = " +
                                                       plain(row.M) + " is " + plain(expected),
                                          .solver = "fast"},
                                         film.moes * scale, expected, 0,
                                         Tolerance::discretisation(film.error + row.uncertainty, 1),
                                         "tolerance = reported error " + plain(film.error, 2) +
                                             " + the uncertainty of the computed films; " + films.ended));
    }
  }
  return found;
}

}  // namespace

std::vector<Topic> regime_topics() {
  return {{.name = "Martin limit", .rungs = {9}, .judge = [] { return judge_martin("reference"); }},
          {.name = "Martin limit", .rungs = {9}, .judge = [] { return judge_martin("fast"); }},
          {.name = "Ertel-Grubin", .rungs = {9}, .judge = judge_ertel_grubin},
          {.name = "isoviscous elastic", .rungs = {9}, .judge = judge_isoviscous_elastic}};
}

}  // namespace ehd::verification
