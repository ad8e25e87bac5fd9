// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/provenance.hpp"

#include <fftw3.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <Eigen/Core>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>

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

std::string eigen_version() {
  return fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
}

Json libraries() {
  return {{"Eigen", eigen_version()},
          {"FFTW", std::string(fftw_version)},
          {"GSL", std::string(gsl_version)},
          {"nlohmann_json", std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
                                std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                                std::to_string(NLOHMANN_JSON_VERSION_PATCH)},
          {"tomlplusplus", EHD_TOMLPLUSPLUS_VERSION},
          {"CLI11", EHD_CLI11_VERSION}};
}

}  // namespace

std::string version_text() {
  constexpr std::size_t shown_of_commit = 8;
  std::string commit = std::string(EHD_COMMIT).substr(0, shown_of_commit);
  if (commit.empty()) commit = "no commit";
  if (EHD_COMMIT_DIRTY) commit += ", changed since";
  std::string fftw = fftw_version;  // "fftw-3.3.10-sse2-avx"
  if (fftw.starts_with("fftw-")) fftw.erase(0, 5);
  return fmt::format("{} ({}, FFTW {}, Eigen {})", EHD_PROJECT_VERSION, commit, fftw.substr(0, fftw.find('-')),
                     eigen_version());
}

std::string build_text() {
  std::string text = version_text() + "\n";
  if (const std::string commit = EHD_COMMIT; !commit.empty())
    text += fmt::format("commit     {}{}\n", commit, EHD_COMMIT_DIRTY ? ", changed since" : "");
  text += fmt::format("compiler   {}\nflags      {}\nlibraries ", compiler(), EHD_COMPILE_FLAGS);
  std::string separator = " ";
  const Json versions = libraries();
  for (const auto& [name, version] : versions.items())
    text += std::exchange(separator, ", ") + name + " " + version.get<std::string>();
  return text;
}

Json provenance() {
  Json json;
  json["version"] = EHD_PROJECT_VERSION;
  // The commit when the program was built, not the present state of the tree.
  if (const std::string commit = EHD_COMMIT; !commit.empty()) {
    json["commit"] = commit;
    json["dirty"] = EHD_COMMIT_DIRTY;
  }
  json["compiler"] = compiler();
  json["flags"] = EHD_COMPILE_FLAGS;
  json["libraries"] = libraries();
  if (const auto model = cpu()) json["cpu"] = *model;
  json["cores"] = std::thread::hardware_concurrency();
  json["date"] = now();
  return json;
}

}  // namespace ehd
