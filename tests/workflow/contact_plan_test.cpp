// SPDX-License-Identifier: GPL-3.0-or-later
// A stage that a case does not need does not run. The counters in Cost show this, not the time.
#include "workflow/contact_plan.hpp"

#include "tests/check.hpp"
#include "workflow/contact_run.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

ContactCase contact(double M, double L, ViscosityLaw viscosity, DensityLaw density) {
  ContactCase made;
  made.statement = MoesGroups{.M = M, .L = L};
  Lubricant lubricant;
  lubricant.viscosity = viscosity;
  lubricant.density = density;
  lubricant.alpha_per_Pa = 2.3e-8;
  lubricant.z = 0.67;
  made.lubricant = lubricant;
  made.inlet = TruncatedAt{-4};
  return made;
}

ContactCase dry_contact() {
  ContactCase made;
  made.statement = Conditions{.load_N_per_m = 1.1e5, .reduced_radius_m = 1.2e-2, .reduced_modulus_Pa = 2.1e11};
  return made;
}

std::string reason(const Plan& plan, std::string_view stage) {
  for (const auto& skipped : plan.skipped) {
    if (skipped.stage == stage) return skipped.why;
  }
  return "";
}

Request coarse() {
  Request request;
  request.tolerance = 1e-2;
  return request;
}

const RegisteredSolver& fast() { return *find_solver("fast"); }
const RegisteredSolver& reference() { return *find_solver("reference"); }

}  // namespace

BOOST_AUTO_TEST_SUITE(contact_plan)

