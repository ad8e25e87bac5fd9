// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6, 8 and 9: the harmonic response against steps in time, against causality, and its answer to waviness.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/legendre.hpp"
#include "verification/claims/response_parts.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/flat_punch.hpp"
#include "verification/exact/time_steps.hpp"
#include "verification/solution_memory.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

using exact::film_by_time_steps;
using exact::motion_by_time_steps;
using exact::TimeSteps;
using std::numbers::pi;
using Amplitude = std::complex<double>;

// ---- steps in time -------------------------------------------------------------------------------------------------

Tolerance order_over_three_steps() {
  return Tolerance::calibrated(0.1, "orders from three lengths of a step are read to a tenth");
}

Findings judge_time(double Omega) {
  constexpr MoesGroups moes{5, 5};
  const Problem problem = response_problem(moes, cut_at_4);
  const Response response = certified_response(problem, {.frequencies = {Omega}, .tolerance = 1e-8});
  const Amplitude kappa = known_kappa(response.frequencies.front());
  const Solution steady = remembered("reference").solve(problem, {.tolerance = 1e-6});
  const auto stepped = [&](int intervals, int steps) {
    return motion_by_time_steps(problem, steady.fields, {.Omega = Omega, .intervals = intervals, .steps = steps}).kappa;
  };
  const Amplitude coarse = stepped(64, 64), fine = stepped(128, 128), both = (4.0 * fine - coarse) / 3.0;
  const std::string at = fmt::format("time/{}/", plain(Omega));
  Findings found;
  found.claims.push_back(
      claim(response_says(at + "kappa", 8, "implicit steps of the full equations in time give the same kappa"),
            std::abs(both - kappa) / std::abs(kappa), 0, Tolerance::required(1e-3, "a part in a thousand"),
            fmt::format("{} + {} i from 64 and 128 intervals and steps, {} + {} i harmonic", plain(both.real(), 6),
                        plain(both.imag(), 6), plain(kappa.real(), 6), plain(kappa.imag(), 6))));
  const Amplitude longest = stepped(128, 64), middle = fine, shortest = stepped(128, 256);
  found.claims.push_back(claim_value(response_says(at + "order", 8, "these steps are of second order in time"),
                                     observed_order(std::abs(longest - middle), std::abs(middle - shortest), 2), 2, 0,
                                     order_over_three_steps(), "64, 128 and 256 steps a period"));
  return found;
}

/// What the film keeps of a waviness at a constant load. Space and time are refined together, each of second order: 4/3
/// of a value less 1/3 of the coarser one is of third order, measured 3.0, so that it leaves a seventh of its last
/// move.
Findings judge_waviness_in_time(double slip) {
  constexpr double wavelength = 2;
  const Waviness waviness{.wavelength = wavelength, .slip = slip};
  const Problem problem = response_problem({5, 5}, cut_at_4);
  const Response response = certified_response(problem, {.waviness = {waviness}, .tolerance = 1e-8});
  const Amplitude film = known_film(response.waviness.front());
  const Solution steady = remembered("reference").solve(problem, {.tolerance = 1e-6});
  const auto stepped = [&](int intervals, int steps) {
    return film_by_time_steps(problem, steady.fields, {.waviness = waviness, .intervals = intervals, .steps = steps});
  };
  const Amplitude coarse = stepped(64, 64), middle = stepped(128, 128), fine = stepped(256, 256);
  const Amplitude before = (4.0 * middle - coarse) / 3.0, last = (4.0 * fine - middle) / 3.0;
  const double size = std::abs(film);
  const std::string at = "time/waviness/" + plain(slip);
  Findings found;
  found.claims.push_back(claim(
      response_says(
          at, 8,
          fmt::format("implicit steps of the full equations in time leave the same of a waviness of 2 b at slip {}",
                      plain(slip))),
      std::abs(last - film) / size, std::abs(last - before) / 7 / size,
      Tolerance::required(1e-3, "a part in a thousand of the amplitude ratio, the phase with it"),
      fmt::format("{} at {} degrees from up to 256 intervals and steps, {} at {} harmonic", plain(std::abs(last), 6),
                  plain(std::arg(last) * 180 / pi, 5), plain(size, 6), plain(std::arg(film) * 180 / pi, 5))));
  const Amplitude longest = stepped(128, 64), shortest = stepped(128, 256);
  found.claims.push_back(claim_value(
      response_says(at + "/order", 8, fmt::format("these steps are of second order in time at slip {}", plain(slip))),
      observed_order(std::abs(longest - middle), std::abs(middle - shortest), 2), 2, 0, order_over_three_steps(),
      "64, 128 and 256 steps a period"));
  return found;
}

