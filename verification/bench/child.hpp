// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, whose memory can be told from ours.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace ehd::verification {

struct ChildEnd {
  std::optional<std::string> text;  ///< what the work returned
  std::string why;                  ///< where there is no text: how the child ended
};

/// Calls `work` in a forked child and brings its text back. The caller may have no other thread running, since those
/// do not come along (a lock that one of them held would stay locked).
[[nodiscard]] ChildEnd in_child(const std::function<std::string()>& work);

/// The most memory that this process ever held (a forked one begins with what it inherits), and what it holds now.
[[nodiscard]] double peak_memory_bytes();
[[nodiscard]] double resident_memory_bytes();

/// Gives pages that were freed back to the system, so that using them again counts.
void return_free_memory();

}  // namespace ehd::verification
