// SPDX-License-Identifier: GPL-3.0-or-later
// The problems of contacts whose films are known, and what is read off a solution.
#pragma once

#include "contact/solution.hpp"
#include "tests/fast/problems.hpp"
#include "tests/truths.hpp"

namespace ehd {

inline Problem problem_of(const Truth& truth) { return roelands_problem(truth.M, truth.L, inlet_of(truth)); }

inline double film(const Solution& solution, Quantity quantity) { return solution.observables.at(quantity).value; }
inline double reported(const Solution& solution, Quantity quantity) {
  return solution.observables.at(quantity).error.value();
}

}  // namespace ehd
