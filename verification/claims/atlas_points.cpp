// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 10: the atlas (cases/atlas). Its table and its case files agree. Both main solvers meet a sample of its points,
// at tolerances that the atlas was not made with.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "verification/atlas/atlas.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr int rung = 10;

/// A sample over laws, M, L and inlets. Slow: the dense solver needs more than about a second.
struct Sample {
  const char* id;
  bool slow;
};
constexpr Sample sample[] = {
    {"atlas-isoviscous-m0.2-l0-flooded", false}, {"atlas-isoviscous-m50-l0-cut4", false},
    {"atlas-roelands-m5-l5-flooded", false},     {"atlas-roelands-m20-l10-cut4", false},
    {"atlas-roelands-m200-l15-flooded", true},   {"atlas-roelands-m1000-l10-cut4", true},
    {"atlas-barus-m2-l2.5-flooded", false},      {"atlas-barus-m20-l5-cut4", true},
    {"atlas-barus-m100-l10-flooded", true},
};

constexpr double usual_tolerance = 1e-4, certified_tolerance = 1e-7;

SkippedClaim skipped(const std::string& id, const std::string& statement, const std::string& why) {
  return {{.id = id, .rung = rung, .statement = statement}, why};
}

Findings judge_files() {
  const auto folder = atlas_folder();
  const std::string id = "atlas/files",
                    statement = "atlas.csv and the case files beside it say the same of every point";
  std::error_code error;
  if (!std::filesystem::exists(folder / "atlas.csv", error) && atlas_files(folder).empty())
    return {.claims = {}, .skipped = {skipped(id, statement, "there is no atlas in " + cases_folder().string())}};
  std::vector<std::string> differ;
  try {
    differ = atlas_disagreements(folder);
  } catch (const CaseError& wrong) {
    differ.push_back(wrong.what());
  }
  const std::string note = differ.empty() ? fmt::format("{} points", atlas_files(folder).size())
                                          : fmt::format("{} differ, first: {}", differ.size(), differ.front());
  return {.claims = {claim_fact({.id = id, .rung = rung, .statement = statement},
                                differ.empty() && !atlas_files(folder).empty(), "one run writes both", note)},
          .skipped = {}};
}

Findings judge_point(const std::string& id) {
  Findings found;
  const auto file = atlas_folder() / (id + ".toml");
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    found.skipped.push_back(skipped("atlas/" + id, "the solvers meet " + id, "there is no such point in cases/atlas"));
    return found;
  }
  const Case point = read_case(file);
  for (const auto& [solver, tolerance] :
       {std::pair{&default_solver(), usual_tolerance}, std::pair{&certified_solver(), certified_tolerance}}) {
    const ContactRun run = run_contact(point, *solver, {.tolerance = tolerance});
    // The reported error is judged also where the tolerance is not met: it must be honest.
    const bool solved = run.status() == StopReason::converged || run.status() == StopReason::tolerance_not_met;
    const std::string ended = converged(run.solution) ? "" : "; " + how_it_ended(run.solution);
    for (const Expectation& expectation : point.expectations) {
      const std::string name = fmt::format("{} at {}", solver->name, plain(tolerance));
      Sentence says{
          .id = fmt::format("atlas/{}/{}/{}", id, solver->name, expectation.quantity),
          .rung = rung,
          .statement = fmt::format("{} meets {} = {} of {}", name, expectation.quantity, expectation.digits, id),
          .case_id = {},
          .solver = solver->name};
      const bool film = is_judged_film(expectation);
      if (expectation.waiting) {
        says.statement = fmt::format("{} waits for the digits of {}", id, expectation.quantity);
        found.skipped.push_back({says, "the atlas does not know them to 1e-4"});
        continue;
      }
      const auto measured = solved ? measure(run, expectation) : std::nullopt;
      if (solved && !film && !(measured && measured->error)) {
        found.skipped.push_back({says, name + " reports no " + (measured ? "error of it" : "such value")});
        continue;
      }
      const double reported = measured && measured->error ? *measured->error : nothing;
      found.claims.push_back(claim_value(says, measured ? measured->value : nothing, expectation.value, 0,
                                         Tolerance::discretisation(reported + expectation.uncertainty, 1),
                                         fmt::format("tolerance = reported error {} + uncertainty in the atlas {}{}",
                                                     plain(reported, 2), plain(expectation.uncertainty, 2), ended)));
    }
  }
  return found;
}

}  // namespace

std::vector<Topic> atlas_topics() {
  std::vector<Topic> topics{{.name = "atlas files", .rungs = {rung}, .judge = judge_files}};
  for (const Sample& one : sample)
    topics.push_back({.name = std::string("atlas sample ") + one.id,
                      .rungs = {rung},
                      .slow = one.slow,
                      .judge = [id = std::string(one.id)] { return judge_point(id); }});
  return topics;
}

}  // namespace ehd::verification
