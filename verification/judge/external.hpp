// SPDX-License-Identifier: GPL-3.0-or-later
// A solver outside this program, beside ours: it gets a case as JSON and leaves a submission.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "verification/bench/film_truth.hpp"
#include "verification/judge/command.hpp"
#include "workflow/case.hpp"

namespace ehd::judging {

struct ExternalSolver {
  std::string name;
  std::string command;  ///< for the shell, with {case}, {out} and {tolerance} where its words go
};

/// From NAME='command {case} {out} {tolerance}'. Throws std::invalid_argument, which says what is allowed.
[[nodiscard]] ExternalSolver external_from(const std::string& text);

/// One call. The run has the films that the submission gives, in Hertz units, with the error that it states. Its
/// status: converged (exit code 0), tolerance-not-met (another exit code, but films), limit-reached (the time limit),
/// diverged (neither film); its reason says how the command ended and what it said last. An external run is never the
/// truth.
struct ExternalRun {
  verification::JudgedRun judged;
  CommandEnd end;
  std::vector<std::string> hints = {};  ///< for films far off the case's digits; nothing is solved for them
};
[[nodiscard]] ExternalRun run_external(const ExternalSolver& solver, const Case& contact_case, double tolerance,
                                       double time_limit_s);

}  // namespace ehd::judging
