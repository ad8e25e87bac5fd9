// SPDX-License-Identifier: GPL-3.0-or-later
// THE list of solvers: the program, the suite and the comparisons iterate over it. A new solver is one header and one
// line in registry.cpp.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/solver.hpp"

namespace ehd {

struct RegisteredSolver {
  std::string name;  ///< what --solver takes; for an alias, not description.name
  SolverDescription description;
  std::function<Solution(const Problem&, const Request&)> solve;
  bool uses_fft = false;
  std::function<double(double)> memory_bytes;  ///< what a solve with N intervals, inlet to exit, holds at its largest
};

[[nodiscard]] const std::vector<RegisteredSolver>& solvers();

/// By name, nullptr where there is none.
[[nodiscard]] const RegisteredSolver* find_solver(std::string_view name);

/// "reference, reference.uniform, …" for messages.
[[nodiscard]] std::string solver_names();

/// Memory that this process may still take: the machine's available memory, or what its control group leaves.
[[nodiscard]] double available_memory_bytes();

/// From now on FFTW measures its plans, starting from what an earlier run learned (FFTW's own text, or empty). False:
/// the text is no wisdom of this FFTW. Two runs may then differ by rounding.
[[nodiscard]] bool measure_fft_plans(const std::string& wisdom);
/// What was learned, for the next run.
[[nodiscard]] std::string learned_fft_plans();

}  // namespace ehd
