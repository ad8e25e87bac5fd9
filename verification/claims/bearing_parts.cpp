// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11, the parts of a bearing: kinematics, datum, fit, film curve, energy, dry laws, stiffness, statics at light
// load, random bearings, and infinitely many rollers. Expected values come from the printed formulas, written out here
// once more, and from contacts solved by `reference` in SI, never from bearing/'s own functions.
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/martin.hpp"
#include "verification/exact/sjovall.hpp"
#include "verification/studies/bearing_check.hpp"
#include "verification/studies/fits.hpp"
#include "verification/studies/random_bearing.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A raceway of the case from its own numbers: no slip at either, so that the contact point's surfaces both run at
/// |w_ring - w_cage| r_ring past it.
struct ByHand {
  double radius_m, modulus_Pa, sum_speed_m_per_s, length_m;
};
ByHand by_hand(const BearingCase& body, bool inner) {
  const auto& g = body.geometry;
  const double raceway =
      inner ? (g.pitch_diameter_m - g.roller_diameter_m) / 2 : (g.pitch_diameter_m + g.roller_diameter_m) / 2;
  const double w_inner = body.operation.inner_speed_rpm * pi / 30, w_outer = body.operation.outer_speed_rpm * pi / 30;
  // The cage goes as the roller's centre, which is half way between two points that move with the rings.
  const double inner_surface = w_inner * (g.pitch_diameter_m - g.roller_diameter_m) / 2;
  const double outer_surface = w_outer * (g.pitch_diameter_m + g.roller_diameter_m) / 2;
  const double cage = (inner_surface + outer_surface) / g.pitch_diameter_m;
  const double ring = inner ? w_inner : w_outer, roller = g.roller_diameter_m / 2;
  return {.radius_m = inner ? roller * raceway / (raceway + roller) : roller * raceway / (raceway - roller),
          .modulus_Pa = body.modulus_Pa / (1 - body.poisson * body.poisson),
          .sum_speed_m_per_s = 2 * std::abs(ring - cage) * raceway,
          .length_m = g.length_m};
}

/// 4w/(pi E'), and b.
double scale_m(const ByHand& contact, double force_N) {
  return 4 * force_N / contact.length_m / (pi * contact.modulus_Pa);
}
double half_width_m(const ByHand& contact, double force_N) {
  return std::sqrt(8 * force_N / contact.length_m * contact.radius_m / (pi * contact.modulus_Pa));
}

Sentence sentence(const std::string& id, const std::string& statement) {
  return {.id = "bearing/" + id, .rung = 11, .statement = statement};
}

// A dozen products, roots and powers of inputs known to half an ulp.
Tolerance rounding() { return Tolerance::round_off(64); }

// ---- Kinematics --------------------------------------------------------------------------------------------------

/// What the solver is asked, by contact: groups and lubricant, seen through a solver that writes them down.
Findings judge_contacts_asked(const Case& bearing_case) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  std::vector<MoesGroups> asked;
  ContactMemory memory([&](const Problem& problem, const Request& request) {
    asked.push_back({problem.groups.M, problem.groups.L});
    return find_solver("fast")->solve(problem, request);
  });
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd_linear}, .films = false}, memory);
  std::vector<MoesGroups> expected;
  const auto [lowest, highest] = body.fit.load_N.value_or(std::pair(nothing, nothing));
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const double U =
        body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s / (contact.modulus_Pa * contact.radius_m);
    for (int i = 0; i < body.fit.points; ++i) {
      const double force = lowest + (highest - lowest) * i / (body.fit.points - 1);
      expected.push_back(
          {force / contact.length_m / (contact.modulus_Pa * contact.radius_m) / std::sqrt(U),
           body.lubricant->lubricant.alpha_per_Pa.value_or(nothing) * contact.modulus_Pa * std::sqrt(std::sqrt(U))});
    }
  }
  // Each expected contact once among those asked, whatever the order.
  double worst = asked.size() == expected.size() ? 0 : nothing;
  for (const MoesGroups& wanted : expected) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const MoesGroups& one : asked)
      nearest = std::min(nearest, worse(std::abs(one.M / wanted.M - 1), std::abs(one.L / wanted.L - 1)));
    worst = worse(worst, nearest);
  }
  Findings found;
  found.claims.push_back(
      claim(sentence("kinematics/" + bearing_case.id + "/contacts",
                     bearing_case.id + ": the contacts solved for the fit have the M and L of both raceways, "
                                       "equally spaced in force"),
            worst, 0, rounding(), std::to_string(asked.size()) + " contacts"));
  return found;
}

