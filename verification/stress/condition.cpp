// SPDX-License-Identifier: GPL-3.0-or-later
// (e) Inputs moved by one ulp and by 1e-8: the amplification dln H/dln q is the condition number. It must be that of a
// step of 1e-3, and where films follow from M and L alone, that of the chain rule; one ulp moves a film by no more than
// condition x ulp and two roundings of a film.
//
// Rounding of a film on n equal cells from X_a: terms of size 1 + X_a^2/2 in a sum of n products, relative to the film,
// and what iteration leaves. Divided by the step, it is what a difference of 1e-8 can be wrong by.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "contact/text.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/oils.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

constexpr double small_step = 1e-8, large_step = 1e-3;
constexpr double iterated_to = 1e-11;

/// Everything that a contact is stated by; a quantity is a place in it.
struct Stated {
  bool in_SI = false;
  MoesGroups moes = {};
  Conditions SI = {};
  Lubricant lubricant = {};
  double inlet = -4;
};

struct Input {
  std::string name;
  std::function<double&(Stated&)> of;
};

std::vector<Input> quantities(const Stated& stated) {
  std::vector<Input> all;
  if (stated.in_SI) {
    all = {{"load", [](Stated& s) -> double& { return s.SI.load_N_per_m; }},
           {"radius", [](Stated& s) -> double& { return s.SI.reduced_radius_m; }},
           {"modulus", [](Stated& s) -> double& { return s.SI.reduced_modulus_Pa; }},
           {"speed", [](Stated& s) -> double& { return *s.SI.speed_sum_m_per_s; }},
           {"viscosity", [](Stated& s) -> double& { return *s.SI.viscosity_Pa_s; }}};
  } else {
    all = {{"M", [](Stated& s) -> double& { return s.moes.M; }}, {"L", [](Stated& s) -> double& { return s.moes.L; }}};
  }
  all.push_back({"inlet", [](Stated& s) -> double& { return s.inlet; }});
  if (stated.lubricant.alpha_per_Pa)
    all.push_back({"alpha", [](Stated& s) -> double& { return *s.lubricant.alpha_per_Pa; }});
  if (stated.lubricant.viscosity == ViscosityLaw::roelands) {
    all.push_back({"z", [](Stated& s) -> double& { return *s.lubricant.z; }});
    all.push_back({"p0", [](Stated& s) -> double& { return s.lubricant.p0_Pa; }});
  }
  return all;
}

struct Films {
  double film[2] = {};
  bool converged = false;
};

/// Films in metres where the statement is in SI, in Moes units else: what M and L alone decide for Barus.
Films films_of(const Stated& stated, const RegisteredSolver& solver, int intervals) {
  const auto made = stated.in_SI ? nondimensionalise(stated.SI, stated.lubricant, TruncatedAt{stated.inlet})
                                 : nondimensionalise(stated.moes, stated.lubricant, TruncatedAt{stated.inlet});
  const Ended end = ended(solver.solve(made.problem, {.tolerance = {}, .nodes = intervals, .time_limit_s = 60}));
  Films result;
  result.converged = end.status == StopReason::converged && end.film[0] && end.film[1] && end.finite;
  const double unit =
      stated.in_SI ? *made.scales->film_m_per_hertz_film() : moes_film_per_hertz_film(made.problem.groups.M);
  for (std::size_t k = 0; k < 2; ++k) result.film[k] = result.converged ? *end.film[k] * unit : std::nan("");
  return result;
}

struct Contact {
  std::string name;
  Stated stated;
};

