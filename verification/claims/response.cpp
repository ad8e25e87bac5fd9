// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6, 8 and 9: the harmonic response of the certified solver against what is known exactly.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/claims/response_parts.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/flat_punch.hpp"
#include "verification/exact/martin.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

// ---- kappa(0) is the slope of steady solves ------------------------------------------------------------------------

Findings judge_slope(MoesGroups moes, const Inlet& inlet) {
  const Response response = certified_response(response_problem(moes, inlet), {.frequencies = {0}, .tolerance = 1e-9});
  const OffsetSlope steady = offset_slope(moes, inlet, "reference", 1e-11);
  const double expected = steady.kappa();
  const Stiffness& at = response.frequencies.front();
  const double uncertainty = at.error + expected / pi * steady.uncertainty;
  Findings found;
  found.claims.push_back(claim_value(
      response_says("slope/" + contact_name(moes, inlet), 6, "kappa(0) is the slope of the load over the offset"),
      known_kappa(at).real(), expected, uncertainty, Tolerance::required(1e-8, "kappa to eight digits"),
      fmt::format("kappa(0) = {}, n = {}", plain(at.kappa.real(), 11), response.cost.nodes)));
  return found;
}

// ---- low frequencies -----------------------------------------------------------------------------------------------

/// kappa_1 from two real solves against Im kappa/Omega, which differs by O(Omega^2).
Findings judge_slow(MoesGroups moes, const Inlet& inlet) {
  const std::vector<double> frequencies = {0.08, 0.04, 0.02, 0.01};
  const Response response =
      certified_response(response_problem(moes, inlet), {.frequencies = frequencies, .tolerance = 1e-9});
  std::vector<double> stiffness, damping;
  for (const Stiffness& at : response.frequencies) {
    stiffness.push_back(std::abs(known_kappa(at).real() / response.slow->kappa_0 - 1));
    damping.push_back(std::abs(known_kappa(at).imag() / (at.Omega * response.slow->kappa_1) - 1));
  }
  Findings found;
  const Tolerance order = order_over_four_grids();
  const std::string name = contact_name(moes, inlet), note = "kappa_1 = " + plain(response.slow->kappa_1, 10);
  found.claims.push_back(claim_value(
      response_says("slow/" + name + "/damping", 6, "Im kappa/Omega goes to kappa_1 of two real solves like Omega^2"),
      observed_order(damping.front(), damping.back(), 8), 2, 0, order, note));
  found.claims.push_back(
      claim_value(response_says("slow/" + name + "/stiffness", 6, "Re kappa goes to kappa_0 like Omega^2"),
                  observed_order(stiffness.front(), stiffness.back(), 8), 2, 0, order, note));
  return found;
}

/// Not proved, so that only what was tried is claimed.
Findings judge_sign(const Box& box) {
  double least = 1e300;
  std::string note;
  for (const BoxContact& contact : contacts_of(box)) {
    const Response response = certified_response(response_problem(contact.moes, contact.inlet), {.tolerance = 1e-5});
    const bool known = response.status == StopReason::converged;
    least = known ? std::min(least, response.slow->kappa_1 * (1 - response.slow->error_1)) : nothing;
    note += plain(known ? response.slow->kappa_1 : nothing, 4) + " ";
  }
  Findings found;
  found.claims.push_back(
      claim_fact(response_says("slow/positive", 6, "slow motion is damped, M from 1 to 500, L from 4 to 12"), least > 0,
                 "kappa_1 > 0 at every contact tried", note));
  return found;
}

/// Where the film begins to be elastic, at large L, the damping of slow motion is negative. `with`: the end of the
/// claims' ids.
Findings judge_driven_slowly(MoesGroups moes, const Lubricant& oil, const std::string& with) {
  Findings found;
  for (const auto& [name, tolerance] : {std::pair{"reference", 1e-6}, std::pair{"fast", 1e-4}}) {
    const Response response = find_solver(name)->respond(response_problem(moes, Flooded{}, oil),
                                                         {.frequencies = {0.3, 1}, .tolerance = tolerance});
    const bool known = response.status == StopReason::converged;
    const auto most = [&](double value, double error) { return known ? value + error : nothing; };
    const Stiffness& at = response.frequencies.front();
    const double slow = most(response.slow->kappa_1, std::abs(response.slow->kappa_1) * response.slow->error_1),
                 moving = most(at.kappa.imag(), at.error * std::abs(at.kappa));
    Sentence says = response_says(fmt::format("slow/driven/{}{}", name, with), 6,
                                  fmt::format("slow motion is driven, not damped, at M = {}, L = {}, {}: {}",
                                              plain(moes.M), plain(moes.L), to_string(oil.viscosity), name));
    says.solver = name;
    found.claims.push_back(
        claim_fact(says, slow < 0 && moving < 0, "kappa_1 < 0, and Im kappa < 0 at Omega = 0.3",
                   fmt::format("kappa_1 = {}, Im kappa = {} at 0.3, {} at 1", plain(response.slow->kappa_1, 9),
                               plain(at.kappa.imag(), 9), plain(response.frequencies.back().kappa.imag(), 9))));
  }
  return found;
}

