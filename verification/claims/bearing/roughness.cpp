// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the lambda ratio of a roller contact, minimum film over composite roughness.
#include <fmt/format.h>

#include <cmath>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

Findings judge_roughness(const Case& bearing_case, ContactMemory& memory) {
  constexpr double roughness_m = 0.17e-6;
  Case rough = bearing_case;
  auto& body = std::get<BearingCase>(rough.body);
  body.roughness_m = roughness_m;
  const auto results = run_bearing(rough, {.laws = {bearing::Law::ehd_linear}, .films = true}, memory);
  Findings found;
  for (const bool inner : {true, false}) {
    double ratio_error = nothing;
    if (results.size() == 1 && !results[0].rollers.empty()) {
      const ContactRow& row = one_of(results[0].rollers.front(), inner);
      const double film_m = solved_by_hand(body, inner, row.force_N).film_minimum_m;
      ratio_error = std::abs(row.lambda_ratio.value_or(nothing) / (film_m / roughness_m) - 1);
    }
    found.claims.push_back(
        claim(sentence(fmt::format("roughness/{}/{}", bearing_case.id, raceway_name(inner)),
                       "roller 1's lambda ratio is the film that `reference` finds at its load over the roughness, " +
                           raceway_name(inner) + " raceway"),
              ratio_error, 0, film_tolerance()));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
