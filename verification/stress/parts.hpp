// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of ehd stress. run_* measures, judge_* judges: they are apart, so that tests can show each verdict to fail
// on wrong rows.
#pragma once

#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "contact/quantities.hpp"
#include "contact/solver.hpp"
#include "io/json.hpp"
#include "verification/stress/stated_errors.hpp"
#include "verification/stress/stress.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification::stress {

/// Solves what would take `reference` seconds a point, and gives up at some points.
inline constexpr const char* quicker_reference = "reference.linear";

/// A solve in short: how it ended, the two films that a tolerance is about (Hertz units), and their stated relative
/// errors.
struct Ended {
  StopReason status = StopReason::diverged;
  std::string reason = {};
  long iterations = 0;
  double wall_s = 0;
  bool finite = true;  ///< every reading, place, error and node value
  std::optional<double> film[2] = {}, error[2] = {};
  [[nodiscard]] bool has_films() const { return film[0] && film[1] && error[0] && error[1]; }
};
[[nodiscard]] Ended ended(const Solution& solution);
/// The time limit ended the solve. That says nothing of the solver, because a busy machine does it too: such a row is
/// inconclusive. A limit on iterations comes at the same place on every machine, and is a failure.
[[nodiscard]] bool out_of_time(StopReason status, double wall_s, double time_limit_s);
/// pass where it holds; else inconclusive where the time limit ended a solve, and fail where nothing excuses it.
[[nodiscard]] Verdict holds_in_time(bool holds, bool out_of_time);
/// Largest difference of the two films over the sum of their stated errors; NaN where a film or an error is missing.
[[nodiscard]] double over_stated_errors(const Ended& one, const Ended& other);
[[nodiscard]] Tolerance within_stated_errors();  ///< over_stated_errors() at most 1
/// The largest tolerance of the rows stands for a part; each row is held to its own.
void keep_larger(std::optional<Tolerance>& largest, const Tolerance& one);
/// The same contacts with the inlet cut at `usual_cut`.
[[nodiscard]] std::vector<BoxContact> cut_contacts(std::vector<BoxContact> contacts);
/// To and from a child process.
[[nodiscard]] Json json_of(const Ended& end);
[[nodiscard]] Ended ended_from(const Json& json);

// (a) -- the box of loads and materials, by both solvers -----------------------------------------------------------
struct BoxPoint {
  bool roelands = false;
  double M = 0, L = 0, p_H_Pa = 0;
  std::string dense = {};  ///< the solver behind `reference`
  Ended reference = {}, fast = {};
};
[[nodiscard]] std::vector<BoxPoint> run_box(const Scope& scope);
[[nodiscard]] Part judge_box(const std::vector<BoxPoint>& points);

// (b) -- random first states ---------------------------------------------------------------------------------------
struct StartRow {
  std::string level = {}, contact = {}, family = {};
  long starts = 0, converged = 0, dishonest = 0;  ///< dishonest: called solved, but a number is not finite
  bool own_solved = false;                        ///< from the start that the solver makes itself
  bool own_late = false;                          ///< it was not, and the time limit was spent
  double worst = 0;                         ///< largest relative difference from the film of that start; NaN stays
  std::optional<Tolerance> tolerance = {};  ///< of that; absent where the own start was not solved
};
[[nodiscard]] std::vector<StartRow> run_starts(const Scope& scope);
[[nodiscard]] Part judge_starts(const std::vector<StartRow>& rows);

// (c) -- double against longer arithmetic on the same grid ---------------------------------------------------------
struct PrecisionRow {
  std::string contact = {}, arithmetic = {}, equations = {};
  long unknowns = 0;
  double minimum = 0, central = 0, pressure = 0;  ///< error against 34 digits, relative; pressure over its maximum
  double condition = 0;                           ///< (1 + X_a^2/2)/H_min: the terms of a film over the film
  double contraction = 0;                         ///< of the iteration in 34 digits
  std::optional<Tolerance> tolerance = {};        ///< of the films
};
[[nodiscard]] std::vector<PrecisionRow> run_precision(const Scope& scope);
[[nodiscard]] Part judge_precision(const std::vector<PrecisionRow>& rows);

