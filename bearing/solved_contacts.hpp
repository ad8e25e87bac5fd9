// SPDX-License-Identifier: GPL-3.0-or-later
// Solved EHD contacts as film curves and fits take them. bearing/ knows no solver: the caller hands in the function
// that solves a contact, and that function may remember what it has solved.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// One solved contact.
struct SolvedContact {
  double offset = 0;        ///< H_0 in Hertz units, datum x_0 = b
  double offset_error = 0;  ///< absolute
  double film_minimum_m = 0;
  double film_error = 0;                             ///< relative error of film_minimum_m
  std::optional<double> rolling_force_N_per_m = {};  ///< |Int h p' dx|/2 per length
  double rolling_error = 0;                          ///< relative
  bool converged = true;  ///< false: the best solution missed its tolerance; the errors above still hold
};
/// A contact that has no solution.
struct SolveFailure {
  std::string why;
  bool limit = false;  ///< true: the solver ran out of iterations or time; false: the equations gave no solution
};
using ContactResult = std::variant<SolvedContact, SolveFailure>;

/// Solves the contact at a load [N/m], or remembers it.
using ContactPoint = std::function<ContactResult(double load_N_per_m)>;

/// The contact at a raceway, and the function that solves it at a load.
struct SolvableContact {
  RacewayContact contact;
  ContactPoint solve;

  /// The contact at a force [N].
  [[nodiscard]] ContactResult at(double force_N) const { return solve(force_N / contact.length_m); }
};

/// The offset film of a solved contact [m], F = (b^2/R)(H_0 - H_0,dry) = delta_dry - delta (film_curve.hpp).
[[nodiscard]] double offset_film_m(const RacewayContact& contact, double force_N, const SolvedContact& solved);

/// The relative error of the offset film.
[[nodiscard]] double relative_offset_error(const SolvedContact& solved);

}  // namespace ehd::bearing
