// SPDX-License-Identifier: GPL-3.0-or-later
// (i) Ten thousand random bearings. Every dry law balances all of them. The laws with films balance those in their
// domain, and refuse others with a reason. Every balance is checked by bisection. The error that a film curve states
// below its lightest contact is held against contacts there that the curve has not seen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

#include "bearing/equilibrium.hpp"
#include "contact/text.hpp"
#include "verification/bench/timing.hpp"
#include "verification/claim.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/bearing_check.hpp"
#include "verification/studies/draw.hpp"
#include "verification/studies/paper_statements.hpp"
#include "verification/studies/random_bearing.hpp"
#include "verification/studies/unseen_contacts.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

using std::numbers::pi;

constexpr unsigned first_seed = 20261122;
constexpr double thickest_L = box_largest_L;  ///< the contact solvers are made up to it
constexpr std::size_t most_messages = 20;
/// The curves of this many bearings are compared with unseen contacts. A verdict needs at least so many contacts.
constexpr std::size_t bearings_with_unseen = 500;
constexpr long fewest_unseen = 200;
/// After this many halvings the interval of ln(viscosity) is as small as its rounding.
constexpr int viscosity_halvings = 60;

/// The same bearing with rings that move against each other, which a film needs.
RandomBearing moving(RandomBearing drawn, unsigned seed) {
  if (bearing::sum_speed_m_per_s(drawn.geometry, drawn.speeds) > 0) return drawn;
  Draw draw(seed ^ 0x70b17u);
  drawn.speeds = bearing::speeds_from_rpm(draw.logarithmic(30, 3000), 0);
  drawn.loading.centrifugal_N = bearing::centrifugal_force_N(drawn.geometry, drawn.speeds);
  return drawn;
}

/// The drawn bearing as a case, with an oil of its own: as thick as drawn, or as L allows at its speed.
Case case_of(const RandomBearing& drawn, unsigned seed) {
  Draw draw(seed ^ 0x5eedu);
  Lubricant oil;
  oil.viscosity = draw.integer(0, 3) == 0 ? ViscosityLaw::barus : ViscosityLaw::roelands;
  oil.density = draw.integer(0, 1) == 0 ? DensityLaw::incompressible : DensityLaw::dowson_higginson;
  BearingCase body;
  body.geometry = drawn.geometry;
  body.ring_thickness_m = drawn.contact.ring_thickness_m;
  constexpr double rpm_per_rad_per_s = 30 / pi;
  body.operation = {.inner_speed_rpm = drawn.speeds.inner_rad_per_s * rpm_per_rad_per_s,
                    .outer_speed_rpm = drawn.speeds.outer_rad_per_s * rpm_per_rad_per_s,
                    .radial_load_N = drawn.loading.radial_N};
  body.modulus_Pa = drawn.contact.modulus_Pa;
  body.poisson = drawn.contact.poisson;
  // Real oils have z from 0.35 to 0.8, and alpha follows from it. Where L would be above 30, a thinner oil is taken.
  const double z = draw.uniform(0.35, 0.8), E = bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson);
  const double u = bearing::sum_speed_m_per_s(drawn.geometry, drawn.speeds);
  const double R = std::min(bearing::reduced_radius_m(drawn.geometry, bearing::Raceway::inner),
                            bearing::reduced_radius_m(drawn.geometry, bearing::Raceway::outer));
  const auto alpha = [&](double eta) { return z * (std::log(eta) + 9.67) / oil.p0_Pa; };
  const auto L = [&](double eta) { return alpha(eta) * E * std::pow(eta * u / (E * R), 0.25); };
  double eta = draw.logarithmic(2e-3, 0.2);
  const double target = draw.uniform(5, thickest_L);
  if (L(eta) > thickest_L) {
    double low = std::exp(-9.67), high = eta;  // alpha is 0 at the low end
    for (int k = 0; k < viscosity_halvings; ++k) {
      const double middle = std::sqrt(low * high);
      (L(middle) < target ? low : high) = middle;
    }
    eta = high;
  }
  oil.alpha_per_Pa = alpha(eta);
  body.lubricant = BearingLubricant{.lubricant = oil, .viscosity_Pa_s = eta};
  Case one;
  one.id = fmt::format("random-{}", seed);
  one.version = 1;
  one.body = std::move(body);
  return one;
}

