// SPDX-License-Identifier: GPL-3.0-or-later
// (e) Inputs moved by one ulp and by 1e-8. The amplification dln H/dln q is the condition number. With a step of 1e-8
// it must equal that with 1e-3, and, where films follow from M and L alone, that of the chain rule. One ulp must move a
// film by no more than condition x ulp and two roundings of a film.
//
// Rounding of a film on n equal cells from X_a: terms of size 1 + X_a^2/2 in a sum of n products, relative to the film,
// plus what the iteration leaves. This rounding over the step bounds the error of a difference quotient.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "contact/text.hpp"
#include "verification/stress/parts.hpp"
#include "verification/stress/stated.hpp"
#include "verification/studies/solver_lists.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

constexpr double small_step = 1e-8, large_step = 1e-3;
constexpr double iterated_to = 1e-11;
constexpr double time_limit_s = 60;
/// Bound of the third derivatives in ln M and ln L. A central difference errs by s^2/6 of it, 10 s^2.
constexpr double third_derivative = 60;

struct Films {
  double film[2] = {};
  bool converged = false, late = false;
};

/// The factor from Hertz units to metres where the statement is in SI, else to Moes' unit, in which films with Barus'
/// law follow from M and L alone.
double film_unit(const Stated& stated, const Nondimensional& made) {
  return stated.in_SI() ? *made.scales->film_m_per_hertz_film() : moes_film_per_hertz_film(made.problem.groups.M);
}

Films films_of(const Stated& stated, const RegisteredSolver& solver, int intervals) {
  const Nondimensional made = stated.made();
  const Ended end =
      ended(solver.solve(made.problem, {.tolerance = {}, .nodes = intervals, .time_limit_s = time_limit_s}));
  Films result;
  // Judged are the equations on this grid, also where it is too coarse for the contact.
  const bool solved = end.status == StopReason::converged || end.status == StopReason::under_resolved;
  result.converged = solved && end.film[0] && end.film[1] && end.finite;
  result.late = out_of_time(end.status, end.wall_s, time_limit_s);
  const double unit = film_unit(stated, made);
  for (std::size_t k = 0; k < 2; ++k) result.film[k] = result.converged ? *end.film[k] * unit : std::nan("");
  return result;
}

struct Contact {
  std::string name;
  Stated stated;
};

std::vector<Contact> contacts(bool quick) {
  std::vector<Contact> list;
  for (const BoxContact& one : {BoxContact{{20, 10}, true}, {{5, 5}, false}, {{2, 5}, true}, {{100, 5}, true}}) {
    list.push_back({one.name(), {.statement = one.moes, .lubricant = oil(one.roelands)}});
    if (quick) break;
  }
  list.push_back({"SI, Barus", {.statement = ordinary_conditions(), .lubricant = {.alpha_per_Pa = 1.7e-8}}});
  Lubricant real = oil(true);
  real.alpha_per_Pa = 1.9e-8;
  if (!quick) list.push_back({"SI, Roelands", {.statement = ordinary_conditions(), .lubricant = real}});
  return list;
}

using PerFilm = std::array<double, 2>;

/// One input of one contact, moved up and down, by one solver.
class Mover {
 public:
  Mover(const Stated& stated, const Input& input, const RegisteredSolver& solver, int intervals)
      : stated_(stated), input_(input.of(stated_)), value_(input_), solver_(solver), intervals_(intervals) {}
  Mover(const Mover&) = delete;
  Mover& operator=(const Mover&) = delete;

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] bool late() const { return late_; }
  Films at(double moved) {
    input_ = moved;
    const Films found = films_of(stated_, solver_, intervals_);
    input_ = value_;
    converged_ = converged_ && found.converged;
    late_ = late_ || found.late;
    return found;
  }
  /// dln H/dln q by a central difference.
  PerFilm slope(double step) {
    const double above = value_ * (1 + step), below = value_ * (1 - step);
    const Films up = at(above), down = at(below);
    PerFilm result{};
    for (std::size_t k = 0; k < 2; ++k) result[k] = std::log(up.film[k] / down.film[k]) / std::log(above / below);
    return result;
  }

 private:
  Stated stated_;
  double& input_;  // in stated_
  double value_;
  const RegisteredSolver& solver_;
  int intervals_;
  bool converged_ = true, late_ = false;
};

