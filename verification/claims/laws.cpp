// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 0: from SI to dimensionless groups and back. Groups, scales and laws of a steel contact are computed here again
// from the printed formulas, by other steps than in contact/. So are a result's metres and Moes units.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "contact/nondimensional.hpp"
#include "contact/observables.hpp"
#include "io/contact_json.hpp"
#include "io/json.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "workflow/contact_run.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;

constexpr double load = 1.3e5, radius = 1.1e-2, modulus = 2.21e11, sum_speed = 2.7, viscosity = 0.028;
constexpr double z = 0.64, p0 = 1.9613e8;

Conditions contact() {
  return {.load_N_per_m = load,
          .reduced_radius_m = radius,
          .reduced_modulus_Pa = modulus,
          .speed_sum_m_per_s = sum_speed,
          .viscosity_Pa_s = viscosity};
}

/// By Roelands' law alpha is absent: it follows from z and eta_0.
Lubricant oil_of(ViscosityLaw law, DensityLaw density) {
  Lubricant oil;
  oil.viscosity = law;
  oil.density = density;
  oil.z = z;
  oil.p0_Pa = p0;
  if (law == ViscosityLaw::barus) oil.alpha_per_Pa = 1.9e-8;
  return oil;
}

void add(Findings& found, const std::string& id, const std::string& statement, double value, double expected) {
  found.claims.push_back(
      claim_value({.id = "inputs/" + id, .rung = 0, .statement = statement}, value, expected, 0, rounding()));
}

Findings judge_groups() {
  Findings found;
  const Nondimensional made =
      nondimensionalise(contact(), oil_of(ViscosityLaw::barus, DensityLaw::incompressible), Flooded{});
  const double pressure = std::sqrt(load * modulus / (2 * pi * radius));  // p_H = sqrt(w E'/(2 pi R))
  const double half_width = 4 * radius * pressure / modulus;
  add(found, "scales/hertz-pressure", "p_H = sqrt(w E'/(2 pi R))", made.scales->hertz_pressure_Pa, pressure);
  add(found, "scales/half-width", "b = 4 R p_H/E'", made.scales->half_width_m.value(), half_width);
  add(found, "scales/film", "one unit of H is b^2/R", made.scales->film_m_per_hertz_film().value(),
      half_width * half_width / radius);
  add(found, "groups/lambda", "lambda = 12 eta_0 u_m R^2/(b^3 p_H) with the mean speed", made.problem.groups.lambda,
      12 * viscosity * (sum_speed / 2) * radius * radius / (half_width * half_width * half_width * pressure));
  add(found, "groups/alpha-p_H", "the exponent is alpha p_H", made.problem.groups.alpha_p_H, 1.9e-8 * pressure);
  const double U = viscosity * sum_speed / (modulus * radius);
  add(found, "groups/M", "M = w/sqrt(eta_0 u_s E' R)", made.problem.groups.M,
      load / std::sqrt(viscosity * sum_speed * modulus * radius));
  add(found, "groups/L", "L = alpha E' (eta_0 u_s/(E' R))^(1/4)", made.problem.groups.L,
      1.9e-8 * modulus * std::sqrt(std::sqrt(U)));
  return found;
}

