// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include "bearing/dynamics.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/response_curve.hpp"
#include "contact/text.hpp"
#include "workflow/bearing_of_case.hpp"

namespace ehd {

using bearing::ContactMotion;
using bearing::CurveLaw;
using bearing::Kappa;
using bearing::Raceway;
using bearing::ResponseCurve;

namespace {

/// Up to this Omega the motion counts as slow, kappa = kappa_0 + i Omega kappa_1. What that neglects is stated as the
/// second number times Omega^2, relative. Measured at M 0.2 to 300, L 4 to 14: at most 0.84 times Omega^2 (the
/// stiffness of light contacts).
constexpr double slow_Omega = 0.01, slow_departure = 1;
/// A stiffness or damping that is known less well than this is no result.
constexpr double largest_dynamic_error = 0.02;

/// The contacts of one raceway with their law, at all frequencies.
class MovingRaceway {
 public:
  MovingRaceway(const BearingResult& result, const BearingSetup& setup, Raceway raceway, const bearing::ForceLaw& law,
                const std::vector<double>& omegas, ContactMemory& memory);

  [[nodiscard]] ContactMotion at(double force_N, double omega) const;
  /// Null where the law has none.
  [[nodiscard]] const ResponseCurve* response() const { return response_; }

 private:
  [[nodiscard]] ContactMotion with_film(double force_N, double omega) const;
  [[nodiscard]] Kappa kappa(double force_N, double omega) const;

