// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller of the C interface holds: one result of a contact or of a bearing, the latter with its laws. The JSON
// and each field are made when they are first asked for: a caller who wants one film does not pay for them.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "bearing/force_law.hpp"
#include "io/bearing_json.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "io/profile_csv.hpp"

namespace ehd::c {

/// A value that is made when it is first asked for; several threads may ask.
template <class Value>
class MadeOnce {
 public:
  template <class Make>
  const Value& get(const Make& make) const {
    std::call_once(made_, [&] { value_ = make(); });
    return value_;
  }

 private:
  mutable std::once_flag made_;
  mutable Value value_;
};

}  // namespace ehd::c

struct ehd_result {
  explicit ehd_result(ehd::ContactRun run) : made(std::move(run)) {}
  ehd_result(ehd::BearingResult balanced, std::optional<ehd::bearing::LawPair> laws_of_it)
      : made(std::move(balanced)), laws(std::move(laws_of_it)) {}

  const std::variant<ehd::ContactRun, ehd::BearingResult> made;
  const std::optional<ehd::bearing::LawPair> laws = {};

  [[nodiscard]] bool of_bearing() const { return std::holds_alternative<ehd::BearingResult>(made); }
  [[nodiscard]] const ehd::Json& json() const {
    return json_.get([this] { return std::visit([](const auto& one) { return ehd::to_json(one); }, made); });
  }
  /// The JSON as the program writes it.
  [[nodiscard]] const std::string& text() const {
    return text_.get([this] { return ehd::json_text(json()); });
  }
  /// The values of profile_rows()[i]; null where this contact has no such column, or no solution.
  [[nodiscard]] const ehd::Array* field(std::size_t i) const {
    const auto& values = fields_[i].get([&] {
      const auto* run = std::get_if<ehd::ContactRun>(&made);
      const bool solved = run && run->status() != ehd::StopReason::diverged && run->solution.fields.X.size() > 0;
      return solved ? ehd::profile_rows()[i].values(*run) : std::nullopt;
    });
    return values ? &*values : nullptr;
  }

 private:
  ehd::c::MadeOnce<ehd::Json> json_;
  ehd::c::MadeOnce<std::string> text_;
  std::array<ehd::c::MadeOnce<std::optional<ehd::Array>>, ehd::most_profile_columns> fields_;
};
