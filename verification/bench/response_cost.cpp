// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/response_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "io/tables.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

/// What a sweep asks for; a frequency costs the same wherever it stands among them.
const std::vector<double> swept_Omegas = {0.5, 1, 2, 5, 10};
/// Of the certified solver, which judges the errors of `fast`. Its own stated errors are far below this tolerance.
constexpr double certified_motion_tolerance = 1e-8;

std::vector<double> tolerances_of(const RegisteredSolver& solver, bool quick) {
  if (solver.certified) return {certified_motion_tolerance};
  return quick ? std::vector<double>{1e-4} : std::vector<double>{1e-3, 1e-4, 1e-5};
}

std::vector<BoxContact> contacts_in_motion(bool quick) {
  return contacts_of({.M = quick ? std::vector<double>{20} : std::vector<double>{20, 200},
                      .L = quick ? std::vector<double>{10} : std::vector<double>{2.5, 5, 10, 12, 15, 20},
                      .roelands = {true},
                      .flooded = {true}});
}

/// Median processor time; the first run counts only where it is long.
template <class Work>
double later_s(const Repetition& repetition, const Work& work) {
  std::vector<double> seconds;
  const double first = thread_seconds();
  work();
  if (const double once = thread_seconds() - first; once >= repetition.enough_s) return once;
  do {
    const double begin = thread_seconds();
    work();
    seconds.push_back(thread_seconds() - begin);
  } while (!repetition.satisfied_by(seconds));
  return median(seconds);
}

double largest_error(const Response& found, const Response& truth) {
  double worst = 0;
  for (std::size_t k = 0; k < found.frequencies.size(); ++k) {
    const auto exact = truth.frequencies[k].kappa;
    const double error = std::abs(found.frequencies[k].kappa - exact) / std::abs(exact);
    if (!(error <= worst)) worst = error;  // NaN stays
    if (std::isnan(worst)) break;
  }
  return worst;
}

FrequencyCost cost_of(const RegisteredSolver& solver, const BoxContact& contact, double tolerance,
                      const Response& truth, const ResponseCostRequest& request) {
  FrequencyCost row{.solver = solver.name, .contact = contact, .tolerance = tolerance};
  const Problem problem = contact.problem();
  ResponseRequest asked{.frequencies = swept_Omegas, .tolerance = tolerance, .time_limit_s = request.time_limit_s};
  ResponseRequest none = asked;
  none.frequencies.clear();
  row.c_s = c_now();
  row.steady_s = later_s(request.repetition, [&] {
    (void)solver.solve(problem, {.tolerance = tolerance, .time_limit_s = request.time_limit_s});
  });
  row.slow_s = later_s(request.repetition, [&] { (void)solver.respond(problem, none); });
  Response found;
  const double all_s = later_s(request.repetition, [&] { found = solver.respond(problem, asked); });
  row.frequency_s = (all_s - row.slow_s) / static_cast<double>(swept_Omegas.size());
  row.status = found.status;
  row.nodes = found.cost.nodes;
  for (const Stiffness& at : found.frequencies) row.stated = std::max(row.stated, at.error);
  if (!solver.certified) row.achieved = largest_error(found, truth);
  return row;
}

DynamicBearingCost cost_of_motion(const std::string& id, const ResponseCostRequest& request) {
  DynamicBearingCost row{.bearing = id};
  const Case bearing = read_case(find_case(id));
  row.c_s = c_now();
  const auto run = [&](std::vector<double> frequencies_Hz) {
    ContactMemory memory(default_solver().solve);
    const BearingRequest asked{.laws = {bearing::Law::ehd}, .frequencies_Hz = std::move(frequencies_Hz)};
    for (const BearingResult& result : run_bearing(bearing, asked, memory)) row.contact_solves = result.contact_solves;
    row.responses = memory.responses();
  };
  row.balance_s = later_s(request.repetition, [&] { run({}); });
  row.dynamic_s = later_s(request.repetition, [&] { run({0}); });
  return row;
}

}  // namespace

