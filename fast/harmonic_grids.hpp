// SPDX-License-Identifier: GPL-3.0-or-later
// The steady states of one contact on the grids of one map, each with twice the intervals of the one before, and the
// equations of small motions about each.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fast/harmonic.hpp"
#include "fast/mapped_start.hpp"
#include "fast/prolongation.hpp"
#include "fast/run.hpp"

namespace ehd::fast {

class HarmonicGrids {
 public:
  /// Plans, tables and arrays stay in the caller's workspace. Newton's method may leave `residual` on each grid. The
  /// map is made with `care`. The time limit starts here.
  HarmonicGrids(const Problem& problem, const Request& request, double residual, Care care, Workspace& workspace);

  /// Finds the steady states up to request.nodes on the best map. False where there are none.
  [[nodiscard]] bool climb();
  /// A grid with twice as many intervals. False where that is more than `most`, where the limits are spent, or where
  /// Newton's method fails.
  [[nodiscard]] bool refine(int most);
  /// What moving the nodes of a grid with the spike changes; made once.
  [[nodiscard]] const MovedNodes& moved(std::size_t k);

  [[nodiscard]] std::size_t size() const { return grids_.size(); }
  [[nodiscard]] Harmonic& operator[](std::size_t k) { return *grids_[k].harmonic; }
  [[nodiscard]] const Harmonic& operator[](std::size_t k) const { return *grids_[k].harmonic; }
  /// The residual that Newton's method left on a grid.
  [[nodiscard]] double residual(std::size_t k) const { return grids_[k].residual; }
  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] double planning_s() const;
  [[nodiscard]] bool spent() const { return run_.limit_reached || run_.limits.time_is_up(); }

 private:
  struct OnGrid {
    std::unique_ptr<Harmonic> harmonic;
    double residual = 0;
    State state;
    std::optional<MovedNodes> moved = {};
  };
  /// Adds the equations about run_.state, whose fields are `nodes`.
  void add(const NodeFields& nodes, double residual);

  const Request request_;
  const double newton_residual_;
  const Care care_;
  Run run_;
  const double planning_before_;
  Prolongation prolongation_;
  std::vector<OnGrid> grids_;
  bool moves_ = false;  ///< the workspace's moved grids are made for this contact's map
};

}  // namespace ehd::fast
