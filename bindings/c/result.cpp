// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/c/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "bindings/c/call.hpp"
#include "bindings/c/ehd/ehd.h"
#include "contact/text.hpp"
#include "io/version.hpp"

namespace ehd::c {

namespace {

/// The value at one step of a path: a member of an object, or an item of a list by its number from 0.
const Json* step_into(const Json& json, std::string_view name) {
  if (json.is_object()) {
    const auto at = json.find(std::string(name));
    return at == json.end() ? nullptr : &*at;
  }
  if (!json.is_array()) return nullptr;
  std::size_t item = 0;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), item);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == name.data() + name.size();
  return whole && item < json.size() ? &json[item] : nullptr;
}

/// The number at "film.minimum.hertz"; nothing where there is none.
std::optional<double> number_at(const Json& json, std::string_view path) {
  const Json* at = &json;
  for (std::size_t begin = 0; at && begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    at = step_into(*at, path.substr(begin, end - begin));
    begin = end + 1;
  }
  if (at && at->is_boolean()) return at->get<bool>() ? 1 : 0;
  return at && at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
}

}  // namespace

}  // namespace ehd::c

const char* ehd_version(void) {
  try {
    static const std::string text = ehd::version_text();
    return text.c_str();
  } catch (...) {  // no memory for it
    return "";
  }
}

int ehd_get(const ehd_result* result, const char* path, double* value) {
  using namespace ehd::c;
  return guarded([&] {
    require_pointer(result, "result");
    require_pointer(path, "path");
    require_pointer(value, "value");
    const auto number = number_at(result->json, path);
    if (!number) throw unknown_name("path", path, "the path of a number in the JSON of this result");
    *value = *number;
    return EHD_OK;
  });
}

size_t ehd_field(const ehd_result* result, const char* name, double* buffer, size_t length) {
  using namespace ehd::c;
  size_t count = 0;
  (void)guarded([&] {
    require_pointer(result, "result");
    require_pointer(name, "name");
    if (length > 0) require_pointer(buffer, "buffer");
    const auto column = std::find_if(result->fields.begin(), result->fields.end(),
                                     [&](const ehd::ProfileColumn& one) { return one.name == name; });
    if (column == result->fields.end()) throw unknown_name("name", name, "a column of the profile of this result");
    count = static_cast<size_t>(column->values.size());
    std::copy_n(column->values.data(), std::min(count, length), buffer);
    return EHD_OK;
  });
  return count;
}

const char* ehd_json(const ehd_result* result) {
  const char* text = nullptr;
  (void)ehd::c::guarded([&] {
    ehd::c::require_pointer(result, "result");
    text = result->text().c_str();
    return EHD_OK;
  });
  return text;
}

void ehd_free(ehd_result* result) { delete result; }
