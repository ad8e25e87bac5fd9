// SPDX-License-Identifier: GPL-3.0-or-later
// From a bearing case to its load distributions: case -> plan -> contacts -> force laws -> equilibrium -> result. The
// one place where bearing/ and a contact solver meet; bearing/ itself calls laws only.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "bearing/approach_formulas.hpp"
#include "bearing/build_curve.hpp"
#include "bearing/equilibrium.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/geometry.hpp"
#include "contact/nondimensional.hpp"
#include "contact/solver.hpp"
#include "contact/stages.hpp"
#include "workflow/bearing_of_case.hpp"
#include "workflow/bearing_plan.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_memory.hpp"

namespace ehd {

/// Where a case states no fit.load_N, the line of a raceway is fitted over these parts of the largest force on it that
/// the dry balance knows: the largest roller load, or at the outer raceway the centrifugal force where that is larger.
/// The range begins no lighter than lightest_fit_M at that raceway, ten times the lightest contact that is solved at
/// all, so that every bearing has a line: down there the film goes as 1/f (Martin's rigid cylinder), and no line
/// follows it any better.
inline constexpr double default_fit_from = 0.2, default_fit_to = 1.2, lightest_fit_M = 10 * smallest_M;

/// hertz, ehd-linear, ehd; hertz alone where the case has no lubricant.
[[nodiscard]] std::vector<bearing::Law> default_laws(const BearingCase& body);

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
};

/// The same law with another rule: what a reader should compare with.
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

struct BearingResult {
  std::string case_id;
  int version = 0;
  bearing::Law law = bearing::Law::hertz;
  bearing::Form form = bearing::Form::plane;
  StopReason status = StopReason::diverged;
  std::string why;  ///< where status is not converged
  double displacement_m = 0;
  double displacement_lateral_m = 0;  ///< towards psi = 90 degrees
  std::optional<std::pair<double, double>> load_zone_deg =
      {};  ///< bearing::load_zone_deg; absent where nothing is loaded
  std::array<std::array<double, 2>, 2> stiffness_N_per_m = {};
  std::optional<CageTurn> cage = {};                                  ///< where cage positions are asked for
  std::vector<RollerRow> rollers;                                     ///< empty where there is no balance
  std::optional<bearing::BothRaceways<double>> datum_m = {};          ///< x_0
  std::optional<bearing::BothRaceways<bearing::LinearFit>> fit = {};  ///< ehd-linear
  std::optional<bearing::BothRaceways<bearing::FilmCurve>> curve =
      {};  ///< ehd; of ehd-linear, where its films are from
  std::vector<VariantResult> variants;
  double balance_error = 0;
  double wall_s = 0;
  long contact_solves = 0;   ///< made for this law
  long contact_recalls = 0;  ///< contacts that it took from memory
  int roller_groups = 0;     ///< rollers that are not another's mirror image
  long rollers_balanced = 0;
  int newton_iterations = 0;
  Plan plan;
  std::vector<std::string> notes;
};

struct BearingRequest {
  std::vector<bearing::Law> laws;
  bool explicitly = false;  ///< laws were named by the user, not taken by default
  bool films = true;        ///< film of each roller, and the variants
  bearing::Form form = bearing::Form::plane;
  int cage_positions = 0;  ///< at how many positions of the cage over one pitch the ring is balanced besides; 0: none
};
/// The laws that a result was balanced with; absent where it has none (no balance).
[[nodiscard]] std::optional<bearing::LawPair> laws_of(const BearingCase& body, const BearingResult& result);

/// All laws of the request that the plan runs, in that order. Every way to end is in the results' status. Throws
/// CaseError for an EHD law at rest, or (`explicitly`) without a lubricant, and for a law without the ring thickness
/// that it needs, before anything is solved.
[[nodiscard]] std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request,
                                                     ContactMemory& memory);
/// The refusals of run_bearing alone.
void require_possible(const Case& bearing_case, const BearingRequest& request);

/// "displacement" [m] or "roller.N.inner.force" [N] (outer, displacement, film likewise) of the law that the
/// expectation names; absent where there is none.
[[nodiscard]] std::optional<double> measure(const std::vector<BearingResult>& results, const Expectation& expectation);

}  // namespace ehd
