// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/report/svg.hpp"

namespace ehd::report {

std::optional<std::pair<Point, Point>> clipped(Point from, Point to, const Box& box) {
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return std::nullopt;
  double enter = 0, leave = 1;
  const double dx = to.x - from.x, dy = to.y - from.y;
  const auto cut = [&](double direction, double distance) {  // keeps where direction * t <= distance
    if (direction == 0) return distance >= 0;
    const double t = distance / direction;
    if (direction < 0) enter = std::max(enter, t);
    if (direction > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  if (!cut(-dx, from.x - box.left) || !cut(dx, box.right - from.x) || !cut(-dy, from.y - box.top) ||
      !cut(dy, box.bottom - from.y))
    return std::nullopt;
  const auto at = [&](double t) { return Point{from.x + t * dx, from.y + t * dy}; };
  return std::pair{enter == 0 ? from : at(enter), leave == 1 ? to : at(leave)};
}

std::vector<std::vector<Point>> pieces(const std::vector<Point>& points, const Box& box) {
  std::vector<std::vector<Point>> result;
  bool open = false;  // the last piece ends at points[i - 1]
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto inside = clipped(points[i - 1], points[i], box);
    if (!inside) {
      open = false;
      continue;
    }
    if (!open) result.push_back({inside->first});
    result.back().push_back(inside->second);
    open = inside->second.x == points[i].x && inside->second.y == points[i].y;
  }
  return result;
}

namespace {

/// The parts of a segment outside all holes, from its beginning to its end.
std::vector<std::pair<Point, Point>> parts_outside(Point from, Point to, const std::vector<Box>& holes) {
  std::vector<std::pair<Point, Point>> inside, outside;
  for (const Box& hole : holes)
    if (const auto part = clipped(from, to, hole)) inside.push_back(*part);
  const auto away = [&](const std::pair<Point, Point>& part) {
    return std::hypot(part.first.x - from.x, part.first.y - from.y);
  };
  std::sort(inside.begin(), inside.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
  for (const auto& [enter, leave] : inside) {
    outside.emplace_back(from, enter);
    from = leave;
  }
  outside.emplace_back(from, to);
  return outside;
}

double length_of(const std::vector<Point>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return length;
}

}  // namespace

std::vector<std::vector<Point>> pieces_outside(const std::vector<Point>& points, const std::vector<Box>& holes,
                                               double least) {
  std::vector<std::vector<Point>> result;
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (const auto& [from, to] : parts_outside(points[i - 1], points[i], holes)) {
      const bool goes_on = !result.empty() && result.back().back().x == from.x && result.back().back().y == from.y;
      if (!goes_on) result.push_back({from});
      result.back().push_back(to);
    }
  }
  std::erase_if(result, [&](const std::vector<Point>& line) { return !(length_of(line) > least); });
  return result;
}

std::vector<Point> simplified(const std::vector<Point>& points, double distance) {
  if (points.size() < 3) return points;
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const double dx = points[last].x - points[first].x, dy = points[last].y - points[first].y;
    const double length = std::hypot(dx, dy);
    double furthest = distance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double ax = points[i].x - points[first].x, ay = points[i].y - points[first].y;
      const double t = length > 0 ? std::clamp((ax * dx + ay * dy) / (length * length), 0.0, 1.0) : 0;
      const double away = std::hypot(ax - t * dx, ay - t * dy);
      if (away > furthest) {
        furthest = away;
        at = i;
      }
    }
    if (at == 0) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i]) result.push_back(points[i]);
  }
  return result;
}

std::string path_data(const std::vector<Point>& points) {
  if (points.size() < 2) return "";
  std::string d;
  for (std::size_t i = 0; i < points.size(); ++i)
    d += fmt::format("{}{} {}", i == 0 ? "M" : "L", pixels(points[i].x), pixels(points[i].y));
  return d;
}

std::string marker_svg(Marker marker, Point at, bool hollow, double size) {
  const std::string css = std::string(" class=\"mark") + (hollow ? " hollow" : "") + "\"";
  const auto placed = [&](const std::vector<Point>& corners) {
    std::vector<Point> points;
    for (const Point& corner : corners) points.push_back({at.x + size * corner.x, at.y + size * corner.y});
    return path_data(points);
  };
  const auto shape = [&](const std::vector<Point>& corners) {
    return fmt::format("<path{} d=\"{}Z\"/>", css, placed(corners));
  };
  const auto strokes = [&](Point a, Point b, Point c, Point d) {
    return fmt::format("<path{} d=\"{}{}\"/>", css, placed({a, b}), placed({c, d}));
  };
  switch (marker) {
    case Marker::none: return "";
    case Marker::circle:
      return fmt::format("<circle{} cx=\"{}\" cy=\"{}\" r=\"{}\"/>", css, pixels(at.x), pixels(at.y),
                         pixels(3.2 * size));
    case Marker::square: return shape({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
    case Marker::triangle: return shape({{0, -4}, {3.6, 2.8}, {-3.6, 2.8}});
    case Marker::diamond: return shape({{0, -4.2}, {4.2, 0}, {0, 4.2}, {-4.2, 0}});
    case Marker::cross: return strokes({-3.2, -3.2}, {3.2, 3.2}, {-3.2, 3.2}, {3.2, -3.2});
    case Marker::plus: return strokes({-4, 0}, {4, 0}, {0, -4}, {0, 4});
  }
  return "";
}

std::string dash_attribute(Line line) {
  switch (line) {
    case Line::dashed: return " stroke-dasharray=\"7 4\"";
    case Line::dotted: return " stroke-dasharray=\"1.8 3\"";
    case Line::dash_dot: return " stroke-dasharray=\"9 3 2 3\"";
    case Line::solid:
    case Line::none: break;
  }
  return "";
}

std::string text_svg(Point at, const std::string& markup, const std::string& anchor, const std::string& css,
                     const std::string& more) {
  return fmt::format("<text x=\"{}\" y=\"{}\"{}{}{}>{}</text>", pixels(at.x), pixels(at.y),
                     anchor == "start" ? "" : " text-anchor=\"" + anchor + "\"",
                     css.empty() ? "" : " class=\"" + css + "\"", more, markup_to_svg(markup));
}

Point LegendRows::next(double width) {
  if (place_.x > left_ && place_.x + width > right_) place_ = {left_, place_.y + height};
  const Point corner = place_;
  place_.x += width;
  return corner;
}

}  // namespace ehd::report
