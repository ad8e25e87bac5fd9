// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/first_solve.hpp"

#include <fmt/format.h>

#include <ctime>
#include <new>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/child.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "verification/studies/box.hpp"

namespace ehd::verification {

namespace {

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// In the child, which has no other thread.
Json measured_first(const RegisteredSolver& solver, const Problem& problem, const FirstSolveRequest& request) {
  const Request asked{.tolerance = request.tolerance, .time_limit_s = request.time_limit_s};
  Json json;
  std::vector<double> later_s;
  double begin = processor_s();
  const Solution first = solver.solve(problem, asked);
  json["first_s"] = processor_s() - begin;
  json["planning_s"] = first.record.cost.planning_s;
  do {
    begin = processor_s();
    (void)solver.solve(problem, asked);
    later_s.push_back(processor_s() - begin);
  } while (!request.repetition.satisfied_by(later_s));
  json["later_s"] = median(later_s);
  json["c_s"] = convolution_s(unit_intervals, request.repetition);
  return json;
}

FirstSolveRow first_solve(const RegisteredSolver& solver, const MoesGroups& contact, const FirstSolveRequest& request) {
  FirstSolveRow row{.solver = solver.name, .contact = contact, .tolerance = request.tolerance, .why = {}};
  const Problem problem = problem_at(contact, true, Flooded{});
  ChildEnd end;
  try {
    end = in_child([&] { return measured_first(solver, problem, request).dump(); });
  } catch (const Refused& refused) {
    end.why = refused.what();
  } catch (const std::bad_alloc&) {
    end.why = memory_is_exhausted;
  }
  if (!end.text) {
    row.why = "not measured: " + end.why;
    return row;
  }
  const Json json = Json::parse(*end.text);
  row.first_s = json["first_s"];
  row.planning_s = json["planning_s"];
  row.later_s = json["later_s"];
  row.c_s = json["c_s"];
  return row;
}

}  // namespace

std::vector<FirstSolveRow> run_first_solves(const FirstSolveRequest& request) {
  std::vector<FirstSolveRow> rows;
  for (const RegisteredSolver* solver : request.solvers) {
    if (request.progress) request.progress("first solves by " + solver->name);
    for (const MoesGroups& contact : request.contacts) rows.push_back(first_solve(*solver, contact, request));
  }
  return rows;
}

Json to_json(const std::vector<FirstSolveRow>& rows) {
  Json list = Json::array();
  for (const FirstSolveRow& row : rows) {
    Json json{{"solver", row.solver}, {"M", row.contact.M}, {"L", row.contact.L}, {"tolerance", row.tolerance}};
    if (row.why.empty()) {
      json.update(
          {{"first_s", row.first_s}, {"planning_s", row.planning_s}, {"later_s", row.later_s}, {"c_s", row.c_s}});
    } else {
      json["reason"] = row.why;
    }
    list.push_back(json);
  }
  return list;
}

std::string human_table(const std::vector<FirstSolveRow>& rows) {
  constexpr double milli = 1e3;
  std::vector<std::vector<std::string>> table{
      {"solver", "M", "L", "later [ms]", "later [c]", "first [ms]", "first [c]", "more [c]", "planning [c]"}};
  for (const FirstSolveRow& row : rows) {
    std::vector<std::string> cells{row.solver, plain(row.contact.M), plain(row.contact.L)};
    const auto in_c = [&](double s) { return plain(s / row.c_s, 3); };
    if (row.why.empty()) {
      cells.insert(cells.end(), {plain(milli * row.later_s, 3), in_c(row.later_s), plain(milli * row.first_s, 3),
                                 in_c(row.first_s), in_c(row.first_s - row.later_s), in_c(row.planning_s)});
    } else {
      cells.push_back(row.why);
    }
    table.push_back(cells);
  }
  return fmt::format(
      "The first solve of a process and a later one, processor time; c: a padded convolution of {} intervals\n{}\n",
      unit_intervals, aligned_in_parts(table, 1, "  "));
}

}  // namespace ehd::verification
