// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/suite.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "verification/claims/topics.hpp"
#include "verification/parallel.hpp"
#include "verification/provenance.hpp"
#include "verification/text.hpp"

namespace ehd::verification {

namespace {

constexpr int schema = 1;

/// Claims that may stay inconclusive, with the reason: empty is the aim.
const std::map<std::string, std::string> accepted = {};

std::vector<LoadedCase> load_cases(const SuiteRequest& request) {
  std::vector<LoadedCase> cases;
  if (request.case_id) {  // named: what is wrong with it is the caller's to know
    Case named = read_case(find_case(*request.case_id));
    cases.push_back({named.id, std::move(named)});
    return cases;
  }
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(cases_folder(), error)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  if (files.empty()) throw CaseError(cases_folder().string() + ": has no cases; required is a folder of *.toml files");
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    try {
      Case one = read_case(file);
      std::string id = one.id;
      cases.push_back({std::move(id), std::move(one)});
    } catch (const CaseError& wrong) {
      cases.push_back({file.stem().string(), wrong});
    }
  }
  return cases;
}

std::vector<Topic> topics_of(const SuiteRequest& request) {
  const auto cases = load_cases(request);
  std::vector<Topic> topics;
  for (auto& list : {input_topics(), kernel_topics(), exact_topics(), coupled_topics(), contact_topics(cases), twin_topics(),
                     box_topics(), random_topics(request.random_runs), grid_topics(), regime_topics(), atlas_topics(), bearing_topics(cases)}) {
    topics.insert(topics.end(), list.begin(), list.end());
  }
  std::erase_if(topics, [&](const Topic& topic) {
    return (request.rung && !topic.rungs.contains(*request.rung)) || (request.case_id && topic.case_id.empty());
  });
  return topics;
}

Findings run_topic(const Topic& topic, const SuiteRequest& request) {
  const Sentence whole{
      .id = topic.name, .rung = request.rung.value_or(*topic.rungs.begin()), .statement = topic.name, .case_id = topic.case_id};
  if (request.quick && topic.slow) return {.claims = {}, .skipped = {{whole, "slow, and --quick was asked for"}}};
  try {
    Findings found = topic.judge();
    if (found.claims.empty() && found.skipped.empty())
      found.skipped.push_back({whole, "there is nothing to judge it by (a case says what it expects in [[expect]])"});
    return found;
  } catch (const std::exception& thrown) {
    Sentence says = whole;
    says.id += "/ran";
    says.statement = topic.name + " can be judged";
    return {.claims = {claim_fact(std::move(says), false, "no topic of the suite throws", thrown.what())}, .skipped = {}};
  }
}

std::string selection(const SuiteRequest& request) {
  return (request.rung ? "--rung " + std::to_string(*request.rung) : "") +
         (request.rung && request.case_id ? " " : "") + (request.case_id ? "--case " + *request.case_id : "");
}

}  // namespace

std::optional<std::string> accepted_as_inconclusive(const std::string& claim_id) {
  const auto at = accepted.find(claim_id);
  return at == accepted.end() ? std::nullopt : std::optional(at->second);
}

bool SuiteResult::success() const {
  const auto stands = [](const Claim& claim) {
    return claim.verdict == Verdict::pass ||
           (claim.verdict == Verdict::inconclusive && accepted_as_inconclusive(claim.says.id));
  };
  return !(claims.empty() && skipped.empty()) && std::all_of(claims.begin(), claims.end(), stands);
}

