// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: a bearing in small harmonic motion. Its parts against equations of motion that are written out again, and
// its contacts against responses that `reference` solves at the rollers' loads.
#include "bearing/dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/bearing/by_hand.hpp"
#include "verification/claims/bearing/parts.hpp"
#include "verification/claims/response_parts.hpp"
#include "verification/exact/martin.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification::bearing_parts {

using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

struct SpringAndDamper {
  double k = 0, c = 0;
};

/// The force on a ring that moves as cos(omega t), over a roller of mass m between two springs with dampers: the
/// displacement of the roller, a cos + b sin, from
///   m v'' + (c_i + c_o) v' + (k_i + k_o) v = k_i u + c_i u'.
SpringAndDamper over_a_roller(SpringAndDamper inner, SpringAndDamper outer, double m, double omega) {
  const double k = inner.k + outer.k - m * omega * omega, c = omega * (inner.c + outer.c);
  const double right_cos = inner.k, right_sin = -omega * inner.c, size = k * k + c * c;
  const double a = (k * right_cos - c * right_sin) / size, b = (c * right_cos + k * right_sin) / size;
  const double force_cos = inner.k * (1 - a) - omega * inner.c * b;
  const double force_sin = -inner.k * b - omega * inner.c * (1 - a);
  return {.k = force_cos, .c = -force_sin / omega};
}

bearing::ContactMotion moving(SpringAndDamper contact) {
  return {.stiffness_N_per_m = contact.k, .damping_N_s_per_m = contact.c};
}

/// Two rollers of different contacts: the ring's matrices by hand, over frequencies around the rollers' own.
double two_rollers_error() {
  const SpringAndDamper first[] = {{3.1e9, 1.3e3}, {2.7e9, 0.9e3}}, second[] = {{1.1e8, 4.2e3}, {1.9e8, 3.7e3}};
  const double psi[] = {17, -64}, mass_kg = 0.0188;
  double worst = 0;
  for (const double Hz : {1.0, 100.0, 2e4, 8.84e4, 3e5}) {  // 8.84e4: the first roller between its contacts
    const double omega = 2 * pi * Hz;
    const SpringAndDamper rollers[] = {over_a_roller(first[0], first[1], mass_kg, omega),
                                       over_a_roller(second[0], second[1], mass_kg, omega)};
    const auto ring = bearing::ring_motion(
        {{psi[0], moving(first[0]), moving(first[1])}, {psi[1], moving(second[0]), moving(second[1])}}, mass_kg, omega);
    const auto compare = [&](const bearing::Matrix2& found, double SpringAndDamper::*part) {
      double expected[2][2] = {}, size = 0;
      for (int j = 0; j < 2; ++j) {
        const double n[] = {std::cos(psi[j] * pi / 180), std::sin(psi[j] * pi / 180)};
        for (int r = 0; r < 2; ++r)
          for (int s = 0; s < 2; ++s) expected[r][s] += rollers[j].*part * n[r] * n[s];
        size += std::abs(rollers[j].*part);
      }
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t s = 0; s < 2; ++s) worst = worse(worst, std::abs(found[r][s] - expected[r][s]) / size);
    };
    compare(ring.stiffness_N_per_m, &SpringAndDamper::k);
    compare(ring.damping_N_s_per_m.value_or(bearing::Matrix2{{{nothing, nothing}, {nothing, nothing}}}),
            &SpringAndDamper::c);
  }
  return worst;
}

/// K of a film with the datum as a spring in series, in complex numbers.
Complex contact_by_hand(const ByHand& contact, double force_N, double datum_m, Complex kappa) {
  const double b = half_width_m(contact, force_N);
  const Complex film = contact.length_m * contact.modulus_Pa / 4 * kappa;
  const double datum = 4 / (pi * contact.modulus_Pa * contact.length_m) * std::log(datum_m / b);
  return film / (1.0 + film * datum);
}

