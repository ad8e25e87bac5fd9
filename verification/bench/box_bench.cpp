// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/box_bench.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/film_formulas.hpp"
#include "contact/text.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/studies/oils.hpp"
#include "workflow/batch.hpp"

namespace ehd::verification {

namespace {

constexpr Quantity films[] = {Quantity::film_minimum, Quantity::film_central};

const Reading* reading_of(const Solution& solution, Quantity quantity) {
  const auto at = solution.observables.find(quantity);
  return at == solution.observables.end() ? nullptr : &at->second;
}

std::string cell(const std::optional<double>& value) { return value ? plain(*value, 2) : "-"; }

}  // namespace

std::vector<BoxContact> box_contacts(bool quick) {
  const std::vector<double> loads =
      quick ? std::vector<double>{0.5, 20, 1000}
            : std::vector<double>{0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};
  const std::vector<double> moduli =
      quick ? std::vector<double>{2.5, 10} : std::vector<double>{0, 1, 2.5, 5, 10, 15, 20, 30};
  std::vector<BoxContact> contacts;
  for (const bool flooded : {false, true}) {
    for (const double M : loads) {
      if (!flooded && M < 0.5) continue;
      for (const double L : moduli) {
        const double film = moes_film_formula({.M = M, .L = L}) / moes_film_per_hertz_film(M);
        const double inlet = -std::max(4.0, 4 * std::sqrt(2 * film));
        contacts.push_back(
            {.M = M,
             .L = L,
             .flooded = flooded,
             .problem = problem_at({M, L}, true, flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{inlet}})});
      }
    }
  }
  return contacts;
}

std::string BoxSetting::text() const {
  return tolerance ? plain(*tolerance) : "n = " + std::to_string(nodes.value_or(0));
}

std::vector<BoxSetting> box_settings() {
  return {{.tolerance = 1e-3, .nodes = {}},
          {.tolerance = 1e-5, .nodes = {}},
          {.tolerance = {}, .nodes = 512},
          {.tolerance = {}, .nodes = 1024}};
}

