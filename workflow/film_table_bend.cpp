// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_bend.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "contact/legendre.hpp"
#include "workflow/chebyshev.hpp"

namespace ehd {

namespace {

/// The films bend between these M. Above 7, degrees of 8 in M and 6 in L leave 2e-5 over M 7..1000, L 2.5..20.
constexpr double bend_above = 1.0, bend_below = 7.0;
/// The bend itself is at M = 1.03 to 2.9 (Barus and Roelands, L = 0 to 60).
constexpr double highest_bend = 3.5;
constexpr double search_from = 0.3, search_to = 6.0, first_guess = 1.8;

/// d X/d ln M of the largest pressure near X = 0: 0.6 to 1.1.
constexpr double usual_slope = 0.8;
/// The search solves beside the bend, at these X on both sides: on the bend of a sharp corner a solve takes fifty times
/// as long. X is known to 3e-5.
constexpr double aimed_X = 3e-3;
/// The secant through two solves as near as these finds the bend to 4e-5.
constexpr double near_X = 6e-3, near_X_before = 2e-2;
constexpr int most_rounds = 8;

/// The bend over a band of L is a polynomial of this degree through so many solved points. Barus' bend turns about
/// L = 10, where the corner arises: there bands are narrow, 9.8 to 11.3 and the like, and so the films of a band are
/// smooth as well. Over L 8.5 to 11.3 the polynomial errs by 2e-4, and the films take 60 degrees instead of 8.
constexpr int bend_degree = 6, bend_points = 10;
/// A point of another band counts where it is within this share of the spacing. With 0.4 points leave a hole, in which
/// the polynomial errs by more than at them.
constexpr double near_share = 0.2;
/// Where the pressure has a sharp spike, the polynomial errs by less than this, else by less than the other: a smooth
/// film only needs a smooth edge near the bend, and a broad peak is found to 2e-4.
constexpr double sharp_peak = 2.5, most_bend_error = 1e-4, most_error_beside_broad_peak = 1e-3;
/// Above this peak the films of a band are solved on a scale with a root. Barus, L 2.5 to 8.5 (peak 1.47): 15 x 11
/// coefficients without a root, 19 x 12 with one. Roelands, L 5 to 25 (peak 1.8): 31 x 19 without, 15 x 11 with one.
constexpr double peak_for_root = 1.5;
constexpr double narrowest_band = 0.06;  // in ln(1 + L)

/// A panel beside the bend is at least so wide in ln M: the part that is extrapolated is then short.
constexpr double least_width = 0.2;

/// ln(1 + L), in which bands are halved.
double length_of(double L) { return std::log1p(L); }

/// Solved points of the bend.
class BendTrace {
 public:
  explicit BendTrace(const FilmSource& source) : source_(source) {}

  /// Finds the bend at the points of a band where it is not known yet. False: it is not found.
  [[nodiscard]] bool add_points(double from, double to) {
    std::vector<Search> searches;
    for (int k = 0; k < bend_points; ++k) {
      const double angle = std::numbers::pi / bend_points, half = (to - from) / 2;
      const double at = from + half * (1 - std::cos((k + 0.5) * angle));
      const double spacing = half * angle * std::sin((k + 0.5) * angle);
      const auto near = points_.lower_bound(at - near_share * spacing);
      if (near == points_.end() || near->first > at + near_share * spacing)
        searches.push_back({.at = at, .log_M = guess(at) + aimed_X});
    }
    return run(searches);
  }

  struct Fit {
    std::vector<double> edge;
    double error = 0;  ///< the largest distance of a point from it
    double peak = 0;   ///< the largest pressure on it
  };
  /// The polynomial over a band.
  [[nodiscard]] Fit fit(double from, double to) const {
    Fit found;
    const auto first = points_.lower_bound(from), last = points_.upper_bound(to);
    MatrixOf<double> basis(std::distance(first, last), bend_degree + 1), values(basis.rows(), 1);
    Eigen::Index row = 0;
    for (auto point = first; point != last; ++point, ++row) {
      const ChebyshevBasis at(bend_degree, 2 * (point->first - from) / (to - from) - 1);
      for (int j = 0; j <= bend_degree; ++j) basis(row, j) = at.value[j];
      values(row, 0) = point->second.log_M;
      found.peak = std::max(found.peak, point->second.peak);
    }
    const MatrixOf<double> c = basis.colPivHouseholderQr().solve(values);
    found.edge.assign(c.data(), c.data() + c.size());
    found.error = (basis * c - values).cwiseAbs().maxCoeff();
    return found;
  }

