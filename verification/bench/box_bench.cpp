// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/box_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/text.hpp"
#include "io/tables.hpp"
#include "verification/bench/csv.hpp"
#include "workflow/batch.hpp"

namespace ehd::verification {

namespace {

constexpr double lightest_cut_M = 0.5;
/// X of a cut inlet: this many lengths sqrt(2 H_cen) before X = 0, and at least 4.
constexpr double cut_in_film_lengths = 4;
/// An achieved error counts where the truth is known to this share of the reported error.
constexpr double truth_share = 0.3;
/// Up to this L the largest error of H_min has a column of its own.
constexpr double mild_L = 15;

double cut_beyond_the_film(const MoesGroups& moes) {
  return -std::max(4.0, cut_in_film_lengths * std::sqrt(2 * expected_film(moes)));
}

std::string inlet_name(const BoxContact& contact) { return contact.flooded() ? "flooded" : "cut"; }

}  // namespace

std::vector<BoxContact> bench_contacts(bool quick, std::vector<bool> roelands) {
  return contacts_of({.M = quick ? std::vector<double>{0.5, 20, 1000} : round_loads(box_lightest_M, box_heaviest_M),
                      .L = quick ? std::vector<double>{2.5, 10} : std::vector<double>{0, 1, 2.5, 5, 10, 15, 20, 30},
                      .roelands = std::move(roelands),
                      .flooded = {false, true},
                      .lightest_cut_M = lightest_cut_M,
                      .cut = cut_beyond_the_film});
}

std::vector<Setting> box_settings() {
  return {{.tolerance = 1e-3}, {.tolerance = 1e-5}, {.nodes = 512}, {.nodes = 1024}};
}

namespace {

std::vector<Solution> truths_of(const BoxRequest& request) {
  if (!request.truth) return {};
  if (request.progress) request.progress(fmt::format("{} truths by {}", request.contacts.size(), request.truth->name));
  std::vector<Problem> problems;
  for (const BoxContact& contact : request.contacts) problems.push_back(contact.problem());
  return solve_all(*request.truth, problems,
                   {.tolerance = request.truth_tolerance, .time_limit_s = request.time_limit_s}, request.threads);
}

/// One contact solved as often as its time needs; `truth` may be absent.
BoxRow row_of(const RegisteredSolver& solver, const Setting& setting, const BoxContact& contact,
              const BoxRequest& request, const Solution* truth) {
  BoxRow row{.setting = setting, .contact = contact};
  const Problem problem = contact.problem();
  Solution solution;
  do {
    solution = solver.solve(problem, setting.request(request.time_limit_s));
    row.wall_s.push_back(solution.record.cost.wall_s);
  } while (!request.repetition.satisfied_by(row.wall_s));
  row.status = to_string(solution.record.status);
  for (std::size_t k = 0; k < 2; ++k) {
    const Reading* const reading = reading_of(solution, judged_films[k]);
    if (!reading) continue;
    row.reported[k] = reading->error;
    const Reading* const exact = truth ? reading_of(*truth, judged_films[k]) : nullptr;
    if (!exact || !exact->error) continue;
    row.truth_error[k] = exact->error;
    row.achieved[k] = std::abs(reading->value - exact->value) / std::abs(exact->value);
  }
  return row;
}

}  // namespace

std::vector<BoxRow> run_box_bench(const BoxRequest& request) {
  const std::vector<Solution> truths = truths_of(request);
  std::vector<BoxRow> rows;
  for (const RegisteredSolver* solver : request.solvers) {
    for (Setting setting : request.settings) {
      setting.solver = solver->name;
      if (request.progress) request.progress(fmt::format("box by {} at {}", solver->name, setting.text()));
      for (std::size_t i = 0; i < request.contacts.size(); ++i)
        rows.push_back(row_of(*solver, setting, request.contacts[i], request, truths.empty() ? nullptr : &truths[i]));
    }
  }
  return rows;
}

Json to_json(const std::vector<BoxRow>& rows) {
  Json list = Json::array();
  for (const BoxRow& row : rows) {
    Json json{{"solver", row.setting.solver},     {"M", row.contact.moes.M}, {"L", row.contact.moes.L},
              {"inlet", inlet_name(row.contact)}, {"status", row.status},    {"wall_s", median(row.wall_s)},
              {"solves", row.wall_s.size()}};
    if (row.setting.tolerance) json["tolerance"] = *row.setting.tolerance;
    if (row.setting.nodes) json["nodes"] = *row.setting.nodes;
    for (std::size_t k = 0; k < 2; ++k) {
      Json& film = json[std::string(to_string(judged_films[k]))];
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
  constexpr int digits = 6;
  std::string text =
      "solver,tolerance,nodes,M,L,inlet,status,wall_s,H_min_reported,H_min_achieved,H_min_truth_error,H_cen_reported,"
      "H_cen_achieved,H_cen_truth_error\n";
  for (const BoxRow& row : rows) {
    const auto& [M, L] = row.contact.moes;
    std::vector<std::string> cells{row.setting.solver,
                                   csv_number(row.setting.tolerance, digits),
                                   row.setting.nodes ? std::to_string(*row.setting.nodes) : "",
                                   plain(M),
                                   plain(L),
                                   inlet_name(row.contact),
                                   row.status,
                                   plain(median(row.wall_s), digits)};
    for (std::size_t k = 0; k < 2; ++k) {
      for (const auto& error : {row.reported[k], row.achieved[k], row.truth_error[k]})
        cells.push_back(csv_number(error, digits));
    }
    text += csv_line(cells);
  }
  return text;
}

namespace {

/// Rows of one solver, setting and inlet, added up.
class Group {
 public:
  void add(const BoxRow& row) {
    converged_ += row.status == to_string(StopReason::converged) ? 1 : 0;
    times_ms_.push_back(1e3 * median(row.wall_s));
    for (std::size_t k = 0; k < 2; ++k) {
      // An error below the truth's own says nothing.
      if (!row.achieved[k] || !row.reported[k] || !(*row.truth_error[k] < truth_share * *row.reported[k])) continue;
      ++judged_;
      covered_ += *row.achieved[k] <= *row.reported[k] + *row.truth_error[k] ? 1 : 0;
      if (!largest_[k] || *row.achieved[k] > *largest_[k]) {
        largest_[k] = row.achieved[k];
        place_[k] = fmt::format("({}, {})", plain(row.contact.moes.M), plain(row.contact.moes.L));
      }
      if (k == 0 && row.contact.moes.L <= mild_L) mild_ = std::max(mild_.value_or(0), *row.achieved[k]);
    }
  }

  [[nodiscard]] std::vector<std::string> cells(const BoxRow& any) const {
    return {any.setting.solver,
            any.setting.text(),
            inlet_name(any.contact),
            fmt::format("{} of {}", converged_, times_ms_.size()),
            plain(median(times_ms_), 3),
            plain(*std::max_element(times_ms_.begin(), times_ms_.end()), 3),
            dash(largest_[0], 2),
            place_[0],
            dash(mild_, 2),
            dash(largest_[1], 2),
            place_[1],
            fmt::format("{} of {}", covered_, judged_)};
  }

 private:
  std::vector<double> times_ms_;
  std::optional<double> largest_[2], mild_;
  std::string place_[2] = {"-", "-"};
  long converged_ = 0, judged_ = 0, covered_ = 0;
};

}  // namespace

std::string human_table(const std::vector<BoxRow>& rows) {
  std::vector<std::vector<std::string>> table{{"solver", "asked", "inlet", "converged", "median [ms]", "slowest [ms]",
                                               "largest error H_min", "at", "H_min, L <= 15", "H_cen", "at",
                                               "within bars"}};
  for (auto first = rows.begin(); first != rows.end();) {
    Group group;
    auto row = first;
    for (; row != rows.end() && row->setting.solver == first->setting.solver &&
           row->setting.text() == first->setting.text() && row->contact.flooded() == first->contact.flooded();
         ++row)
      group.add(*row);
    table.push_back(group.cells(*first));
    first = row;
  }
  return "The box, Roelands compressible: M of 0.5 .. 5000 (flooded from 0.05), L of 0 .. 30\n" +
         aligned_in_parts(table, 3, "  ") + "\n";
}

}  // namespace ehd::verification
