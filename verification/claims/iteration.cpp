// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: how the solvers iterate. Jacobians are derivatives, Newton's method contracts quadratically, the rate of a
// multigrid cycle does not depend on the number of intervals, and iteration counts stay as recorded.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "fast/discretisation.hpp"
#include "fast/jacobian.hpp"
#include "fast/multigrid.hpp"
#include "reference/grid_newton.hpp"
#include "reference/hp/element_newton.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/fits.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

namespace hp = reference::hp;

constexpr double cut_X = -3;
constexpr double shares[] = {8e-3, 4e-3, 2e-3, 1e-3};  ///< of the perturbation

/// Smooth, positive inside, nearly zero at the ends. It solves no contact.
double some_pressure(double X, double exit) {
  return 0.7 * std::exp(-2 * (X + 0.1) * (X + 0.1)) * (1 - std::exp(-4 * (exit - X)));
}
/// A direction of the pressure that moves every node.
double some_change(double X, double exit) {
  return 0.4 * std::sin(1.3 + 2 * X) * std::exp(-X * X) * (1 - std::exp(-4 * (exit - X)));
}
constexpr double some_offset = 0.6, some_exit = 1.07, offset_change = 0.11, exit_change = 0.07;

Problem some_problem() { return problem_at({4.3, 5.2}, true, TruncatedAt{cut_X}); }

Claim quadratic(const std::string& id, const std::string& statement, const std::string& solver,
                const std::vector<double>& left) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < left.size(); ++i) {
    x.push_back(std::log(shares[i]));
    y.push_back(std::log(left[i]));
  }
  return order_claim({.id = "iteration/" + id, .rung = 6, .statement = statement, .solver = solver}, slope(x, y), 2,
                     Tolerance::calibrated(0.1, "fitted orders over four perturbations are read to a tenth"),
                     fmt::format("perturbations of 8e-3 to 1e-3; {} left of the last", scientific(left.back(), 2)));
}

// ---- Jacobians ---------------------------------------------------------------------------------------------------

reference::Grid dense_grid(bool graded, int intervals) {
  reference::Grid grid = reference::uniform_grid(cut_X, intervals);
  if (!graded) return grid;
  const Array s = grid.fractions;
  grid.fractions = s * (0.5 + 0.5 * s);
  for (int i = 0; i < intervals; ++i) grid.kappa[i] = 0.3 * std::sin(i);
  return grid;
}

Claim judge_dense_jacobian(bool graded) {
  constexpr int n = 120;
  const reference::Equations equations(some_problem(), dense_grid(graded, n));
  const Array X = equations.grid().nodes(some_exit);
  reference::State at{
      .P = X.unaryExpr([](double x) { return some_pressure(x, some_exit); }), .offset = some_offset, .exit = some_exit};
  Array change = X.unaryExpr([](double x) { return some_change(x, some_exit); });
  at.P[0] = at.P[n] = change[0] = change[n] = 0;
  const auto base = equations.evaluate(at);
  Eigen::VectorXd step(n + 1);
  step << change.segment(1, n - 1).matrix(), offset_change, exit_change;
  const Eigen::VectorXd linear = equations.jacobian(at, base) * step;
  std::vector<double> left;
  for (const double share : shares) {
    const auto moved = equations.evaluate({.P = at.P + share * change,
                                           .offset = at.offset + share * offset_change,
                                           .exit = at.exit + share * exit_change});
    left.push_back((moved.residual - base.residual - share * linear.array()).abs().maxCoeff());
  }
  const std::string solver = graded ? "reference.linear" : "reference.uniform";
  return quadratic(solver + "/jacobian", "the Jacobian of " + solver + " is the derivative of its residual", solver,
                   left);
}

