// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace ehd {

namespace {

constexpr int most_levels = 64;           // results have up to 8; Json's own destructor and dump recurse
constexpr std::size_t most_keys = 10000;  // results have up to 200; Json looks a key up in linear time

/// NaN, inf, -Infinity, ... at the byte where the parser stopped: the word and its first byte. Empty for anything else.
std::optional<std::pair<std::string_view, std::size_t>> no_number_at(std::string_view text, std::size_t byte) {
  const auto is_of_a_word = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]));
  };
  for (const std::string_view word : {"-Infinity", "Infinity", "-inf", "inf", "NaN", "nan"}) {
    const std::size_t at = text.find(word, byte > word.size() ? byte - word.size() : 0);
    if (at < byte && !is_of_a_word(at - 1) && !is_of_a_word(at + word.size())) return {{word, at + 1}};
  }
  return {};
}

/// What Json's parser accepts and this project never writes.
class StrictParse {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > most_levels) throw JsonError(fmt::format("has more than {} levels", most_levels));
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key) add(parsed.get_ref<const std::string&>());
    return true;
  }

 private:
  void add(const std::string& key) {
    std::vector<std::string>& keys = keys_.back();
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) throw JsonError("has a key twice: " + key);
    if (keys.size() == most_keys) throw JsonError(fmt::format("has an object of more than {} keys", most_keys));
    keys.push_back(key);
  }

  std::vector<std::vector<std::string>> keys_;  ///< of the objects that are open
};

}  // namespace

Json object_of(std::size_t members) {
  Json object = Json::object();
  object.get_ref<Json::object_t&>().reserve(members);
  return object;
}

namespace {

/// A null that the library makes an object on its way crashes in its destructor if there is no memory for the object.
Json& as_object(Json& object) {
  if (object.is_null()) object = Json::object();
  return object;
}

}  // namespace

void put(Json& object, const std::string& key, double value) {
  if (std::isfinite(value)) as_object(object)[key] = value;
}

void put(Json& object, const std::string& key, const std::optional<double>& value) {
  if (value) put(object, key, *value);
}

void put(Json& object, const std::string& key, std::initializer_list<double> values) {
  if (std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    as_object(object)[key] = std::vector<double>(values);
}

Json json_from(std::string_view text) {
  const auto no_json_at = [text](std::size_t byte) {
    const auto word = no_number_at(text, byte);
    if (!word) return JsonError(fmt::format("is no JSON (it breaks at byte {})", byte));
    return JsonError(fmt::format("is no JSON: {} at byte {}; JSON has no such number; leave out what is not known",
                                 word->first, word->second));
  };
  // Json's parser leaves out a byte-order mark, and takes a null byte for the end of the text.
  if (text.starts_with("\xEF\xBB\xBF")) throw no_json_at(1);
  if (const auto null = text.find('\0'); null != std::string_view::npos) throw no_json_at(null + 1);
  StrictParse strict;
  try {
    return Json::parse(
        text, [&strict](int depth, Json::parse_event_t event, Json& parsed) { return strict(depth, event, parsed); });
  } catch (const Json::parse_error& broken) {
    throw no_json_at(broken.byte);
  } catch (const Json::out_of_range&) {
    throw JsonError("holds a number that is out of range");
  }
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace ehd