  long solves = 0;

 private:
  /// A search at one L.
  struct Search {
    double at = 0;     // ln(1 + L)
    double log_M = 0;  // to be solved next
    double low = std::log(search_from), high = std::log(search_to);
    std::optional<std::pair<double, double>> last = {};  // ln M, X
    bool found = false;
  };

  [[nodiscard]] double guess(double at) const {
    const auto above = points_.lower_bound(at);
    if (points_.empty()) return std::log(first_guess);
    if (above == points_.begin()) return above->second.log_M;
    const auto below = std::prev(above);
    if (above == points_.end()) return below->second.log_M;
    const double share = (at - below->first) / (above->first - below->first);
    return below->second.log_M + share * (above->second.log_M - below->second.log_M);
  }

  /// One step of a search with the peak that was solved: the secant, or the middle where it leaves the bracket
  /// by more than the distances that are aimed at.
  void step(Search& search, double X, double peak) {
    (X < 0 ? search.low : search.high) = search.log_M;
    double slope = usual_slope;
    if (search.last && search.last->second != X)
      slope = (X - search.last->second) / (search.log_M - search.last->first);
    const auto inside = [&](double log_M) { return log_M > search.low - near_X && log_M < search.high + near_X; };
    const double bend = search.log_M - X / slope, beside = bend + (X < 0 ? aimed_X : -aimed_X) / slope;
    if (search.last && std::abs(X) < near_X && std::abs(search.last->second) < near_X_before) {
      points_[search.at] = {.log_M = bend, .peak = peak};
      search.found = true;
    }
    search.last = {search.log_M, X};
    search.log_M = inside(beside) ? beside : (search.low + search.high) / 2;
  }

  bool run(std::vector<Search>& searches) {
    for (int round = 0; round < most_rounds && !searches.empty(); ++round) {
      std::vector<MoesGroups> contacts;
      for (const Search& one : searches) contacts.push_back({.M = std::exp(one.log_M), .L = std::expm1(one.at)});
      const std::vector<SolvedFilms> solved = source_(contacts);
      solves += static_cast<long>(contacts.size());
      for (std::size_t i = 0; i < searches.size(); ++i) {
        if (!std::isfinite(solved[i].peak_X)) return false;
        step(searches[i], solved[i].peak_X, solved[i].peak);
      }
      std::erase_if(searches, [](const Search& one) { return one.found; });
    }
    return searches.empty();
  }

