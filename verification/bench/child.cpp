// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

namespace ehd::verification {

namespace {

constexpr int threw = 3, could_not_write = 4, lacked_memory = 5, did_not_start = 127;  // exit codes of the child

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

bool write_all(int pipe, const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const auto count = ::write(pipe, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    written += static_cast<std::size_t>(count);
  }
  return true;
}

std::string read_all(int pipe) {
  std::string text;
  char buffer[4096];
  for (;;) {
    const auto count = ::read(pipe, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

/// The C++ library comes here without an exception where it has no memory for one.
[[noreturn]] void end_child() {
  const std::exception_ptr thrown = std::current_exception();
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
  } catch (...) {
    std::abort();
  }
  ::_exit(lacked_memory);
}

}  // namespace

ChildEnd in_child(const std::function<std::string()>& work) {
  return_free_memory();  // the child would use free pages without growing
  int ends[2];
  if (::pipe(ends) != 0) throw Refused(std::string("no pipe: ") + std::strerror(errno));
  const pid_t child = ::fork();
  if (child < 0) {
    const std::string why = std::string("no process: ") + std::strerror(errno);
    ::close(ends[0]);
    ::close(ends[1]);
    throw Refused(why);
  }
  if (child == 0) {
    ::close(ends[0]);
    std::set_terminate(end_child);
    int code = 0;
    std::string text;
    try {
      text = work();
    } catch (const std::bad_alloc&) {
      code = lacked_memory;
    } catch (const std::exception& thrown) {
      text = thrown.what();
      code = threw;
    } catch (...) {
      code = threw;
    }
    if (!write_all(ends[1], text)) code = could_not_write;
    ::_exit(code);  // not exit(): it would write the parent's buffered output a second time
  }
  ::close(ends[1]);
  std::string text = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {std::move(text), {}};
  if (WIFEXITED(status) && WEXITSTATUS(status) == lacked_memory) throw std::bad_alloc();
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw) return {{}, text.empty() ? "it threw" : text};
  if (WIFSIGNALED(status)) return {{}, std::string("ended by ") + ::strsignal(WTERMSIG(status))};
  return {{}, fmt::format("exit code {}", WIFEXITED(status) ? WEXITSTATUS(status) : -1)};
}

ProgramEnd run_program(const std::string& path, const std::vector<std::string>& arguments) {
  std::vector<std::string> texts{path};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (std::string& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw Refused(std::string("no process: ") + std::strerror(errno));
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    ::execv(path.c_str(), words.data());
    ::_exit(did_not_start);
  }
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status)) throw Refused(path + ": ended by " + ::strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == did_not_start) throw Refused(path + ": does not start");
  return {.exit_code = WEXITSTATUS(status), .processor_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)};
}

double peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  constexpr double kilobyte = 1024;
  return kilobyte * static_cast<double>(usage.ru_maxrss);
}

void return_free_memory() { ::malloc_trim(0); }

double resident_memory_bytes() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace ehd::verification
