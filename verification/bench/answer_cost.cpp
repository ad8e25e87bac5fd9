// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/answer_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/tables.hpp"
#include "verification/bench/box_bench.hpp"
#include "verification/bench/child.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

/// Materials are harder above it: the spike is narrow.
constexpr double stiff_above_L = 15;

struct Answer {
  const char* asked;
  FilmTolerances tolerance;
};
FilmTolerances central_alone(double tolerance) { return {std::nullopt, tolerance}; }

/// Every contact by itself, the median of its solves after the first.
AnswerCost cost_of(const Answer& answer, const std::string& of, const std::vector<BoxContact>& contacts,
                   const AnswerCostRequest& request) {
  if (request.progress) request.progress(std::string(answer.asked) + ", " + of);
  AnswerCost row{.asked = answer.asked, .of = of, .seconds = {}, .solves = static_cast<long>(contacts.size())};
  row.c_s = c_now();
  const Request asked{.tolerance = answer.tolerance, .time_limit_s = request.time_limit_s};
  for (const BoxContact& contact : contacts) {
    const Problem problem = contact.problem();
    const StopReason status = request.solver->solve(problem, asked).record.status;
    row.not_converged += status == StopReason::converged ? 0 : 1;
    std::vector<double> seconds;
    do {
      const double begin = thread_seconds();
      (void)request.solver->solve(problem, asked);
      seconds.push_back(thread_seconds() - begin);
    } while (!request.repetition.satisfied_by(seconds));
    row.seconds.push_back(median(seconds));
  }
  return row;
}

void add_box(const AnswerCostRequest& request, std::vector<AnswerCost>& rows) {
  std::vector<BoxContact> mild, stiff;
  for (const BoxContact& contact : bench_contacts(request.quick, {true, false}))
    (contact.moes.L <= stiff_above_L ? mild : stiff).push_back(contact);
  for (const Answer& answer : {Answer{"H_cen alone to 1e-6", central_alone(1e-6)}, Answer{"both films to 1e-3", 1e-3},
                               Answer{"both films to 1e-5", 1e-5}}) {
    rows.push_back(cost_of(answer, "box, L <= 15", mild, request));
    if (!stiff.empty()) rows.push_back(cost_of(answer, "box, L > 15", stiff, request));
  }
}

/// What a table, a sweep or a multibody code asks for.
std::vector<BoxContact> many_contacts(bool quick) {
  constexpr double lightest = 0.5, heaviest = 1000, largest_L = 20;
  const int loads = quick ? 4 : 20, materials = quick ? 3 : 11;
  Box box{.M = {}, .L = {}, .roelands = {true}, .flooded = {true}};
  for (int i = 0; i < loads; ++i) box.M.push_back(lightest * std::pow(heaviest / lightest, i / (loads - 1.0)));
  for (int i = 0; i < materials; ++i) box.L.push_back(largest_L * i / (materials - 1.0));
  return contacts_of(box);
}

AnswerCost cost_of_bearing(const AnswerCostRequest& request) {
  if (request.progress) request.progress("NA4908");
  AnswerCost row{.asked = "NA4908", .of = "3 clearances, usual laws", .seconds = {}};
  std::vector<Case> bearings;
  for (const char* id : {"na4908", "na4908-2.5um", "na4908-10um"}) bearings.push_back(read_case(find_case(id)));
  row.c_s = c_now();
  do {
    const double begin = thread_seconds();
    ContactMemory memory(default_solver().solve);
    row.not_converged = 0;
    for (const Case& bearing : bearings) {
      const auto laws = default_laws(std::get<BearingCase>(bearing.body));
      for (const BearingResult& result : run_bearing(bearing, {.laws = laws}, memory))
        row.not_converged += result.status == StopReason::converged ? 0 : 1;
    }
    row.seconds.push_back(thread_seconds() - begin);
    row.solves = memory.solves();
  } while (!request.repetition.satisfied_by(row.seconds));
  row.seconds = {median(row.seconds)};
  return row;
}

