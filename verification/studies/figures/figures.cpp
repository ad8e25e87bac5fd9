// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/figures/figures.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "contact/interruption.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/json.hpp"
#include "verification/atlas/atlas.hpp"
#include "verification/studies/figures/parts.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification {

namespace {

/// Cases that can be read, by file name; those that cannot are failing claims of the suite.
std::vector<Case> readable_cases() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(cases_folder(), error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Case> cases;
  for (const auto& file : files) {
    try {
      cases.push_back(read_case(file));
    } catch (const CaseError&) {
      continue;
    }
  }
  return cases;
}

std::vector<FigurePart> parts_of(const FiguresRequest& request) {
  const auto asked = [&](int rung) { return !request.rung || *request.rung == rung; };
  constexpr int coupled = 5, grids = 8, published = 10, bearing = 11;
  std::vector<FigurePart> parts;
  if (request.case_id) {
    const std::vector<Case> named{read_case(find_case(*request.case_id))};
    const bool is_bearing = std::holds_alternative<BearingCase>(named.front().body);
    if (is_bearing && asked(bearing)) parts.push_back(bearing_part(named));
    if (!is_bearing && asked(published)) parts.push_back(profile_part(named, false));
    return parts;
  }
  const std::vector<Case> cases = readable_cases();
  if (asked(bearing)) {
    // The paper's bearing at its clearances; the longest piece, so it comes first.
    std::vector<Case> printed;
    for (const Case& one : cases)
      if (std::holds_alternative<BearingCase>(one.body) && is_of_the_paper(one)) printed.push_back(one);
    std::sort(printed.begin(), printed.end(), [](const Case& one, const Case& other) {
      return std::get<BearingCase>(one.body).geometry.clearance_m <
             std::get<BearingCase>(other.body).geometry.clearance_m;
    });
    parts.push_back(bearing_part(printed));
    parts.push_back(dynamics_part(printed, request.quick));
  }
  if (asked(published)) parts.push_back(profile_part(cases, request.quick));
  if (asked(coupled) || asked(grids)) parts.push_back(convergence_part(asked(coupled), asked(grids), request.quick));
  if (asked(published)) parts.push_back(map_part(atlas_folder(), request.quick));
  return parts;
}

}  // namespace

Json figures(const FiguresRequest& request) {
  const std::vector<FigurePart> parts = parts_of(request);
  std::vector<const FigurePiece*> work;
  std::vector<std::size_t> part_of;  // the piece
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (const FigurePiece& piece : parts[k].work) {
      work.push_back(&piece);
      part_of.push_back(k);
    }

  Json failed = Json::array();
  std::vector<double> took_s(parts.size());
  std::size_t done = 0;
  std::mutex reporting;
  in_threads(work.size(), request.threads, [&](std::size_t i) {
    if (request.deadline.passed()) return;
    const Interruptible ends_solves([&] { return request.deadline.passed(); });
    const auto began = std::chrono::steady_clock::now();
    std::string why;
    try {
      work[i]->run();
    } catch (const std::exception& thrown) {
      why = work[i]->name + ": " + thrown.what();
    }
    const std::lock_guard lock(reporting);
    took_s[part_of[i]] += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (!why.empty()) failed.push_back(why);
    ++done;
    if (request.progress) request.progress(done, work.size(), work[i]->name);
  });

  if (request.deadline.passed()) return {};

  Json json = Json::object();
  json["threads"] = request.threads > 0 ? request.threads : std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    parts[k].finish(json);
    if (!parts[k].work.empty()) json["times"].push_back({{"name", parts[k].name}, {"wall_s", took_s[k]}});
  }
  if (!failed.empty()) json["failed"] = std::move(failed);
  return json;
}

}  // namespace ehd::verification
