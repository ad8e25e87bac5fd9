// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the film vanishes as the speed does, and the full relation becomes a dry law.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;

/// With Lundberg's datum, x_0 = l, the full relation without a film is Lundberg's law.
Findings judge_zero_speed(const Case& bearing_case, ContactMemory& memory) {
  std::vector<std::pair<double, double>> by_speed;  // rpm, relative difference of the displacement
  double bound = nothing;
  for (const double rpm : {500.0, 5.0, 0.05}) {
    Case slow = bearing_case;
    auto& body = std::get<BearingCase>(slow.body);
    body.operation.inner_speed_rpm = rpm;
    body.operation.outer_speed_rpm = 0;
    body.datum = LundbergDatum{};
    body.fit = {};
    const auto results = run_bearing(
        slow, {.laws = {bearing::Law::lundberg, bearing::Law::ehd}, .explicitly = true, .films = false}, memory);
    if (results.size() != 2 || results[0].rollers.empty() || results[1].rollers.empty() || !results[1].curve) continue;
    const double dry = results[0].displacement_m;
    by_speed.emplace_back(rpm, std::abs(results[1].displacement_m / dry - 1));
    // Approaches that change by g at the same forces move the ring by Sum k g cos/Sum k cos^2. That is at most the
    // largest g/cos.
    bound = 0;
    for (const RollerRow& roller : results[1].rollers) {
      if (!bearing::is_loaded(roller.inner.force_N, results[1].rollers.front().inner.force_N)) continue;
      const double films_m = results[1].curve->inner.offset_film(roller.inner.force_N).value +
                             results[1].curve->outer.offset_film(roller.outer.force_N).value;
      bound = worse(bound, films_m / std::cos(roller.azimuth_deg * pi / 180) / dry);
    }
  }
  const bool all = by_speed.size() == 3;
  std::string about;
  for (const auto& [rpm, difference] : by_speed)
    about += fmt::format("{}{} at {} rpm", about.empty() ? "" : ", ", plain(difference, 3), plain(rpm));
  Findings found;
  found.claims.push_back(
      claim(sentence("zero-speed/" + bearing_case.id,
                     "towards rest a balance by `ehd` with Lundberg's datum becomes that of the dry law `lundberg`"),
            all ? by_speed[2].second : nothing, 0,
            Tolerance::asymptotic(
                bound, "largest offset films over cos psi of a roller in the load zone, over the displacement"),
            about));
  found.claims.push_back(
      claim_fact(sentence("zero-speed/" + bearing_case.id + "/falls", "and nears it with every step down"),
                 all && by_speed[1].second < 0.2 * by_speed[0].second && by_speed[2].second < 0.2 * by_speed[1].second,
                 "a hundredth of the speed, a fifth of the difference at most", about));
  return found;
}

}  // namespace ehd::verification::bearing_parts
