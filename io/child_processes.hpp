// SPDX-License-Identifier: GPL-3.0-or-later
// The processes that this process has started, where a signal handler can end them.
#pragma once

#include <sys/types.h>

namespace ehd {

/// The note of one child that leads a process group. kill_child_processes() ends the group while the note exists. There
/// is room for 16 notes; a child beyond that has none.
class ChildNote {
 public:
  explicit ChildNote(pid_t leader);
  ~ChildNote();
  ChildNote(const ChildNote&) = delete;
  ChildNote& operator=(const ChildNote&) = delete;

 private:
  int place_ = -1;
};

/// Ends every group with a note, by SIGKILL. For a signal handler that ends the process: calls only what a handler may
/// call.
void kill_child_processes() noexcept;

}  // namespace ehd
