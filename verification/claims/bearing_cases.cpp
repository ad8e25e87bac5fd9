// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 11: the bearing cases. Equilibrium, geometry and the dry laws are checked with the printed formulas, not with
// bearing/'s own functions. The paper's statements are reported as computed, whether they hold or not.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/bearing_quantities.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

using std::numbers::pi;

/// The contacts solved so far, shared by the topics: bearings that differ in clearance have the same contacts.
struct SharedMemory {
  std::mutex mutex;
  ContactMemory memory{remembered(default_solver().name).solve};
};

/// F_c = m (d_m/2) w_c^2 of a solid roller, from the case's own numbers.
double centrifugal_N(const BearingCase& body) {
  const auto& g = body.geometry;
  const double gamma = g.roller_diameter_m / g.pitch_diameter_m, per_rpm = 2 * pi / 60;
  const double cage =
      per_rpm * (body.operation.inner_speed_rpm * (1 - gamma) + body.operation.outer_speed_rpm * (1 + gamma)) / 2;
  const double mass = g.density_kg_per_m3 * pi * g.roller_diameter_m * g.roller_diameter_m * g.length_m / 4;
  return mass * g.pitch_diameter_m / 2 * cage * cage;
}

/// k of the laws that are printed as f = k l^(8/9) delta^(10/9) in N and mm: 8.06e4 by Palmgren; ISO/TS 16281's 35948
/// covers both contacts in series. Absent for other laws.
std::optional<double> printed_constant(bearing::Law law) {
  if (law == bearing::Law::hertz) return 8.06e4;
  if (law == bearing::Law::iso) return 35948 * std::pow(2.0, 10.0 / 9);
  return std::nullopt;
}

/// The worst of each equation, all relative: forces to the larger of F_r and their sum, lengths to the displacement.
struct Residuals {
  double ring = 0;      ///< Sum f_i cos psi - F_r, and Sum f_i sin psi
  double rollers = 0;   ///< f_o - f_i - F_c
  double geometry = 0;  ///< delta_i + delta_o - (x cos psi + y sin psi - P_d/2)
  double law = 0;       ///< f - k l^(8/9) delta^(10/9) at loaded contacts of a law with a printed constant k
};

Residuals residuals_of(const BearingCase& body, const BearingResult& result) {
  Residuals worst;
  const double radial = body.operation.radial_load_N, centrifugal = centrifugal_N(body);
  double sum = 0, along = 0, across = 0;
  for (const auto& roller : result.rollers) {
    sum += roller.inner.force_N;
    along += roller.inner.force_N * std::cos(roller.azimuth_deg * pi / 180);
    across += roller.inner.force_N * std::sin(roller.azimuth_deg * pi / 180);
  }
  const double force_scale = std::max(radial, sum), length_scale = std::abs(result.displacement_m);
  worst.ring = worse(std::abs(along - radial), std::abs(across)) / force_scale;
  const std::optional<double> constant = printed_constant(result.law);
  for (const auto& roller : result.rollers) {
    worst.rollers =
        worse(worst.rollers, std::abs(roller.outer.force_N - roller.inner.force_N - centrifugal) / force_scale);
    const double room = result.displacement_m * std::cos(roller.azimuth_deg * pi / 180) +
                        result.displacement_lateral_m * std::sin(roller.azimuth_deg * pi / 180) -
                        body.geometry.clearance_m / 2;
    worst.geometry = worse(worst.geometry,
                           std::abs(roller.inner.displacement_m + roller.outer.displacement_m - room) / length_scale);
    if (!constant) continue;
    for (const ContactRow& contact : {roller.inner, roller.outer}) {
      const double closed = contact.displacement_m <= 0 ? 0.0
                                                        : *constant * std::pow(1e3 * body.geometry.length_m, 8.0 / 9) *
                                                              std::pow(1e3 * contact.displacement_m, 10.0 / 9);
      worst.law = worse(worst.law, std::abs(contact.force_N - closed) / force_scale);
    }
  }
  return worst;
}

