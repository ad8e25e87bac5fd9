// SPDX-License-Identifier: GPL-3.0-or-later
// Options that several subcommands share: from text to checked value. All throw UsageError.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/law_table.hpp"
#include "cli/command_line.hpp"
#include "contact/quantities.hpp"
#include "workflow/deadline.hpp"

namespace ehd {
struct RegisteredSolver;
struct Request;
}  // namespace ehd

namespace ehd::cli {

/// --tolerance | --tolerance-minimum, --tolerance-central | --nodes, and --max-iterations, --time-limit, as texts until
/// they are checked.
struct RequestOptions {
  std::optional<std::string> tolerance, tolerance_minimum, tolerance_central, nodes, max_iterations, time_limit;
  void add_to(Command& command, bool with_accuracy = true);
  [[nodiscard]] bool states_accuracy() const { return tolerance || tolerance_minimum || tolerance_central || nodes; }
  /// Throws UsageError: out of range, fewer than 16 nodes, two ways to state the accuracy.
  [[nodiscard]] Request request() const;
  /// Throws UsageError where --tolerance-minimum or --tolerance-central is of a film that no wanted quantity needs.
  void require_wanted(const Wanted& wanted) const;
};

/// Throws UsageError for an unknown name.
[[nodiscard]] const RegisteredSolver& solver_named(const std::string& name);
[[nodiscard]] Wanted quantities_named(const std::vector<std::string>& names);
/// The laws in the order given, each once.
[[nodiscard]] std::vector<bearing::Law> laws_named(const std::vector<std::string>& names);
/// --threads N, 1 to 1024. Without the option 0: as many as there are cores.
[[nodiscard]] unsigned thread_count(const std::optional<std::string>& text);

/// --time-limit-total S, and the deadline that it sets from now on; without the option none.
void add_time_limit_total(Command& command, std::optional<std::string>& text);
[[nodiscard]] Deadline deadline_in(const std::optional<std::string>& text);

/// Throws UsageError where that many intervals do not fit into memory.
void require_memory(const RegisteredSolver& solver, const Request& request);

}  // namespace ehd::cli
