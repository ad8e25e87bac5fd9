// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the schemes against a manufactured solution, grid by grid: what rung 5 fits orders to, and the convergence
// figures show. Second-order schemes are asked through their public solve(), from their own starts, for the fields of
// the grid (fast extrapolates films and the like, never fields); the collocation on polynomial elements through its
// Newton's method from the exact state, since its solver adapts meshes, which fits no order.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "verification/exact/manufactured.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Absolute errors in Hertz units: largest over the nodes (collocation: over 21 points an element), and the three
/// numbers that belong to no node. NaN where the solve did not end as converged.
struct ManufacturedErrors {
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  double pressure = nothing, offset = nothing, flux = nothing, exit = nothing;
};
inline constexpr std::pair<const char*, double ManufacturedErrors::*> manufactured_quantities[] = {
    {"pressure", &ManufacturedErrors::pressure},
    {"offset", &ManufacturedErrors::offset},
    {"flux", &ManufacturedErrors::flux},
    {"exit", &ManufacturedErrors::exit}};

struct ManufacturedContact {
  std::string name;
  exact::Manufactured (*make)();
};
inline const ManufacturedContact manufactured_contacts[] = {{"compressible", &exact::Manufactured::compressible},
                                                            {"barus", &exact::Manufactured::barus}};

inline constexpr int manufactured_grids[] = {192, 288, 432, 648};         ///< intervals
inline constexpr int collocation_elements[] = {48, 72, 108, 162};         ///< of one degree
inline constexpr int collocation_degrees[] = {6, 8, 10, 12, 14, 16, 18};  ///< on collocation_elements_in_p elements
inline constexpr int collocation_elements_in_p = 5;

[[nodiscard]] ManufacturedErrors errors_of_solver(const RegisteredSolver& solver, const exact::Manufactured& truth,
                                                  int intervals);
/// `elements` equal elements from the inlet to the exit.
[[nodiscard]] ManufacturedErrors errors_of_collocation(const exact::Manufactured& truth, int elements, int degree);
/// The factor a degree by which the error in p falls: the sum of the half axes of the largest ellipse about an
/// element's ends without the pole, the smallest of all elements (Bernstein).
[[nodiscard]] double bernstein_factor(const exact::Manufactured& truth, int elements);

}  // namespace ehd::verification
