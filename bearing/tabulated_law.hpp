// SPDX-License-Identifier: GPL-3.0-or-later
// The law `ehd` as a table for another program: cubic Hermite polynomials over the approach, with the error that they
// make between the knots.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bearing/force_law.hpp"

namespace ehd::bearing {

/// A number at the knots, and its derivative to the approach.
struct KnotColumn {
  std::vector<double> values, slopes;
};

/// What the table gives at an approach.
struct TabulatedValues {
  double force_N = 0, stiffness_N_per_m = 0, film_minimum_m = 0;
  std::optional<double> damping_N_s_per_m = {};
};

/// Largest relative differences to the law between the knots.
struct TableErrors {
  double force = 0, stiffness = 0, film = 0;
  std::optional<double> damping = {};
};

/// Between two knots ln f, ln h and c are cubic Hermite polynomials of the approach; the stiffness is the derivative of
/// the force.
struct TabulatedLaw {
  std::vector<double> approach_m;  ///< of the knots, increasing
  KnotColumn force_N;              ///< its slopes are the stiffness [N/m]
  KnotColumn film_minimum_m;
  std::optional<KnotColumn> damping_N_s_per_m;
  TableErrors errors;

  /// Absent outside the table.
  [[nodiscard]] std::optional<TabulatedValues> at(double approach) const;
};

/// Damping of slow motion over the contact force [N -> N s/m]; empty where it is not known.
using DampingOverForce = std::function<double(double force_N)>;

/// Knots equally spaced in ln f, from `lightest_N` to `heaviest_N`; at least two.
[[nodiscard]] TabulatedLaw tabulate(const CurveLaw& law, double lightest_N, double heaviest_N, int knots,
                                    const DampingOverForce& damping);

}  // namespace ehd::bearing