// (d) -- the four rounding modes -----------------------------------------------------------------------------------
struct RoundingRow {
  std::string solver = {}, contact = {}, mode = {};
  bool in_force = false;  ///< the solving process had this mode, and a division there gave another result
  StopReason status = StopReason::diverged;
  double minimum = 0, central = 0;  ///< relative moves against rounding to nearest
  bool to_rounding = false;         ///< false: the solver adapts its grid, and its stated errors bound the move
  std::optional<Tolerance> tolerance = {};
  bool late = false;     ///< the time limit ended the solve
  std::string why = {};  ///< where there is no result
};
[[nodiscard]] std::vector<RoundingRow> run_rounding(const Scope& scope);
[[nodiscard]] Part judge_rounding(const std::vector<RoundingRow>& rows);

// (e) -- inputs moved by one ulp and by 1e-8 -----------------------------------------------------------------------
struct ConditionRow {
  std::string contact = {}, solver = {}, quantity = {};
  double amplification[2] = {};     ///< dln H/dln q of H_min and H_cen by a central difference of 1e-8
  double large_step[2] = {};        ///< by 1e-3, extrapolated
  double large_step_error[2] = {};  ///< its change by the extrapolation
  double ulp_move[2] = {};          ///< relative move of the films for one ulp of the input, the larger of both sides
  double ulp = 0;                   ///< relative
  double floor = 0;                 ///< predicted rounding of one film, relative
  /// By the chain rule from the sensitivities to M and L, where the films follow from these alone.
  std::optional<double> by_groups[2] = {};
  bool converged = true;
  bool late = false;  ///< the time limit ended a solve
};
[[nodiscard]] std::vector<ConditionRow> run_condition(const Scope& scope);
[[nodiscard]] Part judge_condition(const std::vector<ConditionRow>& rows);

// (f) -- from 2^4 to 2^20 intervals --------------------------------------------------------------------------------
struct GridRow {
  std::string solver = {}, contact = {};
  int nodes = 0;
  bool ran = true;  ///< false: not tried; `why` gives the reason
  StopReason status = StopReason::diverged;
  bool spike = false;  ///< of the true pressure: H_min then has no declared order
  double cells = 0;    ///< equal cells in the inlet zone of the true film; 0 on other grids
  std::optional<double> error[2] = {}, stated[2] = {};  ///< of H_min and H_cen, relative; error: against the truth
  double truth_error[2] = {};
  double floor = 0;  ///< predicted for this n
  double wall_s = 0;
  std::string why = {};
};
[[nodiscard]] std::vector<GridRow> run_grids(const Scope& scope);
[[nodiscard]] Part judge_grids(const std::vector<GridRow>& rows);

// (g) -- extreme, impossible and hurried --------------------------------------------------------------------------
struct ExtremeRow {
  std::string kind = {};                       ///< what was tried: "random SI", "impossible inputs", "limits"
  std::string what = {};                       ///< the inputs, with the digits to repeat the run
  bool inside = false;                         ///< in_the_box()
  std::string refused = {};                    ///< the message of a refusal before any solve
  std::optional<Ended> fast = {}, other = {};  ///< other: an independent solver, on some
  double wall_s = 0, time_limit_s = 0;
  std::string broke = {};      ///< how it broke: another exception, a signal
  bool lacked_memory = false;  ///< which says nothing of the solver
};
/// The box that must be solved: M 0.05 ... 5000, L 0 ... 30, p_H <= 4 GPa, z 0.1 ... 1.2, p_0 1e7 ... 1e10 Pa, flooded
/// or (M >= 2) cut at -100 ... -2.5. Computed from the stated numbers alone, without nondimensionalise(), whose wrong
/// refusal would hide a contact inside. With u the sum of speeds: M = w/sqrt(eta u E' R),
/// L = alpha E' (eta u/(E' R))^(1/4), p_H = sqrt(w E'/(2 pi R)).
[[nodiscard]] bool in_the_box(const Statement& statement, const Lubricant& lubricant, const Inlet& inlet);
[[nodiscard]] std::vector<ExtremeRow> run_extremes(const Scope& scope);
[[nodiscard]] Part judge_extremes(const std::vector<ExtremeRow>& rows);

