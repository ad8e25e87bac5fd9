// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_curve.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <variant>
#include <vector>

#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"

namespace ehd {

using bearing::BothRaceways;
using bearing::Equilibrium;
using bearing::FilmCurve;
using bearing::RacewayContact;
using bearing::SharedCurve;

namespace {

/// A curve that a balance goes beyond is extended at most this often.
constexpr int most_extensions = 8;
/// An extended curve reaches beyond the largest load by this factor, a first curve beyond the dry load by the other.
constexpr double extension_margin = 1.1, dry_margin = 1.05;

/// The contacts of the fit, where the case itself states them: the curve then shares them. With a range that follows
/// the dry balance every load and clearance would have a curve of its own.
std::vector<double> stated_fit_N(const BearingCase& body) {
  if (!body.fit.load_N) return {};
  return bearing::fit_forces_N(body.fit.load_N->first, body.fit.load_N->second, body.fit.points);
}

SharedCurve curve_of(const BearingSetup& setup, const RacewayContact& contact, double heaviest_N,
                     ContactMemory& memory) {
  const auto& curve = memory.curve(contact, setup.body.lubricant->lubricant,
                                   {.heaviest_N = heaviest_N, .given_N = stated_fit_N(setup.body)});
  if (const auto* failure = std::get_if<bearing::SolveFailure>(&curve)) throw LawFailure(*failure);
  return std::make_shared<const FilmCurve>(std::get<FilmCurve>(curve));
}

bearing::LawPair laws_from(const BothRaceways<SharedCurve>& curves, bearing::FromCurves make,
                           const BothRaceways<double>& datum_m) {
  try {
    return make(curves, datum_m);
  } catch (const std::domain_error& error) {
    throw LawFailure(error.what());
  }
}

double largest_force_N(const std::vector<Equilibrium>& positions) {
  double largest = 0;
  for (const Equilibrium& ring : positions)
    for (const bearing::RollerState& roller : ring.rollers)
      largest = std::max({largest, roller.inner.force_N, roller.outer.force_N});
  return largest;
}

/// The error of dF_r/d(delta_r) = Sum k cos^2(psi), where k is the stiffness of a roller. k is two contacts in series,
/// so that its relative error is at most that of the worse contact.
double stiffness_error_N_per_m(const Equilibrium& ring, const BothRaceways<SharedCurve>& curves) {
  double sum = 0;
  for (std::size_t j = 0; j < ring.rollers.size(); ++j) {
    const bearing::RollerState& roller = ring.rollers[j];
    const double cosine = std::cos(ring.azimuths_deg[j] * std::numbers::pi / 180);
    const double error = std::max(curves.inner->compliance_error(roller.inner.force_N),
                                  curves.outer->compliance_error(roller.outer.force_N));
    sum += bearing::force_error_by_datum * error * roller.stiffness_N_per_m * cosine * cosine;
  }
  return sum;
}

void note_curve(BearingResult& result, bearing::Raceway raceway) {
  const double lightest_N = result.curve->at(raceway).lightest_N();
  const auto below = std::count_if(result.rollers.begin(), result.rollers.end(),
                                   [&](const RollerRow& row) { return row.at(raceway).force_N < lightest_N; });
  result.notes.push_back(note::Curve{.raceway = raceway, .contacts_below = below});
}

}  // namespace

double force_at_M_1_N(const RacewayContact& contact) {
  const double width = contact.reduced_modulus_Pa * contact.reduced_radius_m;
  return contact.length_m * std::sqrt(contact.viscosity_Pa_s * contact.speed_sum_m_per_s * width);
}

double first_reach_N(const BearingSetup& setup, double largest_dry_N) {
  // Where every roller is light the curve still begins at M = 1: lighter contacts follow from solved ones, and below
  // M = 1e-3 none can be solved.
  return std::max({dry_margin * (largest_dry_N + setup.loading.centrifugal_N), force_at_M_1_N(setup.contacts.inner),
                   force_at_M_1_N(setup.contacts.outer)});
}

BothRaceways<SharedCurve> curves_of(const BearingSetup& setup, double reach_N, ContactMemory& memory) {
  return {curve_of(setup, setup.contacts.inner, reach_N, memory),
          curve_of(setup, setup.contacts.outer, reach_N, memory)};
}

void fill_films(BearingResult& result, const BothRaceways<SharedCurve>& curves) {
  for (RollerRow& row : result.rollers) {
    if (row.inner.force_N > 0) row.inner.film_minimum_m = curves.inner->minimum_film(row.inner.force_N).value;
    if (row.outer.force_N > 0) row.outer.film_minimum_m = curves.outer->minimum_film(row.outer.force_N).value;
  }
  result.curve = BothRaceways<FilmCurve>{*curves.inner, *curves.outer};
}

void run_curve_law(BearingResult& result, const BearingSetup& setup, bearing::FromCurves make, double largest_dry_N,
                   ContactMemory& memory) {
  double reach_N = first_reach_N(setup, largest_dry_N);
  for (int extension = 0; extension < most_extensions; ++extension) {
    const BothRaceways<SharedCurve> curves = curves_of(setup, reach_N, memory);
    const auto positions = balance_all_positions(setup, laws_from(curves, make, *result.datum_m));
    const double largest = largest_force_N(positions);
    if (largest > std::min(curves.inner->heaviest_N(), curves.outer->heaviest_N())) {
      reach_N = extension_margin * std::max(largest, reach_N);
      continue;
    }
    fill_balance(result, setup, positions);
    result.stiffness_error_N_per_m = stiffness_error_N_per_m(positions.front(), curves);
    fill_films(result, curves);
    note_curve(result, bearing::Raceway::inner);
    note_curve(result, bearing::Raceway::outer);
    note_oil(result, setup);
    return;
  }
  throw LawFailure("the roller loads grow beyond every solved contact; the datum or the load is out of reach");
}

}  // namespace ehd