/// Slopes of the film over ln M or ln L, of the same contact stated by groups.
PerFilm slope_of_group(const Groups& groups, double MoesGroups::*group, double cut, const RegisteredSolver& solver,
                       int intervals) {
  const MoesGroups centre{groups.M, groups.L};
  const auto films = [&](double factor) {
    MoesGroups moved = centre;
    moved.*group = centre.*group * factor;
    return films_of({.statement = moved, .lubricant = oil(false), .inlet = cut}, solver, intervals);
  };
  const Films high = films(1 + large_step), low = films(1 - large_step);
  PerFilm slope{};
  for (std::size_t k = 0; k < 2; ++k)
    slope[k] = std::log(high.film[k] / low.film[k]) / std::log((1 + large_step) / (1 - large_step));
  return slope;
}

/// Barus, incompressible, in SI: h = R U^(1/2) f(M, L), M = W U^(-1/2), L = G U^(1/4), with X_a in half-widths. So the
/// chain rule gives the amplification from the slopes over M and L.
void add_chain_rule(const Stated& stated, const RegisteredSolver& solver, int intervals, ConditionRow& row) {
  struct Powers {
    double R = 0, U = 0, W = 0, G = 0;
  };
  const std::map<std::string, Powers> powers{{"load", {.W = 1}},
                                             {"radius", {.R = 1, .U = -1, .W = -1}},
                                             {"modulus", {.U = -1, .W = -1, .G = 1}},
                                             {"speed", {.U = 1}},
                                             {"viscosity", {.U = 1}},
                                             {"alpha", {.G = 1}}};
  const Groups groups = stated.made().problem.groups;
  const PerFilm f_M = slope_of_group(groups, &MoesGroups::M, stated.inlet, solver, intervals);
  const PerFilm f_L = slope_of_group(groups, &MoesGroups::L, stated.inlet, solver, intervals);
  const Powers& p = powers.at(row.quantity);
  for (std::size_t k = 0; k < 2; ++k)
    row.by_groups[k] = p.R + p.U / 2 + f_M[k] * (p.W - p.U / 2) + f_L[k] * (p.G + p.U / 4);
}

ConditionRow row_of(const Contact& contact, const Input& input, const RegisteredSolver& solver, int intervals) {
  ConditionRow row;
  row.contact = contact.name;
  row.solver = solver.name;
  row.quantity = input.name;
  const Stated& stated = contact.stated;
  Mover mover(stated, input, solver, intervals);
  const double value = mover.value(), next = std::nextafter(value, 2 * value);
  const Films here = mover.at(value), up = mover.at(next), down = mover.at(std::nextafter(value, 0));
  row.ulp = std::abs(next / value - 1);
  const PerFilm small = mover.slope(small_step), large = mover.slope(large_step), larger = mover.slope(2 * large_step);
  for (std::size_t k = 0; k < 2; ++k) {
    row.amplification[k] = small[k];
    // The error of a central difference is ~ s^2: extrapolated from s and 2 s.
    row.large_step[k] = large[k] + (large[k] - larger[k]) / 3;
    row.large_step_error[k] = std::abs(large[k] - larger[k]) / 3;
    row.ulp_move[k] = std::max(std::abs(up.film[k] / here.film[k] - 1), std::abs(down.film[k] / here.film[k] - 1));
  }
  row.converged = mover.converged();
  row.late = mover.late();
  const double condition = (1 + stated.inlet * stated.inlet / 2) / (here.film[0] / film_unit(stated, stated.made()));
  const double stages = solver.uses_fft ? 4 * std::log2(2.0 * intervals) + 10 : intervals;
  row.floor = Tolerance::round_off(stages, condition).value() + iterated_to;
  if (stated.in_SI() && stated.lubricant.viscosity == ViscosityLaw::barus && row.quantity != "inlet")
    add_chain_rule(stated, solver, intervals, row);
  return row;
}

}  // namespace

