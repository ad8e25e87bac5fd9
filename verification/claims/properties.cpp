// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that hold for any inputs: units, similarity, monotony, scaling laws, conservation. Inputs are drawn from
// fixed seeds, over the range in which bearings and gears run. These claims need no other solver's solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr unsigned unit_seed = 20261124, similar_seed = 20261125, line_seed = 20261126, flux_seed = 20261127;

struct StatedContact {
  Conditions conditions;
  Lubricant lubricant;
};

/// A contact of steel, or of something a quarter as stiff, whose groups lie well inside the box.
StatedContact drawn_contact(Draw& draw, ViscosityLaw law) {
  for (;;) {
    StatedContact drawn;
    drawn.conditions = {.load_N_per_m = draw.logarithmic(1e3, 1e6),
                        .reduced_radius_m = draw.logarithmic(1e-3, 1e-1),
                        .reduced_modulus_Pa = draw.uniform(0.6e11, 2.4e11),
                        .speed_sum_m_per_s = draw.logarithmic(1e-2, 30),
                        .viscosity_Pa_s = draw.logarithmic(2e-3, 0.5)};
    drawn.lubricant = {
        .viscosity = law,
        .density = DensityLaw::incompressible,  // the constants of the others are in Pa, whatever the units
        .alpha_per_Pa = draw.uniform(0.8e-8, 2.5e-8),
        .z = law == ViscosityLaw::roelands ? std::optional(draw.uniform(0.4, 0.8)) : std::nullopt,
        .p0_Pa = draw.uniform(1.9e8, 2e8)};
    const double ER = drawn.conditions.reduced_modulus_Pa * drawn.conditions.reduced_radius_m;
    const double U = *drawn.conditions.viscosity_Pa_s * *drawn.conditions.speed_sum_m_per_s / ER;
    const double M = drawn.conditions.load_N_per_m / ER / std::sqrt(U);
    const double L = *drawn.lubricant.alpha_per_Pa * drawn.conditions.reduced_modulus_Pa * std::pow(U, 0.25);
    if (M >= 0.5 && M <= 500 && L >= 1 && L <= 20) return drawn;
  }
}

/// A film with its error; null where the solver does not state both.
const Reading* film_of(const Solution& solution, Quantity film) {
  const Reading* seen = reading(solution, film);
  return seen && seen->error && std::isfinite(seen->value) ? seen : nullptr;
}

// ---- Rung 0: units ------------------------------------------------------------------------------------------------

/// The same contact in other units: one metre is `length` of the new units, likewise newton and second.
StatedContact in_units(StatedContact contact, double length, double force, double time) {
  const double pressure = force / (length * length);
  contact.conditions.load_N_per_m *= force / length;
  contact.conditions.reduced_radius_m *= length;
  contact.conditions.reduced_modulus_Pa *= pressure;
  *contact.conditions.speed_sum_m_per_s *= length / time;
  *contact.conditions.viscosity_Pa_s *= pressure * time;
  *contact.lubricant.alpha_per_Pa /= pressure;
  contact.lubricant.p0_Pa *= pressure;
  return contact;
}

/// All numbers of a flooded problem: the groups and both laws.
std::vector<double> numbers_of(const Problem& problem) {
  std::vector<double> numbers{problem.groups.M, problem.groups.L, problem.groups.lambda, problem.groups.alpha_p_H};
  for (const std::vector<double>& law : {cache_key(problem.viscosity), cache_key(problem.density)})
    numbers.insert(numbers.end(), law.begin(), law.end());
  return numbers;
}

