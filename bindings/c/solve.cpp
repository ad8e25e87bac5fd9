// SPDX-License-Identifier: GPL-3.0-or-later
// One contact, and many at once.
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/call.hpp"
#include "bindings/c/ehd/ehd.h"
#include "bindings/c/result.hpp"
#include "contact/interruption.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/case_reader.hpp"
#include "io/near_miss.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/parallel.hpp"
#include "workflow/registry.hpp"

namespace ehd::c {

namespace {

constexpr int most_threads = 1024;

const RegisteredSolver& solver_named(const char* name) {
  require_pointer(name, "solver");
  if (const RegisteredSolver* solver = find_solver(name)) return *solver;
  throw unknown_name("solver", name, is_unknown(name, solver_names()));
}

const Interval& range_of(const char* key) { return std::get<Interval>(row_of_case_key(key).allowed); }

/// Throws CaseError, BadArgument.
ContactCase moes_contact(const MoesGroups& groups, const char* lubricant) {
  require_in("M", groups.M, range_of("moes.M"));
  require_in("L", groups.L, range_of("moes.L"));
  if (lubricant) return read_moes_contact(groups, lubricant);
  return {.statement = groups, .lubricant = Lubricant{}, .inlet = Flooded{}};  // Barus, incompressible
}

/// Solves under the caller's callback and hands the result over.
int hand_over(const std::string& what, const std::function<ContactRun()>& solve, ehd_result** result) {
  Progress progress;
  const Interruptible scope([&progress] { return progress.cancelled(); });
  auto made = std::make_unique<ehd_result>(solve());
  const SolveRecord& record = std::get<ContactRun>(made->made).solution.record;
  const int code = ended(what, record.status, record.reason);
  *result = made.release();
  return code;
}

}  // namespace

}  // namespace ehd::c

int ehd_solve(const char* case_toml, const char* solver, double tolerance, ehd_result** result) {
  using namespace ehd;
  using namespace ehd::c;
  return guarded([&] {
    require_pointer(result, "result");
    *result = nullptr;
    require_pointer(case_toml, "case_toml");
    const RegisteredSolver& by = solver_named(solver);
    require_tolerance(tolerance);
    const Case one = read_case_in_memory(case_toml);
    if (!std::holds_alternative<ContactCase>(one.body))
      throw case_error(one, "bearing", "is no contact; allowed is a contact case (ehd_bearing takes this one)");
    return hand_over(
        one.id, [&] { return run_contact(one, by, {.tolerance = tolerance}); }, result);
  });
}

int ehd_solve_moes(double M, double L, const char* lubricant_toml, const char* solver, double tolerance,
                   ehd_result** result) {
  using namespace ehd;
  using namespace ehd::c;
  return guarded([&] {
    require_pointer(result, "result");
    *result = nullptr;
    const RegisteredSolver& by = solver_named(solver);
    require_tolerance(tolerance);
    const ContactCase contact = moes_contact({.M = M, .L = L}, lubricant_toml);
    return hand_over(
        fmt::format("M = {}, L = {}", plain(M), plain(L)),
        [&] { return run_contact(contact, by, {.tolerance = tolerance}); }, result);
  });
}

namespace ehd::c {

namespace {

/// The arguments of ehd_films that are arrays of one length.
struct FilmArrays {
  std::size_t n;
  const double *M, *L;
  double *minimum, *minimum_error, *central, *central_error;
  int* status;

