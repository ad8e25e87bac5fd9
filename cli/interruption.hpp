// SPDX-License-Identifier: GPL-3.0-or-later
// How the program ends by a signal, or where there is no memory left for an exception.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace ehd::cli {

/// From now on SIGINT, SIGTERM and SIGHUP remove the temporary files, print `message` and a line feed on standard
/// error, and end the program as they usually do; so does SIGPIPE, without a line. A signal that the caller of the
/// program ignores (nohup) stays ignored. The text must live as long as the program. A later call changes the message.
void say_when_interrupted(const char* message);

/// For main: every command says that it was interrupted. A file that grows beyond the limit of the shell (ulimit -f) is
/// an error of the write, not a signal. Lack of memory is one line and exit code 1 even where there is none left for
/// the exception itself.
void handle_signals();

/// For main, before all else: takes a megabyte for the stack while there is memory. A stack that cannot grow ends the
/// program by SIGSEGV, without a word. Throws std::bad_alloc where there is no memory.
void take_stack();

/// While one lives, the first SIGINT, SIGTERM or SIGHUP calls `keep`, which writes what is finished and returns the
/// line for standard error; the program then ends by the signal. `keep` runs in a thread of its own, and the others go
/// on until it returns: it holds a lock where it reads what they write. A second signal ends the program at once. Where
/// the system refuses the thread, so does the first. At most one lives at a time.
class KeepWhenInterrupted {
 public:
  explicit KeepWhenInterrupted(std::function<std::string()> keep);
  /// Where a signal has come, it waits for the end of the program.
  ~KeepWhenInterrupted();
  KeepWhenInterrupted(const KeepWhenInterrupted&) = delete;
  KeepWhenInterrupted& operator=(const KeepWhenInterrupted&) = delete;

  /// Call before a result is recorded. Where a signal has come, which may have ended a child process that the result is
  /// made of, it waits for the end of the program.
  static void before_recording();

 private:
  void wait_for_signal(int pipe) const;
  std::function<std::string()> keep_;
  int ends_[2] = {-1, -1};  ///< of a pipe: the number of the signal, or 0 at the end
  std::thread keeper_;
};

}  // namespace ehd::cli
