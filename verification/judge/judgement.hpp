// SPDX-License-Identifier: GPL-3.0-or-later
// A submission scored against the certified digits of its cases.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/judge/profile_gates.hpp"
#include "verification/judge/regimes.hpp"
#include "verification/judge/score.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

/// One certified number of a case, and what was submitted for it.
struct Score {
  Certified certified;
  std::optional<double> value = {};  ///< Hertz units; absent: missing, which scores 0
  std::optional<double> error = {};  ///< relative
  double digits = 0;                 ///< log relative error
  std::optional<double> stated_error = {};
  std::optional<Honesty> honesty = {};
  [[nodiscard]] bool missing() const { return !value; }
};

/// A profile: its gates, and the distance of its pressure from the certified solver's.
struct JudgedProfile {
  std::string file;
  std::vector<Gate> gates;
  std::optional<double> pressure_error = {};  ///< relative L2, where both are known
  std::string truth;                          ///< what P was compared with
};

struct JudgedCase {
  std::string id;
  int version = 0;
  std::string title;
  std::optional<Groups> groups = {};            ///< absent for a dry contact
  std::vector<Score> scores;                    ///< every certified number of the case
  std::vector<std::string> not_certified = {};  ///< submitted, but the case certifies no digits: not scored
  std::optional<JudgedProfile> profile = {};
  std::optional<double> wall_s = {};  ///< as stated
  std::vector<std::string> hints = {};
  bool submitted = true;  ///< false: one of the first cases that the submission leaves out
};

/// Digits of one regime. Every certified number of every case here counts; a missing one as 0.
struct RegimeDigits {
  Regime regime;
  std::size_t numbers = 0, missing = 0;
  double median = 0, worst = 0;
  std::optional<double> median_given = {};  ///< of the numbers that were submitted; absent where there is none
};

struct Judgement {
  Submission submission;
  std::vector<JudgedCase> cases;  ///< the first cases in their order, then the others by id
  std::vector<RegimeDigits> regimes;
  std::size_t met = 0, missed = 0, undecided = 0;  ///< stated errors
  [[nodiscard]] bool gates_hold() const;           ///< no gate failed
};

struct JudgeRequest {
  /// Called before each case, with the number of cases that are judged and that of all.
  std::function<void(const std::string& id, std::size_t done, std::size_t all)> progress = {};
};

/// Reads the cases and profiles of a submission and scores them. Throws CaseError: an unknown case, a bearing, another
/// version than the case has now, a scaling that the case leaves open, a bad profile.
[[nodiscard]] Judgement judgement_of(const Submission& submission, const JudgeRequest& request = {});

}  // namespace ehd::judging
