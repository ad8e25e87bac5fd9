// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6 and 8: the response by `fast` against that of the certified solver, against its own steady slope, and its
// order from grid to grid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fast/harmonic.hpp"
#include "fast/mapped_ways.hpp"
#include "verification/claims/response_parts.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

Sentence fast_says(const std::string& id, int rung, std::string statement) {
  return {.id = "response/fast/" + id, .rung = rung, .statement = std::move(statement), .solver = "fast"};
}

/// Two answers to one question: how far they are apart over what both state together.
class Apart {
 public:
  void compare(const std::string& what, fast::Complex value, double error, StopReason status, fast::Complex truth,
               double truth_error) {
    const double differ = std::abs(value - truth) / std::abs(truth);
    const bool known = status == StopReason::converged && std::isfinite(truth_error);
    worst_ = worse(worst_, known ? differ / (error + truth_error) : nothing);
    note_ += fmt::format("{} {}/{}  ", what, plain(differ, 2), plain(error, 2));
  }
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] const std::string& note() const { return note_; }

 private:
  double worst_ = 0;
  std::string note_;
};

void compare_all(const Response& found, const Response& truth, Apart& apart) {
  if (found.slow && truth.slow) {
    apart.compare("kappa_0", found.slow->kappa_0, found.slow->error_0, StopReason::converged, truth.slow->kappa_0,
                  truth.slow->error_0);
    apart.compare("kappa_1", found.slow->kappa_1, found.slow->error_1, StopReason::converged, truth.slow->kappa_1,
                  truth.slow->error_1);
  }
  for (std::size_t k = 0; k < found.frequencies.size(); ++k) {
    const Stiffness &at = found.frequencies[k], &exact = truth.frequencies[k];
    apart.compare("Omega " + plain(at.Omega), at.kappa, at.error, at.status, exact.kappa, exact.error);
  }
  for (std::size_t k = 0; k < found.waviness.size(); ++k) {
    const WavinessResponse &at = found.waviness[k], &exact = truth.waviness[k];
    apart.compare(fmt::format("wave {}, slip {}", plain(at.waviness.wavelength), plain(at.waviness.slip)), at.film,
                  at.error, at.status, exact.film, exact.error);
  }
}

// ---- agreement -----------------------------------------------------------------------------------------------------

Findings judge_both_solvers(MoesGroups moes, const Inlet& inlet) {
  const Problem problem = response_problem(moes, inlet);
  ResponseRequest request{.frequencies = {0, 1, 5, 10}, .waviness = {{1, 0.5}, {1, 1}, {2, 2}}};
  request.tolerance = find_solver("fast")->response_tolerance;
  const Response found = find_solver("fast")->respond(problem, request);
  request.tolerance = 1e-6;
  const Response truth = certified_response(problem, request);
  Apart apart;
  compare_all(found, truth, apart);
  const std::string name = contact_name(moes, inlet);
  Findings findings;
  findings.claims.push_back(
      claim(fast_says("agreement/" + name, 8, "fast and reference agree on kappa and wavy films within stated errors"),
            apart.worst(), 0, Tolerance::stated(),
            fmt::format("difference/stated at 1e-4, n = {}: {}", found.cost.nodes, apart.note())));
  const auto known = [](const auto& at) { return at.status == StopReason::converged; };
  findings.claims.push_back(
      claim_fact(fast_says("tolerance/" + name, 8, "fast knows kappa and wavy films to 1e-4, Omega up to 10"),
                 std::ranges::all_of(found.frequencies, known) && std::ranges::all_of(found.waviness, known),
                 "every status is converged", found.reason));
  return findings;
}

/// Where the far inlet is thick, waviness in it moves the film by 4e-6. That is more than fast states at 1e-6.
Findings judge_waves_of_far_inlet(MoesGroups moes) {
  ResponseRequest request{.waviness = {{11, 1}, {2, 1}, {5, 0.3}}, .tolerance = 1e-6};
  const Problem problem = response_problem(moes, Flooded{});
  const Response found = find_solver("fast")->respond(problem, request);
  request.tolerance = 1e-7;
  const Response truth = certified_response(problem, request);
  Apart apart;
  compare_all({.waviness = found.waviness}, truth, apart);
  Findings findings;
  findings.claims.push_back(
      claim(fast_says("waviness/far-inlet/" + contact_name(moes, Flooded{}), 8,
                      "fast and reference agree on wavy films of a thick inlet to 1e-6, within stated errors"),
            apart.worst(), 0, Tolerance::stated(), "difference/stated: " + apart.note()));
  return findings;
}

