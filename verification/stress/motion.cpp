// SPDX-License-Identifier: GPL-3.0-or-later
// (j) Stiffness and damping at random contacts and frequencies: `fast` against `reference`, and its stated errors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/text.hpp"
#include "verification/bench/timing.hpp"
#include "verification/claim.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

/// `reference` computes to a thousandth of the smaller tolerance of `fast`. So it can judge stated errors far below
/// that tolerance.
constexpr double truth_asked = 1e-7, time_limit_s = 60, truth_time_limit_s = 240;
constexpr int whole = 160, quick_points = 3;
constexpr unsigned seed = 20261125;  // not that of the claim response/fast/random
/// The box that the solvers have to serve, by M, L and Omega.
constexpr double lightest_M = 0.5, heaviest_M = 1000, largest_L = 20, largest_Omega = 10;
constexpr double shortest_wave = 0.5, longest_wave = 5, largest_slip = 2;
constexpr double nearest_cut = -2.5, farthest_cut = -10, lightest_cut_M = 2, share_of_cut = 0.4;

MotionPoint drawn_point(Draw& draw) {
  MotionPoint point;
  BoxContact& contact = point.contact;
  contact.moes = {Draw::digits(draw.logarithmic(lightest_M, heaviest_M), 4),
                  Draw::digits(draw.uniform(0, largest_L), 4)};
  point.Omega = Draw::digits(draw.uniform(0, largest_Omega), 4);
  contact.roelands = draw.uniform(0, 1) < 0.5;
  const double cut = Draw::digits(draw.uniform(farthest_cut, nearest_cut), 4);
  if (draw.uniform(0, 1) < share_of_cut && contact.moes.M >= lightest_cut_M) contact.inlet = TruncatedAt{cut};
  point.waviness.wavelength = Draw::digits(draw.logarithmic(shortest_wave, longest_wave), 4);
  point.waviness.slip = Draw::digits(draw.uniform(0, largest_slip), 4);
  return point;
}

std::string name_of(const MotionPoint& point) {
  const auto* cut = std::get_if<TruncatedAt>(&point.contact.inlet);
  return fmt::format("{}{}, Omega = {}, wave of {} b at slip {}, to {}", point.contact.name(),
                     cut ? ", cut at " + plain(cut->x) : ", flooded", plain(point.Omega),
                     plain(point.waviness.wavelength), plain(point.waviness.slip), plain(point.asked));
}

Compared compared(std::complex<double> value, double stated, std::complex<double> truth, double truth_error) {
  return {.differ = std::abs(value - truth) / std::abs(truth), .stated = stated, .truth_error = truth_error};
}

ResponseRequest request_at(const MotionPoint& point, double tolerance, double limit_s) {
  return {.frequencies = {point.Omega}, .waviness = {point.waviness}, .tolerance = tolerance, .time_limit_s = limit_s};
}

void solve_point(MotionPoint& point, const Response& truth) {
  const Response found =
      default_solver().respond(point.contact.problem(), request_at(point, point.asked, time_limit_s));
  const Stiffness &at = found.frequencies.front(), &exact = truth.frequencies.front();
  point.status = at.status;
  point.truth_status = exact.status;
  point.nodes = found.cost.nodes;
  point.wall_s = found.cost.wall_s;
  point.truth_s = truth.cost.wall_s;
  point.late = out_of_time(found.status, point.wall_s, time_limit_s);
  if (at.status != StopReason::diverged && exact.status != StopReason::diverged)
    point.numbers[0] = compared(at.kappa, at.error, exact.kappa, exact.error);
  const WavinessResponse &wave = found.waviness.front(), &true_wave = truth.waviness.front();
  if (wave.status != StopReason::diverged && true_wave.status != StopReason::diverged)
    point.numbers[3] = compared(wave.film, wave.error, true_wave.film, true_wave.error);
  if (!found.slow || !truth.slow) return;
  point.numbers[1] = compared(found.slow->kappa_0, found.slow->error_0, truth.slow->kappa_0, truth.slow->error_0);
  point.numbers[2] = compared(found.slow->kappa_1, found.slow->error_1, truth.slow->kappa_1, truth.slow->error_1);
}

}  // namespace

std::vector<MotionPoint> run_motion(const Scope& scope) {
  Draw draw(seed);
  constexpr std::size_t tolerances = std::size(motion_tolerances);
  const std::size_t contacts = scope.quick ? quick_points : whole;
  std::vector<MotionPoint> points;
  for (std::size_t k = 0; k < contacts; ++k) {
    points.insert(points.end(), tolerances, drawn_point(draw));
    for (std::size_t i = 0; i < tolerances; ++i) points[tolerances * k + i].asked = motion_tolerances[i];
  }
  scope.show(fmt::format("{} contacts", contacts));
  in_threads(contacts, scope.threads, [&](std::size_t k) {
    MotionPoint* const of_contact = &points[tolerances * k];
    const Response truth = certified_solver().respond(of_contact->contact.problem(),
                                                      request_at(*of_contact, truth_asked, truth_time_limit_s));
    for (std::size_t i = 0; i < tolerances; ++i) solve_point(of_contact[i], truth);
  });
  return points;
}

