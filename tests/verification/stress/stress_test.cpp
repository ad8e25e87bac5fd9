// SPDX-License-Identifier: GPL-3.0-or-later
// ehd stress: every verdict fails on rows that are wrong and stays open on rows that say nothing; the program's files
// and exit codes; the small parts themselves.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "contact/nondimensional.hpp"
#include "io/json.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"
#include "verification/stress/parts.hpp"

using namespace ehd;
using namespace ehd::verification;
using namespace ehd::verification::stress;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Ended sound(double minimum, double central, double error) {
  return {.status = StopReason::converged,
          .reason = {},
          .iterations = 5,
          .wall_s = 0.01,
          .film = {minimum, central},
          .error = {error, error}};
}

Ended refused() { return {.status = StopReason::tolerance_not_met, .reason = "the grid ends"}; }

BoxPoint box_point() {
  return {.roelands = true,
          .M = 20,
          .L = 10,
          .p_H_Pa = 8e8,
          .dense = "reference",
          .reference = sound(0.074, 0.085, 1e-4),
          .fast = sound(0.07401, 0.08501, 2e-4)};
}

StartRow start_row() {
  return {.level = "fast.uniform's Newton",
          .contact = "M = 5",
          .family = "rough",
          .starts = 10,
          .converged = 4,
          .dishonest = 0,
          .own_solved = true,
          .worst = 1e-12,
          .tolerance = Tolerance::iteration(1e-11)};
}

PrecisionRow precision_row() {
  return {.contact = "M = 5",
          .arithmetic = "double",
          .equations = "reference, its mesh",
          .unknowns = 100,
          .minimum = 1e-15,
          .central = 2e-15,
          .condition = 5,
          .contraction = 1e-6,
          .tolerance = Tolerance::round_off(10, 5)};
}

RoundingRow rounding_row() {
  return {.solver = "fast.uniform",
          .contact = "M = 5",
          .mode = "up",
          .in_force = true,
          .status = StopReason::converged,
          .minimum = 1e-14,
          .central = 1e-14,
          .to_rounding = true,
          .tolerance = Tolerance::round_off(100, 5)};
}

ConditionRow condition_row() {
  return {.contact = "M = 5",
          .solver = "fast.uniform",
          .quantity = "M",
          .amplification = {-0.1, -0.09},
          .large_step = {-0.1001, -0.0901},
          .large_step_error = {1e-5, 1e-5},
          .ulp_move = {1e-15, 1e-15},
          .ulp = 1e-16,
          .floor = 1e-11};
}

/// Second order from 3.2 cells on, under-resolved before.
std::vector<GridRow> grid_rows() {
  std::vector<GridRow> rows;
  for (const int n : {64, 256, 512, 1024, 2048}) {
    const double cells = n / 128.0, error = 0.1 / (cells * cells);
    const bool sees = cells >= 1.5;
    rows.push_back({.solver = "fast.uniform",
                    .contact = "M = 100",
                    .nodes = n,
                    .status = sees ? StopReason::converged : StopReason::under_resolved,
                    .cells = cells,
                    .error = {error, error},
                    .stated = {2 * error, 2 * error},
                    .truth_error = {1e-11, 1e-11},
                    .floor = 1e-11});
  }
  return rows;
}

ExtremeRow extreme_row() {
  return {.kind = "random SI",
          .what = "load 1",
          .inside = true,
          .fast = sound(0.1, 0.2, 1e-3),
          .other = sound(0.10001, 0.2, 1e-3),
          .wall_s = 0.01,
          .time_limit_s = 5};
}

RepeatRow repeat_row() {
  return {.solver = "fast",
          .request = "tolerance 1e-3",
          .contacts = 3,
          .converged = 3,
          .same_again = 3,
          .same_in_two = 3,
          .same_in_process = 3};
}

/// A hundred points for each tolerance, one tolerance after the other, whose stated errors hold by far.
std::vector<MotionPoint> motion_points() {
  const Compared number{.differ = 3e-6, .stated = 2e-5, .truth_error = 1e-8};
  const MotionPoint point{.contact = {.moes = {7, 6}},
                          .Omega = 2,
                          .numbers = {number, number, number, number},
                          .status = StopReason::converged,
                          .truth_status = StopReason::converged,
                          .nodes = 256,
                          .wall_s = 0.01,
                          .truth_s = 1};
  std::vector<MotionPoint> points(100 * std::size(motion_tolerances), point);
  for (std::size_t k = 0; k < points.size(); ++k) points[k].asked = motion_tolerances[k / 100];
  return points;
}