/// Why a bearing is outside the domain of the laws with films; empty where it is inside. The domain, from the stated
/// numbers alone: rings that move against each other, L up to 30 and M up to 5000 at both raceways, p_H up to 4 GPa at
/// the heaviest contact of the dry balance, and palmgren's datum above the half width of that contact.
std::string outside_films_domain(const RandomBearing& drawn, const BearingCase& body) {
  const double u = bearing::sum_speed_m_per_s(drawn.geometry, drawn.speeds);
  if (!(u > 0)) return "rings at rest against each other";
  const double E = bearing::reduced_modulus_Pa(body.modulus_Pa, body.poisson), eta = body.lubricant->viscosity_Pa_s;
  const auto palmgren = bearing::palmgren_law(drawn.geometry.length_m);
  const auto dry = bearing::balance(drawn.geometry, {palmgren, palmgren}, drawn.loading);
  if (!std::holds_alternative<bearing::Equilibrium>(dry)) return "no dry balance";
  double inner_N = 0;
  for (const auto& roller : std::get<bearing::Equilibrium>(dry).rollers)
    inner_N = std::max(inner_N, roller.inner.force_N);
  // Without a roller load palmgren's datum is met at the centrifugal force.
  const double datum_N = inner_N > 0 ? inner_N : drawn.loading.centrifugal_N;
  for (const auto raceway : bearing::both_raceways) {
    const double R = bearing::reduced_radius_m(drawn.geometry, raceway), l = drawn.geometry.length_m;
    const double force_N = raceway == bearing::Raceway::inner ? inner_N : inner_N + drawn.loading.centrifugal_N;
    const double U = eta * u / (E * R), w = force_N / l;
    if (*body.lubricant->lubricant.alpha_per_Pa * E * std::pow(U, 0.25) > thickest_L) return "L above 30";
    if (w / (E * R) / std::sqrt(U) > box_heaviest_M) return "M above 5000";
    if (std::sqrt(w * E / (2 * pi * R)) > highest_pressure_Pa) return "p_H above 4 GPa";
    // x_0 of palmgren's datum: (4w/(pi E')) [ln(2 x_0/b) + 1/2] = delta
    if (!(datum_N > 0)) continue;
    const double b = std::sqrt(8 * w * R / (pi * E)), w_0 = datum_N / l, b_0 = std::sqrt(8 * w_0 * R / (pi * E));
    const double x_0 = b_0 / 2 * std::exp(palmgren.approach(datum_N) / (4 * w_0 / (pi * E)) - 0.5);
    if (x_0 < b) return "datum below the half width";
  }
  return "";
}

struct Outcome {
  bool balanced = false;
  bool missed = false;  ///< balanced, but a contact missed its tolerance
  bool limit = false;   ///< refused because a solve came to its limit, which no domain excuses
  bool late = false;    ///< it was the time limit
  double balance = 0, bisection = 0, wall_s = 0;
  long solves = 0;
  UnseenContacts unseen;
  std::string why, outside;
};

/// Balances again with the laws, compares the displacement with that returned before, and checks by bisection.
void check(Outcome& outcome, const RandomBearing& drawn, const bearing::LawPair& laws,
           std::optional<double> displacement_m) {
  const Stopwatch watch;
  const auto found = bearing::balance(drawn.geometry, laws, drawn.loading);
  outcome.wall_s += watch.seconds();
  if (const auto* none = std::get_if<bearing::NoEquilibrium>(&found)) {
    outcome.why = none->why;
    return;
  }
  const auto& ring = std::get<bearing::Equilibrium>(found);
  outcome.balanced = true;
  outcome.balance = ring.balance_error;
  outcome.bisection = worst_bisection_error(drawn.geometry, laws, drawn.loading, bearing::Form::plane, ring);
  if (displacement_m && *displacement_m != ring.displacement_m)  // the same laws must give the same bits
    outcome.bisection = std::numeric_limits<double>::quiet_NaN();
}

void meet(UnseenContacts& all, const UnseenContacts& more) {
  all.contacts += more.contacts;
  all.worst = worse(all.worst, more.worst);
}

