// SPDX-License-Identifier: GPL-3.0-or-later
// The law `ehd` of one raceway of a bearing as a table for another program.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "bearing/geometry.hpp"
#include "bearing/tabulated_law.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

struct LawExportRequest {
  bearing::Raceway raceway = bearing::Raceway::inner;
  int knots = 32;
};

struct LawExport {
  std::string case_id;
  int version = 0;
  std::string title = {};  ///< of the case, with the values that --set changed
  bearing::Raceway raceway = bearing::Raceway::inner;
  bearing::RacewayContact contact;
  Lubricant lubricant = {};                               ///< with alpha and z
  double datum_m = 0;                                     ///< x_0
  double lightest_N = 0, heaviest_N = 0;                  ///< contact forces of the table
  double balance_lightest_N = 0, balance_heaviest_N = 0;  ///< of the bearing in balance
  bearing::TabulatedLaw table = {};
  /// The law's own errors, relative, the largest at the knots: of the force and the stiffness at an approach, of the
  /// film, of the damping. The table's are in `table.errors`.
  double force_error = 0, stiffness_error = 0, film_error = 0;
  std::optional<double> damping_error = {};
  std::string no_damping = {};  ///< why the table has no damping; empty where it has
  /// Of the balance: where it is not converged, the errors are larger than asked for, or not known, and `why` says why.
  StopReason status = StopReason::converged;
  std::string why = {};
};

/// The table begins at half the lightest contact force of the balance and ends where the solved contacts end. Throws
/// CaseError as run_bearing does, and LawFailure where there is no balance.
[[nodiscard]] LawExport export_law(const Case& bearing_case, const LawExportRequest& request, ContactMemory& memory);

}  // namespace ehd