/// A hundred contacts for each tolerance, one tolerance after the other, whose stated errors hold by far.
std::vector<FilmPoint> film_points() {
  const Compared number{.differ = 3e-7, .stated = 2e-6, .truth_error = 1e-9};
  const FilmPoint point{.contact = {.moes = {7, 6}},
                        .films = {number, number},
                        .status = StopReason::converged,
                        .truth_status = StopReason::converged,
                        .nodes = 256,
                        .wall_s = 0.01,
                        .truth_s = 1};
  std::vector<FilmPoint> points(100 * std::size(film_tolerances), point);
  for (std::size_t k = 0; k < points.size(); ++k) points[k].asked = film_tolerances[k / 100];
  return points;
}

/// The verdict of one row after it was spoilt.
template <class Row, class Judge, class Spoil>
Verdict spoilt(Row row, Judge judge, Spoil spoil) {
  spoil(row);
  return judge(std::vector<Row>{row}).verdict;
}

}  // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(Verdict)

BOOST_AUTO_TEST_SUITE(stress_stress)

BOOST_AUTO_TEST_CASE(a_tally_with_nothing_in_it_is_open_and_nan_never_passes) {
  Tally tally;
  BOOST_TEST(tally.verdict() == Verdict::inconclusive);
  const auto tolerance = Tolerance::required(1, "a test");
  tally.add(0.5, 0, tolerance, "half");
  BOOST_TEST(tally.verdict() == Verdict::pass);
  tally.add(nothing, 0, tolerance, "unknown");
  BOOST_TEST(tally.verdict() == Verdict::inconclusive);
  tally.add(2, 0, tolerance, "too much");
  BOOST_TEST(tally.verdict() == Verdict::fail);
  BOOST_TEST(tally.failures().size() == 2u);
  BOOST_TEST(!all_passed({}));
}

BOOST_AUTO_TEST_CASE(every_part_is_listed_once_by_letter_and_name) {
  std::set<std::string> ids, names;
  for (const auto& part : parts()) {
    ids.insert(part.id);
    names.insert(part.name);
    BOOST_TEST(find_part(part.id) == &part);
    BOOST_TEST(find_part(part.name) == &part);
  }
  BOOST_TEST(ids == (std::set<std::string>{"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"}),
             boost::test_tools::per_element());
  BOOST_TEST(names.size() == 11u);
  BOOST_TEST(!find_part("l"));
}

BOOST_AUTO_TEST_CASE(a_part_that_throws_is_a_part_that_fails) {
  const PartEntry broken{"z", "broken", [](const Scope&) -> Part { throw std::runtime_error("out of\nmemory"); }};
  const Part part = run_part(broken, {.quick = true});
  BOOST_TEST(part.id == "z");
  BOOST_TEST(part.verdict == Verdict::fail);
  BOOST_TEST(part.summary.find("out of") != std::string::npos);
  BOOST_REQUIRE(part.failures.size() == 1u);
  BOOST_TEST(human_text(part).find("memory") != std::string::npos);
  const Json json = to_json({part}, 1);
  BOOST_TEST(json.at("success") == false);
  BOOST_TEST(json.at("parts")[0].at("verdict") == "fail");
  BOOST_TEST(json.at("parts")[0].at("rows").empty());
  const PartEntry odd{"y", "odd", [](const Scope&) -> Part { throw 1; }};
  BOOST_TEST(run_part(odd, {}).verdict == Verdict::fail);
}

BOOST_AUTO_TEST_CASE(a_part_that_a_signal_ended_is_inconclusive) {
  const PartEntry entry{"z", "endless", {}};
  const Part part = interrupted_part(entry, {.quick = true});
  BOOST_TEST(part.verdict == Verdict::inconclusive);
  BOOST_TEST(part.summary == "ended early: the program was interrupted");
  BOOST_TEST(!all_passed({Part{.id = "a", .verdict = Verdict::pass}, part}));
  BOOST_TEST(to_json({part}, 1).at("parts")[0].at("settings").at("quick") == true);
}