BOOST_AUTO_TEST_CASE(every_stage_runs_or_is_skipped_with_a_reason) {
  for (const auto* solver : {&fast(), &reference()}) {
    for (const auto& any : {dry_contact(), contact(7, 3, ViscosityLaw::roelands, DensityLaw::dowson_higginson)}) {
      const Plan made = plan_contact(any, *solver, coarse(), {Quantity::film_minimum});
      for (const auto stage : {stage::groups, stage::dry, stage::fft_plan, stage::viscosity, stage::density,
                               stage::solve, stage::grids, stage::formulas}) {
        const bool skipped = !reason(made, stage).empty();
        BOOST_CHECK_MESSAGE(made.runs(stage) != skipped, stage);
      }
      for (const Quantity quantity : all_quantities)
        BOOST_TEST(made.runs(stage::observe(quantity)) != !reason(made, stage::observe(quantity)).empty());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_dry_contact_makes_no_fft_plan_and_no_solve) {
  const ContactRun run = run_contact(dry_contact(), fast(), coarse());
  const Cost& cost = run.solution.record.cost;
  BOOST_TEST(!run.plan.runs(stage::solve));
  BOOST_TEST(!run.plan.runs(stage::fft_plan));
  BOOST_TEST(cost.fft_plans == 0);
  BOOST_TEST(cost.newton_iterations == 0);
  BOOST_TEST(cost.convolutions == 0);
  BOOST_TEST(cost.viscosity_points == 0);
  BOOST_TEST(cost.density_points == 0);
  BOOST_CHECK(run.status() == StopReason::converged);
  BOOST_TEST(!run.groups.has_value());
  BOOST_TEST(run.solution.observables.count(Quantity::film_minimum) == 0u);
  EHD_CHECK(error(run.solution.observables.at(Quantity::film_offset).value, -0.5965736),
            Tolerance::published_digits("0.5965736"));
}

BOOST_AUTO_TEST_CASE(film_formulas_are_those_of_the_films_that_are_asked_for) {
  const auto formulas = [](const Wanted& wanted) {
    return run_contact(contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible), fast(), coarse(), wanted)
        .formulas;
  };
  BOOST_TEST(!formulas({Quantity::film_central}).empty());
  for (const FilmFormula& formula : formulas({Quantity::film_central})) BOOST_TEST_CONTEXT(formula.name) {
      BOOST_TEST((formula.of == Quantity::film_central));
    }
  BOOST_TEST(formulas(want_everything()).size() > formulas({Quantity::film_central}).size());
  BOOST_TEST(formulas({Quantity::approach}).empty());
}

BOOST_AUTO_TEST_CASE(an_isoviscous_contact_evaluates_no_viscosity_law) {
  for (const auto* solver : {&fast(), &reference()}) {
    const ContactRun run =
        run_contact(contact(7, 0, ViscosityLaw::isoviscous, DensityLaw::incompressible), *solver, coarse());
    BOOST_TEST(!run.plan.runs(stage::viscosity));
    BOOST_REQUIRE(run.solution.record.cost.newton_iterations > 0);  // it did run
    BOOST_TEST(run.solution.record.cost.viscosity_points == 0);
    BOOST_TEST(run.solution.record.cost.density_points == 0);
  }
}

BOOST_AUTO_TEST_CASE(an_incompressible_contact_evaluates_no_density) {
  for (const auto* solver : {&fast(), &reference()}) {
    const ContactRun run =
        run_contact(contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible), *solver, coarse());
    BOOST_TEST(run.plan.runs(stage::viscosity));
    BOOST_TEST(!run.plan.runs(stage::density));
    BOOST_TEST(run.solution.record.cost.viscosity_points > 0);
    BOOST_TEST(run.solution.record.cost.density_points == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_compressible_roelands_contact_evaluates_both_laws) {
  const ContactRun run =
      run_contact(contact(7, 3, ViscosityLaw::roelands, DensityLaw::dowson_higginson), fast(), coarse());
  BOOST_TEST(run.plan.runs(stage::viscosity));
  BOOST_TEST(run.plan.runs(stage::density));
  BOOST_TEST(run.solution.record.cost.viscosity_points > 0);
  BOOST_TEST(run.solution.record.cost.density_points > 0);
}

BOOST_AUTO_TEST_CASE(only_the_solver_with_transforms_plans_them) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  BOOST_TEST(run_contact(any, fast(), coarse()).solution.record.cost.fft_plans > 0);
  const ContactRun dense = run_contact(any, reference(), coarse());
  BOOST_TEST(!dense.plan.runs(stage::fft_plan));
  BOOST_TEST(dense.solution.record.cost.fft_plans == 0);
}

BOOST_AUTO_TEST_CASE(quantities_that_are_not_asked_for_are_not_returned) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  const ContactRun run = run_contact(any, fast(), coarse(), {Quantity::film_central});
  BOOST_REQUIRE(run.solution.observables.size() == 1u);
  BOOST_TEST(run.solution.observables.count(Quantity::film_central) == 1u);
  BOOST_TEST(reason(run.plan, stage::observe(Quantity::pressure_spike)) == "not asked for");
}

BOOST_AUTO_TEST_CASE(grids_stop_at_the_coarsest_that_meets_the_tolerance) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  Request fine = coarse();
  fine.tolerance = 1e-5;
  const Cost loose_cost = run_contact(any, fast(), coarse()).solution.record.cost;
  const Cost tight_cost = run_contact(any, fast(), fine).solution.record.cost;
  BOOST_TEST(loose_cost.nodes < tight_cost.nodes);
  BOOST_TEST(loose_cost.convolutions < tight_cost.convolutions);
}

BOOST_AUTO_TEST_CASE(a_film_that_is_not_asked_for_refines_no_grid) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  const ContactRun both = run_contact(any, fast(), {.tolerance = 1e-6});
  const ContactRun central = run_contact(any, fast(), {.tolerance = {std::nullopt, 1e-6}});
  const ContactRun minimum = run_contact(any, fast(), {.tolerance = {1e-6, std::nullopt}});
  BOOST_TEST(central.solution.record.cost.nodes < both.solution.record.cost.nodes);
  BOOST_TEST(minimum.solution.record.cost.nodes <= both.solution.record.cost.nodes);
  BOOST_TEST(reason(central.plan, stage::finer).find("of film.central, 1e-6") != std::string::npos);
  BOOST_TEST(reason(minimum.plan, stage::finer).find("of film.minimum, 1e-6") != std::string::npos);
  BOOST_TEST(reason(both.plan, stage::finer).find("of film.minimum and film.central, 1e-6") != std::string::npos);
  const ContactRun each = run_contact(any, fast(), {.tolerance = {1e-2, 1e-6}});
  BOOST_TEST(reason(each.plan, stage::finer).find("of film.minimum, 0.01, and film.central, 1e-6") !=
             std::string::npos);
}

