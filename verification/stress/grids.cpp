// SPDX-License-Identifier: GPL-3.0-or-later
// (f) From 2^4 to 2^20 intervals, odd and prime numbers among them: under-resolved on coarse grids, then errors that
// fall with the order, then a floor of rounding as predicted, and no drift above the floor.
//
// The floor on n equal cells. A film is H_0 + X^2/2 - (l/pi) (K P + ln l S). Its terms have the size 1 + X_a^2/2, and
// an FFT of 2n points sums them with an error of 4 eps log2 2n. Relative to the smallest film that is
//   r_1 = 4 eps log2(2n) (1 + X_a^2/2)/H_min.
// The weights are second differences of u^2 ln u only up to u = 24: they lose at most 24^2 eps, on 24 cells of size
// 1/n, which does not grow with n. In Reynolds' equation P is known to eps P, so that the gradient on a cell of h = l/n
// errs by eps P n/l. The residual, relative to the exit's flux, has the noise
//   r_2 = eps (1 + c n), c = max (rho H^3/(eta lambda)) P/(l rho_n H_n).
// Newton stops at max(1e-11, 8 r_2) (fast/newton_krylov.cpp; reference: 1e-12 + 4 r_2), and a residual changes a film
// by no more than itself (0.24 at most: fast/judgement.hpp). The floor is r_1 + max(1e-11, 8 r_2): flat to some 1e5
// cells, then ~ n. It is allowed beside the line of the order, but not beside a stated error, which contains the
// rounding.
//
// A stated error holds, is missed or is undecided by judged_error(). Undecided needs a stated error below ten times
// truth_tolerance, since the truth has to be as good as asked.
//
// How a solve may end. Every solver: converged only where the stated error of both films is below 10 %. Equal cells:
// under-resolved below 0.75 cells in the inlet zone; above 3 converged, unless an error of 10 % or more is stated;
// either between them. Other solvers: converged, or under-resolved or tolerance-not-met with films and errors; on fewer
// than 64 intervals also under-resolved without a film. Every solve has a result.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "contact/observables.hpp"
#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/solver_lists.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

constexpr double inlet = usual_cut, truth_tolerance = 1e-10, truth_time_limit_s = 120, time_limit_s = 60;
constexpr double iterated_to = 1e-11;
/// Cells in the inlet zone of the true film. Solvers say "under-resolved" below 1.5 cells in the inlet zone of their
/// own film, which errs by up to 40 % there. Half or twice as many cells of the true zone leave no doubt.
constexpr double surely_blind = 0.75, surely_seeing = 3;
/// On fewer intervals than this a solver may find no film.
constexpr int fewest_with_a_film = 64;
/// By what factor an error may exceed the line of the declared order through the first grid that resolves the zone. The
/// order is declared for smooth solutions. Equal cells do not resolve a spike: beside one the error of H_min only has
/// to be smaller on a grid twice as fine.
constexpr double above_the_line = 4, declared_order = 2;

bool has_bars(const GridRow& row) { return row.error[0] && row.error[1] && row.stated[0] && row.stated[1]; }

/// The verdict on a stated error by judged_error(). Absent: undecided. Inconclusive: one of the numbers is not finite.
std::optional<Verdict> judge_bar(double error, double stated, double truth_error) {
  if (!std::isfinite(error) || !std::isfinite(stated) || !std::isfinite(truth_error)) return Verdict::inconclusive;
  switch (judged_error({error, stated, truth_error})) {
    case StatedError::holds: return Verdict::pass;
    case StatedError::missed: return Verdict::fail;
    case StatedError::undecided: break;
  }
  return std::nullopt;
}

struct Truth {
  Ended films;
  double exit = 0;
  double by_cell = 0;  ///< c above
  bool spike = false;
};

