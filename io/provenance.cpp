// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/provenance.hpp"

#include <fftw3.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <xxhash.h>

#include <Eigen/Core>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "ehd_commit.hpp"  // made by cmake/commit.cmake
#include "io/json.hpp"

namespace ehd {

namespace {

std::optional<std::string> cpu() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return std::nullopt;
}

std::string now() {
  const std::time_t time = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string compiler() {
#ifdef __clang__
  return std::string("clang ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

}  // namespace

Json provenance() {
  Json json = Json::object();
  json["version"] = EHD_PROJECT_VERSION;
  // The commit when the program was built, not the present state of the tree.
  if (const std::string commit = EHD_COMMIT; !commit.empty()) {
    json["commit"] = commit;
    json["dirty"] = EHD_COMMIT_DIRTY;
  }
  json["compiler"] = compiler();
  json["flags"] = EHD_COMPILE_FLAGS;
  const unsigned xxhash = XXH_versionNumber();  // of the library that is loaded, as for FFTW and GSL
  json["libraries"] = {
      {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"FFTW", std::string(fftw_version)},
      {"GSL", std::string(gsl_version)},
      {"nlohmann_json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"tomlplusplus", EHD_TOMLPLUSPLUS_VERSION},
      {"CLI11", EHD_CLI11_VERSION},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"xxhash", fmt::format("{}.{}.{}", xxhash / 10000, xxhash / 100 % 100, xxhash % 100)}};
  if (const auto model = cpu()) json["cpu"] = *model;
  json["cores"] = std::thread::hardware_concurrency();
  json["date"] = now();
  return json;
}

std::string commit_year() { return EHD_COMMIT_YEAR; }

}  // namespace ehd
