// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as this project writes it: keys in the order in which they were put, numbers finite, nothing null. And its
// strict reader.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ehd {

/// A source that makes or reads one includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// Indented by two spaces, with a line feed at the end; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& json);

/// {} with room for so many members: an object that grows copies all that it holds.
[[nodiscard]] Json object_of(std::size_t members);

/// object[key] = value, where value is finite.
void put(Json& object, const std::string& key, double value);
void put(Json& object, const std::string& key, const std::optional<double>& value);
/// object[key] = [values], where all are finite.
void put(Json& object, const std::string& key, std::initializer_list<double> values);

/// The text is not valid JSON of this project: what() says why, "breaks at byte 17".
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One JSON value: each key of an object once and at most 10000 of them, numbers that a double holds, at most 64
/// levels. Throws JsonError.
[[nodiscard]] Json json_from(std::string_view text);

}  // namespace ehd