  void require() const {
    if (n == 0) throw BadArgument("n = 0: there are no contacts; allowed is 1 or more");
    const std::pair<const void*, const char*> arrays[] = {{M, "M"},
                                                          {L, "L"},
                                                          {minimum, "minimum"},
                                                          {minimum_error, "minimum_error"},
                                                          {central, "central"},
                                                          {central_error, "central_error"},
                                                          {status, "status"}};
    for (const auto& [array, name] : arrays) require_pointer(array, name);
  }
};

/// The contacts of ehd_films. The first reads the lubricant; the others have the same.
std::vector<Problem> problems_of(const FilmArrays& arrays, const char* lubricant) {
  const auto at = [&](std::size_t i) { return MoesGroups{.M = arrays.M[i], .L = arrays.L[i]}; };
  const ContactCase first = moes_contact(at(0), lubricant);
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < arrays.n; ++i) {
    require_in(fmt::format("M[{}]", i).c_str(), arrays.M[i], range_of("moes.M"));
    require_in(fmt::format("L[{}]", i).c_str(), arrays.L[i], range_of("moes.L"));
    try {
      problems.push_back(nondimensionalise(at(i), *first.lubricant, *first.inlet).problem);
    } catch (const StatementError& error) {
      throw BadArgument(fmt::format("contact {}: {}: {}", i, error.key(), error.what()));
    }
    problems.back().wanted = {Quantity::film_minimum, Quantity::film_central};
  }
  return problems;
}

void put_film(const Solution& solution, Quantity quantity, double& value, double& error) {
  const auto at = solution.observables.find(quantity);
  const bool known = solution.record.status != StopReason::diverged && at != solution.observables.end();
  value = known ? at->second.value : std::nan("");
  error = known ? at->second.error.value_or(std::nan("")) : std::nan("");
}

int word_of(StopReason reason) {
  switch (reason) {
    case StopReason::converged: return EHD_CONVERGED;
    case StopReason::tolerance_not_met: return EHD_TOLERANCE_NOT_MET;
    case StopReason::under_resolved: return EHD_UNDER_RESOLVED;
    case StopReason::limit_reached: return EHD_LIMIT_REACHED;
    case StopReason::diverged: return EHD_DIVERGED;
  }
  return EHD_DIVERGED;
}

struct FilmsDone {
  std::size_t converged = 0;
  bool cancelled = false;
};

FilmsDone solve_films(const FilmArrays& to, const std::vector<Problem>& problems, double tolerance, unsigned threads) {
  Progress progress;
  std::atomic<std::size_t> done = 0, converged = 0;
  in_threads(problems.size(), threads, [&](std::size_t i) {
    Solution solution;
    solution.record.status = StopReason::limit_reached;
    if (!progress.cancelled()) {
      const Interruptible scope([&progress] { return progress.cancelled(); });
      solution = default_solver().solve(problems[i], {.tolerance = tolerance});
    }
    put_film(solution, Quantity::film_minimum, to.minimum[i], to.minimum_error[i]);
    put_film(solution, Quantity::film_central, to.central[i], to.central_error[i]);
    to.status[i] = word_of(solution.record.status);
    if (to.status[i] == EHD_CONVERGED) ++converged;
    progress.reached(static_cast<double>(++done) / static_cast<double>(problems.size()));
  });
  return {.converged = converged, .cancelled = progress.cancelled()};
}

}  // namespace

}  // namespace ehd::c

int ehd_films(size_t n, const double* M, const double* L, const char* lubricant_toml, double tolerance, int threads,
              double* minimum, double* minimum_error, double* central, double* central_error, int* status) {
  using namespace ehd::c;
  return guarded([&] {
    const FilmArrays arrays{n, M, L, minimum, minimum_error, central, central_error, status};
    arrays.require();
    require_tolerance(tolerance);
    if (threads < 0 || threads > most_threads)
      throw BadArgument(
          fmt::format("threads = {}: is out of range; allowed is 0 (one a core) to {}", threads, most_threads));
    const FilmsDone done =
        solve_films(arrays, problems_of(arrays, lubricant_toml), tolerance, static_cast<unsigned>(threads));
    if (done.converged == n) return EHD_OK;
    set_last_error(fmt::format("ehd: {}{} of {} contacts did not converge; their status says how",
                               done.cancelled ? fmt::format("{}; ", ehd::interrupted_reason) : "", n - done.converged,
                               n));
    return EHD_NOT_MET;
  });
}