ResponseCost run_response_costs(const ResponseCostRequest& request) {
  ResponseCost cost;
  const auto show = [&](const std::string& what) {
    if (request.progress) request.progress(what);
  };
  for (const BoxContact& contact : contacts_in_motion(request.quick)) {
    show("response, " + contact.name());
    const Response truth = certified_solver().respond(
        contact.problem(),
        {.frequencies = swept_Omegas, .tolerance = certified_motion_tolerance, .time_limit_s = request.time_limit_s});
    for (const RegisteredSolver& solver : solvers()) {
      if (!solver.respond) continue;
      for (const double tolerance : tolerances_of(solver, request.quick))
        cost.frequencies.push_back(cost_of(solver, contact, tolerance, truth, request));
    }
  }
  for (const char* id : {"na4908", "na4908-2.5um", "na4908-10um"}) {
    show(std::string("response, ") + id);
    cost.bearings.push_back(cost_of_motion(id, request));
    if (request.quick) break;
  }
  return cost;
}

Json to_json(const ResponseCost& cost) {
  Json json{{"Omega", swept_Omegas}, {"frequencies", Json::array()}, {"bearings", Json::array()}};
  for (const FrequencyCost& row : cost.frequencies) {
    Json one{{"solver", row.solver},       {"M", row.contact.moes.M},         {"L", row.contact.moes.L},
             {"tolerance", row.tolerance}, {"status", to_string(row.status)}, {"steady_s", row.steady_s},
             {"slow_s", row.slow_s},       {"frequency_s", row.frequency_s},  {"c_s", row.c_s},
             {"nodes", row.nodes}};
    put(one, "stated", row.stated);
    put(one, "achieved", row.achieved);
    json["frequencies"].push_back(std::move(one));
  }
  for (const DynamicBearingCost& row : cost.bearings)
    json["bearings"].push_back({{"bearing", row.bearing},
                                {"balance_s", row.balance_s},
                                {"dynamic_s", row.dynamic_s},
                                {"contact_solves", row.contact_solves},
                                {"responses", row.responses},
                                {"c_s", row.c_s}});
  return json;
}

std::string human_table(const ResponseCost& cost) {
  constexpr double milli = 1e3;
  std::vector<std::vector<std::string>> rows{{"solver", "M", "L", "tolerance", "n", "steady [ms]", "slow [ms]",
                                              "a frequency [ms]", "[c]", "stated", "achieved", ""}};
  for (const FrequencyCost& row : cost.frequencies)
    rows.push_back({row.solver, plain(row.contact.moes.M), plain(row.contact.moes.L), plain(row.tolerance),
                    std::to_string(row.nodes), plain(milli * row.steady_s, 3), plain(milli * row.slow_s, 3),
                    plain(milli * row.frequency_s, 3), plain(row.frequency_s / row.c_s, 3), plain(row.stated, 2),
                    row.achieved ? plain(*row.achieved, 2) : "",
                    row.status == StopReason::converged ? "" : std::string(to_string(row.status))});
  std::vector<std::vector<std::string>> bearings{
      {"bearing, law ehd", "contact solves", "responses", "balance [ms]", "with motion [ms]", "ratio"}};
  for (const DynamicBearingCost& row : cost.bearings)
    bearings.push_back({row.bearing, std::to_string(row.contact_solves), std::to_string(row.responses),
                        plain(milli * row.balance_s, 3), plain(milli * row.dynamic_s, 3),
                        plain(row.dynamic_s / row.balance_s, 3)});
  return fmt::format(
      "What motion costs, processor time; slow: kappa_0 and kappa_1 with their steady states; a frequency: the mean of "
      "{} more, Omega = {} ... {}\n{}{}\n",
      swept_Omegas.size(), plain(swept_Omegas.front()), plain(swept_Omegas.back()), aligned_in_parts(rows, 1, "  "),
      aligned_in_parts(bearings, 1, "  "));
}

}  // namespace ehd::verification
