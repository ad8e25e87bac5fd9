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

/// The coarsest level is the first with at most one and a half times so many intervals; it has at least three quarters
/// of them, or is the finest. On uniform grids 32 and 128 measured no better than 64.
constexpr int coarsest_uniform = 64, coarsest_mapped = 32;

}  // namespace

template <class Scalar>
typename MultigridOf<Scalar>::Level& MultigridOf<Scalar>::level_of(int intervals) {
  for (const auto& one : known_) {
    if (one->n == intervals) return *one;
  }
  known_.push_back(std::make_unique<Level>());
  known_.back()->n = intervals;
  return *known_.back();
}

template <class Scalar>
bool MultigridOf<Scalar>::prepare(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                                  const State& state, Grids& grids, Counters& counters) {
  const InStage stage(counters, Stage::factorise);
  linearise(setting, finest, jacobian, nullptr, state, grids, counters);
  return factorise(Scalar(0), counters);
}

template <class Scalar>
void MultigridOf<Scalar>::prepare_motion(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                                         const Squeeze& squeeze, const State& state, Grids& grids, Counters& counters) {
  const InStage stage(counters, Stage::factorise);
  linearise(setting, finest, jacobian, &squeeze, state, grids, counters);
}

template <class Scalar>
void MultigridOf<Scalar>::linearise(const Setting& setting, const NodeFields& finest, const Jacobian& jacobian,
                                    const Squeeze* squeeze, const State& state, Grids& grids, Counters& counters) {
  levels_.clear();
  const Array* pressure = &state.P;
  const int coarsest = grids.map() ? coarsest_mapped : coarsest_uniform;
  for (int n = finest.n;; n = (n + 1) / 2) {
    const bool last = n <= coarsest + coarsest / 2;
    Level& level = level_of(n);
    if (levels_.empty()) {
      level.nodes = &finest;
      level.jacobian = &jacobian;
      level.squeeze = squeeze;
    } else {
      Grid& grid = last ? grids.unplanned(n) : grids.of(n);
      counters.clock.change_to(Stage::linearise);
      level.own_nodes.inject(*levels_.back()->nodes, *pressure, level.pressure, grid);
      level.own_jacobian.linearise(setting, level.own_nodes, level.pressure, state.exit);
      if (squeeze) level.own_squeeze.linearise(level.own_nodes);
      counters.clock.change_to(Stage::factorise);
      level.nodes = &level.own_nodes;
      level.jacobian = &level.own_jacobian;
      level.squeeze = squeeze ? &level.own_squeeze : nullptr;
      pressure = &level.pressure;
    }
    level.error.flux.resize(n);
    level.step.P.setZero(n + 1);
    levels_.push_back(&level);
    if (last) return;
  }
}

template <class Scalar>
bool MultigridOf<Scalar>::factorise(Scalar rate, Counters& counters) {
  const InStage stage(counters, Stage::factorise);
  rate_ = rate;
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k) levels_[k]->assemble_band(rate);
  factorise_bands();
  counters.clock.change_to(Stage::coarsest);
  const Level& last = *levels_.back();
  return coarsest_.factorise(*last.nodes, *last.jacobian, last.squeeze, rate);
}

/// Factorises the coarse levels one after another. Each takes turns with the finest, row by row.
template <class Scalar>
void MultigridOf<Scalar>::factorise_bands() {
  if (levels_.size() < 2) return;
  using Rows = typename BandedOf<Scalar>::Factorisation;
  Rows finest(levels_[0]->band);
  for (std::size_t k = 1; k + 1 < levels_.size(); ++k) {
    Rows coarse(levels_[k]->band);
    while (coarse.next()) finest.next();
    levels_[k]->smooths = coarse.succeeded();
  }
  while (finest.next()) {
  }
  levels_[0]->smooths = finest.succeeded();
}

