// SPDX-License-Identifier: GPL-3.0-or-later
// The certified linear response: harmonic.hpp on two discretisations, whose meshes follow the oscillating pressure.
// docs/certified-solver.md, section 7.
#pragma once

#include "contact/response.hpp"

namespace ehd::reference::hp {

/// A problem with sources has no response; its caller never asks for one.
[[nodiscard]] Response response(const Problem& problem, const ResponseRequest& request);

}  // namespace ehd::reference::hp