/// A larger motion: what the response leaves out grows like the square of the amplitude. Where the film moves by a part
/// a of its mean, flow through it changes by 3 a and 3 a^2, so that a twentieth should leave a few (1/20)^2.
Findings judge_amplitude() {
  constexpr double per_cent = 0.01, moderate = 0.05;
  const Problem problem = response_problem({5, 5}, cut_at_4);
  const Solution steady = remembered("reference").solve(problem, {.tolerance = 1e-6});
  const auto motion = [&](double part) {
    const double film = value_of(reading(steady, Quantity::film_central));
    return motion_by_time_steps(problem, steady.fields,
                                {.Omega = 1, .amplitude = part * film / std::abs(steady.fields.offset)});
  };
  const Amplitude linear = motion(1e-4).kappa;
  std::vector<double> beyond, films;
  std::string note;
  for (const double part : {0.05, 0.1, 0.2, 0.4}) {
    const auto found = motion(part);
    beyond.push_back(std::abs(found.kappa - linear) / std::abs(linear));
    films.push_back(found.film);
    note += fmt::format("{} % where the bodies move by {} of the film at X = 0 and it by {}; ",
                        plain(100 * beyond.back(), 2), plain(part), plain(films.back(), 2));
  }
  Findings found;
  found.claims.push_back(claim_value(
      response_says("time/amplitude", 8, "kappa of a larger motion leaves the linear one like the amplitude squared"),
      observed_order(beyond[1], beyond[0], 2), 2, 0,
      Tolerance::asymptotic(0.1, "the next power is the fourth: a few (0.1)^2"), note));
  const double a_square = beyond[0] / (films[0] * films[0]);  // at the smallest amplitude, where the square rules
  found.claims.push_back(claim(
      response_says("time/linear", 8,
                    "the linear response holds to 1 % while the film moves by a twentieth of its mean"),
      a_square * moderate * moderate, 0, Tolerance::required(per_cent, "what a rotor's model asks of a stiffness"),
      fmt::format("off by {} (film amplitude/mean film)^2: 1 % at {}, 10 % at {} of the mean film", plain(a_square, 3),
                  plain(std::sqrt(per_cent / a_square), 2), plain(std::sqrt(10 * per_cent / a_square), 2))));
  return found;
}

// ---- causality -----------------------------------------------------------------------------------------------------

/// Kramers and Kronig for chi = 1/kappa of an incompressible contact: what the force does follows the motion.
Findings judge_causality() {
  constexpr double low_end = 50, high_end = 1e8;
  constexpr int panels = 10, high_panels = 10, points = 8;
  const VectorOf<double> t = lobatto_nodes<double>(points), weights = lobatto_weights<double>(points, t);
  // Int_0^50 dOmega/Omega, whose integrand is smooth and swings once in pi, then Int to 1e8 in ln Omega.
  std::vector<double> Omega, measure;
  const auto panel = [&](double a, double b, bool logarithmic) {
    for (int k = 0; k <= points; ++k) {
      const double at = (a + b) / 2 + (b - a) / 2 * t[k], width = (b - a) / 2 * weights[k];
      Omega.push_back(logarithmic ? std::exp(at) : std::max(at, 1e-6));
      measure.push_back(logarithmic ? width : width / Omega.back());
    }
  };
  for (int k = 0; k < panels; ++k) panel(low_end * k / panels, low_end * (k + 1) / panels, false);
  const double from = std::log(low_end), range = std::log(high_end / low_end);
  for (int k = 0; k < high_panels; ++k)
    panel(from + range * k / high_panels, from + range * (k + 1) / high_panels, true);

  const Problem problem = response_problem({5, 5}, cut_at_4, Lubricant{});
  const Response response = certified_response(problem, {.frequencies = Omega, .tolerance = 1e-5});
  const Solution steady = remembered("reference").solve(problem, {.tolerance = 1e-9});
  double integral = 0;
  for (std::size_t k = 0; k < Omega.size(); ++k)
    integral -= measure[k] * (1.0 / known_kappa(response.frequencies[k])).imag();
  const double beyond = -3 * (1.0 / known_kappa(response.frequencies.back())).imag();  // falls like Omega^(-1/3)
  const double punch = exact::flat_punch_compliance(-4, value_of(reading(steady, Quantity::pressure_exit)));
  Findings found;
  found.claims.push_back(
      claim_value(response_says("causality", 6, "Kramers and Kronig's relation holds between stiffness and damping"),
                  2 / pi * (integral + beyond), 1 / response.slow->kappa_0 - punch, 0,
                  Tolerance::asymptotic(2 / pi * beyond * std::pow(high_end, -1.0 / 3) * 10 + 1e-5,
                                        "next power of what lies beyond 1e8, times 10, and the tolerance of kappa"),
                  fmt::format("{} frequencies; {} from beyond 1e8", Omega.size(), plain(2 / pi * beyond, 3))));
  return found;
}

