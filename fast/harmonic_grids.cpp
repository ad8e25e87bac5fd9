// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic_grids.hpp"

#include <algorithm>
#include <memory>

#include "fast/judgement.hpp"
#include "fast/map.hpp"
#include "fast/mapped_ways.hpp"
#include "fast/remap.hpp"

namespace ehd::fast {

namespace {

/// Step in s of the difference over moved maps: some 1e-4 cells of 64 intervals.
constexpr double small_move = 2e-6;

double planning_of(const Workspace& workspace) {
  return workspace.grids.planning_s() + workspace.moved[0].planning_s() + workspace.moved[1].planning_s();
}

/// The map for a spike that stands about `step` further on in s.
Map with_moved_spike(const Map& map, double step) {
  MapShape shape = map.shape();
  shape.spike += step / map.slope(shape.spike);
  return Map(shape);
}

}  // namespace

HarmonicGrids::HarmonicGrids(const Problem& problem, const Request& request, double residual, Care care,
                             Workspace& workspace)
    : request_(request),
      newton_residual_(std::max(residual, round_off_residual)),
      care_(care),
      run_(begin_mapped(problem, request_, workspace)),
      planning_before_(planning_of(workspace)) {
  run_.residual_on_given_grids = newton_residual_;
}

void HarmonicGrids::add(const NodeFields& nodes, double residual) {
  OnGrid& at = grids_.emplace_back();
  at.harmonic = std::make_unique<Harmonic>(run_.setting, nodes, run_.state, run_.workspace.grids, run_.counters);
  at.residual = residual;
  at.state = run_.state;
  prolongation_.note(run_.state);
}

bool HarmonicGrids::climb() {
  const MappedClimb climb = best_climb(run_, request_, care_);
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

bool HarmonicGrids::refine(int most) {
  const int n = 2 * grids_.back().harmonic->intervals();
  if (n > most || spent()) return false;
  const double film = film_now(run_);
  const State last = run_.state;
  run_.state = prolongation_.onto(n, run_.workspace.grids, run_.setting.inlet);
  const Attempt attempt = solve_on(run_, film, everywhere(newton_residual_));
  if (attempt.succeeded) {
    add(run_.workspace.now().nodes, attempt.newton.residual);
  } else {
    run_.state = last;
  }
  return attempt.succeeded;
}

const MovedNodes& HarmonicGrids::moved(std::size_t k) {
  OnGrid& at = grids_[k];
  if (at.moved) return *at.moved;
  const InStage stage(run_.counters, Stage::grids);
  Grids& own = run_.workspace.grids;
  auto& [forward, back] = run_.workspace.moved;
  if (!moves_) {
    forward.use(std::make_shared<const Map>(with_moved_spike(*own.map(), small_move)), own.robust_wedge(),
                own.tables());
    back.use(std::make_shared<const Map>(with_moved_spike(*own.map(), -small_move)), own.robust_wedge(), own.tables());
    moves_ = true;
  }
  const int n = at.harmonic->intervals();
  return at.moved.emplace(
      moved_nodes(run_.setting, at.state, own.of(n), forward.of(n), back.of(n), small_move, run_.counters));
}

double HarmonicGrids::planning_s() const { return planning_of(run_.workspace) - planning_before_; }

}  // namespace ehd::fast
