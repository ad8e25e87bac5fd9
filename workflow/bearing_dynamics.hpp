// SPDX-License-Identifier: GPL-3.0-or-later
// What the films do to a bearing that is already balanced: its stiffness and damping in motion, and its rolling torque.
#pragma once

#include <vector>

#include "bearing/force_law.hpp"
#include "workflow/bearing_balance.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

/// Contacts of the law `ehd` respond by their kappa; those of the other laws are the law's slope, without damping.
/// Throws LawFailure where a contact has no response.
void fill_dynamics(BearingResult& result, const BearingSetup& setup, const bearing::LawPair& laws,
                   const std::vector<double>& frequencies_Hz, ContactMemory& memory);

/// Torque = u_s l Sum_j (F_t,i + F_t,o)/|w_i - w_o|, the rolling forces F_t read from the result's curves; nothing
/// where there are none.
///
/// It is the whole power that the films take from rings that roll without slip. The power that the surfaces give to a
/// contact, u_m Int h p' dx = u_s F_t, is what the flow dissipates, Int h^3 p'^2/(12 eta) dx: with the mass flow
/// rho (u_m h - h^3 p'/(12 eta)) = C the two differ by C Int p'/rho dx, which vanishes between p = 0 and p = 0, because
/// rho depends on the pressure alone. So compression costs no work, and the torque needs no term for it.
void fill_torque(BearingResult& result, const BearingSetup& setup);

}  // namespace ehd
