// SPDX-License-Identifier: GPL-3.0-or-later
// A line on standard error while something runs.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace ehd::cli {

/// "3/12, 5.1 s, about 15 s left: what", some time after a step that ended `stepped_s` after the begin. The time left
/// is known from the second step on.
[[nodiscard]] std::string step_line(std::size_t done, std::size_t all, const std::string& what, double stepped_s,
                                    double passed_s);

/// The same where everything is known to end `ends_s` after the begin. Without `ends_s` no time left is shown.
[[nodiscard]] std::string step_line_until(std::size_t done, std::size_t all, const std::string& what,
                                          std::optional<double> ends_s, double passed_s);

/// One of several runs, each by a solver.
struct PlannedRun {
  std::string solver;
  bool quick = false;                 ///< its time does not count beside that of a solver that is not quick
  std::optional<double> took_s = {};  ///< absent before it has ended
};
/// The time of all runs that have not ended. Each counts as the last ended run of its solver. A quick solver without an
/// ended run counts as nothing, once a run of another kind has ended. Any other solver without one: the time is absent.
[[nodiscard]] std::optional<double> time_left_s(const std::vector<PlannedRun>& runs);

/// "solving ID with SOLVER: TITLE ...": what a narrow terminal cuts is the title. An empty title is left out.
[[nodiscard]] std::string running_line(const std::string& doing, const std::string& id, const std::string& solver,
                                       const std::string& title);

/// A line on standard error while something runs, on a terminal only; removed at the end. It is drawn again every
/// second, with the time that has passed since the construction. Threads may share it.
class Progress {
 public:
  /// The line at a time [s] after the construction.
  using Line = std::function<std::string(double passed_s)>;

  Progress() = default;
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(Line line);
  /// "line, 3 s": from the first second on with the time. An empty one removes the line.
  void show(const std::string& line);
  /// step_line of a step that ends now.
  void step(std::size_t done, std::size_t all, const std::string& what);
  /// The same with the time left [s] from now on; without it none is shown.
  void step(std::size_t done, std::size_t all, const std::string& what, std::optional<double> left_s);

  [[nodiscard]] double passed_s() const;  ///< since the construction

 private:
  void draw();  ///< with the mutex held
  void redraw_until_the_end();

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable end_;
  bool ends_ = false;
  Line line_;  ///< none: nothing is shown
  std::size_t shown_ = 0;
  std::thread clock_;
};

}  // namespace ehd::cli