Truth truth_of(const Problem& problem) {
  const Solution solution =
      certified_solver().solve(problem, {.tolerance = truth_tolerance, .time_limit_s = truth_time_limit_s});
  Truth truth{.films = ended(solution)};
  truth.spike = observe(solution.fields, {Quantity::pressure_spike}).contains(Quantity::pressure_spike);
  const Fields& f = solution.fields;
  const auto last = f.X.size() - 1;
  if (last < 1) return truth;
  truth.exit = f.X[last];
  const Array mobility = f.density * f.H.cube() * (-f.log_viscosity).exp() / problem.groups.lambda;
  truth.by_cell = (mobility * f.P).maxCoeff() / ((truth.exit - inlet) * f.density[last] * f.H[last]);
  return truth;
}

struct Task {
  std::size_t contact;
  const RegisteredSolver* solver;
  int nodes;
};

/// Powers of two from 2^4, the fewest that the program accepts, every second one of large grids, and odd numbers among
/// them, of which 97 and 1009 are prime.
std::set<int> sizes_of(const RegisteredSolver& solver, bool quick) {
  constexpr int sparse_from = 1 << 12;
  const bool fft = solver.uses_fft, equal_cells = on_equal_cells(solver);
  // The certified solver needs hundreds of nodes for its last digits: a thousand would resolve nothing more.
  const int far = quick              ? (fft ? 1 << 12 : 1 << 8)
                  : fft              ? (equal_cells ? 1 << 20 : 1 << 16)
                  : solver.certified ? 1 << 9
                                     : 1 << 11;
  std::set<int> sizes;
  for (int n = 1 << 4; n <= far; n *= (fft && n >= sparse_from ? 4 : 2)) sizes.insert(n);
  for (const int odd : {97, 255, 1009, 10007, 100003}) {
    if (odd <= far) sizes.insert(odd);
  }
  return sizes;
}

/// Every contact, solver and size; the expensive ones first, so that the threads end together.
std::vector<Task> tasks_of(std::size_t contacts, bool quick) {
  std::vector<Task> tasks;
  for (std::size_t c = 0; c < contacts; ++c) {
    for (const RegisteredSolver& solver : solvers()) {
      for (const int n : sizes_of(solver, quick)) tasks.push_back({c, &solver, n});
    }
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) {
    const auto cost = [](const Task& task) { return task.solver->uses_fft ? task.nodes / 100.0 : 1.0 * task.nodes; };
    return cost(a) > cost(b);
  });
  return tasks;
}

/// Cells in the inlet zone, and the floor of rounding: the head of this file.
void predict(const Truth& truth, GridRow& row) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double n = row.nodes, H = *truth.films.film[1];
  const double zone = std::pow(std::min(H, 1.0), 2.0 / 3) * std::max(1.0, std::sqrt(2 * H));
  row.cells = zone * n / (truth.exit - inlet);
  const double film = 4 * eps * std::log2(2.0 * n) * (1 + inlet * inlet / 2) / *truth.films.film[0];
  row.floor = film + std::max(iterated_to, 8 * eps * (1 + truth.by_cell * n));
}

GridRow row_of(const BoxContact& contact, const Truth& truth, const RegisteredSolver& solver, int n) {
  GridRow row;
  row.solver = solver.name;
  row.contact = contact.name();
  row.nodes = n;
  row.spike = truth.spike;
  if (solver.memory_bytes(n) > available_memory_bytes() / 2) {
    row.ran = false;
    row.why = "not run: it would not fit into memory";
    return row;
  }
  const Ended end = ended(solver.solve(contact.problem(), {.tolerance = {}, .nodes = n, .time_limit_s = time_limit_s}));
  row.status = end.status;
  row.why = end.finite ? end.reason : "a number is not finite";
  row.wall_s = end.wall_s;
  const bool known = truth.films.has_films();
  if (known && on_equal_cells(solver)) predict(truth, row);
  for (std::size_t k = 0; k < 2; ++k) {
    row.truth_error[k] = known ? *truth.films.error[k] : std::numeric_limits<double>::infinity();
    if (!known || !end.film[k]) continue;
    row.error[k] = end.finite ? std::abs(*end.film[k] / *truth.films.film[k] - 1) : std::nan("");
    row.stated[k] = end.error[k];
  }
  return row;
}

}  // namespace

