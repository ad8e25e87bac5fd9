// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/batch_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/timing.hpp"
#include "verification/studies/box.hpp"
#include "workflow/batch.hpp"

namespace ehd::verification {

std::vector<Problem> batch_problems(bool quick) {
  const Box box = quick ? Box{.M = {5, 20}, .L = {5, 10}} : Box{.M = round_loads(2, 500), .L = {2.5, 5, 10, 15}};
  std::vector<Problem> problems;
  for (const BoxContact& contact : contacts_of(box)) problems.push_back(contact.problem());
  return problems;
}

std::vector<BatchRow> run_batch(const BatchRequest& request) {
  std::vector<BatchRow> rows;
  for (const RegisteredSolver* solver : request.solvers) {
    const std::size_t first = rows.size();
    for (const unsigned threads : request.threads)
      rows.push_back({.solver = solver->name,
                      .tolerance = request.tolerance,
                      .problems = request.problems.size(),
                      .threads = threads,
                      .wall_s = {}});
    std::vector<Solution> expected;
    for (int round = 0; round < request.rounds; ++round) {
      for (std::size_t i = first; i < rows.size(); ++i) {
        BatchRow& row = rows[i];
        if (request.progress)
          request.progress(
              fmt::format("{} contacts by {}, {} threads, round {}", row.problems, row.solver, row.threads, round + 1));
        const Stopwatch watch;
        auto solutions = solve_all(*solver, request.problems,
                                   {.tolerance = request.tolerance, .time_limit_s = request.time_limit_s}, row.threads);
        row.wall_s.push_back(watch.seconds());
        row.converged = static_cast<std::size_t>(std::count_if(solutions.begin(), solutions.end(), [](const auto& one) {
          return one.record.status == StopReason::converged;
        }));
        if (expected.empty())
          expected = std::move(solutions);
        else
          row.same_results = row.same_results && std::equal(expected.begin(), expected.end(), solutions.begin(),
                                                            solutions.end(), identical);
      }
    }
    for (std::size_t i = first; i < rows.size(); ++i)
      rows[i].speed_up = median(rows[first].wall_s) / median(rows[i].wall_s);
  }
  return rows;
}

Json to_json(const std::vector<BatchRow>& rows) {
  Json list = Json::array();
  for (const BatchRow& row : rows) {
    list.push_back({{"solver", row.solver},
                    {"tolerance", row.tolerance},
                    {"problems", row.problems},
                    {"converged", row.converged},
                    {"threads", row.threads},
                    {"wall_s", median(row.wall_s)},
                    {"rounds", row.wall_s.size()},
                    {"speed_up", row.speed_up},
                    {"same_results", row.same_results}});
  }
  return list;
}

std::string human_table(const std::vector<BatchRow>& rows) {
  std::vector<std::vector<std::string>> table{
      {"solver", "results", "tolerance", "contacts", "converged", "threads", "time [s]", "contacts/s", "speed-up"}};
  for (const BatchRow& row : rows) {
    const double seconds = median(row.wall_s);
    table.push_back({row.solver, row.same_results ? "the same" : "DIFFER", plain(row.tolerance),
                     std::to_string(row.problems), std::to_string(row.converged), std::to_string(row.threads),
                     plain(seconds, 3), plain(static_cast<double>(row.problems) / seconds, 3), plain(row.speed_up, 3)});
  }
  return "Many contacts, one solve a thread\n" + aligned_in_parts(table, 2, "  ") + "\n";
}

}  // namespace ehd::verification
