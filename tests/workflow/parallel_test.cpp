// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/parallel.hpp"

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
