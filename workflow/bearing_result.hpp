// SPDX-License-Identifier: GPL-3.0-or-later
// The result of balancing one bearing with one contact force law.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/dynamics.hpp"
#include "bearing/equilibrium.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/geometry.hpp"
#include "bearing/law_table.hpp"
#include "contact/oil_grade.hpp"
#include "contact/solution.hpp"
#include "workflow/bearing_notes.hpp"
#include "workflow/plan.hpp"

namespace ehd {

struct ContactRow {
  double force_N = 0;
  double displacement_m = 0;
  std::optional<double> film_minimum_m = {};
  std::optional<double> hertz_pressure_Pa = {};  ///< absent at no force
  std::optional<double> lambda_ratio = {};       ///< minimum film over the composite roughness; absent without either
};
struct RollerRow {
  double azimuth_deg = 0;
  ContactRow inner, outer;
  [[nodiscard]] const ContactRow& at(bearing::Raceway raceway) const {
    return raceway == bearing::Raceway::inner ? inner : outer;
  }
};

/// How many of a bearing's rollers are loaded (bearing::is_loaded).
[[nodiscard]] int loaded_rollers(const std::vector<RollerRow>& rollers);

/// The balance with a variant of the law, for comparison.
struct VariantResult {
  std::string name;
  double displacement_m = 0;
  double displacement_lateral_m = 0;
  double balance_error = 0;
  std::vector<RollerRow> rollers;
};

/// The ring while the cage turns by one pitch, 360/Z.
struct CageTurn {
  struct Range {
    double mean = 0, peak_to_peak = 0;
  };
  int positions = 0;  ///< equally spaced, the case's own the first
  Range displacement_m, displacement_lateral_m;
  double largest_force_N = 0;  ///< of any inner contact at any position
};

/// The bearing in small motion at one frequency.
struct DynamicRow {
  double frequency_Hz = 0;
  bearing::RingMotion ring = {};
  std::vector<bearing::RollerMotion> rollers = {};  ///< one each, in the order of the rollers
};

/// What the films take from the rings (bearing_dynamics.hpp).
struct RollingTorque {
  double torque_N_m = 0;
  double error = 0;  ///< relative, of the rolling forces
};

/// Numerical errors of a balance with films: those of fit, interpolation and contact solves, added
/// (bearing_errors.hpp). The datum is not among them: the case chooses it.
struct BearingErrors {
  double displacement_m = 0;                 ///< of the ring, along the load
  double displacement_lateral_m = 0;         ///< across it
  double largest_force_N = 0;                ///< of the most loaded roller, inner raceway
  double any_force_N = 0;                    ///< of the roller whose force is known least
  std::optional<double> smallest_film = {};  ///< relative
};

struct BearingResult {
  std::string case_id;
  int version = 0;
  bearing::Law law = bearing::Law::hertz;
  bearing::Form form = bearing::Form::plane;
  StopReason status = StopReason::diverged;
  std::string why;  ///< where status is not converged: why there is no balance, or which accuracy was missed
  double displacement_m = 0;
  double displacement_lateral_m = 0;  ///< towards psi = 90 degrees
  /// From the first to the last loaded roller (bearing::load_zone_deg); absent where nothing is loaded.
  std::optional<std::pair<double, double>> load_zone_deg = {};
  /// Where clearance and displacement alone would load a roller: ehd::geometric_load_zone_deg.
  std::optional<std::pair<double, double>> geometric_load_zone_deg = {};
  std::array<std::array<double, 2>, 2> stiffness_N_per_m = {};
  std::optional<double> stiffness_error_N_per_m = {};         ///< of dF_r/d(delta_r), where the law follows curves
  std::vector<DynamicRow> dynamics = {};                      ///< where the request has frequencies
  std::optional<RollingTorque> torque = {};                   ///< where the result has curves
  std::optional<CageTurn> cage = {};                          ///< where the request has cage positions
  std::vector<RollerRow> rollers;                             ///< empty where there is no balance
  std::optional<bearing::BothRaceways<double>> datum_m = {};  ///< x_0
  std::optional<bearing::BothRaceways<bearing::LinearFit>> fit = {};  ///< of a law made from fits
  /// The films are read from it; a law made from curves follows it.
  std::optional<bearing::BothRaceways<bearing::FilmCurve>> curve = {};
  /// kappa over the force at the same raceways, where the request has frequencies and the law has curves.
  std::optional<bearing::BothRaceways<bearing::ResponseCurve>> response = {};
  /// Of a law with films, where the law ehd was balanced too and every source has a bound. `ehd bearing` balances ehd
  /// for a line that is asked for alone.
  std::optional<BearingErrors> errors = {};
  std::vector<VariantResult> variants;
  double balance_error = 0;
  double wall_s = 0;
  long contact_solves = 0;    ///< contacts that this law is the first to need
  long contact_recalls = 0;   ///< contacts that it took from memory
  long responses = 0;         ///< contacts whose response this law is the first to need
  long rollers_balanced = 0;  ///< those that are not another's mirror image, once an iteration
  int newton_iterations = 0;
  Plan plan;
  std::vector<BearingNote> notes;
  std::optional<GradedOil> oil = {};  ///< where the case states its grade
};

/// A contact of a balance.
struct ContactPlace {
  std::size_t roller = 0;
  bearing::Raceway raceway = bearing::Raceway::inner;
};
/// The index of the roller with the largest force at the inner raceway, the first one of equals.
[[nodiscard]] std::size_t most_loaded(const BearingResult& result);
/// That force; 0 without a balance.
[[nodiscard]] double largest_force_N(const BearingResult& result);
/// Of the most loaded roller, the contact with the larger Hertz pressure. Absent where that roller carries nothing.
[[nodiscard]] std::optional<ContactPlace> largest_pressure_place(const BearingResult& result);
/// The contact with the smallest film over both raceways of the loaded rollers. Absent without films.
[[nodiscard]] std::optional<ContactPlace> smallest_film_place(const BearingResult& result);

/// The balanced result of the law ehd, which a fitted law approximates; null where there is none.
[[nodiscard]] const BearingResult* full_relation_in(const std::vector<BearingResult>& results);
/// Relative error of the stiffness along the load, d(F_r)/d(delta_r). Absent for dry laws, which are solved to
/// rounding. The error of a fitted law is its distance from `full`, plus the error of `full`; absent without `full`.
[[nodiscard]] std::optional<double> stiffness_error(const BearingResult& result, const BearingResult* full);
/// The same for the rolling torque. A fitted law unloads rollers that ehd loads.
[[nodiscard]] std::optional<double> torque_error(const BearingResult& result, const BearingResult* full);
/// The same for the stiffness in motion at frequency number k, relative to the trace.
[[nodiscard]] std::optional<double> motion_error(const BearingResult& result, const BearingResult* full, std::size_t k);
/// False where the error is so large that not even the first digit of the stiffness is known. Text and JSON then leave
/// the stiffness out.
[[nodiscard]] bool knows_stiffness(const BearingResult& result, const BearingResult* full);
/// The same of the stiffness in motion; and of the damping, where the law knows one.
[[nodiscard]] bool knows_motion(const BearingResult& result, const BearingResult* full, std::size_t k);
[[nodiscard]] bool knows_damping(const DynamicRow& row);

/// Where the ring has moved by more than half the clearance: from one azimuth to the other [deg], with
/// cos(half the zone) = P_d/(2 delta_r). Absent where it has not; the whole circle where preload holds every roller.
[[nodiscard]] std::optional<std::pair<double, double>> geometric_load_zone_deg(const BearingResult& result,
                                                                               double clearance_m);
/// The error of either end of that zone [deg]: the ring lies within its errors along and across the load. Absent
/// without errors, and where preload holds every roller.
[[nodiscard]] std::optional<double> load_zone_error_deg(const BearingResult& result, double clearance_m);

}  // namespace ehd
