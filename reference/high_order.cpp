// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/high_order.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "reference/hp/discretiser.hpp"
#include "reference/hp/error_report.hpp"
#include "reference/lengths.hpp"

namespace ehd::reference {

namespace {

using namespace hp;
using Clock = std::chrono::steady_clock;

/// Tolerance where a request states none: that of the solution that lays out a given number of intervals.
constexpr double layout_tolerance = 1e-6;
/// Below this working tolerance meshes would resolve rounding.
constexpr double finest_working = 1e-13;
/// What a mesh resolves at a working tolerance: coefficients of the pressure in p_H, and the flux between collocation
/// points.
constexpr double spike_resolution = 1e-3, defect_resolution = 1e-2;
/// Attempts to meet a tolerance, each working with this part of the tolerance of the one before.
constexpr int attempts = 3;
constexpr double next_working = 0.01;
/// A refinement that leaves more than this part of the error is the last one, because finer meshes do not help ...
constexpr double hopeless_reduction = 0.7;
/// ... unless the error is larger than this. The floor is then too high, and finer meshes may reach a lower one.
constexpr double unknown = 0.5;
GridRecord record_of(const Discretised& of) {
  GridRecord grid;
  grid.nodes = of.last().equations->intervals();
  grid.newton_iterations = of.last().run.iterations;
  grid.residual = of.last().run.residual;
  grid.observed = of.seen;
  grid.inlet_cells = inlet_cells(of.fields.X, of.last().run.state.flux);
  return grid;
}

/// One solve: the discretiser, and the record that is kept beside it.
class Solve {
 public:
  Solve(const Problem& problem, const Request& request)
      : problem_(problem), discretiser_(problem, meter_of(request.max_iterations, request.time_limit_s, begin_)) {}

  [[nodiscard]] Solution on_intervals(int intervals, double layout);
  [[nodiscard]] Solution within(const FilmTolerances& asked);
  [[nodiscard]] Solution finished(Solution solution, StopReason status, std::string reason) const;

 private:
  /// As finished(), but limits that ran out are the reason.
  [[nodiscard]] Solution ended(Solution solution, StopReason status, const std::string& reason) const {
    if (discretiser_.meter().spent())
      return finished(std::move(solution), StopReason::limit_reached, "iterations or time ended first");
    return finished(std::move(solution), status, reason);
  }
  [[nodiscard]] Solution no_start() const {
    return ended({}, StopReason::diverged, "no film was found even at a fluidity floor of 1");
  }
  [[nodiscard]] Solution no_mesh() const { return ended({}, StopReason::diverged, "no mesh resolves the solution"); }
  [[nodiscard]] Solution reported(const Discretised& first, const Discretised& second, const Discretised* guide) const {
    return report(problem_, first, second, guide, discretiser_.rounding_of(first.last().run.state.flux));
  }

