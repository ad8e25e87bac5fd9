// SPDX-License-Identifier: GPL-3.0-or-later
// Work, or a program, in a process of its own, so that its memory or time is measured apart from ours.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ehd::verification {

struct ChildEnd {
  std::optional<std::string> text;  ///< what the work returned
  std::string why;                  ///< where there is no text: how the child ended
};

/// The system refuses a process or a thread: what() says why.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The reason where memory is lacking.
inline constexpr const char* memory_is_exhausted = "memory is exhausted";

/// Calls `work` in a forked child and returns its text. No other thread may run: a fork does not copy it, and a lock
/// that it held would stay locked. Throws Refused where there can be no process, and std::bad_alloc where the work
/// lacked memory.
[[nodiscard]] ChildEnd in_child(const std::function<std::string()>& work);

struct ProgramEnd {
  int exit_code = 0;
  double processor_s = 0;  ///< of the program and the system for it
};

/// Runs a program to its end, its output thrown away. Throws Refused where there can be no process, where the program
/// does not start, and where a signal ends it.
[[nodiscard]] ProgramEnd run_program(const std::string& path, const std::vector<std::string>& arguments);

/// The largest memory that this process has held (a forked one begins with its parent's), and the memory that it holds
/// now.
[[nodiscard]] double peak_memory_bytes();
[[nodiscard]] double resident_memory_bytes();

/// Returns freed pages to the system, so that their next use counts as growth.
void return_free_memory();

}  // namespace ehd::verification
