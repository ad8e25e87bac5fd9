// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/exact/manufactured_motion.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace ehd::verification::exact {

namespace {

using Complex = ManufacturedMotion::Complex;

Manufactured with_flux_of_its_exit(const Manufactured& contact) {
  Manufactured::Choice choice = contact.choice();
  choice.flux = -contact.flux(0, 0, contact.film(choice.exit).value).value;
  return Manufactured(choice);
}

/// A real functional of a complex function.
Complex both_parts(const std::function<double(const std::function<double(double)>&)>& functional,
                   const std::function<Complex(double)>& f) {
  return {functional([&](double X) { return f(X).real(); }), functional([&](double X) { return f(X).imag(); })};
}

}  // namespace

ManufacturedMotion::ManufacturedMotion(const Manufactured& contact, const Choice& choice)
    : steady_(with_flux_of_its_exit(contact)), choice_(choice) {}

ManufacturedMotion ManufacturedMotion::about(const Manufactured& contact) {
  return {contact,
          {.Omega = 2.3,
           .pressure = {0.31, -0.17},
           .pressure_slope = {-0.12, 0.26},
           .offset = {-0.41, 0.22},
           .flux = {0.13, -0.37},
           .film = {0.19, 0.08},
           .film_wave = {-0.11, 0.24},
           .wavenumber = 1.7}};
}

ManufacturedMotion::Jet ManufacturedMotion::pressure(double X) const {
  const auto& at = steady_.choice();
  const double before = X - at.inlet, left = at.exit - X, u = (X - at.centre) / at.width;
  const Complex line = choice_.pressure + choice_.pressure_slope * X;
  const Complex g = before * left * line, g1 = (left - before) * line + before * left * choice_.pressure_slope;
  const double s = 1 / std::cosh(u), s1 = -s * std::tanh(u) / at.width;
  return {g * s, g1 * s + g * s1};
}

Complex ManufacturedMotion::film(double X) const {
  return choice_.film + choice_.film_wave * std::exp(Complex(0, -choice_.wavenumber * X));
}

Complex ManufacturedMotion::exit() const {
  const double X = steady_.choice().exit;
  return -pressure(X).slope / steady_.pressure(X).curvature;
}

Complex ManufacturedMotion::load() const {
  const auto& at = steady_.choice();
  return both_parts([&](const auto& f) { return integral(f, at.inlet, at.exit); },
                    [&](double X) { return pressure(X).value; });
}

Complex ManufacturedMotion::moving_pressure(double X, double by_exit) const {
  return pressure(X).value + steady_.pressure(X).slope * by_exit * exit();
}

Complex ManufacturedMotion::feature(double X) const {
  const auto& at = steady_.choice();
  const Complex potential = both_parts([&](const auto& f) { return log_potential(f, at.inlet, at.exit, X); },
                                       [&](double t) { return pressure(t).value; });
  return film(X) - choice_.offset + potential / std::numbers::pi;
}

Complex ManufacturedMotion::balance_source(double X) const {
  const auto F = [&](double x) {
    const auto P = steady_.pressure(x);
    return steady_.flux(P.value, P.slope, steady_.film(x).value);
  };
  const Complex squeezed =
      both_parts([&](const auto& f) { return integral(f, X, steady_.choice().exit); },
                 [&](double x) {
                   const auto oil = F(x);
                   return oil.density_slope * pressure(x).value * steady_.film(x).value + oil.density * film(x);
                 });
  const auto here = F(X);
  const Jet P = pressure(X);
  return here.by_pressure * P.value + here.by_slope * P.slope + here.by_film * film(X) + choice_.flux +
         Complex(0, choice_.Omega) * squeezed;
}

}  // namespace ehd::verification::exact
