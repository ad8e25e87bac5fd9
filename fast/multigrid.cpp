// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehd::fast {

using std::numbers::pi;

Multigrid::Level& Multigrid::level_of(int intervals) {
  for (const auto& one : known_) {
    if (one->n == intervals) return *one;
  }
  known_.push_back(std::make_unique<Level>());
  known_.back()->n = intervals;
  return *known_.back();
}

void Multigrid::assemble_band(Level& level) const {
  const Discretisation& s = *level.scheme;
  const int n = s.n;
  Banded& band = level.band;
  band.resize(n - 1);
  const Grid& grid = *level.grid;
  const double g0 = grid.weight(0), g1 = grid.weight(1), g2 = grid.weight(2), scale = -s.length / (n * pi);
  const double k0 = scale * (2 * g0 - 2 * g1), k1 = scale * (2 * g1 - g0 - g2);
  const double* const per = grid.by_slope.data();
  // dF_i by d_(i-2) .. d_(i+2); phi'_j dP_j = 2 d_j - d_(j-1) - d_(j+1), dH_j ~ k0 d_j + k1 (d_(j-1) + d_(j+1)).
  const auto face = [&](int i) {
    // P_0 and P_n are given: their columns are dropped.
    const double pl = i > 1 ? s.p_left[i] * per[i - 1] : 0, pm = i > 0 ? s.p_mid[i] * per[i] : 0;
    const double pr = i < n - 1 ? s.p_right[i] * per[i + 1] : 0;
    const double wl = s.w_left[i], wm = s.w_mid[i], wr = s.w_right[i];
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
    Banded::Row& row = band.row(i - 1);  // row of r_i = F_i - F_(i-1), columns d_(i-3) .. d_(i+2)
    row[0] = -before[0];
    for (std::size_t k = 1; k < 5; ++k) row[k] = now[k - 1] - before[k];
    row[5] = now[4];
    before = now;
  }
  level.smooths = band.factorise();
}

bool Multigrid::assemble_dense(const Level& level) {
  const Discretisation& s = *level.scheme;
  const int n = s.n;
  // Columns 0..n-2: P_1..P_(n-1); n-1: H_0; n: X*.
  RowMajor& film = film_;  // row by row, as Reynolds' equation combines them
  film.resize(n + 1, n + 1);
  const double scale = -s.length / pi, log_length = std::log(s.length);
  Eigen::RowVectorXd& integral = integral_;
  integral = (level.grid->slope.segment(1, n - 1) / n).matrix().transpose();
  const RowMajor& kernel = level.grid->dense();
  for (int i = 0; i <= n; ++i)
    film.row(i).head(n - 1) = scale * (kernel.row(i).segment(1, n - 1) + log_length * integral);
  film.col(n - 1).setOnes();
  film.col(n) = s.film_by_exit.matrix();
  dense_.resize(n + 1, n + 1);
  const double at_exit = s.density.value[n];
  dense_.row(0) = s.w_mid[0] * film.row(0) + s.w_right[0] * film.row(1) - at_exit * film.row(n);
  for (int i = 0; i < n; ++i) {
    if (i > 0)
      dense_.row(i) = s.w_left[i] * film.row(i - 1) + s.w_mid[i] * film.row(i) + s.w_right[i] * film.row(i + 1) -
                      at_exit * film.row(n);
    if (i > 1) dense_(i, i - 2) += s.p_left[i];
    if (i > 0) dense_(i, i - 1) += s.p_mid[i];
    if (i + 1 < n) dense_(i, i) += s.p_right[i];
    dense_(i, n) += s.by_exit[i];
  }
  dense_.row(n).head(n - 1) = s.length * integral;
  dense_(n, n - 1) = 0;
  dense_(n, n) = s.load_by_exit;
  factors_.compute(Eigen::Map<const Eigen::MatrixXd>(dense_.data(), n + 1, n + 1));
  right_side_.resize(n + 1);
  return dense_.allFinite() && factors_.matrixLU().diagonal().cwiseAbs().minCoeff() > 0;
}

