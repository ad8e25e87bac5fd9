// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "contact/text.hpp"
#include "io/child_processes.hpp"

namespace ehd::judging {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_bytes = 4096, longest_line = 200;
/// What Octave 7 says behind every exit of a script: the line before it has the reason.
constexpr std::string_view octave_exit = "error: ignoring const execution_exception& while preparing to exit";

/// Closes what it holds.
struct Descriptor {
  int number = -1;
  Descriptor() = default;
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

/// In the child, after the fork: only what a child of a program with threads may call.
[[noreturn]] void become(const char* command, int standard_error, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  constexpr int could_not_run = 127;
  if (::getppid() != parent) ::_exit(could_not_run);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 || ::dup2(nothing, STDOUT_FILENO) < 0 ||
      ::dup2(standard_error, STDERR_FILENO) < 0)
    ::_exit(could_not_run);
  ::execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  ::_exit(could_not_run);
}

std::string_view without_space_behind(std::string_view text) {
  return text.substr(0, text.find_last_not_of("\r\n \t") + 1);
}

/// The end of what comes through a pipe.
class Tail {
 public:
  /// False at the end of the stream, or where nothing is waiting.
  bool read_from(int pipe) {
    char buffer[kept_bytes];
    const auto count = ::read(pipe, buffer, sizeof buffer);
    if (count < 0) return errno == EINTR;
    if (count == 0) return false;
    text_.append(buffer, static_cast<std::size_t>(count));
    if (text_.size() > 2 * kept_bytes) text_.erase(0, text_.size() - kept_bytes);
    return true;
  }
  [[nodiscard]] std::string last_line() const {
    std::string_view text = without_space_behind(text_);
    if (text.ends_with(octave_exit)) text = without_space_behind(text.substr(0, text.size() - octave_exit.size()));
    const auto before = text.find_last_of("\r\n");
    const auto begin = before == std::string_view::npos ? 0 : before + 1;
    return shortened(one_line(std::string(text.substr(begin))), longest_line);
  }

 private:
  std::string text_;
};

/// Waits until the child has ended; false where the time is over first.
bool wait_for(const Descriptor& child, Descriptor& pipe, Tail& tail, Clock::time_point deadline) {
  for (;;) {
    pollfd both[] = {{child.number, POLLIN, 0}, {pipe.number, POLLIN, 0}};
    const double left_ms = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
    if (left_ms <= 0) return false;
    constexpr double longest_ms = std::numeric_limits<int>::max() / 2;
    const int ready = ::poll(both, 2, static_cast<int>(std::min(left_ms, longest_ms)) + 1);
    if (ready <= 0) continue;
    if (both[1].revents != 0 && !tail.read_from(pipe.number)) pipe.close();
    if (both[0].revents != 0) return true;
  }
}

/// From errno.
CommandEnd not_started(const char* what) {
  return {.words = fmt::format("could not be started: {} ({})", what, std::strerror(errno)), .last_line = {}};
}

CommandEnd end_of(int status, bool in_time, const Tail& tail, double wall_s, double time_limit_s) {
  CommandEnd end{.words = {}, .last_line = tail.last_line(), .wall_s = wall_s};
  if (!in_time) {
    end.words = fmt::format("ended by the time limit of {} s", plain(time_limit_s));
  } else if (WIFEXITED(status)) {
    end.exit_code = WEXITSTATUS(status);
    end.words = fmt::format("exit code {}", *end.exit_code);
  } else {
    end.words = std::string("ended by ") + ::strsignal(WTERMSIG(status));
  }
  return end;
}

}  // namespace

CommandEnd run_command(const std::string& command, double time_limit_s) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return not_started("no pipe");
  Descriptor from(ends[0]), into(ends[1]);
  ::fcntl(from.number, F_SETFL, O_NONBLOCK);
  const pid_t parent = ::getpid();
  const auto begin = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) return not_started("no process");
  if (child == 0) become(command.c_str(), into.number, parent);
  ::setpgid(child, child);  // the first of the two calls counts
  std::optional<ChildNote> note(std::in_place, child);
  into.close();
  const Descriptor ended(static_cast<int>(::syscall(SYS_pidfd_open, child, 0)));  // readable when the child has ended
  const int why = errno;
  Tail tail;
  const bool in_time =
      ended.number >= 0 &&
      wait_for(ended, from, tail,
               begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_limit_s)));
  const std::chrono::duration<double> passed = Clock::now() - begin;
  ::kill(-child, SIGKILL);
  note.reset();  // after waitpid the number may be that of another group
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (ended.number < 0) {
    errno = why;
    return not_started("no descriptor of a process");
  }
  while (from.number >= 0 && tail.read_from(from.number)) {
  }
  return end_of(status, in_time, tail, passed.count(), time_limit_s);
}

std::optional<double> idle_call_s() {
  constexpr int calls = 3;
  constexpr double limit_s = 10;
  std::optional<double> shortest;
  for (int i = 0; i < calls; ++i) {
    const CommandEnd end = run_command(":", limit_s);
    if (end.exit_code) shortest = std::min(shortest.value_or(limit_s), end.wall_s);
  }
  return shortest;
}

std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string{c};
  return quoted + "'";
}

}  // namespace ehd::judging
