// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rheology.hpp"

namespace ehd {

namespace {
template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;
}  // namespace

DowsonHigginson dowson_higginson_per_Pa() { return {.a = 0.34 / 5.9e8, .c = 1 / 5.9e8}; }

DowsonHigginson dowson_higginson_1977_per_Pa() { return {.a = 0.6e-9, .c = 1.7e-9}; }

Viscosity in_units_of(const Viscosity& law, double unit) {
  return std::visit(Overloaded{[](const Isoviscous& l) -> Viscosity { return l; },
                               [&](const Barus& l) -> Viscosity { return Barus{l.alpha * unit}; },
                               [&](const Roelands& l) -> Viscosity {
                                 return Roelands{.alpha = l.alpha * unit, .p0 = l.p0 / unit, .z = l.z};
                               }},
                    law);
}

Density in_units_of(const Density& law, double unit) {
  return std::visit(
      Overloaded{[](const Incompressible& l) -> Density { return l; },
                 [&](const DowsonHigginson& l) -> Density {
                   return DowsonHigginson{.a = l.a * unit, .c = l.c * unit};
                 }},
      law);
}

double ambient_slope(const Viscosity& law) {
  return std::visit(Overloaded{[](const Isoviscous&) { return 0.0; }, [](const Barus& l) { return l.alpha; },
                               [](const Roelands& l) { return l.alpha; }},
                    law);
}

std::string_view name(const Viscosity& law) {
  return std::visit(Overloaded{[](const Isoviscous&) { return std::string_view{"isoviscous"}; },
                               [](const Barus&) { return std::string_view{"barus"}; },
                               [](const Roelands&) { return std::string_view{"roelands"}; }},
                    law);
}

std::string_view name(const Density& law) {
  return std::visit(
      Overloaded{[](const Incompressible&) { return std::string_view{"incompressible"}; },
                 [](const DowsonHigginson&) { return std::string_view{"dowson-higginson"}; }},
      law);
}

}  // namespace ehd
