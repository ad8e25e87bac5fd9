// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rheology.hpp"

namespace ehd {

namespace {

template <class Law>
std::vector<double> key_of(const Law& law) {
  std::vector<double> key{static_cast<double>(law.index())};
  const std::vector<double> parameters = std::visit([](const auto& formula) { return formula.parameters(); }, law);
  key.insert(key.end(), parameters.begin(), parameters.end());
  return key;
}

}  // namespace

Viscosity in_units_of(const Viscosity& law, double unit) {
  return std::visit([&](const ViscosityFormula auto& formula) -> Viscosity { return formula.in_units_of(unit); }, law);
}

Density in_units_of(const Density& law, double unit) {
  return std::visit([&](const DensityFormula auto& formula) -> Density { return formula.in_units_of(unit); }, law);
}

bool is_trivial(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& formula) { return formula.trivial; }, law);
}

bool is_trivial(const Density& law) {
  return std::visit([](const DensityFormula auto& formula) { return formula.trivial; }, law);
}

double ambient_slope(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& formula) { return formula.ambient_slope(); }, law);
}

std::string_view name(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& formula) { return formula.name; }, law);
}

std::string_view name(const Density& law) {
  return std::visit([](const DensityFormula auto& formula) { return formula.name; }, law);
}

std::vector<double> cache_key(const Viscosity& law) { return key_of(law); }
std::vector<double> cache_key(const Density& law) { return key_of(law); }

}  // namespace ehd
