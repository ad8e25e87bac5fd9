// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts whose films are known, and what is read off a solution.
#pragma once

#include "contact/solution.hpp"
#include "tests/fast/problems.hpp"

namespace ehd {

/// Films in Hertz units by high-order collocation, with ten digits and more.
struct Truth {
  double M, L;
  bool flooded;
  double minimum, central;
};
inline constexpr Truth truths[] = {
    {5, 5, false, .242348656788, .300522502074},         {20, 10, false, .0741426753998, .0856067317967},
    {100, 10, false, .0121609125334, .013493910275},     {200, 15, false, .0072455216009, .0078653033017},
    {5, 5, true, .244974049968, .304553206653},          {20, 10, true, .074327072817, .085869387723},
    {100, 10, true, .0121636414018, .013497647172},      {200, 15, true, .0072463876853, .0078664543505},
    {1000, 10, false, 8.9959560167e-4, 9.6476425613e-4}, {1000, 20, false, 1.436646952e-3, 1.537475954e-3},
    {1000, 10, true, 8.996019841e-4, 9.647726835e-4},
};

inline Problem problem_of(const Truth& truth) {
  return roelands_problem(truth.M, truth.L, truth.flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{-4}});
}

inline double film(const Solution& solution, Quantity quantity) { return solution.observables.at(quantity).value; }
inline double reported(const Solution& solution, Quantity quantity) {
  return solution.observables.at(quantity).error.value();
}

}  // namespace ehd
