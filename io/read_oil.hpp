// SPDX-License-Identifier: GPL-3.0-or-later
// The [lubricant] of a contact or a bearing: laws and coefficients, and the oil by its grade.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "workflow/case.hpp"

namespace ehd {

class CaseTree;

struct OilOfCase {
  Lubricant lubricant;  ///< with the estimated alpha, where there is one
  std::optional<GradedOil> grade = {};
};

/// [lubricant] without the viscosity eta_0 that a bearing may state there. Where the oil is stated by its grade and a
/// law needs an alpha that the case leaves out, alpha is estimated. Throws CaseError.
[[nodiscard]] OilOfCase read_oil(const CaseTree& tree);

/// Whether the case states its oil by grade: then eta_0 follows, and no key may state it again.
[[nodiscard]] bool states_grade(const CaseTree& tree);
/// The first key of the case that belongs to a grade ("temperature_C"), without the keys that state it; empty where
/// there is none.
[[nodiscard]] std::string key_beside_grade(const CaseTree& tree);
/// Whether a key ("lubricant.iso_vg") states the grade.
[[nodiscard]] bool is_grade_key(std::string_view key);
/// Refuses the key that states eta_0 where the oil's grade sets it as well. Throws CaseError.
void refuse_beside_grade(const CaseTree& tree, std::string_view viscosity_key);
/// Refuses the grade where the case has no eta_0 that it could set: a contact stated by groups. Throws CaseError.
void refuse_grade_beside(const CaseTree& tree, const std::string& statement);

}  // namespace ehd
