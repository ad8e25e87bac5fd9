// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/text.hpp"
#include "verification/report/svg.hpp"

namespace ehd::report {

namespace {

constexpr int linear_steps = 5;
constexpr double slack = 1e-9;  // of a step: ticks at the ends of a range are kept in spite of rounding

/// Zero has no sign.
std::string plain_label(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  return text.find_first_not_of("-0.") == std::string::npos ? fixed(0, decimals) : with_minus_sign(text);
}

/// A digit times a power of ten.
std::string power_label(int digit, int exponent, bool plainly) {
  if (plainly) return plain_label(digit * std::pow(10, exponent), std::max(0, -exponent));
  return fmt::format("{}10^{{{}{}}}", digit == 1 ? "" : fmt::format("{}\u2009\u00b7\u2009", digit),
                     exponent < 0 ? "\u2212" : "", std::abs(exponent));
}

}  // namespace

Range range_of(const std::vector<double>& values, Scale scale) {
  constexpr double largest = 1e300;  // differences stay finite; not infinite, not NaN
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!(std::abs(value) <= largest) || (scale == Scale::logarithmic && !(value > 0))) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high)) return scale == Scale::linear ? Range{0, 1} : Range{1, 10};
  if (scale == Scale::logarithmic) {
    constexpr double part_of_range = 0.04, narrow_decades = 0.3, around_narrow_decades = 0.2;
    const double from = std::log10(low), to = std::log10(high);
    const double margin = std::max(part_of_range * (to - from), to - from < narrow_decades ? around_narrow_decades : 0);
    constexpr double last = std::numeric_limits<double>::max_exponent10 - 1;  // of a finite power of ten
    return {std::pow(10, std::max(from - margin, -last)), std::pow(10, std::min(to + margin, last))};
  }
  if (low == high) {
    const double half = low == 0 ? 0.5 : 0.5 * std::abs(low);
    low -= half;
    high += half;
  }
  const double step = tick_step({low, high}, linear_steps);
  return {step * std::floor(low / step + slack), step * std::ceil(high / step - slack)};
}

double tick_step(const Range& range, int wanted) {
  const double rough = (range.high - range.low) / wanted;
  if (!(rough > 0) || !std::isfinite(rough)) return 1;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - slack)) return factor * power;
  }
  return 10 * power;
}

std::vector<Tick> linear_ticks(const Range& range, double step) {
  std::vector<Tick> ticks;
  constexpr double most_ticks = 200;  // a wrong step is no reason to fill the memory
  if (!(step > 0) || !((range.high - range.low) / step <= most_ticks)) return ticks;
  const double first = std::ceil(range.low / step - slack), last = std::floor(range.high / step + slack);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  int decimals = 0;
  for (double scaled = step; decimals < 12 && std::abs(scaled - std::round(scaled)) > slack * scaled; scaled *= 10)
    ++decimals;
  constexpr double plain_up_to = 1e5;
  constexpr int most_decimals = 4;
  const bool powers = largest >= plain_up_to || decimals > most_decimals;
  for (double k = first; k <= last; k += 1)
    ticks.push_back({k * step, powers ? number_markup(k == 0 ? 0.0 : k * step, 6) : plain_label(k * step, decimals)});
  return ticks;
}

std::vector<Tick> log_ticks(const Range& range, int most_labels) {
  std::vector<Tick> ticks;
  if (!(range.low > 0 && range.high > range.low)) return ticks;
  const double from = std::log10(range.low), to = std::log10(range.high), decades = to - from;
  const int first = static_cast<int>(std::ceil(from - slack)), last = static_cast<int>(std::floor(to + slack));
  if (decades < 0.5) {
    for (Tick& tick : linear_ticks(range, tick_step(range, 4))) ticks.push_back(std::move(tick));
    return ticks;
  }
  const int decade_labels = std::max(1, last - first + 1);
  const int every = (decade_labels + most_labels - 1) / most_labels;
  constexpr double with_minor = 7, few_decades = 2;
  const bool few = decades < few_decades;
  const bool plainly = from >= (few ? -4 : -3) - slack && to <= 5;
  const auto inside = [&](double value) {
    return value >= range.low * (1 - slack) && value <= range.high * (1 + slack);
  };
  int steps = 0;  // 1, 2 and 5 of each decade
  for (int k = first - 1; k <= last; ++k)
    for (const int digit : {1, 2, 5}) steps += inside(digit * std::pow(10, k)) ? 1 : 0;
  // Less than two decades have no labels to spare.
  const bool with_two_and_five = few && (steps <= most_labels || first == last || last < first);
  for (int k = static_cast<int>(std::floor(from - slack)); k <= last; ++k) {
    const double decade = std::pow(10, k);
    if (inside(decade)) ticks.push_back({decade, (k % every) == 0 ? power_label(1, k, plainly) : ""});
    if (decades > with_minor) continue;
    for (int digit = 2; digit <= 9; ++digit) {
      const double value = digit * decade;
      if (!inside(value)) continue;
      const bool label = with_two_and_five && (digit == 2 || digit == 5);
      ticks.push_back({value, label ? power_label(digit, k, plainly) : ""});
    }
  }
  return ticks;
}

bool labels_touch(const std::vector<Tick>& ticks, const Mapping& to_pixel,
                  const std::function<double(const std::string&)>& room) {
  std::vector<std::pair<double, double>> taken;  // from, to
  for (const Tick& tick : ticks) {
    if (tick.label.empty()) continue;
    const double at = to_pixel(tick.value), half = room(tick.label) / 2;
    taken.emplace_back(at - half, at + half);
  }
  std::sort(taken.begin(), taken.end());
  for (std::size_t i = 1; i < taken.size(); ++i)
    if (taken[i].first < taken[i - 1].second) return true;
  return false;
}

Mapping::Mapping(Scale scale, Range range, double from_pixel, double to_pixel)
    : scale_(scale), range_(range), from_(from_pixel), to_(to_pixel) {}

double Mapping::operator()(double value) const {
  if (!std::isfinite(value) || (scale_ == Scale::logarithmic && !(value > 0)))
    return std::numeric_limits<double>::quiet_NaN();
  const double share = scale_ == Scale::linear ? (value - range_.low) / (range_.high - range_.low)
                                               : std::log(value / range_.low) / std::log(range_.high / range_.low);
  return from_ + share * (to_ - from_);
}

}  // namespace ehd::report