std::vector<BoxRow> run_box(const BoxRequest& request) {
  std::vector<Solution> truths;
  if (request.truth) {
    if (request.progress)
      request.progress(std::to_string(request.contacts.size()) + " truths by " + request.truth->name);
    std::vector<Problem> problems;
    for (const BoxContact& contact : request.contacts) problems.push_back(contact.problem);
    truths = solve_all(*request.truth, problems,
                       {.tolerance = request.truth_tolerance, .time_limit_s = request.time_limit_s}, request.threads);
  }
  std::vector<BoxRow> rows;
  for (const RegisteredSolver* solver : request.solvers) {
    for (const BoxSetting& setting : request.settings) {
      if (request.progress) request.progress("box by " + solver->name + " at " + setting.text());
      for (std::size_t i = 0; i < request.contacts.size(); ++i) {
        const BoxContact& contact = request.contacts[i];
        BoxRow row{.solver = solver->name,
                   .setting = setting,
                   .M = contact.M,
                   .L = contact.L,
                   .flooded = contact.flooded,
                   .status = {},
                   .wall_s = {},
                   .reported = {},
                   .achieved = {},
                   .truth_error = {}};
        const Request asked{.tolerance = setting.tolerance,
                            .nodes = setting.nodes,
                            .iteration_share = setting.nodes ? std::optional(0.5) : std::nullopt,
                            .time_limit_s = request.time_limit_s};
        Solution solution;
        do {
          solution = solver->solve(contact.problem, asked);
          row.wall_s.push_back(solution.record.cost.wall_s);
        } while (!request.repetition.satisfied_by(row.wall_s));
        row.status = to_string(solution.record.status);
        for (std::size_t k = 0; k < 2; ++k) {
          const Reading* const reading = reading_of(solution, films[k]);
          if (!reading) continue;
          row.reported[k] = reading->error;
          const Reading* const truth = truths.empty() ? nullptr : reading_of(truths[i], films[k]);
          if (!truth || !truth->error) continue;
          row.truth_error[k] = truth->error;
          row.achieved[k] = std::abs(reading->value - truth->value) / std::abs(truth->value);
        }
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

Json to_json(const std::vector<BoxRow>& rows) {
  Json list = Json::array();
  for (const BoxRow& row : rows) {
    Json json{{"solver", row.solver},
              {"M", row.M},
              {"L", row.L},
              {"inlet", row.flooded ? "flooded" : "cut"},
              {"status", row.status},
              {"wall_s", median(row.wall_s)},
              {"solves", row.wall_s.size()}};
    if (row.setting.tolerance) json["tolerance"] = *row.setting.tolerance;
    if (row.setting.nodes) json["nodes"] = *row.setting.nodes;
    for (std::size_t k = 0; k < 2; ++k) {
      Json& film = json[std::string(to_string(films[k]))];
      film = Json::object();
      put(film, "reported", row.reported[k]);
      put(film, "achieved", row.achieved[k]);
      put(film, "truth_error", row.truth_error[k]);
    }
    list.push_back(json);
  }
  return list;
}

std::string box_csv(const std::vector<BoxRow>& rows) {
  std::string text =
      "solver,tolerance,nodes,M,L,inlet,status,wall_s,H_min_reported,H_min_achieved,H_min_truth_error,H_cen_reported,"
      "H_cen_achieved,H_cen_truth_error\n";
  const auto number = [](const std::optional<double>& value) { return value ? plain(*value, 6) : std::string(); };
  for (const BoxRow& row : rows) {
    text += row.solver + "," + number(row.setting.tolerance) + "," +
            (row.setting.nodes ? std::to_string(*row.setting.nodes) : "") + "," + plain(row.M) + "," + plain(row.L) +
            "," + (row.flooded ? "flooded" : "cut") + "," + row.status + "," + plain(median(row.wall_s), 6);
    for (std::size_t k = 0; k < 2; ++k)
      text += "," + number(row.reported[k]) + "," + number(row.achieved[k]) + "," + number(row.truth_error[k]);
    text += "\n";
  }
  return text;
}

std::string human_table(const std::vector<BoxRow>& rows) {
  std::vector<std::vector<std::string>> table{{"solver", "asked", "inlet", "converged", "median [ms]", "slowest [ms]",
                                               "largest error H_min", "at", "H_min, L <= 15", "H_cen", "at",
                                               "within bars"}};
  for (auto first = rows.begin(); first != rows.end();) {
    const auto same = [&](const BoxRow& row) {
      return row.solver == first->solver && row.setting.text() == first->setting.text() &&
             row.flooded == first->flooded;
    };
    const auto last = std::find_if_not(first, rows.end(), same);
    std::vector<double> times;
    std::optional<double> largest[2], mild;
    std::string place[2] = {"-", "-"};
    long converged = 0, judged = 0, covered = 0;
    for (auto row = first; row != last; ++row) {
      converged += row->status == to_string(StopReason::converged) ? 1 : 0;
      times.push_back(1e3 * median(row->wall_s));
      for (std::size_t k = 0; k < 2; ++k) {
        // An error below the truth's own says nothing.
        if (!row->achieved[k] || !row->reported[k] || !(*row->truth_error[k] < 0.3 * *row->reported[k])) continue;
        ++judged;
        covered += *row->achieved[k] <= *row->reported[k] + *row->truth_error[k] ? 1 : 0;
        if (!largest[k] || *row->achieved[k] > *largest[k]) {
          largest[k] = row->achieved[k];
          place[k] = "(" + plain(row->M) + ", " + plain(row->L) + ")";
        }
        if (k == 0 && row->L <= 15) mild = std::max(mild.value_or(0), *row->achieved[k]);
      }
    }
    table.push_back({first->solver, first->setting.text(), first->flooded ? "flooded" : "cut",
                     std::to_string(converged) + " of " + std::to_string(last - first), plain(median(times), 3),
                     plain(*std::max_element(times.begin(), times.end()), 3), cell(largest[0]), place[0], cell(mild),
                     cell(largest[1]), place[1], std::to_string(covered) + " of " + std::to_string(judged)});
    first = last;
  }
  return "The box, Roelands compressible: M of 0.5 .. 5000 (flooded from 0.05), L of 0 .. 30\n" +
         aligned(table, 3, "  ") + "\n";
}

}  // namespace ehd::verification
