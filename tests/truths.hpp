// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts whose films are known: Roelands z = 0.68, alpha = 2.2e-8 1/Pa, p_0 = 1.96e8 Pa, Dowson-Higginson density.
// The cases own-moes-* hold the same digits, which claims judge.
#pragma once

#include <stdexcept>

#include "contact/problem.hpp"

namespace ehd {

/// Films in Hertz units by high-order collocation, with ten digits and more. The inlet is flooded or cut at X = -4.
struct Truth {
  double M, L;
  bool flooded;
  double minimum, central;
  double known_to = 4e-11;  ///< half a unit of the last digit, relative, of the film with fewer digits
};
inline constexpr Truth truths[] = {
    {5, 5, false, .242348656788, .300522502074},
    {20, 10, false, .0741426753998, .0856067317967},
    {100, 10, false, .0121609125334, .013493910275},
    {200, 15, false, .0072455216009, .0078653033017},
    {5, 5, true, .244974049968, .304553206653},
    {20, 10, true, .074327072817, .085869387723},
    {100, 10, true, .0121636414018, .013497647172},
    {200, 15, true, .0072463876853, .0078664543505},
    {1000, 10, false, 8.9959560167e-4, 9.6476425613e-4},
    {1000, 20, false, 1.436646952e-3, 1.537475954e-3, 5e-10},
    {1000, 10, true, 8.996019841e-4, 9.647726835e-4, 6e-11},
};
/// Of the row with the fewest digits.
inline constexpr double truths_known_to = 5e-10;

/// The row of a contact. Throws where there is none.
constexpr Truth truth_at(double M, double L, bool flooded = false) {
  for (const Truth& truth : truths)
    if (truth.M == M && truth.L == L && truth.flooded == flooded) return truth;
  throw std::invalid_argument("there is no such truth");
}

inline Inlet inlet_of(const Truth& truth) { return truth.flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{-4}}; }

}  // namespace ehd