// Counters: a wanted quantity costs what the tolerance of its film alone costs.
BOOST_AUTO_TEST_CASE(a_tolerance_holds_for_the_films_that_the_wanted_quantities_need) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  const auto work = [&](const Request& request, const Wanted& wanted = want_everything()) {
    return run_contact(any, fast(), request, wanted).solution.record.cost.convolutions;
  };
  const Request both{.tolerance = 1e-6}, minimum{.tolerance = {1e-6, std::nullopt}},
      central{.tolerance = {std::nullopt, 1e-6}};
  BOOST_TEST(work(central) < work(both));
  for (const Quantity one : {Quantity::film_central, Quantity::film_couette, Quantity::film_offset, Quantity::approach})
    BOOST_TEST(work(both, {one}) == work(central), to_string(one));
  BOOST_TEST(work(both, {Quantity::film_minimum}) == work(minimum));
  for (const Quantity one : {Quantity::pressure_maximum, Quantity::pressure_exit, Quantity::rolling_force})
    BOOST_TEST(work(both, {one}) == work(both), to_string(one));
  BOOST_TEST(work(both, {Quantity::film_minimum, Quantity::film_couette}) == work(both));
}

BOOST_AUTO_TEST_CASE(the_plan_names_the_films_that_the_wanted_quantities_need) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  const auto why = [&](const Wanted& wanted) {
    return reason(plan_contact(any, fast(), {.tolerance = 1e-6}, wanted), stage::finer);
  };
  const std::string begin = "a coarser grid already meets the tolerance of ";
  BOOST_TEST(why({Quantity::film_minimum}) == begin + "film.minimum, 1e-6");
  BOOST_TEST(why({Quantity::film_central, Quantity::approach}) == begin + "film.central, 1e-6");
  BOOST_TEST(why({Quantity::film_couette, Quantity::film_offset}) ==
             begin + "film.central, 1e-6 (film.central for film.couette, film.offset)");
  BOOST_TEST(why({Quantity::pressure_maximum}) ==
             begin + "film.minimum and film.central, 1e-6 (film.minimum and film.central for pressure.maximum)");
  BOOST_TEST(why(want_everything()) == begin + "film.minimum and film.central, 1e-6");
}

// A library caller may state such a request; the command line refuses it.
BOOST_AUTO_TEST_CASE(a_tolerance_that_serves_no_wanted_quantity_still_ends_the_solve) {
  const Request central{.tolerance = {std::nullopt, 1e-2}};
  BOOST_TEST((request_for(central, {Quantity::film_minimum}).tolerance == central.tolerance));
}

BOOST_AUTO_TEST_CASE(a_number_of_nodes_switches_the_search_for_a_grid_off) {
  const auto any = contact(7, 3, ViscosityLaw::barus, DensityLaw::incompressible);
  Request request;
  request.tolerance = {};
  request.nodes = 512;
  const ContactRun run = run_contact(any, fast(), request);
  BOOST_TEST(!run.plan.runs(stage::grids));
  BOOST_TEST(run.solution.record.cost.nodes == 512);
}

// The table of quantities says which of them a dry contact has.
BOOST_AUTO_TEST_CASE(a_dry_contact_has_the_quantities_that_the_table_gives_it) {
  const ContactRun run = run_contact(dry_contact(), default_solver(), Request{});
  for (const Quantity quantity : all_quantities)
    BOOST_TEST(run.solution.observables.contains(quantity) == exists_when_dry(quantity), to_string(quantity));
}

BOOST_AUTO_TEST_SUITE_END()