Findings judge_contact_formula() {
  const bearing::RacewayContact contact{.length_m = 0.037,
                                        .reduced_radius_m = 2.9e-3,
                                        .reduced_modulus_Pa = 2.3e11,
                                        .speed_sum_m_per_s = 7.7,
                                        .viscosity_Pa_s = 0.03};
  const ByHand hand{contact.reduced_radius_m, contact.reduced_modulus_Pa, contact.speed_sum_m_per_s, contact.length_m};
  double worst = 0;
  for (const double Omega : {0.01, 0.7, 9.0}) {
    const double force_N = 1700, datum_m = 0.021, b = half_width_m(hand, force_N);
    const double omega = Omega * contact.speed_sum_m_per_s / 2 / b;
    const Complex kappa(3.6, 0.43 * Omega), with_l = 1.0 / (1.0 / kappa + std::log(hand.length_m / b) / pi);
    const auto found = bearing::contact_motion(contact, force_N, datum_m, omega,
                                               {.stiffness = with_l.real(), .damping = with_l.imag() / Omega});
    const Complex expected = contact_by_hand(hand, force_N, datum_m, kappa);
    worst = worse(worst, std::abs(found.stiffness_N_per_m / expected.real() - 1),
                  std::abs(found.damping_N_s_per_m.value_or(nothing) * omega / expected.imag() - 1));
  }
  Findings found;
  found.claims.push_back(
      claim(sentence("motion/contact", "the datum is a compliance in series with the film, with any damping"), worst, 0,
            Tolerance::round_off(64, 100)));
  return found;
}

}  // namespace

Findings judge_rollers_in_motion() {
  Findings found = judge_contact_formula();
  found.claims.push_back(claim(
      sentence("motion/two-rollers", "two rollers obey their equations of motion: stiffness and damping of the ring"),
      two_rollers_error(), 0, Tolerance::round_off(100, 1e4)));
  // Far above its own frequency a roller stands still: k_j -> K_i, and the next term is -K_i^2/(m omega^2).
  const SpringAndDamper inner{3.1e9, 1.3e3}, outer{2.7e9, 0.9e3};
  const double mass_kg = 0.0188, omega = 2 * pi * 1e7;
  const auto still = bearing::ring_motion({{0, moving(inner), moving(outer)}}, mass_kg, omega);
  const Complex K(inner.k, omega * inner.c);
  const double next = std::abs(K / (mass_kg * omega * omega));
  found.claims.push_back(
      claim_value(sentence("motion/still-roller", "far above its own frequency a roller stands still"),
                  still.stiffness_N_per_m[0][0], (K + K * K / (mass_kg * omega * omega)).real(), 0,
                  Tolerance::asymptotic(4 * next * next * std::abs(K / inner.k), "the square of the first term")));
  // Equal contacts all around.
  std::vector<bearing::RollerMotion> rollers;
  for (int j = 0; j < 7; ++j) rollers.push_back({360.0 * j / 7 - 180, moving(inner), moving(outer)});
  const auto round = bearing::ring_motion(rollers, mass_kg, 2 * pi * 300);
  const auto one = bearing::ring_motion({rollers.front()}, mass_kg, 2 * pi * 300);
  double uneven = 0;
  const auto compare = [&](const bearing::Matrix2& all, const bearing::Matrix2& single) {
    const double half = 3.5 * (single[0][0] + single[1][1]);
    uneven = worse(uneven, std::abs(all[0][0] / half - 1), std::abs(all[1][1] / half - 1), std::abs(all[0][1] / half),
                   std::abs(all[1][0] / half));
  };
  compare(round.stiffness_N_per_m, one.stiffness_N_per_m);
  compare(*round.damping_N_s_per_m, *one.damping_N_s_per_m);
  found.claims.push_back(claim(
      sentence("motion/all-around", "equal contacts all around are as stiff, and damp as much, in every direction"),
      uneven, 0, rounding()));
  return found;
}