Findings judge_kinematics(const Case& na4908) {
  const auto& body = std::get<BearingCase>(na4908.body);
  Findings found;
  const auto add = [&](const std::string& id, const std::string& statement, double value, double expected) {
    found.claims.push_back(claim_value(sentence("kinematics/" + id, statement), value, expected, 0, rounding()));
  };
  const auto printed = [&](const std::string& id, const std::string& statement, double value,
                           const std::string& digits) {
    found.claims.push_back(claim_value(sentence("kinematics/" + id, statement + " " + digits), value, std::stod(digits),
                                       0, Tolerance::published_digits(digits)));
  };
  const bearing::Geometry geometry = geometry_of(body);
  printed("na4908/inner-radius", "the inner contacts of NA4908 have R [mm] =",
          1e3 * bearing::reduced_radius_m(geometry, bearing::Raceway::inner), "2.264");
  printed("na4908/outer-radius", "the outer contacts of NA4908 have R [mm] =",
          1e3 * bearing::reduced_radius_m(geometry, bearing::Raceway::outer), "2.736");
  printed("na4908/speed", "the surfaces in NA4908's contacts have the sum speed [m/s]",
          bearing::sum_speed_m_per_s(geometry, bearing::speeds_from_rpm(5000, 0)), "13.75");
  const struct {
    const char* name;
    double inner_rpm, outer_rpm;
  } turns[] = {{"inner", 5000, 0}, {"outer", 0, 3100}, {"both", 4200, 1300}, {"against", 2100, -900}};
  for (const auto& turn : turns) {
    BearingCase turned = body;
    turned.operation.inner_speed_rpm = turn.inner_rpm;
    turned.operation.outer_speed_rpm = turn.outer_rpm;
    const auto speeds = bearing::speeds_from_rpm(turn.inner_rpm, turn.outer_rpm);
    const std::string ring = turn.name, who = ring == "both"      ? "both rings turning"
                                              : ring == "against" ? "rings turning against each other"
                                                                  : "the " + ring + " ring turning";
    for (const bool inner : {true, false})
      add(ring + (inner ? "/inner" : "/outer") + "/speed",
          std::string("rolling without slip gives the sum speed at the ") + (inner ? "inner" : "outer") + " raceway, " +
              who,
          bearing::sum_speed_m_per_s(geometry, speeds), by_hand(turned, inner).sum_speed_m_per_s);
    const double cage =
        (turn.inner_rpm * 48 + turn.outer_rpm * 58) / 106 * pi / 30;  // r_i : r_o = 48 : 58, d_m = 53 mm
    add(ring + "/cage", "the cage goes as the rollers' centres, " + who,
        bearing::cage_speed_rad_per_s(geometry, speeds), cage);
    const double mass = 7850 * pi / 4 * 0.005 * 0.005 * 0.122;
    add(ring + "/centrifugal", "a roller's mass and the cage's speed make the centrifugal force, " + who,
        bearing::centrifugal_force_N(geometry, speeds), mass * 0.053 / 2 * cage * cage);
  }
  return found;
}

// ---- Datum, fit, curve -------------------------------------------------------------------------------------------

/// f in N and delta in m by Palmgren, as rounded in print.
double palmgren_m(double force_N, double length_m) {
  return 1e-3 * std::pow(force_N / (8.06e4 * std::pow(1e3 * length_m, 8.0 / 9)), 0.9);
}
double dry_m(const ByHand& contact, double force_N, double datum_m) {
  return scale_m(contact, force_N) * (std::log(2 * datum_m / half_width_m(contact, force_N)) + 0.5);
}

/// Film and approach of one roller contact by `reference`, from SI.
struct SolvedByHand {
  double offset_film_m = nothing;  ///< delta_dry - delta, whatever the datum
  double film_minimum_m = nothing;
};
SolvedByHand solved_by_hand(const BearingCase& body, bool inner, double force_N) {
  const ByHand contact = by_hand(body, inner);
  const Conditions conditions{.load_N_per_m = force_N / contact.length_m,
                              .reduced_radius_m = contact.radius_m,
                              .reduced_modulus_Pa = contact.modulus_Pa,
                              .speed_sum_m_per_s = contact.sum_speed_m_per_s,
                              .viscosity_Pa_s = body.lubricant->viscosity_Pa_s};
  const Solution solution =
      find_solver("reference")
          ->solve(nondimensionalise(conditions, body.lubricant->lubricant, Flooded{}).problem, {.tolerance = 1e-6});
  if (solution.record.status != StopReason::converged) return {};
  const double b = half_width_m(contact, force_N), unit = b * b / contact.radius_m;
  constexpr double dry_offset = -0.25 - std::numbers::ln2 / 2;
  return {.offset_film_m = unit * (solution.observables.at(Quantity::film_offset).value - dry_offset),
          .film_minimum_m = unit * solution.observables.at(Quantity::film_minimum).value};
}

Findings judge_datum(const Case& bearing_case, ContactMemory& memory) {
  Findings found;
  const auto run = [&](const Datum& datum) {
    Case one = bearing_case;
    std::get<BearingCase>(one.body).datum = datum;
    return run_bearing(one, {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear}, .films = false}, memory);
  };
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto datum_of = [](const std::vector<BearingResult>& results, bool inner) {
    if (results.size() != 2 || !results[1].datum_m) return nothing;
    return inner ? results[1].datum_m->inner : results[1].datum_m->outer;
  };
  constexpr double named_N = 7300, length_m = 0.0173;
  const auto by_default = run(PalmgrenDatum{}), named = run(PalmgrenDatum{named_N}), lundberg = run(LundbergDatum{}),
             stated = run(LengthDatum{length_m});
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const std::string raceway = inner ? "inner" : "outer";
    double largest = nothing;
    if (!by_default.empty() && !by_default[0].rollers.empty()) {
      largest = 0;
      for (const RollerRow& roller : by_default[0].rollers) largest = std::max(largest, roller.inner.force_N);
    }
    for (const auto& [name, results, force] :
         {std::tuple{"palmgren", &by_default, largest}, std::tuple{"palmgren-load", &named, named_N}}) {
      found.claims.push_back(claim_value(
          sentence(std::string("datum/") + name + "/" + raceway,
                   "with Palmgren's datum the dry log kernel has Palmgren's approach at the " +
                       std::string(name == std::string("palmgren") ? "largest dry roller load" : "load that is named") +
                       ", " + raceway + " raceway"),
          dry_m(contact, force, datum_of(*results, inner)), palmgren_m(force, contact.length_m), 0,
          Tolerance::round_off(64, 20), "the datum is the exponential of twenty"));
    }
    found.claims.push_back(claim_value(
        sentence("datum/lundberg/" + raceway, "Lundberg's datum is the length of the roller, " + raceway + " raceway"),
        datum_of(lundberg, inner), contact.length_m, 0, rounding()));
    found.claims.push_back(
        claim_value(sentence("datum/x0/" + raceway, "a datum that is stated is used, " + raceway + " raceway"),
                    datum_of(stated, inner), length_m, 0, rounding()));
  }
  return found;
}

// What `fast` is asked for in a bearing (1e-4 of the films), ten times: an offset film is a film and a bit more.
Tolerance film_tolerance() {
  return Tolerance::required(1e-3, "ten times the 1e-4 that a bearing asks of its contacts");
}

