// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/multigrid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fast/counters.hpp"

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// Intervals of the coarsest level, from this number to half as many again. On uniform grids 32 and 128 measured no
/// better than 64.
constexpr int coarsest_uniform = 64, coarsest_mapped = 32;

}  // namespace

Multigrid::Level& Multigrid::level_of(int intervals) {
  for (const auto& one : known_) {
    if (one->n == intervals) return *one;
  }
  known_.push_back(std::make_unique<Level>());
  known_.back()->n = intervals;
  return *known_.back();
}

bool Multigrid::prepare(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian, const State& state,
                        Grids& grids, Counters& counters) {
  const InStage stage(counters, Stage::factorise);
  levels_.clear();
  const Array* pressure = &state.P;
  const int coarsest = grids.map() ? coarsest_mapped : coarsest_uniform;
  for (int n = finest.n;; n = (n + 1) / 2) {
    const bool last = n <= coarsest + coarsest / 2;
    Level& level = level_of(n);
    if (levels_.empty()) {
      level.nodes = &finest;
      level.jacobian = &jacobian;
    } else {
      Grid& grid = last ? grids.unplanned(n) : grids.of(n);
      counters.clock.change_to(Stage::linearise);
      level.own_nodes.inject(*levels_.back()->nodes, *pressure, level.pressure, grid);
      level.own_jacobian.linearise(setting, level.own_nodes, level.pressure, state.exit);
      counters.clock.change_to(Stage::factorise);
      level.nodes = &level.own_nodes;
      level.jacobian = &level.own_jacobian;
      pressure = &level.pressure;
    }
    level.error.flux.resize(n);
    level.step.P.setZero(n + 1);
    levels_.push_back(&level);
    if (last) {
      counters.clock.change_to(Stage::coarsest);
      return coarsest_.factorise(*level.nodes, *level.jacobian);
    }
    level.assemble_band();
  }
}

/// The matrix of r_i = F_i - F_(i-1) in the dipole variable, factorised.
void Multigrid::Level::assemble_band() {
  const Jacobian& J = *jacobian;
  const Grid& grid = *nodes->grid;
  band.resize(n - 1);
  const double g0 = grid.weight(0), g1 = grid.weight(1), g2 = grid.weight(2), scale = -J.length / (n * pi);
  const double k0 = scale * (2 * g0 - 2 * g1), k1 = scale * (2 * g1 - g0 - g2);
  const double* const per = grid.inverse_slope.data();
  // dF_i by d_(i-2) .. d_(i+2); phi'_j dP_j = 2 d_j - d_(j-1) - d_(j+1), dH_j ~ k0 d_j + k1 (d_(j-1) + d_(j+1)).
  const auto face = [&](int i) {
    // P_0 and P_n are given: their columns are dropped.
    const double pl = i > 1 ? J.p_left[i] * per[i - 1] : 0, pm = i > 0 ? J.p_mid[i] * per[i] : 0;
    const double pr = i < n - 1 ? J.p_right[i] * per[i + 1] : 0;
    const double wl = J.w_left[i], wm = J.w_mid[i], wr = J.w_right[i];
    return std::array<double, 5>{
        -pl + k1 * wl,
        2 * pl - pm + k0 * wl + k1 * wm,
        -pl + 2 * pm - pr + k1 * wl + k0 * wm + k1 * wr,
        -pm + 2 * pr + k1 * wm + k0 * wr,
        -pr + k1 * wr,
    };
  };
  auto before = face(0);
  for (int i = 1; i < n; ++i) {
    const auto now = face(i);
    Banded::Row& row = band.row(i - 1);  // columns d_(i-3) .. d_(i+2)
    row[0] = -before[0];
    for (std::size_t k = 1; k < 5; ++k) row[k] = now[k - 1] - before[k];
    row[5] = now[4];
    before = now;
  }
  smooths = band.factorise();
}

/// Makes a step that removes the rough part of the error, and updates the error.
void Multigrid::Level::smooth(Counters& counters) {
  step.offset = step.exit = 0;
  if (!smooths) {
    step.P.setZero();
    return;
  }
  Array& d = dipole;
  d = error.flux.tail(n - 1) - error.flux.head(n - 1);
  band.solve(d);
  Array& P = step.P;
  P[0] = P[n] = 0;
  const Array& per = nodes->grid->inverse_slope;
  for (int j = 1; j < n; ++j) P[j] = per[j] * (2 * d[j - 1] - (j > 1 ? d[j - 2] : 0.0) - (j < n - 1 ? d[j] : 0.0));
  const Residual& change = jacobian->apply(step, counters);
  error.flux -= change.flux;
  error.load -= change.load;
}

/// Flux errors of a coarse face: the mean of its two fine ones, or linear interpolation between fine faces.
void Multigrid::Level::restrict_to(Level& coarse) const {
  const int m = coarse.n;
  if (n % 2 == 0) {
    for (Eigen::Index i = 0; i < m; ++i) coarse.error.flux[i] = (error.flux[2 * i] + error.flux[2 * i + 1]) / 2;
  } else {
    for (int i = 0; i < m; ++i) {
      const double at = (i + 0.5) * n / m - 0.5;
      const int left = std::clamp(static_cast<int>(at), 0, n - 2);
      const double share = at - left;
      coarse.error.flux[i] = (1 - share) * error.flux[left] + share * error.flux[left + 1];
    }
  }
  coarse.error.load = error.load;
}

/// The coarse level's step, interpolated linearly.
void Multigrid::Level::add_correction(const Level& coarse) {
  const Array& correction = coarse.step.P;
  const int m = coarse.n;
  if (n % 2 == 0) {
    for (Eigen::Index i = 0; i < m; ++i) {
      step.P[2 * i] += correction[i];
      step.P[2 * i + 1] += (correction[i] + correction[i + 1]) / 2;
    }
  } else {
    for (int i = 1; i < n; ++i) {
      const double at = static_cast<double>(i) * m / n;
      const int left = std::min(static_cast<int>(at), m - 1);
      step.P[i] += (1 - (at - left)) * correction[left] + (at - left) * correction[left + 1];
    }
  }
  step.P[0] = step.P[n] = 0;
  step.offset += coarse.step.offset;
  step.exit += coarse.step.exit;
}

void Multigrid::down(std::size_t index, Counters& counters) {
  Level& level = *levels_[index];
  if (index + 1 == levels_.size()) {
    const InStage stage(counters, Stage::coarsest);
    coarsest_.solve(level.error, level.step);
    return;
  }
  Level& coarse = *levels_[index + 1];
  level.smooth(counters);
  level.restrict_to(coarse);
  down(index + 1, counters);
  level.add_correction(coarse);
}

void Multigrid::cycle(const Residual& error, Step& step, Counters& counters) {
  const InStage stage(counters, Stage::smooth);
  levels_[0]->error = error;
  down(0, counters);
  step = levels_[0]->step;
}

}  // namespace ehd::fast