Findings judge_bearing(const Case& bearing_case, SharedMemory& shared) {
  const auto& body = std::get<BearingCase>(bearing_case.body);
  std::vector<bearing::Law> laws = default_laws(body);
  if (body.operation.inner_speed_rpm == body.operation.outer_speed_rpm)  // at rest there is no film
    std::erase_if(laws, [](bearing::Law law) { return needs_film(law); });
  for (const auto& expectation : bearing_case.expectations) {
    const auto law = bearing::law_from(expectation.law);
    if (law && std::find(laws.begin(), laws.end(), *law) == laws.end()) laws.push_back(*law);
  }
  std::vector<BearingResult> results;
  {
    const std::lock_guard lock(shared.mutex);
    results = run_bearing(bearing_case, {.laws = laws, .explicitly = false, .films = true}, shared.memory);
  }

  Findings found;
  for (const BearingResult& result : results) {
    const std::string law(to_string(result.law));
    const auto says = [&](const std::string& what, const std::string& statement) {
      return Sentence{.id = fmt::format("{}/{}/{}", bearing_case.id, law, what),
                      .rung = 11,
                      .statement = fmt::format("{} by the law {}: {}", bearing_case.id, law, statement),
                      .case_id = bearing_case.id};
    };
    const bool balanced = result.status == StopReason::converged && !result.rollers.empty();
    found.claims.push_back(
        claim_fact(says("balanced", "the bearing is balanced"), balanced, "every law finds a balance",
                   fmt::format("{}{}", to_string(result.status), result.why.empty() ? "" : ": " + result.why)));
    const Residuals worst = balanced ? residuals_of(body, result) : Residuals{nothing, nothing, nothing, nothing};
    const Tolerance bound = Tolerance::required(1e-12, "balance error below 1e-12");
    found.claims.push_back(claim(says("balance_error", "the reported balance error is below 1e-12"),
                                 balanced ? result.balance_error : nothing, 0, bound));
    found.claims.push_back(
        claim(says("ring", "the rollers carry the radial load, and nothing across it"), worst.ring, 0, bound));
    found.claims.push_back(claim(says("rollers", "f_o = f_i + F_c on every roller"), worst.rollers, 0, bound));
    found.claims.push_back(claim(says("geometry", "delta_i + delta_o = x cos psi + y sin psi - P_d/2 at every roller"),
                                 worst.geometry, 0, bound));
    if (printed_constant(result.law))
      found.claims.push_back(claim(says("law", "every contact obeys the printed power law"), worst.law, 0, bound));
  }

  for (const Expectation& expectation : bearing_case.expectations) {
    Sentence says{.id = fmt::format("{}/{}/{}/{}", bearing_case.id, expectation.law, expectation.quantity,
                                    expectation.waiting ? "waiting" : expectation.digits),
                  .rung = 11,
                  .statement = fmt::format("{}{} of {} by the law {}", expectation.quantity,
                                           expectation.waiting ? "" : " = " + expectation.digits, bearing_case.id,
                                           expectation.law),
                  .case_id = bearing_case.id};
    if (expectation.waiting) {
      found.skipped.push_back({says, "waits for the source's number"});
      continue;
    }
    const auto measured = measure(results, expectation);
    if (expectation.kind == ExpectationKind::fit) {
      found.skipped.push_back({says, "a regression neither passes nor fails" +
                                         (measured ? "; computed " + plain(*measured) : std::string())});
      continue;
    }
    found.claims.push_back(claim_value(says, measured.value_or(nothing), expectation.value, 0,
                                       Tolerance::discretisation(expectation.uncertainty, 1),
                                       "tolerance = the expectation's uncertainty; balances are exact to 1e-12"));
  }
  return found;
}

