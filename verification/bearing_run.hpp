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
#include "bearing/equilibrium.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/fit.hpp"
#include "bearing/geometry.hpp"
#include "contact/stages.hpp"
#include "contact/nondimensional.hpp"
#include "contact/solver.hpp"
#include "verification/case.hpp"
#include "verification/output.hpp"

namespace ehd::verification {

enum class BearingLaw { hertz, iso, lundberg, tripp, houpert, ehd_linear, ehd };
[[nodiscard]] std::string_view to_string(BearingLaw law);  ///< "hertz", …, "houpert", "ehd-linear", "ehd"
[[nodiscard]] std::optional<BearingLaw> bearing_law_from(std::string_view text);
[[nodiscard]] std::string bearing_law_names();  ///< for messages
[[nodiscard]] bool needs_film(BearingLaw law);
[[nodiscard]] bool needs_ring_thickness(BearingLaw law);  ///< tripp, houpert: at the outer raceway
/// A dry law at both raceways. Throws std::invalid_argument for a law with films.
[[nodiscard]] bearing::LawPair dry_laws(BearingLaw law, const bearing::RollerContact& contact);

/// What the case says of the bearing, as bearing/ takes it.
[[nodiscard]] bearing::Geometry geometry_of(const BearingCase& body);
[[nodiscard]] bearing::RollerContact roller_contact_of(const BearingCase& body);

/// Where a case states no fit.load_N, the line of a raceway is fitted over these parts of the largest force on it that the
/// dry balance knows: the largest roller load, or at the outer raceway the centrifugal force where that is larger. The range
/// begins no lighter than lightest_fit_M at that raceway, ten times the lightest contact that is solved at all, so that every
/// bearing has a line: down there the film goes as 1/f (Martin's rigid cylinder), and no line follows it any better.
inline constexpr double default_fit_from = 0.2, default_fit_to = 1.2, lightest_fit_M = 10 * smallest_M;

/// hertz, ehd-linear, ehd; hertz alone where the case has no lubricant.
[[nodiscard]] std::vector<BearingLaw> default_laws(const BearingCase& bearing);

/// Names of the stages; those of a law or raceway end in its name.
namespace bearing_stage {
inline constexpr std::string_view geometry = "geometry and kinematics";
inline constexpr std::string_view dry = "dry balance for datum and ranges";
inline constexpr std::string_view datum = "datum of the approach";
inline constexpr std::string_view solves = "EHD contact solves";
inline constexpr std::string_view fit = "straight-line fit";
inline constexpr std::string_view curve = "load-approach curve";
inline constexpr std::string_view variant = "ehd-linear cut at delta = 0";
inline constexpr std::string_view lambda = "lambda ratios";
inline constexpr std::string_view across = "balance across the load";
inline constexpr std::string_view cage = "cage positions over one pitch";
[[nodiscard]] std::string balance(BearingLaw law);
[[nodiscard]] std::string film(BearingLaw law);
}  // namespace bearing_stage

/// What run_bearing will do, from the case alone. `asked`: laws asked for; those that the case cannot have are skipped
/// with the reason.
[[nodiscard]] Plan plan_bearing(const BearingCase& bearing, const std::vector<BearingLaw>& asked,
                                bearing::Form form = bearing::Form::plane, int cage_positions = 0);

using ContactSolver = std::function<Solution(const Problem&, const Request&)>;

/// The solved contacts of every raceway seen so far. A contact that agrees in radius, length, modulus, speed and
/// lubricant is solved once, whichever law or case asks.
class ContactMemory {
 public:
  explicit ContactMemory(ContactSolver solver, Request request = bearing_request());

  [[nodiscard]] bearing::SolvedContacts& of(const bearing::RacewayContact& contact, const Lubricant& lubricant);
  /// The raceway's curve, built once for all laws, clearances and cases that need the same.
  [[nodiscard]] const std::variant<bearing::FilmCurve, bearing::SolveFailure>& curve(
      const bearing::RacewayContact& contact, const Lubricant& lubricant, const bearing::CurveRequest& request);
  [[nodiscard]] long solves() const;   ///< calls of the solver
  [[nodiscard]] long recalls() const;  ///< contacts taken from memory

