// SPDX-License-Identifier: GPL-3.0-or-later
// By how much fit, interpolation, rigid limit and contact solver may change the balance of one law.
//
// Bounds are of first order. Let g be the error of a contact's approach at a fixed force, k and n the stiffness and the
// direction of a roller. The ring then moves by du = K^(-1) Sum k g n, K = Sum k n n', and the roller's force changes
// by k (n du - g). The sizes of the contacts' errors are added, whatever their signs. A ring that is symmetric to the
// load stays on its line, because mirrored contacts have equal errors. A difference is that of two balances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"

namespace ehd {

struct BudgetRow {
  std::string source = {};                   ///< "fit", "interpolation", "rigid limit", "contact solver"
  std::string of = {};                       ///< what was compared, or bounded, in words
  bool bound = false;                        ///< false: the size of a difference
  double displacement_m = 0;                 ///< of the ring, along the load
  double displacement_lateral_m = 0;         ///< across it
  double largest_force_N = 0;                ///< of the most loaded roller, inner raceway
  double any_force_N = 0;                    ///< of the roller whose force changes most
  std::optional<double> smallest_film = {};  ///< relative, of the thinnest minimum film at any contact

  /// Of displacements and forces the larger ones.
  void meet(const BudgetRow& other);
};

/// How far another balance of the same bearing is from `result`. The change of the film is relative to that of
/// `result`.
[[nodiscard]] BudgetRow difference(const BearingResult& other, const BearingResult& result);

/// The numerical errors of a law with films, a row a source. `full` is the balance of the law ehd (`result` itself, if
/// its law is that): the line ehd-linear is as far off as it differs from ehd ("fit") and as ehd itself is. Empty for a
/// dry law, and where a balance or its curve is missing.
[[nodiscard]] std::vector<BudgetRow> numerical_budget(const BearingCase& body, const BearingResult& result,
                                                      const BearingResult& full);

/// The sum of the rows. Absent where there are none, and where a source is infinite, as that of a film curve with a gap
/// that nothing judged.
[[nodiscard]] std::optional<BearingErrors> sum_of(const std::vector<BudgetRow>& rows);

}  // namespace ehd