/// Units that differ by powers of two change no digit; lengths by powers of four, because b holds their square root.
Findings judge_units() {
  constexpr int contacts = 200, solved = 4;
  Draw draw(unit_seed);
  int same = 0, films_same = 0, films_seen = 0;
  for (int i = 0; i < contacts; ++i) {
    const auto law = i % 2 == 0 ? ViscosityLaw::roelands : ViscosityLaw::barus;
    const StatedContact one = drawn_contact(draw, law);
    const StatedContact other = in_units(one, std::pow(4.0, draw.integer(-8, 8)), std::pow(2.0, draw.integer(-20, 20)),
                                         std::pow(2.0, draw.integer(-12, 12)));
    const Problem in_SI = nondimensionalise(one.conditions, one.lubricant, Flooded{}).problem;
    const Problem in_others = nondimensionalise(other.conditions, other.lubricant, Flooded{}).problem;
    same += numbers_of(in_SI) == numbers_of(in_others) ? 1 : 0;
    if (i >= solved) continue;
    const Solution a = default_solver().solve(in_SI, {}), b = default_solver().solve(in_others, {});
    for (const Quantity film : judged_films) {
      const Reading *x = film_of(a, film), *y = film_of(b, film);
      ++films_seen;
      films_same += x && y && x->value == y->value && *x->error == *y->error ? 1 : 0;
    }
  }
  Findings found;
  found.claims.push_back(claim_fact(
      {.id = "properties/units/problem",
       .rung = 0,
       .statement = fmt::format(
           "{} random contacts in units that differ by powers of two are bit for bit the same dimensionless problem",
           contacts)},
      same == contacts, "only similarity groups enter", fmt::format("{} of {}", same, contacts)));
  found.claims.push_back(claim_fact(
      {.id = "properties/units/films",
       .rung = 0,
       .statement = fmt::format("and {} of them have films and errors that are the same bit for bit", solved),
       .solver = default_solver().name},
      films_same == films_seen && films_seen > 0, "a solver sees groups alone",
      fmt::format("{} of {} films", films_same, films_seen)));
  return found;
}

// ---- Rung 9: similarity, scaling laws, monotony -----------------------------------------------------------------

/// h/R U_s^(-1/2) by its definition, from the film in metres.
double moes_film(const Conditions& conditions, double film_m) {
  const double U = *conditions.viscosity_Pa_s * *conditions.speed_sum_m_per_s /
                   (conditions.reduced_modulus_Pa * conditions.reduced_radius_m);
  return film_m / conditions.reduced_radius_m / std::sqrt(U);
}

/// Another contact with the same M and L: E', R and eta_0 are drawn, w, u_s and alpha follow.
StatedContact similar_to(const StatedContact& one, Draw& draw) {
  const Conditions& from = one.conditions;
  StatedContact other = one;
  Conditions& to = other.conditions;
  to.reduced_modulus_Pa *= draw.uniform(0.2, 0.9);
  to.reduced_radius_m *= draw.uniform(1.1, 7);
  *to.viscosity_Pa_s *= draw.uniform(0.1, 0.9);
  const double U_ratio = draw.uniform(0.2, 5);  // W ~ U^(1/2), G ~ U^(-1/4)
  const double ER_ratio =
      to.reduced_modulus_Pa * to.reduced_radius_m / (from.reduced_modulus_Pa * from.reduced_radius_m);
  *to.speed_sum_m_per_s *= U_ratio * ER_ratio * *from.viscosity_Pa_s / *to.viscosity_Pa_s;
  to.load_N_per_m *= std::sqrt(U_ratio) * ER_ratio;
  *other.lubricant.alpha_per_Pa *= std::pow(U_ratio, -0.25) * from.reduced_modulus_Pa / to.reduced_modulus_Pa;
  return other;
}

Findings judge_similarity() {
  constexpr int pairs = 6;
  constexpr double tolerance = 1e-5;
  Draw draw(similar_seed);
  double worst = 0;  // difference over the sum of the stated errors
  double difference = 0;
  for (int i = 0; i < pairs; ++i) {
    const StatedContact one = drawn_contact(draw, ViscosityLaw::barus);
    const StatedContact other = similar_to(one, draw);
    double film[2][2], error[2][2];
    for (int k = 0; k < 2; ++k) {
      const StatedContact& contact = k == 0 ? one : other;
      const Nondimensional made = nondimensionalise(contact.conditions, contact.lubricant, Flooded{});
      const Solution solution = default_solver().solve(made.problem, {.tolerance = tolerance});
      for (std::size_t j = 0; j < 2; ++j) {
        const Reading* seen = film_of(solution, judged_films[j]);
        const double unit_m = made.scales->film_m_per_hertz_film().value_or(nothing);
        film[k][j] = seen ? moes_film(contact.conditions, seen->value * unit_m) : nothing;
        error[k][j] = error_of(seen);
      }
    }
    for (int j = 0; j < 2; ++j) {
      const double apart = std::abs(film[1][j] / film[0][j] - 1), ratio = apart / (error[0][j] + error[1][j]);
      worst = worse(worst, ratio);
      difference = worse(difference, apart);
    }
  }
  Findings found;
  found.claims.push_back(claim({.id = "properties/similarity/moes",
                                .rung = 9,
                                .statement = fmt::format("Moes films of Barus contacts depend on M and L alone: {} "
                                                         "random pairs that differ in E', R, eta_0, u, w and alpha",
                                                         pairs),
                                .solver = default_solver().name},
                               worst, 0, Tolerance::required(1, "difference over the sum of the stated errors"),
                               "largest relative difference " + plain(difference, 2)));
  return found;
}