  const FilmSource& source_;
  struct Point {
    double log_M = 0, peak = 0;
  };
  std::map<double, Point> points_;  // over ln(1 + L)
};

PanelShape straight(double M_low, double M_high, double L_low, double L_high) {
  return {
      .L_low = L_low, .L_high = L_high, .low = {std::log(M_low)}, .high = {std::log(M_high)}, .map = PanelMap::even};
}

/// An edge over half of its panel: the one about y = middle.
std::vector<double> part_of(const std::vector<double>& edge, double middle) {
  const std::vector<double> points = leja_points(edge.size());
  MatrixOf<double> values(static_cast<Eigen::Index>(edge.size()), 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    values(static_cast<Eigen::Index>(i), 0) =
        chebyshev_sum(edge, ChebyshevBasis(static_cast<int>(edge.size()) - 1, middle + points[i] / 2)).value;
  const MatrixOf<double> c = chebyshev_coefficients(values, points, {0});
  return {c.data(), c.data() + c.size()};
}

/// The panels of the M between which the bend lies.
class BendPanels {
 public:
  BendPanels(const FilmSource& source, double M_low, double M_high, long most_panels)
      : trace_(source), M_low_(M_low), M_high_(M_high), most_panels_(most_panels) {}

  /// Plans a band of L, in halves where the bend is no polynomial. False: the bend is not found.
  [[nodiscard]] bool plan(double L_low, double L_high) {
    const double from = length_of(L_low), to = length_of(L_high);
    if (!trace_.add_points(from, to)) return false;
    const BendTrace::Fit bend = trace_.fit(from, to);
    const auto [least, most] = ends_of(bend.edge);
    if (most <= M_low_ || least >= M_high_) {
      add_straight(L_low, L_high);
      return true;
    }
    const double allowed = bend.peak > sharp_peak ? most_bend_error : most_error_beside_broad_peak;
    const bool splits =
        bend.error > allowed && to - from > narrowest_band && static_cast<long>(panels.size()) + 4 <= most_panels_;
    if (splits) {
      const double middle = std::expm1((from + to) / 2);
      return plan(L_low, middle) && plan(middle, L_high);
    }
    add_beside(bend.edge, bend.peak > peak_for_root, L_low, L_high);
    return true;
  }

  [[nodiscard]] long solves() const { return trace_.solves; }

  std::vector<PanelPlan> panels;

 private:
  void add_straight(double L_low, double L_high) {
    const PanelShape shape = straight(M_low_, M_high_, L_low, L_high);
    PanelPlan* last = panels.empty() ? nullptr : &panels.back();
    if (last && is_straight(last->shape))
      last->shape.L_high = L_high;
    else
      panels.push_back({.shape = shape});
  }

  /// The panels on both sides of the bend. An edge is straight where it is far from the bend, else parallel to it.
  void add_beside(const std::vector<double>& bend, bool root, double L_low, double L_high) {
    const auto [M_least, M_most] = ends_of(bend);
    const double least = std::log(M_least), most = std::log(M_most), a = std::log(M_low_), c = std::log(M_high_);
    const auto parallel = [&](double distance) {
      std::vector<double> edge = bend;
      edge[0] += distance;
      return edge;
    };
    const bool far_below = least - a >= least_width, far_above = c - most >= least_width;
    const double below = far_below ? least - a : std::max(least_width, most - a);
    const double above = far_above ? c - most : std::max(least_width, c - least);
    /// The part of -1 … 1 that is within the gap.
    const auto gap = [&](double width) { return 2 * (root ? std::sqrt(bend_gap / width) : bend_gap / width); };
    PanelPlan plan{.shape = {.L_low = L_low, .L_high = L_high}};
    if (most > a) {
      plan.shape.low = far_below ? std::vector{a} : parallel(-below);
      plan.shape.high = bend;
      plan.shape.map = root ? PanelMap::root_high : PanelMap::even;
      plan.x_last = 1 - gap(below);
      panels.push_back(plan);
      plan.x_last = 1;
    }
    if (least < c) {
      plan.shape.low = bend;
      plan.shape.high = far_above ? std::vector{c} : parallel(above);
      plan.shape.map = root ? PanelMap::root_low : PanelMap::even;
      plan.x_first = gap(above) - 1;
      panels.push_back(plan);
    }
  }

  BendTrace trace_;
  double M_low_, M_high_;
  long most_panels_;
};

}  // namespace

std::vector<PanelPlan> straight_panels(const FilmRange& range) {
  std::vector<double> ends{range.M_low};
  for (const double M : {bend_above, bend_below})
    if (M > range.M_low && M < range.M_high) ends.push_back(M);
  ends.push_back(range.M_high);
  std::vector<PanelPlan> plans;
  for (std::size_t p = 0; p + 1 < ends.size(); ++p)
    plans.push_back({.shape = straight(ends[p], ends[p + 1], range.L_low, range.L_high),
                     .may_bend = ends[p] >= bend_above && ends[p] < highest_bend});
  return plans;
}

BendPlans panels_beside_bend(const PanelShape& panel, const FilmSource& source, long most_panels) {
  BendPanels bend(source, std::exp(panel.low.front()), std::exp(panel.high.front()), most_panels);
  const bool found = bend.plan(panel.L_low, panel.L_high);
  return {.panels = found ? bend.panels : std::vector<PanelPlan>{}, .solves = bend.solves()};
}

std::vector<PanelPlan> halves(const PanelPlan& plan, bool in_M) {
  PanelPlan low = plan, high = plan;
  low.may_bend = high.may_bend = false;
  const PanelShape& whole = plan.shape;
  if (in_M && is_straight(whole)) {
    low.shape.high = high.shape.low = {(whole.low.front() + whole.high.front()) / 2};
    return {low, high};
  }
  low.shape.L_high = high.shape.L_low = std::expm1((length_of(whole.L_low) + length_of(whole.L_high)) / 2);
  for (PanelPlan* half : {&low, &high}) {
    const double middle = half == &low ? -0.5 : 0.5;
    half->shape.low = part_of(whole.low, middle);
    half->shape.high = part_of(whole.high, middle);
  }
  return {low, high};
}

}  // namespace ehd
