// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <set>
#include <thread>
#include <utility>

#include "contact/interruption.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "verification/bench/child.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/traceability.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification {

/// The result of a topic.
struct JudgedTopic {
  Findings findings = {};
  double took_s = 0;
  bool left_out = false;
};

namespace {

/// Claims that may stay inconclusive, with the reason. The aim is an empty list.
const std::map<std::string, std::string> accepted = {};

std::vector<LoadedCase> load_cases(const SuiteRequest& request) {
  std::vector<LoadedCase> cases;
  if (request.case_id) {  // an error in a case that the caller named goes to the caller
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

std::vector<Topic> topics_of(const SuiteRequest& request, const std::vector<LoadedCase>& cases) {
  std::vector<Topic> topics;
  const auto add = [&](const std::vector<Topic>& more) { topics.insert(topics.end(), more.begin(), more.end()); };
#define EHD_ADD_TOPICS(NAME, PARAMETERS, ARGUMENTS) add(NAME##_topics ARGUMENTS);
  EHD_TOPICS(EHD_ADD_TOPICS)
#undef EHD_ADD_TOPICS
  return topics;
}

/// Makes repeated texts distinct: "box", "box 2", ...
class Numbered {
 public:
  [[nodiscard]] std::string operator()(const std::string& text) {
    std::string name = text;
    for (int k = 2; !taken_.insert(name).second; ++k) name = fmt::format("{} {}", text, k);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

/// Short topics count too: a quick suite has many of them.
double expected_s(const Topic& topic, bool quick) {
  constexpr double short_s = 0.1, slow_s = 2;
  if (quick && topic.slow) return 0;
  return topic.expected_s > 0 ? topic.expected_s : topic.slow ? slow_s : short_s;
}

Sentence whole_of(const Topic& topic, const SuiteRequest& request) {
  return {.id = topic.name,
          .rung = request.rung.value_or(*topic.rungs.begin()),
          .statement = topic.name,
          .case_id = topic.case_id};
}

JudgedTopic leave_out(const Topic& topic, const SuiteRequest& request, const char* why) {
  return {.findings = {.claims = {}, .skipped = {{whole_of(topic, request), why}}}, .left_out = true};
}

/// An error that is not a number makes the claim inconclusive.
Findings thrown_by(const Topic& topic, Sentence says, double error, const char* why) {
  says.id += "/ran";
  says.statement = topic.name + " can be judged";
  return {.claims = {claim(std::move(says), error, 0, Tolerance::required(0, "no topic of the suite throws"), why)},
          .skipped = {}};
}

Findings judge_topic(const Topic& topic, const Sentence& whole) {
  try {
    Findings found = topic.judge();
    if (found.claims.empty() && found.skipped.empty())
      found.skipped.push_back({whole, "there is nothing to judge it by (a case says what it expects in [[expect]])"});
    return found;
  } catch (const std::bad_alloc&) {  // the machine lacks memory: the topic has no result
    return thrown_by(topic, whole, std::nan(""), memory_is_exhausted);
  } catch (const std::exception& thrown) {
    return thrown_by(topic, whole, 1, thrown.what());
  }
}

JudgedTopic run_topic(const Topic& topic, const SuiteRequest& request) {
  const Sentence whole = whole_of(topic, request);
  if (request.quick && topic.slow)
    return {.findings = {.claims = {}, .skipped = {{whole, "slow, and --quick was asked for"}}}};
  // Long topics begin first. A topic that would not end before the deadline is not begun.
  if (request.deadline.left_s() <= expected_s(topic, request.quick))
    return leave_out(topic, request, Deadline::not_run);
  const Interruptible ends_solves([&] { return request.deadline.passed(); });
  JudgedTopic topic_ended{.findings = judge_topic(topic, whole)};
  // The deadline may have ended some of its solves: its claims are not known.
  return request.deadline.passed() ? leave_out(topic, request, Deadline::out_of_time) : topic_ended;
}

/// The rungs that any of the topics may judge, but for one: "8, 10, 11".
std::string rungs_of(const std::vector<Topic>& topics, std::optional<int> but_for) {
  std::set<int> all;
  for (const Topic& topic : topics) all.insert(topic.rungs.begin(), topic.rungs.end());
  if (but_for) all.erase(*but_for);
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string selection(const SuiteRequest& request) {
  return fmt::format("{}{}{}", request.rung ? fmt::format("--rung {}", *request.rung) : "",
                     request.rung && request.case_id ? " " : "", request.case_id ? "--case " + *request.case_id : "");
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void fill_in_versions(SuiteResult& result, const std::map<std::string, int>& versions) {
  const auto fill_in_version = [&](Sentence& says) {
    if (const auto at = versions.find(says.case_id); at != versions.end()) says.version = at->second;
  };
  for (Claim& one : result.claims) fill_in_version(one.says);
  for (SkippedClaim& one : result.skipped) fill_in_version(one.says);
}

/// Two claims with one id hide each other from readers of results.json. The second one gets a number, and one more
/// claim, which fails, reports it.
void number_repeated_ids(SuiteResult& result) {
  Numbered ids, skipped_ids;
  for (std::size_t i = 0; i < result.claims.size(); ++i) {
    const Sentence says = result.claims[i].says;
    result.claims[i].says.id = ids(says.id);
    if (result.claims[i].says.id == says.id) continue;
    Sentence unique{.id = ids(says.id + "/unique"), .rung = says.rung, .statement = "one claim is called " + says.id};
    Claim repeated = claim_fact(std::move(unique), false, "an id names one claim",
                                "another is now called " + result.claims[i].says.id);
    result.claims.insert(result.claims.begin() + static_cast<std::ptrdiff_t>(++i), std::move(repeated));
  }
  for (SkippedClaim& one : result.skipped) one.says.id = skipped_ids(one.says.id);
}

/// Case versions where the cases can be read.
std::map<std::string, int> versions_of(const std::vector<LoadedCase>& cases) {
  std::map<std::string, int> versions;
  for (const LoadedCase& loaded : cases)
    if (const auto* one = std::get_if<Case>(&loaded.content)) versions[one->id] = one->version;
  return versions;
}

NothingSelected nothing_for(const SuiteRequest& request, const std::string& allowed_rungs) {
  return NothingSelected(
      fmt::format("there is nothing to verify for {}; allowed here is --rung {}", selection(request), allowed_rungs));
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
  return !stopped && not_run == 0 && !(claims.empty() && skipped.empty()) &&
         std::all_of(claims.begin(), claims.end(), stands);
}

struct SuiteRun::State {
  SuiteRequest request;
  std::vector<Topic> topics;
  std::map<std::string, int> versions;
  std::string allowed_rungs = {};
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::mutex mutex = {};                                ///< of what follows
  std::vector<std::optional<JudgedTopic>> judged = {};  ///< in the order of the topics
  double expected_done_s = 0;

  void judge_topics();
  /// Topics that are not judged are left out.
  [[nodiscard]] SuiteResult result();

 private:
  void record(std::size_t topic, JudgedTopic ended, double all_expected_s);
};

/// Judges all topics in threads.
void SuiteRun::State::judge_topics() {
  // The longest first, so that no thread starts a long topic when the others are done.
  std::vector<std::size_t> order(topics.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return expected_s(topics[a], request.quick) > expected_s(topics[b], request.quick);
  });
  double all_expected_s = 0;
  for (const Topic& topic : topics) all_expected_s += expected_s(topic, request.quick);
  in_threads(topics.size(), request.threads, [&](std::size_t k) {
    const std::size_t i = order[k];
    const auto began = std::chrono::steady_clock::now();
    JudgedTopic ended = run_topic(topics[i], request);
    ended.took_s = seconds_since(began);
    record(i, std::move(ended), all_expected_s);
  });
}

void SuiteRun::State::record(std::size_t topic, JudgedTopic ended, double all_expected_s) {
  const std::lock_guard lock(mutex);
  judged[topic] = std::move(ended);
  expected_done_s += expected_s(topics[topic], request.quick);
  if (!request.progress) return;
  const double elapsed = seconds_since(start);
  const auto done = std::count_if(judged.begin(), judged.end(), [](const auto& one) { return one.has_value(); });
  request.progress(
      {.done = static_cast<std::size_t>(done),
       .all = topics.size(),
       .name = topics[topic].name,
       .elapsed_s = elapsed,
       .left_s = expected_done_s > 0 ? elapsed * (all_expected_s - expected_done_s) / expected_done_s : 0});
}

SuiteResult SuiteRun::State::result() {
  SuiteResult result;
  result.threads = request.threads > 0 ? request.threads : std::max(1U, std::thread::hardware_concurrency());
  result.quick = request.quick;
  result.selection = selection(request);
  {
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < topics.size(); ++i) {
      const JudgedTopic topic =
          judged[i] ? *judged[i] : leave_out(topics[i], request, "not finished: the program was interrupted");
      result.topics.push_back({topics[i].name, topic.took_s});
      result.not_run += topic.left_out ? 1 : 0;
      result.claims.insert(result.claims.end(), topic.findings.claims.begin(), topic.findings.claims.end());
      result.skipped.insert(result.skipped.end(), topic.findings.skipped.begin(), topic.findings.skipped.end());
    }
  }
  fill_in_versions(result, versions);
  if (result.selection.empty() && !request.quick &&
      result.not_run == 0) {  // in a selection, a part of the work may have no claim
    for (Claim& one : judge_traceability(trace(traceable_parts(), {result.claims, result.skipped})))
      result.claims.push_back(std::move(one));
  }
  if (request.rung) {
    const auto elsewhere = [&](const auto& one) { return one.says.rung != *request.rung; };
    std::erase_if(result.claims, elsewhere);
    std::erase_if(result.skipped, elsewhere);
  }
  const auto by_rung = [](const auto& a, const auto& b) { return a.says.rung < b.says.rung; };
  std::stable_sort(result.claims.begin(), result.claims.end(), by_rung);
  std::stable_sort(result.skipped.begin(), result.skipped.end(), by_rung);
  number_repeated_ids(result);
  result.wall_s = seconds_since(start);
  return result;
}

SuiteRun::SuiteRun(const SuiteRequest& request) : SuiteRun(request, load_cases(request)) {}

SuiteRun::SuiteRun(const SuiteRequest& request, const std::vector<LoadedCase>& cases)
    : SuiteRun(request, topics_of(request, cases), versions_of(cases)) {}

SuiteRun::SuiteRun(const SuiteRequest& request, std::vector<Topic> topics, std::map<std::string, int> versions)
    : state_(new State{.request = request, .topics = std::move(topics), .versions = std::move(versions)}) {
  std::vector<Topic>& all = state_->topics;
  Numbered topic_names;  // of all topics, also of those left out below, so that a topic always has the same name
  for (Topic& topic : all) topic.name = topic_names(topic.name);
  std::erase_if(all, [&](const Topic& topic) { return request.case_id && topic.case_id.empty(); });
  state_->allowed_rungs = rungs_of(all, request.rung);
  std::erase_if(all, [&](const Topic& topic) { return request.rung && !topic.rungs.contains(*request.rung); });
  if (all.empty()) throw nothing_for(request, state_->allowed_rungs);
  state_->judged.resize(all.size());
}

SuiteRun::~SuiteRun() = default;

SuiteResult SuiteRun::judge() {
  run_memory().forget();  // the solutions of an earlier run in this program
  state_->judge_topics();
  SuiteResult result = state_->result();
  if (result.claims.empty() && result.skipped.empty()) throw nothing_for(state_->request, state_->allowed_rungs);
  return result;
}

SuiteResult SuiteRun::stopped() const {
  SuiteResult result = state_->result();
  result.stopped = true;
  return result;
}

SuiteResult run_suite(const SuiteRequest& request) { return SuiteRun(request).judge(); }

SuiteResult run_topics(const SuiteRequest& request, std::vector<Topic> topics, std::map<std::string, int> versions) {
  return SuiteRun(request, std::move(topics), std::move(versions)).judge();
}

}  // namespace ehd::verification