// A busy machine ends a solve by its time limit, which says nothing of the solver. A limit on iterations is a failure.
BOOST_AUTO_TEST_CASE(a_time_limit_is_inconclusive_and_a_limit_on_iterations_fails) {
  constexpr auto limit = StopReason::limit_reached;
  BOOST_TEST(out_of_time(limit, 30.01, 30));
  BOOST_TEST(!out_of_time(limit, 3, 30));
  BOOST_TEST(!out_of_time(StopReason::diverged, 30.01, 30));
  BOOST_TEST(holds_in_time(true, false) == Verdict::pass);
  BOOST_TEST(holds_in_time(false, false) == Verdict::fail);
  for (const bool by_time : {true, false}) {
    const Verdict expected = by_time ? Verdict::inconclusive : Verdict::fail;
    const auto ended_by_limit = [&](Ended& end, double seconds) {
      end = refused();
      end.status = limit;
      end.wall_s = by_time ? seconds : 0.1;
    };
    BOOST_TEST(spoilt(box_point(), judge_box, [&](BoxPoint& p) { ended_by_limit(p.reference, 30.1); }) == expected);
    BOOST_TEST(spoilt(box_point(), judge_box, [&](BoxPoint& p) {
                 ended_by_limit(p.reference, 30.1), p.fast = refused();
               }) == Verdict::fail);  // the other one has no excuse
    BOOST_TEST(spoilt(rounding_row(), judge_rounding, [&](RoundingRow& r) { r.status = limit, r.late = by_time; }) ==
               expected);
    BOOST_TEST(spoilt(condition_row(), judge_condition,
                      [&](ConditionRow& r) { r.converged = false, r.late = by_time; }) == expected);
    BOOST_TEST(spoilt(start_row(), judge_starts, [&](StartRow& r) { r.own_solved = false, r.own_late = by_time; }) ==
               expected);
    auto grids = grid_rows();
    grids[4].status = limit, grids[4].wall_s = by_time ? 60.1 : 0.1;
    for (std::size_t k = 0; k < 2; ++k) grids[4].error[k] = grids[4].stated[k] = {};
    BOOST_TEST(judge_grids(grids).verdict == expected);
    BOOST_TEST(judge_extremes({[&] {
                 ExtremeRow row = extreme_row();
                 ended_by_limit(*row.fast, 5.1);
                 row.other.reset();
                 row.wall_s = row.fast->wall_s;
                 return row;
               }()})
                   .verdict == expected);
  }
}

