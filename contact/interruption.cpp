// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/interruption.hpp"

#include <utility>

namespace ehd {

namespace {
thread_local const Interruptible* innermost = nullptr;
}  // namespace

Interruptible::Interruptible(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), outer_(std::exchange(innermost, this)) {}

Interruptible::~Interruptible() { innermost = outer_; }

bool interrupted() { return innermost && innermost->wanted_(); }

}  // namespace ehd