// ---- negative damping ----------------------------------------------------------------------------------------------

/// A contact is driven by its rolling: disturbances cross it in 2 b/u_m. Computed independently: .107, -.0049, .124,
/// .0084 at Omega = 1, 2, 3, 8.
Findings judge_negative_damping() {
  Lubricant oil = response_oil;
  oil.z = 0.62, oil.alpha_per_Pa = 1.9e-8;
  const Response response =
      certified_response(response_problem({40, 9}, cut_at_4, oil), {.frequencies = {1, 2, 3, 8}, .tolerance = 1e-6});
  Findings found;
  const char* printed[] = {"0.107", "-0.0049", "0.124", "0.0084"};
  for (std::size_t k = 0; k < response.frequencies.size(); ++k) {
    const Stiffness& at = response.frequencies[k];
    found.claims.push_back(
        claim_value(response_says("crossing/" + plain(at.Omega), 8,
                                  "Im kappa at (40, 9), negative at Omega = 2, is that of an independent program"),
                    known_kappa(at).imag(), std::stod(printed[k]), at.error * std::abs(at.kappa / at.kappa.imag()),
                    Tolerance::published_digits(printed[k]), "Im kappa = " + plain(at.kappa.imag(), 9)));
  }
  return found;
}

// ---- waviness ------------------------------------------------------------------------------------------------------

/// P_0'(0)/H_0(0) of a solution on polynomial elements.
double central_slope_over_film(const Fields& fields) {
  for (std::size_t e = 0; e + 1 < fields.elements.size(); ++e) {
    const Eigen::Index first = fields.elements[e], last = fields.elements[e + 1];
    if (!(fields.X[first] <= 0 && 0 < fields.X[last])) continue;
    const int degree = static_cast<int>(last - first);
    const double half = (fields.X[last] - fields.X[first]) / 2, t = -fields.X[first] / half - 1;
    const MatrixOf<double> modes = lobatto_to_legendre<double>(degree, lobatto_nodes<double>(degree));
    const VectorOf<double> P = modes * fields.P.segment(first, degree + 1).matrix(),
                           H = modes * fields.H.segment(first, degree + 1).matrix();
    return P.dot(legendre_derivatives(degree, t)) / half / H.dot(legendre(degree, t));
  }
  return nothing;
}

