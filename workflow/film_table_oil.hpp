// SPDX-License-Identifier: GPL-3.0-or-later
// The oil and the inlet that a table of films is for. M and L then fix the contact: p_H = L sqrt(M/2pi)/alpha.
#pragma once

#include "contact/problem.hpp"
#include "workflow/case.hpp"

namespace ehd {

struct TableOil {
  Lubricant lubricant;  ///< with alpha and z wherever the laws need them
  Inlet inlet = Flooded{};
};

/// The oil and inlet of a contact, or of a bearing, whose inlets are flooded. An alpha or z that follows from eta_0 is
/// put in. Throws CaseError: a dry case, an isoviscous oil, a law that needs pressures in Pa where alpha is not stated.
[[nodiscard]] TableOil table_oil(const Case& stated);

/// The same laws with the same numbers, and the same inlet.
[[nodiscard]] bool same_oil(const TableOil& one, const TableOil& other);

/// The problem of one contact of a table. Throws StatementError where M or L is out of range.
[[nodiscard]] Problem problem_of(const TableOil& oil, const MoesGroups& at);

}  // namespace ehd
