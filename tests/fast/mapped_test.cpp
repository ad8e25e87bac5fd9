// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/nondimensional.hpp"
#include "tests/check.hpp"
#include "tests/fast/conformance.hpp"
#include "tests/fast/truths.hpp"

using namespace ehd;
using verification::Tolerance;

namespace {

constexpr int known = static_cast<int>(std::size(truths));

std::string name_of(const Truth& truth) {
  return fmt::format("M {} L {}{}", truth.M, truth.L, truth.flooded ? " flooded" : " cut at -4");
}

std::pair<Quantity, double> films_of(const Truth& truth, int which) {
  return which == 0 ? std::pair{Quantity::film_minimum, truth.minimum}
                    : std::pair{Quantity::film_central, truth.central};
}

/// Each film within its reported error of the truth.
void check_bars(const Solution& solution, const Truth& truth) {
  for (const int which : {0, 1}) {
    const auto [quantity, value] = films_of(truth, which);
    BOOST_TEST_CONTEXT(to_string(quantity)) {
      BOOST_REQUIRE(solution.observables.contains(quantity));
      BOOST_REQUIRE(solution.observables.at(quantity).error.has_value());
      EHD_CHECK(error(film(solution, quantity), value),
                Tolerance::discretisation(reported(solution, quantity) + truths_known_to, 1));
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(mapped)

BOOST_AUTO_TEST_CASE(reported_errors_cover_the_true_ones_and_meet_the_tolerance) {
  // Bars are calibrated to hold 98 of 100 films (fast/extrapolation.hpp): at (1000, 20) and 1e-6 a spike that jitters
  // on the last grids leaves 2 bars.
  int films = 0, missed = 0;
  double worst = 0;
  for (const Truth& truth : truths) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      BOOST_TEST_CONTEXT(name_of(truth) << " T " << tolerance) {
        const Solution solution = fast::Mapped{}.solve(problem_of(truth), {.tolerance = tolerance});
        BOOST_CHECK(solution.record.status == StopReason::converged);
        for (const int which : {0, 1}) {
          const auto [quantity, value] = films_of(truth, which);
          const double bar = reported(solution, quantity),
                       bars = error(film(solution, quantity), value) / (bar + truths_known_to);
          EHD_CHECK(bar, Tolerance::required(tolerance, "the tolerance asked for"));
          if (!(bars <= 1)) BOOST_TEST_MESSAGE(to_string(quantity) << " is " << bars << " bars off");
          ++films;
          missed += bars <= 1 ? 0 : 1;
          worst = std::max(worst, bars);
        }
      }
    }
  }
  BOOST_REQUIRE_EQUAL(films, 10 * known);
  EHD_CHECK(missed / static_cast<double>(films), Tolerance::required(0.02, "98 of 100 films within their bars"));
  EHD_CHECK(worst, Tolerance::required(3, "none beyond three bars"));
}

BOOST_AUTO_TEST_CASE(two_grids_cover_the_smallest_film_of_heavy_isoviscous_contacts) {
  struct Contact {
    double M;
    Inlet inlet;
  };
  for (const auto& [M, inlet] : {Contact{11270.1, TruncatedAt{-4}}, Contact{9421.36, Flooded{}}}) {
    BOOST_TEST_CONTEXT("M " << M) {
      const Problem problem = barus_problem(M, 0, inlet);
      const Solution loose = fast::Mapped{}.solve(problem, {.tolerance = 1e-2}),
                     tight = fast::Mapped{}.solve(problem, {.tolerance = 1e-4});
      BOOST_CHECK(loose.record.status == StopReason::converged);
      BOOST_TEST(loose.record.cost.levels == 2);  // else nothing is shown of two grids
      BOOST_CHECK(tight.record.status == StopReason::converged);
      EHD_CHECK(error(film(loose, Quantity::film_minimum), film(tight, Quantity::film_minimum)),
                Tolerance::discretisation(reported(loose, Quantity::film_minimum), 1) + Tolerance::iteration(1e-4));
    }
  }
}

BOOST_AUTO_TEST_CASE(errors_hold_where_they_were_once_too_small) {
  struct Case {
    double M, L, tolerance;
    const char* why;
    bool roelands = false;
    Inlet inlet = Flooded{};
  };
  constexpr double tight_tolerance = 1e-5;
  int rows = 0;
  for (const Case& one : {Case{1449.1, 10.045, 1e-4, "three grids agree on a wrong H_min"},
                          {1457.608, 11.046, 2e-4, "three grids agree on a wrong H_min"},
                          {1827.9, 11.921, 1e-4, "three grids agree on a wrong H_cen"},
                          {1.886, 24.13, 1e-3, "a spike at X = 0, three grids"},
                          {1.8346, 19.303, 3e-3, "a spike at X = 0, two grids"},
                          {1.706576645, 12.5375, 1e-3, "a spike within a cell of X = 0, five grids"},
                          {1.723271816, 15.8565, 1e-2, "a spike within a cell of X = 0, two grids"},
                          {417.21, 21.283, 5e-3, "two grids beside a narrow spike"},
                          {61421.9, 4.7077, 2e-4, "a narrow spike at a small L", true},
                          {0.28601, 15.08, 3e-3, "two grids agree by chance", true, TruncatedAt{-1.156}},
                          {0.0262, 42.74, 7e-3, "a small residual, a wrong film", true, TruncatedAt{-1.049}},
                          {0.12754, 3.492, 1e-3, "cut just before the contact", true, TruncatedAt{-1.02}},
                          {0.2446, 4.87, 1e-2, "cut just before the contact", true, TruncatedAt{-1.0036}},
                          {2.48673, 8.73481, 1e-4, "the same, four grids", true, TruncatedAt{-1.00373}},
                          {0.00203922, 8.84928, 1e-4, "the same, four grids", true, TruncatedAt{-1.05642}}}) {
    BOOST_TEST_CONTEXT("M " << one.M << " L " << one.L << ": " << one.why) {
      const Problem problem =
          one.roelands ? roelands_problem(one.M, one.L, one.inlet) : barus_problem(one.M, one.L, one.inlet);
      const Solution asked = fast::Mapped{}.solve(problem, {.tolerance = one.tolerance}),
                     tight = fast::Mapped{}.solve(problem, {.tolerance = tight_tolerance});
      BOOST_CHECK(asked.record.status == StopReason::converged);
      BOOST_CHECK(tight.record.status == StopReason::converged);
      for (const Quantity quantity : {Quantity::film_minimum, Quantity::film_central})
        EHD_CHECK(error(film(asked, quantity), film(tight, quantity)),
                  Tolerance::discretisation(reported(asked, quantity), 1) + Tolerance::iteration(tight_tolerance));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 15);
}

// The usual tables of the kernel leave 1e-6 in H_min at such an M.
BOOST_AUTO_TEST_CASE(the_stated_error_of_a_very_heavy_contact_covers_the_tables_too) {
  const Problem problem = roelands_problem(490317, 0.9509, Flooded{});
  const Solution asked = fast::Mapped{}.solve(problem, {.tolerance = 1e-6}),
                 finer = fast::Mapped{}.solve(problem, {.tolerance = 1e-7});
  BOOST_CHECK(asked.record.status == StopReason::converged);
  const auto film_minimum = [](const Solution& one) { return film(one, Quantity::film_minimum); };
  EHD_CHECK(
      error(film_minimum(asked), film_minimum(finer)),
      Tolerance::discretisation(reported(asked, Quantity::film_minimum) + reported(finer, Quantity::film_minimum), 1));
}

BOOST_AUTO_TEST_CASE(the_error_of_a_central_film_alone_holds_where_the_spike_stands_near_it) {
  const Problem problem = barus_problem(1.60398, 13.1908, Flooded{});
  const Solution alone = fast::Mapped{}.solve(problem, {.tolerance = {std::nullopt, 1e-6}}),
                 tight = fast::Mapped{}.solve(problem, {.tolerance = 1e-7});
  BOOST_CHECK(alone.record.status == StopReason::converged);
  EHD_CHECK(error(film(alone, Quantity::film_central), film(tight, Quantity::film_central)),
            Tolerance::discretisation(reported(alone, Quantity::film_central), 1) + Tolerance::iteration(1e-7));
}

BOOST_AUTO_TEST_CASE(the_central_film_alone_takes_fewer_intervals_than_both_films) {
  int fewer = 0;
  for (const Truth& truth : truths) {
    for (const double tolerance : {1e-4, 1e-6}) {
      BOOST_TEST_CONTEXT(name_of(truth) << " T " << tolerance) {
        const Problem problem = problem_of(truth);
        const Solution alone = fast::Mapped{}.solve(problem, {.tolerance = {std::nullopt, tolerance}});
        const Solution both = fast::Mapped{}.solve(problem, {.tolerance = tolerance});
        BOOST_CHECK(alone.record.status == StopReason::converged);
        const double bar = reported(alone, Quantity::film_central);
        EHD_CHECK(bar, Tolerance::required(tolerance, "the tolerance asked for"));
        check_bars(alone, truth);
        BOOST_TEST(alone.record.cost.nodes <= both.record.cost.nodes);
        fewer += alone.record.cost.nodes < both.record.cost.nodes ? 1 : 0;
      }
    }
  }
  // At 1e-4 both may end on the same grid.
  BOOST_TEST(fewer >= known);
}

BOOST_AUTO_TEST_CASE(the_central_film_alone_gets_better_maps_where_the_first_does_not_suffice) {
  for (const double M : {500.0, 1000.0, 5000.0}) {
    BOOST_TEST_CONTEXT("M " << M) {
      const Problem problem = roelands_problem(M, 15, Flooded{});
      const Solution alone = fast::Mapped{}.solve(problem, {.tolerance = {std::nullopt, 1e-6}}),
                     both = fast::Mapped{}.solve(problem, {.tolerance = 1e-5});
      BOOST_CHECK(alone.record.status == StopReason::converged);
      BOOST_TEST(alone.record.cost.nodes <= 2048);  // on the first map 4096 and 8192 intervals
      EHD_CHECK(error(film(alone, Quantity::film_central), film(both, Quantity::film_central)),
                Tolerance::discretisation(reported(alone, Quantity::film_central), 1) +
                    Tolerance::discretisation(reported(both, Quantity::film_central), 1));
    }
  }
}

BOOST_AUTO_TEST_CASE(five_hundred_and_a_thousand_intervals_give_the_digits_required) {
  int rows = 0;
  for (const Truth& truth : truths) {
    for (const int n : {512, 1024}) {
      BOOST_TEST_CONTEXT(name_of(truth) << " n " << n) {
        const Solution solution = fast::Mapped{}.solve(problem_of(truth), {.tolerance = {}, .nodes = n});
        BOOST_REQUIRE(solution.record.status == StopReason::converged);
        BOOST_CHECK_EQUAL(solution.record.cost.nodes, n);
        const double central = n == 512 ? 1e-5 : 1e-6, minimum = n == 512 ? 1e-4 : 1e-5;
        EHD_CHECK(error(film(solution, Quantity::film_central), truth.central),
                  Tolerance::required(central, "films to 1e-5 and 1e-6 with 512 and 1024 intervals"));
        EHD_CHECK(error(film(solution, Quantity::film_minimum), truth.minimum),
                  Tolerance::required(minimum, "1e-4 with 512 intervals, 1e-5 with 1024"));
        check_bars(solution, truth);
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 2 * known);
}

BOOST_AUTO_TEST_CASE(any_number_of_intervals_from_sixteen_on_works) {
  int rows = 0;
  for (const Truth& truth : truths) {
    for (const int n : {16, 31, 64, 97, 333, 1000, 1001, 2048}) {
      BOOST_TEST_CONTEXT(name_of(truth) << " n " << n) {
        const Solution solution = fast::Mapped{}.solve(problem_of(truth), {.tolerance = {}, .nodes = n});
        // Alone, a grid of 57 intervals or fewer states 10 % and more.
        BOOST_CHECK(solution.record.status == (n < 58 ? StopReason::under_resolved : StopReason::converged));
        BOOST_CHECK_EQUAL(solution.fields.X.size(), n + 1);
        // Second-order films: 16 cells see an inlet zone of d <= 1.
        EHD_CHECK(error(film(solution, Quantity::film_central), truth.central) * n * n,
                  Tolerance::calibrated(130, "largest of n^2 times the error, (1000, 10) flooded at n = 31 and 16"));
        BOOST_CHECK_EQUAL(solution.record.grids.size() == 1, n < 128);
        check_bars(solution, truth);
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 8 * known);
}

// The coarser grids of such numbers have not exactly half the intervals. Counted as halves they left H_cen up to four
// times its stated error off.
BOOST_AUTO_TEST_CASE(errors_hold_on_intervals_that_four_does_not_divide) {
  struct Case {
    Problem problem;
    std::vector<int> intervals;
  };
  for (const auto& [problem, intervals] :
       {Case{roelands_problem(148.9, 14.09, Flooded{}), {525, 526, 527}},
        Case{barus_problem(2.237, 11.96, TruncatedAt{-4.8266}), {3961, 3962, 3963}}}) {
    const Solution tight = fast::Mapped{}.solve(problem, {.tolerance = 1e-9});
    const double truth = film(tight, Quantity::film_central);
    for (const int n : intervals) {
      BOOST_TEST_CONTEXT("M " << problem.groups.M << " n " << n) {
        const Solution given = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = n});
        EHD_CHECK(error(film(given, Quantity::film_central), truth),
                  Tolerance::discretisation(reported(given, Quantity::film_central), 1));
      }
    }
  }
}

// Both films of a rigid contact have nearly the same error. H_cen missed its stated error by up to 2.5 times.
BOOST_AUTO_TEST_CASE(the_error_of_a_thick_central_film_holds) {
  for (const auto& [M, L, cut, intervals] : {std::tuple{0.03628, 5.0, -8.0, 640}, std::tuple{0.05358, 2.0, -6.0, 512},
                                             std::tuple{0.03301, 10.0, -8.0, 513}}) {
    BOOST_TEST_CONTEXT("M " << M << " n " << intervals) {
      const Problem problem = barus_problem(M, L, TruncatedAt{cut});
      const Solution tight = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = 4 * intervals}),
                     given = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = intervals});
      EHD_CHECK(error(film(given, Quantity::film_central), film(tight, Quantity::film_central)),
                Tolerance::discretisation(reported(given, Quantity::film_central), 1));
    }
  }
}

// The last move of the smallest film is small by chance: it was off by up to 5.7 stated errors. Truths by `reference`
// at 1e-10.
BOOST_AUTO_TEST_CASE(the_smallest_film_of_a_compressible_oil_lies_within_its_error) {
  struct Case {
    double M, L, alpha_per_Pa, cut;  // 0: flooded
    int intervals;
    double minimum;
  };
  for (const Case& one : {Case{2214.4, 14.405, 1.12e-8, -2.5, 8192, 4.8969038336163e-4},
                          Case{411.81, 14.711, 2.162e-8, -2.5, 16384, 3.2955169875715e-3},
                          Case{434.63, 17.123, 1.771e-8, 0, 8192, 3.4438574474710e-3},
                          Case{771, 7.7973, 1.895e-8, 0, 8192, 1.0662140132146e-3}}) {
    BOOST_TEST_CONTEXT("M " << one.M << " n " << one.intervals) {
      const Lubricant oil{
          .viscosity = ViscosityLaw::barus, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = one.alpha_per_Pa};
      const Inlet inlet = one.cut < 0 ? Inlet{TruncatedAt{one.cut}} : Inlet{Flooded{}};
      const Solution given = fast::Mapped{}.solve(nondimensionalise(MoesGroups{one.M, one.L}, oil, inlet).problem,
                                                  {.tolerance = {}, .nodes = one.intervals});
      EHD_CHECK(error(film(given, Quantity::film_minimum), one.minimum),
                Tolerance::discretisation(reported(given, Quantity::film_minimum), 1));
    }
  }
}

// Light load, stiff oil: the pressure falls most steeply before X = 0, and the map has to gather nodes there. Without,
// both films are off by 1.1e-5 on 512 intervals, four times what is stated. Films by high-order collocation.
BOOST_AUTO_TEST_CASE(a_steep_fall_before_the_centre_is_resolved) {
  constexpr Truth truth{.M = 0.6203, .L = 27.77, .flooded = true, .minimum = 6.230251363038, .central = 6.271420658872};
  for (const int n : {256, 512, 1024}) {
    BOOST_TEST_CONTEXT("n " << n) {
      const Problem problem = barus_problem(truth.M, truth.L, Flooded{});
      check_bars(fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = n}), truth);
    }
  }
}