Claim judge_matrix_free_jacobian(bool mapped) {
  constexpr int n = 128;
  fast::Grids grids;
  if (mapped)
    grids.use(std::make_shared<const fast::Map>(fast::MapShape{
        .inlet = cut_X, .exit = some_exit, .scale = 1, .inlet_width = 0.3, .spike = 0.8, .spike_width = 0.1}));
  const fast::Setting setting = setting_of(some_problem(), cut_X);
  fast::Grid& grid = grids.of(n);
  fast::Counters counters;
  const Array X = cut_X + (some_exit - cut_X) * grid.place;
  fast::State at{.P = X.unaryExpr([](double x) { return some_pressure(x, some_exit); }),
                 .offset = some_offset,
                 .exit = some_exit,
                 .tail = {}};
  fast::Step step{.P = X.unaryExpr([](double x) { return some_change(x, some_exit); }),
                  .offset = offset_change,
                  .exit = exit_change};
  at.P[0] = at.P[n] = step.P[0] = step.P[n] = 0;
  fast::Discretisation base, moved;
  std::vector<double> left;
  if (base.evaluate(setting, at, grid, counters)) {
    fast::Jacobian jacobian;
    jacobian.linearise(setting, base.nodes, at.P, at.exit);
    const auto& [linear, load] = jacobian.apply(step, counters);
    for (const double share : shares) {
      fast::State there = at;
      there.P += share * step.P;
      there.offset += share * step.offset;
      there.exit += share * step.exit;
      if (!moved.evaluate(setting, there, grid, counters)) break;
      left.push_back(worse((moved.error.flux - base.error.flux - share * linear).abs().maxCoeff(),
                           std::abs(moved.error.load - base.error.load - share * load)));
    }
  }
  if (left.size() != std::size(shares)) left.assign(std::size(shares), nothing);
  const std::string solver = mapped ? "fast" : "fast.uniform";
  return quadratic(solver + "/jacobian", "the matrix-free Jacobian of " + solver + " is the derivative of its residual",
                   solver, left);
}

hp::Mesh some_mesh() {
  return {.inlet = cut_X,
          .breakpoints = {cut_X - some_exit, -2.5, -1.7, -1.1, -0.6, -0.2, 0},
          .degrees = {5, 6, 7, 8, 7, 6}};
}

Claim judge_collocation_jacobian() {
  const hp::Collocation<double> equations(some_problem(), some_mesh(), hp::Points::left_radau);
  const Eigen::Index n = equations.intervals();
  const Array X = equations.node_coordinates(some_exit);
  hp::State<double> at{.P = VectorOf<double>(n + 1), .offset = some_offset, .flux = 0.4, .exit = some_exit};
  VectorOf<double> change(n + 1);
  for (Eigen::Index i = 0; i <= n; ++i) {
    at.P[i] = i == n ? 0 : some_pressure(X[i], some_exit);
    change[i] = i == n ? 0 : some_change(X[i], some_exit);
  }
  constexpr double flux_change = 0.05;
  const auto base = equations.evaluate(at, 0);
  Eigen::VectorXd step(n + 3);
  step << change.head(n), offset_change, flux_change, exit_change;
  const Eigen::VectorXd linear = equations.jacobian(at, base) * step;
  std::vector<double> left;
  for (const double share : shares) {
    hp::State<double> there = at;
    there.P += share * change;
    there.offset += share * offset_change;
    there.flux += share * flux_change;
    there.exit += share * exit_change;
    left.push_back((equations.evaluate(there, 0).residual - base.residual - share * linear).cwiseAbs().maxCoeff());
  }
  return quadratic("reference/jacobian", "the Jacobian of reference is the derivative of its residual", "reference",
                   left);
}

Findings judge_jacobians() {
  return {{judge_dense_jacobian(false), judge_dense_jacobian(true), judge_matrix_free_jacobian(false),
           judge_matrix_free_jacobian(true), judge_collocation_jacobian()},
          {}};
}

// ---- Newton's method ---------------------------------------------------------------------------------------------

