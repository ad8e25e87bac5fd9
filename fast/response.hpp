// SPDX-License-Identifier: GPL-3.0-or-later
// The linear response of a contact by `fast`: harmonic.hpp on the grids of one map, each with twice the intervals of
// the one before, extrapolated.
#pragma once

#include "contact/response.hpp"
#include "fast/workspace.hpp"

namespace ehd::fast {

/// A problem with sources has no response; its caller never asks for one. Plans, tables and arrays are the caller's.
[[nodiscard]] Response response(const Problem& problem, const ResponseRequest& request, Workspace& workspace);

}  // namespace ehd::fast
