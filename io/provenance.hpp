// SPDX-License-Identifier: GPL-3.0-or-later
// Where a result comes from: commit, compiler, libraries, machine, date.
#pragma once

#include <string>

#include "io/json.hpp"

namespace ehd {

/// {"version", "commit", "dirty", "compiler", "flags", "libraries", "cpu", "cores", "date"}. Unknown entries are
/// absent (the commit in a source tree without git).
[[nodiscard]] Json provenance();

/// The year of that commit; empty where it is unknown.
[[nodiscard]] std::string commit_year();

}  // namespace ehd
