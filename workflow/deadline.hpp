// SPDX-License-Identifier: GPL-3.0-or-later
// The time for all the solves of a command together, beside the limit of each.
#pragma once

#include <chrono>
#include <optional>

#include "contact/interruption.hpp"
#include "workflow/bearing_response.hpp"
#include "workflow/contact_cache.hpp"

namespace ehd {

class Deadline {
 public:
  Deadline() = default;  ///< none
  explicit Deadline(double seconds_from_now);

  [[nodiscard]] bool passed() const { return left_s() <= 0; }
  [[nodiscard]] double left_s() const;  ///< infinite without a deadline
  /// The solver, which gets no more time than is left. When none is left, it is not called, and the solution is
  /// `limit_reached` with the reason not_run. The caches around the solver see the request as it was.
  [[nodiscard]] ContactSolver limiting(ContactSolver solver) const;
  [[nodiscard]] ContactResponder limiting(ContactResponder responder) const;

  // What reasons say, so that a later run can tell a row that had too little time from one that never ends.
  static constexpr const char* out_of_time = time_limit_reason;
  static constexpr const char* not_run = "not run: the time for everything has passed";

 private:
  std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace ehd