namespace {

const std::vector<Column> motion_columns = columns_of(
    "laws | M | L | inlet | Omega | wavelength | slip | tolerance | status | reference status | intervals | kappa: "
    "difference | stated | of reference | kappa_0: difference | stated | of reference | kappa_1: difference | stated | "
    "of reference | wavy film: difference | stated | of reference | time [s] | reference time [s]");

std::vector<Cell> cells_of(const MotionPoint& point) {
  const auto* cut = std::get_if<TruncatedAt>(&point.contact.inlet);
  std::vector<Cell> cells{law_name(point.contact.roelands),
                          point.contact.moes.M,
                          point.contact.moes.L,
                          cut ? plain(cut->x) : "flooded",
                          point.Omega,
                          point.waviness.wavelength,
                          point.waviness.slip,
                          point.asked,
                          to_string(point.status),
                          to_string(point.truth_status),
                          point.nodes};
  for (const auto& [differ, stated, truth_error] : point.numbers)
    for (const double number : {differ, stated, truth_error}) cells.emplace_back(number);
  cells.emplace_back(point.wall_s);
  cells.emplace_back(point.truth_s);
  return cells;
}

Verdict judge_end(const MotionPoint& point) { return holds_in_time(point.status == StopReason::converged, point.late); }

/// What the points with one tolerance say.
struct AtTolerance {
  std::size_t points = 0;
  ErrorCount counts[std::size(motion_numbers)] = {};
  long converged = 0;
};

/// The points with this tolerance, counted; `missed` grows by a clause for each stated error that does not hold.
AtTolerance counted(const std::vector<MotionPoint>& points, double asked, std::string& missed) {
  AtTolerance at;
  for (ErrorCount& count : at.counts) count.asked = asked;
  for (const MotionPoint& point : points) {
    if (point.asked != asked) continue;
    ++at.points;
    at.converged += point.status == StopReason::converged ? 1 : 0;
    for (std::size_t k = 0; k < point.numbers.size(); ++k) {
      if (at.counts[k].add(point.numbers[k]) == StatedError::missed)
        missed += fmt::format("; {} at {}: {} stated errors off", motion_numbers[k], name_of(point),
                              plain(point.numbers[k].differ / point.numbers[k].stated, 3));
    }
  }
  return at;
}

Part empty_part() {
  Part part{.id = "j",
            .name = "motion",
            .question =
                "Does fast know stiffness and damping to 1e-4 and to 1e-3 at random contacts, and do its errors "
                "hold?"};
  part.tolerance = Tolerance::required(0.02, "share of stated errors that do not hold: at most 2 in 100");
  part.settings = {{"tolerance", motion_tolerances}, {"reference_tolerance", truth_asked},
                   {"time_limit_s", time_limit_s},   {"seed", seed},
                   {"M", {lightest_M, heaviest_M}},  {"L", {0, largest_L}},
                   {"Omega", {0, largest_Omega}}};
  part.table.columns = columns_of(error_count_columns);
  part.points = Table{.columns = motion_columns};
  return part;
}

}  // namespace

Part judge_motion(const std::vector<MotionPoint>& points) {
  Part part = empty_part();
  Tally tally;
  long unanswered = 0;
  for (const MotionPoint& point : points) {
    part.points->rows.push_back(cells_of(point));
    unanswered += point.truth_status == StopReason::diverged ? 1 : 0;
    tally.add(judge_end(point), fmt::format("{}: kappa by fast {}", name_of(point), to_string(point.status)));
  }
  std::string missed;
  for (const double asked : motion_tolerances) {
    const AtTolerance at = counted(points, asked, missed);
    std::string held;
    for (std::size_t k = 0; k < std::size(motion_numbers); ++k) {
      const ErrorCount& count = at.counts[k];
      judge_share(count, at.points, *part.tolerance, fmt::format("{}, to {}", motion_numbers[k], plain(asked)), tally);
      held += fmt::format("{}{} {} of {}", k > 0 ? ", " : "", motion_numbers[k], count.held, count.judged);
      part.table.rows.push_back(count.cells(motion_numbers[k], at.points));
    }
    part.summary += fmt::format("kappa is known to {} at {} of {} points; stated errors hold: {}; ", plain(asked),
                                at.converged, at.points, held);
  }
  tally.close(part);
  part.summary += fmt::format("reference has no answer at {} points{}", unanswered, missed);
  return part;
}

}  // namespace ehd::verification::stress