BOOST_AUTO_TEST_CASE(the_box_fails_where_solvers_differ_or_refuse_below_4_GPa) {
  const auto with_a_sound_one = [](std::vector<BoxPoint> points) {
    points.push_back(box_point());
    return judge_box(points);
  };
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [](BoxPoint&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [](BoxPoint& p) { p.fast.film[1] = 0.0851; }) == Verdict::fail);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [](BoxPoint& p) { p.fast.film[0] = nothing; }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [](BoxPoint& p) { p.fast.finite = false; }) == Verdict::fail);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [](BoxPoint& p) { p.reference = refused(); }) == Verdict::fail);
  // Above, a refusal by both is honest, a film that nobody can check is not known, and a wrong one fails.
  const auto above = [](BoxPoint& p) { p.p_H_Pa = 5e9; };
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { above(p), p.reference = p.fast = refused(); }) ==
             Verdict::pass);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { above(p), p.reference = refused(); }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { above(p), p.fast.film[0] = 0.08; }) ==
             Verdict::fail);
  // A solver that does not converge cannot excuse a film by an error as large as it likes, nor NaN by the next film.
  const auto vague = [&](BoxPoint& p, double film, double error) {
    above(p), p.reference.status = StopReason::tolerance_not_met;
    p.reference.error[0] = p.reference.error[1] = error, p.fast.film[0] = film;
  };
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { vague(p, 0.0744, 0.01); }) == Verdict::pass);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { vague(p, 0.08, 0.01); }) == Verdict::fail);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { vague(p, 0.08, 1); }) == Verdict::inconclusive);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { vague(p, 0.08, nothing); }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(box_point(), with_a_sound_one, [&](BoxPoint& p) { above(p), p.fast.film[0] = nothing; }) ==
             Verdict::inconclusive);
  // Nothing below 4 GPa, nothing shown.
  BOOST_TEST(spoilt(box_point(), judge_box, [&](BoxPoint& p) { above(p), p.reference = p.fast = refused(); }) ==
             Verdict::inconclusive);
  BOOST_TEST(judge_box({}).verdict == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(bearings_fail_where_one_does_not_balance_or_is_no_balance) {
  const BearingRow dry{
      .law = "hertz", .tried = 1000, .balanced = 1000, .worst_balance = 2e-16, .worst_bisection = 3e-16};
  const BearingRow film{.law = "ehd",
                        .tried = 1000,
                        .balanced = 995,
                        .refused_outside = 5,
                        .worst_balance = 1e-15,
                        .worst_bisection = 1e-15,
                        .unseen = 216,
                        .worst_unseen = 0.6};
  const auto verdict = [&](auto&& change) {
    std::vector<BearingRow> rows{dry, film};
    change(rows[0], rows[1]);
    return judge_bearings(rows).verdict;
  };
  BOOST_TEST((verdict([](auto&, auto&) {}) == Verdict::pass));
  BOOST_TEST((verdict([](auto& one, auto&) { one.balanced = 999; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto& one, auto&) { one.worst_balance = 2e-12; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.worst_bisection = 2e-12; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.worst_bisection = std::nan(""); }) != Verdict::pass));
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 994, one.refused_inside = 1; }) == Verdict::fail));
  // A stated error that does not cover an unseen contact, and too few of these.
  BOOST_TEST((verdict([](auto&, auto& one) { one.worst_unseen = 1.1; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.worst_unseen = std::nan(""); }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.unseen = 199; }) == Verdict::fail));
  // The share is of all that were tried, whatever excuses the rest.
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 990, one.refused_outside = 10; }) == Verdict::pass));
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 989, one.refused_outside = 11; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 900, one.refused_outside = 100; }) == Verdict::fail));
  // A time limit does not excuse a refusal. A missed tolerance is not a balance, and is a failure inside the domain.
  BOOST_TEST((verdict([](auto&, auto& one) { one.refused_outside = 4, one.limits = 1; }) == Verdict::fail));
  BOOST_TEST(
      (verdict([](auto&, auto& one) { one.refused_outside = 4, one.limits = one.late = 1; }) == Verdict::inconclusive));
  BOOST_TEST(
      (verdict([](auto&, auto& one) { one.refused_outside = 4, one.limits = 2, one.late = 1; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.refused_outside = 4, one.missed = 1; }) == Verdict::pass));
  BOOST_TEST((verdict([](auto&, auto& one) { one.refused_outside = 4, one.missed = one.missed_inside = 1; }) ==
              Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 985, one.missed = 10; }) == Verdict::fail));
  BOOST_TEST((verdict([](auto&, auto& one) { one.balanced = 0, one.refused_outside = one.tried; }) == Verdict::fail));
  BOOST_TEST((judge_bearings({}).verdict != Verdict::pass));
}

