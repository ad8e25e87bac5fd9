// SPDX-License-Identifier: GPL-3.0-or-later
// (h) The same problem again: in this thread, in two threads, in another process. Every bit is compared, except times.
#include <fmt/format.h>

#include "verification/bench/child.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/bit_digest.hpp"
#include "verification/studies/solver_lists.hpp"
#include "workflow/batch.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

constexpr double time_limit_s = 60;
/// Above this M the dense solver on equal cells is not asked for a tolerance. Cells shrink with the 2/3 power of the
/// film: at (200, 7.5) there would be thousands, and each run would meet the time limit at another place.
constexpr double heaviest_on_equal_cells = 20;
constexpr double lightest_cut_M = 2;
constexpr double heaviest_quick_M = 10;

std::vector<Problem> contacts(bool quick) {
  std::vector<Problem> list;
  for (const auto& [M, L] : {std::pair{0.3, 4.0}, {5.0, 5.0}, {20.0, 10.0}, {200.0, 7.5}}) {
    for (const BoxContact& contact : contacts_of({.M = {M}, .L = {L}, .lightest_cut_M = lightest_cut_M})) {
      if (quick && (M > heaviest_quick_M || contact.flooded() == contact.roelands)) continue;
      list.push_back(contact.problem());
    }
  }
  return list;
}

/// A text of the solution's bits. Solutions that differ have other texts, except for collisions of 128 bits.
std::string fingerprint(const Solution& solution) {
  BitDigest digest;
  for (const auto& [quantity, reading] : solution.observables) {
    digest.add(static_cast<double>(quantity));
    digest.add(reading.value);
    digest.add(reading.place.value_or(0));
    digest.add(reading.error.value_or(0));
  }
  const Fields& fields = solution.fields;
  for (const Array* field : {&fields.X, &fields.P, &fields.H, &fields.density, &fields.log_viscosity, &fields.flux})
    for (const double value : *field) digest.add(value);
  digest.add(fields.offset);
  digest.add(static_cast<double>(solution.record.cost.newton_iterations));
  return digest.text();
}

}  // namespace

std::vector<RepeatRow> run_repeats(const Scope& scope) {
  std::vector<RepeatRow> rows;
  const auto all_problems = contacts(scope.quick);
  for (const RegisteredSolver& solver : solvers()) {
    struct Asked {
      std::string text;
      Request request;
    };
    const Asked all[] = {{"tolerance 1e-3", {.tolerance = 1e-3, .time_limit_s = time_limit_s}},
                         {"256 intervals", {.tolerance = {}, .nodes = 256, .time_limit_s = time_limit_s}}};
    for (const Asked& asked : all) {
      const std::string& text = asked.text;
      const Request& request = asked.request;
      std::vector<Problem> problems = all_problems;
      if (solver.dense() && on_equal_cells(solver) && request.tolerance.any())
        std::erase_if(problems, [](const Problem& problem) { return problem.groups.M > heaviest_on_equal_cells; });
      scope.show(solver.name + ", " + text);
      // The other process first, while this one has a single thread.
      const ChildEnd child = in_child([&] {
        std::string prints;
        for (const Solution& solution : solve_all(solver, problems, request, 1)) prints += fingerprint(solution) + "\n";
        return prints;
      });
      const auto first = solve_all(solver, problems, request, 1), again = solve_all(solver, problems, request, 1);
      if (in_threads(2, 2, [](std::size_t) {}) < 2) throw Refused("no second thread");
      const auto in_two = solve_all(solver, problems, request, 2);
      RepeatRow row{.solver = solver.name, .request = text, .contacts = static_cast<long>(problems.size())};
      std::string rest = child.text.value_or("");
      for (std::size_t i = 0; i < problems.size(); ++i) {
        row.converged += first[i].record.status == StopReason::converged ? 1 : 0;
        row.ended_by_time += first[i].record.status == StopReason::limit_reached ? 1 : 0;
        row.same_again += identical(first[i], again[i]) ? 1 : 0;
        row.same_in_two += identical(first[i], in_two[i]) ? 1 : 0;
        const auto line = rest.find('\n');
        if (line == std::string::npos) continue;
        row.same_in_process += rest.substr(0, line) == fingerprint(first[i]) ? 1 : 0;
        rest.erase(0, line + 1);
      }
      rows.push_back(row);
    }
  }
  return rows;
}

Part judge_repeats(const std::vector<RepeatRow>& rows) {
  Part part{.id = "h",
            .name = "repeatability",
            .question = "Does a solve give the same bits again, in one thread, two threads, another process?"};
  part.tolerance =
      Tolerance::required(0, "solutions that differ in any bit; plans are estimated, no solve knows of another");
  part.settings = {
      {"threads", {1, 2}}, {"time_limit_s", time_limit_s}, {"heaviest_on_equal_cells", heaviest_on_equal_cells}};
  part.table.columns =
      columns_of("solver | asked | contacts | converged | same again | same in 2 threads | same in a child");
  Tally tally;
  long solves = 0, same = 0;
  for (const RepeatRow& row : rows) {
    part.table.rows.push_back(
        {row.solver, row.request, row.contacts, row.converged, row.same_again, row.same_in_two, row.same_in_process});
    const std::string where = fmt::format("{}, {}: ", row.solver, row.request);
    if (row.contacts == 0 || row.converged == 0) {
      tally.add(Verdict::inconclusive, where + "no contact was solved");
      continue;
    }
    if (row.ended_by_time > 0) {
      tally.add(Verdict::inconclusive,
                fmt::format("{}{} solves were ended by a limit, which no two runs meet at the same place", where,
                            row.ended_by_time));
      continue;
    }
    const std::pair<const char*, long> counts[] = {
        {"again", row.same_again}, {"in two threads", row.same_in_two}, {"in another process", row.same_in_process}};
    for (const auto& [how, count] : counts) {
      tally.add(static_cast<double>(row.contacts - count), 0, *part.tolerance, where + "solutions that differ " + how);
      solves += row.contacts;
      same += count;
    }
  }
  tally.close(part);
  part.summary = fmt::format("{} of {} repeated solves are the same bit for bit, every solver", same, solves);
  return part;
}

}  // namespace ehd::verification::stress
