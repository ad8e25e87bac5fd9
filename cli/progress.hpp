// SPDX-License-Identifier: GPL-3.0-or-later
// A line on standard error while something runs.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace ehd::cli {

/// "3/12, 5.1 s, about 15 s left: what", some time after a step that ended `stepped_s` after the begin. The time left
/// is known from the second step on.
[[nodiscard]] std::string step_line(std::size_t done, std::size_t all, const std::string& what, double stepped_s,
                                    double passed_s);

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

 private:
  [[nodiscard]] double passed_s() const;
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