std::vector<Contact> contacts(bool quick) {
  std::vector<Contact> list;
  for (const auto& [M, L, roelands] :
       {std::tuple{20.0, 10.0, true}, {5.0, 5.0, false}, {2.0, 5.0, true}, {100.0, 5.0, true}}) {
    list.push_back({contact_name({M, L}, roelands), {.moes = {M, L}, .lubricant = oil(roelands)}});
    if (quick) break;
  }
  const Conditions SI{.load_N_per_m = 1.1e5,
                      .reduced_radius_m = 0.0113,
                      .reduced_modulus_Pa = 2.26e11,
                      .speed_sum_m_per_s = 2.9,
                      .viscosity_Pa_s = 0.021};
  list.push_back({"SI, Barus", {.in_SI = true, .SI = SI, .lubricant = {.alpha_per_Pa = 1.7e-8}}});
  Lubricant real = oil(true);
  real.alpha_per_Pa = 1.9e-8;
  if (!quick) list.push_back({"SI, Roelands", {.in_SI = true, .SI = SI, .lubricant = real}});
  return list;
}

}  // namespace

std::vector<ConditionRow> run_condition(const Scope& scope) {
  struct Task {
    const Contact* contact;
    const RegisteredSolver* solver;
    Input quantity;
  };
  const auto all = contacts(scope.quick);
  const int intervals = scope.quick ? 128 : 256;
  std::vector<Task> tasks;
  for (const Contact& contact : all) {
    for (const char* solver : {"reference.uniform", "fast.uniform"}) {
      for (const auto& quantity : quantities(contact.stated))
        tasks.push_back({&contact, find_solver(solver), quantity});
    }
  }
  std::vector<ConditionRow> rows(tasks.size());
  scope.show(std::to_string(tasks.size()) + " quantities");
  in_threads(tasks.size(), scope.threads, [&](std::size_t index) {
    const Task& task = tasks[index];
    ConditionRow& row = rows[index];
    row.contact = task.contact->name;
    row.solver = task.solver->name;
    row.quantity = task.quantity.name;
    Stated stated = task.contact->stated;
    double& input = task.quantity.of(stated);
    const double value = input;
    const auto at = [&](double moved) {
      input = moved;
      const Films found = films_of(stated, *task.solver, intervals);
      input = value;
      row.converged = row.converged && found.converged;
      return found;
    };
    const auto slope = [&](double step) {
      const double above = value * (1 + step), below = value * (1 - step);
      const Films up = at(above), down = at(below);
      std::array<double, 2> result{};
      for (std::size_t k = 0; k < 2; ++k) result[k] = std::log(up.film[k] / down.film[k]) / std::log(above / below);
      return result;
    };
    const Films here = at(value), up = at(std::nextafter(value, 2 * value)), down = at(std::nextafter(value, 0));
    row.ulp = std::abs(std::nextafter(value, 2 * value) / value - 1);
    const auto small = slope(small_step), large = slope(large_step), larger = slope(2 * large_step);
    for (std::size_t k = 0; k < 2; ++k) {
      row.amplification[k] = small[k];
      // Central differences err by s^2: the next term cancels between s and 2 s.
      row.large_step[k] = large[k] + (large[k] - larger[k]) / 3;
      row.large_step_error[k] = std::abs(large[k] - larger[k]) / 3;
      row.ulp_move[k] = std::max(std::abs(up.film[k] / here.film[k] - 1), std::abs(down.film[k] / here.film[k] - 1));
    }
    const auto made = stated.in_SI ? nondimensionalise(stated.SI, stated.lubricant, TruncatedAt{stated.inlet})
                                   : nondimensionalise(stated.moes, stated.lubricant, TruncatedAt{stated.inlet});
    const double unit =
        stated.in_SI ? *made.scales->film_m_per_hertz_film() : moes_film_per_hertz_film(made.problem.groups.M);
    const double condition = (1 + stated.inlet * stated.inlet / 2) / (here.film[0] / unit);
    const double stages = task.solver->uses_fft ? 4 * std::log2(2.0 * intervals) + 10 : intervals;
    row.floor = Tolerance::round_off(stages, condition).value() + iterated_to;

    // Barus, incompressible, in SI: h = R U^(1/2) f(M, L), M = W U^(-1/2), L = G U^(1/4), and X_a in half-widths.
    if (!stated.in_SI || stated.lubricant.viscosity != ViscosityLaw::barus || row.quantity == "inlet") return;
    const Groups& groups = made.problem.groups;
    Stated by_groups{.moes = {groups.M, groups.L}, .lubricant = oil(false), .inlet = stated.inlet};
    std::array<double, 2> f_M{}, f_L{};
    for (double* const one : {&by_groups.moes.M, &by_groups.moes.L}) {
      const double centre = *one;
      *one = centre * (1 + large_step);
      const Films high = films_of(by_groups, *task.solver, intervals);
      *one = centre * (1 - large_step);
      const Films low = films_of(by_groups, *task.solver, intervals);
      *one = centre;
      auto& f = one == &by_groups.moes.M ? f_M : f_L;
      for (std::size_t k = 0; k < 2; ++k)
        f[k] = std::log(high.film[k] / low.film[k]) / std::log((1 + large_step) / (1 - large_step));
    }
    struct Powers {
      double R = 0, U = 0, W = 0, G = 0;
    };
    const std::map<std::string, Powers> powers{{"load", {.W = 1}},
                                               {"radius", {.R = 1, .U = -1, .W = -1}},
                                               {"modulus", {.U = -1, .W = -1, .G = 1}},
                                               {"speed", {.U = 1}},
                                               {"viscosity", {.U = 1}},
                                               {"alpha", {.G = 1}}};
    const Powers& p = powers.at(row.quantity);
    for (std::size_t k = 0; k < 2; ++k)
      row.by_groups[k] = p.R + p.U / 2 + f_M[k] * (p.W - p.U / 2) + f_L[k] * (p.G + p.U / 4);
  });
  return rows;
}