  const Problem& problem_;
  Clock::time_point begin_ = Clock::now();
  Discretiser discretiser_;
  std::vector<GridRecord> grids_;
};

/// Exactly `intervals` intervals, laid out by a solution that is good to `layout`.
Solution Solve::on_intervals(int intervals, double layout) {
  const auto top = discretiser_.start();
  if (!top) return no_start();
  const auto floors = discretiser_.coarse_descent(*top, layout);
  const Resolution resolution{.film = layout, .spike = spike_resolution, .defect = defect_resolution};
  const auto guide = discretiser_.discretised(floors, coarse_scheme, resolution, layout);
  if (!guide) return no_mesh();
  const auto first = discretiser_.laid_out(*guide, floors, intervals);
  if (!first)
    return ended({}, StopReason::under_resolved,
                 "no positive film solves the equations of " + std::to_string(intervals) + " intervals");
  const auto second = discretiser_.second_opinion(*first);
  grids_.push_back(record_of(*first));
  if (second) grids_.push_back(record_of(*second));
  Solution solution = reported(*first, second ? *second : *guide, &*guide);
  if (grids_.front().inlet_cells < fewest_inlet_cells)
    return ended(std::move(solution), StopReason::under_resolved, "the inlet zone is narrower than 1.5 intervals");
  if (const auto why = too_coarse(solution.record.film_minimum, solution.record.film_central))
    return ended(std::move(solution), StopReason::under_resolved, *why);
  return ended(std::move(solution), StopReason::converged, "");
}

/// Two discretisations that resolve below the tolerance; finer ones where they differ by more.
Solution Solve::within(const FilmTolerances& asked) {
  // 1. A solution where the fluidity cannot fall below 1e-2 of its ambient value.
  const auto top = discretiser_.start();
  if (!top) return no_start();

  // 2. From there down to the physics, on a coarse mesh.
  std::vector<Resolved> floors = discretiser_.coarse_descent(*top, asked.tightest());

  Solution solution;
  double last_error = std::numeric_limits<double>::infinity();
  double working = asked.tightest();  // floors and meshes are judged by it
  std::string why;                    // reason of tolerance_not_met
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (attempt > 0) working *= next_working;
    if (attempt > 0 && working < finest_working) break;

    // 3. Two discretisations, and the error from their difference.
    const Scheme scheme = working >= fine_tolerance ? coarse_scheme : fine_scheme;
    const Resolution resolution{.film = std::max(working, discretiser_.expected_rounding()),
                                .spike = spike_resolution,
                                .defect = defect_resolution};
    const auto both = discretiser_.discretised_twice(floors, scheme, resolution, working);
    if (!both) break;
    const auto& [first, second] = *both;
    Solution refined = reported(first, second, nullptr);
    const double error = std::max(refined.record.film_minimum.total(), refined.record.film_central.total());
    const bool met = asked.met_by(refined.record.film_minimum, refined.record.film_central);

    // 4. The best solution so far stays.
    if (error < last_error) {
      solution = std::move(refined);
      why = first.last().floor > 0 ? "the fluidity's floor could not be lowered below " + plain(first.last().floor, 2)
                                   : "the two discretisations differ by more than the tolerance";
      grids_ = {record_of(first), record_of(second)};
    }
    if (met) return finished(std::move(solution), StopReason::converged, "");
    if (error > hopeless_reduction * last_error && error < unknown) break;
    last_error = error;
    floors.insert(floors.end(), first.floors.begin(), first.floors.end());  // where the next attempt goes on
  }
  if (solution.observables.empty()) return no_mesh();
  return ended(std::move(solution), StopReason::tolerance_not_met, why);
}

Solution Solve::finished(Solution solution, StopReason status, std::string reason) const {
  const Meter& meter = discretiser_.meter();
  solution.record.status = status;
  solution.record.reason = std::move(reason);
  solution.record.grids = grids_;
  Cost& cost = solution.record.cost;
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
  cost.nodes = grids_.empty() ? 0 : grids_.front().nodes;
  cost.newton_iterations = meter.iterations;
  cost.convolutions = meter.kernel_products;
  cost.work_units = cost.nodes > 0 ? meter.point_products / cost.nodes : 0;
  cost.levels = static_cast<int>(grids_.size());
  cost.viscosity_points = is_trivial(problem_.viscosity) ? 0 : meter.viscosity_points;
  cost.density_points = is_trivial(problem_.density) ? 0 : meter.density_points;
  return solution;
}

}  // namespace

Solution HighOrder::solve(const Problem& problem, const Request& request) const {
  Solve solve(problem, request);
  if (request.nodes && *request.nodes > largest_nodes)
    return solve.finished(
        {}, StopReason::limit_reached,
        std::to_string(*request.nodes) + " intervals do not fit into memory; at most " + std::to_string(largest_nodes));
  if (!request.nodes) return solve.within(request.tolerance);
  return solve.on_intervals(*request.nodes, request.tolerance.any() ? request.tolerance.tightest() : layout_tolerance);
}

}  // namespace ehd::reference
