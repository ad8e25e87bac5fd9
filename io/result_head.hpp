// SPDX-License-Identifier: GPL-3.0-or-later
// How every JSON result begins.
#pragma once

#include <string_view>

#include "io/json.hpp"

namespace ehd {

/// {"schema": schema, "provenance": {"version", "commit"}}; without the commit where it is unknown. docs/schema has a
/// JSON Schema of that name.
[[nodiscard]] Json result_head(std::string_view schema);

}  // namespace ehd