/// h ~ u and h ~ 1/w where surfaces stay rigid: the Moes film times M is Martin's constant, up to a remainder in M^2.
Findings judge_rigid_surfaces() {
  constexpr double M = 0.05, tolerance = 1e-5;
  // Doubled speed: M over sqrt 2, h/R = Moes film times U^(1/2). Doubled load: M doubled.
  struct Change {
    const char *id, *says;
    double M_after, expected;
  };
  const Solution before = default_solver().solve(problem_at({M, 0}, false, Flooded{}), {.tolerance = tolerance});
  Findings found;
  for (const Change& change :
       {Change{"speed", "doubling the speed doubles", M / std::numbers::sqrt2, std::numbers::sqrt2},
        Change{"load", "doubling the load halves", 2 * M, 0.5}}) {
    const Solution after =
        default_solver().solve(problem_at({change.M_after, 0}, false, Flooded{}), {.tolerance = tolerance});
    const Reading *a = film_of(before, Quantity::film_minimum), *b = film_of(after, Quantity::film_minimum);
    const double measured =
        a && b ? b->value * moes_film_per_hertz_film(change.M_after) / (a->value * moes_film_per_hertz_film(M))
               : nothing;
    const double heavier = std::max(M, change.M_after);
    found.claims.push_back(claim_value(
        {.id = std::string("properties/scaling/rigid-") + change.id,
         .rung = 9,
         .statement = std::string(change.says) + " an isoviscous film between surfaces that stay rigid",
         .solver = default_solver().name},
        measured, change.expected, a && b ? *a->error + *b->error : nothing,
        Tolerance::asymptotic(heavier * heavier, "elastic remainder of order M^2, at M = " + plain(heavier))));
  }
  return found;
}

struct FilmAndError {
  double value = nothing, error = nothing;
};
/// A solver need not state an error of the Couette film. That of the central film serves, because both are one flux.
FilmAndError film_or_flux(const Solution& solution, Quantity film) {
  const Reading* seen = film_of(solution, film == Quantity::film_couette ? Quantity::film_central : film);
  const Reading* own = observed(solution, film);
  return seen && own ? FilmAndError{own->value, *seen->error} : FilmAndError{};
}