/// Pure rolling, k = 2 pi/lambda_w -> infinity: wedge and squeeze of R_1 cancel, and the pressure P_0' that drives oil
/// through the waves leaves -k^2 P_1 - 3 i k P_0' R_1/H = 0, which lifts the surface by P_1/k.
Findings judge_short_waves() {
  const Problem problem = response_problem({5, 5}, cut_at_4);
  const Response response =
      certified_response(problem, {.waviness = {{0.4, 1}, {0.2, 1}, {0.1, 1}, {0.05, 1}}, .tolerance = 1e-7});
  const Solution steady = remembered("reference").solve(problem, {.tolerance = 1e-9});
  const double slope = central_slope_over_film(steady.fields);
  std::vector<Amplitude> lift;  // over the expected one
  std::string note;
  for (const WavinessResponse& at : response.waviness) {
    const double k = at.waviness.wavenumber();
    lift.push_back((known_film(at) - 1.0) / Amplitude(0, -3 * slope / (k * k)));
    note += fmt::format("{} at {}; ", plain(at.amplitude_ratio(), 8), plain(at.waviness.wavelength));
  }
  const double off = std::abs(lift[3] - 1.0);
  Findings found;
  found.claims.push_back(
      claim(response_says("waviness/short", 9, "in pure rolling short waves pass, lifted by -3 i P_0'/(H_0 k^2)"),
            std::abs(2.0 * lift[3] - lift[2] - 1.0), 0,
            Tolerance::asymptotic(3 * off * off, "square of the remainder of first order, times 3"),
            fmt::format("{}off by {}, {}", note, plain(std::abs(lift[2] - 1.0), 2), plain(off, 2))));
  found.claims.push_back(
      claim(response_says("waviness/short/limit", 9, "the amplitude of short waves stays as it is, to the third order"),
            std::abs(response.waviness.back().amplitude_ratio() - 1), 0,
            Tolerance::asymptotic(std::pow(0.05, 3), "wavelength cubed, in b"), note));
  return found;
}

/// A long wave lifts and tilts the bodies, which changes no film at a constant load.
Findings judge_long_waves() {
  Findings found;
  for (const double slip : {0.0, 1.0, 2.0}) {
    const Response response =
        certified_response(response_problem({5, 5}, cut_at_4), {.waviness = {{50, slip}, {200, slip}}});
    const double shorter = std::abs(known_film(response.waviness.front())),
                 longer = std::abs(known_film(response.waviness.back()));
    found.claims.push_back(claim(response_says("waviness/long/" + plain(slip), 9,
                                               "long waves leave the film as it is, at least like 1/wavelength"),
                                 longer / shorter, 0,
                                 Tolerance::asymptotic(0.25 * (1 + 2 * pi / 50), "1/4, and the next power at 50 b"),
                                 fmt::format("{} at 50 b, {} at 200 b", plain(shorter, 5), plain(longer, 5))));
  }
  return found;
}

/// A light contact lets a waviness grow. Computed independently: 1.09 at (1.2, 4), 1.5 b.
Findings judge_growing_waves() {
  Findings found;
  for (const auto& [name, tolerance] : {std::pair{"reference", 1e-8}, std::pair{"fast", 1e-4}}) {
    const Response response = find_solver(name)->respond(
        response_problem({1.2, 4}, Flooded{}), {.waviness = {{.wavelength = 1.5, .slip = 1}}, .tolerance = tolerance});
    const WavinessResponse& at = response.waviness.front();
    Sentence says = response_says("waviness/growing/" + std::string(name), 9,
                                  "a light contact lets a waviness of pure rolling grow: " + std::string(name));
    says.solver = name;
    found.claims.push_back(claim_value(std::move(says), std::abs(known_film(at)), 1.09, at.error,
                                       Tolerance::published_digits("1.09"),
                                       "the film keeps " + plain(at.amplitude_ratio(), 9)));
  }
  return found;
}

}  // namespace

std::vector<Topic> response_motion_topics() {
  return {
      {.name = "response in time", .rungs = {8}, .judge = [] { return judge_time(1); }, .expected_s = 2},
      {.name = "response in time", .rungs = {8}, .judge = [] { return judge_time(3); }, .expected_s = 2},
      {.name = "waviness in time", .rungs = {8}, .judge = [] { return judge_waviness_in_time(1); }, .expected_s = 3},
      {.name = "waviness in time", .rungs = {8}, .judge = [] { return judge_waviness_in_time(0.5); }, .expected_s = 3},
      {.name = "response amplitude", .rungs = {8}, .judge = judge_amplitude},
      {.name = "response causality", .rungs = {6}, .slow = true, .judge = judge_causality, .expected_s = 15},
      {.name = "response crossing", .rungs = {8}, .judge = judge_negative_damping, .expected_s = 3},
      {.name = "short waves", .rungs = {9}, .judge = judge_short_waves, .expected_s = 4},
      {.name = "long waves", .rungs = {9}, .judge = judge_long_waves},
      {.name = "growing waves", .rungs = {9}, .judge = judge_growing_waves}};
}

}  // namespace ehd::verification
