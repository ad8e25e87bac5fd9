// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/child_processes.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace ehd {

namespace {

constexpr std::size_t most_children = 16;
constexpr pid_t nobody = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may not wait for a lock");

std::array<std::atomic<pid_t>, most_children> children;

}  // namespace

ChildNote::ChildNote(pid_t leader) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    pid_t expected = nobody;
    if (!children[i].compare_exchange_strong(expected, leader)) continue;
    place_ = static_cast<int>(i);
    return;
  }
}

ChildNote::~ChildNote() {
  if (place_ >= 0) children[static_cast<std::size_t>(place_)] = nobody;
}

void kill_child_processes() noexcept {
  for (const auto& child : children) {
    const pid_t leader = child;
    if (leader != nobody) ::kill(-leader, SIGKILL);
  }
}

}  // namespace ehd