/// Numbers that docs/results/na4908.md prints of NA4908: verdicts, and ends of the ranges of x_0 in mm.
struct PrintedEnd {
  const char *what, *id, *mm;  ///< mm empty: the statement holds nowhere
  DatumScan::Ranges DatumScan::*ranges;
  bool low;
};
struct PrintedVerdicts {
  bearing::Law law;
  std::string hold, do_not;  ///< letters, by every roller
  std::string hold_at_top;   ///< letters of (a), (b) and (c) that hold at psi = 0 alone
  std::vector<PrintedEnd> ends;
};
std::vector<PrintedVerdicts> printed_verdicts() {
  const auto ends = [](std::array<const char*, 8> mm) {
    using Scan = DatumScan;
    return std::vector<PrintedEnd>{
        {"(a) holds from", "a/from", mm[0], &Scan::a_m, true},
        {"(b) at psi = 0 alone holds up to", "b/to", mm[1], &Scan::b_at_top_m, false},
        {"(c) at psi = 0 alone holds from", "c/from", mm[2], &Scan::c_at_top_m, true},
        {"(c) at psi = 0 alone holds up to", "c/to", mm[3], &Scan::c_at_top_m, false},
        {"the second half of (c) holds up to", "c-opposite/to", mm[4], &Scan::c_opposite_m, false},
        {"(d) holds from", "d/from", mm[5], &Scan::d_m, true},
        {"at psi = 0 alone all hold from", "sign/from", mm[6], &Scan::at_top_m, true},
        {"at psi = 0 alone all hold up to", "sign/to", mm[7], &Scan::at_top_m, false}};
  };
  std::vector<PrintedVerdicts> all{{bearing::Law::ehd_linear, "abd", "c", "ab",
                                    ends({"1.36", "26.9", "0.0573", "0.178", "2.15", "0.085", "0.102", "0.178"})},
                                   {bearing::Law::ehd, "abd", "c", "ab",
                                    ends({"1.73", "26.3", "0.119", "0.637", "2.84", "0.0876", "0.149", "0.637"})}};
  // By every roller; (c) by `ehd` holds nowhere.
  all[0].ends.push_back({"(b) holds up to", "b-all/to", "25.9", &DatumScan::b_m, false});
  all[0].ends.push_back({"(c) holds from", "c-all/from", "0.0811", &DatumScan::c_m, true});
  all[0].ends.push_back({"(c) holds up to", "c-all/to", "0.155", &DatumScan::c_m, false});
  all[1].ends.push_back({"(b) holds up to", "b-all/to", "21.8", &DatumScan::b_m, false});
  all[1].ends.push_back({"(c) holds nowhere", "c-all/nowhere", "", &DatumScan::c_m, true});
  return all;
}

/// Compares the judge with the printed table, so that a changed verdict or a moved end is seen.
void judge_printed(const PrintedVerdicts& printed, const std::vector<PaperStatement>& statements, const DatumScan& scan,
                   Findings& found) {
  const std::string name(to_string(printed.law)), where = "what docs/results/na4908.md prints";
  const auto says = [&](const std::string& id, const std::string& statement) {
    return Sentence{.id = fmt::format("paper/{}/{}", name, id),
                    .rung = 11,
                    .statement = statement + ", law " + name,
                    .case_id = "na4908"};
  };
  for (const bool expected : {true, false})
    for (const char letter : expected ? printed.hold : printed.do_not) {
      const auto one = std::find_if(statements.begin(), statements.end(),
                                    [&](const PaperStatement& of) { return of.letter == letter; });
      found.claims.push_back(claim_fact(
          says(std::string("verdict/") + letter,
               fmt::format("paper's ({}) {} for NA4908, as printed", letter, expected ? "holds" : "does not hold")),
          one != statements.end() && one->holds == expected, where,
          one == statements.end() ? "not judged" : one->numbers));
    }
  for (const char letter : {'a', 'b', 'c'}) {
    const PaperStatement* const one = find_statement(statements, letter);
    const bool expected = printed.hold_at_top.find(letter) != std::string::npos;
    found.claims.push_back(claim_fact(says(std::string("verdict-at-psi-0/") + letter,
                                           fmt::format("at psi = 0 alone the paper's ({}) {} for NA4908, as printed",
                                                       letter, expected ? "holds" : "does not hold")),
                                      one && one->holds_at_top == expected, where, one ? one->numbers : "not judged"));
  }
  found.claims.push_back(claim_fact(says("x0/nowhere", "(a), (b), (c) and (d) hold together with no x_0, as printed"),
                                    scan.half_width_m > 0 && scan.all_hold_m.empty(), where,
                                    words_of(scan, scan.all_hold_m)));
  for (const PrintedEnd& end : printed.ends) {
    const auto& ranges = scan.*end.ranges;
    if (*end.mm == '\0') {
      found.claims.push_back(claim_fact(says(std::string("x0/") + end.id, std::string(end.what) + ", as printed"),
                                        scan.half_width_m > 0 && ranges.empty(), where, words_of(scan, ranges)));
      continue;
    }
    const double x0_m = ranges.size() != 1 ? nothing : end.low ? ranges.front().first : ranges.front().second;
    found.claims.push_back(
        claim_value(says(std::string("x0/") + end.id, fmt::format("{} x_0 = {} mm", end.what, end.mm)), 1e3 * x0_m,
                    std::stod(end.mm), 0,
                    Tolerance::published_digits(end.mm) +
                        Tolerance::required(scan.precision - 1, "precision of the search for the ends"),
                    "one range: " + words_of(scan, ranges)));
  }
}