BOOST_AUTO_TEST_CASE(corners_of_the_box_converge) {
  int rows = 0;
  for (const auto& [M, L] : {std::pair{0.02, 0.0},
                             {0.05, 0.0},
                             {0.05, 20.0},
                             {0.5, 30.0},
                             {5000.0, 0.0},
                             {5000.0, 30.0},
                             {3e5, 50.0},
                             {1e6, 0.0},
                             {1e6, 10.0},
                             {1e6, 30.0}}) {
    for (const bool roelands : {false, true}) {
      for (const bool flooded : {false, true}) {
        if (!flooded && M < 0.5) continue;
        BOOST_TEST_CONTEXT("M " << M << " L " << L << " roelands " << roelands << " flooded " << flooded) {
          const Inlet inlet = flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{-4}};
          const Problem problem = roelands ? roelands_problem(M, L, inlet) : barus_problem(M, L, inlet);
          const Solution solution = fast::Mapped{}.solve(problem, {.tolerance = 1e-3});
          BOOST_CHECK(solution.record.status == StopReason::converged);
          BOOST_REQUIRE(solution.observables.contains(Quantity::film_minimum));
          BOOST_CHECK_GT(film(solution, Quantity::film_minimum), 0);
          ++rows;
        }
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 34);
}

BOOST_AUTO_TEST_CASE(a_neighbours_solution_as_start_gives_the_same_films_for_fewer_steps) {
  int rows = 0;
  long warm_steps = 0, cold_steps = 0;
  for (const Truth& truth : truths) {
    BOOST_TEST_CONTEXT(name_of(truth)) {
      const Request request{.tolerance = 1e-4};
      fast::Workspace workspace;
      const Solution neighbour =
          fast::Mapped{}.solve(roelands_problem(1.05 * truth.M, 0.97 * truth.L, inlet_of(truth)), request, workspace);
      const Solution cold = fast::Mapped{}.solve(problem_of(truth), request);
      const Solution warm = fast::Mapped{}.solve(problem_of(truth), request, workspace, neighbour);
      BOOST_REQUIRE(warm.record.status == StopReason::converged);
      check_bars(warm, truth);
      for (const Quantity quantity : {Quantity::film_minimum, Quantity::film_central})
        EHD_CHECK(error(film(warm, quantity), film(cold, quantity)),
                  Tolerance::discretisation(reported(warm, quantity) + reported(cold, quantity), 1));
      warm_steps += warm.record.cost.newton_iterations;
      cold_steps += cold.record.cost.newton_iterations;
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, known);
  BOOST_TEST_MESSAGE(warm_steps << " Newton steps instead of " << cold_steps);
  EHD_CHECK(static_cast<double>(warm_steps) / static_cast<double>(cold_steps),
            Tolerance::required(0.95, "a start that is worth having, over all problems"));
}

BOOST_AUTO_TEST_CASE(the_far_inlet_costs_no_newton_steps) {
  // Flux errors in units of H_n, which the far inlet decides, take 440 steps here; those in units of the oil 355.
  long steps = 0;
  for (const Truth& truth : truths)
    steps += fast::Mapped{}.solve(problem_of(truth), {.tolerance = 1e-4}).record.cost.newton_iterations;
  EHD_CHECK(static_cast<double>(steps), Tolerance::required(400, "halfway between both"));
}

BOOST_AUTO_TEST_CASE(a_useless_start_is_replaced_by_a_cold_one) {
  const Request request{.tolerance = 1e-3};
  fast::Workspace workspace;
  const Solution far = fast::Mapped{}.solve(barus_problem(0.1, 0, Flooded{}), request, workspace);
  const Truth& truth = truths[8];
  const Solution solution = fast::Mapped{}.solve(problem_of(truth), request, workspace, far);
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  check_bars(solution, truth);
  const Solution from_nothing = fast::Mapped{}.solve(problem_of(truth), request, workspace, Solution{});
  BOOST_REQUIRE(from_nothing.record.status == StopReason::converged);
  check_bars(from_nothing, truth);
}

BOOST_AUTO_TEST_CASE(a_kept_workspace_saves_plans_and_changes_no_digit) {
  int rows = 0;
  fast::Workspace kept;
  const Request request{.tolerance = 1e-4};
  (void)fast::Mapped{}.solve(barus_problem(3, 4, Flooded{}), {.tolerance = 1e-6}, kept);
  for (const Truth& truth : truths) {
    BOOST_TEST_CONTEXT(name_of(truth)) {
      const Solution fresh = fast::Mapped{}.solve(problem_of(truth), request);
      const Solution first = fast::Mapped{}.solve(problem_of(truth), request, kept);
      const Solution again = fast::Mapped{}.solve(problem_of(truth), request, kept);
      BOOST_CHECK_GT(fresh.record.cost.planning_s, 0);
      BOOST_CHECK_EQUAL(again.record.cost.planning_s, 0);
      BOOST_CHECK_GT(fresh.record.cost.fft_plans, 0);
      BOOST_CHECK_EQUAL(again.record.cost.fft_plans, fresh.record.cost.fft_plans);
      for (const Solution* other : {&first, &again}) {
        BOOST_REQUIRE_EQUAL(fresh.fields.P.size(), other->fields.P.size());
        BOOST_CHECK((fresh.fields.X == other->fields.X).all());
        BOOST_CHECK((fresh.fields.P == other->fields.P).all());
        BOOST_CHECK((fresh.fields.H == other->fields.H).all());
        BOOST_CHECK_EQUAL(film(fresh, Quantity::film_minimum), film(*other, Quantity::film_minimum));
        BOOST_CHECK_EQUAL(reported(fresh, Quantity::film_minimum), reported(*other, Quantity::film_minimum));
      }
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, known);
}

BOOST_AUTO_TEST_CASE(only_lengths_that_are_multiplied_with_are_planned) {
  constexpr int coarsest = 32, next = 64;  // of the multigrid cycles
  fast::Workspace workspace;
  const Solution solution = fast::Mapped{}.solve(problem_of(truths[0]), {.tolerance = 1e-3}, workspace);
  BOOST_REQUIRE(solution.record.status == StopReason::converged);
  const double planned_s = workspace.grids.planning_s();
  BOOST_CHECK_EQUAL(solution.record.cost.planning_s, planned_s);
  (void)workspace.grids.of(next);
  BOOST_CHECK_EQUAL(workspace.grids.planning_s(), planned_s);
  (void)workspace.grids.of(coarsest);
  BOOST_CHECK_GT(workspace.grids.planning_s(), planned_s);
}

BOOST_AUTO_TEST_CASE(limits_end_a_solve_as_such) {
  const Problem problem = roelands_problem(20, 10, TruncatedAt{-4});
  for (const Request& request :
       {Request{.tolerance = 1e-6, .max_iterations = 3}, Request{.tolerance = 1e-6, .time_limit_s = 0},
        Request{.tolerance = {}, .nodes = 512, .max_iterations = 3},
        Request{.tolerance = 1e-6, .max_iterations = 20}}) {
    const Solution stopped = fast::Mapped{}.solve(problem, request);
    BOOST_CHECK(stopped.record.status == StopReason::limit_reached);
    BOOST_CHECK(!stopped.record.reason.empty());
    if (stopped.observables.contains(Quantity::film_minimum) && stopped.observables.at(Quantity::film_minimum).error)
      EHD_CHECK(error(film(stopped, Quantity::film_minimum), truth_at(20, 10).minimum),
                Tolerance::discretisation(reported(stopped, Quantity::film_minimum), 1));
  }
  const Solution strict = fast::Mapped{}.solve(problem, {.tolerance = 1e-14});
  BOOST_CHECK(strict.record.status == StopReason::tolerance_not_met);
  BOOST_CHECK(!strict.record.reason.empty());
  check_bars(strict, truths[1]);
}

BOOST_AUTO_TEST_CASE(flux_is_constant_and_the_load_is_carried) {
  int rows = 0;
  for (const Truth& truth : truths) {
    BOOST_TEST_CONTEXT(name_of(truth)) {
      const Solution solution = fast::Mapped{}.solve(problem_of(truth), {.tolerance = {}, .nodes = 1024});
      // Newton ends at 8 rounding floors of the flux (newton_krylov.cpp): 4e-9 at (1000, 10) flooded, less at the
      // others.
      EHD_CHECK(film(solution, Quantity::flux_variation), Tolerance::iteration(4e-9, 1));
      EHD_CHECK(film(solution, Quantity::load_error), Tolerance::iteration(1e-9, 1));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, known);
}

BOOST_AUTO_TEST_CASE(a_given_grid_is_solved_to_rounding_in_the_far_inlet_too) {
  const Solution solution =
      fast::Mapped{}.solve(roelands_problem(100, 15, Flooded{}), {.tolerance = {}, .nodes = 1024});
  // 1.9e-10; where flux errors count in units of the oil alone, 7.5e-10 is left far out.
  EHD_CHECK(film(solution, Quantity::flux_variation), Tolerance::iteration(4e-10, 1));
}

BOOST_AUTO_TEST_CASE(plain_films_converge_with_the_declared_order_and_extrapolation_is_worth_it) {
  int rows = 0;
  for (const Truth& truth : {truths[0], truths[1], truths[2], truths[4]}) {
    BOOST_TEST_CONTEXT(name_of(truth)) {
      const Solution solution = fast::Mapped{}.solve(problem_of(truth), {.tolerance = {}, .nodes = 2048});
      const auto& grids = solution.record.grids;
      BOOST_REQUIRE_GE(grids.size(), 4u);
      std::vector<double> logs;  // 256, 512, 1024, 2048
      for (std::size_t k = grids.size() - 4; k < grids.size(); ++k) {
        BOOST_CHECK_EQUAL(grids[k].nodes, 256 << (k + 4 - grids.size()));
        logs.push_back(std::log2(error(grids[k].observed.at(Quantity::film_central).value, truth.central)));
      }
      const double order = (3 * (logs[0] - logs[3]) + (logs[1] - logs[2])) / 10;  // least squares over four grids
      EHD_CHECK(std::abs(order - fast::Mapped::description.formal_order),
                Tolerance::asymptotic(0.15, "h^3 beside h^2 at n = 256"));
      EHD_CHECK(error(film(solution, Quantity::film_central), truth.central),
                Tolerance::discretisation(std::exp2(logs[3]), 0.1));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 4);
}

// These problems were found by random trial. Their true values are by `reference` at 1e-8.
BOOST_AUTO_TEST_CASE(a_pressure_maximum_that_a_spike_may_hide_is_left_out) {
  // The smooth maximum is at 1.0012561, a spike that 4e-4 does not resolve stands beside it.
  const Lubricant oil{.viscosity = ViscosityLaw::roelands,
                      .density = DensityLaw::dowson_higginson,
                      .alpha_per_Pa = 1.59819e-08,
                      .z = 0.7118,
                      .p0_Pa = 2.11889e8};
  Problem problem = nondimensionalise(MoesGroups{20.0519, 11.2773}, oil, Flooded{}).problem;
  const Solution all = fast::Mapped{}.solve(problem, {.tolerance = 4e-4});
  BOOST_REQUIRE(all.record.status == StopReason::converged);
  const auto maximum = all.observables.find(Quantity::pressure_maximum);
  if (maximum != all.observables.end()) {  // the reported error then covers the truth
    BOOST_REQUIRE(maximum->second.error.has_value());
    EHD_CHECK(error(maximum->second.value, 1.0012561), Tolerance::discretisation(*maximum->second.error, 1));
  }
  // A request for the maximum alone gets the same answer.
  problem.wanted = {Quantity::pressure_maximum};
  const Solution one = fast::Mapped{}.solve(problem, {.tolerance = 4e-4});
  BOOST_CHECK_EQUAL(one.observables.contains(Quantity::pressure_maximum), maximum != all.observables.end());
}

// Steel and oil of examples/cylinder-on-plate.toml at other loads and speeds: grids agreed on a height that was 10 and
// 4 % off. The true values are by `reference` at 1e-6.
BOOST_AUTO_TEST_CASE(a_spike_that_still_grows_is_not_reported) {
  const Lubricant oil{
      .viscosity = ViscosityLaw::roelands, .density = DensityLaw::dowson_higginson, .alpha_per_Pa = 2e-8};
  struct Contact {
    double load_N_per_m, speed_m_per_s, maximum_Pa;
  };
  for (const auto& [load, speed, truth] :
       {Contact{200511.013, 7.7822418, 1078.757e6}, {183987.17, 3.27948, 825.98e6}}) {
    const Conditions conditions{.load_N_per_m = load,
                                .reduced_radius_m = 1e-2,
                                .reduced_modulus_Pa = 2.2e11,
                                .speed_sum_m_per_s = speed,
                                .viscosity_Pa_s = 0.02};
    const Nondimensional stated = nondimensionalise(conditions, oil, Flooded{});
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
      BOOST_TEST_CONTEXT("load " << load << ", tolerance " << tolerance) {
        const Solution solution = fast::Mapped{}.solve(stated.problem, {.tolerance = tolerance});
        BOOST_CHECK(solution.record.status == StopReason::converged);
        const auto maximum = solution.observables.find(Quantity::pressure_maximum);
        if (maximum == solution.observables.end()) continue;
        EHD_CHECK(error(maximum->second.value * stated.scales.value().hertz_pressure_Pa, truth),
                  Tolerance::discretisation(maximum->second.error.value(), 1));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(bars_of_two_grids_hold_pressures_too) {
  const Solution solution =
      fast::Mapped{}.solve(barus_problem(4.60323, 1.86837, Flooded{}), {.tolerance = {}, .nodes = 129});
  BOOST_REQUIRE(solution.observables.contains(Quantity::pressure_maximum));
  for (const auto& [quantity, truth] :
       {std::pair{Quantity::pressure_maximum, .951194581}, std::pair{Quantity::film_minimum, .189790071436},
        std::pair{Quantity::film_central, .248863963190}, std::pair{Quantity::film_couette, .246587689221}})
    EHD_CHECK(error(film(solution, quantity), truth), Tolerance::discretisation(reported(solution, quantity), 1));
}

/// Two grids that both miss the spike hardly move. There the work was 2.6 to 4.4 times its stated error off.
BOOST_AUTO_TEST_CASE(two_grids_cover_the_work_at_a_spike) {
  struct Contact {
    double M, L;
    Inlet inlet;
    int nodes;
  };
  const Contact contacts[] = {{250, 9, TruncatedAt{-4}, 220},
                              {250, 9, TruncatedAt{-4}, 240},
                              {250, 9, Flooded{}, 220},
                              {10, 13.5, Flooded{}, 240}};
  for (const auto& [M, L, inlet, nodes] : contacts) {
    BOOST_TEST_CONTEXT("M " << M << " L " << L << " on " << nodes << " intervals") {
      const Problem problem = barus_problem(M, L, inlet);
      const Solution coarse = fast::Mapped{}.solve(problem, {.tolerance = {}, .nodes = nodes});
      const double truth = film(fast::Mapped{}.solve(problem, {.tolerance = 1e-6}), Quantity::rolling_force);
      BOOST_REQUIRE(std::isfinite(truth));
      EHD_CHECK(error(film(coarse, Quantity::rolling_force), truth),
                Tolerance::discretisation(reported(coarse, Quantity::rolling_force), 1));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_light_load_starved_by_a_short_inlet_is_reached_from_a_milder_one) {
  const Solution short_inlet = fast::Mapped{}.solve(barus_problem(0.05, 20, TruncatedAt{-4}), {.tolerance = 1e-3});
  BOOST_REQUIRE(short_inlet.record.status == StopReason::converged);
  EHD_CHECK(error(film(short_inlet, Quantity::film_minimum), 25.194510212),
            Tolerance::discretisation(reported(short_inlet, Quantity::film_minimum), 1));
  const Solution shorter =
      fast::Mapped{}.solve(barus_problem(.668806, 26.5047, TruncatedAt{-1.5}), {.tolerance = {}, .nodes = 145});
  BOOST_REQUIRE(shorter.record.status == StopReason::converged);
  EHD_CHECK(error(film(shorter, Quantity::film_minimum), 1.56140466),
            Tolerance::discretisation(reported(shorter, Quantity::film_minimum), 1));
}

BOOST_AUTO_TEST_CASE(what_a_case_does_not_need_is_not_computed) {
  check_that_nothing_needless_is_computed(fast::Mapped{});
}

BOOST_AUTO_TEST_CASE(multigrid_needs_one_or_two_krylov_steps_whatever_the_grid) {
  std::vector<Problem> problems;
  for (const Truth& truth : {truths[0], truths[1], truths[3], truths[8]}) problems.push_back(problem_of(truth));
  check_krylov_steps(fast::Mapped{}, problems, {512, 2048, 8192});
}

BOOST_AUTO_TEST_SUITE_END()
