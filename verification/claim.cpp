// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claim.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/json.hpp"

namespace ehd::verification {

double Claim::margin() const {
  const double used = error + uncertainty;
  if (tolerance.value() == 0) return used == 0 ? 0 : -std::numeric_limits<double>::infinity();
  return 1 - used / tolerance.value();
}

Claim claim(Sentence says, double error, double uncertainty, Tolerance tolerance, std::string note) {
  note.erase(note.find_last_not_of("; ") + 1);  // behind the last part of a list
  const Verdict verdict = judge(error, uncertainty, tolerance);
  return {.says = std::move(says),
          .error = error,
          .uncertainty = uncertainty,
          .tolerance = std::move(tolerance),
          .verdict = verdict,
          .note = std::move(note)};
}

Claim claim_value(Sentence says, double measured, double expected, double uncertainty, Tolerance tolerance,
                  std::string note) {
  const double size = expected == 0 ? 1 : std::abs(expected);
  Claim judged =
      claim(std::move(says), std::abs(measured - expected) / size, uncertainty, std::move(tolerance), std::move(note));
  judged.measured = measured;
  judged.expected = expected;
  return judged;
}

Claim claim_fact(Sentence says, bool holds, std::string where, std::string note) {
  return claim(std::move(says), holds ? 0 : 1, 0, Tolerance::required(0, std::move(where)), std::move(note));
}

Claim claim_finding(Sentence says, std::string note) {
  Claim found = claim_fact(std::move(says), true, "a finding: what was measured, not what has to be", std::move(note));
  found.finding = true;
  return found;
}

namespace {

Json heading(const Sentence& says) {
  Json json = {{"id", says.id}, {"rung", says.rung}, {"statement", says.statement}};
  if (!says.case_id.empty()) json["case"] = says.case_id;
  if (says.version > 0) json["version"] = says.version;
  if (!says.solver.empty()) json["solver"] = says.solver;
  return json;
}

}  // namespace

Json to_json(const Claim& claim) {
  Json json = heading(claim.says);
  put(json, "measured", claim.measured);
  put(json, "expected", claim.expected);
  put(json, "error", claim.error);
  put(json, "uncertainty", claim.uncertainty);
  Json tolerance = Json::object();
  put(tolerance, "value", claim.tolerance.value());
  tolerance["basis"] = claim.tolerance.basis();
  tolerance["reason"] = claim.tolerance.reason();
  json["tolerance"] = tolerance;
  json["verdict"] = to_string(claim.verdict);
  put(json, "margin", claim.margin());
  if (claim.finding) json["finding"] = true;
  if (!claim.note.empty()) json["note"] = claim.note;
  return json;
}

Json to_json(const SkippedClaim& skipped) {
  Json json = heading(skipped.says);
  json["why"] = skipped.why;
  return json;
}

}  // namespace ehd::verification
