// SPDX-License-Identifier: GPL-3.0-or-later
// THE list of solvers: the program, the suite and the comparisons iterate over it. A new solver is one header and one
// line in registry.cpp.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/response.hpp"
#include "contact/solver.hpp"

namespace ehd {

/// A solver and its traits. Code that needs a solver of some kind asks for the trait, not for a name.
struct RegisteredSolver {
  std::string name;  ///< what --solver takes
  SolverDescription description;
  /// Each thread that calls it keeps FFT plans, tables and arrays for its next solves, up to 13 MB.
  std::function<Solution(const Problem&, const Request&)> solve;
  bool uses_fft = false;
  std::function<double(double)> memory_bytes;  ///< the largest memory of a solve with N intervals, inlet to exit
  bool is_default = false;                     ///< where nobody names a solver
  bool certified = false;         ///< its error bars come from a second, independent discretisation; it is the truth
  std::string_view twin_of = {};  ///< the solver with the same grid and discretisation, of which this is a rewrite
  int look = 0;                   ///< number of its line style in figures, from 1; each solver has its own
  /// The linear response of a contact; empty where the solver has none.
  std::function<Response(const Problem&, const ResponseRequest&)> respond = {};
  double response_tolerance = 0;  ///< of a response where nobody states one

  /// Its kernel is a dense matrix: time ~ n^3, memory ~ n^2.
  [[nodiscard]] bool dense() const { return !uses_fft; }
};

[[nodiscard]] const std::vector<RegisteredSolver>& solvers();

/// By name, nullptr where there is none.
[[nodiscard]] const RegisteredSolver* find_solver(std::string_view name);

/// The solver where nobody names one, and the one that is the truth for the others: one row each.
[[nodiscard]] const RegisteredSolver& default_solver();
[[nodiscard]] const RegisteredSolver& certified_solver();

/// A solver and the solver that it is a twin of.
struct SolverTwins {
  const RegisteredSolver* solver;
  const RegisteredSolver* twin;
};
[[nodiscard]] std::vector<SolverTwins> solver_twins();

/// "reference, reference.uniform, …" for messages.
[[nodiscard]] std::string solver_names();
/// The names of the solvers that have a response.
[[nodiscard]] std::string responsive_solver_names();

/// The loosest relative error of a film that a solve may be asked for.
inline constexpr double loosest_tolerance = 1;

/// Memory that this process may still take: the machine's available memory, or what its control group leaves.
[[nodiscard]] double available_memory_bytes();

/// From now on FFTW measures its plans, starting from what an earlier run learned (FFTW's own text, or empty). False:
/// the text is no wisdom of this FFTW. Two runs may then differ by rounding.
[[nodiscard]] bool measure_fft_plans(const std::string& wisdom);
/// What was learned, for the next run.
[[nodiscard]] std::string learned_fft_plans();

}  // namespace ehd