Findings judge_fit(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd_linear}, .films = true}, memory);
  Findings found;
  for (const bool inner : {true, false}) {
    const std::string raceway = inner ? "inner" : "outer";
    const ByHand contact = by_hand(body, inner);
    const bool fitted = results.size() == 1 && results[0].fit && results[0].datum_m;
    double points_error = fitted ? 0 : nothing, line_error = nothing, K = nothing, dF = nothing, spread_error = nothing;
    int solved = 0;
    if (fitted) {
      const auto& fit = inner ? results[0].fit->inner : results[0].fit->outer;
      const double datum = inner ? results[0].datum_m->inner : results[0].datum_m->outer;
      K = fit.K_N_per_m;
      dF = fit.dF_N;
      double sx = 0, sy = 0, sxx = 0, sxy = 0;
      for (const auto& point : fit.points) {
        sx += point.approach_m, sy += point.force_N, sxx += point.approach_m * point.approach_m,
            sxy += point.approach_m * point.force_N;
        const double film = solved_by_hand(body, inner, point.force_N).offset_film_m;
        points_error =
            worse(points_error, std::abs((dry_m(contact, point.force_N, datum) - point.approach_m) / film - 1));
        ++solved;
      }
      const double n = static_cast<double>(fit.points.size()), slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
      line_error = worse(std::abs(K / slope - 1), std::abs(dF / ((sy - slope * sx) / n) - 1));
      double largest = 0, squares = 0;
      for (const auto& point : fit.points) {
        const double off = point.force_N - (slope * point.approach_m + (sy - slope * sx) / n);
        largest = std::max(largest, std::abs(off));
        squares += off * off;
      }
      spread_error = worse(std::abs(fit.residual_N / largest - 1),
                           std::abs(fit.standard_deviation_N / std::sqrt(squares / (n - 2)) - 1));
    }
    found.claims.push_back(
        claim(sentence("fit/" + bearing_case.id + "/" + raceway + "/points",
                       "the points of the fit are delta_dry less the film that `reference` finds at their loads, " +
                           raceway + " raceway"),
              points_error, 0, film_tolerance(), std::to_string(solved) + " contacts, relative to the offset film"));
    found.claims.push_back(
        claim(sentence("fit/" + bearing_case.id + "/" + raceway + "/line",
                       "K and dF are the least squares of f on delta through them, " + raceway + " raceway"),
              line_error, 0, Tolerance::round_off(64, 1e4), "sums of six products; n Sxx - Sx^2 cancels two digits"));
    found.claims.push_back(claim(sentence("fit/" + bearing_case.id + "/" + raceway + "/spread",
                                          "the residual is the largest distance from the line, the deviation that of "
                                          "points - 2 degrees of freedom, " +
                                              raceway + " raceway"),
                                 spread_error, 0, Tolerance::round_off(64, 1e6),
                                 "a distance is a hundredth of the force"));
    double pressure_error = fitted && !results[0].rollers.empty() ? 0 : nothing, film_error = pressure_error;
    int loaded = 0;
    for (const RollerRow& roller : fitted ? results[0].rollers : std::vector<RollerRow>{}) {
      const ContactRow& row = inner ? roller.inner : roller.outer;
      if (!(row.force_N > 2000) || roller.azimuth_deg < 0) continue;  // where the line was fitted, one of each pair
      pressure_error = worse(pressure_error, std::abs(row.hertz_pressure_Pa.value_or(nothing) /
                                                          std::sqrt(row.force_N / contact.length_m *
                                                                    contact.modulus_Pa / (2 * pi * contact.radius_m)) -
                                                      1));
      film_error = worse(
          film_error,
          std::abs(row.film_minimum_m.value_or(nothing) / solved_by_hand(body, inner, row.force_N).film_minimum_m - 1));
      ++loaded;
    }
    found.claims.push_back(claim(sentence("fit/" + bearing_case.id + "/" + raceway + "/pressure",
                                          "the rollers' p_H are sqrt(f E'/(2 pi R l)), " + raceway + " raceway"),
                                 loaded > 0 ? pressure_error : nothing, 0, rounding()));
    found.claims.push_back(
        claim(sentence("fit/" + bearing_case.id + "/" + raceway + "/film",
                       "the rollers' films by `ehd-linear` are those that `reference` finds at their loads, " +
                           raceway + " raceway"),
              loaded > 0 ? film_error : nothing, 0, film_tolerance(), std::to_string(loaded) + " rollers"));
  }
  return found;
}

