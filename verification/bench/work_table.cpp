// SPDX-License-Identifier: GPL-3.0-or-later
// The work-precision benchmark as people read it on a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "contact/text.hpp"
#include "io/duration.hpp"
#include "io/tables.hpp"
#include "verification/bench/csv.hpp"
#include "verification/bench/work_precision.hpp"

namespace ehd::verification {

namespace {

/// Below this share of a core, other processes took time and the measured times are too long.
constexpr double undisturbed_share = 0.9;

std::string crossover_text(const Crossover& at, const ComparedSolvers& pair) {
  const std::string &tight = at.rises ? pair.over : pair.solver, &loose = at.rises ? pair.solver : pair.over;
  return fmt::format("{} is ahead down to {}, {} from {}", loose, plain(at.looser), tight, plain(at.tighter));
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

std::string truths_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{{"case", "status", "asked", "H_min", "H_cen", "pressure L2 to",
                                               "H_min from digits", "H_cen from digits", "time [s]"}};
  for (const Truth& truth : result.truths) {
    if (!truth.status) {
      table.push_back(
          {truth.case_id, "no truth", plain(truth.tolerance), "-", "-", "-", "-", "-", plain(truth.wall_s, 3)});
      continue;
    }
    const double pressure = truth.error[static_cast<std::size_t>(Judged::pressure)];
    table.push_back({truth.case_id, std::string(to_string(*truth.status)), plain(truth.tolerance),
                     with_error(truth.value[0], truth.error[0]), with_error(truth.value[1], truth.error[1]),
                     pressure > 0 ? plain(pressure, 2) : "-", dash(truth.from_digits[0], 2),
                     dash(truth.from_digits[1], 2), plain(truth.wall_s, 3)});
  }
  return fmt::format("The truths: {}, with the errors that it states\n{}", certified_solver().name,
                     aligned_in_parts(table, 2, "  "));
}

std::string rows_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{{"case", "solver", "asked", "status", "time [ms]", "solves", "work units",
                                               "intervals", "H_min reported", "achieved", "H_cen reported", "achieved",
                                               "P achieved"}};
  for (const WorkRow& row : result.rows) {
    std::vector<std::string> cells{row.case_id, row.setting.solver, row.setting.text(),
                                   row.status ? std::string(to_string(*row.status)) : "not run"};
    cells.push_back(row.wall_s.empty() ? "-" : milliseconds(median(row.wall_s)));
    cells.push_back(std::to_string(row.wall_s.size()));
    cells.push_back(row.cost.nodes > 0 ? plain(row.cost.work_units, 3) : "-");
    cells.push_back(row.cost.nodes > 0 ? std::to_string(row.cost.nodes) : "-");
    for (const Judged judged : all_judged) {
      const AchievedError& error = row.error(judged);
      if (judged != Judged::pressure) cells.push_back(dash(error.reported, 2));
      cells.push_back(error.words());
    }
    table.push_back(cells);
  }
  constexpr double percent = 100;
  return fmt::format("Every run: time is the median of cold solves; this process had {} % of a core{}\n{}",
                     plain(percent * result.cpu_share, 3),
                     result.cpu_share < undisturbed_share ? ", so that times are too long: measure again" : "",
                     aligned_in_parts(table, 4, "  "));
}

std::string crossovers_list(const WorkPrecisionResult& result, Judged judged) {
  std::string text;
  for (const Truth& truth : result.truths) {
    for (const ComparedSolvers& pair : compared_solvers()) {
      const auto by_level = ratios(result.rows, truth.case_id, pair.solver, pair.over, judged, error_levels(judged));
      if (const auto at = crossover(by_level))
        text += fmt::format("  {}: {}\n", truth.case_id, crossover_text(*at, pair));
    }
  }
  return text.empty() ? "" : "\n  crossovers\n" + text;
}

/// Ratios of times over all cases: their geometric mean and range, by pair of solvers and error level.
std::string means_table(const WorkPrecisionResult& result, Judged judged) {
  std::map<std::string, std::map<double, std::vector<double>, std::greater<>>> by_pair;
  for (const Truth& truth : result.truths) {
    for (const ComparedSolvers& pair : compared_solvers()) {
      for (const Ratio& at : ratios(result.rows, truth.case_id, pair.solver, pair.over, judged, error_levels(judged)))
        by_pair[pair.name()][at.level].push_back(at.value);
    }
  }
  std::vector<std::vector<std::string>> table{{"ratio", "error", "cases", "geometric mean", "smallest", "largest"}};
  for (const auto& [name, by_level] : by_pair) {
    for (const auto& [level, values] : by_level) {
      const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
      table.push_back({name, plain(level), std::to_string(values.size()), plain(geometric_mean(values), 3),
                       plain(*smallest, 3), plain(*largest, 3)});
    }
  }
  return table.size() > 1 ? "\n" + aligned_in_parts(table, 1, "  ") : "";
}

std::string equal_error_table(const WorkPrecisionResult& result, Judged judged) {
  std::vector<std::vector<std::string>> table{{"case", "error"}};
  std::vector<std::string>& header = table.front();
  header.insert(header.end(), result.solvers.begin(), result.solvers.end());
  for (const ComparedSolvers& pair : compared_solvers()) header.push_back(pair.name());
  for (const Truth& truth : result.truths) {
    for (const double level : error_levels(judged)) {
      std::vector<std::string> cells{truth.case_id, plain(level)};
      for (const auto& solver : result.solvers) {
        const WorkRow* best = quickest(result.rows, truth.case_id, solver, judged, level);
        cells.push_back(best ? fmt::format("{} ({})", milliseconds(median(best->wall_s)), best->setting.text()) : "-");
      }
      for (const ComparedSolvers& pair : compared_solvers()) {
        const auto at = ratios(result.rows, truth.case_id, pair.solver, pair.over, judged, {level});
        cells.push_back(at.empty() ? "-" : plain(at.front().value, 3));
      }
      table.push_back(cells);
    }
  }
  return fmt::format("Best time [ms] at an achieved error in {} of at most (and what was asked for)\n",
                     to_string(judged)) +
         aligned_in_parts(table, 1, "  ") + means_table(result, judged) + crossovers_list(result, judged);
}

std::string coverage_table(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table{
      {"solver", "quantity", "covered", "missed", "undecided", "reported/achieved, median", "smallest"}};
  for (const auto& solver : result.solvers) {
    for (const Judged judged : {Judged::film_minimum, Judged::film_central}) {
      const Coverage found = coverage(result.rows, solver, judged);
      table.push_back({solver, std::string(to_string(judged)), std::to_string(found.yes), std::to_string(found.no),
                       std::to_string(found.undecided), dash(found.median_excess, 3), dash(found.worst_excess, 3)});
    }
  }
  return "Errors reported against achieved, of every run that reports one\n" + aligned_in_parts(table, 2, "  ");
}

/// Neighbouring rows of one solver with the same status and reason share a line.
std::string failures_list(const WorkPrecisionResult& result) {
  std::vector<std::pair<std::string, std::string>> lines;  // what, and how it ended
  std::string last;
  for (const WorkRow& row : result.rows) {
    if (row.converged() && row.reason.empty()) continue;
    const std::string who = row.case_id + ", " + row.setting.solver;
    std::string how = row.status ? std::string(to_string(*row.status)) : "";
    if (!row.reason.empty()) how += (how.empty() ? "" : "; ") + row.reason;
    if (lines.empty() || last != who + how) lines.emplace_back(who, how);
    lines.back().first += ", " + row.setting.text();
    last = who + how;
  }
  for (const Truth& truth : result.truths) {
    if (!truth.reason.empty()) lines.emplace_back(truth.case_id + ", the truth", truth.reason);
  }
  if (lines.empty()) return "";
  std::string text = "What did not converge, was not run or not judged, and why\n";
  for (const auto& [what, how] : lines) text += fmt::format("  {}: {}\n", what, how);
  return text + "\n";
}

std::string missed_list(const WorkPrecisionResult& result) {
  std::vector<std::vector<std::string>> table;
  for (const WorkRow& row : result.rows) {
    for (const Judged judged : all_judged) {
      const AchievedError& error = row.error(judged);
      if (covered(error) != Covered::no) continue;
      table.push_back({row.case_id, row.setting.solver, row.setting.text(), std::string(to_string(judged)),
                       "reported " + plain(*error.reported, 3), "achieved " + plain(*error.achieved, 3)});
    }
  }
  constexpr std::size_t columns = 6;
  return table.empty() ? "" : "\n  missed\n" + aligned_in_parts(table, columns, "  ");
}

}  // namespace

std::string human_table(const WorkPrecisionResult& result) {
  std::string text = fmt::format("{}\n{}\n{}", truths_table(result), rows_table(result), failures_list(result));
  for (const Judged judged : {Judged::film_central, Judged::film_minimum, Judged::pressure})
    text += equal_error_table(result, judged) + "\n";
  return fmt::format("{}{}{}\n", text, coverage_table(result), missed_list(result));
}

}  // namespace ehd::verification