  const bearing::ForceLaw& law_;
  const CurveLaw* film_;                     ///< the law, where its contacts have a response
  const ResponseCurve* response_ = nullptr;  ///< kept by the memory
  double law_error_ = 0;                     ///< relative, of the slope of a law without a response
};

MovingRaceway::MovingRaceway(const BearingResult& result, const BearingSetup& setup, Raceway raceway,
                             const bearing::ForceLaw& law, const std::vector<double>& omegas, ContactMemory& memory)
    : law_(law), film_(std::get_if<CurveLaw>(&law)), law_error_(result.balance_error) {
  if (result.fit) law_error_ = result.fit->at(raceway).K_deviation_N_per_m / result.fit->at(raceway).K_N_per_m;
  if (!film_) return;
  const bearing::FilmCurve& curve = film_->curve();
  bearing::ResponseCurveRequest request{.lightest_N = curve.lightest_N(), .heaviest_N = curve.heaviest_N()};
  for (const double omega : omegas)
    if (bearing::Omega_of(curve.contact(), curve.heaviest_N(), omega) > slow_Omega) request.omegas.push_back(omega);
  for (const RollerRow& roller : result.rollers) request.read_at_N.push_back(roller.at(raceway).force_N);
  const auto& made = memory.response_curve(curve.contact(), setup.body.lubricant->lubricant, request);
  if (const auto* failure = std::get_if<bearing::SolveFailure>(&made)) throw LawFailure(*failure);
  response_ = &std::get<ResponseCurve>(made);
}

Kappa MovingRaceway::kappa(double force_N, double omega) const {
  const auto& fast = response_->omegas();
  const auto found = std::find(fast.begin(), fast.end(), omega);
  if (found != fast.end()) return response_->at(force_N, static_cast<std::size_t>(found - fast.begin()));
  Kappa slow = response_->slow(force_N);
  const double Omega = bearing::Omega_of(response_->contact(), force_N, omega);
  slow.stiffness_error += slow_departure * Omega * Omega * slow.stiffness;
  slow.damping_error += slow_departure * Omega * Omega * response_->damping_scale(force_N);  // damping may vanish
  return slow;
}

ContactMotion MovingRaceway::with_film(double force_N, double omega) const {
  const auto made = [&](double f) {
    return contact_motion(response_->contact(), f, film_->datum_m(), omega, kappa(f, omega));
  };
  // The force itself has an error, and the contact at another force moves otherwise.
  const bearing::CurveErrors& errors = film_->curve().errors();
  const double force_error =
      bearing::force_error_by_datum *
      (errors.solver_offset_film +
       (force_N < film_->curve().lightest_N() ? errors.joint_force : errors.interpolation_force));
  ContactMotion contact = made(force_N);
  const ContactMotion heavier = made(force_N * (1 + force_error));
  contact.stiffness_error += std::abs(heavier.stiffness_N_per_m - contact.stiffness_N_per_m);
  contact.damping_error += std::abs(*heavier.damping_N_s_per_m - *contact.damping_N_s_per_m);
  return contact;
}

ContactMotion MovingRaceway::at(double force_N, double omega) const {
  if (film_) return with_film(force_N, omega);
  if (!(force_N > 0)) return {};
  const double slope = 1 / bearing::compliance(law_, force_N);
  return {.stiffness_N_per_m = slope, .stiffness_error = law_error_ * slope};
}

/// NaN where one of the two is.
double largest_error(const DynamicRow& row) {
  const double stiffness = row.ring.error, damping = row.ring.damping_error.value_or(0);
  return std::isnan(damping) || damping > stiffness ? damping : stiffness;
}

/// Names the lowest frequency that is not known well enough, and the highest asked one below it.
void judge_dynamics(BearingResult& result) {
  if (result.status != StopReason::converged) return;
  const DynamicRow* unknown = nullptr;
  for (const DynamicRow& row : result.dynamics)
    if (!(largest_error(row) <= largest_dynamic_error) && (!unknown || row.frequency_Hz < unknown->frequency_Hz))
      unknown = &row;
  if (!unknown) return;
  std::optional<double> known_Hz;
  for (const DynamicRow& row : result.dynamics)
    if (row.frequency_Hz < unknown->frequency_Hz) known_Hz = std::max(known_Hz.value_or(0), row.frequency_Hz);
  result.status = StopReason::tolerance_not_met;
  result.why =
      fmt::format("at {} Hz stiffness and damping are known to {} only; {} is needed; {}", plain(unknown->frequency_Hz),
                  rounded_up(largest_error(*unknown), 2), plain(largest_dynamic_error),
                  known_Hz ? fmt::format("of those asked, frequencies up to {} Hz are known", plain(*known_Hz))
                           : std::string("of those asked, no lower frequency is known"));
}

}  // namespace

void fill_dynamics(BearingResult& result, const BearingSetup& setup, const bearing::LawPair& laws,
                   const std::vector<double>& frequencies_Hz, ContactMemory& memory) {
  std::vector<double> omegas;
  omegas.reserve(frequencies_Hz.size());
  for (const double frequency_Hz : frequencies_Hz) omegas.push_back(2 * std::numbers::pi * frequency_Hz);
  const MovingRaceway inner(result, setup, Raceway::inner, laws.inner, omegas, memory),
      outer(result, setup, Raceway::outer, laws.outer, omegas, memory);
  const double mass_kg = bearing::roller_mass_kg(setup.body.geometry);
  for (std::size_t k = 0; k < omegas.size(); ++k) {
    DynamicRow row{.frequency_Hz = frequencies_Hz[k]};
    for (const RollerRow& roller : result.rollers)
      row.rollers.push_back({.azimuth_deg = roller.azimuth_deg,
                             .inner = inner.at(roller.inner.force_N, omegas[k]),
                             .outer = outer.at(roller.outer.force_N, omegas[k])});
    row.ring = bearing::ring_motion(row.rollers, mass_kg, omegas[k]);
    result.dynamics.push_back(std::move(row));
  }
  if (inner.response() && outer.response()) result.response = {*inner.response(), *outer.response()};
  result.notes.emplace_back(note::Dynamics{.damped = result.dynamics.front().ring.damping_N_s_per_m.has_value()});
  judge_dynamics(result);
}

void fill_torque(BearingResult& result, const BearingSetup& setup) {
  if (!result.curve || result.rollers.empty()) return;
  double sum_N_per_m = 0;
  for (const RollerRow& roller : result.rollers)
    for (const Raceway raceway : bearing::both_raceways) {
      const double force_N = roller.at(raceway).force_N;
      if (!(force_N > 0)) continue;  // the straight line lets rollers go
      const auto rolling = result.curve->at(raceway).rolling_force_N_per_m(force_N);
      if (!rolling) return;
      sum_N_per_m += *rolling;
    }
  const bearing::Speeds speeds = speeds_of(setup.body);
  const double slip_rad_per_s = std::abs(speeds.inner_rad_per_s - speeds.outer_rad_per_s);
  result.torque =
      RollingTorque{.torque_N_m = setup.contacts.inner.speed_sum_m_per_s * setup.body.geometry.length_m * sum_N_per_m /
                                  slip_rad_per_s,
                    .error = std::max(result.curve->inner.errors().rolling, result.curve->outer.errors().rolling)};
  result.notes.emplace_back(note::Torque{});
}

}  // namespace ehd