/// Rollers of a balance by the full relation, at heavy, medium and light loads.
Findings judge_curve(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .films = true}, memory);
  Findings found;
  const bool balanced = results.size() == 1 && !results[0].rollers.empty() && results[0].datum_m;
  for (const bool inner : {true, false}) {
    const ByHand contact = by_hand(body, inner);
    const std::string raceway = inner ? "inner" : "outer";
    double approach_error = balanced ? 0 : nothing, film_error = balanced ? 0 : nothing, martin_error = nothing;
    int judged = 0;
    if (balanced) {
      const double datum = inner ? results[0].datum_m->inner : results[0].datum_m->outer;
      double lightest = std::numeric_limits<double>::infinity();
      for (const RollerRow& roller : results[0].rollers) {
        const ContactRow& row = inner ? roller.inner : roller.outer;
        if (row.force_N >= lightest) continue;  // one of each pair, and the lightest last
        lightest = row.force_N;
        const SolvedByHand truth = solved_by_hand(body, inner, row.force_N);
        approach_error =
            worse(approach_error,
                  std::abs((dry_m(contact, row.force_N, datum) - row.displacement_m) / truth.offset_film_m - 1));
        film_error = worse(film_error, std::abs(row.film_minimum_m.value_or(nothing) / truth.film_minimum_m - 1));
        const double martin = exact::Martin{}.load_sum * body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s *
                              contact.radius_m * contact.length_m / row.force_N;
        martin_error = std::abs(row.film_minimum_m.value_or(nothing) / martin - 1);
        ++judged;
      }
    }
    // A hundredth of the lightest solved load: what is left of its few per cent there is a thousandth of them.
    double rigid_error = nothing;
    if (balanced && results[0].curve) {
      const bearing::FilmCurve& curve = inner ? results[0].curve->inner : results[0].curve->outer;
      const double force = curve.lightest_N() / 100;
      const double martin = exact::Martin{}.load_sum * body.lubricant->viscosity_Pa_s * contact.sum_speed_m_per_s *
                            contact.radius_m * contact.length_m / force;
      rigid_error = worse(std::abs(curve.minimum_film(force).value / martin - 1),
                          std::abs(curve.offset_film(force).value / martin - 1));
    }
    found.claims.push_back(claim(
        sentence("curve/" + bearing_case.id + "/" + raceway + "/rigid",
                 "far below its lightest contact the curve has the film of a rigid cylinder, " + raceway + " raceway"),
        rigid_error, 0, Tolerance::asymptotic(1e-3, "5 % x 100^(-3/2), and twenty times that")));
    const std::string about = std::to_string(judged) + " loads, of the heaviest to the lightest roller";
    found.claims.push_back(
        claim(sentence("curve/" + bearing_case.id + "/" + raceway + "/approach",
                       "a balance by `ehd` has the approaches that `reference` finds at its rollers' loads, " +
                           raceway + " raceway"),
              approach_error, 0, film_tolerance(), about));
    found.claims.push_back(claim(sentence("curve/" + bearing_case.id + "/" + raceway + "/film",
                                          "and the smallest films, " + raceway + " raceway"),
                                 film_error, 0, film_tolerance(), about));
    found.claims.push_back(claim(
        sentence("curve/" + bearing_case.id + "/" + raceway + "/martin",
                 "the lightest roller's film is nearly that of a rigid cylinder, " + raceway + " raceway"),
        martin_error, 0, Tolerance::asymptotic(0.05, "M < 0.1: elasticity and pressure add a few per cent at most")));
  }
  return found;
}

// ---- Energy ------------------------------------------------------------------------------------------------------

/// What a displaced ring has stored in its contacts, rollers balanced, less the work of the centrifugal force. Of a
/// film's law, which has stored without end at no force, what is stored from the roller's forces in `from` on, a step
/// away.
double energy_J(const bearing::Geometry& geometry, const bearing::LawPair& laws, double centrifugal_N, double along_m,
                double across_m, const std::vector<bearing::RollerState>& from) {
  const auto stored = [](const bearing::ForceLaw& law, const bearing::ContactState& at,
                         const bearing::ContactState& began) {
    if (at.force_N <= 0) return 0.0;
    if (std::holds_alternative<bearing::PowerLaw>(law)) return 9.0 / 19 * at.force_N * at.approach_m;
    if (const auto* film =
            std::get_if<bearing::CurveLaw>(&law)) {  // Int f d(delta) = [f delta] - Int delta df, by Simpson
      const double by_N = at.force_N - began.force_N, middle_m = film->approach(began.force_N + by_N / 2);
      return at.force_N * at.approach_m - began.force_N * began.approach_m -
             by_N / 6 * (began.approach_m + 4 * middle_m + at.approach_m);
    }
    const auto& line = std::get<bearing::LinearLaw>(law);
    return at.force_N * at.force_N / (2 * line.K_N_per_m);
  };
  double energy = 0;
  for (int j = 0; j < geometry.rollers; ++j) {
    const double psi = (geometry.first_azimuth_deg + 360.0 * j / geometry.rollers) * pi / 180;
    const auto roller = bearing::balance_roller(
        laws, centrifugal_N, along_m * std::cos(psi) + across_m * std::sin(psi) - geometry.clearance_m / 2);
    const auto& began = from[static_cast<std::size_t>(j)];
    energy += stored(laws.inner, roller.inner, began.inner) + stored(laws.outer, roller.outer, began.outer) -
              centrifugal_N * roller.outer.approach_m;
  }
  return energy;
}

void add_energy(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                const bearing::LawPair& laws, double centrifugal_N, double radial_N) {
  const auto balanced = bearing::balance(geometry, laws, {.radial_N = radial_N, .centrifugal_N = centrifugal_N});
  double along = nothing, across = nothing;
  if (const auto* ring = std::get_if<bearing::Equilibrium>(&balanced)) {
    const double x = ring->displacement_m, y = ring->lateral_displacement_m, h = 1e-5 * x;
    const auto slope = [&](double to_x, double to_y) {
      const auto E = [&](double steps) {
        return energy_J(geometry, laws, centrifugal_N, x + steps * h * to_x, y + steps * h * to_y, ring->rollers);
      };
      return (8 * (E(1) - E(-1)) - (E(2) - E(-2))) / (12 * h);
    };
    along = slope(1, 0);
    across = slope(0, 1);
  }
  // Fourth differences at 1e-5: nothing of the fifth derivative's part, eps/1e-5 of rounding; at the edge of the load
  // zone a roller's energy has a second derivative that jumps, and no roller is within 2e-5 of the displacement from
  // it.
  const Tolerance differences = Tolerance::discretisation(1e-7, 10);
  found.claims.push_back(claim_value(
      sentence("energy/" + name, "the radial load is the gradient of the energy stored in the contacts, law " + name),
      along, radial_N, 0, differences));
  found.claims.push_back(
      claim(sentence("energy/" + name + "/across",
                     "under a cage that is not symmetric the energy is least across the load, law " + name),
            std::abs(across) / radial_N, 0, differences));
}

Findings judge_energy() {
  const bearing::Geometry geometry{.rollers = 17,
                                   .pitch_diameter_m = 0.061,
                                   .roller_diameter_m = 0.0083,
                                   .length_m = 0.011,
                                   .clearance_m = 7e-6,
                                   .density_kg_per_m3 = 7810,
                                   .first_azimuth_deg = 4.3};
  constexpr double centrifugal_N = 31, radial_N = 8.7e3;
  const bearing::PowerLaw power = bearing::palmgren_law(geometry.length_m);
  const bearing::LinearLaw inner{.K_N_per_m = 3.3e8, .dF_N = 410}, outer{.K_N_per_m = 2.7e8, .dF_N = 530};
  Findings found;
  for (const auto& [name, pair] : {std::pair<std::string, bearing::LawPair>{"hertz", {power, power}},
                                   std::pair<std::string, bearing::LawPair>{"ehd-linear", {inner, outer}}})
    add_energy(found, name, geometry, pair, centrifugal_N, radial_N);
  return found;
}

