// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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
  const double force_error = bearing::force_error_by_datum * film_->curve().force_error(force_N);
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

bool is_known(const DynamicRow& row) { return largest_error(row) <= largest_dynamic_error; }

/// The bearing at some frequencies.
class MovingBearing {
 public:
  MovingBearing(const BearingResult& result, const BearingSetup& setup, const bearing::LawPair& laws,
                const std::vector<double>& frequencies_Hz, ContactMemory& memory)
      : result_(result),
        mass_kg_(bearing::roller_mass_kg(setup.body.geometry)),
        inner_(result, setup, Raceway::inner, laws.inner, omegas_of(frequencies_Hz), memory),
        outer_(result, setup, Raceway::outer, laws.outer, omegas_of(frequencies_Hz), memory) {}

  [[nodiscard]] DynamicRow at(double frequency_Hz) const {
    DynamicRow row{.frequency_Hz = frequency_Hz};
    const double omega = omega_of(frequency_Hz);
    for (const RollerRow& roller : result_.rollers)
      row.rollers.push_back({.azimuth_deg = roller.azimuth_deg,
                             .inner = inner_.at(roller.inner.force_N, omega),
                             .outer = outer_.at(roller.outer.force_N, omega)});
    row.ring = bearing::ring_motion(row.rollers, mass_kg_, omega);
    return row;
  }
  /// Absent where the law has none.
  [[nodiscard]] std::optional<bearing::BothRaceways<ResponseCurve>> response() const {
    if (!inner_.response() || !outer_.response()) return std::nullopt;
    return bearing::BothRaceways<ResponseCurve>{*inner_.response(), *outer_.response()};
  }

 private:
  [[nodiscard]] static double omega_of(double frequency_Hz) { return 2 * std::numbers::pi * frequency_Hz; }
  [[nodiscard]] static std::vector<double> omegas_of(const std::vector<double>& frequencies_Hz) {
    std::vector<double> omegas;
    omegas.reserve(frequencies_Hz.size());
    for (const double frequency_Hz : frequencies_Hz) omegas.push_back(omega_of(frequency_Hz));
    return omegas;
  }

  const BearingResult& result_;
  double mass_kg_;
  MovingRaceway inner_, outer_;
};

/// Those of 1, 2, 5, 10, 20, ... Hz that lie between two frequencies.
std::vector<double> round_frequencies_Hz(double above_Hz, double below_Hz) {
  std::vector<double> frequencies;
  for (double decade = 1; decade < below_Hz; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * decade > above_Hz && step * decade < below_Hz) frequencies.push_back(step * decade);
  return frequencies;
}

/// The lowest asked frequency that is not known well enough; null where all are.
const DynamicRow* lowest_unknown(const BearingResult& result) {
  const DynamicRow* unknown = nullptr;
  for (const DynamicRow& row : result.dynamics)
    if (!is_known(row) && (!unknown || row.frequency_Hz < unknown->frequency_Hz)) unknown = &row;
  return unknown;
}

/// The highest known frequency of those tried below `unknown_Hz`: the asked ones, and round ones of which `known` tells
/// by solving. The list of these is halved, as if all below a known one were known. This may miss a higher one: errors
/// are large where light rollers resonate.
std::optional<double> highest_known_Hz(const BearingResult& result, double unknown_Hz,
                                       const std::function<bool(double frequency_Hz)>& known) {
  std::optional<double> highest_Hz;
  for (const DynamicRow& row : result.dynamics)
    if (row.frequency_Hz < unknown_Hz) highest_Hz = std::max(highest_Hz.value_or(0), row.frequency_Hz);
  const std::vector<double> round = round_frequencies_Hz(highest_Hz.value_or(0), unknown_Hz);
  std::size_t low = 0, high = round.size();  // those before low are known, those from high on are not
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (known(round[middle])) {
      highest_Hz = round[middle];
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return highest_Hz;
}

/// Names the lowest frequency that is not known well enough, and a lower one that is.
void judge_dynamics(BearingResult& result, const std::function<bool(double frequency_Hz)>& known) {
  if (result.status != StopReason::converged) return;
  const DynamicRow* unknown = lowest_unknown(result);
  if (!unknown) return;
  const double error = largest_error(*unknown);
  const auto highest_Hz = highest_known_Hz(result, unknown->frequency_Hz, known);
  result.status = StopReason::tolerance_not_met;
  result.why = fmt::format(
      "at {} Hz stiffness and damping are {}; {}", plain(unknown->frequency_Hz),
      std::isfinite(error)
          ? fmt::format("known to {} only; {} is needed", rounded_up(error, 2), plain(largest_dynamic_error))
          : std::string("not known"),
      highest_Hz ? fmt::format("of the lower frequencies tried, {} Hz is the highest known one", plain(*highest_Hz))
                 : std::string("of the lower frequencies tried, none is known"));
}

}  // namespace

void fill_dynamics(BearingResult& result, const BearingSetup& setup, const bearing::LawPair& laws,
                   const std::vector<double>& frequencies_Hz, ContactMemory& memory) {
  const MovingBearing moving(result, setup, laws, frequencies_Hz, memory);
  for (const double frequency_Hz : frequencies_Hz) result.dynamics.push_back(moving.at(frequency_Hz));
  result.response = moving.response();
  result.notes.emplace_back(note::Dynamics{.damped = result.dynamics.front().ring.damping_N_s_per_m.has_value()});
  judge_dynamics(result, [&](double frequency_Hz) {
    if (!result.response) return false;  // the error of such a law is the same at all frequencies
    try {
      return is_known(MovingBearing(result, setup, laws, {frequency_Hz}, memory).at(frequency_Hz));
    } catch (const LawFailure&) {
      return false;
    }
  });
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