namespace {

/// The contact by `reference` at one roller's load, and what the bearing says of it, over the stated error.
double against_reference(const BearingCase& body, const BearingResult& result, const DynamicRow& row, std::size_t j,
                         bool inner, std::string& note) {
  const ByHand contact = by_hand(body, inner);
  const double force_N = one_of(result.rollers[j], inner).force_N, b = half_width_m(contact, force_N);
  const double omega = 2 * pi * row.frequency_Hz;
  const Conditions conditions{.load_N_per_m = force_N / contact.length_m,
                              .reduced_radius_m = contact.radius_m,
                              .reduced_modulus_Pa = contact.modulus_Pa,
                              .speed_sum_m_per_s = contact.sum_speed_m_per_s,
                              .viscosity_Pa_s = body.lubricant->viscosity_Pa_s};
  const Response response =
      certified_response(nondimensionalise(conditions, body.lubricant->lubricant, Flooded{}).problem,
                         {.frequencies = {omega * b / (contact.sum_speed_m_per_s / 2)}, .tolerance = 1e-7});
  const Complex K =
      contact_by_hand(contact, force_N, one_of(*result.datum_m, inner), known_kappa(response.frequencies.front()));
  const bearing::ContactMotion& said = one_of(row.rollers[j], inner);
  note += fmt::format("{} N: {} N/m, {} N s/m; ", plain(force_N, 4), plain(K.real(), 5), plain(K.imag() / omega, 5));
  return worse(std::abs(said.stiffness_N_per_m - K.real()) / said.stiffness_error,
               std::abs(said.damping_N_s_per_m.value_or(nothing) - K.imag() / omega) / said.damping_error);
}

/// An interpolation error that vanishes at both ends of a gap g in ln f and reaches e between them has a slope of at
/// most about pi e/g. The static stiffness is made of such slopes.
double error_of_slopes(const bearing::FilmCurve& curve) {
  double narrowest = std::log(curve.forces_N()[1] / curve.forces_N()[0]);
  for (std::size_t k = 1; k < curve.forces_N().size(); ++k)
    narrowest = std::min(narrowest, std::log(curve.forces_N()[k] / curve.forces_N()[k - 1]));
  return pi * std::max(curve.errors().interpolation_force, curve.errors().joint_force) / narrowest;
}

double difference(const bearing::Matrix2& one, const bearing::Matrix2& other) {
  double worst = 0;
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t s = 0; s < 2; ++s) worst = worse(worst, std::abs(one[r][s] - other[r][s]));
  return worst / (other[0][0] + other[1][1]);
}

constexpr double running_Hz = 100, fast_Hz = 5000;

/// The limit omega -> 0, and whether there is a damping.
void judge_law(Findings& found, const std::string& id, const BearingResult& result) {
  const std::string law(to_string(result.law));
  const bool film = result.law == bearing::Law::ehd;
  const Tolerance tolerance = film ? Tolerance::discretisation(worse(error_of_slopes(result.curve->inner),
                                                                     error_of_slopes(result.curve->outer)) +
                                                                   result.dynamics[0].ring.error,
                                                               1)
                                   : rounding();
  found.claims.push_back(claim(sentence(id + "/static/" + law, "omega -> 0 gives the static stiffness of " + law),
                               difference(result.dynamics[0].ring.stiffness_N_per_m, result.stiffness_N_per_m), 0,
                               tolerance, "xx = " + plain(result.dynamics[0].ring.stiffness_N_per_m[0][0], 6)));
  bool damped = true, undamped = true;
  for (const DynamicRow& row : result.dynamics) (row.ring.damping_N_s_per_m.has_value() ? undamped : damped) = false;
  found.claims.push_back(
      claim_fact(sentence(id + "/damping/" + law, law + (film ? " has a damping" : " has no damping, not a zero one")),
                 film ? damped : undamped, "at every frequency"));
}

