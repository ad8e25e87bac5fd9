// SPDX-License-Identifier: GPL-3.0-or-later
// Cost against the number of unknowns: time, work, memory, each size in a process of its own.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/conditions.hpp"
#include "io/json.hpp"
#include "verification/bench/timing.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

/// Seconds of one padded convolution on n intervals: a real FFT of twice the length, a product with a spectrum, the
/// inverse FFT. FFTW_ESTIMATE; the median of repetitions. A work unit counts one such convolution.
[[nodiscard]] double convolution_s(int intervals, const Repetition& repetition);

/// c, the unit of times, is a convolution on so many intervals.
inline constexpr int unit_intervals = 512;
/// c now [s]: measured for a tenth of a second at most, beside what is timed.
[[nodiscard]] double c_now();

struct ScalingRow {
  std::string solver;
  MoesGroups contact;
  int nodes = 0;                          ///< asked
  std::optional<StopReason> status = {};  ///< none: not run
  std::string reason = {};
  std::vector<double> wall_s = {};  ///< of each cold solve
  double convolution_s = 0;
  double peak_bytes = 0;  ///< largest memory of the first solve, less the memory held after a solve on 64 intervals
  int nodes_used = 0;
  double work_units = 0;
  long newton_iterations = 0;
  std::vector<std::pair<std::string, double>> stage_s = {};

  [[nodiscard]] std::optional<double> median_s() const;
  [[nodiscard]] std::optional<double> per_unit() const;        ///< time over (work units x one convolution)
  [[nodiscard]] std::optional<double> ns_per_n_log_n() const;  ///< time over n log2 n, in nanoseconds
};

struct ScalingRequest {
  struct Range {
    const RegisteredSolver* solver = nullptr;
    int most = 0;  ///< intervals; from 256 by doubling
  };
  std::vector<Range> solvers;
  std::vector<MoesGroups> contacts;  ///< Roelands, compressible, inlet cut at -4
  double time_limit_s = 30;
  Repetition repetition = {};
  std::function<void(const std::string&)> progress = {};
};
/// 2^20 intervals for a solver whose work grows linearly with them on a uniform grid, 2^14 for other FFT solvers; 2^12
/// for all of them when quick. (20, 10) and (5, 5); when quick, the second alone.
[[nodiscard]] ScalingRequest usual_scaling(const std::vector<const RegisteredSolver*>& solvers, bool quick);

/// A size is not run where it would not fit into memory, or where a smaller one reached the time limit; its row says
/// so. Call with no other thread running (see in_child).
[[nodiscard]] std::vector<ScalingRow> run_scaling(const ScalingRequest& request);

/// The exponent b of time ~ n^b, by least squares of the logarithms over converged rows of one solver and contact with
/// at least `least` intervals; absent for fewer than three.
[[nodiscard]] std::optional<double> fitted_exponent(const std::vector<ScalingRow>& rows, const std::string& solver,
                                                    const MoesGroups& contact, int least);

[[nodiscard]] Json to_json(const std::vector<ScalingRow>& rows);
[[nodiscard]] std::string scaling_csv(const std::vector<ScalingRow>& rows);
[[nodiscard]] std::string human_table(const std::vector<ScalingRow>& rows);

}  // namespace ehd::verification
