// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/manufactured.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <variant>

#include "contact/nondimensional.hpp"
#include "contact/overloaded.hpp"
#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

using std::numbers::pi;

namespace {

/// A law at one pressure: its value and its derivative to pressure.
struct Law {
  double value = 0, slope = 0;
};

/// The laws are written out here again, so that the formulas of contact/rheology.hpp are not checked by themselves.
Law log_viscosity(const Viscosity& law, double P) {
  return std::visit(
      Overloaded{[](const Isoviscous&) { return Law{}; },
                 [P](const Barus& barus) {
                   return Law{barus.alpha * P, barus.alpha};
                 },
                 [P](const Roelands& roelands) {
                   const auto [alpha, p0, z] = roelands;
                   return Law{alpha * p0 / z * (std::pow(1 + P / p0, z) - 1), alpha * std::pow(1 + P / p0, z - 1)};
                 }},
      law);
}

Law relative_density(const Density& law, double P) {
  return std::visit(Overloaded{[](const Incompressible&) { return Law{.value = 1, .slope = 0}; },
                               [P](const DowsonHigginson& dh) {
                                 const double room = 1 + dh.c * P;
                                 return Law{1 + dh.a * P / room, dh.a / (room * room)};
                               }},
                    law);
}

/// The same law with the alpha that follows from L.
Viscosity with_alpha(const Viscosity& law, double alpha) {
  return std::visit(Overloaded{[](const Isoviscous& one) -> Viscosity { return one; },
                               [alpha](const Barus&) -> Viscosity { return Barus{.alpha = alpha}; },
                               [alpha](Roelands one) -> Viscosity {
                                 one.alpha = alpha;
                                 return one;
                               }},
                    law);
}

}  // namespace

Manufactured::Manufactured(const Choice& choice) : choice_(choice), lambda_(3 * pi * pi / (8 * choice.M * choice.M)) {
  choice_.viscosity = with_alpha(choice.viscosity, choice.L * std::sqrt(choice.M / (2 * pi)));
  amplitude_ =
      pi / 2 * (1 + choice.load) / integral([this](double X) { return pressure(X).value; }, choice.inlet, choice.exit);
}

Manufactured Manufactured::compressible() {
  return Manufactured({.M = 4.3,
                       .L = 5.2,
                       .viscosity = Roelands{.p0 = 0.47, .z = 0.61},
                       .density = DowsonHigginson{.a = 0.29, .c = 0.83},
                       .inlet = -3.6,
                       .exit = 1.17,
                       .offset = -0.31,
                       .flux = 0.43,
                       .load = 0.06,
                       .centre = -0.13,
                       .width = 0.57,
                       .film = 0.29,
                       .film_centre = 0.11,
                       .film_roundness = 1.3});
}

Manufactured Manufactured::barus() {
  return Manufactured({.M = 6.1,
                       .L = 3.4,
                       .viscosity = Barus{},
                       .density = Incompressible{},
                       .inlet = -2.9,
                       .exit = 1.23,
                       .offset = -0.37,
                       .flux = 0.38,
                       .load = -0.04,
                       .centre = 0.08,
                       .width = 0.52,
                       .film = 0.24,
                       .film_centre = -0.09,
                       .film_roundness = 1.5});
}

Problem Manufactured::problem() const {
  const Groups groups = groups_from(MoesGroups{.M = choice_.M, .L = choice_.L});
  const auto sources = std::make_shared<Sources>();
  sources->film = [self = *this](double X) { return self.film_source(X); };
  sources->balance = [self = *this](double X) { return self.balance_source(X); };
  sources->load = choice_.load;
  return {.groups = groups,
          .viscosity = with_alpha(choice_.viscosity, groups.alpha_p_H),
          .density = choice_.density,
          .inlet = TruncatedAt{choice_.inlet},
          .sources = sources};
}

Manufactured::Jet Manufactured::pressure(double X) const {
  const double before = X - choice_.inlet, left = choice_.exit - X, w = choice_.width, u = (X - choice_.centre) / w;
  const double g = before * left * left, g1 = left * left - 2 * before * left, g2 = 2 * before - 4 * left;
  const double s = 1 / std::cosh(u), s1 = -s * std::tanh(u) / w, s2 = s * (1 - 2 * s * s) / (w * w);
  return {amplitude_ * g * s, amplitude_ * (g1 * s + g * s1), amplitude_ * (g2 * s + 2 * g1 * s1 + g * s2)};
}

Manufactured::Jet Manufactured::film(double X) const {
  const double y = X - choice_.film_centre, y2 = y * y, room = choice_.film_roundness * choice_.film_roundness + y2;
  return {.value = choice_.film + y2 * y2 / (2 * room), .slope = 2 * y * y2 / room - y * y2 * y2 / (room * room)};
}

std::pair<double, double> Manufactured::film_source(double X) const {
  const Jet H = film(X);
  const double J = log_potential([this](double t) { return pressure(t).value; }, choice_.inlet, choice_.exit, X);
  const double J1 = log_potential([this](double t) { return pressure(t).slope; }, choice_.inlet, choice_.exit, X);
  return {H.value - choice_.offset - X * X / 2 + J / pi, H.slope - X + J1 / pi};
}

Manufactured::Flux Manufactured::flux(double P, double slope, double H) const {
  const Law a = log_viscosity(choice_.viscosity, P), rho = relative_density(choice_.density, P);
  const double m = rho.value * std::pow(H, 3) * std::exp(-a.value) / lambda_;
  return {.value = m * slope - rho.value * H,
          .by_pressure = m * slope * (rho.slope / rho.value - a.slope) - rho.slope * H,
          .by_slope = m,
          .by_film = 3 * m * slope / H - rho.value,
          .density = rho.value,
          .density_slope = rho.slope};
}

std::pair<double, double> Manufactured::balance_source(double X) const {
  const Jet P = pressure(X), H = film(X);
  const Flux F = flux(P.value, P.slope, H.value);
  return {F.value + choice_.flux, F.by_pressure * P.slope + F.by_slope * P.curvature + F.by_film * H.slope};
}

std::complex<double> Manufactured::pole() const { return {choice_.centre, pi * choice_.width / 2}; }

}  // namespace ehd::verification::exact
