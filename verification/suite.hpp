// SPDX-License-Identifier: GPL-3.0-or-later
// The verification suite: topics run in threads, their claims are sorted by rung, printed, and written to results.json.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/claim.hpp"
#include "workflow/deadline.hpp"

namespace ehd::verification {

/// How far a run has come.
struct SuiteProgress {
  std::size_t done = 0, all = 0;  ///< topics
  std::string name;               ///< of the topic that ended last
  double elapsed_s = 0;
  double left_s = 0;  ///< estimated from the topics' expected times and the speed so far
};

struct SuiteRequest {
  std::optional<int> rung = {};             ///< 0 to 11
  std::optional<std::string> case_id = {};  ///< a case's id or file
  int random_runs = 10;                     ///< for each law set, of the claims about random points
  bool quick = false;                       ///< slow topics are skipped, each with a line that says so
  unsigned threads = 0;                     ///< 0: as many as there are cores
  /// A topic that is expected to end after it is not run; one that has not ended by then is left out, and its solves
  /// end at their next iteration.
  Deadline deadline = {};
  /// Called after each topic, one thread at a time.
  std::function<void(const SuiteProgress&)> progress = {};
};

struct TopicTime {
  std::string name;
  double wall_s = 0;
};

struct SuiteResult {
  std::vector<Claim> claims;  ///< by rung
  std::vector<SkippedClaim> skipped;
  std::vector<TopicTime> topics;  ///< in the order of the list
  double wall_s = 0;
  unsigned threads = 0;
  bool quick = false;
  std::size_t not_run = 0;  ///< topics that the deadline, or the end of the program, left out
  bool stopped = false;     ///< the program ended before the run did
  std::string selection;    ///< "--rung 7", or empty for everything
  /// The run came to its end, every topic ran, no claim fails, every inconclusive one is accepted with a reason, and
  /// there is a claim, or a skipped row that says why there is none.
  [[nodiscard]] bool success() const;
};

/// The reason for which a claim may stay inconclusive; absent where it may not.
[[nodiscard]] std::optional<std::string> accepted_as_inconclusive(const std::string& claim_id);

/// The filters leave no claim; what() names the filters.
class NothingSelected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LoadedCase;  // claims/topics.hpp
struct Topic;

/// A run of the suite. Another thread may look into it.
class SuiteRun {
 public:
  /// Throws NothingSelected, or CaseError for a case that is named and cannot be read.
  explicit SuiteRun(const SuiteRequest& request);
  /// The same for a list of topics; `versions` of the cases by id. Topics, skipped rows and claims that share a name
  /// are numbered ("box", "box 2"). Two claims with one id are an error: one more claim is added, which fails.
  SuiteRun(const SuiteRequest& request, std::vector<Topic> topics, std::map<std::string, int> versions);
  ~SuiteRun();
  SuiteRun(const SuiteRun&) = delete;
  SuiteRun& operator=(const SuiteRun&) = delete;

  /// Call once. Throws NothingSelected. A topic that throws is a failing claim.
  [[nodiscard]] SuiteResult judge();
  /// From any thread: what is judged so far. Topics that are not are left out, each with a row that says so.
  [[nodiscard]] SuiteResult stopped() const;

 private:
  SuiteRun(const SuiteRequest& request, const std::vector<LoadedCase>& cases);
  struct State;
  std::unique_ptr<State> state_;
};

/// Both ways to begin a run, and then judge().
[[nodiscard]] SuiteResult run_suite(const SuiteRequest& request);
[[nodiscard]] SuiteResult run_topics(const SuiteRequest& request, std::vector<Topic> topics,
                                     std::map<std::string, int> versions);

/// The verdicts on one rung.
struct RungSummary {
  int rung = 0;
  std::size_t pass = 0, fail = 0, inconclusive = 0, skipped = 0;
  /// The smallest margin and the id of its claim, among claims with a positive tolerance that are no findings.
  std::optional<double> worst_margin = {};
  std::string worst_claim = {};
};
/// All rungs in order.
[[nodiscard]] std::vector<RungSummary> summarise(const SuiteResult& result);

/// For each rung the claims that failed, in full, then a table with a line for each rung. `all`: passing claims too.
[[nodiscard]] std::string human_summary(const SuiteResult& result, bool all);

/// {"schema", "provenance", "summary", "rungs", "traceability", "claims", "skipped", "topics"}; README.md.
[[nodiscard]] Json to_json(const SuiteResult& result);

}  // namespace ehd::verification
