// SPDX-License-Identifier: GPL-3.0-or-later
// The box of line contacts that claims, stress tests, benchmarks and the atlas go over: loads M, materials L, two law
// sets, flooded and cut inlets. The walk over such a box stands here, once; each user gives its own M and L.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/nondimensional.hpp"

namespace ehd::verification {

inline constexpr double box_lightest_M = 0.05, box_heaviest_M = 5000, box_largest_L = 30;
inline constexpr double oil_alpha_per_Pa = 2.2e-8;  ///< pressure-viscosity coefficient: it gives p_H in Pa
inline constexpr double highest_pressure_Pa = 4e9;  ///< p_H; a contact above it is a numerical test
inline constexpr double usual_cut = -4;             ///< X of a cut inlet, in Hertz half-widths

/// The two law sets. Roelands: z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa, with Dowson and Higginson's density.
/// Barus: incompressible; at L = 0 it is isoviscous.
[[nodiscard]] Lubricant oil(bool roelands);
[[nodiscard]] std::string law_name(bool roelands);  ///< "Roelands", "Barus"

[[nodiscard]] Problem problem_at(MoesGroups moes, bool roelands, Inlet inlet);

/// p_H of a contact that is stated by groups, with the alpha above [Pa]; 0 at L = 0.
[[nodiscard]] double hertz_pressure_Pa(const Groups& groups);

struct BoxContact {
  MoesGroups moes;
  bool roelands = true;
  Inlet inlet = Flooded{};

  [[nodiscard]] bool flooded() const { return std::holds_alternative<Flooded>(inlet); }
  [[nodiscard]] Problem problem() const { return problem_at(moes, roelands, inlet); }
  [[nodiscard]] std::string name() const;  ///< "M = 20, L = 10, Roelands": without the inlet
};

/// What a walk goes over.
struct Box {
  std::vector<double> M, L;
  std::vector<bool> roelands = {true, false};
  std::vector<bool> flooded = {true, false};  ///< false: cut
  double lightest_cut_M = 0;                  ///< a lighter contact is not cut
  /// X of a cut inlet; `usual_cut` where it is empty.
  std::function<double(const MoesGroups&)> cut = {};
};
/// THE walk: every contact of the box, by law set, inlet, M and L, each in the order given.
[[nodiscard]] std::vector<BoxContact> contacts_of(const Box& box);

/// 0.05, 0.1, 0.2, 0.5, ... 5000: those of them from `lightest` to `heaviest`.
[[nodiscard]] std::vector<double> round_loads(double lightest, double heaviest);

}  // namespace ehd::verification