// ---- Dry laws and the ring in the plane
// ------------------------------------------------------------------------------

constexpr bearing::Law printed_laws[] = {bearing::Law::hertz, bearing::Law::iso, bearing::Law::lundberg,
                                         bearing::Law::tripp, bearing::Law::houpert};

bearing::RollerContact some_contact() {
  return {.force_N = 0,
          .length_m = 0.017,
          .roller_diameter_m = 0.011,
          .pitch_diameter_m = 0.083,
          .modulus_Pa = 2.09e11,
          .poisson = 0.28,
          .ring_thickness_m = 0.0064};
}

/// Nine decades of force, to 4 GPa; of a film's law as far as it has solved contacts.
void add_law(Findings& found, const std::string& name, const bearing::LawPair& laws) {
  double slope_error = 0, inverse_error = 0;
  int forces = 0;
  const bool film = std::holds_alternative<bearing::CurveLaw>(laws.inner);
  for (const bearing::ForceLaw* one : {&laws.inner, &laws.outer})
    for (double f = 1e-4; f < 1e5; f *= 3.1) {
      if (std::holds_alternative<bearing::LinearLaw>(*one) && f < 1) continue;  // lost beside dF
      const auto* curve = std::get_if<bearing::CurveLaw>(one);
      if (curve && 1.01 * f > curve->curve().heaviest_N()) continue;
      const double delta = bearing::approach(*one, f), step = 1e-4 * f, shift = 1e-4 * f * bearing::compliance(*one, f);
      const double compliance = (bearing::approach(*one, f + step) - bearing::approach(*one, f - step)) / (2 * step);
      const double stiffness =
          (bearing::force(*one, delta + shift) - bearing::force(*one, delta - shift)) / (2 * shift);
      slope_error = worse(slope_error, std::abs(bearing::compliance(*one, f) / compliance - 1),
                          std::abs(bearing::stiffness(*one, delta) / stiffness - 1));
      inverse_error = worse(inverse_error, std::abs(bearing::force(*one, delta) / f - 1));
      ++forces;
    }
  const std::string about = std::to_string(forces) + " forces";
  // delta = -C/f of a light film has differences that are off by (step/f)^2, and a curve that bends by a few times
  // that.
  found.claims.push_back(claim(sentence("laws/" + name + "/slopes", "the slopes of the law " + name +
                                                                        " are those of its force and of its approach"),
                               slope_error, 0, Tolerance::discretisation(1e-8, film ? 10 : 1),
                               about + ", central differences of 1e-4"));
  found.claims.push_back(claim(
      sentence("laws/" + name + "/inverse", "the law " + name + " gives back the force that its approach came from"),
      inverse_error, 0, Tolerance::round_off(film ? 20 : 2, name == "ehd-linear" ? 1e3 : 50),
      about + (film
                   ? "; twenty operations behind a film and an approach, whose difference loses less than fifty of them"
                   : "; the logarithm of f over its coefficient is below 50, dF over f below 1000")));
}

Findings judge_dry_laws() {
  Findings found;
  for (const bearing::Law law : printed_laws)
    add_law(found, std::string(to_string(law)), dry_laws(law, some_contact()));
  add_law(found, "ehd-linear",
          {bearing::LinearLaw{.K_N_per_m = 3.3e8, .dF_N = 410}, bearing::LinearLaw{.K_N_per_m = 2.7e8, .dF_N = -90}});
  return found;
}

/// Sum f (cos, sin) of a ring that is put somewhere, from the rollers alone.
std::pair<double, double> ring_force_N(const bearing::Geometry& geometry, const bearing::LawPair& laws,
                                       double centrifugal_N, double along_m, double across_m) {
  std::pair<double, double> sum{0, 0};
  for (int j = 0; j < geometry.rollers; ++j) {
    const double psi = (geometry.first_azimuth_deg + 360.0 * j / geometry.rollers) * pi / 180;
    const double f =
        bearing::balance_roller(laws, centrifugal_N,
                                along_m * std::cos(psi) + across_m * std::sin(psi) - geometry.clearance_m / 2)
            .inner.force_N;
    sum.first += f * std::cos(psi);
    sum.second += f * std::sin(psi);
  }
  return sum;
}

