// SPDX-License-Identifier: GPL-3.0-or-later
// A visitor made of one lambda for each alternative of a variant. Without a generic lambda among them, a variant that
// gets a new alternative no longer compiles.
#pragma once

namespace ehd {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace ehd