/// The paper's statements about its figures beside the computed results. These are findings: they pass when they could
/// be computed. Further claims compare the verdicts with those printed in docs/results/.
Findings judge_paper(const std::vector<Case>& clearances, SharedMemory& shared) {
  Findings found;
  const std::lock_guard lock(shared.mutex);
  for (const bearing::Law law : film_laws()) {
    std::vector<ClearanceComparison> rows;
    for (const Case& one : clearances) {
      const auto results =
          run_bearing(one, {.laws = {bearing::Law::hertz, law}, .explicitly = false, .films = false}, shared.memory);
      if (results.size() != 2) continue;
      rows.push_back({std::get<BearingCase>(one.body).geometry.clearance_m, results[0], results[1]});
    }
    const auto statements = judge_paper_statements(rows);
    const std::string name(to_string(law));
    found.claims.push_back(claim_fact({.id = "paper/" + name + "/computed",
                                       .rung = 11,
                                       .statement = "the paper's four statements can be judged by the law " + name,
                                       .case_id = "na4908"},
                                      statements.size() == 4, "a judgement for each statement"));
    for (const PaperStatement& one : statements) {
      found.claims.push_back(claim_finding({.id = fmt::format("paper/{}/{}", name, one.letter),
                                            .rung = 11,
                                            .statement = fmt::format("paper's ({}), law {}: {}: computed: {}",
                                                                     one.letter, name, one.statement, verdict_of(one)),
                                            .case_id = "na4908"},
                                           one.numbers));
    }
    const DatumScan scan = scan_datum(clearances, law, shared.memory);
    found.claims.push_back(claim_finding(
        {.id = "paper/" + name + "/datum",
         .rung = 11,
         .statement =
             fmt::format("the datum x_0 with which (a) to (d) all hold, law {}: {}; each judged at psi = 0 alone: {}",
                         name, words_of(scan, scan.all_hold_m), words_of(scan, scan.at_top_m)),
         .case_id = "na4908"},
        fmt::format("scanned from {} to {} mm in steps of a factor {}, ends to a factor {}",
                    plain(1e3 * scan.lowest_m, 3), plain(1e3 * scan.highest_m, 3), plain(scan.step, 4),
                    plain(scan.precision, 4))));
    for (const PrintedVerdicts& printed : printed_verdicts())
      if (printed.law == law) judge_printed(printed, statements, scan, found);
  }
  return found;
}

/// The literature prints 37.8 N for a roller of the 209 bearing at 10,000 rpm.
Findings judge_centrifugal() {
  const bearing::Geometry geometry{.rollers = 14,
                                   .pitch_diameter_m = 0.065,
                                   .roller_diameter_m = 0.010,
                                   .length_m = 0.0096,
                                   .clearance_m = 0,
                                   .density_kg_per_m3 = 7860,
                                   .first_azimuth_deg = 0};
  const std::string printed = "37.8";
  return {{claim_value({.id = "bearing/centrifugal-209",
                        .rung = 11,
                        .statement = "a roller of the 209 bearing at 10,000 rpm is thrown out with 37.8 N"},
                       bearing::centrifugal_force_N(geometry, bearing::speeds_from_rpm(10000, 0)), std::stod(printed),
                       0, Tolerance::published_digits(printed))},
          {}};
}

}  // namespace

std::vector<Topic> bearing_topics(const std::vector<LoadedCase>& cases) {
  std::vector<Topic> topics{{.name = "centrifugal force", .rungs = {11}, .judge = judge_centrifugal}};
  const auto shared = std::make_shared<SharedMemory>();
  std::vector<Case> paper;
  for (const LoadedCase& loaded : cases) {
    const auto* one = std::get_if<Case>(&loaded.content);
    if (!one || !std::holds_alternative<BearingCase>(one->body)) continue;
    topics.push_back({.name = one->id, .rungs = {11}, .case_id = one->id, .judge = [bearing_case = *one, shared] {
                        return judge_bearing(bearing_case, *shared);
                      }});
    if (one->id == "na4908" || one->id == "na4908-2.5um" || one->id == "na4908-10um") paper.push_back(*one);
  }
  if (paper.size() > 1)
    topics.push_back({.name = "the paper's statements", .rungs = {11}, .judge = [paper, shared] {
                        return judge_paper(paper, *shared);
                      }});
  return topics;
}

}  // namespace ehd::verification
