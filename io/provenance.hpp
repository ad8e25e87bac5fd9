// SPDX-License-Identifier: GPL-3.0-or-later
// Where a result comes from: commit, compiler, libraries, machine, date.
#pragma once

#include "io/json.hpp"

namespace ehd {

/// {"version", "commit", "dirty", "compiler", "flags", "libraries", "cpu", "cores", "date"}. Unknown entries are
/// absent (the commit in a source tree without git).
[[nodiscard]] Json provenance();

}  // namespace ehd
