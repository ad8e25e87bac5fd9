// SPDX-License-Identifier: GPL-3.0-or-later
// How a caller ends a solve before its time: a program that embeds the solvers asks its user now and then whether to go
// on. Solvers ask interrupted() wherever they look at the clock, once a Newton iteration, and end with
// StopReason::limit_reached.
#pragma once

#include <functional>

namespace ehd {

/// What a record's reason says of a solve that was ended so.
inline constexpr const char* interrupted_reason = "cancelled by the caller";
/// What it says of a solve that time ended. Other limits end at the same place on every machine.
inline constexpr const char* time_limit_reason = "ended by the time limit";

/// Whether this thread's caller wants its solve to end. False where nobody can say so.
[[nodiscard]] bool interrupted();

/// While it lives, interrupted() of this thread asks `wanted`. One inside another takes its place until it ends. The
/// thread that makes it also destroys it.
class Interruptible {
 public:
  explicit Interruptible(std::function<bool()> wanted);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  friend bool interrupted();
  std::function<bool()> wanted_;
  const Interruptible* outer_;
};

}  // namespace ehd
