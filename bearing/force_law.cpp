// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/force_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"

namespace ehd::bearing {

namespace {

constexpr double exponent = 10.0 / 9.0;

/// From N and mm: f = c l^(8/9) delta^(10/9).
PowerLaw power_law_from_mm(double c, double length_m) {
  return {c * std::pow(1e3 * length_m, 8.0 / 9.0) * std::pow(1e3, exponent)};
}

}  // namespace

PowerLaw palmgren_law(double length_m) { return power_law_from_mm(8.06e4, length_m); }
PowerLaw iso_law(double length_m) { return power_law_from_mm(35948 * std::pow(2.0, exponent), length_m); }

double PowerLaw::force(double approach_m) const {
  return approach_m > 0 ? coefficient * std::pow(approach_m, exponent) : 0;
}
double PowerLaw::stiffness(double approach_m) const {
  return approach_m > 0 ? exponent * coefficient * std::pow(approach_m, exponent - 1) : 0;
}
double PowerLaw::approach(double force_N) const { return std::pow(force_N / coefficient, 1 / exponent); }
double PowerLaw::compliance(double force_N) const {
  return std::pow(force_N / coefficient, 1 / exponent - 1) / (exponent * coefficient);
}

double LinearLaw::begins_at() const {
  return unloading == Unloading::at_zero_approach ? std::max(0.0, -dF_N / K_N_per_m) : -dF_N / K_N_per_m;
}
double LinearLaw::force(double approach_m) const {
  return approach_m > begins_at() ? std::max(0.0, K_N_per_m * approach_m + dF_N) : 0;
}
double LinearLaw::stiffness(double approach_m) const { return approach_m > begins_at() ? K_N_per_m : 0; }
double LinearLaw::approach(double force_N) const { return std::max(begins_at(), (force_N - dF_N) / K_N_per_m); }
double LinearLaw::compliance(double force_N) const {
  return (force_N - dF_N) / K_N_per_m >= begins_at() ? 1 / K_N_per_m : 0;
}

CurveLaw::CurveLaw(std::shared_ptr<const FilmCurve> curve, double datum_m)
    : curve_(std::move(curve)), datum_m_(datum_m) {
  // delta_dry' > 0 needs x_0 > b/2, and F falls with the load; both are looked at where the law is used, densely.
  const double lightest = curve_->lightest_N() / 64, heaviest = curve_->heaviest_N();
  constexpr int samples = 400;
  for (int k = 0; k <= samples; ++k) {
    const double f = lightest * std::pow(heaviest / lightest, static_cast<double>(k) / samples);
    if (compliance(f) > 0) continue;
    char text[256];
    std::snprintf(text, sizeof text,
                  "the approach does not increase with the contact force at %.4g N (datum x_0 = %.4g m, contact half "
                  "width %.4g m); state a larger datum.x0_m or another datum.law",
                  f, datum_m, hertz::half_width_m(curve_->contact().at(f)));
    throw std::domain_error(text);
  }
}

double CurveLaw::begins_at() const { return -std::numeric_limits<double>::infinity(); }

double CurveLaw::approach(double force_N) const {
  const double heaviest = curve_->heaviest_N();
  if (force_N > heaviest) return approach(heaviest) + compliance(heaviest) * (force_N - heaviest);
  return dry_approach_m(curve_->contact().at(force_N), datum_m_) - curve_->offset_film(force_N).value;
}

double CurveLaw::compliance(double force_N) const {
  const double f = std::min(force_N, curve_->heaviest_N());
  // delta_dry = (4 f/(pi E' l)) [ln(2 x_0/b) + 1/2] with b ~ sqrt(f).
  const double dry = dry_approach_m(curve_->contact().at(f), datum_m_) / f - curve_->compliance_scale() / 2;
  return dry - curve_->offset_film(f).slope;
}

double CurveLaw::force(double approach_m) const {
  // Bracket in powers of two from the heaviest solved load, then Newton in ln f, halving where it leaves the bracket.
  double low = curve_->heaviest_N(), high = low;
  while (approach(low) > approach_m) low /= 2;
  while (approach(high) < approach_m) high *= 2;
  double f = std::sqrt(low * high);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const double excess = approach(f) - approach_m;
    if (excess == 0) return f;
    (excess < 0 ? low : high) = f;
    const double step = -excess / (compliance(f) * f);
    double next = f * std::exp(std::clamp(step, -2.0, 2.0));
    if (!(next > low && next < high)) next = std::sqrt(low * high);
    if (std::abs(next - f) <= 2 * std::numeric_limits<double>::epsilon() * f) return next;
    f = next;
  }
  return f;
}

double force(const ForceLaw& law, double approach_m) {
  return std::visit([&](const auto& one) { return one.force(approach_m); }, law);
}
double stiffness(const ForceLaw& law, double approach_m) {
  return std::visit([&](const auto& one) { return one.stiffness(approach_m); }, law);
}
double approach(const ForceLaw& law, double force_N) {
  if (!(force_N > 0)) return begins_at(law);
  return std::visit([&](const auto& one) { return one.approach(force_N); }, law);
}
double compliance(const ForceLaw& law, double force_N) {
  return std::visit([&](const auto& one) { return one.compliance(force_N); }, law);
}
double begins_at(const ForceLaw& law) {
  return std::visit([](const auto& one) { return one.begins_at(); }, law);
}

std::optional<std::pair<double, double>> domain(const ForceLaw& law) {
  if (const auto* line = std::get_if<LinearLaw>(&law)) return line->fitted_N;
  if (const auto* curve = std::get_if<CurveLaw>(&law)) return std::pair{0.0, curve->curve().heaviest_N()};
  return std::nullopt;
}

}  // namespace ehd::bearing