/// One step from a start near a solution leaves an error that is quadratic in the distance of the start.
Findings judge_newton() {
  Findings found;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  {
    constexpr int n = 200;
    const reference::Equations equations(some_problem(), dense_grid(false, n));
    const auto solved = reference::newton(equations, reference::hertz_start(equations, 0.5, some_exit),
                                          {.newton_iterations = 60, .end = end});
    std::vector<double> left(std::size(shares), nothing);
    if (solved.end == reference::NewtonEnd::solved) {
      const Array change = solved.state.P * solved.at.X.unaryExpr([](double x) { return std::sin(1.3 + 2 * x); });
      left.clear();
      for (const double share : shares) {
        const reference::State beside{.P = solved.state.P + share * change,
                                      .offset = solved.state.offset + 0.1 * share,
                                      .exit = solved.state.exit - 0.1 * share};
        const auto next = reference::newton(equations, beside, {.newton_iterations = 1, .end = end});
        left.push_back(next.iterations == 1 ? worse((next.state.P - solved.state.P).abs().maxCoeff(),
                                                    std::abs(next.state.exit - solved.state.exit))
                                            : nothing);
      }
    }
    found.claims.push_back(quadratic("reference.uniform/newton",
                                     "Newton's method of reference.uniform contracts quadratically",
                                     "reference.uniform", left));
  }
  const hp::Collocation<double> equations(some_problem(), some_mesh(), hp::Points::left_radau);
  hp::Meter meter{.iterations_left = 100, .end = end};
  const auto solved = hp::newton(equations, hp::hertz_start(equations, some_exit, 0.5), 0, {.iterations = 60}, meter);
  std::vector<double> left(std::size(shares), nothing);
  if (solved.solved) {
    const Array X = equations.node_coordinates(solved.state.exit);
    left.clear();
    for (const double share : shares) {
      hp::State<double> beside = solved.state;
      beside.P.array() *= 1 + share * (1.3 + 2 * X).sin();
      beside.offset += 0.1 * share;
      beside.flux += 0.1 * share;
      beside.exit -= 0.1 * share;
      hp::Meter one{.iterations_left = 10, .end = end};
      const auto next = hp::newton(equations, beside, 0, {.iterations = 1, .step = 0}, one);
      left.push_back(
          worse((next.state.P - solved.state.P).cwiseAbs().maxCoeff(), std::abs(next.state.exit - solved.state.exit)));
    }
  }
  found.claims.push_back(
      quadratic("reference/newton", "Newton's method of reference contracts quadratically", "reference", left));
  return found;
}

// ---- Multigrid ---------------------------------------------------------------------------------------------------

/// The part of the linear residual that a cycle leaves, in the geometric mean of the cycles 5 to 12, at the solution of
/// a grid.
double contraction(MoesGroups moes, int n) {
  const Problem problem = problem_at(moes, true, TruncatedAt{usual_cut});
  const Solution solution = find_solver("fast.uniform")->solve(problem, {.tolerance = {}, .nodes = n});
  if (solution.fields.X.size() != n + 1) return nothing;
  const fast::Setting setting = setting_of(problem, usual_cut);
  fast::State state{.P = solution.fields.P, .offset = solution.fields.offset, .exit = solution.fields.X[n], .tail = {}};
  fast::Grids grids;
  fast::Counters counters;
  fast::Discretisation scheme;
  fast::Multigrid multigrid;
  if (!scheme.evaluate(setting, state, grids.of(n), counters)) return nothing;
  fast::Jacobian jacobian;
  jacobian.linearise(setting, scheme.nodes, state.P, state.exit);
  if (!multigrid.prepare(setting, scheme.nodes, jacobian, state, grids, counters)) return nothing;
  fast::Residual left{.flux = Array(n), .load = 0.3};
  for (int i = 0; i < n; ++i) left.flux[i] = std::sin(3.0 * i) + std::cos(0.01 * i);  // rough and smooth
  double early = 0;
  constexpr int first = 4, last = 12;
  for (int cycle = 1; cycle <= last; ++cycle) {
    fast::Step step;
    step.P = Array::Zero(n + 1);
    multigrid.cycle(left, step, counters);
    const fast::Residual& change = jacobian.apply(step, counters);
    left.flux -= change.flux;
    left.load -= change.load;
    if (cycle == first) early = left.flux.matrix().norm();
  }
  return std::pow(left.flux.matrix().norm() / early, 1.0 / (last - first));
}

