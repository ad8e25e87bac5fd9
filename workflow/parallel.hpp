// SPDX-License-Identifier: GPL-3.0-or-later
// Independent pieces of work over threads: whoever is free takes the next one.
#pragma once

#include <cstddef>
#include <functional>

namespace ehd {

/// Calls work(0) … work(count - 1), each once, from up to `threads` threads (0: as many as there are cores), the
/// calling one among them; pieces are taken in order. The first exception ends the taking and is thrown again when
/// every thread has come back.
void in_threads(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace ehd
