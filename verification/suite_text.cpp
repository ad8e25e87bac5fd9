// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of the suite shows: a table of the rungs on the terminal, results.json.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "io/provenance.hpp"
#include "io/tables.hpp"
#include "verification/report/schemas.hpp"
#include "verification/suite.hpp"
#include "verification/traceability.hpp"

namespace ehd::verification {

std::vector<RungSummary> summarise(const SuiteResult& result) {
  std::vector<RungSummary> summaries;
  for (int rung = 0; rung < rungs; ++rung) {
    RungSummary summary{.rung = rung};
    for (const Claim& one : result.claims) {
      if (one.says.rung != rung) continue;
      ++(one.verdict == Verdict::pass   ? summary.pass
         : one.verdict == Verdict::fail ? summary.fail
                                        : summary.inconclusive);
      const double margin = one.margin();
      if (one.finding || !(one.tolerance.value() > 0) || !std::isfinite(margin)) continue;
      if (summary.worst_margin && *summary.worst_margin <= margin) continue;
      summary.worst_margin = margin;
      summary.worst_claim = one.says.id;
    }
    for (const SkippedClaim& one : result.skipped) summary.skipped += one.says.rung == rung ? 1 : 0;
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

namespace {

std::string numbers_of(const Claim& claim) {
  std::string text;
  constexpr int digits = 8;
  if (claim.measured && claim.expected && std::isfinite(*claim.measured))
    text += fmt::format("measured {}, expected {}; ", plain(*claim.measured, digits), plain(*claim.expected, digits));
  text += "error " + (std::isfinite(claim.error) ? plain(claim.error, 3) : std::string("unknown"));
  if (claim.uncertainty != 0) text += " +- " + plain(claim.uncertainty, 2);
  return fmt::format("{}{}{} ({})", text, claim.verdict == Verdict::pass ? " <= " : ", tolerance ",
                     plain(claim.tolerance.value(), 3), claim.tolerance.reason());
}

}  // namespace

std::string human_summary(const SuiteResult& result, bool all) {
  const bool nothing_judged = result.claims.empty();
  std::string text;
  std::vector<std::vector<std::string>> table{
      {"rung", "", "worst claim", "pass", "fail", "inconclusive", "skipped", "margin"}};
  std::size_t total[3] = {0, 0, 0};
  const std::vector<RungSummary> summaries = summarise(result);
  for (int rung = 0; rung < rungs; ++rung) {
    const RungSummary& summary = summaries[static_cast<std::size_t>(rung)];
    std::string lines;
    for (const Claim& claim : result.claims) {
      if (claim.says.rung != rung) continue;
      if (claim.finding) {
        lines += wrapped("  finding  " + claim.says.statement, "    ") + wrapped("        " + claim.note, "        ");
        continue;
      }
      if (!all && claim.verdict == Verdict::pass) continue;
      lines += wrapped(fmt::format("  {}  {}", to_string(claim.verdict), claim.says.statement), "    ");
      lines += wrapped("        " + numbers_of(claim), "        ");
      if (!claim.note.empty()) lines += wrapped("        " + claim.note, "        ");
      if (claim.verdict == Verdict::inconclusive) {
        if (const auto reason = accepted_as_inconclusive(claim.says.id))
          lines += wrapped("        accepted: " + *reason, "        ");
      }
    }
    for (const SkippedClaim& one : result.skipped) {
      if (one.says.rung != rung) continue;
      if (all || nothing_judged)
        lines += wrapped(fmt::format("  skipped  {}: {}", one.says.statement, one.why), "    ");
    }
    if (summary.pass + summary.fail + summary.inconclusive + summary.skipped == 0) continue;
    total[0] += summary.pass;
    total[1] += summary.fail;
    total[2] += summary.inconclusive;
    const std::string name(rung_names[rung]);
    if (!lines.empty()) text += fmt::format("rung {}, {}\n{}\n", rung, name, lines);
    table.push_back({std::to_string(rung), name, summary.worst_margin ? summary.worst_claim : "-",
                     std::to_string(summary.pass), std::to_string(summary.fail), std::to_string(summary.inconclusive),
                     std::to_string(summary.skipped), summary.worst_margin ? percent(*summary.worst_margin, 3) : "-"});
  }
  table.push_back({"all", "", "", std::to_string(total[0]), std::to_string(total[1]), std::to_string(total[2]),
                   std::to_string(result.skipped.size()), ""});
  text += aligned(table, 3) + fmt::format("time {} s\n", plain(result.wall_s, 3));
  if (nothing_judged) {
    const std::size_t rows = result.skipped.size();
    text += fmt::format("nothing could be judged: {}{} skipped, for the reasons above\n", rows,
                        rows == 1 ? " row is" : " rows are");
  }
  return text;
}

Json to_json(const SuiteResult& result) {
  Json json;
  json["schema"] = report::results_schema.name;
  json["provenance"] = provenance();
  Json claims = Json::array(), skipped = Json::array();
  std::size_t count[3] = {0, 0, 0};
  for (const Claim& one : result.claims) {
    ++count[static_cast<int>(one.verdict)];
    Json entry = to_json(one);
    if (const auto reason = accepted_as_inconclusive(one.says.id)) entry["accepted"] = *reason;
    claims.push_back(std::move(entry));
  }
  for (const SkippedClaim& one : result.skipped) skipped.push_back(to_json(one));
  json["summary"] = {{"pass", count[0]},
                     {"fail", count[1]},
                     {"inconclusive", count[2]},
                     {"skipped", result.skipped.size()},
                     {"success", result.success()},
                     {"quick", result.quick},
                     {"selection", result.selection},
                     {"threads", result.threads},
                     {"wall_s", result.wall_s}};
  if (result.not_run > 0) json["summary"]["not_run"] = result.not_run;
  if (result.stopped) json["summary"]["stopped"] = true;
  Json rung_rows = Json::array(), traced = Json::array(), topics = Json::array();
  for (const RungSummary& summary : summarise(result)) {
    Json row = {{"rung", summary.rung}, {"name", rung_names[summary.rung]},     {"pass", summary.pass},
                {"fail", summary.fail}, {"inconclusive", summary.inconclusive}, {"skipped", summary.skipped}};
    put(row, "worst_margin", summary.worst_margin);
    if (summary.worst_margin) row["worst_claim"] = summary.worst_claim;
    rung_rows.push_back(std::move(row));
  }
  for (const TraceRow& row : trace(traceable_parts(), {result.claims, result.skipped})) traced.push_back(to_json(row));
  for (const TopicTime& topic : result.topics) topics.push_back({{"name", topic.name}, {"wall_s", topic.wall_s}});
  json["rungs"] = std::move(rung_rows);
  json["traceability"] = std::move(traced);
  json["claims"] = std::move(claims);
  json["skipped"] = std::move(skipped);
  json["topics"] = std::move(topics);
  return json;
}

}  // namespace ehd::verification