/// Of random contacts and frequencies, M of 0.5..1000, L of 0..20, Omega of 0..10, both law sets, flooded and cut.
Findings judge_random_frequencies(int wanted) {
  constexpr unsigned seed = 20261123;
  constexpr int draws_a_point = 2;
  Draw draw(seed);
  int judged = 0, covered = 0, unknown = 0, drawn = 0;
  std::string beyond;
  for (; judged < wanted && drawn < draws_a_point * wanted; ++drawn) {
    const MoesGroups moes{Draw::digits(draw.logarithmic(0.5, 1000), 4), Draw::digits(draw.uniform(0, 20), 4)};
    const double Omega = Draw::digits(draw.uniform(0, 10), 4), cut = Draw::digits(draw.uniform(-10, -2.5), 4);
    const bool roelands = draw.uniform(0, 1) < 0.5, flooded = draw.uniform(0, 1) < 0.6 || moes.M < 2;
    const Problem problem = problem_at(moes, roelands, flooded ? Inlet(Flooded{}) : Inlet(TruncatedAt{cut}));
    const Response found =
        find_solver("fast")->respond(problem, {.frequencies = {Omega}, .tolerance = 1e-4, .time_limit_s = 20});
    const Response truth = certified_response(problem, {.frequencies = {Omega}, .tolerance = 1e-5, .time_limit_s = 20});
    const Stiffness &at = found.frequencies.front(), &exact = truth.frequencies.front();
    if (at.status != StopReason::converged) ++unknown;
    // The truth judges where it is ten times tighter.
    if (at.status == StopReason::diverged || !std::isfinite(at.error) || !(exact.error <= 0.1 * at.error)) continue;
    ++judged;
    const double differ = std::abs(at.kappa - exact.kappa) / std::abs(exact.kappa);
    if (differ <= at.error)
      ++covered;
    else
      beyond += fmt::format("; M = {}, L = {}, Omega = {}: {} bars off", plain(moes.M), plain(moes.L), plain(Omega),
                            plain(differ / at.error, 3));
  }
  Findings findings;
  findings.claims.push_back(claim(
      fast_says("random/covered", 8, "the stated error of kappa by fast holds at random points"),
      judged == wanted ? 1 - covered / static_cast<double>(judged) : nothing, 0,
      Tolerance::required(0.02, "at least 98 in 100"),
      fmt::format("{} of {} covered, {} drawn, {} not known to 1e-4{}", covered, judged, drawn, unknown, beyond)));
  return findings;
}

/// Where no grid resolves the spike. One map leaves 7e-3 in the lag.
Findings judge_narrow_spike(MoesGroups moes) {
  const Problem problem = response_problem(moes, Flooded{});
  const Response found = find_solver("fast")->respond(problem, {.tolerance = 1e-4});
  const Response truth = certified_response(problem, {.tolerance = 1e-6});
  const bool known = found.slow && found.status == StopReason::converged && truth.slow && truth.slow->lag_error < 1e-5;
  const double differ = known ? std::abs(found.slow->lag / truth.slow->lag - 1) : nothing;
  Findings findings;
  findings.claims.push_back(
      claim(fast_says("narrow/" + contact_name(moes, Flooded{}), 8,
                      "with nodes that follow a narrow spike, fast knows the film's lag"),
            differ, 0, Tolerance::required(1e-4, "the tolerance of the request; fixed nodes leave 7e-3"),
            known ? fmt::format("stated {}, n = {}", plain(found.slow->lag_error, 2), found.cost.nodes) : ""));
  findings.claims.push_back(claim(
      fast_says("narrow/stated/" + contact_name(moes, Flooded{}), 8, "the stated error of that lag covers the error"),
      known ? differ / (found.slow->lag_error + truth.slow->lag_error) : nothing, 0, Tolerance::stated()));
  return findings;
}

// ---- at rest -------------------------------------------------------------------------------------------------------

