// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/provenance.hpp"

#include <fftw3.h>
#include <gsl/gsl_version.h>
#include <stdlib.h>

#include <Eigen/Core>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace ehd::verification {

namespace {

/// What a command prints, without the last line feed; absent where it fails.
std::optional<std::string> output_of(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
  if (!pipe) return std::nullopt;
  std::string text;
  char buffer[256];
  while (std::fgets(buffer, sizeof buffer, pipe)) text += buffer;
  if (::pclose(pipe) != 0) return std::nullopt;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string quoted(const std::string& path) {
  std::string text = "'";
  for (const char c : path) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

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
  Json json;
  json["version"] = EHD_PROJECT_VERSION;
  // The tree that the program was built from, if it is still there and under git.
  const std::string git = "git -C " + quoted(EHD_SOURCE_FOLDER) + " ";
  if (const auto commit = output_of(git + "rev-parse HEAD")) {
    json["commit"] = *commit;
    if (const auto changes = output_of(git + "status --porcelain")) json["dirty"] = !changes->empty();
  }
  json["compiler"] = compiler();
  json["flags"] = EHD_COMPILE_FLAGS;
  json["libraries"] = {{"Eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                     std::to_string(EIGEN_MINOR_VERSION)},
                       {"FFTW", std::string(fftw_version)},
                       {"GSL", std::string(gsl_version)},
                       {"nlohmann_json", std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
                                             std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                                             std::to_string(NLOHMANN_JSON_VERSION_PATCH)}};
  if (const auto model = cpu()) json["cpu"] = *model;
  json["cores"] = std::thread::hardware_concurrency();
  json["date"] = now();
  return json;
}

}  // namespace ehd::verification