/// Along lines through the box, in steps of a factor of two of the speed alone or of the load alone. Judged are minimum
/// film and flux. The film at X = 0 is not monotone: it grows with the load where the contact's plateau forms
/// (reference, Barus, L = 9: 5.3596, 5.5751, 6.2535 Moes units at M = 1, 1.4, 1.9), and falls at heavier loads.
Findings judge_lines(bool roelands) {
  constexpr int lines = 8, steps = 4;
  constexpr double tolerance = 1e-3, lightest = 0.05, heaviest = 2000, largest_step_L = 25;
  struct Count {
    int right = 0, wrong = 0, undecided = 0, unsolved = 0;
    double smallest = std::numeric_limits<double>::infinity();  // change of the film over the errors
  };
  std::map<bool, Count> counts;  // speed, load
  std::map<bool, std::string> against;
  Draw draw(line_seed);
  for (int line = 0; line < lines; ++line) {
    const MoesGroups from{draw.logarithmic(2, 100), draw.uniform(2, 15)};
    for (const bool speed : {true, false}) {
      Count& count = counts[speed];
      std::optional<Solution> before;
      MoesGroups at_before;
      for (int step = 0; step <= steps; ++step) {
        const double factor = std::pow(2.0, step - steps / 2);
        // U -> factor U: M ~ U^(-1/2), L ~ U^(1/4); W -> factor W: M ~ W.
        const MoesGroups at = speed ? MoesGroups{from.M / std::sqrt(factor), from.L * std::pow(factor, 0.25)}
                                    : MoesGroups{from.M * factor, from.L};
        if (at.M < lightest || at.M > heaviest || at.L > largest_step_L) continue;
        Solution now = default_solver().solve(problem_at(at, roelands, Flooded{}), {.tolerance = tolerance});
        for (const Quantity film : {Quantity::film_minimum, Quantity::film_couette}) {
          if (!before) break;
          const FilmAndError a = film_or_flux(*before, film), b = film_or_flux(now, film);
          if (std::isnan(a.value) || std::isnan(b.value)) {
            ++count.unsolved;
            continue;
          }
          // h/R = H (8M/pi) U^(1/2), and U^(1/2) doubles every second step of the speed.
          const double root_U = speed ? std::numbers::sqrt2 : 1;
          const double grows =
              b.value * moes_film_per_hertz_film(at.M) * root_U / (a.value * moes_film_per_hertz_film(at_before.M));
          const double change = speed ? std::log(grows) : -std::log(grows), errors = a.error + b.error;
          ++(change > errors ? count.right : change < -errors ? count.wrong : count.undecided);
          count.smallest = std::min(count.smallest, change / errors);  // shown beside the verdict, no part of it
          if (change < -errors)
            against[speed] += fmt::format(" {} at M = {}, L = {};", to_string(film), plain(at.M, 4), plain(at.L, 4));
        }
        before = std::move(now);
        at_before = at;
      }
    }
  }
  Findings found;
  for (const auto& [speed, count] : counts) {
    const int all = count.right + count.wrong + count.undecided + count.unsolved;
    found.claims.push_back(claim_fact(
        {.id = std::string("properties/monotone/") + (speed ? "speed-" : "load-") + (roelands ? "roelands" : "barus"),
         .rung = 9,
         .statement =
             fmt::format("minimum film and flux {} beyond the stated errors, at {} random contacts in steps of two, {}",
                         speed ? "grow with the speed" : "shrink with the load", lines, law_name(roelands)),
         .solver = default_solver().name},
        all > 0 && count.right == all, "every step of two is decided and has that direction",
        fmt::format("{} of {} steps, {} within the errors, {} without films; smallest change {} times the errors{}",
                    count.right, all, count.undecided, count.unsolved, plain(count.smallest, 3),
                    against[speed].empty() ? "" : "; against it:" + against[speed])));
  }
  return found;
}

// ---- Rung 6: constant flux ---------------------------------------------------------------------------------------

Findings judge_flux() {
  constexpr int contacts = 40;
  constexpr double tolerance = 1e-3;
  Findings found;
  for (const Quantity quantity : {Quantity::flux_variation, Quantity::load_error}) {
    Draw draw(flux_seed);
    double worst = 0;
    std::string worst_at;
    for (int i = 0; i < contacts; ++i) {
      const MoesGroups at{draw.logarithmic(0.2, 1000), draw.uniform(0, 20)};
      const bool roelands = i % 2 == 0, flooded = at.M < 2 || i % 4 < 2;
      const Inlet inlet = flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{usual_cut}};
      const Solution solution =
          remembered(default_solver().name).solve(problem_at(at, roelands, inlet), {.tolerance = tolerance});
      const double value = value_of(reading(solution, quantity));
      if (!(value <= worst) && !std::isnan(worst)) {
        worst = value;
        worst_at = fmt::format("worst at M = {}, L = {}, {}{}", plain(at.M, 4), plain(at.L, 4), law_name(roelands),
                               flooded ? ", flooded" : ", cut at -4");
      }
    }
    const bool flux = quantity == Quantity::flux_variation;
    found.claims.push_back(
        claim({.id = std::string("properties/conserved/") + (flux ? "flux" : "load"),
               .rung = 6,
               .statement =
                   fmt::format("{} of {} random contacts, within the accuracy asked of the films",
                               flux ? "the flux is the same at every face" : "the pressure carries the load", contacts),
               .solver = default_solver().name},
              worst, 0, Tolerance::required(tolerance, "the accuracy asked of the films"), worst_at));
  }
  return found;
}

}  // namespace

std::vector<Topic> property_topics() {
  std::vector<Topic> topics{
      {.name = "properties: units", .rungs = {0}, .judge = judge_units},
      {.name = "properties: similarity", .rungs = {9}, .judge = judge_similarity},
      {.name = "properties: rigid surfaces", .rungs = {9}, .judge = judge_rigid_surfaces},
      {.name = "properties: flux and load", .rungs = {6}, .judge = judge_flux},
      {.name = "properties: bearings", .rungs = {11}, .judge = bearing_parts::judge_bearing_symmetry}};
  for (const bool roelands : {true, false})
    topics.push_back(
        {.name = "properties: speed and load", .rungs = {9}, .judge = [roelands] { return judge_lines(roelands); }});
  return topics;
}

}  // namespace ehd::verification
