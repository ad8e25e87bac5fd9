// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/traceability.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/claims/shared.hpp"

namespace ehd::verification {

namespace {

bool matches(const std::string& pattern, const std::string& id) {
  return ::fnmatch(pattern.c_str(), id.c_str(), 0) == 0;
}

}  // namespace

const std::vector<TraceablePart>& traceable_parts() {
  static const std::vector<TraceablePart> parts{
      {"work/contact",
       "the full EHD line contact: Reynolds' equation, the film with elastic deformation, the load balance",
       {"manufactured/*", "own-moes-*/film.*", "kostreva-*/film.*", "regimes/*", "reynolds/*", "elasticity/*",
        "properties/monotone/*", "properties/similarity/*", "properties/conserved/*"}},
      {"work/rheology",
       "viscosity by Roelands (and Barus), density by Dowson and Higginson",
       {"inputs/laws/*", "manufactured/compressible/*", "manufactured/barus/*", "reynolds/*/barus"}},
      {"work/multilevel",
       "multilevel solution of Reynolds' equation with a fast evaluation of the deformation integral",
       {"operator/*", "iteration/*/multigrid*", "twins/*"}},
      {"work/direct",
       "a direct dense solver beside it",
       {"kernel/*", "*/certified/*", "*/reference-fast/*", "iteration/*/newton*"}},
      {"work/force-law",
       "a contact law for each raceway by least squares, f = K_EHD delta + Delta F",
       {"bearing/fit/*", "bearing/curve/*", "na4908*/ehd-linear/*"}},
      {"work/dry-law",
       "the dry law beside it, f = K_Hertz delta^(10/9)",
       {"*/hertz/law", "*/iso/law", "approach/*", "bearing/laws/*"}},
      {"work/equilibrium",
       "equilibrium of the bearing: f_o - f_i = F_c, Sum f_i cos psi = F_r, delta_r cos psi - P_d/2 = delta_i + "
       "delta_o",
       {"*/ring", "*/rollers", "*/geometry", "bearing/sjovall/*", "sjovall/*", "bearing/energy/*",
        "bearing/stiffness/*", "bearing/forms/*", "bearing/statics", "bearing/random/*", "properties/bearing/*"}},
      {"work/kinematics",
       "speed, radii, centrifugal force and datum of each raceway from the bearing's geometry",
       {"bearing/kinematics/*", "bearing/centrifugal-209", "bearing/datum/*"}},
      {"work/example",
       "NA4908 at 5000 rpm and 50 kN with clearances 0, 2.5 and 10 um, dry and EHD",
       {"na4908/*/balanced", "na4908-2.5um/*/balanced", "na4908-10um/*/balanced", "na4908-18mm/*/balanced"}},
      {"work/statements",
       "statements (a) to (d): what the film does to the bearing; for which datum they hold",
       {"paper/*/a", "paper/*/b", "paper/*/c", "paper/*/d", "paper/*/datum", "paper/*/verdict/*", "paper/*/x0/*"}},
      {"readme/one-contact-two-codes",
       "two solvers side by side, each with its own code from the kernel weights up",
       {"kernel/two-codes", "twins/*", "box/*/agreement"}},
      {"readme/reference-digits",
       "reference: films of mild contacts to ten digits and more (Roelands), to seven (Barus)",
       {"*/certified/film.*", "*/reference/film.*/certified"}},
      {"readme/fast-error-bars",
       "the errors that `fast` states cover the true ones",
       {"*/reference-fast/*", "*/fast/stated-*", "random-fast/*", "box/*/agreement"}},
      {"readme/atlas", "cases/atlas: contacts with the digits that are known", {"atlas/files", "atlas/atlas-*"}},
      {"readme/isoviscous-limit",
       fmt::format("the isoviscous elastic limit, film x M^(1/5) = {} and {}", couette_limit, smallest_limit),
       {"regimes/isoviscous-elastic-limit/*"}},
      {"readme/literature",
       "published digits are reproduced; what waits for its source is a row that says so",
       {"kostreva-*/film.*", "harris-209*/hertz/*", "iso-*/iso/*", "computed/*", "exact/*", "*/waiting"}},
      {"readme/formulas", "film formulas stand beside a result and are never a verdict", {"formulas/*"}},
  };
  return parts;
}

std::vector<TraceRow> trace(const std::vector<TraceablePart>& parts, const Findings& findings) {
  std::vector<TraceRow> rows;
  constexpr std::size_t most_examples = 5;
  for (const TraceablePart& part : parts) {
    TraceRow row{.part = part};
    std::vector<bool> used(part.patterns.size(), false);
    const auto match = [&](const std::string& id) {
      bool any = false;
      for (std::size_t i = 0; i < part.patterns.size(); ++i) {
        if (!matches(part.patterns[i], id)) continue;
        if (!used[i] && row.examples.size() < most_examples) row.examples.push_back(id);
        used[i] = any = true;
      }
      return any;
    };
    for (const Claim& one : findings.claims) {
      if (!match(one.says.id)) continue;
      ++(one.verdict == Verdict::pass ? row.pass : one.verdict == Verdict::fail ? row.fail : row.inconclusive);
    }
    for (const SkippedClaim& one : findings.skipped) row.skipped += match(one.says.id) ? 1 : 0;
    for (std::size_t i = 0; i < part.patterns.size(); ++i)
      if (!used[i]) row.unmatched.push_back(part.patterns[i]);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Claim> judge_traceability(const std::vector<TraceRow>& rows) {
  std::vector<Claim> claims;
  for (const TraceRow& row : rows) {
    std::string dead;
    for (const std::string& pattern : row.unmatched) dead += (dead.empty() ? "no claim is called " : ", ") + pattern;
    claims.push_back(claim_fact(
        {.id = "traceability/" + row.part.id, .rung = 0, .statement = "claims were judged of: " + row.part.text},
        row.judged() > 0 && row.unmatched.empty(), "what is promised is judged", dead));
  }
  return claims;
}

std::string human_trace(const std::vector<TraceRow>& rows) {
  std::vector<std::vector<std::string>> table{{"part", "pass", "fail", "inconclusive", "skipped"}};
  std::string text;
  for (const TraceRow& row : rows) {
    table.push_back({row.part.id, std::to_string(row.pass), std::to_string(row.fail), std::to_string(row.inconclusive),
                     std::to_string(row.skipped)});
    text += fmt::format("{}: {}\n ", row.part.id, row.part.text);
    for (const std::string& pattern : row.part.patterns) text += " " + pattern;
    text += "\n";
  }
  return text + "\n" + aligned(table, 1);
}

Json to_json(const TraceRow& row) {
  return {{"part", row.part.id},    {"text", row.part.text},
          {"claims", row.judged()}, {"pass", row.pass},
          {"fail", row.fail},       {"inconclusive", row.inconclusive},
          {"skipped", row.skipped}, {"patterns", row.part.patterns},
          {"ids", row.examples}};
}

}  // namespace ehd::verification
