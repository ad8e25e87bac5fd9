// SPDX-License-Identifier: GPL-3.0-or-later
// What every call through the C interface needs: a return value for each way to end, the thread's last error, and the
// caller's callback.
#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "contact/solution.hpp"

namespace ehd {
struct Interval;
}

namespace ehd::c {

/// An argument is wrong: what() is "name = value: what is wrong; what is allowed".
class BadArgument : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// In a handler: the exception becomes EHD_BAD_INPUT or, for lack of memory and for our own errors, EHD_NOT_MET; the
/// thread's last error says why.
[[nodiscard]] int refused() noexcept;

/// Runs the body of a call and returns what it returns, or what its exception becomes. Nothing is thrown.
template <class Body>
[[nodiscard]] int guarded(const Body& body) noexcept {
  try {
    return body();
  } catch (...) {
    return refused();
  }
}

/// The thread's last error, for a call that ends with EHD_NOT_MET.
void set_last_error(const std::string& line);

/// The last error of a solve, and the return value that belongs to its status.
[[nodiscard]] int ended(const std::string& what, StopReason status, const std::string& reason);

/// Throws BadArgument for a null pointer.
void require_pointer(const void* pointer, const char* name);
void require_in(const char* name, double value, const Interval& allowed);
/// Refuses a name: "argument = name: fault". The fault, such as "is unknown; allowed is a, b", is worded by
/// io/near_miss.hpp.
[[nodiscard]] BadArgument unknown_name(const char* argument, const char* name, const std::string& fault);
/// A tolerance of the films.
void require_tolerance(double tolerance);

/// The callback of the thread that calls, while one of its calls runs.
class Progress {
 public:
  Progress();

  /// Whether the callback has cancelled the call. In the thread that made the call it may be asked again.
  [[nodiscard]] bool cancelled();
  /// Share of the work that is done, for the callback.
  void reached(double done) { done_ = done; }

 private:
  using Clock = std::chrono::steady_clock;
  void ask();

  std::thread::id caller_ = std::this_thread::get_id();
  Clock::time_point asked_ = {};
  std::atomic<double> done_ = 0;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace ehd::c