std::vector<ConditionRow> run_condition(const Scope& scope) {
  struct Task {
    const Contact* contact;
    const RegisteredSolver* solver;
    Input input;
  };
  const auto all = contacts(scope.quick);
  const int intervals = scope.quick ? 128 : 256;
  std::vector<Task> tasks;
  for (const Contact& contact : all) {
    for (const RegisteredSolver* solver : second_order_solvers()) {
      if (!on_equal_cells(*solver)) continue;
      for (const Input& input : inputs_of(contact.stated)) tasks.push_back({&contact, solver, input});
    }
  }
  std::vector<ConditionRow> rows(tasks.size());
  scope.show(fmt::format("{} quantities", tasks.size()));
  in_threads(tasks.size(), scope.threads, [&](std::size_t i) {
    const Task& task = tasks[i];
    rows[i] = row_of(*task.contact, task.input, *task.solver, intervals);
  });
  return rows;
}

Part judge_condition(const std::vector<ConditionRow>& rows) {
  Part part{.id = "e",
            .name = "condition",
            .question = "By how much do the films move where an input moves by one ulp or by 1e-8?"};
  part.settings = {{"small_step", small_step}, {"large_step", large_step}};
  part.table.columns = columns_of(
      "contact | solver | input | dlnH_min/dln [1e-8] | dlnH_min/dln [1e-3] | dlnH_cen/dln [1e-8] | dlnH_cen/dln "
      "[1e-3] | by groups [H_cen] | ulp moves H_min | H_cen | rounding of a film");
  Tally tally;
  double largest = 0, worst_slope = 0, worst_ulp = 0;
  for (const ConditionRow& row : rows) {
    const std::string where = fmt::format("{}, {}, {}", row.contact, row.solver, row.quantity);
    part.table.rows.push_back({row.contact, row.solver, row.quantity, row.amplification[0], row.large_step[0],
                               row.amplification[1], row.large_step[1], row.by_groups[1], row.ulp_move[0],
                               row.ulp_move[1], row.floor});
    tally.add(holds_in_time(row.converged, row.late), where + ": a solve did not converge");
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string film = fmt::format("{}, {}", where, to_string(judged_films[k]));
      const double condition = std::abs(row.large_step[k]);
      // The rounding of two films over twice the step.
      const Tolerance of_slope =
          Tolerance::iteration(row.floor, 1 / small_step) +
          Tolerance::asymptotic(row.large_step_error[k], "what extrapolating the large step moved");
      tally.add(std::abs(row.amplification[k] - row.large_step[k]), 0, of_slope,
                film + ", amplification against that of 1e-3");
      worst_slope = std::max(worst_slope, std::abs(row.amplification[k] - row.large_step[k]) / of_slope.value());
      const Tolerance of_ulp =
          Tolerance::required(condition * row.ulp, "condition x ulp") + Tolerance::iteration(row.floor, 2);
      tally.add(row.ulp_move[k], 0, of_ulp, film + ", moved by one ulp");
      worst_ulp = std::max(worst_ulp, row.ulp_move[k] / of_ulp.value());
      if (row.by_groups[k])
        tally.add(std::abs(row.large_step[k] - *row.by_groups[k]), 0,
                  Tolerance::asymptotic(third_derivative / 6 * large_step * large_step,
                                        "s^2 of the central differences in M and L, third derivatives below 60") +
                      Tolerance::iteration(row.floor, 4 / large_step),
                  film + ", against the chain rule over M and L");
      largest = std::max(largest, std::abs(row.amplification[k]));
      keep_larger(part.tolerance, of_slope);
    }
  }
  tally.close(part);
  part.summary = fmt::format(
      "The largest derivative dln(film)/dln(input) is {}. Steps of 1e-8 and of 1e-3 give it with a difference of at "
      "most {} times the bound for rounding. A step of one ulp moves films by at most {} times their bound",
      plain(largest, 3), plain(worst_slope, 2), plain(worst_ulp, 2));
  return part;
}

}  // namespace ehd::verification::stress
