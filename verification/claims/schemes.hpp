// SPDX-License-Identifier: GPL-3.0-or-later
// The discretisation of each second-order solver, evaluated at a state that the caller gives. Rungs 3 and 4 judge it.
#pragma once

#include <functional>
#include <memory>

#include "contact/array.hpp"
#include "contact/problem.hpp"

namespace ehd::verification::schemes {

inline constexpr double any_M = 3.7;  ///< any: lambda is a factor of the pressure
inline constexpr double inlet = -1.9;

/// What a scheme computes from a state, on nodes and faces. Empty where its film is not positive.
struct Scheme {
  Array X, H, wedge, mobility;
  Array residual;  ///< the flux minus the flux at the exit
};

/// Sources that make the film of the undeformed surfaces any function.
[[nodiscard]] std::shared_ptr<const Sources> sources_for(std::function<double(double)> film);
/// An isoviscous contact with that film, cut at `inlet`.
[[nodiscard]] Problem rigid_problem(std::function<double(double)> film);

enum class Kind { reference_uniform, reference_graded, fast_uniform, fast_mapped };
struct Named {
  Kind kind;
  const char* solver;
};
inline constexpr Named all[] = {{Kind::reference_uniform, "reference.uniform"},
                                {Kind::reference_graded, "reference.linear"},
                                {Kind::fast_uniform, "fast.uniform"},
                                {Kind::fast_mapped, "fast"}};

[[nodiscard]] Scheme evaluated(Kind kind, const Problem& problem, double exit, const Array& P, double offset = 0);
/// At P = 0.
[[nodiscard]] Scheme at_rest(Kind kind, const Problem& problem, int intervals, double exit);

}  // namespace ehd::verification::schemes
