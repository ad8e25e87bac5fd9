// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing/force_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "contact/approach.hpp"
#include "contact/hertz.hpp"
#include "contact/overloaded.hpp"
#include "contact/text.hpp"

namespace ehd::bearing {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double roller_exponent = 10.0 / 9.0;

// ---- Inverse of a logarithmic law
/// Newton in the logarithm ends by rounding long before this.
constexpr int most_logarithm_iterations = 50;
/// Newton's steps in the force itself: they give back the digits that the exponential of the logarithm loses.
constexpr int polishing_steps = 2;

// ---- Inverse of a curve
/// Newton in the bracket ends by rounding long before this.
constexpr int most_curve_iterations = 200;
/// Newton's step in ln f is at most this long.
constexpr double longest_step = 2;

// ---- Where a curve is looked at for a rising approach
/// Forces, equally spaced in their logarithm, from this part of the lightest solved force to the heaviest.
constexpr int rising_samples = 400;
constexpr double rising_from = 1.0 / 64;

std::string beyond_the_logarithm(double force_N, double heaviest_N) {
  return fmt::format(
      "a contact would carry {} N, beyond the domain of its law: the half width must stay below an eighth of the "
      "length in the logarithm, allowed is up to {} N",
      plain(force_N), plain(heaviest_N));
}

/// From N and mm: f = c l^(8/9) delta^(10/9).
PowerLaw power_law_from_mm(double c, double length_m) {
  return {c * std::pow(1e3 * length_m, 8.0 / 9.0) * std::pow(1e3, roller_exponent), roller_exponent};
}

}  // namespace

PowerLaw palmgren_law(double length_m) { return power_law_from_mm(8.06e4, length_m); }
PowerLaw iso_law(double length_m) { return power_law_from_mm(35948 * std::pow(2.0, roller_exponent), length_m); }
PowerLaw houpert_law(const RollerContact& contact, Raceway raceway) {
  const PowerApproach terms = houpert_terms(contact, raceway);
  return {std::pow(terms.scale, -1 / terms.exponent), 1 / terms.exponent};
}
LogarithmicLaw lundberg_law(const RollerContact& contact, Raceway raceway) {
  return LogarithmicLaw(lundberg_terms(contact, raceway));
}
LogarithmicLaw tripp_law(const RollerContact& contact, Raceway raceway) {
  return LogarithmicLaw(tripp_terms(contact, raceway));
}

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

double PowerLaw::rise(double from_N, double by_N) const {
  if (by_N >= from_N) return approach(from_N + by_N) - approach(from_N);
  return approach(from_N) * std::expm1(std::log1p(by_N / from_N) / exponent);
}