// ---- stated errors -------------------------------------------------------------------------------------------------

/// What a response to 1e-2 states against a response to 1e-8.
Findings judge_stated(MoesGroups moes, const Inlet& inlet) {
  ResponseRequest request{.frequencies = {0, 1, 5, 10}, .waviness = {{1, 0.5}, {1, 1}, {2, 2}}};
  request.tolerance = 1e-8;
  const Response fine = certified_response(response_problem(moes, inlet), request);
  request.tolerance = 1e-2;
  const Response coarse = certified_response(response_problem(moes, inlet), request);
  double worst = 0;
  std::string note;
  const auto compare = [&](Complex value, double error, Complex truth, double truth_error) {
    const double differ = std::abs(value - truth) / std::abs(truth);
    worst = worse(worst, differ / (error + truth_error));
    note += fmt::format("{}/{} ", plain(differ, 2), plain(error, 2));
  };
  for (std::size_t k = 0; k < fine.frequencies.size(); ++k)
    compare(known_kappa(coarse.frequencies[k]), coarse.frequencies[k].error, fine.frequencies[k].kappa,
            fine.frequencies[k].error);
  for (std::size_t k = 0; k < fine.waviness.size(); ++k)
    compare(coarse.waviness[k].film, coarse.waviness[k].error, fine.waviness[k].film, fine.waviness[k].error);
  Findings found;
  found.claims.push_back(
      claim(response_says("stated/" + contact_name(moes, inlet), 8, "stated errors of kappa and of wavy films hold"),
            worst, 0, Tolerance::stated(), "error/stated at 1e-2: " + note));
  return found;
}

// ---- limits --------------------------------------------------------------------------------------------------------

