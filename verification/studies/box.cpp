// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/box.hpp"

#include <fmt/format.h>

#include "contact/text.hpp"

namespace ehd::verification {

Lubricant oil(bool roelands) {
  if (!roelands) return {};
  return {.viscosity = ViscosityLaw::roelands,
          .density = DensityLaw::dowson_higginson,
          .alpha_per_Pa = oil_alpha_per_Pa,
          .z = 0.68,
          .p0_Pa = 1.96e8};
}

std::string law_name(bool roelands) { return roelands ? "Roelands" : "Barus"; }

Problem problem_at(MoesGroups moes, bool roelands, Inlet inlet) {
  return nondimensionalise(moes, oil(roelands), inlet).problem;
}

double hertz_pressure_Pa(const Groups& groups) { return groups.alpha_p_H / oil_alpha_per_Pa; }

std::string BoxContact::name() const {
  return fmt::format("M = {}, L = {}, {}", plain(moes.M), plain(moes.L), law_name(roelands));
}

std::vector<BoxContact> contacts_of(const Box& box) {
  std::vector<BoxContact> contacts;
  for (const bool roelands : box.roelands) {
    for (const bool flooded : box.flooded) {
      for (const double M : box.M) {
        if (!flooded && M < box.lightest_cut_M) continue;
        for (const double L : box.L) {
          const MoesGroups moes{.M = M, .L = L};
          Inlet inlet = Flooded{};
          if (!flooded) inlet = TruncatedAt{box.cut ? box.cut(moes) : usual_cut};
          contacts.push_back({.moes = moes, .roelands = roelands, .inlet = inlet});
        }
      }
    }
  }
  return contacts;
}

std::vector<double> round_loads(double lightest, double heaviest) {
  std::vector<double> loads;
  for (const double M : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1e3, 2e3, 5e3}) {
    if (M >= lightest && M <= heaviest) loads.push_back(M);
  }
  return loads;
}

}  // namespace ehd::verification
