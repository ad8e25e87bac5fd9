// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace ehd {

std::size_t in_threads(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex failing;
  std::exception_ptr failure;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min<std::size_t>(threads > 0 ? threads : cores, count);
  std::size_t working = 1;
  {
    std::vector<std::jthread> others;
    others.reserve(workers);
    try {
      for (; working < workers; ++working) others.emplace_back(take);
    } catch (const std::system_error&) {  // refused: go on with fewer
    } catch (const std::bad_alloc&) {
    }
    take();
  }
  if (failure) std::rethrow_exception(failure);
  return working;
}

}  // namespace ehd