/// ln(eta/eta_0) and rho/rho_0 of the problem at a pressure in Pa.
Findings judge_laws() {
  Findings found;
  double worst_roelands = 0, worst_slope = 0, worst_density[2] = {0, 0};
  const auto problem_of = [](ViscosityLaw law, DensityLaw density) {
    return nondimensionalise(contact(), oil_of(law, density), Flooded{});
  };
  const Nondimensional first = problem_of(ViscosityLaw::roelands, DensityLaw::dowson_higginson);
  const Nondimensional second = problem_of(ViscosityLaw::roelands, DensityLaw::dowson_higginson_1977);
  const double unit = first.scales->hertz_pressure_Pa;
  int judged = 0;
  for (const double p : {2e7, 1.9e8, 6.1e8, 1.7e9}) {
    const auto at = [&](const auto& law, double pressure) {
      return evaluate(law, Array(Array::Constant(1, pressure / unit)));
    };
    const double exponent = (std::log(viscosity) + 9.67) * (-1 + std::pow(1 + p / p0, z));
    const auto eta = at(first.problem.viscosity, p);
    worst_roelands = worse(worst_roelands, std::abs(eta.value[0] / exponent - 1));
    // Slopes by central differences. Steps of 1e-5 p err by 1e-10 (third derivative) and 1e-11 (rounding).
    const double step = 1e-5 * p;
    const double slope =
        (at(first.problem.viscosity, p + step).value[0] - at(first.problem.viscosity, p - step).value[0]) /
        (2 * step / unit);
    const double of_density =
        (at(first.problem.density, p + step).value[0] - at(first.problem.density, p - step).value[0]) /
        (2 * step / unit);
    worst_slope = worse(worst_slope, std::abs(eta.slope[0] / slope - 1),
                        std::abs(at(first.problem.density, p).slope[0] - of_density));
    worst_density[0] = worse(worst_density[0],
                             std::abs(at(first.problem.density, p).value[0] / ((5.9e8 + 1.34 * p) / (5.9e8 + p)) - 1));
    worst_density[1] = worse(
        worst_density[1], std::abs(at(second.problem.density, p).value[0] / (1 + 0.6e-9 * p / (1 + 1.7e-9 * p)) - 1));
    ++judged;
  }
  const auto claim_of = [&](const std::string& id, const std::string& statement, double error, Tolerance tolerance) {
    found.claims.push_back(claim({.id = "inputs/laws/" + id, .rung = 0, .statement = statement}, error, 0,
                                 std::move(tolerance), fmt::format("{} pressures, 20 MPa to 1.7 GPa", judged)));
  };
  claim_of("roelands", "eta is Roelands' eta_0 exp((ln eta_0 + 9.67)((1 + p/p_0)^z - 1))", worst_roelands, rounding());
  claim_of("dowson-higginson", "rho is rho_0 (5.9e8 + 1.34 p)/(5.9e8 + p)", worst_density[0], rounding());
  claim_of("dowson-higginson-1977", "rho is rho_0 (1 + 0.6e-9 p/(1 + 1.7e-9 p))", worst_density[1], rounding());
  claim_of("slopes", "the laws' slopes are their derivatives", worst_slope, Tolerance::discretisation(1e-10, 10));
  {  // alpha and eta_0 given: z follows
    Lubricant oil = oil_of(ViscosityLaw::roelands, DensityLaw::incompressible);
    oil.z.reset();
    oil.alpha_per_Pa = 2.05e-8;
    const double follows = 2.05e-8 * p0 / (std::log(viscosity) + 9.67), p = 7.3e8;
    add(found, "laws/roelands-from-alpha", "z follows from alpha and eta_0 where it is not stated",
        evaluate(nondimensionalise(contact(), oil, Flooded{}).problem.viscosity, Array(Array::Constant(1, p / unit)))
            .value[0],
        (std::log(viscosity) + 9.67) * (-1 + std::pow(1 + p / p0, follows)));
  }
  const Nondimensional barus = problem_of(ViscosityLaw::barus, DensityLaw::incompressible);
  const double p = 8.3e8;
  add(found, "laws/barus", "eta is Barus' eta_0 exp(alpha p)",
      evaluate(barus.problem.viscosity, Array(Array::Constant(1, p / unit))).value[0], 1.9e-8 * p);
  return found;
}

/// The films of a result in Hertz, Moes' and SI units are the same films.
Findings judge_units_of_a_result() {
  ContactCase stated;
  stated.statement = contact();
  stated.lubricant = oil_of(ViscosityLaw::roelands, DensityLaw::dowson_higginson);
  stated.inlet = Flooded{};
  const ContactRun run = run_contact(stated, default_solver(), {.tolerance = 1e-3});
  const Json json = to_json(run);
  const double pressure = std::sqrt(load * modulus / (2 * pi * radius)), half_width = 4 * radius * pressure / modulus;
  const double metres = half_width * half_width / radius;
  const double moes = metres / radius / std::sqrt(viscosity * sum_speed / (modulus * radius));
  Findings found;
  for (const char* film : {"minimum", "central", "couette"}) {
    const Json& said = json.at("film").at(film);
    const double H = said.at("hertz");
    add(found, std::string("result/") + film + "/m", std::string("the ") + film + " film in metres is H b^2/R",
        said.at("m"), H * metres);
    add(found, std::string("result/") + film + "/moes",
        std::string("the ") + film + " film in Moes' units is (h/R) U_s^(-1/2)", said.at("moes"), H * moes);
  }
  const double offset = json.at("film").at("offset").at("hertz");
  add(found, "result/approach/m", "the approach with x_0 = b is -H_0 b^2/R", json.at("approach").at("m"),
      -offset * metres);
  const Json& groups = json.at("groups");
  const double U = viscosity * sum_speed / (modulus * radius), alpha = z * (std::log(viscosity) + 9.67) / p0;
  add(found, "result/groups/p_H", "the result's p_H is sqrt(w E'/(2 pi R))", groups.at("hertz_pressure_Pa"), pressure);
  add(found, "result/groups/half-width", "the result's b is 4 R p_H/E'", groups.at("half_width_m"), half_width);
  add(found, "result/groups/W", "the result's W is w/(E' R)", groups.at("W"), load / (modulus * radius));
  add(found, "result/groups/U", "the result's U has the mean speed", groups.at("U_mean"), U / 2);
  add(found, "result/groups/G", "the result's G is alpha E', alpha from z and eta_0", groups.at("G"), alpha * modulus);
  add(found, "result/exit", "the result's exit is where its pressure ends, nearly",
      std::round(50 * json.at("pressure").at("exit_x").get<double>()) / 50,
      std::round(50 * run.solution.fields.X[run.solution.fields.X.size() - 1]) / 50);
  return found;
}