Findings judge_own_slope(MoesGroups moes, const Inlet& inlet) {
  constexpr double tolerance = 1e-7;
  const Response found =
      find_solver("fast")->respond(response_problem(moes, inlet), {.frequencies = {0}, .tolerance = 1e-6});
  const OffsetSlope steady = offset_slope(moes, inlet, "fast", tolerance);
  const double expected = steady.kappa();
  const Stiffness& at = found.frequencies.front();
  Findings findings;
  findings.claims.push_back(
      claim_value(fast_says("slope/" + contact_name(moes, inlet), 6,
                            "kappa(0) by fast is the slope of the load over the offset of its steady solves"),
                  known_kappa(at).real(), expected, 0,
                  Tolerance::discretisation(at.error + expected / std::numbers::pi * steady.uncertainty, 1),
                  fmt::format("kappa(0) = {}, slope {}", plain(at.kappa.real(), 9), plain(expected, 9))));
  return findings;
}

// ---- from grid to grid ---------------------------------------------------------------------------------------------

/// kappa at i Omega on 128 to 1024 intervals of one map.
Findings judge_grid_order(MoesGroups moes, double Omega) {
  fast::Workspace workspace;
  const Problem problem = response_problem(moes, cut_at_4);
  const Request request{.tolerance = {}, .nodes = 1024};
  fast::Run run = fast::begin_mapped(problem, request, workspace);
  const fast::MappedClimb climb = fast::best_climb(run, request, fast::Care::full);
  std::vector<fast::Complex> kappa;
  std::string note = "kappa =";
  for (std::size_t k = 0; k < climb.states.size(); ++k) {
    if (climb.grids[k].nodes < 128) continue;
    fast::State state = climb.states[k];
    fast::Discretisation at;
    if (!at.evaluate(run.setting, state, workspace.grids.of(climb.grids[k].nodes), run.counters)) continue;
    fast::Harmonic harmonic(run.setting, at.nodes, state, workspace.grids, run.counters);
    kappa.push_back(-1.0 / harmonic.of_load(fast::Complex(0, Omega), 1e-10).u.offset);
    note += fmt::format(" {} + {} i", plain(kappa.back().real(), 9), plain(kappa.back().imag(), 9));
  }
  const double order =
      kappa.size() == 4 ? observed_order(std::abs(kappa[1] - kappa[0]), std::abs(kappa[3] - kappa[2]), 4) : nothing;
  Findings findings;
  findings.claims.push_back(
      claim_value(fast_says("order/" + plain(Omega), 6, "kappa by fast is of second order from grid to grid"), order, 2,
                  0, order_over_four_grids(), note));
  return findings;
}

}  // namespace

std::vector<Topic> fast_response_topics() {
  std::vector<Topic> topics;
  const auto agreement = [&](MoesGroups moes, const Inlet& inlet, bool slow) {
    topics.push_back({.name = "response fast agreement " + contact_name(moes, inlet),
                      .rungs = {8},
                      .slow = slow,
                      .judge = [=] { return judge_both_solvers(moes, inlet); },
                      .expected_s = slow ? 10.0 : 2.0});
  };
  agreement({5, 5}, cut_at_4, false);
  agreement({3, 6}, Flooded{}, false);
  agreement({0.1, 2}, cut_at_4, false);  // light: the error that GMRES leaves counts most here
  for (const MoesGroups moes : {MoesGroups{1, 3}, {8, 12}, {20, 10}, {100, 5}, {150, 12}, {500, 8}}) {
    agreement(moes, Flooded{}, true);
    if (moes.M > 2) agreement(moes, cut_at_4, true);
  }
  // Heavy contacts: there the spike is narrow at L = 11, too.
  for (const MoesGroups moes : {MoesGroups{100, 11}, {1000, 11}}) agreement(moes, Flooded{}, true);
  topics.push_back({.name = "response fast waviness", .rungs = {8}, .judge = [] {
                      return judge_waves_of_far_inlet({0.6, 2});
                    }});
  topics.push_back({.name = "response fast random",
                    .rungs = {8},
                    .slow = true,
                    .judge = [] { return judge_random_frequencies(100); },
                    .expected_s = 300});
  topics.push_back({.name = "response fast narrow", .rungs = {8}, .judge = [] { return judge_narrow_spike({8, 22}); }});
  topics.push_back({.name = "response fast slope", .rungs = {6}, .judge = [] {
                      return judge_own_slope({5, 5}, cut_at_4);
                    }});
  for (const double Omega : {0.0, 5.0})
    topics.push_back({.name = "response fast order", .rungs = {6}, .judge = [=] {
                        return judge_grid_order({5, 5}, Omega);
                      }});
  return topics;
}

}  // namespace ehd::verification