/// The stiffness of a bearing against what its rollers and other balances give.
void add_stiffness(Findings& found, const std::string& name, const bearing::Geometry& geometry,
                   const bearing::LawPair& laws, double centrifugal_N, double radial_N) {
  const auto ring_of = [&](const bearing::Geometry& of, double load_N) -> std::optional<bearing::Equilibrium> {
    const auto result = bearing::balance(of, laws, {.radial_N = load_N, .centrifugal_N = centrifugal_N});
    const auto* ring = std::get_if<bearing::Equilibrium>(&result);
    return ring ? std::optional(*ring) : std::nullopt;
  };
  double forces_error = nothing, balances_error = nothing, reciprocity = nothing;
  if (const auto ring = ring_of(geometry, radial_N)) {
    const auto& K = ring->stiffness_N_per_m;
    const double x = ring->displacement_m, y = ring->lateral_displacement_m, h = 1e-5 * x;
    const auto slope = [&](double to_x, double to_y) {
      const auto more = ring_force_N(geometry, laws, centrifugal_N, x + h * to_x, y + h * to_y),
                 less = ring_force_N(geometry, laws, centrifugal_N, x - h * to_x, y - h * to_y);
      return std::pair{(more.first - less.first) / (2 * h), (more.second - less.second) / (2 * h)};
    };
    const auto along = slope(1, 0), across = slope(0, 1);
    forces_error = worse(worse(std::abs(along.first - K[0][0]), std::abs(along.second - K[1][0])),
                         worse(std::abs(across.first - K[0][1]), std::abs(across.second - K[1][1]))) /
                   K[0][0];
    // The inverse, by other balances: a load along changed by 1e-5, and as much across, which is the cage turned back.
    constexpr double part = 1e-5;
    const auto more = ring_of(geometry, radial_N * (1 + part)), less = ring_of(geometry, radial_N * (1 - part));
    const auto with_lateral = [&](double part_across) {
      const double angle = std::atan(part_across);
      bearing::Geometry turned = geometry;
      turned.first_azimuth_deg -= angle * 180 / pi;
      const auto seen = ring_of(turned, radial_N / std::cos(angle));
      return seen ? seen->displacement_m * std::cos(angle) - seen->lateral_displacement_m * std::sin(angle) : nothing;
    };
    if (more && less) {
      const double determinant = K[0][0] * K[1][1] - K[0][1] * K[0][1], unit = K[1][1] / determinant,
                   load = 2 * part * radial_N;
      const double gives_along = (more->displacement_m - less->displacement_m) / load,
                   gives_across = (more->lateral_displacement_m - less->lateral_displacement_m) / load;
      balances_error =
          worse(std::abs(gives_along - K[1][1] / determinant), std::abs(gives_across + K[0][1] / determinant)) / unit;
      reciprocity = std::abs((with_lateral(part) - with_lateral(-part)) / load - gives_across) / unit;
    }
  }
  // (h/x)^2 with a third derivative of order a thousand: a roller near the edge of the load zone has a steep one.
  const Tolerance differences = Tolerance::discretisation(1e-10, 1e3);
  const std::string of = ", law " + name;
  found.claims.push_back(
      claim(sentence("stiffness/" + name + "/forces",
                     "the stiffness of the bearing is the derivative of the rollers' forces along and across" + of),
            forces_error, 0, differences));
  found.claims.push_back(claim(
      sentence("stiffness/" + name + "/balances", "its inverse is what other balances give way, along and across" + of),
      balances_error, 0, differences));
  found.claims.push_back(claim(sentence("stiffness/" + name + "/reciprocal",
                                        "a load across moves the ring along as a load along moves it across" + of),
                               reciprocity, 0, differences));
}

Findings judge_plane() {
  const bearing::RollerContact contact = some_contact();
  const bearing::Geometry geometry{.rollers = 9,
                                   .pitch_diameter_m = contact.pitch_diameter_m,
                                   .roller_diameter_m = contact.roller_diameter_m,
                                   .length_m = contact.length_m,
                                   .clearance_m = 6e-6,
                                   .density_kg_per_m3 = 7790,
                                   .first_azimuth_deg = 8.3};
  Findings found;
  for (const bearing::Law law : printed_laws)
    add_stiffness(found, std::string(to_string(law)), geometry, dry_laws(law, contact), 57, 7.7e3);
  return found;
}

/// The same of the full relation: energy, slopes, stiffness, under a cage that is not symmetric.
Findings judge_full_relation(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .explicitly = true}, memory);
  const auto laws = results.size() == 1 ? laws_of(body, results[0]) : std::nullopt;
  Findings found;
  if (!laws) {
    found.claims.push_back(
        claim_fact(sentence("energy/ehd", "the full relation has a balance"), false, "a law to judge", "no balance"));
    return found;
  }
  bearing::Geometry geometry = geometry_of(body);
  geometry.first_azimuth_deg = 4.3;
  geometry.clearance_m = 7e-6;
  constexpr double centrifugal_N = 31, radial_N = 43e3;
  add_energy(found, "ehd", geometry, *laws, centrifugal_N, radial_N);
  add_law(found, "ehd", *laws);
  add_stiffness(found, "ehd", geometry, *laws, centrifugal_N, radial_N);
  return found;
}

/// Where the cage is symmetric to the load the ring goes along it: the form in two displacements, which then takes the
/// short cut of the radial one, is asked under a cage that is turned by a billionth of a degree.
Findings judge_forms(const Case& bearing_case) {
  constexpr double turned_deg = 1e-9;
  const auto& body = std::get<BearingCase>(bearing_case.body);
  ContactMemory memory(
      [](const Problem& problem, const Request& request) { return find_solver("fast")->solve(problem, request); });
  std::vector<bearing::Law> possible;
  for (const bearing::Law law : {bearing::Law::hertz, bearing::Law::iso, bearing::Law::lundberg, bearing::Law::tripp,
                                 bearing::Law::houpert, bearing::Law::ehd_linear, bearing::Law::ehd})
    if (plan_bearing(body, {law}).runs(bearing_stage::balance(law))) possible.push_back(law);
  Findings found;
  for (const BearingResult& result :
       run_bearing(bearing_case, {.laws = possible, .explicitly = true, .films = false}, memory)) {
    const auto laws = laws_of(body, result);
    double worst = laws ? 0 : nothing, bound = 0;
    for (const double of_pitch : {0.0, 0.5}) {
      if (!laws) break;
      bearing::Geometry geometry = geometry_of(body);
      geometry.first_azimuth_deg = of_pitch * 360 / geometry.rollers;
      const bearing::Loading loading{
          .radial_N = body.operation.radial_load_N,
          .centrifugal_N = bearing::centrifugal_force_N(
              geometry, bearing::speeds_from_rpm(body.operation.inner_speed_rpm, body.operation.outer_speed_rpm))};
      const auto along = bearing::balance(geometry, *laws, loading, bearing::Form::radial);
      bearing::Geometry turned = geometry;
      turned.first_azimuth_deg += turned_deg;
      const auto plane = bearing::balance(turned, *laws, loading, bearing::Form::plane);
      const auto* const one = std::get_if<bearing::Equilibrium>(&along);
      const auto* const other = std::get_if<bearing::Equilibrium>(&plane);
      // The short cut balances mirrored rollers once; in the plane every roller is a group of its own.
      if (!one || !other || other->groups != geometry.rollers || one->groups == geometry.rollers) {
        worst = nothing;
        break;
      }
      double sum_N = 0;
      for (const auto& roller : one->rollers) sum_N += roller.inner.force_N;
      const double scale_N = std::max(loading.radial_N, sum_N), x = one->displacement_m;
      worst = worse(worst, std::abs(other->displacement_m / x - 1), std::abs(other->lateral_displacement_m / x));
      for (std::size_t j = 0; j < one->rollers.size(); ++j)
        worst = worse(worst, std::abs(other->rollers[j].inner.force_N - one->rollers[j].inner.force_N) / scale_N,
                      std::abs(other->rollers[j].outer.force_N - one->rollers[j].outer.force_N) / scale_N);
      // Turned by t, a roller is moved by t x, and pushes the ring by K t x at most; a balance that is off by its
      // largest error moves the ring by that over K.
      const auto& K = one->stiffness_N_per_m;
      const double stiffest = K[0][0] + K[1][1], softest = std::min(K[0][0], K[1][1]);
      const double turn = turned_deg * pi / 180,
                   from_balance = 2 * bearing::largest_balance_error * scale_N / (softest * x);
      bound = worse(bound, turn * worse(stiffest / softest, stiffest * x / scale_N) +
                               from_balance * worse(1, stiffest * x / scale_N));
    }
    const std::string name(to_string(result.law));
    found.claims.push_back(claim(
        sentence("forms/" + bearing_case.id + "/" + name,
                 bearing_case.id + ": under a symmetric cage the form in two displacements gives the radial one, law " +
                     name),
        worst, 0, Tolerance::asymptotic(bound, "a cage turned by 1e-9 degrees, and twice what a balance promises"),
        "a roller under the load, and two beside it"));
  }
  return found;
}

