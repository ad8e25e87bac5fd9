// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a sweep: its name, its computation, and why it failed.
//
// A row depends on its own case alone: its contacts are cold solves at loads that follow from that case. So no bit of a
// row depends on threads, shards, the order of the rows, or which row solved a shared contact first.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "io/json.hpp"
#include "io/sweep_file.hpp"
#include "workflow/contact_cache.hpp"
#include "workflow/deadline.hpp"

namespace ehd {

/// The schema of rows.json. It is hashed with every row, so that rows of another schema are not taken for these.
inline constexpr const char* sweep_schema = "ehd-sweep-1";

struct SweepRequest {
  int max_iterations = 2000;  ///< of each contact solve
  double time_limit_s = 300;  ///< likewise; where it ends a solve, the row depends on the machine
  unsigned threads = 0;       ///< 0: as many as there are cores
  bool fresh = false;         ///< rows of an earlier run are computed again
  bool keep_limits = false;   ///< rows of an earlier run that lacked time or memory are not computed again
  Deadline deadline = {};     ///< of all rows; those after it are not run, and not kept
  /// After every row, one call at a time: rows known so far, of how many, how many of them this run computed.
  std::function<void(std::size_t known, std::size_t all, std::size_t computed)> progress = {};
};

/// The content_hash of all that a row's numbers follow from: the case with its values, laws, solver, tolerance, limit
/// on iterations, and the program (its commit, or its own bytes where the commit does not identify the build). Not the
/// time limit: a row that ended in time does not follow from it, and another row lacked time.
[[nodiscard]] std::string row_hash(const Sweep& sweep, const SweepRequest& request, std::size_t row);

/// A row as it is kept: all of its object in rows.json but its number. io/stored_row reads it back.
struct ComputedRow {
  std::string text;
  long needed = 0;  ///< contacts that the row would solve alone
};
/// `cache`: of the sweep's solver with fallback (workflow/bearing_contact.hpp). `table`: that of a sweep with
/// films = "table", else null.
[[nodiscard]] ComputedRow compute_row(const Sweep& sweep, const SweepRequest& request, std::size_t row,
                                      const std::string& hash, const std::shared_ptr<ContactCache>& cache,
                                      const FilmTable* table = nullptr);
/// A row that could not be computed: each result is `limit-reached` with this reason.
[[nodiscard]] ComputedRow row_not_computed(const Sweep& sweep, std::size_t row, const std::string& hash,
                                           const std::string& why);
/// A result of the kept row lacked time or memory, and another run may get further. Film curves that a limit ended
/// count too, because their row does not say whether it was the one on time.
[[nodiscard]] bool lacked_time_or_memory(const std::string& kept);

[[nodiscard]] bool converged(const Json& result);
/// Why a result did not converge; bearings and contacts name it differently. Empty where the result does not say.
[[nodiscard]] std::string reason_of(const Json& result);
/// "row 7: ehd: diverged: why" of the first result of a numbered row that did not converge.
[[nodiscard]] std::optional<std::string> failure_of(const Json& row);

}  // namespace ehd