/// c of f(M) = c + M^2 (a + b ln M) through three points.
double limit_of_light_loads(const std::vector<std::pair<double, double>>& points) {
  // Differences of f/M^2 in ln M would amplify c: eliminate a and b directly (Cramer).
  const auto row = [&](std::size_t i) {
    const double M = points[i].first;
    return std::array<double, 3>{1, M * M, M * M * std::log(M)};
  };
  const auto r0 = row(0), r1 = row(1), r2 = row(2);
  const auto det = [](auto a, auto b, auto c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  auto f0 = r0, f1 = r1, f2 = r2;
  f0[0] = points[0].second, f1[0] = points[1].second, f2[0] = points[2].second;
  return det(f0, f1, f2) / det(r0, r1, r2);
}

/// Isoviscous, flooded, M -> 0: a rigid roller. Its load is Martin's, w ~ 1/h_0, and its damping that of exact/martin.
Findings judge_rigid_response() {
  const exact::Martin martin;
  std::vector<std::pair<double, double>> stiffness, slow, fast;
  std::string note;
  double error = 0;
  for (const double M : {0.05, 0.025, 0.0125}) {
    const Problem problem = response_problem({M, 0}, Flooded{}, Lubricant{});
    const Response response = certified_response(problem, {.frequencies = {1}, .tolerance = 1e-9});
    const Solution solution = remembered("reference").solve(problem, {.tolerance = 1e-9});
    const Reading* film = reading(solution, Quantity::film_central);
    // c (b^2/R)(u_m/b)/(p_H b) with lambda = 12 eta_0 u_m R^2/(b^3 p_H) and h = H b^2/R
    const double damping = martin.damping * problem.groups.lambda / 12 * std::pow(value_of(film), -1.5);
    const bool known = response.status == StopReason::converged;
    stiffness.emplace_back(M, known ? response.slow->kappa_0 * value_of(film) / (pi / 2) : nothing);
    slow.emplace_back(M, known ? response.slow->kappa_1 / damping : nothing);
    fast.emplace_back(M, known_kappa(response.frequencies.front()).imag() / damping);
    error = worse(error, 2.5 * error_of(film) + response.slow->error_1 + response.frequencies.front().error);
    note += fmt::format("M = {}: {}, {}, {}; ", plain(M), plain(stiffness.back().second, 7),
                        plain(slow.back().second, 7), plain(fast.back().second, 7));
  }
  // The next term is M^4 ln^2 M: of order 1e-5 at the middle point.
  const Tolerance remainder = Tolerance::asymptotic(std::pow(0.025, 4) * std::pow(std::log(0.025), 2) * 10,
                                                    "M^4 (ln M)^2 at M = 0.025, times 10");
  // M^2 (a + b ln M) behaves like M^2 ln M, and a moves the order by a/(b (ln M)^2).
  const auto remainder_order = [](const std::vector<std::pair<double, double>>& points) {
    return observed_order(points[1].second - 1, points[2].second - 1, 2);
  };
  const double order = 2 + std::log2(std::log(0.025) / std::log(0.0125));
  const Tolerance square = Tolerance::asymptotic(1 / std::pow(std::log(0.025), 2),
                                                 "M^2 beside M^2 ln M at M = 0.025, coefficients of equal size");
  Findings found;
  found.claims.push_back(
      claim_value(response_says("rigid/stiffness/order", 9, "kappa(0) H(0) goes to pi/2 like M^2 ln M"),
                  remainder_order(stiffness), order, 0, square, note));
  found.claims.push_back(
      claim_value(response_says("rigid/damping/order", 9, "kappa_1 goes to that of a rigid roller like M^2 ln M"),
                  remainder_order(slow), order, 0, square, note));
  found.claims.push_back(claim_value(response_says("rigid/stiffness", 9, "kappa(0) H(0) goes to pi/2 as M -> 0"),
                                     limit_of_light_loads(stiffness), 1, 10 * error, remainder, note));
  found.claims.push_back(
      claim_value(response_says("rigid/damping", 9, "kappa_1 goes to the damping of a rigid roller as M -> 0"),
                  limit_of_light_loads(slow), 1, 10 * error, remainder, note));
  found.claims.push_back(claim_value(
      response_says("rigid/damping-at-1", 9, "Im kappa at Omega = 1 goes to the damping of a rigid roller as M -> 0"),
      fast.back().second, 1, error,
      Tolerance::asymptotic(0.0125 * 0.0125 * std::pow(std::log(0.0125), 2), "M^2 (ln M)^2 at M = 0.0125"), note));
  return found;
}

/// Isoviscous, M -> infinity. H_0 - dry ~ M^(-6/5) as the film does, so that the same holds for kappa(0); the next
/// terms are smaller by M^(-2/5).
Findings judge_dry() {
  std::vector<double> kappa;
  double error = 0;
  std::string note;
  for (const double M : {3200, 6400, 12800}) {
    const Response response = certified_response(response_problem({M, 0}, cut_at_4, Lubricant{}), {.tolerance = 1e-7});
    kappa.push_back(response.slow && response.slow->error_0 <= 1e-7 ? response.slow->kappa_0 : nothing);
    error = worse(error, response.slow->error_0);
    note += plain(kappa.back(), 10) + " ";
  }
  const double dry = pi / std::numbers::ln2;
  const double order = observed_order(dry - kappa[1], dry - kappa[2], 2);
  const double d1 = kappa[1] - kappa[0], d2 = kappa[2] - kappa[1];
  const double next = std::pow(12800, -0.4);
  Findings found;
  found.claims.push_back(claim_value(
      response_says("dry/limit", 9, "kappa(0) goes to pi/ln 2, that of a dry contact, as M -> infinity"),
      kappa[2] + d2 * d2 / (d1 - d2), dry, 4 * error,
      Tolerance::asymptotic(3 * next * (dry - kappa[2]) / dry, "remainder at the heaviest load, times 3 M^(-2/5)"),
      note));
  found.claims.push_back(claim_value(response_says("dry/order", 9, "kappa(0) goes to that limit like M^(-6/5)"), order,
                                     1.2, 0, Tolerance::asymptotic(3 * next, "3 M^(-2/5)"), note));
  return found;
}

/// Incompressible, cut: as Omega -> infinity no oil flows out and the roller is a flat punch on the oil.
Findings judge_punch() {
  const Problem problem = response_problem({5, 5}, cut_at_4, Lubricant{});
  const Response response = certified_response(problem, {.frequencies = {1e6, 1e7, 1e8}, .tolerance = 1e-6});
  const Solution solution = remembered("reference").solve(problem, {.tolerance = 1e-9});
  const double exit = value_of(reading(solution, Quantity::pressure_exit));
  std::vector<Complex> chi;
  for (const Stiffness& at : response.frequencies) chi.push_back(1.0 / known_kappa(at));
  const Complex d1 = chi[1] - chi[0], d2 = chi[2] - chi[1];
  const double limit = (chi[2] + d2 * d2 / (d1 - d2)).real();
  const std::string note = fmt::format("chi = {}, {}, {} at 1e6, 1e7, 1e8; X* = {}", plain(chi[0].real(), 7),
                                       plain(chi[1].real(), 7), plain(chi[2].real(), 7), plain(exit, 9));
  Findings found;
  found.claims.push_back(
      claim_value(response_says("punch/limit", 9, "an incompressible contact is a flat punch as Omega -> infinity"),
                  limit, exact::flat_punch_compliance(-4, exit), 0,
                  Tolerance::asymptotic(std::abs(d2 / chi[2]) * std::pow(1e8, -1.0 / 6),
                                        "the last change, times the square root of its Omega^(-1/3)"),
                  note));
  found.claims.push_back(
      claim_value(response_says("punch/order", 9, "its compliance goes to the limit like Omega^(-1/3)"),
                  -std::log10(std::abs(d2 / d1)), 1.0 / 3, 0,
                  Tolerance::asymptotic(0.02, "the next power, Omega^(-2/3), at 1e6"), note));
  return found;
}

}  // namespace