/// By every law with films; `with_unseen`: its curves against unseen contacts too.
std::vector<Outcome> of_films(const RandomBearing& at_any_speed, unsigned seed, bool with_unseen) {
  RandomBearing drawn = moving(at_any_speed, seed);
  const Case one = case_of(drawn, seed);
  const auto& body = std::get<BearingCase>(one.body);
  // The speeds of the case, which are rounded by its rotations a minute.
  drawn.speeds = bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm);
  drawn.loading.centrifugal_N = bearing::centrifugal_force_N(drawn.geometry, drawn.speeds);
  Request request = bearing_contact_request();
  request.time_limit_s = 20;
  ContactMemory memory(default_solver().solve, request);
  std::vector<Outcome> outcomes;
  for (const bearing::Law law : film_laws()) {
    Outcome& outcome = outcomes.emplace_back();
    outcome.outside = outside_films_domain(drawn, body);
    const auto results = run_bearing(one, {.laws = {law}, .explicitly = true, .films = false}, memory);
    if (results.empty() || results[0].rollers.empty()) {
      outcome.why = results.empty() ? "no result" : results[0].why;
      outcome.limit = !results.empty() && results[0].status == StopReason::limit_reached;
      outcome.late = outcome.limit && out_of_time(results[0].status, results[0].wall_s, request.time_limit_s);
      continue;
    }
    outcome.missed = results[0].status != StopReason::converged;
    outcome.why = results[0].why;
    outcome.wall_s = results[0].wall_s;
    outcome.solves = results[0].contact_solves;
    const auto pair = laws_of(body, results[0]);
    if (pair) check(outcome, drawn, *pair, results[0].displacement_m);
    if (with_unseen && results[0].curve)
      for (const auto raceway : bearing::both_raceways)
        meet(outcome.unseen, unseen_below(results[0].curve->at(raceway), body.lubricant->lubricant));
  }
  return outcomes;
}

void add(BearingRow& row, const Outcome& outcome, const std::string& name) {
  ++row.tried;
  row.wall_s += outcome.wall_s;
  row.slowest_s = std::max(row.slowest_s, outcome.wall_s);
  row.contact_solves += outcome.solves;
  row.unseen += outcome.unseen.contacts;
  row.worst_unseen = worse(row.worst_unseen, outcome.unseen.worst);
  const auto tell = [&] {
    if (row.inside.size() < most_messages) row.inside.push_back(name + ": " + outcome.why);
  };
  if (outcome.balanced) {
    ++(outcome.missed ? row.missed : row.balanced);
    if (outcome.missed && outcome.outside.empty()) {
      ++row.missed_inside;
      tell();
    }
    row.worst_balance = worse(row.worst_balance, outcome.balance);
    row.worst_bisection = worse(row.worst_bisection, outcome.bisection);
    return;
  }
  if (outcome.limit) {
    ++row.limits;
    row.late += outcome.late ? 1 : 0;
    tell();
  } else if (outcome.outside.empty()) {
    ++row.refused_inside;
    tell();
  } else {
    ++row.refused_outside;
    const auto same_kind = [&](const std::string& reason) { return reason.starts_with(outcome.outside); };
    if (std::none_of(row.reasons.begin(), row.reasons.end(), same_kind))
      row.reasons.push_back(fmt::format("{} ({}: {})", outcome.outside, name, outcome.why));
  }
}

}  // namespace

std::vector<BearingRow> run_bearings(const Scope& scope) {
  const std::size_t bearings = scope.quick ? 200 : 10000, with_films = scope.quick ? 16 : 10000;
  const auto dry = laws_of(bearing::Laws::dry);
  std::vector<std::vector<Outcome>> outcomes(bearings);  // of each the dry laws first
  std::mutex lock;
  std::size_t done = 0;
  in_threads(bearings, scope.threads, [&](std::size_t i) {
    const unsigned seed = first_seed + static_cast<unsigned>(i);
    const RandomBearing drawn = random_bearing(seed);
    for (const bearing::Law law : dry)
      check(outcomes[i].emplace_back(), drawn, dry_laws(law, drawn.contact), std::nullopt);
    if (i < with_films)
      for (Outcome& outcome : of_films(drawn, seed, i < bearings_with_unseen))
        outcomes[i].push_back(std::move(outcome));
    const std::lock_guard guard(lock);
    if (++done % 100 == 0) scope.show(fmt::format("random bearings: {} of {}", done, bearings));
  });
  std::vector<BearingRow> rows;
  for (const bearing::Law law : dry) rows.push_back({.law = std::string(to_string(law))});
  for (const bearing::Law law : film_laws()) rows.push_back({.law = std::string(to_string(law))});
  for (std::size_t i = 0; i < bearings; ++i)
    for (std::size_t k = 0; k < outcomes[i].size(); ++k)
      add(rows[k], outcomes[i][k], fmt::format("seed {}", first_seed + i));
  return rows;
}

