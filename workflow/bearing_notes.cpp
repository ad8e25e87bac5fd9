// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "workflow/bearing_plan.hpp"

namespace ehd::note {

namespace {

constexpr double steel_limit_Pa = 4e9;  // above it a result is a numerical test
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Row>
long loaded(const std::vector<Row>& rollers) {
  return std::count_if(rollers.begin(), rollers.end(), [](const Row& roller) { return roller.inner.force_N > 0; });
}

}  // namespace

std::string datum(const std::string& name, const bearing::BothRaceways<double>& x0_m) {
  return fmt::format("datum: {}; x_0 = {} (inner), {} (outer)", name, millimetre(x0_m.inner), millimetre(x0_m.outer));
}

std::string palmgren_at(double load_N) {
  return fmt::format("palmgren, the hertz law met at a contact force of {} N", plain(load_N));
}

std::string lateral_force(double force_N) {
  return fmt::format(
      "radial form: the cage position is not symmetric to the load, and the ring, which moves along the load only, "
      "needs a lateral force of {} N",
      plain(force_N, 4));
}

std::string raised_fit(double M, const char* raceway, double from_N, double part_of_dry, double unraised_N) {
  return fmt::format(
      "fit raised to M = {} at the {} raceway: from {} N, where {} times the largest dry force would be {} N", plain(M),
      raceway, plain(from_N, 4), plain(part_of_dry), plain(unraised_N, 3));
}

std::string no_films(const std::string& why) { return "no films: " + why; }

std::string no_variant(const std::string& why) {
  return fmt::format("variant {}: no balance, {}", bearing_stage::variant, why);
}

std::string variant(const VariantResult& cut, const std::vector<RollerRow>& rollers, bool on_jump, bool radial) {
  return fmt::format("variant {}: {} loaded rollers instead of {}, roller 1 carries {} N instead of {} N{}{}", cut.name,
                     loaded(cut.rollers), loaded(rollers), plain(cut.rollers[0].inner.force_N),
                     plain(rollers[0].inner.force_N),
                     on_jump ? "; the outermost sit on the jump of the law at delta = 0" : "",
                     radial ? "; balanced in the radial form, since in the plane rollers stand on that jump" : "");
}

std::string curve(const bearing::FilmCurve& curve, const std::vector<RollerRow>& rollers,
                  ContactRow RollerRow::*raceway, const char* name) {
  const auto below = std::count_if(rollers.begin(), rollers.end(),
                                   [&](const RollerRow& row) { return (row.*raceway).force_N < curve.lightest_N(); });
  const bearing::CurveErrors& errors = curve.errors();
  return fmt::format(
      "{} curve: {} solved contacts from {} to {} N, relative errors of film and force: interpolation {}, {}; rigid "
      "limit below {}, {}; solver's own {} ({}); {} contacts lie below it",
      name, curve.forces_N().size(), plain(curve.lightest_N(), 4), plain(curve.heaviest_N(), 4),
      plain(errors.interpolation, 2), plain(errors.interpolation_force, 2), plain(errors.joint, 2),
      plain(errors.joint_force, 2), plain(errors.solver_offset_film, 2), errors.lightest_because, below);
}

std::string missed_contacts(std::size_t count) {
  return fmt::format("{} of the raceways' solved contacts have an estimated film error above 1e-3", count);
}

void add_lubricant(Notes& notes, const BearingSetup& setup) {
  const Conditions conditions = setup.contacts.inner.at(setup.loading.radial_N / setup.geometry.rollers);
  try {
    for (const std::string& note : nondimensionalise(conditions, setup.body.lubricant->lubricant, Flooded{}).notes)
      if (note.find("GPa") == std::string::npos) notes.push_back(note);
  } catch (const StatementError&) {  // a mean load out of range says nothing about the rollers' own
  }
}

void add_fit_range(Notes& notes, const bearing::LinearFit& fit, const std::vector<RollerRow>& rollers,
                   ContactRow RollerRow::*raceway, const char* name) {
  const double low = fit.points.front().force_N, high = fit.points.back().force_N;
  int outside = 0;
  double lowest = infinity, highest = 0;
  for (const RollerRow& row : rollers) {
    const double f = (row.*raceway).force_N;
    if (!(f > 0) || (f >= low && f <= high)) continue;
    ++outside;
    lowest = std::min(lowest, f);
    highest = std::max(highest, f);
  }
  if (outside > 0)
    notes.push_back(fmt::format("fit used outside its range: {} {} contacts carry {} to {} N, fitted from {} to {} N",
                                outside, name, plain(lowest, 4), plain(highest, 4), plain(low), plain(high)));
}

void add_limits(Notes& notes, const std::vector<RollerRow>& rollers) {
  double highest_Pa = 0, smallest_ratio = infinity;
  for (const RollerRow& row : rollers)
    for (const ContactRow* at : {&row.inner, &row.outer}) {
      highest_Pa = std::max(highest_Pa, at->hertz_pressure_Pa.value_or(0));
      smallest_ratio = std::min(smallest_ratio, at->lambda_ratio.value_or(smallest_ratio));
    }
  if (highest_Pa > steel_limit_Pa)
    notes.push_back(fmt::format("p_H = {} GPa is above 4 GPa: a numerical test, physically not steel",
                                plain(1e-9 * highest_Pa, 4)));
  if (smallest_ratio < 1)
    notes.push_back(fmt::format(
        "lambda ratio {} is below 1: the film is thinner than the roughness, which smooth surfaces do not see",
        plain(smallest_ratio, 3)));
}

}  // namespace ehd::note
