// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic_grids.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "fast/judgement.hpp"
#include "fast/mapped_start.hpp"
#include "fast/mapped_ways.hpp"
#include "fast/remap.hpp"

namespace ehd::fast {

namespace {

/// Secant steps for the place of a spike. Two leave 1e-3 of a cell, since s is nearly linear over a cell.
constexpr int spike_steps = 3;

}  // namespace

Map with_moved_spike(const Map& map, double step) {
  const double spike = map.shape().spike, wanted = map(spike) - step;
  MapShape shape = map.shape();
  double before = spike, error_before = step, slope = -map.slope(spike);
  for (int k = 0; k < spike_steps; ++k) {
    shape.spike = before - error_before / slope;
    const double error = Map(shape)(spike) - wanted;
    if (shape.spike == before || error == error_before) break;
    slope = (error - error_before) / (shape.spike - before);
    before = shape.spike;
    error_before = error;
  }
  return Map(shape);
}

HarmonicGrids::HarmonicGrids(const Problem& problem, const Request& request, double residual, Workspace& workspace)
    : request_(request),
      newton_residual_(std::max(residual, round_off_residual)),
      run_(begin_mapped(problem, request_, workspace)) {}

void HarmonicGrids::add(const NodeFields& nodes, double residual) {
  grids_.push_back(
      {.harmonic = std::make_unique<Harmonic>(run_.setting, nodes, run_.state, run_.workspace.grids, run_.counters),
       .residual = residual});
  prolongation_.note(run_.state);
}

bool HarmonicGrids::climb() {
  const MappedClimb climb = best_climb(run_, request_);
  if (!climb.complete) return false;
  Discretisation at;
  for (std::size_t k = 0; k < climb.states.size(); ++k) {
    run_.state = climb.states[k];
    Grid& grid = run_.workspace.grids.of(climb.grids[k].nodes);
    if (!at.evaluate(run_.setting, run_.state, grid, run_.counters)) return false;
    add(at.nodes, climb.grids[k].residual);
  }
  return true;
}

bool HarmonicGrids::climb_beside(const HarmonicGrids& other, std::size_t count, double cells) {
  const Run& from = other.run_;
  const int coarsest = other[0].intervals();
  {
    const InStage stage(run_.counters, Stage::grids);
    const Map& map = *from.workspace.grids.map();
    run_.workspace.grids.use(std::make_shared<const Map>(with_moved_spike(map, cells / coarsest)),
                             from.workspace.grids.robust_wedge());
  }
  const Known known = known_now(from);
  while (size() < count) {
    const int n = other[size()].intervals();
    run_.state = size() < 2 ? on_present_map(run_, known, from.state.tail, n)
                            : prolongation_.onto(n, run_.workspace.grids, run_.setting.inlet);
    const Attempt attempt = solve_on(run_, known.film, {.residual = newton_residual_});
    if (!attempt.succeeded) return false;
    add(run_.workspace.now().nodes, attempt.newton.residual);
  }
  return true;
}

bool HarmonicGrids::refine(int most) {
  const int n = 2 * grids_.back().harmonic->intervals();
  if (n > most || spent()) return false;
  const double film = film_now(run_);
  const State last = run_.state;
  run_.state = prolongation_.onto(n, run_.workspace.grids, run_.setting.inlet);
  const Attempt attempt = solve_on(run_, film, {.residual = newton_residual_});
  if (attempt.succeeded) {
    add(run_.workspace.now().nodes, attempt.newton.residual);
  } else {
    run_.state = last;
  }
  return attempt.succeeded;
}

}  // namespace ehd::fast