Part judge_condition(const std::vector<ConditionRow>& rows) {
  Part part{.id = "e",
            .name = "condition",
            .question = "By how much do the films move where an input moves by one ulp or by 1e-8?"};
  part.settings = {{"small_step", small_step}, {"large_step", large_step}};
  part.table.columns = {{"contact", ""},
                        {"solver", ""},
                        {"input", ""},
                        {"dlnH_min/dln", "1e-8"},
                        {"dlnH_min/dln", "1e-3"},
                        {"dlnH_cen/dln", "1e-8"},
                        {"dlnH_cen/dln", "1e-3"},
                        {"by groups", "H_cen"},
                        {"ulp moves H_min", ""},
                        {"H_cen", ""},
                        {"rounding of a film", ""}};
  Tally tally;
  double largest = 0, worst_slope = 0, worst_ulp = 0;
  for (const ConditionRow& row : rows) {
    const std::string where = row.contact + ", " + row.solver + ", " + row.quantity;
    part.table.rows.push_back({row.contact, row.solver, row.quantity, row.amplification[0], row.large_step[0],
                               row.amplification[1], row.large_step[1], row.by_groups[1].value_or(std::nan("")),
                               row.ulp_move[0], row.ulp_move[1], row.floor});
    tally.require(row.converged, where + ": a solve did not converge");
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string film = where + ", " + std::string(to_string(films[k]));
      const double condition = std::abs(row.large_step[k]);
      // Two films, each known to the floor, over twice the step.
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
                  Tolerance::asymptotic(10 * large_step * large_step,
                                        "s^2 of the central differences in M and L, third derivatives below 60") +
                      Tolerance::iteration(row.floor, 4 / large_step),
                  film + ", against the chain rule over M and L");
      largest = std::max(largest, std::abs(row.amplification[k]));
      if (!part.tolerance || of_slope.value() > part.tolerance->value()) part.tolerance = of_slope;
    }
  }
  part.verdict = tally.verdict();
  part.failures = tally.failures();
  part.summary = "largest amplification " + plain(largest, 3) + "; 1e-8 and 1e-3 agree within " +
                 plain(worst_slope, 2) + " of what rounding allows, one ulp moves films by at most " +
                 plain(worst_ulp, 2) + " of condition x ulp + rounding";
  return part;
}

}  // namespace ehd::verification::stress