/// The quantities of made-up fields, each of which is known beforehand.
Findings judge_observed() {
  constexpr int n = 400;
  Fields fields;
  fields.X = Array::LinSpaced(n + 1, -3.0, 1.5);
  const Array& X = fields.X;
  fields.P = (1 - X / 1.5).max(0) * (X + 3) / 4;  // a parabola: 0 at both ends
  fields.P[n] = 0;
  fields.H = 0.2 + 0.3 * (X - 0.4).square();
  fields.density = Array::Ones(n + 1);
  fields.log_viscosity = Array::Zero(n + 1);
  fields.flux = Array::Constant(n, fields.H[n]);
  fields.flux[17] *= 1.07;
  fields.offset = -0.31;
  const Observables seen = observe(fields, want_everything());
  Findings found;
  const auto read = [&](Quantity quantity) { return value_of(observed(seen, quantity)); };
  const auto add_with = [&](const std::string& id, const std::string& statement, double value, double expected,
                            Tolerance tolerance) {
    found.claims.push_back(claim_value({.id = "inputs/observed/" + id, .rung = 0, .statement = statement}, value,
                                       expected, 0, std::move(tolerance)));
  };
  // Parabolas through nodes reproduce a parabola. The search for a minimum ends within the square root of rounding.
  const Tolerance sharp = Tolerance::round_off(1e3), place = Tolerance::discretisation(1e-7, 10);
  // P = (3 - 2X)(X + 3)/12: largest at -3/4, 27/32. Int P dX = 81/32; P' = (-4X - 3)/12.
  constexpr double h = 4.5 / n, integral = 81.0 / 32;
  add_with("minimum", "the smallest film of a parabola is its vertex", read(Quantity::film_minimum), 0.2, sharp);
  add_with("minimum-place", "and stands where it is", place_of(observed(seen, Quantity::film_minimum)), 0.4, place);
  add_with("central", "the central film is the one at X = 0", read(Quantity::film_central), 0.2 + 0.3 * 0.16, sharp);
  add_with("couette", "the Couette film is the flux at the exit", read(Quantity::film_couette), 0.2 + 0.3 * 1.21,
           sharp);
  add_with("exit", "the exit is where the pressure ends", read(Quantity::pressure_exit), 1.5, sharp);
  add_with("approach", "the approach is minus the offset", read(Quantity::approach), 0.31, sharp);
  add_with("pressure", "the largest pressure of a parabola is its vertex", read(Quantity::pressure_maximum), 27.0 / 32,
           sharp);
  add_with("pressure-place", "and stands where it is", place_of(observed(seen, Quantity::pressure_maximum)), -0.75,
           place);
  // The trapezoid rule errs by h^2/12 times the change of the slope, -4.5/3.
  add_with("load-error", "the load's error is 2/pi Int P dX less 1", read(Quantity::load_error),
           2 / pi * (integral - h * h / 12 * 1.5) - 1, Tolerance::round_off(1e4));
  add_with("flux-variation", "the flux's variation is its largest distance from the exit's",
           read(Quantity::flux_variation), 0.07, Tolerance::round_off(1e3));
  // Int H P' dX by hand: Int (.2 + .3 (X - .4)^2)(-4X - 3)/12 dX over [-3, 1.5].
  const auto antiderivative = [](double x) {
    // .248 - .24 x + .3 x^2 times (-4x - 3)/12
    return (-0.744 * x + (-0.992 + 0.72) / 2 * x * x + (0.96 - 0.9) / 3 * x * x * x - 1.2 / 4 * x * x * x * x) / 12;
  };
  add_with("rolling-force", "the rolling force is half of Int H dP", read(Quantity::rolling_force),
           std::abs(antiderivative(1.5) - antiderivative(-3)) / 2, Tolerance::discretisation(h * h, 1));
  return found;
}

}  // namespace

std::vector<Topic> law_topics() {
  return {{.name = "groups and scales", .rungs = {0}, .judge = judge_groups},
          {.name = "laws", .rungs = {0}, .judge = judge_laws},
          {.name = "units of a result", .rungs = {0}, .judge = judge_units_of_a_result},
          {.name = "observed quantities", .rungs = {0}, .judge = judge_observed}};
}

}  // namespace ehd::verification
