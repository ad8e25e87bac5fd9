// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
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
  const bool known = done > 0 && done < all;
  const double whole_s = known ? stepped_s * static_cast<double>(all) / static_cast<double>(done) : 0;
  return step_line_until(done, all, what, known ? std::optional(whole_s) : std::nullopt, passed_s);
}

std::string step_line_until(std::size_t done, std::size_t all, const std::string& what, std::optional<double> ends_s,
                            double passed_s) {
  constexpr double least_shown_s = 0.1;
  std::string line = fmt::format("{}/{}, {}", done, all, duration(passed_s < least_shown_s ? 0 : passed_s));
  if (ends_s && passed_s < *ends_s) line += fmt::format(", about {} left", duration(*ends_s - passed_s));
  return line + ": " + what;
}

std::optional<double> time_left_s(const std::vector<PlannedRun>& runs) {
  std::map<std::string, double> last_s;
  bool slow_one_ended = false;
  for (const PlannedRun& run : runs) {
    if (!run.took_s) continue;
    last_s[run.solver] = *run.took_s;
    slow_one_ended = slow_one_ended || !run.quick;
  }
  double left_s = 0;
  for (const PlannedRun& run : runs) {
    if (run.took_s) continue;
    const auto known = last_s.find(run.solver);
    if (known != last_s.end())
      left_s += known->second;
    else if (!(run.quick && slow_one_ended))
      return std::nullopt;
  }
  return left_s;
}

std::string running_line(const std::string& doing, const std::string& id, const std::string& solver,
                         const std::string& title) {
  constexpr std::size_t longest_id = 40;  // so that the solver's name still fits
  return fmt::format("{} {} with {}{} ...", doing, cut(id, longest_id), solver, title.empty() ? "" : ": " + title);
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

void Progress::step(std::size_t done, std::size_t all, const std::string& what, std::optional<double> left_s) {
  const double stepped_s = passed_s();
  const auto ends_s = left_s ? std::optional(stepped_s + *left_s) : std::nullopt;
  show([=](double passed_s) { return step_line_until(done, all, what, ends_s, std::max(passed_s, stepped_s)); });
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
