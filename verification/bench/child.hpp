// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, so that its memory is measured apart from ours.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace ehd::verification {

struct ChildEnd {
  std::optional<std::string> text;  ///< what the work returned
  std::string why;                  ///< where there is no text: how the child ended
};

/// The system refuses a process or a thread: what() says why.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `work` in a forked child and returns its text. No other thread may run: a fork does not copy it, and a lock
/// that it held would stay locked. Throws Refused where there can be no process.
[[nodiscard]] ChildEnd in_child(const std::function<std::string()>& work);

/// The largest memory that this process has held (a forked one begins with its parent's), and the memory that it holds
/// now.
[[nodiscard]] double peak_memory_bytes();
[[nodiscard]] double resident_memory_bytes();

/// Returns freed pages to the system, so that their next use counts as growth.
void return_free_memory();

}  // namespace ehd::verification
