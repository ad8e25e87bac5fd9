// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the schemes against a manufactured solution, grid by grid. Rung 5 fits orders to them, and the convergence
// figures show them. Solvers of second order run through their public solve() from their own starts; their errors are
// those of the grid's fields, which no solver extrapolates. The certified solver adapts its meshes, which gives no
// order in h or p: its collocation is solved on given meshes instead, by its Newton's method from the exact state.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/hp/homotopy.hpp"
#include "verification/exact/manufactured.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Absolute errors in Hertz units. Pressure: the largest over the nodes (collocation: over 21 points of each element).
/// NaN where the solve did not converge.
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

/// Newton's method of a second-order solver. Sources cost a quadrature a node, so a wrong program that never converges
/// would take many minutes for what a right one does in a second.
inline constexpr int most_manufactured_iterations = 100;

inline constexpr int manufactured_grids[] = {192, 288, 432, 648};         ///< intervals
inline constexpr int collocation_elements[] = {48, 72, 108, 162};         ///< of one degree
inline constexpr int collocation_degrees[] = {6, 8, 10, 12, 14, 16, 18};  ///< on collocation_elements_in_p elements
inline constexpr int collocation_elements_in_p = 5;

[[nodiscard]] ManufacturedErrors errors_of_solver(const RegisteredSolver& solver, const exact::Manufactured& truth,
                                                  int intervals);
/// The discrete solution on `elements` equal elements from the inlet to the exit. Empty where no step was taken.
[[nodiscard]] std::optional<reference::hp::Resolved> collocation_of(const exact::Manufactured& truth, int elements,
                                                                    int degree);
[[nodiscard]] ManufacturedErrors errors_of_collocation(const exact::Manufactured& truth, int elements, int degree);
/// The factor by which the error in p falls with each degree (Bernstein): the sum of the half axes of the largest
/// ellipse about an element's ends that does not contain the pole; the smallest of all elements.
[[nodiscard]] double bernstein_factor(const exact::Manufactured& truth, int elements);

}  // namespace ehd::verification