void judge_contacts_in_motion(Findings& found, const std::string& id, const BearingCase& body,
                              const BearingResult& film) {
  double worst = 0;
  std::string note;
  for (const std::size_t row : {std::size_t{1}, std::size_t{2}})
    for (const std::size_t j :
         {std::size_t{0}, film.rollers.size() / 4 + 1})  // the heaviest; the edge of the load zone
      worst = worse(worst, against_reference(body, film, film.dynamics[row], j, j == 0, note));
  found.claims.push_back(
      claim(sentence(id + "/contacts", "stated errors of contact stiffness and damping cover responses by `reference`"),
            worst, 0, Tolerance::stated(), note));
  const auto& damping = film.dynamics[1].ring.damping_N_s_per_m.value();
  found.claims.push_back(
      claim_finding(sentence(id + "/across",
                             "the rollers at the edge of the load zone damp most: damping across the load over that "
                             "along it"),
                    fmt::format("{} at {} Hz ({} and {} N s/m)", plain(damping[1][1] / damping[0][0], 3),
                                plain(running_Hz), plain(damping[0][0], 4), plain(damping[1][1], 4))));
}

/// k + i omega c = (E'/4) kappa per length, Omega = omega b/u_m, against Martin's film and the damping of exact/martin.
void judge_rigid_contact(Findings& found, const std::string& id, const BearingCase& body, const BearingResult& film,
                         bool inner, ContactMemory& memory) {
  const ByHand contact = by_hand(body, inner);
  const bearing::FilmCurve& curve = one_of(*film.curve, inner);
  const auto& made = memory.response_curve(curve.contact(), body.lubricant->lubricant,
                                           {.lightest_N = curve.lightest_N(), .heaviest_N = curve.heaviest_N()});
  const auto* responses = std::get_if<bearing::ResponseCurve>(&made);
  const exact::Martin martin;
  const double force_N = curve.lightest_N() / 100, viscosity = body.lubricant->viscosity_Pa_s;
  const double film_m =
      martin.load_sum * viscosity * contact.sum_speed_m_per_s * contact.radius_m * contact.length_m / force_N;
  const double k = force_N / contact.length_m / film_m;
  const double c = martin.damping * viscosity * std::pow(contact.radius_m / film_m, 1.5);
  const bearing::Kappa slow = responses ? responses->slow(force_N) : bearing::Kappa{nothing, nothing};
  const double b = half_width_m(contact, force_N), s_per_T = b / (contact.sum_speed_m_per_s / 2);
  found.claims.push_back(claim(
      sentence(id + "/rigid/" + raceway_name(inner),
               "far below its lightest contact a film is as stiff, and damps as much, as one on a rigid cylinder, " +
                   raceway_name(inner) + " raceway"),
      worse(std::abs(contact.modulus_Pa / 4 * slow.stiffness / k - 1),
            std::abs(contact.modulus_Pa / 4 * slow.damping * s_per_T / c - 1)),
      0, Tolerance::asymptotic(1e-3, "5 % x 100^(-3/2), and twenty times that")));
}

}  // namespace

Findings judge_dynamics(const Case& bearing_case, ContactMemory& memory) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const std::string id = "motion/" + bearing_case.id;
  const auto results = run_bearing(bearing_case,
                                   {.laws = {bearing::Law::hertz, bearing::Law::ehd_linear, bearing::Law::ehd},
                                    .frequencies_Hz = {0, running_Hz, fast_Hz}},
                                   memory);
  Findings found;
  const bool known = results.size() == 3 && results[2].curve &&
                     std::all_of(results.begin(), results.end(),
                                 [](const BearingResult& result) { return result.dynamics.size() == 3; });
  if (!known || !results[2].dynamics[1].ring.damping_N_s_per_m) {
    found.claims.push_back(claim_fact(sentence(id, "the bearing has stiffness and damping in motion"), false,
                                      "three laws, three frequencies", results.empty() ? "" : results.back().why));
    return found;
  }
  for (const BearingResult& result : results) judge_law(found, id, result);
  judge_contacts_in_motion(found, id, body, results[2]);
  for (const bool inner : {true, false}) judge_rigid_contact(found, id, body, results[2], inner, memory);
  return found;
}

}  // namespace ehd::verification::bearing_parts