std::vector<GridRow> run_grids(const Scope& scope) {
  std::vector<BoxContact> contacts =
      cut_contacts({{{5, 5}, true}, {{1000, 10}, true}, {{1, 0}, false}, {{20, 10}, true}});
  if (scope.quick) contacts.resize(2);
  std::vector<Truth> truths(contacts.size());
  scope.show(fmt::format("{} truths by {}", contacts.size(), certified_solver().name));
  in_threads(contacts.size(), scope.threads, [&](std::size_t i) { truths[i] = truth_of(contacts[i].problem()); });
  const std::vector<Task> tasks = tasks_of(contacts.size(), scope.quick);
  std::vector<GridRow> rows(tasks.size());
  scope.show(fmt::format("{} grids", tasks.size()));
  in_threads(tasks.size(), scope.threads, [&](std::size_t i) {
    const auto& [c, solver, n] = tasks[i];
    rows[i] = row_of(contacts[c], truths[c], *solver, n);
  });
  std::stable_sort(rows.begin(), rows.end(), [](const GridRow& a, const GridRow& b) {
    return std::tie(a.contact, a.solver, a.nodes) < std::tie(b.contact, b.solver, b.nodes);
  });
  return rows;
}

namespace {

struct Counts {
  long blind = 0, called = 0, covered = 0, stated = 0, undecided = 0;
  double lowest = std::numeric_limits<double>::infinity();
  int finest = 0;
};

std::string place_of(const GridRow& row) { return fmt::format("{}, {}, n = {}", row.contact, row.solver, row.nodes); }

std::vector<Cell> cells_of(const GridRow& row) {
  return {row.contact,
          row.solver,
          row.nodes,
          to_string(row.status),
          row.cells > 0 ? row.cells : std::nan(""),
          row.error[0],
          row.stated[0],
          row.error[1],
          row.stated[1],
          std::max(row.truth_error[0], row.truth_error[1]),
          row.floor > 0 ? row.floor : std::nan(""),
          row.wall_s};
}

/// How the solve ended: as the head of this file allows.
void judge_end(const GridRow& row, Counts& counts, Tally& tally) {
  const std::string where = place_of(row), status(to_string(row.status));
  const std::string end = fmt::format("{}: {} ({})", where, status, row.why);
  const bool converged = row.status == StopReason::converged, under_resolved = row.status == StopReason::under_resolved;
  const bool equal_cells = on_equal_cells(*find_solver(row.solver));
  const bool fine_enough =
      row.stated[0].value_or(1) < least_error_under_resolved && row.stated[1].value_or(1) < least_error_under_resolved;
  if (converged) tally.require(fine_enough, end + ", with a stated error of a film of 10 % or more, or none");
  if (!(std::max(row.truth_error[0], row.truth_error[1]) <= truth_tolerance) || (equal_cells && !(row.cells > 0)))
    tally.add(Verdict::inconclusive, where + ": the truth is not known to what was asked of it");
  if (out_of_time(row.status, row.wall_s, time_limit_s)) {
    tally.add(Verdict::inconclusive, end);
    return;
  }
  if (equal_cells) {
    tally.require(converged || under_resolved, end);
  } else {
    const bool missed = under_resolved || row.status == StopReason::tolerance_not_met;
    const bool too_few = under_resolved && row.nodes < fewest_with_a_film;
    tally.require(converged || too_few || (missed && has_bars(row)),
                  fmt::format("{}, {} films and errors", end, has_bars(row) ? "with" : "without"));
  }
  if (row.cells > 0 && row.cells < surely_blind) {
    ++counts.blind;
    counts.called += under_resolved ? 1 : 0;
    tally.require(under_resolved,
                  fmt::format("{}: {} cells in the inlet zone, but {}", where, plain(row.cells, 2), status));
  }
  if (row.cells > surely_seeing) tally.require(converged || !fine_enough, end);
}

/// No drift: the error against the first grid of its kind that resolves the zone; beside a spike against every grid at
/// most half as fine.
void judge_fall(const std::vector<GridRow>& rows, const GridRow& row, std::size_t k, const std::string& film,
                Tally& tally) {
  if (row.cells <= surely_seeing) return;
  const auto of_its_kind = [&](const GridRow& one) {
    return one.contact == row.contact && one.solver == row.solver && one.cells > surely_seeing &&
           one.error[k].has_value();
  };
  const Tolerance floor = Tolerance::iteration(row.floor + row.truth_error[k]);
  if (row.spike && judged_films[k] == Quantity::film_minimum) {
    double coarser = std::numeric_limits<double>::infinity();
    for (const GridRow& one : rows) {
      if (of_its_kind(one) && 2 * one.nodes <= row.nodes) coarser = std::min(coarser, *one.error[k]);
    }
    if (std::isfinite(coarser))
      tally.add(*row.error[k], 0, Tolerance::discretisation(coarser, 1) + floor,
                film + " against grids at most half as fine");
    return;
  }
  const auto first = std::find_if(rows.begin(), rows.end(), of_its_kind);
  if (first == rows.end() || first->nodes >= row.nodes) return;
  const double line = *first->error[k] * std::pow(static_cast<double>(first->nodes) / row.nodes, declared_order);
  tally.add(*row.error[k], 0, Tolerance::discretisation(line, above_the_line) + floor,
            film + " against order 2 and the floor");
}

void judge_film(const std::vector<GridRow>& rows, const GridRow& row, std::size_t k, Counts& counts, Tally& tally) {
  const bool converged = row.status == StopReason::converged;
  if (!row.error[k]) {
    if (converged) tally.add(Verdict::inconclusive, place_of(row) + ": no film, or no truth");
    return;
  }
  const std::string film = fmt::format("{}, {}", place_of(row), to_string(judged_films[k]));
  if (!row.stated[k]) {
    tally.require(!converged, film + ": no stated error");
  } else if (const auto verdict = judge_bar(*row.error[k], *row.stated[k], row.truth_error[k])) {
    ++counts.stated;
    counts.covered += *verdict == Verdict::pass ? 1 : 0;
    tally.add(*verdict, fmt::format("{}: off by {} +- {}, and states {}", film, plain(*row.error[k], 3),
                                    plain(row.truth_error[k], 2), plain(*row.stated[k], 3)));
  } else {
    ++counts.undecided;
  }
  if (converged) counts.lowest = std::min(counts.lowest, *row.error[k]);
  judge_fall(rows, row, k, film, tally);
}

}  // namespace

