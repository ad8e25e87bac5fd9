// SPDX-License-Identifier: GPL-3.0-or-later
// Results of the C interface that free themselves, and the cases of the tests.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "bindings/c/ehd/ehd.h"

namespace ehd::c::test {

struct Free {
  void operator()(ehd_result* result) const { ehd_free(result); }
};

/// A return value with the result that came with it.
struct Held {
  int code = -1;
  std::unique_ptr<ehd_result, Free> result;

  [[nodiscard]] double get(const char* path) const {
    double value = 0;
    return ehd_get(result.get(), path, &value) == EHD_OK ? value : std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] std::vector<double> field(const char* name) const {
    std::vector<double> values(ehd_field(result.get(), name, nullptr, 0));
    ehd_field(result.get(), name, values.data(), values.size());
    return values;
  }
  [[nodiscard]] nlohmann::ordered_json json() const { return nlohmann::ordered_json::parse(ehd_json(result.get())); }
};

template <class Call>
[[nodiscard]] Held held(const Call& call) {
  ehd_result* result = nullptr;
  const int code = call(&result);
  return {.code = code, .result = std::unique_ptr<ehd_result, Free>(result)};
}

[[nodiscard]] inline Held solve(const std::string& text, const char* solver = "fast", double tolerance = 1e-3) {
  return held([&](ehd_result** result) { return ehd_solve(text.c_str(), solver, tolerance, result); });
}

[[nodiscard]] inline Held solve_moes(double M, double L, const char* lubricant = nullptr, const char* solver = "fast",
                                     double tolerance = 1e-3) {
  return held([&](ehd_result** result) { return ehd_solve_moes(M, L, lubricant, solver, tolerance, result); });
}

[[nodiscard]] inline Held bearing(const std::string& text, const char* law) {
  return held([&](ehd_result** result) { return ehd_bearing(text.c_str(), law, result); });
}

/// The text of a benchmark case.
[[nodiscard]] inline std::string case_text(const std::string& id) {
  std::ostringstream text;
  text << std::ifstream(fmt::format("{}/cases/{}.toml", EHD_SOURCE_DIR, id)).rdbuf();
  return text.str();
}

/// Without the times, which differ from run to run.
[[nodiscard]] inline nlohmann::ordered_json without_times(nlohmann::ordered_json json) {
  for (const char* time : {"wall_s", "planning_s", "total_s", "stage_s"}) json["cost"].erase(time);
  return json;
}

}  // namespace ehd::c::test