OffsetSlope offset_slope(MoesGroups moes, const Inlet& inlet, const std::string& solver, double tolerance) {
  constexpr double step = 0.015;  // in ln M; 0.03 was off by 1e-9 at (5, 5), which step^6 makes 2e-11
  constexpr double weights[] = {0, 3.0 / 4, -3.0 / 20, 1.0 / 60};
  const Request request{.tolerance = tolerance};
  const auto* cut = std::get_if<TruncatedAt>(&inlet);
  OffsetSlope found;
  for (int k = -3; k <= 3; ++k) {
    const double ratio = std::exp(k * step);
    const Inlet same = cut ? Inlet(TruncatedAt{cut->x / std::sqrt(ratio)}) : inlet;  // b grows like sqrt(M)
    const Solution solution = remembered(solver).solve(response_problem({moes.M * ratio, moes.L}, same), request);
    const Reading* offset = reading(solution, Quantity::film_offset);
    const double weight = (k < 0 ? -1 : 1) * weights[std::abs(k)] / step;
    found.slope += weight * value_of(offset);
    if (k == 0) found.offset = value_of(offset), found.uncertainty += 2 * error_of(offset);
    // What a flooded inlet leaves is a power of M, so that its slope is of its own size; all else may change its sign.
    found.uncertainty += 2 * (cut ? std::abs(weight) : k == 0 ? 1 : 0) * error_of(offset);
  }
  return found;
}

std::vector<Topic> response_topics() {
  std::vector<Topic> topics;
  for (const MoesGroups moes : {MoesGroups{5, 5}, MoesGroups{20, 10}, MoesGroups{100, 10}}) {
    for (const Inlet& inlet : {Inlet(Flooded{}), cut_at_4}) {
      const bool slow = moes.M > 5;
      topics.push_back({.name = "response slope " + contact_name(moes, inlet),
                        .rungs = {6},
                        .slow = slow,
                        .judge = [=] { return judge_slope(moes, inlet); },
                        .expected_s = slow ? 15.0 : 3.0});
      topics.push_back({.name = "response stated errors " + contact_name(moes, inlet),
                        .rungs = {8},
                        .slow = slow,
                        .judge = [=] { return judge_stated(moes, inlet); },
                        .expected_s = slow ? 15.0 : 3.0});
    }
  }
  topics.push_back({.name = "response slow", .rungs = {6}, .judge = [] { return judge_slow({5, 5}, cut_at_4); }});
  topics.push_back({.name = "response slow", .rungs = {6}, .judge = [] { return judge_slow({3, 6}, Flooded{}); }});
  topics.push_back(
      {.name = "response sign",
       .rungs = {6},
       .slow = true,
       .judge =
           [] {
             return judge_sign({.M = {1, 5, 20, 100, 500}, .L = {4, 8, 12}, .roelands = {true}, .flooded = {true}});
           },
       .expected_s = 20});
  topics.push_back({.name = "response driven", .rungs = {6}, .judge = [] {
                      return judge_driven_slowly({0.7, 25}, response_oil, "");
                    }});
  topics.push_back({.name = "response driven, Barus", .rungs = {6}, .judge = [] {
                      return judge_driven_slowly({1, 15}, Lubricant{}, "-barus");
                    }});
  topics.push_back({.name = "response rigid", .rungs = {9}, .judge = judge_rigid_response});
  topics.push_back({.name = "response dry", .rungs = {9}, .judge = judge_dry});
  topics.push_back({.name = "response punch", .rungs = {9}, .judge = judge_punch, .expected_s = 2});
  return topics;
}

}  // namespace ehd::verification
