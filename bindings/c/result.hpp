// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller of the C interface holds: the JSON of one result, with the fields of a contact and the laws of a
// bearing.
#pragma once

#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bearing/force_law.hpp"
#include "io/json.hpp"
#include "io/profile_csv.hpp"

struct ehd_result {
  ehd::Json json;
  std::vector<ehd::ProfileColumn> fields = {};  ///< of a contact; empty where it has no solution
  std::optional<ehd::bearing::LawPair> laws = {};
  bool of_bearing = false;

  /// The JSON as the program writes it, made when it is first asked for; several threads may ask.
  [[nodiscard]] const std::string& text() const {
    std::call_once(text_made_, [this] { text_ = ehd::json_text(json); });
    return text_;
  }

 private:
  mutable std::once_flag text_made_;
  mutable std::string text_;
};
