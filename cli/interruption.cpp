// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interruption.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

#include "cli/usage.hpp"
#include "contact/text.hpp"
#include "io/child_processes.hpp"
#include "io/temporary_files.hpp"

namespace ehd::cli {

namespace {

// Set before the handler is.
std::atomic<const char*> interruption_message = "";
std::atomic<bool> behind_progress = false;  ///< a line of progress may stand on the terminal
std::atomic<pid_t> owner = 0;               ///< a forked child has other work than to remove its parent's files
std::atomic<bool> told = false;             ///< that the program was interrupted

/// Where a KeepWhenInterrupted waits for the number of a signal.
constexpr int nobody_waits = -1, signal_has_come = -2;
std::atomic<int> pipe_to_keeper = nobody_waits;

/// More than the solvers need, whose small matrices Eigen puts there.
constexpr std::size_t stack_bytes = std::size_t{1} << 20;

/// Writes the far end of so much stack. The kernel then gives the program all of it, and fills no memory but that end.
[[gnu::noinline]] void reach_down() {
  [[maybe_unused]] volatile char room[stack_bytes];
  room[0] = 0;
}

void tell(const char* text) { [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text)); }

/// What the program does before it ends by a signal. An empty line is not told.
void leave(const char* line) {
  kill_child_processes();  // they may be writing
  remove_temporary_files();
  if (*line == '\0' || told.exchange(true)) return;
  if (behind_progress) tell("\n");
  tell(line);
  tell("\n");
}

/// True for the first signal, if somebody keeps what is finished.
bool left_to_keeper(int signal) {
  int pipe = pipe_to_keeper;
  while (pipe >= 0 && !pipe_to_keeper.compare_exchange_weak(pipe, signal_has_come)) {
  }
  if (pipe < 0) return false;
  const int before = errno;
  const auto number = static_cast<unsigned char>(signal);
  const bool written = ::write(pipe, &number, 1) == 1;
  errno = before;
  return written;
}

/// Calls only what a signal handler may call.
extern "C" void end_by_signal(int signal) {
  if (::getpid() == owner) {
    if (signal != SIGPIPE && left_to_keeper(signal)) return;
    leave(signal == SIGPIPE ? "" : interruption_message.load());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Every signal goes to another thread while this lives.
class SignalsElsewhere {
 public:
  SignalsElsewhere() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsElsewhere() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsElsewhere(const SignalsElsewhere&) = delete;
  SignalsElsewhere& operator=(const SignalsElsewhere&) = delete;

 private:
  sigset_t before_{};
};

[[noreturn]] void wait_for_the_end() {
  for (;;) ::pause();
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
  action.sa_flags = SA_RESTART;  // the handler may return
  ::sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
}

void take_stack() {
  rlimit allowed{};
  if (::getrlimit(RLIMIT_STACK, &allowed) != 0 || allowed.rlim_cur < 4 * stack_bytes) return;  // a user's small stack
  void* const room = ::mmap(nullptr, stack_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, stack_bytes);
  reach_down();
}

void handle_signals() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(end_without_memory);
  say_when_interrupted("ehd: interrupted; no unfinished file is left");
}

KeepWhenInterrupted::KeepWhenInterrupted(std::function<std::string()> keep) : keep_(std::move(keep)) {
  if (::pipe2(ends_, O_CLOEXEC) != 0) return;
  try {
    const SignalsElsewhere inherited;
    keeper_ = std::thread([this] { wait_for_signal(ends_[0]); });
  } catch (const std::system_error&) {
    return;
  }
  pipe_to_keeper = ends_[1];
}

KeepWhenInterrupted::~KeepWhenInterrupted() {
  if (keeper_.joinable()) {
    if (pipe_to_keeper.exchange(nobody_waits) == signal_has_come) wait_for_the_end();
    constexpr unsigned char no_signal = 0;
    [[maybe_unused]] const auto written = ::write(ends_[1], &no_signal, 1);
    keeper_.join();
  }
  for (const int end : ends_)
    if (end >= 0) ::close(end);
}

void KeepWhenInterrupted::before_recording() {
  if (pipe_to_keeper == signal_has_come) wait_for_the_end();
}

void KeepWhenInterrupted::wait_for_signal(int pipe) const {
  unsigned char signal = 0;
  while (::read(pipe, &signal, 1) < 0 && errno == EINTR) {
  }
  if (signal == 0) return;
  std::string line;
  try {
    line = keep_();
  } catch (const std::exception& error) {
    line = "ehd: interrupted; " + one_line(error.what());
  }
  leave(line.c_str());
  std::signal(signal, SIG_DFL);
  ::kill(::getpid(), signal);
  wait_for_the_end();
}

}  // namespace ehd::cli
