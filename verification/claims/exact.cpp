// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 4: the exact solutions satisfy their own equations, and have the digits that the literature prints.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "verification/claims/topics.hpp"
#include "verification/exact/blok.hpp"
#include "verification/exact/ertel_grubin.hpp"
#include "verification/exact/martin.hpp"
#include "verification/exact/numerics.hpp"

namespace ehd::verification {

namespace {

void digits(Findings& found, const std::string& id, const std::string& what, double value, const std::string& printed) {
  found.claims.push_back(claim_value(
      {.id = "exact/" + id, .rung = 4, .statement = fmt::format("{} has the printed digits {}", what, printed)}, value,
      std::stod(printed), 0, Tolerance::published_digits(printed)));
}

Findings judge_exact() {
  Findings found;
  const exact::Martin martin;
  const auto slope = [&](double X) {
    const double H = 1 + X * X;
    return 12 * (H - martin.exit_film) / (H * H * H);
  };
  const double at_exit =
      exact::integral_to_infinity([&](double t) { return slope(-t); }, 0) + exact::integral(slope, 0, martin.exit);
  found.claims.push_back(
      claim({.id = "exact/martin-exit",
             .rung = 4,
             .statement = "Martin's pressure, by quadrature of Reynolds' equation, ends at his exit"},
            std::abs(at_exit) / martin.pressure_max, 0, Tolerance::discretisation(1e-13, 10)));
  digits(found, "martin-load", "Martin's load h_0 w/(eta u_m R)", martin.load_mean, "4.894968494");
  digits(found, "martin-exit-film", "Martin's exit film over the smallest", martin.exit_film, "1.225748441");
  digits(found, "martin-pressure", "Martin's largest pressure", martin.pressure_max, "1.520945584");
  digits(found, "martin-rolling-force", "Martin's rolling force over sqrt(U_s W)", martin.rolling_force, "1.470515");
  found.claims.push_back(claim_value({.id = "exact/martin-exit-place",
                                      .rung = 4,
                                      .statement = "Martin's exit X_c has the printed digits 0.4751299200930562"},
                                     martin.exit, 0.4751299200930562, 0, Tolerance::round_off(16)));
  // Printed as 25.41379133: cut, not rounded, so a whole unit of the last digit is allowed.
  constexpr double printed_degrees = 25.41379133, unit = 1e-8;
  found.claims.push_back(
      claim_value({.id = "exact/martin-exit-angle",
                   .rung = 4,
                   .statement = "Martin's exit stands at 25.41379133 degrees (cut, not rounded)"},
                  martin.exit_angle * 180 / std::numbers::pi, printed_degrees, 0,
                  Tolerance::calibrated(unit / printed_degrees, "a unit of the last printed digit")));
  digits(found, "martin-load-sum", "Martin's load with the sum speed", martin.load_sum, "2.447484");
  found.claims.push_back(claim_value(
      {.id = "exact/martin-pressure-at-0", .rung = 4, .statement = "Martin's pressure at x = 0 is half of the largest"},
      martin.pressure_at_0, martin.pressure_max / 2, 0, Tolerance::round_off(64)));
  digits(found, "martin-rolling-force-moes", "Martin's T* M", exact::MartinContact(1).rolling_force, "1.4475");
  // Full Sommerfeld: with h_exit = 4/3 h_0 the pressure goes back to zero far behind the contact. So it is odd and
  // carries nothing.
  const auto sommerfeld = [](double X) {
    const double H = 1 + X * X;
    return 12 * (H - 4.0 / 3) / (H * H * H);
  };
  const double turn = std::sqrt(1.0 / 3), down = exact::integral(sommerfeld, 0, turn),
               up = exact::integral_to_infinity(sommerfeld, turn);
  found.claims.push_back(claim({.id = "exact/full-sommerfeld",
                                .rung = 4,
                                .statement = "full Sommerfeld's pressure is odd and carries no load: h_exit = 4/3 h_0"},
                               std::abs(down + up) / std::abs(down), 0, Tolerance::discretisation(1e-13, 10)));
  const exact::Blok blok;
  digits(found, "blok-couette", "Blok's Couette film over L^(2/3)", blok.couette, "1.28667");
  digits(found, "blok-minimum", "Blok's minimum film over L^(2/3)", blok.minimum, "1.04970");
  for (const auto& [M, L, printed] :
       {std::tuple{20, 10, "4.8350"}, std::tuple{50, 10, "4.4009"}, std::tuple{100, 10, "4.0755"},
        std::tuple{200, 10, "3.7614"}, std::tuple{20, 5, "2.9083"}, std::tuple{200, 15, "5.0871"},
        std::tuple{1000, 10, "3.0984"}, std::tuple{1000, 20, "5.2039"}}) {
    const std::string point = fmt::format("{}-{}", M, L);
    digits(found, "ertel-grubin-" + point, "the Ertel-Grubin film at M-L = " + point, exact::ertel_grubin_film(M, L),
           printed);
  }
  return found;
}

}  // namespace

std::vector<Topic> exact_topics() { return {{.name = "exact", .rungs = {4}, .judge = judge_exact}}; }

}  // namespace ehd::verification