/// `ehd solve --M 20 --L 10` from its start to its end.
AnswerCost cost_of_process(const AnswerCostRequest& request) {
  if (request.progress) request.progress("whole processes");
  AnswerCost row{.asked = "whole process", .of = "ehd solve --M 20 --L 10", .seconds = {}, .solves = 1};
  row.c_s = c_now();
  std::vector<double> seconds;
  try {
    do {
      const ProgramEnd end = run_program(request.program, {"solve", "--M", "20", "--L", "10"});
      row.not_converged = end.exit_code == 0 ? 0 : 1;
      seconds.push_back(end.processor_s);
    } while (!request.repetition.satisfied_by(seconds));
    row.seconds = {median(seconds)};
  } catch (const Refused& refused) {
    row.why = std::string("not measured: ") + refused.what();
  }
  return row;
}

/// The value that `share` of the sorted values do not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  const auto count = static_cast<double>(sorted.size());
  const auto index = static_cast<std::size_t>(std::max(0.0, std::ceil(share * count) - 1));
  return sorted.at(std::min(index, sorted.size() - 1));
}

struct Spread {
  double mean, middle, most, slowest;
};
constexpr double nearly_all = 0.95;
Spread spread_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  double sum = 0;
  for (const double one : seconds) sum += one;
  return {.mean = sum / static_cast<double>(seconds.size()),
          .middle = median(seconds),
          .most = quantile(seconds, nearly_all),
          .slowest = seconds.back()};
}

}  // namespace

std::vector<AnswerCost> run_answer_costs(const AnswerCostRequest& request) {
  std::vector<AnswerCost> rows;
  add_box(request, rows);
  rows.push_back(cost_of({"both films to 1e-4", 1e-4}, "many contacts", many_contacts(request.quick), request));
  rows.push_back(cost_of_bearing(request));
  if (!request.program.empty()) rows.push_back(cost_of_process(request));
  return rows;
}

Json to_json(const std::vector<AnswerCost>& rows) {
  Json list = Json::array();
  for (const AnswerCost& row : rows) {
    if (!row.why.empty()) {
      list.push_back({{"asked", row.asked}, {"of", row.of}, {"reason", row.why}});
      continue;
    }
    const Spread spread = spread_of(row.seconds);
    list.push_back({{"asked", row.asked},
                    {"of", row.of},
                    {"number", row.seconds.size()},
                    {"not_converged", row.not_converged},
                    {"contact_solves", row.solves},
                    {"mean_s", spread.mean},
                    {"median_s", spread.middle},
                    {"of_95_percent_s", spread.most},
                    {"slowest_s", spread.slowest},
                    {"c_s", row.c_s}});
  }
  return list;
}

std::string human_table(const std::vector<AnswerCost>& rows) {
  constexpr double milli = 1e3, micro = 1e6;
  std::vector<std::vector<std::string>> table{{"asked", "of", "number", "not converged", "solves", "median [ms]",
                                               "median [c]", "mean [c]", "95 % [c]", "slowest [c]", "c [us]"}};
  for (const AnswerCost& row : rows) {
    if (!row.why.empty()) {
      table.push_back({row.asked, row.of, row.why});
      continue;
    }
    const Spread spread = spread_of(row.seconds);
    const auto in_c = [&](double s) { return plain(s / row.c_s, 3); };
    table.push_back({row.asked, row.of, std::to_string(row.seconds.size()), std::to_string(row.not_converged),
                     std::to_string(row.solves), plain(milli * spread.middle, 3), in_c(spread.middle),
                     in_c(spread.mean), in_c(spread.most), in_c(spread.slowest), plain(micro * row.c_s, 3)});
  }
  return fmt::format("What an answer costs, processor time; c: one padded convolution of {} intervals\n{}\n",
                     unit_intervals, aligned_in_parts(table, 2, "  "));
}

}  // namespace ehd::verification
