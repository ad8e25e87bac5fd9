// SPDX-License-Identifier: GPL-3.0-or-later
// From what is promised to what is judged: the parts of the work and the sentences of README.md, each with the claims
// that support it. A full run of the suite fails where a part has no claim that was judged.
#pragma once

#include <string>
#include <vector>

#include "io/json.hpp"
#include "verification/claim.hpp"

namespace ehd::verification {

/// One thing that somebody relies on.
struct TraceablePart {
  std::string id;                     ///< "work/force-law"
  std::string text;                   ///< one sentence
  std::vector<std::string> patterns;  ///< of claim ids; * stands for anything, as in a shell
};

/// The work restated (work/…), then what README.md says (readme/…).
[[nodiscard]] const std::vector<TraceablePart>& traceable_parts();

struct TraceRow {
  TraceablePart part;
  std::size_t pass = 0, fail = 0, inconclusive = 0, skipped = 0;
  std::vector<std::string> examples = {};   ///< ids of at most five claims, from different patterns first
  std::vector<std::string> unmatched = {};  ///< patterns that no claim and no skipped row has
  [[nodiscard]] std::size_t judged() const { return pass + fail + inconclusive; }
};

[[nodiscard]] std::vector<TraceRow> trace(const std::vector<TraceablePart>& parts, const Findings& findings);

/// A claim for each part, on rung 0: it is supported by a claim that was judged, and none of its patterns is a dead
/// letter.
[[nodiscard]] std::vector<Claim> judge_traceability(const std::vector<TraceRow>& rows);

[[nodiscard]] std::string human_trace(const std::vector<TraceRow>& rows);
[[nodiscard]] Json to_json(const TraceRow& row);

}  // namespace ehd::verification
