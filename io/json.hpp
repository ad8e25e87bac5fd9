// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as this project writes it: keys in the order in which they were put, numbers finite, nothing null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace ehd {

/// A source that makes or reads one includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// Indented by two spaces, with a line feed at the end; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& json);

/// object[key] = value, where value is finite.
void put(Json& object, const std::string& key, double value);
void put(Json& object, const std::string& key, const std::optional<double>& value);

}  // namespace ehd