/// With room, a light load rests on the two rollers beside it, whose forces are F sin(b)/sin(a + b) and F sin(a)/sin(a
/// + b).
Findings judge_light_load() {
  const bearing::RollerContact contact = some_contact();
  double worst = 0;
  int balances = 0;
  for (const int rollers : {3, 5, 36, 400})
    for (const double part : {1e-5, 0.2, 0.49, 0.9})
      for (const double load_N : {1e-9, 1e-3}) {
        const double pitch = 2 * pi / rollers, a = part * pitch, b = pitch - a;
        const bearing::Geometry geometry{.rollers = rollers,
                                         .pitch_diameter_m = contact.pitch_diameter_m,
                                         .roller_diameter_m = contact.roller_diameter_m,
                                         .length_m = contact.length_m,
                                         .clearance_m = 200e-6,
                                         .density_kg_per_m3 = 7790,
                                         .first_azimuth_deg = part * 360 / rollers};
        const auto result = bearing::balance(geometry, dry_laws(bearing::Law::tripp, contact),
                                             {.radial_N = load_N, .centrifugal_N = 57});
        const auto* ring = std::get_if<bearing::Equilibrium>(&result);
        const double first = ring ? ring->rollers.front().inner.force_N : nothing,
                     last = ring ? ring->rollers.back().inner.force_N : nothing;
        worst = worse(worst, std::abs(first / load_N - std::sin(b) / std::sin(pitch)),
                      std::abs(last / load_N - std::sin(a) / std::sin(pitch)));
        ++balances;
      }
  Findings found;
  found.claims.push_back(claim(
      sentence("statics", "a light load rests on the two rollers beside it, with the forces that statics gives"), worst,
      0, Tolerance::round_off(20, 100), std::to_string(balances) + " bearings; 1/sin(pitch) is below 100"));
  return found;
}

/// Bearings over the whole ranges, each balance looked at by bisection.
Findings judge_random_bearings() {
  constexpr unsigned bearings = 150;
  Findings found;
  for (const bearing::Law law : printed_laws) {
    double worst = 0;
    unsigned worst_seed = 0;
    for (unsigned seed = 1; seed <= bearings; ++seed) {
      const RandomBearing drawn = random_bearing(seed);
      const bearing::LawPair laws = dry_laws(law, drawn.contact);
      const auto result = bearing::balance(drawn.geometry, laws, drawn.loading);
      const auto* ring = std::get_if<bearing::Equilibrium>(&result);
      const double error =
          ring ? worst_bisection_error(drawn.geometry, laws, drawn.loading, bearing::Form::plane, *ring) : nothing;
      if (!(error <= worst) && !std::isnan(worst)) {
        worst = error;
        worst_seed = seed;
      }
    }
    const std::string name(to_string(law));
    found.claims.push_back(claim(
        sentence("random/" + name, std::to_string(bearings) +
                                       " random bearings are balanced, which bisection of every roller confirms, law " +
                                       name),
        worst, 0, Tolerance::required(bearing::largest_balance_error, "what a balance promises"),
        "worst at seed " + std::to_string(worst_seed)));
  }
  return found;
}

// ---- Many rollers ------------------------------------------------------------------------------------------------

/// F_r/(Z Q_max) goes to Sjovall's integral. The rollers sum a periodic function whose corner, at the edge of the load
/// zone, is of power n = 10/9: the largest error over the cage's positions falls like Z^-(n + 1).
Findings judge_many_rollers() {
  constexpr double length_m = 0.012, clearance_m = 5e-6;
  const bearing::PowerLaw law = bearing::palmgren_law(length_m);
  Findings found;
  std::vector<double> x, y;
  double worst_on_last = 0;
  for (const int rollers : {24, 48, 96, 192, 384}) {
    double worst = 0;
    for (int position = 0; position < 12; ++position) {
      const bearing::Geometry geometry{.rollers = rollers,
                                       .pitch_diameter_m = 0.07,
                                       .roller_diameter_m = 0.009,
                                       .length_m = length_m,
                                       .clearance_m = clearance_m,
                                       .density_kg_per_m3 = 7850,
                                       .first_azimuth_deg = 360.0 / rollers * (position / 12.0 - 0.5)};
      const double load_N = 180.0 * rollers;
      const auto balanced = bearing::balance(geometry, {law, law}, {.radial_N = load_N}, bearing::Form::radial);
      const auto* ring = std::get_if<bearing::Equilibrium>(&balanced);
      double error = nothing;
      if (ring) {
        const double eps = (1 - clearance_m / (2 * ring->displacement_m)) / 2;
        const double at_top_mm =
            1e3 * (ring->displacement_m - clearance_m / 2) / 2;  // each contact, f = 8.06e4 l^(8/9) delta^(10/9)
        const double largest = 8.06e4 * std::pow(1e3 * length_m, 8.0 / 9) * std::pow(at_top_mm, 10.0 / 9);
        error = std::abs(load_N / (rollers * largest) / exact::SjovallIntegral{}(eps)-1);
      }
      worst = worse(worst, error);
    }
    x.push_back(-std::log(rollers));
    y.push_back(std::log(worst));
    worst_on_last = worst;
  }
  found.claims.push_back(order_claim(
      sentence("sjovall/order", "the load shares of Z rollers go to Sjovall's integral with order n + 1 = 19/9"),
      slope(x, y), 19.0 / 9, Tolerance::calibrated(0.2, "an envelope over twelve cage positions, read to a fifth"),
      "24 to 384 rollers, error " + three_digits(worst_on_last) + " on the last"));
  return found;
}

