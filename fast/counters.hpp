// SPDX-License-Identifier: GPL-3.0-or-later
// What a solve counts, and where its time goes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>

#include "contact/enum_words.hpp"

namespace ehd::fast {

/// The parts of a solve that are timed. `other`: starts, interpolation, line search, observation.
enum class Stage { product, laws, residual, linearise, factorise, smooth, coarsest, krylov, grids, other };
inline constexpr std::string_view stage_names[] = {
    "kernel products",        "laws",          "residual",          "linearisation",   "factorisation",
    "smoothing and transfer", "coarsest grid", "orthogonalisation", "maps and tables", "other"};
static_assert(std::size(stage_names) == word_count<Stage>(), "each stage has a name");

/// A stop watch that belongs to one stage at a time; 30 ns a change.
class StageClock {
 public:
  using Clock = std::chrono::steady_clock;
  /// The time since the last change goes to the present stage, which is returned; the clock then belongs to `next`.
  Stage change_to(Stage next) {
    const auto now = Clock::now();
    seconds_[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    return std::exchange(stage_, next);
  }
  [[nodiscard]] double seconds(Stage stage) const { return seconds_[static_cast<std::size_t>(stage)]; }
  /// The stages of a solve that ran within the present stage of this one: their time leaves that stage.
  void add(const StageClock& within) {
    change_to(stage_);
    for (std::size_t k = 0; k < seconds_.size(); ++k) {
      seconds_[k] += within.seconds_[k];
      seconds_[static_cast<std::size_t>(stage_)] -= within.seconds_[k];
    }
  }

 private:
  Stage stage_ = Stage::other;
  Clock::time_point since_ = Clock::now();
  std::array<double, std::size(stage_names)> seconds_ = {};
};

/// Counts that a solve reports.
struct Counters {
  StageClock clock;
  long convolutions = 0;
  double convolution_points = 0;  ///< sum of the intervals over all kernel products
  std::set<int> product_grids;    ///< the intervals of all of them
  long newton = 0;
  long krylov = 0;
  long viscosity_points = 0;
  long density_points = 0;

  void count_product(int intervals) {
    ++convolutions;
    convolution_points += intervals;
    product_grids.insert(intervals);
  }

  /// Also what another solve counts, which ran within this one.
  void add(const Counters& other) {
    clock.add(other.clock);
    convolutions += other.convolutions;
    convolution_points += other.convolution_points;
    product_grids.insert(other.product_grids.begin(), other.product_grids.end());
    newton += other.newton;
    krylov += other.krylov;
    viscosity_points += other.viscosity_points;
    density_points += other.density_points;
  }
};

/// Within the scope of this object, time belongs to `stage`.
class InStage {
 public:
  InStage(Counters& counters, Stage stage) : clock_(counters.clock), before_(clock_.change_to(stage)) {}
  ~InStage() { clock_.change_to(before_); }
  InStage(const InStage&) = delete;
  InStage& operator=(const InStage&) = delete;

 private:
  StageClock& clock_;
  Stage before_;
};

}  // namespace ehd::fast
