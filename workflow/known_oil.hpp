// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of an oil, those that follow from eta_0 among them.
#pragma once

#include "contact/conditions.hpp"

namespace ehd {

/// The oil as stated. Where its law has alpha and z and one of them is left out, that one is put in: it follows from
/// eta_0 of the contact. Throws StatementError as nondimensionalise does.
[[nodiscard]] Lubricant with_alpha_and_z(Lubricant oil, const Conditions& contact);

}  // namespace ehd