  /// Film tolerance 1e-4: an offset film to that accuracy moves a contact force by a few parts in 1e5.
  [[nodiscard]] static Request bearing_request();

 private:
  using Key = std::tuple<bearing::RacewayContact, ViscosityLaw, DensityLaw, std::optional<double>,
                         std::optional<double>, double>;
  ContactSolver solver_;
  Request request_;
  struct Raceway {
    std::unique_ptr<bearing::SolvedContacts> contacts;
    std::map<bearing::CurveRequest, std::variant<bearing::FilmCurve, bearing::SolveFailure>> curves;
  };
  [[nodiscard]] Raceway& raceway(const bearing::RacewayContact& contact, const Lubricant& lubricant);
  std::map<Key, Raceway> raceways_;
  long curve_recalls_ = 0;
};

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

template <class T>
struct BothRaceways {
  T inner, outer;
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
  BearingLaw law = BearingLaw::hertz;
  bearing::Form form = bearing::Form::plane;
  StopReason status = StopReason::diverged;
  std::string why;  ///< where status is not converged
  double displacement_m = 0;
  double displacement_lateral_m = 0;                           ///< towards psi = 90 degrees
  std::optional<std::pair<double, double>> load_zone_deg = {};  ///< bearing::load_zone_deg; absent where nothing is loaded
  std::array<std::array<double, 2>, 2> stiffness_N_per_m = {};
  std::optional<CageTurn> cage = {};                           ///< where cage positions are asked for
  std::vector<RollerRow> rollers;                              ///< empty where there is no balance
  std::optional<BothRaceways<double>> datum_m = {};            ///< x_0
  std::optional<BothRaceways<bearing::LinearFit>> fit = {};    ///< ehd-linear
  std::optional<BothRaceways<bearing::FilmCurve>> curve = {};  ///< ehd; of ehd-linear, where its films are from
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
  std::vector<BearingLaw> laws;
  bool explicitly = false;  ///< laws were named by the user, not taken by default
  bool films = true;        ///< film of each roller, and the variants
  bearing::Form form = bearing::Form::plane;
  int cage_positions = 0;  ///< at how many positions of the cage over one pitch the ring is balanced besides; 0: none
};
/// The laws that a result was balanced with; absent where it has none (no balance).
[[nodiscard]] std::optional<bearing::LawPair> laws_of(const BearingCase& body, const BearingResult& result);

/// All laws of the request that the plan runs, in that order. Every way to end is in the results' status. Throws
/// CaseError for an EHD law at rest, or (`explicitly`) without a lubricant, and for a law without the ring thickness that
/// it needs, before anything is solved.
[[nodiscard]] std::vector<BearingResult> run_bearing(const Case& bearing_case, const BearingRequest& request,
                                                     ContactMemory& memory);
/// The refusals of run_bearing alone.
void require_possible(const Case& bearing_case, const BearingRequest& request);

/// "displacement" [m] or "roller.N.inner.force" [N] (outer, displacement, film likewise) of the law that the
/// expectation names; absent where there is none.
[[nodiscard]] std::optional<double> measure(const std::vector<BearingResult>& results, const Expectation& expectation);

[[nodiscard]] Json to_json(const BearingResult& result);
/// One case: its laws side by side over the rollers, fits, notes.
[[nodiscard]] std::string human_table(const Case& bearing_case, const std::vector<BearingResult>& results);

// ---- What the paper says of its figures -------------------------------------------------------------------------

/// The same bearing at one clearance with the dry law and an EHD law.
struct ClearanceComparison {
  double clearance_m = 0;
  BearingResult dry, film;
};

/// A statement of the paper with what was computed.
struct PaperStatement {
  char letter = 'a';
  std::string statement;  ///< as judged here, in one sentence
  bool holds = false;
  std::string numbers;
  std::vector<std::pair<std::string, bool>> parts = {};  ///< where a statement says two things
  /// Relative changes (EHD against dry) at psi = 0: "change" of (a), "least" and "most" of (b), "middle" and "largest"
  /// clearance of (c). "apart" of (a): the largest change of any roller's load over the largest dry load.
  std::vector<std::pair<std::string, double>> values = {};
};

/// Readings of words: "EHD is close to Hertz" (c) is within this fraction of the roller load at psi = 0, and
/// "considerably smaller" (b) is smaller by at least the second. The numbers stand beside every verdict.
inline constexpr double close_load = 0.02, considerably = 0.10;
/// "Similar" (a): no roller's load changes by more than this fraction of the largest dry load. The paper gives no number;
/// curves that are further apart than a fifth of a figure's scale are not what a reader of it calls similar.
inline constexpr double similar_load = 0.20;

/// (a)..(d) from at least three clearances of one bearing; absent where a balance is missing.
[[nodiscard]] std::vector<PaperStatement> judge_paper_statements(std::vector<ClearanceComparison> clearances);

/// One datum and what it makes of the statements; no contact is solved for it, since films do not depend on the datum.
struct DatumRow {
  std::string datum;
  std::vector<ClearanceComparison> clearances;
  std::vector<PaperStatement> statements;
};
/// `law`: ehd-linear or ehd. The named data: palmgren, lundberg, x0 = 20, 2.5, 1 and 0.5 mm.
[[nodiscard]] std::vector<DatumRow> compare_data(const std::vector<Case>& cases, BearingLaw law, ContactMemory& memory,
                                                 bearing::Form form = bearing::Form::plane);

/// The lengths x_0 for which the statements hold, scanned from `lowest_m` to `highest_m` in steps of a factor `step`, each
/// end refined by bisection until it is known to a factor `precision`: lists of closed ranges, empty where there is none.
/// What is narrower than a step may be missed. No scan (half_width_m = 0) where the dry law has no balance or no load.
struct DatumScan {
  double half_width_m = 0;  ///< of the heaviest dry contact; below about half of it there is no law
  double lowest_m = 0, highest_m = 0, step = 0, precision = 0;
  using Ranges = std::vector<std::pair<double, double>>;
  Ranges balanced_m;  ///< where the law has a balance at every clearance
  Ranges a_m, b_m, c_m, d_m;
  Ranges a_similar_m, a_lower_m;   ///< the two halves of (a)
  Ranges c_close_m, c_opposite_m;  ///< the two halves of (c)
  Ranges abc_m;                    ///< (a), (b) and (c)
  Ranges all_hold_m;               ///< (a) to (d)
  Ranges sign_of_a_m;              ///< (b), (c), (d) and the second half of (a): its threshold is this project's
  /// Least and largest of what "similar" is judged by over the lengths judged in sign_of_a_m: what its threshold decides.
  std::optional<std::pair<double, double>> apart_there = {};
  Ranges all_hold_mildly_m;  ///< (a) to (d), "close" in (c) read as closer than at the other two clearances
};
/// "0.15 to 0.61 mm", with a word where an end is the scan's own or the law's; "nowhere".
[[nodiscard]] std::string words_of(const DatumScan& scan, const DatumScan::Ranges& ranges, int digits = 3);
[[nodiscard]] DatumScan scan_datum(const std::vector<Case>& cases, BearingLaw law, ContactMemory& memory,
                                   bearing::Form form = bearing::Form::plane);

/// True where the cases are one bearing at different clearances.
[[nodiscard]] bool differ_only_in_clearance(const std::vector<Case>& cases);

[[nodiscard]] std::string human_statements(const std::vector<PaperStatement>& statements);
[[nodiscard]] std::string human_data(const std::vector<DatumRow>& rows, const DatumScan& scan);

}  // namespace ehd::verification