Part judge_bearings(const std::vector<BearingRow>& rows) {
  Part part{.id = "i",
            .name = "bearings",
            .question = "Do random bearings balance under every law, and is every balance one?"};
  const Tolerance balance = Tolerance::required(1e-12, "of the larger of the load and the sum of the roller forces");
  part.tolerance = balance;
  part.settings = {{"first_seed", first_seed}};
  part.table.columns = columns_of(
      "law | tried | balanced | refused outside the domain | refused inside | ended by a limit | tolerance missed | "
      "worst balance error | worst against bisection | contact solves | unseen contacts | worst error over stated | "
      "mean [ms] | slowest [ms] | why outside");
  Tally tally;
  std::vector<std::string> inside;
  long all = 0, balanced = 0;
  for (const BearingRow& row : rows) {
    all += row.tried;
    balanced += row.balanced;
    const auto law = bearing::law_from(row.law);
    std::string reasons;
    for (const std::string& one : row.reasons) reasons += (reasons.empty() ? "" : "; ") + one;
    part.table.rows.push_back({row.law, row.tried, row.balanced, row.refused_outside, row.refused_inside, row.limits,
                               row.missed, row.worst_balance, row.worst_bisection, row.contact_solves, row.unseen,
                               row.worst_unseen, 1e3 * row.wall_s / static_cast<double>(std::max(1L, row.tried)),
                               1e3 * row.slowest_s, reasons});
    tally.add(row.worst_balance, 0, balance, row.law + ", balance error");
    tally.add(row.worst_bisection, 0, balance, row.law + ", against bisection");
    if (!law || !needs_film(*law)) {
      tally.require(row.tried > 0 && row.balanced == row.tried,
                    fmt::format("{}: {} of {} balance", row.law, row.balanced, row.tried));
    } else {
      // At least 99 % of all tried balance, so that a narrow domain cannot hide refusals. No refused one lies inside
      // it.
      constexpr double least_share = 0.99;
      tally.require(row.tried > 0 && static_cast<double>(row.balanced) >= least_share * static_cast<double>(row.tried),
                    fmt::format("{}: {} of {} balance", row.law, row.balanced, row.tried));
      tally.require(row.refused_inside == 0,
                    fmt::format("{}: {} refused inside the domain", row.law, row.refused_inside));
      tally.add(holds_in_time(row.limits == 0, row.limits == row.late),
                fmt::format("{}: {} ended by a limit", row.law, row.limits));
      tally.require(row.missed_inside == 0,
                    fmt::format("{}: {} with contacts that missed their tolerance, inside the domain", row.law,
                                row.missed_inside));
    }
    if (law && std::holds_alternative<bearing::FromCurves>(bearing::row_of(*law).make)) {
      tally.require(row.unseen >= fewest_unseen,
                    fmt::format("{}: {} unseen contacts below the curves", row.law, row.unseen));
      tally.require(row.worst_unseen <= 1,
                    fmt::format("{}: an unseen contact is {} times the stated error off its curve", row.law,
                                plain(row.worst_unseen, 3)));
    }
    for (const std::string& one : row.inside) inside.push_back(row.law + ", " + one);
  }
  tally.close(part);
  part.failures.insert(part.failures.end(), inside.begin(), inside.end());
  part.summary =
      fmt::format("{} of {} balances found; {} of {} requirements met", balanced, all, tally.passed(), tally.judged());
  return part;
}

}  // namespace ehd::verification::stress
