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

namespace {

void end(Solution& solution, const char* why) {
  solution.record.status = StopReason::limit_reached;
  solution.record.reason = why;
}
void end(Response& response, const char* why) {
  response.status = StopReason::limit_reached;
  response.reason = why;
}

/// A function of a problem and a request with a time limit, which gets no more time than is left.
template <class Result, class Asked>
std::function<Result(const Problem&, const Asked&)> limited(const Deadline& deadline,
                                                            std::function<Result(const Problem&, const Asked&)> solve) {
  return [deadline, solve = std::move(solve)](const Problem& problem, const Asked& request) {
    const double left_s = deadline.left_s();
    if (left_s <= 0) {
      Result result;
      end(result, Deadline::not_run);
      return result;
    }
    Asked shorter = request;
    shorter.time_limit_s = std::min(request.time_limit_s, left_s);
    return solve(problem, shorter);
  };
}

}  // namespace

ContactSolver Deadline::limiting(ContactSolver solver) const {
  return end_ ? limited(*this, std::move(solver)) : solver;
}
ContactResponder Deadline::limiting(ContactResponder responder) const {
  return end_ ? limited(*this, std::move(responder)) : responder;
}

}  // namespace ehd