double LogarithmicLaw::logarithm(double force_N) const {
  const double ratio = terms_.limit_N / force_N;
  return std::isfinite(ratio) ? std::log(ratio) : std::log(terms_.limit_N) - std::log(force_N);
}
double LogarithmicLaw::approach(double force_N) const {
  const double heaviest = heaviest_N();
  if (force_N > heaviest) return approach(heaviest) + compliance(heaviest) * (force_N - heaviest);
  return force_N > 0 ? terms_.scale_m_per_N * force_N * logarithm(force_N) : 0;
}
double LogarithmicLaw::compliance(double force_N) const {
  if (!(force_N > 0)) return infinity;
  return terms_.scale_m_per_N * (logarithm(std::min(force_N, heaviest_N())) - 1);
}
double LogarithmicLaw::stiffness(double approach_m) const {
  return approach_m > 0 ? 1 / compliance(force(approach_m)) : 0;
}
double LogarithmicLaw::force(double approach_m) const {
  if (!(approach_m > 0)) return 0;
  const double heaviest = heaviest_N(), farthest = approach(heaviest);
  if (approach_m > farthest) return heaviest + (approach_m - farthest) / compliance(heaviest);
  // With f = limit exp(-L) the law is L - ln L = A: convex and increasing for L > 1, and L >= ln 64 here, so that
  // Newton from A + ln A, which lies below the root and above 1, steps over it once and then falls to it.
  const double A = std::log(terms_.scale_m_per_N * terms_.limit_N) - std::log(approach_m);
  double L = A + std::log(A);
  for (int iteration = 0; iteration < most_logarithm_iterations; ++iteration) {
    const double step = (L - std::log(L) - A) / (1 - 1 / L);
    L -= step;
    if (std::abs(step) <= 4 * epsilon * L) break;
  }
  // exp(-L) keeps an L-th of the digits of L; two more steps in f itself, where the law is good to an ulp or two.
  double f = terms_.limit_N * std::exp(-L);
  for (int polish = 0; polish < polishing_steps; ++polish) f -= (approach(f) - approach_m) / compliance(f);
  return f;
}
double LogarithmicLaw::rise(double from_N, double by_N) const {
  const double heaviest = heaviest_N(), to_N = from_N + by_N;
  if (from_N >= heaviest) return compliance(heaviest) * by_N;
  if (to_N > heaviest) return rise_inside(from_N, heaviest - from_N) + compliance(heaviest) * (to_N - heaviest);
  return rise_inside(from_N, by_N);
}
double LogarithmicLaw::rise_inside(double from_N, double by_N) const {
  if (!(from_N > 0)) return approach(by_N);
  return terms_.scale_m_per_N * (by_N * logarithm(from_N + by_N) - from_N * std::log1p(by_N / from_N));
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
double LinearLaw::rise(double from_N, double by_N) const {
  // Cut at delta = 0, the law carries up to dF there without any approach.
  const double carried_N = unloading == Unloading::at_zero_approach ? std::max(0.0, dF_N) : 0;
  const double still_N = std::max(0.0, carried_N - from_N);
  return std::max(0.0, by_N - still_N) / K_N_per_m;
}

CurveLaw::CurveLaw(std::shared_ptr<const FilmCurve> curve, double datum_m)
    : curve_(std::move(curve)), datum_m_(datum_m) {
  // delta_dry' > 0 needs x_0 > b/2, and F falls with the load; both are looked at where the law is used, densely.
  const double lightest = curve_->lightest_N() * rising_from, heaviest = curve_->heaviest_N();
  for (int k = 0; k <= rising_samples; ++k) {
    const double f = lightest * std::pow(heaviest / lightest, static_cast<double>(k) / rising_samples);
    if (compliance(f) > 0) continue;
    throw std::domain_error(
        fmt::format("the approach does not increase with the contact force at {} N (datum x_0 = {} m, contact half "
                    "width {} m); state a larger datum.x0_m or another datum.law",
                    plain(f, 4), plain(datum_m, 4), plain(hertz::half_width_m(curve_->contact().at(f)), 4)));
  }
}

double CurveLaw::begins_at() const { return -infinity; }

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
  for (int iteration = 0; iteration < most_curve_iterations; ++iteration) {
    const double excess = approach(f) - approach_m;
    if (excess == 0) return f;
    (excess < 0 ? low : high) = f;
    const double step = -excess / (compliance(f) * f);
    double next = f * std::exp(std::clamp(step, -longest_step, longest_step));
    if (!(next > low && next < high)) next = std::sqrt(low * high);
    if (std::abs(next - f) <= 2 * epsilon * f) return next;
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
double rise(const ForceLaw& law, double from_N, double by_N) {
  return std::visit([&](const auto& one) { return one.rise(from_N, by_N); }, law);
}
double begins_at(const ForceLaw& law) {
  return std::visit([](const auto& one) { return one.begins_at(); }, law);
}

std::optional<std::pair<double, double>> domain(const ForceLaw& law) {
  using Domain = std::optional<std::pair<double, double>>;
  return std::visit(Overloaded{[](const PowerLaw&) -> Domain { return std::nullopt; },
                               [](const LogarithmicLaw& one) -> Domain {
                                 return std::pair{0.0, one.heaviest_N()};
                               },
                               [](const LinearLaw& one) -> Domain { return one.fitted_N; },
                               [](const CurveLaw& one) -> Domain {
                                 return std::pair{0.0, one.curve().heaviest_N()};
                               }},
                    law);
}

std::optional<std::string> refusal(const ForceLaw& law, double force_N) {
  using Refusal = std::optional<std::string>;
  return std::visit(Overloaded{[](const PowerLaw&) -> Refusal { return std::nullopt; },
                               [&](const LogarithmicLaw& one) -> Refusal {
                                 if (!(force_N > one.heaviest_N())) return std::nullopt;
                                 return beyond_the_logarithm(force_N, one.heaviest_N());
                               },
                               [](const LinearLaw&) -> Refusal { return std::nullopt; },
                               // Whoever balances with a curve extends it.
                               [](const CurveLaw&) -> Refusal { return std::nullopt; }},
                    law);
}

bool jumps(const ForceLaw& law) {
  return std::visit(Overloaded{[](const PowerLaw&) { return false; }, [](const LogarithmicLaw&) { return false; },
                               [](const LinearLaw& one) { return one.unloading == Unloading::at_zero_approach; },
                               [](const CurveLaw&) { return false; }},
                    law);
}

}  // namespace ehd::bearing
