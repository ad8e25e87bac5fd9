// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/high_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "contact/film_formulas.hpp"
#include "contact/observables.hpp"
#include "contact/nondimensional.hpp"
#include "reference/hp/homotopy.hpp"

namespace ehd::reference {

namespace {

using namespace hp;
using Clock = std::chrono::steady_clock;

/// A discretisation: its points, its degree, and where it stands against the first one.
struct Scheme {
  Points points = Points::left_radau;
  int degree = 12;
  double shift = 0;       ///< of the breakpoints, in elements
  double inlet_part = 1;  ///< of a flooded domain's X_a
};

/// Tolerances from here on need the high degree.
constexpr double fine_tolerance = 2e-5;
constexpr Scheme coarse_scheme{.degree = 8};
constexpr Scheme fine_scheme{.degree = 12};
/// The second discretisation against the first: higher degree, no common breakpoint, half the inlet. (Gauss points in
/// place of left Radau were tried: where the fluidity vanishes their odd-even mode makes meshes five times finer.)
Scheme second_to(const Scheme& scheme) {
  return {.points = Points::left_radau, .degree = scheme.degree + 3, .shift = 0.37, .inlet_part = 0.5};
}

/// Fewer intervals than this in the inlet zone cannot see it.
constexpr double fewest_inlet_cells = 1.5;
/// Of the solution that lays out a given number of intervals.
constexpr double layout_tolerance = 1e-6;

/// Below it, meshes would resolve rounding.
constexpr double finest_working = 1e-13;

/// X_a of a flooded domain in units of l, with the tail before it; hp/README.md, section 5.
constexpr double flooded_inlet = -800;

std::string text_of(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", value);
  return buffer;
}

/// A discretisation at the end of its descent.
struct Discretised {
  std::vector<Resolved> floors;
  Fields fields;
  Observables seen;                         ///< carried on to floor 0 where the descent ended before
  std::map<Quantity, double> floor_errors;  ///< absolute, of that
  [[nodiscard]] const Resolved& last() const { return floors.back(); }
};

class Solve {
 public:
  Solve(const Problem& problem, const Request& request) : problem_(problem), wanted_(problem.wanted) {
    wanted_.insert({Quantity::film_minimum, Quantity::film_central});
    meter_.iterations_left = request.max_iterations * 10;  // of meshes with a hundred nodes, most of them
    meter_.end = begin_ + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(std::min(request.time_limit_s, 1e8)));
    film_ = moes_film_formula({problem.groups.M, problem.groups.L}) / moes_film_per_hertz_film(problem.groups.M);
    length_ = std::max(1.0, std::sqrt(2 * film_));
    inlet_zone_ = length_ * std::pow(std::min(film_, 1.0), 2.0 / 3);
    const auto* truncated = std::get_if<TruncatedAt>(&problem.inlet);
    flooded_ = !truncated;
    inlet_ = truncated ? truncated->x : flooded_inlet * length_;
  }

