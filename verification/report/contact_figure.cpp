// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and film of one contact: the figure, and a small picture for a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

constexpr const char* axis_X = "*X* = *x*/*b*";
constexpr const char* axis_P = "*P* = *p*/*p*_{H}";
constexpr const char* axis_H = "*H* = *h R*/*b*^{2}";
constexpr const char* height_not_known = "spike: height not known";

std::string pressure_name(const ContactCurves& curves) { return "*P* " + literal(curves.name); }

/// H at the node nearest to X = 0; 0 where there is none.
double film_at_centre(const ContactCurves& curves) {
  double nearest = std::numeric_limits<double>::infinity(), film = 0;
  for (std::size_t i = 0; i < std::min(curves.X.size(), curves.H.size()); ++i) {
    if (!(std::abs(curves.X[i]) < nearest) || !std::isfinite(curves.H[i])) continue;
    nearest = std::abs(curves.X[i]);
    film = curves.H[i];
  }
  return film;
}

/// Highest finite value; 0 where there is none.
double highest(const std::vector<double>& values) {
  double top = 0;
  for (const double value : values) top = std::isfinite(value) ? std::max(top, value) : top;
  return top;
}

/// A spike so high and narrow that the dome beside it would fill less than half of the figure: its height, and that of
/// the pressure elsewhere.
struct Spike {
  double height = 0, dome = 0;
  bool known = true;  ///< the height is that of the true spike
};
std::optional<Spike> tall_spike(const ContactCurves& one) {
  constexpr double felt = 0.02;   // of the highest pressure: where the contact begins and ends
  constexpr double narrow = 0.1;  // of the contact; a dome is above half of its height on nine tenths of it
  const double top = highest(one.P);
  double low = std::numeric_limits<double>::infinity(), high = -low, from = low, to = -low;
  for (std::size_t i = 0; i < std::min(one.X.size(), one.P.size()); ++i) {
    if (!(one.P[i] > felt * top)) continue;
    low = std::min(low, one.X[i]);
    high = std::max(high, one.X[i]);
    if (!(one.P[i] > top / 2)) continue;
    from = std::min(from, one.X[i]);
    to = std::max(to, one.X[i]);
  }
  if (!(to - from < narrow * (high - low))) return std::nullopt;
  Spike spike{.height = top, .known = !one.P_cut && !one.vague_spike};
  const double foot = std::max(3 * (to - from), 0.02 * (high - low));  // the spike's flanks are no dome
  for (std::size_t i = 0; i < std::min(one.X.size(), one.P.size()); ++i)
    if (std::isfinite(one.P[i]) && (one.X[i] < from - foot || one.X[i] > to + foot))
      spike.dome = std::max(spike.dome, one.P[i]);
  return spike;
}

/// The axis ends above the dome; a rule says how high the spike is, or that this is not known.
void cut_spike(Panel& panel, const std::vector<ContactCurves>& curves) {
  Spike highest_one;
  double top = 0;
  for (const ContactCurves& one : curves) {
    top = std::max(top, highest(one.P));
    if (const auto spike = tall_spike(one); spike && spike->height > highest_one.height) highest_one = *spike;
  }
  if (!(highest_one.height > 0) || highest_one.height < top) return;
  constexpr double room = 1.25;
  panel.y.high = range_of({0, room * highest_one.dome}, Scale::linear).high;
  panel.rules.push_back(
      {highest_one.dome, highest_one.known ? "spike to " + number_markup(highest_one.height, 3) : height_not_known});
}

/// A dotted line goes on from the top of a spike of unknown height, and says so. A curve that is cut has a rule
/// already.
void mark_vague_spike(Panel& panel, const ContactCurves& one) {
  if (!one.vague_spike || one.P_cut || !panel.rules.empty()) return;
  constexpr double line_ends = 1.1, room = 1.2;  // of the highest pressure
  const double top = std::max(highest(one.P), one.vague_spike->y), x = one.vague_spike->x;
  panel.y.high = std::max(panel.y.high.value_or(0), range_of({0, room * top}, Scale::linear).high);
  panel.series.push_back({.x = {x, x},
                          .y = {one.vague_spike->y, line_ends * top},
                          .line = Line::dotted,
                          .colour = 1,
                          .end = height_not_known,
                          .of = pressure_name(one)});
}

/// A curve in a box of `width` by `height` pixels; points outside the ranges are left out.
std::string spark_path(const std::vector<double>& x, const std::vector<double>& y, Range across, double top,
                       double width, double height, const char* css) {
  const Mapping to_x(Scale::linear, across, 1, width - 1), to_y(Scale::linear, {0, top}, height - 1, 1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) points.push_back({to_x(x[i]), to_y(y[i])});
  constexpr double coarse = 0.3;  // pixels
  std::string d;
  for (const auto& piece : pieces(points, {0, 0, width, height})) d += path_data(simplified(piece, coarse));
  return d.empty() ? "" : fmt::format("<g class=\"{}\"><path class=\"line\" d=\"{}\"/></g>", css, d);
}

}  // namespace

