// SPDX-License-Identifier: GPL-3.0-or-later
// Where a result comes from: commit, compiler, libraries, machine, date.
#pragma once

#include <string_view>

#include "io/json.hpp"

namespace ehd {

/// {"version", "commit", "dirty", "compiler", "flags", "libraries", "cpu", "cores", "date"}. Unknown entries are
/// absent (the commit in a source tree without git).
[[nodiscard]] Json provenance();

/// The first members of a result: {"schema": schema, "provenance": {"version", "commit"}}. docs/schema has a JSON
/// Schema of that name.
[[nodiscard]] Json result_head(std::string_view schema);

}  // namespace ehd
