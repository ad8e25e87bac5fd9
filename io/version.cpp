// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/version.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "io/provenance.hpp"

namespace ehd {

namespace {

/// The commit, or its first letters; "no commit" outside git.
std::string commit_of(const Json& built, std::size_t letters) {
  const std::string commit = built.value("commit", "");
  if (commit.empty()) return "no commit";
  return commit.substr(0, letters) + (built.value("dirty", false) ? ", changed since" : "");
}

std::string version_text(const Json& built) {
  constexpr std::size_t shown_of_commit = 8;
  const Json& libraries = built.at("libraries");
  std::string fftw = libraries.at("FFTW").get<std::string>();  // "fftw-3.3.10-sse2-avx"
  if (fftw.starts_with("fftw-")) fftw.erase(0, 5);
  return fmt::format("{} ({}, FFTW {}, Eigen {})", built.at("version").get<std::string>(),
                     commit_of(built, shown_of_commit), fftw.substr(0, fftw.find('-')),
                     libraries.at("Eigen").get<std::string>());
}

}  // namespace

std::string commit_words(std::size_t letters) {
  const Json built = provenance();
  return (built.contains("commit") ? "commit " : "") + commit_of(built, letters);
}

std::string version_text() { return version_text(provenance()); }

std::string build_text() {
  const Json built = provenance();
  std::string text = fmt::format("{}\ncommit     {}\ncompiler   {}\nflags      {}\nlibraries ", version_text(built),
                                 commit_of(built, std::string::npos), built.at("compiler").get<std::string>(),
                                 built.at("flags").get<std::string>());
  std::string separator = " ";
  for (const auto& [name, version] : built.at("libraries").items())
    text += fmt::format("{}{} {}", std::exchange(separator, ", "), name, version.get<std::string>());
  return text;
}

}  // namespace ehd
