// SPDX-License-Identifier: GPL-3.0-or-later
// From a bearing case to its load distributions: case -> plan -> contacts -> force laws -> equilibrium -> result. Each
// arrow is a file: bearing_plan, bearing_contact, bearing_datum, bearing_fit, bearing_curve, bearing_balance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "bearing/law_table.hpp"
#include "workflow/bearing_of_case.hpp"
#include "workflow/bearing_plan.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

/// The laws that bearing/law_table marks as default; without a lubricant the dry ones of them.
[[nodiscard]] std::vector<bearing::Law> default_laws(const BearingCase& body);

struct BearingRequest {
  std::vector<bearing::Law> laws;
  bool explicitly = false;  ///< laws were named by the user, not taken by default
  bool films = true;        ///< film of each roller, and the variants
  bearing::Form form = bearing::Form::plane;
  /// The ring is also balanced at this many positions of the cage over one pitch; 0: none.
  int cage_positions = 0;
  /// Stiffness and damping of the balanced bearing at these frequencies, >= 0; none: not asked for.
  std::vector<double> frequencies_Hz = {};
};

/// The laws that a result was balanced with; absent where it has none (no balance).
[[nodiscard]] std::optional<bearing::LawPair> laws_of(const BearingCase& body, const BearingResult& result);

/// Why a result with films is `limit_reached`, if it is not said otherwise: the begin of its reason.
inline constexpr const char* limit_ended_film_curves =
    "the limit on iterations or time ended contacts of the film curves";

/// All laws of the request that the plan runs, in that order. Every way to end is in the results' status. Throws
/// CaseError for an EHD law at rest, or (`explicitly`) without a lubricant, and for a law without the ring thickness
/// that it needs, before anything is solved.
[[nodiscard]] std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request,
                                                     ContactMemory& memory);
/// Throws what run_bearing throws before it solves anything.
void require_possible(const Case& bearing_case, const BearingRequest& request);

}  // namespace ehd
