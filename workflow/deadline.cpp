// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/deadline.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace ehd {

namespace {
using DeadlineClock = std::chrono::steady_clock;
}  // namespace

Deadline::Deadline(double seconds_from_now)
    : end_(DeadlineClock::now() +
           std::chrono::duration_cast<DeadlineClock::duration>(std::chrono::duration<double>(seconds_from_now))) {}

double Deadline::left_s() const {
  if (!end_) return std::numeric_limits<double>::infinity();
  return std::chrono::duration<double>(*end_ - DeadlineClock::now()).count();
}

ContactSolver Deadline::limiting(ContactSolver solver) const {
  if (!end_) return solver;
  return [deadline = *this, solver = std::move(solver)](const Problem& problem, const Request& request) {
    Solution solution;
    const double left_s = deadline.left_s();
    if (left_s <= 0) {
      solution.record.status = StopReason::limit_reached;
      solution.record.reason = not_run;
      return solution;
    }
    Request shorter = request;
    shorter.time_limit_s = std::min(request.time_limit_s, left_s);
    return solver(problem, shorter);
  };
}

}  // namespace ehd
