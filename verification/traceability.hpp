// SPDX-License-Identifier: GPL-3.0-or-later
// Which claims support which promise: the parts of the work and the sentences of README.md, each with its claims. A
// full run of the suite fails where no claim of a part was judged.
#pragma once

#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/claim.hpp"

namespace ehd::verification {

/// One promise that users rely on.
struct TraceablePart {
  std::string id;                     ///< "work/force-law"
  std::string text;                   ///< one sentence
  std::vector<std::string> patterns;  ///< of claim ids; * stands for any text, as in a shell
};

/// The parts of the work (work/…), then the sentences of README.md (readme/…).
[[nodiscard]] const std::vector<TraceablePart>& traceable_parts();

struct TraceRow {
  TraceablePart part;
  std::size_t pass = 0, fail = 0, inconclusive = 0, skipped = 0;
  std::vector<std::string> examples = {};   ///< ids of at most five claims, from different patterns first
  std::vector<std::string> unmatched = {};  ///< patterns that no claim and no skipped row has
  [[nodiscard]] std::size_t judged() const { return pass + fail + inconclusive; }
};

[[nodiscard]] std::vector<TraceRow> trace(const std::vector<TraceablePart>& parts, const Findings& findings);

/// A claim for each part, on rung 0: a claim that supports it was judged, and each of its patterns matches a claim.
[[nodiscard]] std::vector<Claim> judge_traceability(const std::vector<TraceRow>& rows);

[[nodiscard]] std::string human_trace(const std::vector<TraceRow>& rows);
[[nodiscard]] Json to_json(const TraceRow& row);

}  // namespace ehd::verification