bool Multigrid::prepare(const Setting& setting, const Discretisation& finest, const State& state, Grids& grids,
                        Counters& counters) {
  const InStage stage(counters, Stage::factorise);
  levels_.clear();
  const Array* pressure = &state.P;
  const int coarsest = grids.map() ? coarsest_mapped : coarsest_uniform;
  for (int n = finest.n;; n = (n + 1) / 2) {
    Level& level = level_of(n);
    level.grid = &grids.of(n);
    if (levels_.empty()) {
      level.scheme = &finest;
    } else {
      if (!level.own) level.own = std::make_unique<Discretisation>();
      const Discretisation& fine = *levels_.back()->scheme;
      counters.clock.change_to(Stage::linearise);
      level.own->inject(fine, *pressure, level.pressure, *level.grid);
      level.own->linearise(setting, level.pressure, state.exit);
      counters.clock.change_to(Stage::factorise);
      level.scheme = level.own.get();
      pressure = &level.pressure;
    }
    level.error.resize(n);
    level.step.P.setZero(n + 1);
    levels_.push_back(&level);
    if (n <= coarsest + coarsest / 2) {
      counters.clock.change_to(Stage::coarsest);
      return assemble_dense(level);
    }
    assemble_band(level);
  }
}

void Multigrid::solve_dense(Level& level, double load_error) {
  const int n = level.scheme->n;
  right_side_.head(n) = level.error.matrix();
  right_side_[n] = load_error;
  Eigen::VectorXd& x = solution_;
  x = factors_.transpose().solve(right_side_);
  level.step.P[0] = level.step.P[n] = 0;
  level.step.P.segment(1, n - 1) = x.head(n - 1).array();
  level.step.offset = x[n - 1];
  level.step.exit = x[n];
}

void Multigrid::down(std::size_t index, double load_error, Counters& counters) {
  Level& level = *levels_[index];
  if (index + 1 == levels_.size()) {
    const InStage stage(counters, Stage::coarsest);
    return solve_dense(level, load_error);
  }
  const int n = level.scheme->n;

  // Smooth.
  level.step.offset = level.step.exit = 0;
  if (level.smooths) {
    Array& d = level.dipole;
    d = level.error.tail(n - 1) - level.error.head(n - 1);
    level.band.solve(d);
    Array& P = level.step.P;
    P[0] = P[n] = 0;
    const Array& per = level.grid->by_slope;
    for (int j = 1; j < n; ++j) P[j] = per[j] * (2 * d[j - 1] - (j > 1 ? d[j - 2] : 0.0) - (j < n - 1 ? d[j] : 0.0));
    double load_change = 0;
    level.scheme->apply(level.step, *level.grid, counters, level.change, load_change);
    level.error -= level.change;
    load_error -= load_change;
  } else {
    level.step.P.setZero();
  }

  // Coarse correction.
  Level& coarse = *levels_[index + 1];
  const int m = coarse.scheme->n;
  if (n % 2 == 0) {
    for (int i = 0; i < m; ++i) coarse.error[i] = (level.error[2 * i] + level.error[2 * i + 1]) / 2;
  } else {
    for (int i = 0; i < m; ++i) {  // the fine faces about the coarse one
      const double at = (i + 0.5) * n / m - 0.5;
      const int left = std::clamp(static_cast<int>(at), 0, n - 2);
      const double share = at - left;
      coarse.error[i] = (1 - share) * level.error[left] + share * level.error[left + 1];
    }
  }
  down(index + 1, load_error, counters);

  const Array& correction = coarse.step.P;
  if (n % 2 == 0) {
    for (int i = 0; i < m; ++i) {
      level.step.P[2 * i] += correction[i];
      level.step.P[2 * i + 1] += (correction[i] + correction[i + 1]) / 2;
    }
  } else {
    for (int i = 1; i < n; ++i) {
      const double at = static_cast<double>(i) * m / n;
      const int left = std::min(static_cast<int>(at), m - 1);
      level.step.P[i] += (1 - (at - left)) * correction[left] + (at - left) * correction[left + 1];
    }
  }
  level.step.P[0] = level.step.P[n] = 0;
  level.step.offset += coarse.step.offset;
  level.step.exit += coarse.step.exit;
}

void Multigrid::cycle(const Array& flux_error, double load_error, Step& step, Counters& counters) {
  const InStage stage(counters, Stage::smooth);
  levels_[0]->error = flux_error;
  down(0, load_error, counters);
  step = levels_[0]->step;
}

}  // namespace ehd::fast