// ---- Zero speed --------------------------------------------------------------------------------------------------

/// Towards rest the film goes, and with Lundberg's datum the full relation becomes Lundberg's law: x_0 = l is that law.
Findings judge_zero_speed(const Case& bearing_case, ContactMemory& memory) {
  std::vector<std::pair<double, double>> by_speed;  // rpm, relative difference of the displacement
  double bound = nothing;
  for (const double rpm : {500.0, 5.0, 0.05}) {
    Case slow = bearing_case;
    auto& body = std::get<BearingCase>(slow.body);
    body.operation.inner_speed_rpm = rpm;
    body.operation.outer_speed_rpm = 0;
    body.datum = LundbergDatum{};
    body.fit = {};
    const auto results = run_bearing(
        slow, {.laws = {bearing::Law::lundberg, bearing::Law::ehd}, .explicitly = true, .films = false}, memory);
    if (results.size() != 2 || results[0].rollers.empty() || results[1].rollers.empty() || !results[1].curve) continue;
    const double dry = results[0].displacement_m;
    by_speed.emplace_back(rpm, std::abs(results[1].displacement_m / dry - 1));
    // An approach that is off by g at the same force moves the ring by Sum k g cos/Sum k cos^2, at most the largest
    // g/cos.
    bound = 0;
    for (const RollerRow& roller : results[1].rollers) {
      if (roller.inner.force_N < bearing::load_zone_share * results[1].rollers.front().inner.force_N) continue;
      const double films_m = results[1].curve->inner.offset_film(roller.inner.force_N).value +
                             results[1].curve->outer.offset_film(roller.outer.force_N).value;
      bound = worse(bound, films_m / std::cos(roller.azimuth_deg * pi / 180) / dry);
    }
  }
  const bool all = by_speed.size() == 3;
  std::string about;
  for (const auto& [rpm, difference] : by_speed)
    about += (about.empty() ? "" : ", ") + plain(difference, 3) + " at " + plain(rpm) + " rpm";
  Findings found;
  found.claims.push_back(
      claim(sentence("zero-speed/" + bearing_case.id,
                     "towards rest a balance by `ehd` with Lundberg's datum becomes that of the dry law `lundberg`"),
            all ? by_speed[2].second : nothing, 0,
            Tolerance::asymptotic(
                bound, "largest offset films over cos psi of a roller in the load zone, over the displacement"),
            about));
  found.claims.push_back(
      claim_fact(sentence("zero-speed/" + bearing_case.id + "/falls", "and nears it with every step down"),
                 all && by_speed[1].second < 0.2 * by_speed[0].second && by_speed[2].second < 0.2 * by_speed[1].second,
                 "a hundredth of the speed, a fifth of the difference at most", about));
  return found;
}

}  // namespace

std::vector<Topic> bearing_part_topics(const std::vector<LoadedCase>& cases) {
  std::vector<Topic> topics;
  const auto add = [&](const std::string& name, std::function<Findings()> judge) {
    topics.push_back({.name = name, .rungs = {11}, .judge = std::move(judge)});
  };
  add("energy", judge_energy);
  add("many rollers", judge_many_rollers);
  add("dry laws", judge_dry_laws);
  add("ring in the plane", judge_plane);
  add("light load", judge_light_load);
  add("random bearings", judge_random_bearings);
  for (const LoadedCase& loaded : cases) {
    const auto* one = std::get_if<Case>(&loaded.content);
    if (!one || !std::holds_alternative<BearingCase>(one->body)) continue;
    topics.push_back({.name = one->id + ", forms", .rungs = {11}, .case_id = one->id, .judge = [c = *one] {
                        return judge_forms(c);
                      }});
  }
  const auto na4908 =
      std::find_if(cases.begin(), cases.end(), [](const LoadedCase& loaded) { return loaded.id == "na4908"; });
  if (na4908 == cases.end() || !std::holds_alternative<Case>(na4908->content)) return topics;
  const Case one = std::get<Case>(na4908->content);
  add("kinematics", [one] { return judge_kinematics(one); });
  add("contacts of a bearing", [one] { return judge_contacts_asked(one); });
  const auto with_memory = [one](auto judge) {
    return [one, judge] {
      ContactMemory memory(
          [](const Problem& problem, const Request& request) { return find_solver("fast")->solve(problem, request); });
      return judge(one, memory);
    };
  };
  add("datum", with_memory([](const Case& c, ContactMemory& m) { return judge_datum(c, m); }));
  add("fit", with_memory([](const Case& c, ContactMemory& m) { return judge_fit(c, m); }));
  add("curve", with_memory([](const Case& c, ContactMemory& m) { return judge_curve(c, m); }));
  add("full relation", with_memory([](const Case& c, ContactMemory& m) { return judge_full_relation(c, m); }));
  add("zero speed", with_memory([](const Case& c, ContactMemory& m) { return judge_zero_speed(c, m); }));
  return topics;
}

}  // namespace ehd::verification
