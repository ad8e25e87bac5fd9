// SPDX-License-Identifier: GPL-3.0-or-later
// What each simplification on the way to a load distribution costs: of one law's balance, what fit, interpolation,
// rigid limit, contact solver and datum may move.
//
// Bounds are of first order: at fixed forces an error of a contact's approach is g; with the rollers' stiffnesses k and
// directions n the ring gives way by du = K^(-1) Sum k g n, K = Sum k n n', and a roller's force changes by k (n du -
// g). Errors of different contacts add up in their sizes, whatever their signs. Differences are of two full balances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

struct BudgetRow {
  std::string source;                        ///< "fit", "interpolation", "rigid limit", "contact solver", "datum"
  std::string of;                            ///< what was compared, or bounded, in words
  bool bound = false;                        ///< a first-order bound; else the size of a difference
  double displacement_m = 0;                 ///< of the ring, along the load
  double largest_force_N = 0;                ///< of the most loaded roller, inner raceway
  double any_force_N = 0;                    ///< of the roller that is moved most
  std::optional<double> smallest_film = {};  ///< relative, of the thinnest minimum film at any contact
};

/// The rows of one EHD law among the results of a case; empty for a dry law, and where a balance is missing. "fit"
/// needs both EHD laws among the results. The data compared are the others of palmgren, lundberg and x_0 = twice the
/// case's; contacts are taken from the memory, which the datum does not change.
[[nodiscard]] std::vector<BudgetRow> budget_of(const Case& bearing_case, const std::vector<BearingResult>& results,
                                               bearing::Law law, ContactMemory& memory);

[[nodiscard]] Json to_json(const std::vector<BudgetRow>& rows);
[[nodiscard]] std::string human_budget(const std::vector<BudgetRow>& rows);

}  // namespace ehd::verification
