// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rheology.hpp"

namespace ehd {

namespace {

template <class Law>
std::vector<double> key_of(const Law& law) {
  std::vector<double> key{static_cast<double>(law.index())};
  for (const LawParameter& one : parameters(law)) key.push_back(one.value);
  return key;
}

}  // namespace

Viscosity in_units_of(const Viscosity& law, double unit) {
  return std::visit([&](const ViscosityFormula auto& one) -> Viscosity { return one.in_units_of(unit); }, law);
}

Density in_units_of(const Density& law, double unit) {
  return std::visit([&](const DensityFormula auto& one) -> Density { return one.in_units_of(unit); }, law);
}

bool is_trivial(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& one) { return one.trivial; }, law);
}

bool is_trivial(const Density& law) {
  return std::visit([](const DensityFormula auto& one) { return one.trivial; }, law);
}

double ambient_slope(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& one) { return one.ambient_slope(); }, law);
}

std::string_view name(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& one) { return one.name; }, law);
}

std::string_view name(const Density& law) {
  return std::visit([](const DensityFormula auto& one) { return one.name; }, law);
}

std::string_view formula(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& one) { return one.formula; }, law);
}

std::string_view formula(const Density& law) {
  return std::visit([](const DensityFormula auto& one) { return one.formula; }, law);
}

std::vector<LawParameter> parameters(const Viscosity& law) {
  return std::visit([](const ViscosityFormula auto& one) { return one.parameters(); }, law);
}

std::vector<LawParameter> parameters(const Density& law) {
  return std::visit([](const DensityFormula auto& one) { return one.parameters(); }, law);
}

std::vector<double> cache_key(const Viscosity& law) { return key_of(law); }
std::vector<double> cache_key(const Density& law) { return key_of(law); }

}  // namespace ehd
