// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the datum x_0 of the approach, for each way to state it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

namespace {

/// f in N and delta in m by Palmgren, as rounded in print.
double palmgren_m(double force_N, double length_m) {
  return 1e-3 * std::pow(force_N / (8.06e4 * std::pow(1e3 * length_m, 8.0 / 9)), 0.9);
}

}  // namespace

Findings judge_datum(const Case& bearing_case, ContactMemory& memory) {
  Findings found;
  const auto run = [&](const Datum& datum) {
    Case one = bearing_case;
    std::get<BearingCase>(one.body).datum = datum;
    return run_bearing(one, {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .films = false}, memory);
  };
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto datum_of = [](const std::vector<BearingResult>& results, bool inner) {
    if (results.size() != 2 || !results[1].datum_m) return nothing;
    return one_of(*results[1].datum_m, inner);
  };
  constexpr double named_N = 7300, length_m = 0.0173;
  const auto by_default = run(PalmgrenDatum{}), named = run(PalmgrenDatum{named_N}), lundberg = run(LundbergDatum{}),
             stated = run(LengthDatum{length_m});
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const std::string raceway = raceway_name(inner), at = ", " + raceway + " raceway";
    double largest = nothing;
    if (!by_default.empty() && !by_default[0].rollers.empty()) {
      largest = 0;
      for (const RollerRow& roller : by_default[0].rollers) largest = std::max(largest, roller.inner.force_N);
    }
    for (const auto& [name, results, force] :
         {std::tuple{"palmgren", &by_default, largest}, std::tuple{"palmgren-load", &named, named_N}}) {
      found.claims.push_back(claim_value(
          sentence(fmt::format("datum/{}/{}", name, raceway),
                   fmt::format("with Palmgren's datum the dry log kernel has Palmgren's approach at the {}{}",
                               name == std::string("palmgren") ? "largest dry roller load" : "load that is named", at)),
          dry_m(contact, force, datum_of(*results, inner)), palmgren_m(force, contact.length_m), 0,
          Tolerance::round_off(64, 20), "the datum is the exponential of twenty"));
    }
    found.claims.push_back(
        claim_value(sentence("datum/lundberg/" + raceway, "Lundberg's datum is the length of the roller" + at),
                    datum_of(lundberg, inner), contact.length_m, 0, rounding()));
    found.claims.push_back(claim_value(sentence("datum/x0/" + raceway, "a datum that is stated is used" + at),
                                       datum_of(stated, inner), length_m, 0, rounding()));
  }
  return found;
}

}  // namespace ehd::verification::bearing_parts
