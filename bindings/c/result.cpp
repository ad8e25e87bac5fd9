// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/c/result.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "bindings/c/call.hpp"
#include "bindings/c/ehd/ehd.h"
#include "io/case_keys.hpp"
#include "io/near_miss.hpp"
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

std::optional<double> as_number(const Json& json) {
  if (json.is_boolean()) return json.get<bool>() ? 1 : 0;
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

/// The number at "film.minimum.hertz"; nothing where there is none.
std::optional<double> number_at(const Json& json, std::string_view path) {
  const Json* at = &json;
  for (std::size_t begin = 0; at && begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    at = step_into(*at, path.substr(begin, end - begin));
    begin = end + 1;
  }
  return at ? as_number(*at) : std::nullopt;
}

/// The same of a result. An observed quantity is read without the rest of the JSON, which costs more to make than the
/// case costs to read.
std::optional<double> number_of(const ehd_result& result, std::string_view path) {
  if (const auto* run = std::get_if<ContactRun>(&result.made)) {
    if (const auto entry = observable_json(*run, path)) return as_number(*entry);
    const std::size_t dot = std::min(path.rfind('.'), path.size());
    if (const auto entry = observable_json(*run, path.substr(0, dot)))
      return number_at(*entry, path.substr(std::min(dot + 1, path.size())));
  }
  return number_at(result.json(), path);
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
    const auto number = number_of(*result, path);
    if (!number)
      throw unknown_name("path", path, "is unknown; allowed is the path of a number in the JSON of this result");
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
    const auto rows = ehd::profile_rows();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const ehd::ProfileRow& one) { return one.name == name; });
    const ehd::Array* const values =
        row == rows.end() ? nullptr : result->field(static_cast<std::size_t>(row - rows.begin()));
    if (!values) {
      std::vector<std::string> names;
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (result->field(i)) names.emplace_back(rows[i].name);
      throw unknown_name("name", name, ehd::is_unknown(name, ehd::list(names)));
    }
    count = static_cast<size_t>(values->size());
    std::copy_n(values->data(), std::min(count, length), buffer);
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
