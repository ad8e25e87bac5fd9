// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace ehd {

void put(Json& object, const std::string& key, double value) {
  if (std::isfinite(value)) object[key] = value;
}

void put(Json& object, const std::string& key, const std::optional<double>& value) {
  if (value) put(object, key, *value);
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace ehd
