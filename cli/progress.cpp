// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <system_error>
#include <utility>

#include "contact/text.hpp"
#include "io/duration.hpp"

namespace ehd::cli {

namespace {

constexpr std::size_t widest = 79;  // a terminal has 80 columns
constexpr auto pause = std::chrono::seconds(1);

std::string cut(const std::string& text, std::size_t columns) {
  constexpr std::size_t dots = 3;
  return text.size() <= columns ? text : shortened(text, columns - dots);
}

}  // namespace

std::string step_line(std::size_t done, std::size_t all, const std::string& what, double stepped_s, double passed_s) {
  std::string line = fmt::format("{}/{}, {}", done, all, duration(passed_s));
  if (done > 0 && done < all) {
    const double whole_s = stepped_s * static_cast<double>(all) / static_cast<double>(done);
    if (passed_s < whole_s) line += fmt::format(", about {} left", duration(whole_s - passed_s));
  }
  return line + ": " + what;
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    line_ = {};
    draw();
  }
  end_.notify_all();
  if (clock_.joinable()) clock_.join();
}

double Progress::passed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::show(Line line) {
  if (!::isatty(STDERR_FILENO)) return;
  const std::lock_guard lock(mutex_);
  line_ = std::move(line);
  draw();
  if (!line_ || clock_.joinable()) return;
  try {
    clock_ = std::thread([this] { redraw_until_the_end(); });
  } catch (const std::system_error&) {  // no thread is left: the line then changes with each step alone
  }
}

void Progress::show(const std::string& line) {
  if (line.empty()) return show(Line());
  show([line = one_line(line)](double passed_s) {
    const std::string time = passed_s < 1 ? "" : ", " + duration(passed_s);
    return cut(line, widest - time.size()) + time;
  });
}

void Progress::step(std::size_t done, std::size_t all, const std::string& what) {
  show([done, all, what, stepped_s = passed_s()](double passed_s) {
    return step_line(done, all, what, stepped_s, std::max(passed_s, stepped_s));
  });
}

void Progress::draw() {
  if (!line_ && shown_ == 0) return;
  // Spaces and carriage returns only, so that it needs no terminal codes.
  const std::string text = line_ ? cut(one_line(line_(passed_s())), widest) : "";
  std::cerr << '\r' << text << std::string(shown_ > text.size() ? shown_ - text.size() : 0, ' ') << '\r' << text
            << std::flush;
  shown_ = text.size();
}

void Progress::redraw_until_the_end() {
  std::unique_lock lock(mutex_);
  while (!end_.wait_for(lock, pause, [this] { return ends_; })) draw();
}

}  // namespace ehd::cli