std::string contact_spark(const ContactCurves& one) {
  constexpr double width = 120, height = 30, room = 1.05, shown_films = 4;
  const double top = highest(one.P), central = film_at_centre(one);
  const auto spike = tall_spike(one);
  // The contact and a third of its width on both sides.
  constexpr double felt = 0.02;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < std::min(one.X.size(), one.P.size()); ++i) {
    if (!(one.P[i] > felt * top)) continue;
    low = std::min(low, one.X[i]);
    high = std::max(high, one.X[i]);
  }
  if (!(low < high)) return "";
  const Range across{low - (high - low) / 3, high + (high - low) / 3};
  std::string svg = "<svg class=\"spark\" viewBox=\"0 0 120 30\" aria-hidden=\"true\">";
  if (top > 0) svg += spark_path(one.X, one.P, across, room * (spike ? 2 * spike->dome : top), width, height, "s1");
  if (central > 0) svg += spark_path(one.X, one.H, across, shown_films * central, width, height, "s3");
  return svg + "</svg>";
}

Figure contact_figure(const std::string& id, const std::string& title, const std::vector<ContactCurves>& curves) {
  Figure figure{.id = id,
                .title = title,
                .description = "Pressure P = p/p_H (left axis) and film H = h R/b^2 (right axis) over X = x/b."};
  Panel panel;
  // From where the pressure begins to where it has ended, with a margin on both sides.
  constexpr double felt = 0.02, margin = 0.15;
  double low = std::numeric_limits<double>::infinity(), high = -low, first = low, last = -low, central = 0;
  for (const ContactCurves& one : curves) {
    double top = 0;
    for (const double P : one.P) top = std::isfinite(P) ? std::max(top, P) : top;
    for (std::size_t i = 0; i < std::min(one.X.size(), one.P.size()); ++i) {
      if (!std::isfinite(one.X[i])) continue;
      first = std::min(first, one.X[i]);
      last = std::max(last, one.X[i]);
      if (!(one.P[i] > felt * top)) continue;
      low = std::min(low, one.X[i]);
      high = std::max(high, one.X[i]);
    }
    central = std::max(central, film_at_centre(one));
  }
  panel.x = {.label = axis_X};
  if (low < high) {
    const double wide = high - low;
    panel.x.low = std::max(first, std::min(low - margin * wide, -1.5));
    // The oil of a solver ends at the exit, which in a heavy contact is next to the spike: the frame is not.
    constexpr double room = 0.05;
    panel.x.high = std::max(std::min(last, std::max(high + margin * wide, 1.5)), high + room * wide);
  }
  panel.y = {.label = axis_P, .low = 0};
  cut_spike(panel, curves);
  panel.right = Axis{.label = axis_H, .low = 0};
  // Outside the contact the film opens far beyond its height inside. The figure ends at four times that height.
  constexpr double shown_films = 4;
  if (central > 0) {
    double tallest = 0;
    for (const ContactCurves& one : curves) {
      for (std::size_t i = 0; i < std::min(one.X.size(), one.H.size()); ++i) {
        if (one.X[i] >= panel.x.low.value_or(-1e9) && one.X[i] <= panel.x.high.value_or(1e9) && std::isfinite(one.H[i]))
          tallest = std::max(tallest, one.H[i]);
      }
    }
    constexpr double no_film = 1e-9;  // of the tallest: a dry contact's rounding
    panel.right->high =
        range_of({0, central > no_film * tallest ? std::min(tallest, shown_films * central) : tallest}, Scale::linear)
            .high;
  }
  for (const ContactCurves& one : curves)
    if (one.P_cut && panel.rules.empty()) panel.rules.push_back({*one.P_cut, "above: unresolved"});
  for (const ContactCurves& one : curves) {
    // One solver: P solid, H dashed. The curves of two solvers lie on each other: each curve has a dash of its own.
    const bool alone = curves.size() == 1, upper = &one == &curves.front();
    panel.series.push_back({.name = pressure_name(one),
                            .x = one.X,
                            .y = one.P,
                            .line = upper ? Line::solid : Line::dashed,
                            .colour = upper ? 1 : 2});
    panel.series.push_back({.name = "*H* " + literal(one.name),
                            .x = one.X,
                            .y = one.H,
                            .line = alone   ? Line::dashed
                                    : upper ? Line::dash_dot
                                            : Line::dotted,
                            .colour = upper ? 3 : 4,
                            .right = true});
    if (alone) mark_vague_spike(panel, one);
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace ehd::report