/// The matrix of r_i = F_i - F_(i-1) in the dipole variable.
template <class Scalar>
void MultigridOf<Scalar>::Level::assemble_band(Scalar rate) {
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
    auto& row = band.row(i - 1);  // columns d_(i-3) .. d_(i+2)
    row[0] = -before[0];
    for (std::size_t k = 1; k < 5; ++k) row[k] = now[k - 1] - before[k];
    row[5] = now[4];
    if (squeeze) {  // s w_i m_i
      const double by_film = squeeze->by_film[i], by_density = squeeze->by_pressure[i] * per[i];
      row[2] += rate * (k1 * by_film - by_density);
      row[3] += rate * (k0 * by_film + 2 * by_density);
      row[4] += rate * (k1 * by_film - by_density);
    }
    before = now;
  }
}

/// Makes a step that removes the rough part of the error, and updates the error.
template <class Scalar>
void MultigridOf<Scalar>::Level::smooth(Scalar rate, Counters& counters) {
  step.offset = step.exit = Scalar(0);
  if (!smooths) {
    step.P.setZero();
    return;
  }
  ArrayOf<Scalar>& d = dipole;
  d = error.flux.tail(n - 1) - error.flux.head(n - 1);
  band.solve(d);
  ArrayOf<Scalar>& P = step.P;
  P[0] = P[n] = Scalar(0);
  const Array& per = nodes->grid->inverse_slope;
  for (int j = 1; j < n; ++j)
    P[j] = per[j] * (2.0 * d[j - 1] - (j > 1 ? d[j - 2] : Scalar(0)) - (j < n - 1 ? d[j] : Scalar(0)));
  ChangeOf<Scalar>& change = jacobian->change_film(step, counters, Accuracy::rough);
  jacobian->change_residual(step, change);
  if (squeeze) squeeze->subtract(rate, step, change);
  error.flux -= change.flux;
  error.load -= change.load;
}

/// Flux errors of a coarse face: the mean of its two fine ones, or linear interpolation between fine faces.
template <class Scalar>
void MultigridOf<Scalar>::Level::restrict_to(Level& coarse) const {
  const int m = coarse.n;
  if (n % 2 == 0) {
    for (Eigen::Index i = 0; i < m; ++i) coarse.error.flux[i] = (error.flux[2 * i] + error.flux[2 * i + 1]) / 2.0;
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
template <class Scalar>
void MultigridOf<Scalar>::Level::add_correction(const Level& coarse) {
  const ArrayOf<Scalar>& correction = coarse.step.P;
  const int m = coarse.n;
  if (n % 2 == 0) {
    for (Eigen::Index i = 0; i < m; ++i) {
      step.P[2 * i] += correction[i];
      step.P[2 * i + 1] += (correction[i] + correction[i + 1]) / 2.0;
    }
  } else {
    for (int i = 1; i < n; ++i) {
      const double at = static_cast<double>(i) * m / n;
      const int left = std::min(static_cast<int>(at), m - 1);
      step.P[i] += (1 - (at - left)) * correction[left] + (at - left) * correction[left + 1];
    }
  }
  step.P[0] = step.P[n] = Scalar(0);
  step.offset += coarse.step.offset;
  step.exit += coarse.step.exit;
}

template <class Scalar>
void MultigridOf<Scalar>::down(std::size_t index, Counters& counters) {
  Level& level = *levels_[index];
  if (index + 1 == levels_.size()) {
    const InStage stage(counters, Stage::coarsest);
    coarsest_.solve(level.error, level.step);
    return;
  }
  Level& coarse = *levels_[index + 1];
  level.smooth(rate_, counters);
  level.restrict_to(coarse);
  down(index + 1, counters);
  level.add_correction(coarse);
}

template <class Scalar>
void MultigridOf<Scalar>::cycle(const ResidualOf<Scalar>& error, StepOf<Scalar>& step, Counters& counters) {
  const InStage stage(counters, Stage::smooth);
  levels_[0]->error = error;
  down(0, counters);
  step = levels_[0]->step;
}

template class MultigridOf<double>;
template class MultigridOf<Complex>;

}  // namespace ehd::fast
