// SPDX-License-Identifier: GPL-3.0-or-later
// Axes: places and labels of the ticks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ehd::report {

enum class Scale { linear, logarithmic };

struct Tick {
  double value = 0;
  std::string label = {};  ///< markup; empty for a minor one
};

struct Range {
  double low = 0, high = 1;
};

/// The range that shows all finite values (logarithmic: all positive ones), widened to whole ticks (linear) or to a
/// part of a decade (logarithmic); a range of its own around one value, and 0..1 (1..10) where there is none.
[[nodiscard]] Range range_of(const std::vector<double>& values, Scale scale);

/// 1, 2 or 5 times a power of ten, so that about `wanted` steps make up the range.
[[nodiscard]] double tick_step(const Range& range, int wanted);

/// Multiples of `step` within the range, labelled with as many decimals as the step needs.
[[nodiscard]] std::vector<Tick> linear_ticks(const Range& range, double step);

/// Decades, labelled 10^{k} or, from 0.001 to 10000, plainly; at most `most_labels` of them. Below two decades the 2
/// and the 5 are labelled too where all three have room, below half a decade round numbers in between. Minor ticks up
/// to seven decades. All labels of an axis are powers of ten, or none is.
[[nodiscard]] std::vector<Tick> log_ticks(const Range& range, int most_labels = 7);

/// An axis of a plot.
struct Axis {
  std::string label = {};  ///< markup, unit in brackets
  Scale scale = Scale::linear;
  std::optional<double> low = {}, high = {};  ///< absent: from the data
  std::optional<double> step = {};            ///< of linear ticks
  bool downward = false;                      ///< of y: grows from top to bottom
  bool silent = false;                        ///< of x: the panel below says what the axis is
};

/// From data to pixels along one axis.
class Mapping {
 public:
  Mapping(Scale scale, Range range, double from_pixel, double to_pixel);
  /// NaN where the value has no place on the axis (not finite; not positive on a logarithmic one).
  [[nodiscard]] double operator()(double value) const;

 private:
  Scale scale_;
  Range range_;
  double from_, to_;
};

/// Whether two labels of an axis touch. Each takes `room(label)` pixels along the axis, around its tick.
[[nodiscard]] bool labels_touch(const std::vector<Tick>& ticks, const Mapping& to_pixel,
                                const std::function<double(const std::string&)>& room);

}  // namespace ehd::report