Findings judge_multigrid(MoesGroups moes) {
  Findings found;
  std::vector<double> x, rates;
  std::string text;
  for (const int n : {256, 512, 1024, 2048, 4096}) {
    x.push_back(std::log2(n));
    rates.push_back(contraction(moes, n));
    text += (text.empty() ? "" : ", ") + plain(rates.back(), 2);
  }
  double worst = 0;
  for (const double rate : rates) worst = worse(worst, rate);
  const std::string point = fmt::format("{}-{}", plain(moes.M), plain(moes.L));
  const std::string at = fmt::format(" at ({},{})", plain(moes.M), plain(moes.L));
  found.claims.push_back(
      claim({.id = "iteration/fast.uniform/multigrid-rate/" + point,
             .rung = 6,
             .statement = "a cycle leaves a bounded share of the linear residual" + at,
             .solver = "fast.uniform"},
            worst, 0,
            Tolerance::calibrated(moes.M < 100 ? 0.25 : 0.8,
                                  "twice the largest seen up to (20,10), .12; .62 was seen at (200,15)"),
            "256 to 4096 cells: " + text));
  found.claims.push_back(
      claim({.id = "iteration/fast.uniform/multigrid-independent/" + point,
             .rung = 6,
             .statement = "that share does not grow with the number of cells" + at,
             .solver = "fast.uniform"},
            worse(0, slope(x, rates)), 0,
            Tolerance::calibrated(0.05, "growth a doubling: after ten of .05 each, a rate is .5 larger"), text));
  return found;
}

// ---- Counts ------------------------------------------------------------------------------------------------------

/// Counted with cold starts on 2026-11-22, the last one on 2026-11-27. There the pressure falls steepest in a layer
/// whose place depends on the floor of the fluidity: `reference` has no film to 1e-6 where its mesh does not follow.
struct RecordedCount {
  BoxContact contact;
  const char* solver;
  std::optional<double> tolerance;
  std::optional<int> nodes;
  double newton, krylov, work_units;
};
BoxContact cut_at(MoesGroups moes) { return {.moes = moes, .inlet = TruncatedAt{usual_cut}}; }
const RecordedCount recorded_counts[] = {
    {cut_at({5, 5}), "fast.uniform", {}, 1024, 12, 12, 19.75},
    {cut_at({20, 10}), "fast.uniform", {}, 1024, 15, 16, 27.75},
    {cut_at({200, 15}), "fast.uniform", {}, 1024, 16, 27, 57.1},
    {cut_at({5, 5}), "fast", 1e-4, {}, 17, 19, 15.0},
    {cut_at({20, 10}), "fast", 1e-4, {}, 31, 31, 22.1},
    {cut_at({200, 15}), "fast", 1e-4, {}, 46, 63, 46.0},
    {cut_at({5, 5}), "reference", 1e-6, {}, 23, 0, 32.0},
    {cut_at({20, 10}), "reference", 1e-6, {}, 61, 0, 55.1},
    {cut_at({5, 5}), "reference.uniform", {}, 512, 21, 0, 12.3},
    {cut_at({200, 15}), "reference.uniform", {}, 512, 20, 0, 25.75},
    {{.moes = {20, 100}, .roelands = false}, "reference", 1e-6, {}, 1074, 0, 2525},
};

