// SPDX-License-Identifier: GPL-3.0-or-later
// Independent pieces of work over threads: a thread that is free takes the next one.
#pragma once

#include <cstddef>
#include <functional>

namespace ehd {

/// Calls work(0) … work(count - 1), each once, from up to `threads` threads (0: one per core), the calling one among
/// them. Pieces start in order. After an exception no piece starts; the first one is thrown again when all threads have
/// ended. Where the system refuses a thread (a limit on processes or memory), those that there are do all the work.
/// Returns the number of threads.
std::size_t in_threads(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace ehd
