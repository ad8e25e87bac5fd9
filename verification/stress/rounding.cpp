// SPDX-License-Identifier: GPL-3.0-or-later
// (d) Every solver, with FFTW, Eigen and libm, in the four rounding modes, each mode in a process of its own.
//
// A film is X^2/2 + H_0 less a sum of kernel products. Its terms have the size 1 + X_a^2/2. A directed mode errs by up
// to one eps in each operation, always to the same side: n terms err by up to n eps. An FFT adds them in log2 2n stages
// of 4 eps each (rung 2). The bound is twice that, because the mode and rounding to nearest both err, plus what the
// iteration leaves. Solvers that fit their grids to the solution may choose another grid: their films may move by the
// sum of the errors that both runs state.
#include <fmt/format.h>

#include <cfenv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/text.hpp"
#include "io/json.hpp"
#include "verification/bench/child.hpp"
#include "verification/claim.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/solver_lists.hpp"

namespace ehd::verification::stress {

namespace {

constexpr double inlet = usual_cut;
constexpr int intervals = 256;
constexpr double iterated_to = 1e-11;
constexpr double time_limit_s = 60, adaptive_tolerance = 1e-5;

struct Mode {
  const char* name;
  int mode;
};
constexpr Mode modes[] = {
    {"nearest", FE_TONEAREST}, {"up", FE_UPWARD}, {"down", FE_DOWNWARD}, {"to zero", FE_TOWARDZERO}};

struct Asked {
  const RegisteredSolver* solver;
  Request request;
  bool to_rounding;
  double operations;
};

std::vector<Asked> asked_of_all() {
  const double fft_stages = std::log2(2.0 * intervals);
  const Request on_a_grid{.tolerance = {}, .nodes = intervals, .time_limit_s = time_limit_s};
  const Request to_tolerance{.tolerance = adaptive_tolerance, .time_limit_s = time_limit_s};
  std::vector<Asked> all;
  for (const RegisteredSolver* solver : second_order_solvers())
    if (on_equal_cells(*solver))
      all.push_back({solver, on_a_grid, true, solver->dense() ? 2.0 * intervals : 8 * fft_stages + 20});
  for (const RegisteredSolver* solver : second_order_solvers())
    if (!on_equal_cells(*solver)) all.push_back({solver, to_tolerance, false, 0});
  all.push_back({&certified_solver(), to_tolerance, false, 0});
  return all;
}

/// True where 1/3 rounded up differs from 1/3 rounded down. If not, the modes have no effect and nothing is tested.
bool modes_act() {
  volatile double one = 1, three = 3;  // volatile: the compiler must not divide
  const int before = std::fegetround();
  if (std::fesetround(FE_UPWARD) != 0) return false;
  volatile double up = one / three;
  if (std::fesetround(FE_DOWNWARD) != 0) return false;
  volatile double down = one / three;
  return std::fesetround(before) == 0 && up > down;
}

Json in_mode(int mode, const std::vector<Asked>& all, const std::vector<Problem>& problems) {
  std::vector<Ended> ends;
  const bool act = modes_act();
  if (std::fesetround(mode) != 0) throw std::runtime_error("this rounding mode cannot be set");
  const bool in_force = act && std::fegetround() == mode;
  for (const Asked& asked : all) {
    for (const Problem& problem : problems) ends.push_back(ended(asked.solver->solve(problem, asked.request)));
  }
  const bool stayed = std::fegetround() == mode;
  std::fesetround(FE_TONEAREST);  // for the text of the numbers, which is read in this mode
  if (!stayed) throw std::runtime_error("a solver changed the rounding mode");
  Json json = Json::array();
  for (const Ended& end : ends) {
    Json one = json_of(end);
    one["in_force"] = in_force;
    json.push_back(one);
  }
  return json;
}

/// One solve in its mode against the same solve rounded to nearest.
void compare(const Ended& end, const Ended& nearest, const Asked& asked, RoundingRow& row) {
  row.status = end.status;
  row.late = out_of_time(end.status, end.wall_s, time_limit_s);
  if (!end.has_films() || !nearest.has_films() || !end.finite) return;
  row.minimum = std::abs(*end.film[0] / *nearest.film[0] - 1);
  row.central = std::abs(*end.film[1] / *nearest.film[1] - 1);
  if (asked.to_rounding) {
    const double condition = (1 + inlet * inlet / 2) / *nearest.film[0];
    row.tolerance = Tolerance::round_off(2 * asked.operations, condition) + Tolerance::iteration(2 * iterated_to);
  } else {
    const double stated = std::max(*end.error[0] + *nearest.error[0], *end.error[1] + *nearest.error[1]);
    row.tolerance = Tolerance::discretisation(stated, 1);
  }
}

}  // namespace

std::vector<RoundingRow> run_rounding(const Scope& scope) {
  std::vector<BoxContact> contacts =
      cut_contacts({{{5, 5}, true}, {{20, 10}, true}, {{1, 0}, false}, {{10, 5}, false}});
  if (scope.quick) contacts.resize(1);
  std::vector<Problem> problems;
  for (const BoxContact& contact : contacts) problems.push_back(contact.problem());
  const auto all = asked_of_all();
  std::vector<RoundingRow> rows;
  Json nearest;
  for (const auto& [name, mode] : modes) {
    scope.show(name);
    const ChildEnd child = in_child([&, one = mode] { return in_mode(one, all, problems).dump(); });
    const Json json = child.text ? Json::parse(*child.text) : Json::array();
    if (mode == FE_TONEAREST) nearest = json;
    std::size_t index = 0;
    for (const Asked& asked : all) {
      for (const BoxContact& contact : contacts) {
        RoundingRow row{
            .solver = asked.solver->name, .contact = contact.name(), .mode = name, .to_rounding = asked.to_rounding};
        row.minimum = row.central = std::nan("");
        if (index < json.size() && index < nearest.size()) {
          row.in_force = json[index].at("in_force").get<bool>();
          compare(ended_from(json[index]), ended_from(nearest[index]), asked, row);
        } else {
          row.why = child.why;
        }
        ++index;
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

Part judge_rounding(const std::vector<RoundingRow>& rows) {
  Part part{.id = "d",
            .name = "rounding",
            .question = "Do the films stay where they are when the processor rounds up, down or to zero?"};
  part.settings = {{"intervals", intervals}, {"tolerance", adaptive_tolerance}, {"inlet", inlet}};
  part.table.columns = columns_of("solver | contact | mode | status | H_min moves | H_cen moves | bound | by");
  Tally tally;
  double worst = 0, farthest = 0;
  long converged = 0, directed = 0, moved = 0;
  for (const RoundingRow& row : rows) {
    const bool is_directed = row.mode != modes[0].name;
    directed += is_directed ? 1 : 0;
    moved += is_directed && (row.minimum != 0 || row.central != 0) ? 1 : 0;
    const std::string where = fmt::format("{}, {}, {}", row.solver, row.contact, row.mode);
    part.table.rows.push_back({row.solver, row.contact, row.mode, to_string(row.status), row.minimum, row.central,
                               row.tolerance, row.to_rounding ? "operations x condition" : "stated errors"});
    tally.add(holds_in_time(row.status == StopReason::converged, row.late),
              where + ": " + (row.why.empty() ? std::string(to_string(row.status)) : row.why));
    converged += row.status == StopReason::converged ? 1 : 0;
    if (row.why.empty() && !row.in_force)
      tally.add(Verdict::inconclusive, where + ": the rounding mode was not in force");
    if (!row.tolerance) {
      tally.add(Verdict::inconclusive, where + ": no films to compare");
      continue;
    }
    for (const double move : {row.minimum, row.central}) {
      tally.add(move, 0, *row.tolerance, where + ", a film moves");
      worst = worse(worst, move / row.tolerance->value());
      if (row.to_rounding) farthest = worse(farthest, move);
    }
    if (row.to_rounding) keep_larger(part.tolerance, *row.tolerance);
  }
  if (directed == 0 || moved == 0)
    tally.add(Verdict::inconclusive, "not one bit of one film moves in a directed mode: it cannot have been in force");
  tally.close(part);
  part.summary = fmt::format(
      "{} of {} solves converge; films on fixed grids move by at most {}, every film by at most {} of its bound",
      converged, rows.size(), plain(farthest, 2), plain(worst, 2));
  return part;
}

}  // namespace ehd::verification::stress