// (h) -- the same bits again --------------------------------------------------------------------------------------
struct RepeatRow {
  std::string solver = {}, request = {};
  long contacts = 0, converged = 0;
  long ended_by_time = 0;    ///< of the first run
  long same_again = 0;       ///< a second run in one thread
  long same_in_two = 0;      ///< two threads
  long same_in_process = 0;  ///< another process
};
[[nodiscard]] std::vector<RepeatRow> run_repeats(const Scope& scope);
[[nodiscard]] Part judge_repeats(const std::vector<RepeatRow>& rows);

// (i) -- random bearings ------------------------------------------------------------------------------------------
struct BearingRow {
  std::string law = {};
  long tried = 0;
  long balanced = 0;                   ///< every contact met its tolerance
  long missed = 0, missed_inside = 0;  ///< balanced, but a contact missed its tolerance; those inside the law's domain
  long limits = 0;                     ///< refused because a solve came to its limit, inside or outside the domain
  long late = 0;                       ///< of those, by the time limit
  long refused_outside = 0, refused_inside = 0;  ///< other refusals; the domain is computed from the stated numbers
  double worst_balance = 0;                      ///< balance_error; NaN stays
  double worst_bisection = 0;                    ///< worst_bisection_error; NaN stays
  long contact_solves = 0;
  long unseen = 0;          ///< contacts below the curves that these have not seen
  double worst_unseen = 0;  ///< largest error there over the stated one; NaN stays
  double wall_s = 0, slowest_s = 0;
  std::vector<std::string> inside = {};   ///< refusals and misses that no domain excuses: seed and reason
  std::vector<std::string> reasons = {};  ///< each kind of refusal outside, with the first seed and its message
};
[[nodiscard]] std::vector<BearingRow> run_bearings(const Scope& scope);
[[nodiscard]] Part judge_bearings(const std::vector<BearingRow>& rows);

// (j) -- random small motions -------------------------------------------------------------------------------------
/// "kappa" is taken at Omega. "wavy film" is the amplitude of the film at X = 0, from a wavy body.
inline constexpr const char* motion_numbers[] = {"kappa", "kappa_0", "kappa_1", "wavy film"};
/// Every contact is solved to each of these tolerances, and judged by one solve of `reference`.
inline constexpr double motion_tolerances[] = {1e-4, 1e-3};
struct MotionPoint {
  BoxContact contact = {};
  double asked = motion_tolerances[0];
  double Omega = 0;
  Waviness waviness = {};
  std::array<Compared, std::size(motion_numbers)> numbers = {};
  StopReason status = StopReason::diverged;        ///< of kappa by `fast`
  StopReason truth_status = StopReason::diverged;  ///< of kappa by `reference`
  bool late = false;                               ///< the time limit ended `fast`
  int nodes = 0;                                   ///< of the finest grid of `fast`
  double wall_s = 0, truth_s = 0;
};
[[nodiscard]] std::vector<MotionPoint> run_motion(const Scope& scope);
[[nodiscard]] Part judge_motion(const std::vector<MotionPoint>& points);

// (k) -- stated errors of films at random contacts ----------------------------------------------------------------
/// Every contact is solved to each of these tolerances, and judged by one solve of `reference`.
inline constexpr double film_tolerances[] = {1e-3, 1e-4, 1e-5};
struct FilmPoint {
  BoxContact contact = {};
  double asked = film_tolerances[0];
  std::array<Compared, std::size(judged_films)> films = {};  ///< in the order of judged_films
  StopReason status = StopReason::diverged;                  ///< of `fast`
  StopReason truth_status = StopReason::diverged;            ///< of `reference`
  bool late = false;                                         ///< the time limit ended `fast`
  int nodes = 0;                                             ///< of the finest grid of `fast`
  double wall_s = 0, truth_s = 0;
};
[[nodiscard]] std::vector<FilmPoint> run_films(const Scope& scope);
[[nodiscard]] Part judge_films(const std::vector<FilmPoint>& points);

}  // namespace ehd::verification::stress