Findings judge_counts(const RecordedCount& recorded) {
  const std::string solver = recorded.solver;
  const std::string M = plain(recorded.contact.moes.M), L = plain(recorded.contact.moes.L);
  const Solution solution = find_solver(solver)->solve(recorded.contact.problem(),
                                                       {.tolerance = recorded.tolerance, .nodes = recorded.nodes});
  const Cost& cost = solution.record.cost;
  Findings found;
  const auto add = [&](const std::string& what, double now, double then) {
    Claim judged = claim({.id = fmt::format("iteration/{}/{}/{}-{}", solver, what, M, L),
                          .rung = 6,
                          .statement = fmt::format("{} needs as many {} at ({},{}) as recorded", solver, what, M, L),
                          .solver = solver},
                         converged(solution) ? std::abs(std::log(now / then)) : nothing, 0,
                         Tolerance::calibrated(std::log(1.5), "a factor 1.5 either way of the count recorded"));
    judged.measured = now;
    judged.expected = then;
    found.claims.push_back(std::move(judged));
  };
  add("Newton steps", static_cast<double>(cost.newton_iterations), recorded.newton);
  if (recorded.krylov > 0) add("Krylov steps", static_cast<double>(cost.krylov_iterations), recorded.krylov);
  add("work units", cost.work_units, recorded.work_units);
  return found;
}

/// A uniform solver reports cells that are wider than the inlet zone. At (1000,10), 128 intervals err by 40 % or more.
Findings judge_blind_grids() {
  Findings found;
  for (const std::string solver : {"reference.uniform", "fast.uniform"}) {
    const Solution solution = find_solver(solver)->solve(problem_at({1000, 10}, true, TruncatedAt{usual_cut}),
                                                         {.tolerance = {}, .nodes = 128});
    found.claims.push_back(claim_fact({.id = "iteration/" + solver + "/under-resolved",
                                       .rung = 6,
                                       .statement = solver + " calls 128 intervals at (1000,10) under-resolved",
                                       .solver = solver},
                                      solution.record.status == StopReason::under_resolved,
                                      "a grid that cannot see the inlet zone is never converged",
                                      std::string(to_string(solution.record.status))));
  }
  return found;
}

/// 16 intervals see neither contact: `fast` errs by 41 % of H_min and 32 % of H_cen at (200,15).
Findings judge_coarsest_grid(const BoxContact& contact, const std::string& point) {
  Findings found;
  for (const RegisteredSolver& solver : solvers()) {
    const Solution solution = solver.solve(contact.problem(), {.tolerance = {}, .nodes = 16});
    found.claims.push_back(claim_fact(
        {.id = fmt::format("iteration/{}/16-intervals/{}", solver.name, point),
         .rung = 6,
         .statement = fmt::format("{} calls 16 intervals at {}, flooded, under-resolved", solver.name, contact.name()),
         .solver = solver.name},
        solution.record.status == StopReason::under_resolved,
        "a given grid is converged only where the stated error of both films is below 10 %", how_it_ended(solution)));
  }
  return found;
}

}  // namespace

std::vector<Topic> iteration_topics() {
  std::vector<Topic> topics;
  const auto add = [&](std::function<Findings()> judge) {
    topics.push_back({.name = "iteration", .rungs = {6}, .judge = std::move(judge)});
  };
  add(judge_jacobians);
  add(judge_newton);
  add(judge_blind_grids);
  add([] { return judge_coarsest_grid({.moes = {200, 15}, .roelands = true}, "200-15"); });
  add([] { return judge_coarsest_grid({.moes = {100, 10}, .roelands = false}, "100-10"); });
  for (const MoesGroups moes : {MoesGroups{5, 5}, MoesGroups{20, 10}, MoesGroups{200, 15}})
    add([moes] { return judge_multigrid(moes); });
  for (const RecordedCount& recorded : recorded_counts) add([&recorded] { return judge_counts(recorded); });
  return topics;
}

}  // namespace ehd::verification
