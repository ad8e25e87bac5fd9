// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the film curve of the law ehd, from the heaviest roller to the rigid cylinder.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/exact/martin.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

/// Rollers of a balance by the full relation, at heavy, medium and light loads.
Findings judge_curve(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .films = true}, memory);
  Findings found;
  const bool balanced = results.size() == 1 && !results[0].rollers.empty() && results[0].datum_m;
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const std::string id = fmt::format("curve/{}/{}", bearing_case.id, raceway_name(inner));
    const std::string at = ", " + raceway_name(inner) + " raceway";
    const auto martin_film_m = [&](double force_N) {
      return exact::Martin{}.load_sum * body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s * contact.radius_m *
             contact.length_m / force_N;
    };
    double approach_error = balanced ? 0 : nothing, film_error = balanced ? 0 : nothing, martin_error = nothing;
    int judged = 0;
    if (balanced) {
      const double datum = one_of(*results[0].datum_m, inner);
      double lightest = std::numeric_limits<double>::infinity();
      for (const RollerRow& roller : results[0].rollers) {
        const ContactRow& row = one_of(roller, inner);
        if (row.force_N >= lightest) continue;  // one of each pair, and the lightest last
        lightest = row.force_N;
        const SolvedByHand truth = solved_by_hand(body, inner, row.force_N);
        approach_error =
            worse(approach_error,
                  std::abs((dry_m(contact, row.force_N, datum) - row.displacement_m) / truth.offset_film_m - 1));
        film_error = worse(film_error, std::abs(row.film_minimum_m.value_or(nothing) / truth.film_minimum_m - 1));
        martin_error = std::abs(row.film_minimum_m.value_or(nothing) / martin_film_m(row.force_N) - 1);
        ++judged;
      }
    }
    // Elasticity adds a few per cent at the lightest solved load, and a thousandth of that at a hundredth of the load.
    double rigid_error = nothing;
    if (balanced && results[0].curve) {
      const bearing::FilmCurve& curve = one_of(*results[0].curve, inner);
      const double force = curve.lightest_N() / 100, martin = martin_film_m(force);
      rigid_error = worse(std::abs(curve.minimum_film(force).value / martin - 1),
                          std::abs(curve.offset_film(force).value / martin - 1));
    }
    found.claims.push_back(
        claim(sentence(id + "/rigid", "far below its lightest contact the curve has the film of a rigid cylinder" + at),
              rigid_error, 0, Tolerance::asymptotic(1e-3, "5 % x 100^(-3/2), and twenty times that")));
    const std::string about = fmt::format("{} loads, of the heaviest to the lightest roller", judged);
    found.claims.push_back(
        claim(sentence(id + "/approach",
                       "a balance by `ehd` has the approaches that `reference` finds at its rollers' loads" + at),
              approach_error, 0, film_tolerance(), about));
    found.claims.push_back(
        claim(sentence(id + "/film", "and the smallest films" + at), film_error, 0, film_tolerance(), about));
    found.claims.push_back(claim(
        sentence(id + "/martin", "the lightest roller's film is nearly that of a rigid cylinder" + at), martin_error, 0,
        Tolerance::asymptotic(0.05, "M < 0.1: elasticity and pressure add a few per cent at most")));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
