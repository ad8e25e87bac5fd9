// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/parallel.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/check.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(parallel)

BOOST_AUTO_TEST_CASE(every_piece_is_done_once_whatever_the_number_of_threads) {
  constexpr std::size_t pieces = 57;
  for (const unsigned threads : {0u, 1u, 2u, 3u, 100u}) {
    std::vector<std::atomic<int>> done(pieces);
    in_threads(pieces, threads, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) BOOST_TEST(times == 1);
  }
  in_threads(0, 2, [](std::size_t) { BOOST_ERROR("there was nothing to do"); });
}

BOOST_AUTO_TEST_CASE(a_long_piece_does_not_hold_up_the_others) {
  constexpr std::size_t pieces = 9;
  std::atomic<std::size_t> short_ones = 0;
  bool waited_in_vain = true;
  in_threads(pieces, 2, [&](std::size_t i) {
    if (i > 0) {
      ++short_ones;
      return;
    }
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (short_ones + 1 < pieces && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    waited_in_vain = short_ones + 1 < pieces;
  });
  BOOST_TEST(!waited_in_vain);
}

BOOST_AUTO_TEST_CASE(as_many_threads_work_as_were_asked_for) {
  std::atomic<int> inside = 0;
  int most = 0;
  in_threads(3, 3, [&](std::size_t i) {
    ++inside;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (inside < 3 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    if (i == 0) most = inside;
  });
  BOOST_TEST(most == 3);
}

/// Does the work in a child that may start no thread. A limit on processes does not hold for root.
BOOST_AUTO_TEST_CASE(refused_threads_leave_the_work_to_those_there_are) {
  const pid_t child = ::fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    const rlimit none{0, 0};
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(2);
    if (::setrlimit(RLIMIT_NPROC, &none) != 0) ::_exit(2);
    try {
      int done = 0;
      const std::size_t threads = in_threads(5, 3, [&](std::size_t) { ++done; });
      ::_exit(done == 5 && threads == 1 ? 0 : 3);
    } catch (...) {
      ::_exit(4);
    }
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  BOOST_TEST(WIFEXITED(status));
  BOOST_TEST(WEXITSTATUS(status) == 0);
}

BOOST_AUTO_TEST_CASE(what_a_piece_throws_reaches_the_caller_and_ends_the_work) {
  for (const unsigned threads : {1u, 2u}) {
    std::atomic<int> done = 0;
    BOOST_CHECK_THROW(in_threads(1000, threads,
                                 [&](std::size_t i) {
                                   if (i == 3) throw std::runtime_error("three");
                                   ++done;
                                   std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                 }),
                      std::runtime_error);
    BOOST_TEST(done < 100);
  }
}

BOOST_AUTO_TEST_SUITE_END()
