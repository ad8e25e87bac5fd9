// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/child.hpp"

#include <signal.h>
#include <unistd.h>

#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/sanitizer.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// How far the peak of a child rises while it holds that many bytes, all of them touched.
double rise_with(std::size_t bytes) {
  const ChildEnd end = in_child([&] {
    const double before = resident_memory_bytes();
    {
      std::vector<char> block(bytes, 'x');
      if (block[bytes / 2] != 'x') return std::string();
    }
    return std::to_string(peak_memory_bytes() - before);
  });
  return std::stod(end.text.value());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bench_child)

BOOST_AUTO_TEST_CASE(the_text_comes_back_whole) {
  const std::string long_text(300000, 'y');  // more than a pipe holds
  BOOST_TEST((in_child([&] { return long_text; }).text == long_text));
  BOOST_TEST((in_child([] { return std::string(); }).text == ""));
}

BOOST_AUTO_TEST_CASE(a_child_changes_nothing_of_ours) {
  int ours = 1;
  const ChildEnd end = in_child([&] { return std::to_string(ours = 2); });
  BOOST_TEST((end.text == "2"));
  BOOST_TEST(ours == 1);
}

BOOST_AUTO_TEST_CASE(a_program_ends_with_its_code_and_its_processor_time) {
  BOOST_TEST(run_program("/bin/sh", {"-c", "exit 3"}).exit_code == 3);
  const ProgramEnd idle = run_program("/bin/sh", {"-c", "echo to nobody"});
  const ProgramEnd busy = run_program("/bin/sh", {"-c", "i=0; while [ $i -lt 100000 ]; do i=$((i + 1)); done"});
  BOOST_TEST(idle.exit_code == 0);
  BOOST_TEST(busy.processor_s > idle.processor_s);
  BOOST_CHECK_THROW((void)run_program("/no/such/program", {}), Refused);
  BOOST_CHECK_THROW((void)run_program("/bin/sh", {"-c", "kill -9 $$"}), Refused);
}

BOOST_AUTO_TEST_CASE(a_child_that_fails_says_how) {
  const ChildEnd thrown = in_child([]() -> std::string { throw std::runtime_error("no film"); });
  BOOST_TEST(!thrown.text);
  BOOST_TEST(thrown.why == "no film");
  const ChildEnd killed = in_child([]() -> std::string {
    ::kill(::getpid(), SIGKILL);
    return "survived";
  });
  BOOST_TEST(!killed.text);
  BOOST_TEST(killed.why.find("Killed") != std::string::npos, killed.why);
  BOOST_TEST(in_child([]() -> std::string { ::_exit(9); }).why == "exit code 9");
}

// The library ends a program without memory for an exception by std::terminate.
BOOST_AUTO_TEST_CASE(a_child_that_lacks_memory_is_told_from_one_that_fails) {
  BOOST_CHECK_THROW((void)in_child([]() -> std::string { throw std::bad_alloc(); }), std::bad_alloc);
  BOOST_CHECK_THROW((void)in_child([]() -> std::string { std::terminate(); }), std::bad_alloc);
  const auto out_of_noexcept = [](const auto& thrown) noexcept { std::rethrow_exception(thrown); };
  const auto child_of = [&](const auto& thrown) {
    return in_child([&]() -> std::string {
      ::signal(SIGABRT, SIG_DFL);  // Boost.Test has a handler
      out_of_noexcept(std::make_exception_ptr(thrown));
      return {};
    });
  };
  BOOST_CHECK_THROW((void)child_of(std::bad_alloc()), std::bad_alloc);
  const ChildEnd wrong = child_of(std::runtime_error("no film"));
  BOOST_TEST(wrong.why.find("Aborted") != std::string::npos, wrong.why);
}

BOOST_AUTO_TEST_CASE(the_peak_is_what_the_child_held, *testing::needs_measurable_memory()) {
  constexpr double megabyte = 1024 * 1024;
  constexpr std::size_t held = 64;
  const double rise = rise_with(held * 1024 * 1024) / megabyte;
  // The pages that the run-time library itself touches on the way.
  EHD_CHECK(std::abs(rise - static_cast<double>(held)),
            Tolerance::calibrated(4, "megabytes; measured 0.1 to 1.5 above the block"));
  EHD_CHECK(rise_with(1024 * 1024) / megabyte, Tolerance::calibrated(5, "megabytes of a block of 1"));
}

BOOST_AUTO_TEST_CASE(a_child_does_not_inherit_the_peak_of_its_parent, *testing::needs_measurable_memory()) {
  constexpr double megabyte = 1024 * 1024;
  { const std::vector<char> freed(256 * 1024 * 1024, 'z'); }
  BOOST_TEST(peak_memory_bytes() > 256 * megabyte);
  EHD_CHECK(rise_with(1024 * 1024) / megabyte, Tolerance::calibrated(5, "megabytes of a block of 1"));
}

BOOST_AUTO_TEST_CASE(what_a_child_holds_counts_though_its_parent_had_freed_as_much,
                     *testing::needs_measurable_memory()) {
  constexpr double megabyte = 1024 * 1024;
  constexpr std::size_t size = 1000, held = 32 * 1024;  // small blocks, which the library keeps when they are freed
  const auto blocks = [](std::size_t count) {
    std::vector<std::unique_ptr<char[]>> all;
    for (std::size_t i = 0; i < count; ++i) all.emplace_back(std::make_unique<char[]>(size));
    return all;
  };
  auto ours = blocks(2 * held);
  const auto last = std::make_unique<char[]>(size);  // above them, so that they are not given back by themselves
  ours.clear();
  const ChildEnd end = in_child([&] {
    const double before = resident_memory_bytes();
    const auto theirs = blocks(held);
    return std::to_string(theirs.back()[0] + peak_memory_bytes() - before);
  });
  EHD_CHECK(std::abs(std::stod(end.text.value()) - size * held) / megabyte,
            Tolerance::calibrated(4, "megabytes; blocks have headers, and their pointers an array"));
  BOOST_TEST(last[0] == 0);
}

BOOST_AUTO_TEST_SUITE_END()