Part judge_grids(const std::vector<GridRow>& rows) {
  Part part{
      .id = "f",
      .name = "grids",
      .question =
          "Do errors fall with the grid, down to the rounding that is predicted, and is a blind grid called blind?"};
  part.settings = {{"inlet", inlet}, {"truth_tolerance", truth_tolerance}, {"above_the_line", above_the_line}};
  part.tolerance = Tolerance::required(
      above_the_line,
      "times the line of second order through the first grid that sees the inlet zone, plus the predicted rounding");
  part.table.columns = columns_of(
      "contact | solver | intervals | status | cells [inlet zone] | H_min off | stated | H_cen off | stated | truth "
      "known to | floor [predicted] | time [s]");
  Tally tally;
  Counts counts;
  for (const GridRow& row : rows) {
    part.table.rows.push_back(cells_of(row));
    if (row.status == StopReason::converged) counts.finest = std::max(counts.finest, row.nodes);
    if (!row.ran) {
      tally.add(Verdict::inconclusive, place_of(row) + ": " + row.why);
      continue;
    }
    judge_end(row, counts, tally);
    for (std::size_t k = 0; k < 2; ++k) judge_film(rows, row, k, counts, tally);
  }
  tally.close(part);
  part.summary = fmt::format(
      "{} of {} blind grids called under-resolved; {} of {} stated errors hold ({} more where the truth cannot tell); "
      "errors fall to {}, up to {} intervals",
      counts.called, counts.blind, counts.covered, counts.stated, counts.undecided, plain(counts.lowest, 2),
      counts.finest);
  return part;
}

}  // namespace ehd::verification::stress
