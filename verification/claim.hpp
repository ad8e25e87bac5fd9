// SPDX-License-Identifier: GPL-3.0-or-later
// A claim: one sentence about the program, with its verdict. A sentence that could not be judged has a reason instead.
#pragma once

#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "verification/report/ladder.hpp"
#include "verification/tolerance.hpp"

namespace ehd::verification {

/// The ladder: each rung assumes the one below.
inline constexpr std::string_view rung_names[] = {"inputs",   "kernel",  "operator",  "elasticity",
                                                  "Reynolds", "coupled", "solvers",   "twins",
                                                  "grids",    "regimes", "published", "bearing"};
inline constexpr int rungs = report::rungs;
static_assert(std::size(rung_names) == rungs);

/// What a claim says, and about which case and solver.
struct Sentence {
  std::string id;  ///< unique: "own-moes-20-10/fast/film.minimum/expected"
  int rung = 0;
  std::string statement;  ///< "fast meets the computed film.minimum of own-moes-20-10"
  std::string case_id = {};
  std::string solver = {};
  int version = 0;  ///< of the case; 0 where there is none. The suite fills it in.
};

struct Claim {
  Sentence says;
  std::optional<double> measured = {}, expected = {};  ///< absent where a claim is a yes or a no
  double error = 0;        ///< compared with the tolerance; NaN where nothing could be measured
  double uncertainty = 0;  ///< of that error, where the tolerance does not contain it
  Tolerance tolerance;
  Verdict verdict;
  std::string note = {};  ///< numbers or the reason, for a reader
  bool finding = false;   ///< reports a computed result and does not judge it; always shown

  /// 1 - (error + uncertainty)/tolerance: 1 nothing used, 0 just met, negative beyond. 0 or -infinity where the
  /// tolerance is 0.
  [[nodiscard]] double margin() const;
};

/// Judged by error and uncertainty against the tolerance.
[[nodiscard]] Claim claim(Sentence says, double error, double uncertainty, Tolerance tolerance, std::string note = {});
/// |measured - expected| relative to |expected| (absolute where that is 0); measured = NaN where a solve gave nothing.
[[nodiscard]] Claim claim_value(Sentence says, double measured, double expected, double uncertainty,
                                Tolerance tolerance, std::string note = {});
/// A yes or a no: error 0 or 1 against the tolerance 0.
[[nodiscard]] Claim claim_fact(Sentence says, bool holds, std::string where, std::string note = {});

/// A statement from the literature beside the computed result. It passes when the result could be computed.
[[nodiscard]] Claim claim_finding(Sentence says, std::string note);

/// The larger of two errors, and NaN once one is NaN (std::max drops it).
[[nodiscard]] inline double worse(double one, double other) {
  if (std::isnan(one) || one >= other) return one;
  return other;
}
template <class... More>
[[nodiscard]] double worse(double one, double other, double third, More... more) {
  return worse(worse(one, other), third, more...);
}

/// A sentence that could not be judged, and why.
struct SkippedClaim {
  Sentence says;
  std::string why;
};

/// The result of a topic.
struct Findings {
  std::vector<Claim> claims;
  std::vector<SkippedClaim> skipped;
};

/// The entry in results.json. Numbers that are not finite are left out.
[[nodiscard]] Json to_json(const Claim& claim);
[[nodiscard]] Json to_json(const SkippedClaim& skipped);

}  // namespace ehd::verification