SuiteResult run_suite(const SuiteRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Topic> topics = topics_of(request);
  if (topics.empty()) throw NothingSelected("there is nothing to verify for " + selection(request));

  std::vector<Findings> findings(topics.size());
  std::size_t done = 0;
  std::mutex reporting;
  in_threads(topics.size(), request.threads, [&](std::size_t i) {
    findings[i] = run_topic(topics[i], request);
    const std::lock_guard lock(reporting);
    ++done;
    if (request.progress) request.progress(done, topics.size(), topics[i].name);
  });

  SuiteResult result;
  for (auto& found : findings) {
    std::move(found.claims.begin(), found.claims.end(), std::back_inserter(result.claims));
    std::move(found.skipped.begin(), found.skipped.end(), std::back_inserter(result.skipped));
  }
  if (request.rung) {
    const auto elsewhere = [&](const auto& one) { return one.says.rung != *request.rung; };
    std::erase_if(result.claims, elsewhere);
    std::erase_if(result.skipped, elsewhere);
    if (result.claims.empty() && result.skipped.empty())
      throw NothingSelected("there is nothing to verify for " + selection(request));
  }
  const auto by_rung = [](const auto& a, const auto& b) { return a.says.rung < b.says.rung; };
  std::stable_sort(result.claims.begin(), result.claims.end(), by_rung);
  std::stable_sort(result.skipped.begin(), result.skipped.end(), by_rung);
  // Two claims with one name would hide each other from whoever reads results.json by id.
  std::set<std::string> ids;
  for (const Claim& one : result.claims) {
    if (!ids.insert(one.says.id).second) throw std::logic_error("two claims are called " + one.says.id);
  }
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

namespace {

std::string numbers_of(const Claim& claim) {
  std::string text;
  constexpr int digits = 8;
  if (claim.measured && claim.expected && std::isfinite(*claim.measured))
    text += "measured " + plain(*claim.measured, digits) + ", expected " + plain(*claim.expected, digits) + "; ";
  text += "error " + (std::isfinite(claim.error) ? plain(claim.error, 3) : std::string("unknown"));
  if (claim.uncertainty != 0) text += " +- " + plain(claim.uncertainty, 2);
  return text + (claim.verdict == Verdict::pass ? " <= " : ", tolerance ") + plain(claim.tolerance.value(), 3) + " (" +
         claim.tolerance.reason() + ")";
}

}  // namespace

std::string human_summary(const SuiteResult& result, bool all) {
  const bool nothing_judged = result.claims.empty();
  std::string text;
  std::vector<std::vector<std::string>> table{{"rung", "", "pass", "fail", "inconclusive", "skipped", "tightest margin"}};
  std::size_t total[3] = {0, 0, 0};
  for (int rung = 0; rung < rungs; ++rung) {
    std::size_t count[3] = {0, 0, 0}, skipped = 0;
    double margin = 1;
    std::string lines;
    for (const Claim& claim : result.claims) {
      if (claim.says.rung != rung) continue;
      ++count[static_cast<int>(claim.verdict)];
      if (claim.verdict == Verdict::pass && claim.tolerance.value() > 0) margin = std::min(margin, claim.margin());
      if (claim.finding) {
        lines += "  finding  " + claim.says.statement + "\n        " + claim.note + "\n";
        continue;
      }
      if (!all && claim.verdict == Verdict::pass) continue;
      lines += "  " + std::string(to_string(claim.verdict)) + "  " + claim.says.statement + "\n        " +
               numbers_of(claim) + "\n";
      if (!claim.note.empty()) lines += "        " + claim.note + "\n";
      if (claim.verdict == Verdict::inconclusive) {
        if (const auto reason = accepted_as_inconclusive(claim.says.id)) lines += "        accepted: " + *reason + "\n";
      }
    }
    for (const SkippedClaim& one : result.skipped) {
      if (one.says.rung != rung) continue;
      ++skipped;
      if (all || nothing_judged) lines += "  skipped  " + one.says.statement + ": " + one.why + "\n";
    }
    if (count[0] + count[1] + count[2] + skipped == 0) continue;
    for (int i = 0; i < 3; ++i) total[i] += count[i];
    const std::string name(rung_names[rung]);
    if (!lines.empty()) text += "rung " + std::to_string(rung) + ", " + name + "\n" + lines + "\n";
    table.push_back({std::to_string(rung), name, std::to_string(count[0]), std::to_string(count[1]),
                     std::to_string(count[2]), std::to_string(skipped),
                     count[0] > 0 ? plain(100 * margin, 3) + " %" : "-"});
  }
  table.push_back({"all", "", std::to_string(total[0]), std::to_string(total[1]), std::to_string(total[2]),
                   std::to_string(result.skipped.size()), plain(result.wall_s, 3) + " s"});
  text += aligned(table, 2);
  if (nothing_judged) {
    const std::size_t rows = result.skipped.size();
    text += "nothing could be judged: " + std::to_string(rows) + (rows == 1 ? " row is" : " rows are") +
            " skipped, for the reasons above\n";
  }
  return text;
}

Json to_json(const SuiteResult& result) {
  Json json;
  json["schema"] = schema;
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
                     {"wall_s", result.wall_s}};
  json["claims"] = std::move(claims);
  json["skipped"] = std::move(skipped);
  return json;
}

}  // namespace ehd::verification