  /// A coarse solution at a floor where Newton's method finds one.
  [[nodiscard]] std::optional<Resolved> start() {
    const double exit = std::max(1 + 0.45 * inlet_zone_ / length_, 0.5 * std::sqrt(2 * film_));
    const Mesh mesh = seeded_mesh({.inlet = inlet_, .exit = exit, .length = length_, .inlet_zone = inlet_zone_});
    const auto equations = std::make_shared<const Collocation<double>>(problem_, mesh, Points::left_radau);
    HomotopyLimits limits{.newton = {.iterations = 40, .step = 1e-4}};
    for (const double floor : {1e-2, 1e-1, 1.0}) {
      for (const double factor : {1.0, 2.0, 0.5, 4.0}) {
        for (const bool rigid : {film_ > 0.5, film_ <= 0.5}) {
          Resolved guess{.equations = equations, .run = {}, .floor = floor};
          guess.run.state =
              rigid ? martin_start(*equations, exit, factor * film_) : hertz_start(*equations, exit, factor * film_);
          if (auto solved = resolved(problem_, guess, Resolution{}, limits, meter_)) return solved;
        }
        if (meter_.spent()) return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// The descent of the coarse mesh: a state at every floor.
  [[nodiscard]] std::vector<Resolved> coarse_descent(const Resolved& top, double tolerance) {
    return descent(problem_, top, Resolution{},
                   {.settled = 0.2 * tolerance, .newton = {.iterations = 25, .step = 1e-4}}, meter_);
  }

  /// The scheme at one floor, its first mesh made from the one that was used there.
  [[nodiscard]] std::optional<Resolved> on_mesh_of(const Resolved& from, const Scheme& scheme,
                                                   const Resolution& resolution, const HomotopyLimits& limits) {
    Mesh mesh = with_degree(from.equations->mesh(), scheme.degree);
    if (scheme.shift > 0) mesh = shifted(std::move(mesh), scheme.shift);
    if (flooded_ && scheme.inlet_part < 1)
      mesh = cut_at(std::move(mesh), scheme.inlet_part * inlet_, from.run.state.exit);
    return resolved(problem_, moved_to(problem_, from, std::move(mesh), scheme.points), resolution, limits, meter_);
  }

  /// Newton's method on a mesh that stays as it is.
  [[nodiscard]] std::optional<Resolved> as_it_is(const Resolved& start, const HomotopyLimits& limits) {
    Resolved done = start;
    done.run = newton(*start.equations, start.run.state, start.floor, limits.newton, meter_);
    if (!done.run.solved) return std::nullopt;
    return done;
  }

  /// What can be read off the last floor; a spike that is wanted, and is there, is resolved first.
  [[nodiscard]] Discretised observed(std::vector<Resolved> floors, Resolution resolution,
                                     const HomotopyLimits& limits) {
    Discretised done;
    done.floors = std::move(floors);
    done.fields = fields_of(problem_, done.last());
    done.seen = observe(done.fields, wanted_);
    constexpr double finest_spike = 1e-8;
    if (done.last().floor == 0 && done.seen.contains(Quantity::pressure_spike) && resolution.film <= fine_tolerance) {
      resolution.spike = finest_spike;
      if (auto solved = resolved(problem_, done.last(), resolution, limits, meter_)) {
        done.floors.back() = std::move(*solved);
        done.fields = fields_of(problem_, done.last());
        done.seen = observe(done.fields, wanted_);
      }
    }
    return done;
  }

  /// From the lowest of `floors` at which a mesh of the scheme finds a solution that `resolution` asks for, down.
  [[nodiscard]] std::optional<Discretised> discretised(const std::vector<Resolved>& floors, const Scheme& scheme,
                                                       const Resolution& resolution, double tolerance) {
    const HomotopyLimits limits{.settled = 0.2 * tolerance, .newton = {.iterations = 20, .step = 1e-9}};
    for (auto from = floors.rbegin(); from != floors.rend() && !meter_.spent(); ++from) {
      const auto top = on_mesh_of(*from, scheme, resolution, limits);
      if (!top) continue;
      Discretised done = observed(descent(problem_, *top, resolution, limits, meter_), resolution, limits);
      // Two floors to carry on to 0 from, and a third to judge that by: further ones from further up.
      for (auto above = from; done.last().floor > 0 && floors_apart(done.floors).size() < 3 && above != floors.rend();
           ++above) {
        if (above->floor < 3 * done.floors.front().floor) continue;
        if (auto solved = on_mesh_of(*above, scheme, resolution, limits))
          done.floors.insert(done.floors.begin(), std::move(*solved));
      }
      carry_to_zero(done);
      return done;
    }
    return std::nullopt;
  }

  /// Just `intervals` intervals, laid out by the solution that the first discretisation left at its floors.
  /// Where that few find none, by the smoother ones of the coarse descent.
  [[nodiscard]] std::optional<Discretised> laid_out(const Discretised& guide, const std::vector<Resolved>& coarse,
                                                    int intervals) {
    std::vector<Resolved> floors = coarse;
    floors.insert(floors.end(), guide.floors.begin(), guide.floors.end());
    // Few intervals do better with low degrees, as many elements can then follow the solution.
    const int degree = intervals >= 400 ? 12 : intervals >= 160 ? 8 : intervals >= 80 ? 6 : 4;
    const HomotopyLimits limits{.newton = {.iterations = 30, .step = 1e-9}};
    for (auto from = floors.rbegin(); from != floors.rend() && !meter_.spent(); ++from) {
      const auto excess = excess_of(*from->equations, from->run, problem_, Resolution{.film = 1e-8, .spike = 1e-3});
      Mesh mesh = with_intervals(
          with_elements(from->equations->mesh(), excess, intervals / degree, limits.shortest_element), intervals);
      Resolved start = moved_to(problem_, *from, std::move(mesh), Points::left_radau);
      start.floor = 0;
      if (auto solved = as_it_is(start, limits)) return observed({std::move(*solved)}, {}, limits);
    }
    return std::nullopt;
  }

  /// The same elements once more for a second opinion: shifted, of higher degree, half the inlet.
  [[nodiscard]] std::optional<Discretised> second_opinion(const Discretised& first) {
    const HomotopyLimits limits{.newton = {.iterations = 30, .step = 1e-9}};
    const Scheme other = second_to({});
    Mesh mesh = shifted(first.last().equations->mesh(), other.shift);
    for (int& degree : mesh.degrees) degree = (3 * degree + 1) / 2;
    if (flooded_) mesh = cut_at(std::move(mesh), other.inlet_part * inlet_, first.last().run.state.exit);
    auto solved = as_it_is(moved_to(problem_, first.last(), std::move(mesh), Points::left_radau), limits);
    if (!solved) return std::nullopt;
    return observed({std::move(*solved)}, {}, limits);
  }

  /// Values are linear in a small floor, and the curvature through a third one says how small it is. hp/README.md,
  /// section 4.
  void carry_to_zero(Discretised& done) const {
    const auto apart = floors_apart(done.floors);
    if (done.last().floor == 0 || apart.size() < 2) return;
    const double f0 = done.last().floor, f1 = done.floors[apart[1]].floor;
    const Observables one = observe(fields_of(problem_, done.floors[apart[1]]), wanted_);
    const bool three = apart.size() > 2;
    const Observables two = three ? observe(fields_of(problem_, done.floors[apart[2]]), wanted_) : Observables{};
    for (auto& [quantity, reading] : done.seen) {
      if (is_self_check(quantity) || !one.contains(quantity)) continue;
      const double slope = (one.at(quantity).value - reading.value) / (f1 - f0), move = -f0 * slope;
      double error = three && f0 <= highest_linear_floor ? floor_safety * std::abs(move) : 2 * std::abs(move);
      if (three && two.contains(quantity)) {
        const double f2 = done.floors[apart[2]].floor;
        const double further = (two.at(quantity).value - one.at(quantity).value) / (f2 - f1);
        error = std::max(error, curvature_safety * std::abs(f0 * f1 * (further - slope) / (f2 - f0)));
      }
      if (is_pressure_peak(quantity)) error = std::max(error, peak_safety * std::abs(move));  // grows like a logarithm
      if (f0 > highest_floor) error = std::max(error, size_of(quantity, reading.value));
      done.floor_errors[quantity] = error;
      if (!is_pressure_peak(quantity)) reading.value += move;
    }
  }

  /// Two discretisations of one problem, the first reported with its difference from the second. Where it has fewer
  /// intervals than a guide, its difference from that counts too.
  [[nodiscard]] Solution report(const Discretised& first, const Discretised& second, const Discretised* guide) const {
    const bool guided = guide && guide->last().equations->intervals() > first.last().equations->intervals();
    Solution solution;
    solution.fields = first.fields;
    auto& record = solution.record;
    record.status = StopReason::converged;
    const double film = first.last().run.state.flux;
    const double rounding = rounding_of(film);
    // Numbers of one solution move together: a difference of one that is small by chance is no small error.
    double films_differ = 0, all_differ = 0;
    for (const auto& [quantity, reading] : first.seen) {
      if (is_self_check(quantity) || is_pressure_peak(quantity) || !second.seen.contains(quantity)) continue;
      const double differ = std::abs(reading.value - second.seen.at(quantity).value) / size_of(quantity, reading.value);
      all_differ = std::max(all_differ, differ);
      if (is_film(quantity)) films_differ = std::max(films_differ, differ);
    }
    for (auto [quantity, reading] : first.seen) {
      if (is_self_check(quantity)) {
        if (problem_.wanted.contains(quantity)) solution.observables[quantity] = reading;
        continue;
      }
      if (!second.seen.contains(quantity)) continue;
      const bool absolute = has_absolute_error(quantity);
      const double size = size_of(quantity, reading.value);
      ErrorBudget budget;
      budget.discretisation = (is_pressure_peak(quantity) ? peak_safety : discretisation_safety) *
                              std::abs(reading.value - second.seen.at(quantity).value) / size;
      budget.discretisation =
          std::max(budget.discretisation, is_film(quantity) ? discretisation_safety * films_differ : all_differ);
      if (guided && guide->seen.contains(quantity))
        budget.discretisation = std::max(
            budget.discretisation, guide_safety * std::abs(reading.value - guide->seen.at(quantity).value) / size);
      budget.iteration = first.last().run.iteration_error + rounding;
      if (absolute) budget.iteration *= film;
      if (first.last().floor > 0)
        budget.discretisation += first.floor_errors.contains(quantity) ? first.floor_errors.at(quantity) / size : 1;
      // A maximum behind the centre is the spike, or on its way to be one.
      const bool on_a_floor = first.last().floor > 0 && reading.place.value_or(0) > 0;
      if (is_pressure_peak(quantity) && (on_a_floor || !(budget.total() <= vaguest_peak))) {
        if (problem_.wanted.contains(quantity))
          record.notes.push_back(std::string(to_string(quantity)) + " is left out: the spike is not resolved");
        continue;
      }
      reading.error = budget.total();
      if (const auto parts = row_of(quantity).budget) record.*parts = budget;
      if (problem_.wanted.contains(quantity)) solution.observables[quantity] = reading;
    }
    if (first.last().floor > 0)
      record.notes.push_back(
          "the fluidity has a floor of " + text_of(first.last().floor) +
          ": films are carried on to 0 and what may be left is part of the errors; profiles are those of the floor");
    return solution;
  }

  /// What rounding does to films: H is a difference of terms of size 1 + X^2/2.
  [[nodiscard]] double rounding_of(double film) const {
    return 10 * std::numeric_limits<double>::epsilon() * (1 + length_ * length_ / 2) / film;
  }

  void record_grid(const Discretised& of) {
    GridRecord grid;
    grid.nodes = of.last().equations->intervals();
    grid.newton_iterations = of.last().run.iterations;
    grid.residual = of.last().run.residual;
    grid.observed = of.seen;
    grid.inlet_cells = inlet_cells(of.fields, of.last().run.state.flux);
    grids_.push_back(std::move(grid));
  }

  [[nodiscard]] Solution finished(Solution solution, StopReason status, std::string reason) const {
    solution.record.status = status;
    solution.record.reason = std::move(reason);
    solution.record.grids = grids_;
    Cost& cost = solution.record.cost;
    cost.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
    cost.nodes = grids_.empty() ? 0 : grids_.front().nodes;
    cost.newton_iterations = meter_.iterations;
    cost.convolutions = meter_.kernel_products;
    cost.work_units = cost.nodes > 0 ? meter_.point_products / cost.nodes : 0;
    cost.levels = static_cast<int>(grids_.size());
    cost.viscosity_points = is_trivial(problem_.viscosity) ? 0 : meter_.viscosity_points;
    cost.density_points = is_trivial(problem_.density) ? 0 : meter_.density_points;
    return solution;
  }

  [[nodiscard]] bool out_of_limits() const { return meter_.spent(); }
  /// Meshes that resolve less than this only cost time.
  [[nodiscard]] double expected_rounding() const { return rounding_of(film_); }
  [[nodiscard]] bool sees_inlet() const { return grids_.front().inlet_cells >= fewest_inlet_cells; }
  void forget_grids() { grids_.clear(); }

 private:
  /// hp/README.md, sections 4 and 6.
  static constexpr double discretisation_safety = 5, peak_safety = 10, floor_safety = 0.2, curvature_safety = 3,
                          guide_safety = 1.5, vaguest_peak = 0.05;
  /// Above, values are not taken to be linear in the floor, whatever three of them show.
  static constexpr double highest_linear_floor = 1e-6;
  /// Above, the solution of the floor says nothing of that without it.
  static constexpr double highest_floor = 1e-5;

  [[nodiscard]] static double size_of(Quantity quantity, double value) {
    return has_absolute_error(quantity) ? 1 : std::abs(value);
  }

  [[nodiscard]] static double inlet_cells(const Fields& fields, double film) {
    const double l = std::max(1.0, std::sqrt(2 * film)), zone = l * std::pow(std::min(film, 1.0), 2.0 / 3);
    const Eigen::Index right = std::lower_bound(fields.X.begin(), fields.X.end(), -l) - fields.X.begin();
    const Eigen::Index i = std::clamp<Eigen::Index>(right, 1, fields.X.size() - 1);
    return zone / (fields.X[i] - fields.X[i - 1]);
  }

  const Problem& problem_;
  Wanted wanted_;
  Clock::time_point begin_ = Clock::now();
  Meter meter_;
  double film_, length_, inlet_zone_, inlet_;
  bool flooded_;
  std::vector<GridRecord> grids_;
};

}  // namespace

Solution HighOrder::solve(const Problem& problem, const Request& request) const {
  Solve solve(problem, request);
  if (request.nodes && *request.nodes > largest_nodes)
    return solve.finished(
        {}, StopReason::limit_reached,
        std::to_string(*request.nodes) + " intervals do not fit into memory; at most " + std::to_string(largest_nodes));
  const double tolerance = request.tolerance.value_or(layout_tolerance);
  const auto ended = [&](Solution solution, StopReason status, const std::string& reason) {
    if (solve.out_of_limits())
      return solve.finished(std::move(solution), StopReason::limit_reached, "iterations or time ended first");
    return solve.finished(std::move(solution), status, reason);
  };

  // 1. A solution where the fluidity cannot fall below 1e-2 of its ambient value, and from there down to the physics.
  const auto top = solve.start();
  if (!top) return ended({}, StopReason::diverged, "no film was found even at a fluidity floor of 1");
  const auto floors = solve.coarse_descent(*top, tolerance);

  // 2. The intervals that were asked for.
  if (request.nodes) {
    const auto guide =
        solve.discretised(floors, coarse_scheme, {.film = tolerance, .spike = 1e-3, .defect = 1e-2}, tolerance);
    if (!guide) return ended({}, StopReason::diverged, "no mesh resolves the solution");
    const auto first = solve.laid_out(*guide, floors, *request.nodes);
    if (!first)
      return ended({}, StopReason::under_resolved,
                   "no positive film solves the equations of " + std::to_string(*request.nodes) + " intervals");
    const auto second = solve.second_opinion(*first);
    solve.record_grid(*first);
    if (second) solve.record_grid(*second);
    Solution solution = solve.report(*first, second ? *second : *guide, &*guide);
    if (solve.sees_inlet()) return ended(std::move(solution), StopReason::converged, "");
    return ended(std::move(solution), StopReason::under_resolved, "the inlet zone is narrower than two intervals");
  }

  // 3. Two discretisations that resolve below the tolerance; finer ones where they differ by more.
  Solution solution;
  double last_error = std::numeric_limits<double>::infinity();
  double working = tolerance;  // what floors and meshes are judged by
  std::string why;             // the tolerance is not met
  std::vector<Resolved> descended = floors;
  for (int refinement = 0; refinement < 3; ++refinement) {
    if (refinement > 0) {
      working *= 0.01;
      if (working < finest_working) break;
      descended = solve.coarse_descent(*top, working);
    }
    const Scheme scheme = working >= fine_tolerance ? coarse_scheme : fine_scheme;
    const Resolution resolution{.film = std::max(working, solve.expected_rounding()), .spike = 1e-3, .defect = 1e-2};
    const auto first = solve.discretised(descended, scheme, resolution, working);
    if (!first) break;
    const auto second = solve.discretised(first->floors, second_to(scheme), resolution, working);
    if (!second) break;
    Solution refined = solve.report(*first, *second, nullptr);
    const double error = std::max(refined.record.film_minimum.total(), refined.record.film_central.total());
    const bool better = error < last_error;
    if (better) {
      solution = std::move(refined);
      why = first->last().floor > 0
                ? "the fluidity's floor could not be lowered further than " + text_of(first->last().floor)
                : "the two discretisations differ by more than the tolerance";
      solve.forget_grids();
      solve.record_grid(*first);
      solve.record_grid(*second);
    }
    if (error <= tolerance) return solve.finished(std::move(solution), StopReason::converged, "");
    constexpr double unknown = 0.5;  // the floor is too high: a lower one may be found by finer meshes, at once or not
    if (error > 0.7 * last_error && error < unknown) break;  // finer meshes are no cure
    last_error = error;
  }
  if (solution.observables.empty()) return ended({}, StopReason::diverged, "no mesh resolves the solution");
  return ended(std::move(solution), StopReason::tolerance_not_met, why);
}

}  // namespace ehd::reference