BOOST_AUTO_TEST_CASE(starts_fail_where_another_solution_is_found) {
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) { r.worst = 1e-10; }) == Verdict::fail);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) { r.worst = nothing; }) == Verdict::inconclusive);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) { r.dishonest = 1; }) == Verdict::fail);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) { r.converged = 0; }) == Verdict::inconclusive);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) { r.own_solved = false; }) == Verdict::fail);
  BOOST_TEST(spoilt(start_row(), judge_starts, [](StartRow& r) {
               r.tolerance = Tolerance::iteration(std::numeric_limits<double>::infinity());
             }) == Verdict::inconclusive);
  // A sound row beside it does not speak for a row without one converged start.
  StartRow silent = start_row();
  silent.converged = 0;
  BOOST_TEST(judge_starts({start_row(), silent}).verdict == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(precision_fails_beyond_condition_times_eps) {
  BOOST_TEST(spoilt(precision_row(), judge_precision, [](PrecisionRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(precision_row(), judge_precision, [](PrecisionRow& r) { r.central = 2e-14; }) == Verdict::fail);
  BOOST_TEST(spoilt(precision_row(), judge_precision, [](PrecisionRow& r) { r.minimum = nothing; }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(precision_row(), judge_precision, [](PrecisionRow& r) { r.tolerance.reset(); }) ==
             Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(rounding_fails_where_films_move_or_a_mode_stops_a_solver) {
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow& r) { r.central = 1e-12; }) == Verdict::fail);
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow& r) { r.status = StopReason::diverged; }) ==
             Verdict::fail);
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow& r) { r.minimum = nothing; }) ==
             Verdict::inconclusive);
  // A mode that was never set moves nothing.
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow& r) { r.in_force = false; }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(rounding_row(), judge_rounding, [](RoundingRow& r) { r.minimum = r.central = 0; }) ==
             Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(condition_fails_where_small_and_large_steps_disagree_or_an_ulp_moves_too_much) {
  BOOST_TEST(spoilt(condition_row(), judge_condition, [](ConditionRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(condition_row(), judge_condition, [](ConditionRow& r) { r.amplification[0] = -0.12; }) ==
             Verdict::fail);
  BOOST_TEST(spoilt(condition_row(), judge_condition, [](ConditionRow& r) { r.ulp_move[1] = 1e-10; }) == Verdict::fail);
  BOOST_TEST(spoilt(condition_row(), judge_condition, [](ConditionRow& r) { r.by_groups[1] = -0.2; }) == Verdict::fail);
  BOOST_TEST(spoilt(condition_row(), judge_condition, [](ConditionRow& r) { r.amplification[1] = nothing; }) ==
             Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(grids_fail_where_a_blind_grid_converges_an_error_is_hidden_or_errors_drift) {
  BOOST_TEST(judge_grids(grid_rows()).verdict == Verdict::pass);
  auto blind = grid_rows();
  blind[0].status = StopReason::converged;
  BOOST_TEST(judge_grids(blind).verdict == Verdict::fail);
  auto hidden = grid_rows();
  hidden[0].stated[0] = 0.5 * *hidden[0].error[0];
  BOOST_TEST(judge_grids(hidden).verdict == Verdict::fail);
  // A bar that the truth's own uncertainty cannot save fails, however small it is.
  auto far_too_small = grid_rows();
  far_too_small[0].stated[0] = 1e-14;
  BOOST_TEST(judge_grids(far_too_small).verdict == Verdict::fail);
  auto zero = grid_rows();
  zero[4].stated[1] = 0;
  BOOST_TEST(judge_grids(zero).verdict == Verdict::fail);
  auto vague = grid_rows();  // sees the zone, but states 10 %
  vague[3].stated[0] = 0.1;
  BOOST_TEST(judge_grids(vague).verdict == Verdict::fail);
  vague[3].status = StopReason::under_resolved;
  BOOST_TEST(judge_grids(vague).verdict == Verdict::pass);
  vague[3].stated[0] = 0.09;
  BOOST_TEST(judge_grids(vague).verdict == Verdict::fail);
  auto unsure = grid_rows();  // of a coarse truth, nothing can be said
  for (auto& row : unsure) row.truth_error[0] = 1e-3;
  BOOST_TEST(judge_grids(unsure).verdict == Verdict::inconclusive);
  auto drifting = grid_rows();  // no smaller than on the grid before, and honest about it
  drifting[4].error[1] = drifting[3].error[1];
  drifting[4].stated[1] = 0.09;
  BOOST_TEST(judge_grids(drifting).verdict == Verdict::pass);  // a factor 4 is within the line's allowance
  drifting[4].error[1] = drifting[2].error[1];
  BOOST_TEST(judge_grids(drifting).verdict == Verdict::fail);
  auto spiky = grid_rows();  // with a spike no order is declared of H_min, but it has to fall
  for (auto& row : spiky) row.spike = true;
  spiky[4].error[0] = 0.9 * *spiky[3].error[0];
  spiky[4].stated[0] = 0.09;
  BOOST_TEST(judge_grids(spiky).verdict == Verdict::pass);
  spiky[4].error[0] = 1.1 * *spiky[3].error[0];
  BOOST_TEST(judge_grids(spiky).verdict == Verdict::fail);
  auto unknown = grid_rows();
  unknown[3].error[0] = nothing;
  BOOST_TEST(judge_grids(unknown).verdict == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(a_grid_that_ends_without_a_result_fails) {
  const GridRow mapped{.solver = "fast",
                       .contact = "M = 100",
                       .nodes = 128,
                       .status = StopReason::converged,
                       .error = {1e-4, 1e-4},
                       .stated = {2e-4, 2e-4},
                       .truth_error = {1e-11, 1e-11}};
  const auto without_films = [](GridRow& row) { row.error[0] = row.error[1] = row.stated[0] = row.stated[1] = {}; };
  BOOST_TEST(spoilt(mapped, judge_grids, [](GridRow&) {}) == Verdict::pass);
  for (const char* solver : {"fast", "reference", "reference.linear"}) {
    BOOST_TEST(spoilt(mapped, judge_grids, [&](GridRow& r) {
                 r.solver = solver, r.status = StopReason::limit_reached, without_films(r);
               }) == Verdict::fail);
    BOOST_TEST(spoilt(mapped, judge_grids, [&](GridRow& r) {
                 r.solver = solver, r.status = StopReason::under_resolved, without_films(r);
               }) == Verdict::fail);
    BOOST_TEST(spoilt(mapped, judge_grids, [&](GridRow& r) {
                 r.solver = solver, r.status = StopReason::tolerance_not_met;
               }) == Verdict::pass);
  }
  BOOST_TEST(spoilt(mapped, judge_grids, [&](GridRow& r) {
               r.nodes = 16, r.status = StopReason::under_resolved, without_films(r);
             }) == Verdict::pass);
  auto between = grid_rows();  // 2 cells: may be called blind, may not run out of time
  between[1].status = StopReason::limit_reached;
  without_films(between[1]);
  BOOST_TEST(judge_grids(between).verdict == Verdict::fail);
  BOOST_TEST(spoilt(mapped, judge_grids, [&](GridRow& r) {
               r.ran = false, r.why = "not run: too large", without_films(r);
             }) == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(extremes_fail_on_nan_hangs_crashes_and_wrong_answers) {
  const auto with_a_sound_one = [](std::vector<ExtremeRow> rows) {
    rows.push_back(extreme_row());
    return judge_extremes(rows);
  };
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.fast->finite = false; }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.wall_s = 60; }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.broke = "ended by Segmentation fault"; }) ==
             Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.lacked_memory = true, r.fast.reset(); }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.fast->film[0] = 0.11; }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.fast->film[0] = -0.1; }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.fast = refused(); }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one,
                    [](ExtremeRow& r) { r.fast = refused(), r.inside = false, r.other.reset(); }) == Verdict::pass);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) { r.fast.reset(), r.other.reset(); }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [](ExtremeRow& r) {
               r.inside = false, r.refused = "M: is out of range\nsecond line";
             }) == Verdict::fail);
  const auto refuse = [](ExtremeRow& r) { r.refused = "M: is out of range", r.fast.reset(), r.other.reset(); };
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [&](ExtremeRow& r) { refuse(r); }) == Verdict::fail);
  BOOST_TEST(spoilt(extreme_row(), with_a_sound_one, [&](ExtremeRow& r) { refuse(r), r.inside = false; }) ==
             Verdict::pass);
  // Refusals alone show nothing, and neither does a film that nobody held against another.
  BOOST_TEST(spoilt(extreme_row(), judge_extremes, [&](ExtremeRow& r) { refuse(r), r.inside = false; }) ==
             Verdict::inconclusive);
  BOOST_TEST(spoilt(extreme_row(), judge_extremes, [](ExtremeRow& r) { r.other.reset(); }) == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(the_box_is_read_from_what_is_stated) {
  const Conditions steel{.load_N_per_m = 1.1e5,
                         .reduced_radius_m = 0.0113,
                         .reduced_modulus_Pa = 2.26e11,
                         .speed_sum_m_per_s = 2.9,
                         .viscosity_Pa_s = 0.021};
  const Lubricant oil{.viscosity = ViscosityLaw::roelands, .alpha_per_Pa = 1.9e-8, .z = 0.68};
  BOOST_TEST(in_the_box(steel, oil, Flooded{}));
  BOOST_TEST(in_the_box(steel, oil, TruncatedAt{-4}));
  BOOST_TEST(!in_the_box(steel, oil, TruncatedAt{-2}));
  // The same edges by groups and by SI: M, L and p_H each alone.
  const auto moved = [&](double load, double radius, double alpha) {
    Conditions conditions = steel;
    conditions.load_N_per_m *= load;
    conditions.reduced_radius_m *= radius;
    Lubricant lubricant = oil;
    *lubricant.alpha_per_Pa *= alpha;
    const auto made = nondimensionalise(conditions, lubricant, Flooded{});
    const Groups& groups = made.problem.groups;
    return std::pair(in_the_box(conditions, lubricant, Flooded{}),
                     groups.M >= 0.05 && groups.M <= 5000 && groups.L <= 30 && made.scales->hertz_pressure_Pa <= 4e9);
  };
  int inside = 0, outside = 0;
  for (const double load : {1e-3, 5e-3, 7e-3, 1.0, 11.0, 12.0, 20.0, 1e3}) {
    for (const double radius : {1e-2, 1.0, 50.0}) {
      for (const double alpha : {0.0, 1.0, 2.0, 2.5}) {
        const auto [by_SI, by_groups] = moved(load, radius, alpha);
        BOOST_TEST(by_SI == by_groups, load << " " << radius << " " << alpha);
        (by_SI ? inside : outside) += 1;
      }
    }
  }
  BOOST_TEST(inside > 0);
  BOOST_TEST(outside > 0);
  BOOST_TEST(in_the_box(MoesGroups{7, 6}, oil, Flooded{}));
  BOOST_TEST(in_the_box(HertzGroups{0.07, 6}, oil, Flooded{}));
  BOOST_TEST(!in_the_box(MoesGroups{5001, 1}, oil, Flooded{}));
  BOOST_TEST(!in_the_box(MoesGroups{7, nothing}, oil, Flooded{}));
  BOOST_TEST(!in_the_box(HertzGroups{-0.07, 6}, oil, Flooded{}));
}

BOOST_AUTO_TEST_CASE(repeats_fail_on_one_solution_that_differs) {
  BOOST_TEST(spoilt(repeat_row(), judge_repeats, [](RepeatRow&) {}) == Verdict::pass);
  BOOST_TEST(spoilt(repeat_row(), judge_repeats, [](RepeatRow& r) { r.same_in_two = 2; }) == Verdict::fail);
  BOOST_TEST(spoilt(repeat_row(), judge_repeats, [](RepeatRow& r) {
               r.ended_by_time = 1;
               r.same_in_two = 2;
             }) == Verdict::inconclusive);
  BOOST_TEST(spoilt(repeat_row(), judge_repeats, [](RepeatRow& r) { r.converged = 0; }) == Verdict::inconclusive);
}

BOOST_AUTO_TEST_CASE(motion_fails_where_three_of_a_hundred_stated_errors_do_not_hold) {
  std::size_t first = 0;
  const auto verdict = [&](std::size_t count, auto spoil) {
    std::vector<MotionPoint> points = motion_points();
    for (std::size_t k = first; k < first + count; ++k) spoil(points[k]);
    return judge_motion(points).verdict;
  };
  for (std::size_t one = 0; one < std::size(motion_tolerances) * std::size(motion_numbers); ++one) {
    const std::size_t number = one % std::size(motion_numbers);
    first = 100 * (one / std::size(motion_numbers));
    const auto too_small = [&](MotionPoint& p) { p.numbers[number].stated = 2.9e-6; };
    BOOST_TEST(verdict(2, too_small) == Verdict::pass);
    BOOST_TEST(verdict(3, too_small) == Verdict::fail);
    const auto vague = [&](MotionPoint& p) { p.numbers[number].truth_error = 4e-6; };
    BOOST_TEST(verdict(3, [&](MotionPoint& p) { too_small(p), vague(p); }) == Verdict::pass);  // 3 of 100 undecided
    BOOST_TEST(verdict(11, [&](MotionPoint& p) { too_small(p), vague(p); }) == Verdict::inconclusive);
    BOOST_TEST(verdict(100, [&](MotionPoint& p) { p.numbers[number] = {}; }) == Verdict::inconclusive);
  }
  const auto not_met = [](MotionPoint& p) { p.status = StopReason::tolerance_not_met; };
  BOOST_TEST(verdict(1, not_met) == Verdict::fail);
  BOOST_TEST(verdict(1, [&](MotionPoint& p) { not_met(p), p.contact.moes.L = 13; }) == Verdict::fail);
  BOOST_TEST(verdict(1, [](MotionPoint& p) { p.status = StopReason::limit_reached, p.late = true; }) ==
             Verdict::inconclusive);
  BOOST_TEST(judge_motion({}).verdict == Verdict::inconclusive);
  const Part part = judge_motion(motion_points());
  BOOST_TEST(part.table.rows.size() == std::size(motion_tolerances) * std::size(motion_numbers));
  for (const auto& row : part.table.rows) BOOST_TEST(row.size() == part.table.columns.size());
  for (const auto& row : part.points->rows) BOOST_TEST(row.size() == part.points->columns.size());
}

BOOST_AUTO_TEST_CASE(films_fail_where_two_of_a_hundred_stated_errors_do_not_hold) {
  std::size_t first = 0;
  const auto verdict = [&](std::size_t count, auto spoil) {
    std::vector<FilmPoint> points = film_points();
    for (std::size_t k = first; k < first + count; ++k) spoil(points[k]);
    return judge_films(points).verdict;
  };
  for (std::size_t one = 0; one < std::size(film_tolerances) * std::size(judged_films); ++one) {
    const std::size_t film = one % std::size(judged_films);
    first = 100 * (one / std::size(judged_films));
    const auto too_small = [&](FilmPoint& p) { p.films[film].stated = 2.9e-7; };
    BOOST_TEST(verdict(1, too_small) == Verdict::pass);
    BOOST_TEST(verdict(2, too_small) == Verdict::fail);
    const auto vague = [&](FilmPoint& p) { p.films[film].truth_error = 4e-7; };
    BOOST_TEST(verdict(10, [&](FilmPoint& p) { too_small(p), vague(p); }) == Verdict::pass);  // undecided
    BOOST_TEST(verdict(11, [&](FilmPoint& p) { too_small(p), vague(p); }) == Verdict::inconclusive);
    BOOST_TEST(verdict(100, [&](FilmPoint& p) { p.films[film] = {}; }) == Verdict::inconclusive);
  }
  BOOST_TEST(verdict(1, [](FilmPoint& p) { p.status = StopReason::tolerance_not_met; }) == Verdict::fail);
  BOOST_TEST(verdict(1, [](FilmPoint& p) { p.status = StopReason::limit_reached, p.late = true; }) ==
             Verdict::inconclusive);
  BOOST_TEST(judge_films({}).verdict == Verdict::inconclusive);
  const Part part = judge_films(film_points());
  BOOST_TEST(part.table.rows.size() == std::size(film_tolerances) * std::size(judged_films));
  for (const auto& row : part.table.rows) BOOST_TEST(row.size() == part.table.columns.size());
  for (const auto& row : part.points->rows) BOOST_TEST(row.size() == part.points->columns.size());
}

BOOST_AUTO_TEST_CASE(a_stated_error_is_judged_against_a_truth_with_its_own_error) {
  BOOST_TEST((judged_error({1, 2, 0.5}) == StatedError::holds));
  BOOST_TEST((judged_error({1.9, 2, 0.2}) == StatedError::holds));  // a truth ten times tighter is exact
  BOOST_TEST((judged_error({1.9, 2, 0.3}) == StatedError::undecided));
  BOOST_TEST((judged_error({2.1, 2, 0.2}) == StatedError::undecided));
  BOOST_TEST((judged_error({2.3, 2, 0.2}) == StatedError::missed));
  BOOST_TEST((judged_error({std::nan(""), 2, 0.2}) == StatedError::undecided));
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_one_line_and_leaves_nothing) {
  const test::Folder folder;
  const std::string out = (folder.path() / "out").string();
  for (const auto& [arguments, says] : std::initializer_list<std::pair<std::string, std::string>>{
           {"--part z", "--part = z: is unknown; allowed is a to k, or the name of a part"},
           {"--threads 0", "--threads = 0: is out of range"},
           {"extra", "ehd stress --help"}}) {
    test::check_refused(folder, fmt::format("stress --quick --output '{}' {}", out, arguments), says);
    BOOST_TEST(!std::filesystem::exists(out), arguments);
  }
}

BOOST_AUTO_TEST_CASE(small_parts_pass_and_leave_their_file) {
  const test::Folder folder;
  const auto out = folder.path() / "new" / "stress";
  const auto run =
      test::ehd_run(folder, "stress --quick --part c --part d --part e --part h --output '" + out.string() + "'");
  BOOST_TEST(run.exit_code == 0, run.out);
  BOOST_TEST(run.err == "");
  const auto json = nlohmann::json::parse(test::read(out / "stress.json"));
  BOOST_TEST(json["schema"] == "ehd-stress-1");
  BOOST_TEST(json["success"] == true);
  BOOST_TEST(json["provenance"].contains("compiler"));
  BOOST_REQUIRE(json["parts"].size() == 4u);
  for (const auto& part : json["parts"]) {
    BOOST_TEST(part["verdict"] == "pass");
    BOOST_TEST(!part["rows"].empty());
    BOOST_TEST(part["tolerance"].contains("reason"));
    for (const auto& row : part["rows"]) BOOST_TEST(row.size() == part["columns"].size());
  }
}

BOOST_AUTO_TEST_SUITE_END()
