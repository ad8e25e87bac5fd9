// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/schemes.hpp"

#include <utility>

#include "fast/discretisation.hpp"
#include "reference/equations.hpp"
#include "verification/claims/shared.hpp"
#include "verification/studies/box.hpp"

namespace ehd::verification::schemes {

namespace {

/// Graded towards the right end, with the wedge of equal cells. The claims judge the scheme, not the places of nodes.
reference::Grid graded_grid(int intervals) {
  reference::Grid grid = reference::uniform_grid(inlet, intervals);
  const Array s = grid.fractions;
  grid.fractions = s * (0.6 + 0.4 * s);
  return grid;
}

std::shared_ptr<const fast::Map> some_map() {
  return std::make_shared<const fast::Map>(
      fast::MapShape{.inlet = inlet, .exit = 0.9, .scale = 1, .inlet_width = 0.3, .spike = 0.4, .spike_width = 0.1});
}

}  // namespace

std::shared_ptr<const Sources> sources_for(std::function<double(double)> film) {
  const auto none = [](double) { return std::pair(0.0, 0.0); };
  return std::make_shared<Sources>(Sources{
      .film = [film = std::move(film)](double X) { return std::pair(film(X) - X * X / 2, 0.0); }, .balance = none});
}

Problem rigid_problem(std::function<double(double)> film) {
  Problem problem = problem_at({any_M, 0}, false, TruncatedAt{inlet});
  problem.sources = sources_for(std::move(film));
  return problem;
}

Scheme evaluated(Kind kind, const Problem& problem, double exit, const Array& P, double offset) {
  const Eigen::Index n = P.size() - 1;
  const int intervals = static_cast<int>(n);
  if (kind == Kind::reference_uniform || kind == Kind::reference_graded) {
    const reference::Equations equations(
        problem, kind == Kind::reference_graded ? graded_grid(intervals) : reference::uniform_grid(inlet, intervals));
    const auto at = equations.evaluate({.P = P, .offset = offset, .exit = exit});
    return {at.X, at.H, at.wedge, at.mobility, at.residual.head(n)};
  }
  fast::Grids grids;
  if (kind == Kind::fast_mapped) grids.use(some_map());
  fast::State state{.P = P, .offset = offset, .exit = exit, .tail = {}};
  fast::Discretisation scheme;
  fast::Counters counters;
  if (!scheme.evaluate(setting_of(problem, inlet), state, grids.of(intervals), counters)) return {};
  return {scheme.nodes.places(inlet), scheme.nodes.H, scheme.faces.flux, scheme.faces.eps, scheme.error.flux};
}

Scheme at_rest(Kind kind, const Problem& problem, int intervals, double exit) {
  return evaluated(kind, problem, exit, Array::Zero(intervals + 1));
}

}  // namespace ehd::verification::schemes
