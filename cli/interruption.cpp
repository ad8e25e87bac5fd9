// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interruption.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "cli/usage.hpp"
#include "io/child_processes.hpp"
#include "io/temporary_files.hpp"

namespace ehd::cli {

namespace {

// Set before the handler is.
std::atomic<const char*> interruption_message = "";
std::atomic<bool> behind_progress = false;  ///< a line of progress may stand on the terminal
std::atomic<pid_t> owner = 0;               ///< a forked child has other work than to remove its parent's files

void tell(const char* text) { [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text)); }

/// Calls only what a signal handler may call.
extern "C" void end_by_signal(int signal) {
  if (::getpid() == owner) {
    kill_child_processes();  // they may be writing
    remove_temporary_files();
    if (signal != SIGPIPE) {
      if (behind_progress) tell("\n");
      tell(interruption_message);
      tell("\n");
    }
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// The C++ library comes here without an exception where it has no memory for one.
[[noreturn]] void end_without_memory() {
  const std::exception_ptr thrown = std::current_exception();
  kill_child_processes();
  remove_temporary_files();
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
  } catch (...) {
    tell("ehd: internal error: an exception that nobody catches\n");
    std::abort();
  }
  tell("ehd: memory is exhausted\n");
  ::_exit(not_met);
}

}  // namespace

void say_when_interrupted(const char* message) {
  interruption_message = message;
  behind_progress = ::isatty(STDERR_FILENO) == 1;
  owner = ::getpid();
  struct sigaction action {};
  action.sa_handler = end_by_signal;
  ::sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
}

void handle_signals() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(end_without_memory);
  say_when_interrupted("ehd: interrupted; no unfinished file is left");
}

}  // namespace ehd::cli
