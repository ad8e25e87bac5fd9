// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller of the C interface holds: the JSON of one result, with the fields of a contact and the laws of a
// bearing.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bearing/force_law.hpp"
#include "io/json.hpp"
#include "io/profile_csv.hpp"

struct ehd_result {
  ehd::Json json;
  std::string text;                             ///< the JSON as the program writes it
  std::vector<ehd::ProfileColumn> fields = {};  ///< of a contact; empty where it has no solution
  std::optional<ehd::bearing::LawPair> laws = {};
  bool of_bearing = false;
};
