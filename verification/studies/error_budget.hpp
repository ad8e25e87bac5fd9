// SPDX-License-Identifier: GPL-3.0-or-later
// The error budget of a load distribution: how much fit, interpolation, rigid limit, contact solver and datum may
// change the balance of one law.
//
// Bounds are of first order. Let g be the error of a contact's approach at a fixed force, k and n the stiffness and the
// direction of a roller. The ring then moves by du = K^(-1) Sum k g n, K = Sum k n n', and the roller's force changes
// by k (n du - g). The sizes of the contacts' errors are added, whatever their signs. A difference is that of two
// balances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

/// The source of the rows that say what another datum changes: a choice of the case, not an error of the numerics.
inline constexpr const char* datum_source = "datum";

struct BudgetRow {
  std::string source;                        ///< "fit", "interpolation", "rigid limit", "contact solver", "datum"
  std::string of;                            ///< what was compared, or bounded, in words
  bool bound = false;                        ///< false: the size of a difference
  double displacement_m = 0;                 ///< of the ring, along the load
  double largest_force_N = 0;                ///< of the most loaded roller, inner raceway
  double any_force_N = 0;                    ///< of the roller whose force changes most
  std::optional<double> smallest_film = {};  ///< relative, of the thinnest minimum film at any contact

  /// Of displacement and forces the larger ones.
  void meet(const BudgetRow& other);
};

/// The rows of one EHD law among the results of a case; empty for a dry law, and where a balance is missing. The line
/// ehd-linear is as far off as it differs from ehd ("fit") and as ehd itself is; ehd is balanced where it is not among
/// the results, on the curve that the memory has. The case's datum is compared with palmgren, lundberg (where it is not
/// that itself) and twice its x_0. The datum does not change the contacts: they are taken from the memory.
[[nodiscard]] std::vector<BudgetRow> budget_of(const Case& bearing_case, const std::vector<BearingResult>& results,
                                               bearing::Law law, ContactMemory& memory);

/// Why the balance of a law with films has no budget; absent where it has one, and where there is nothing to budget.
[[nodiscard]] std::optional<std::string> why_no_budget(const Case& bearing_case,
                                                       const std::vector<BearingResult>& results, bearing::Law law,
                                                       ContactMemory& memory);

/// A number that is not finite is no bound: its key is then in the row's list "unknown".
[[nodiscard]] Json to_json(const std::vector<BudgetRow>& rows);
[[nodiscard]] std::string human_budget(const std::vector<BudgetRow>& rows);

}  // namespace ehd::verification
