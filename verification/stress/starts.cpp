// SPDX-License-Identifier: GPL-3.0-or-later
// (b) Random admissible pressures and offsets lead to the same solution, or to an honest failure. solve() takes no
// start (except a neighbour's solution in fast), so the Newton's methods are started directly:
// - reference.uniform and fast.uniform: on 128 equal cells, inlet cut at -4;
// - reference: its collocation on one mesh, with 1e-2 as the floor of the fluidity, where the solver itself begins;
// - fast: from a made-up neighbour. The films must be those of a cold start within the stated errors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "contact/film_formulas.hpp"
#include "contact/text.hpp"
#include "fast/mapped.hpp"
#include "fast/run.hpp"
#include "reference/grid_newton.hpp"
#include "reference/hp/element_newton.hpp"
#include "verification/bench/timing.hpp"
#include "verification/claim.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/draw.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

using std::numbers::pi;
using Clock = std::chrono::steady_clock;

constexpr unsigned seed = 20261124;
constexpr int intervals = 128, time_limit_s = 20;
constexpr double inlet = usual_cut;
/// What Newton's method on equal cells iterates to, relative to the exit's film. A residual changes a film by at most
/// 0.24 of itself in 96 problems (fast/judgement.hpp): 1 covers it.
constexpr double iterated_to = 1e-11, amplification = 1;

/// A random pressure P(X) >= 0, exit and smallest film.
struct Start {
  std::function<double(double)> P;
  double exit = 1, film = 0;
};

constexpr const char* families[] = {"stretched", "bumps", "rough"};

/// stretched: a moved half ellipse, 0.5 to 1.5 times as wide as the contact. bumps: one to four. rough: random values
/// under an ellipse. Films are 0.25 to 4 times the expected one. The caller scales the pressure to the load.
Start drawn(Draw& draw, const std::string& family, double film) {
  const double l = std::max(1.0, std::sqrt(2 * film));
  Start start{.P = {}, .exit = l * draw.uniform(0.7, 1.4), .film = film * draw.logarithmic(0.25, 4)};
  const double exit = start.exit;
  if (family == "bumps") {
    std::vector<std::array<double, 3>> bumps(static_cast<std::size_t>(draw.integer(1, 4)));
    for (auto& [centre, width, height] : bumps) {
      centre = draw.uniform(-1.2 * l, 0.8 * exit);
      width = draw.uniform(0.3, 1.2) * l;
      height = draw.uniform(0.2, 1);
    }
    start.P = [bumps, exit](double X) {
      double sum = 0;
      for (const auto& [centre, width, height] : bumps) {
        const double t = (X - centre) / width;
        if (std::abs(t) < 1) sum += height * std::pow(std::cos(pi / 2 * t), 2);
      }
      return X < exit ? sum * std::min(1.0, (exit - X) / (0.1 * exit)) : 0.0;
    };
    return start;
  }
  const double width = draw.uniform(0.5, 1.5) * l, centre = draw.uniform(-0.3, 0.1) * l;
  const bool rough = family == "rough";
  std::vector<double> noise(1024);
  for (double& one : noise) one = rough ? draw.uniform(0, 2) : 1;
  start.P = [=](double X) {
    const double t = (X - centre) / width;
    const auto at = static_cast<std::size_t>(std::clamp((X / l + 4) * 128, 0.0, 1023.0));
    return std::abs(t) < 1 && X < exit ? std::sqrt(1 - t * t) * noise[at] : 0.0;
  };
  return start;
}

double largest_difference(const Array& film, const Array& truth) {
  return (film / truth - 1).abs().maxCoeff<Eigen::PropagateNaN>();
}

/// Rounding of a film: terms of size 1 + X_a^2/2, relative to the film.
Tolerance rounding(double film) { return Tolerance::round_off(10, (1 + inlet * inlet / 2) / film); }

struct Outcome {
  bool solved = false, finite = true;
  double difference = 0;
};
using Attempt = std::function<Outcome(const Start&)>;

struct Level {
  std::string name;
  bool own_solved;  ///< from the start that the solver makes itself; its film is the truth of the level
  Tolerance tolerance;
  Attempt attempt;
};

Level of_reference_uniform(const Problem& problem) {
  const auto equations =
      std::make_shared<const reference::Equations>(problem, reference::uniform_grid(inlet, intervals));
  const auto budget = [] {
    return reference::Budget{.newton_iterations = 1000, .end = Clock::now() + std::chrono::seconds(time_limit_s)};
  };
  const double film = expected_film({problem.groups.M, problem.groups.L});
  auto own = reference::newton(
      *equations, reference::hertz_start(*equations, film, 1 + 0.45 * std::pow(std::min(film, 1.0), 2.0 / 3)),
      budget());
  if (own.end != reference::NewtonEnd::solved)
    own = reference::newton(*equations, reference::martin_start(*equations, film), budget());
  const bool known = own.end == reference::NewtonEnd::solved;
  const double smallest = known ? own.at.H.minCoeff() : 0;
  const Array truth = own.at.H;
  return {"reference.uniform's Newton", known,
          Tolerance::iteration(2 * iterated_to, amplification) + rounding(smallest), [=](const Start& start) {
            const Array X = equations->grid().nodes(start.exit);
            reference::State state{.P = X.unaryExpr(start.P), .exit = start.exit};
            state.P[0] = state.P[intervals] = 0;
            const double spacing = (start.exit - inlet) / intervals;
            state.P *= pi / 2 / (spacing * state.P.sum());
            state.offset = start.film - equations->film_without_offset(state.P, state.exit).minCoeff();
            const auto run = reference::newton(*equations, state, budget());
            if (!known || run.end != reference::NewtonEnd::solved) return Outcome{};
            return Outcome{true, run.at.H.allFinite() && run.state.P.allFinite(), largest_difference(run.at.H, truth)};
          }};
}

Level of_fast_uniform(const Problem& problem) {
  struct Kept {
    fast::Workspace workspace;
    fast::Counters counters;
  };
  const auto kept = std::make_shared<Kept>();
  kept->workspace.grids.use(nullptr);
  const fast::Setting setting{
      .groups = problem.groups, .viscosity = problem.viscosity, .density = problem.density, .inlet = inlet};
  const auto solve = [=](fast::State& state) {
    static_cast<void>(kept->workspace.grids.of(intervals));  // the grid of now()
    return fast::newton(setting, state, {.residual = iterated_to}, 60,
                        {.newton_iterations = 100000000, .deadline = Clock::now() + std::chrono::seconds(time_limit_s)},
                        kept->workspace, kept->counters);
  };
  // As in fast::succeeded: P >= 0, and the film opens at the exit.
  const auto admissible = [=](const fast::NewtonResult& result, const fast::State& state) {
    const auto& at = kept->workspace.now().nodes;
    return result.end == fast::NewtonEnd::converged && state.P.minCoeff() >= -1e-3 &&
           at.density.value[at.n] * at.H[at.n] >= at.density.value[at.n - 1] * at.H[at.n - 1];
  };
  const double film = expected_film({problem.groups.M, problem.groups.L});
  Array truth;
  for (const auto shape : {fast::likely_shape(film), fast::Shape::hertz, fast::Shape::martin}) {
    fast::State state = fast::first_iterate(setting, shape, film, kept->workspace.grids.of(intervals));
    const auto result = solve(state);
    if (!admissible(result, state)) continue;
    truth = kept->workspace.now().nodes.H;
    break;
  }
  return {"fast.uniform's Newton", truth.size() > 0,
          Tolerance::iteration(2 * iterated_to, amplification) + rounding(truth.size() > 0 ? truth.minCoeff() : 0),
          [=](const Start& start) {
            const Array X = Array::LinSpaced(intervals + 1, inlet, start.exit);
            fast::State state{.P = X.unaryExpr(start.P), .exit = start.exit, .tail = {}};
            state.P[0] = state.P[intervals] = 0;
            state.P *= pi / 2 / ((start.exit - inlet) / intervals * state.P.sum());
            state.offset = fast::offset_for(start.film, setting, state, kept->workspace.grids.of(intervals));
            const auto result = solve(state);
            if (truth.size() == 0 || !admissible(result, state)) return Outcome{};
            const Array& H = kept->workspace.now().nodes.H;
            return Outcome{true, H.allFinite() && state.P.allFinite(), largest_difference(H, truth)};
          }};
}

Level of_reference(const Problem& problem) {
  using namespace reference::hp;
  constexpr double floor = 1e-2, step = 1e-10;
  const double film = expected_film({problem.groups.M, problem.groups.L}), l = std::max(1.0, std::sqrt(2 * film)),
               zone = l * std::pow(std::min(film, 1.0), 2.0 / 3);
  const double exit = std::max(1 + 0.45 * zone / l, 0.5 * std::sqrt(2 * film));
  const auto equations = std::make_shared<const Collocation<double>>(
      problem, seeded_mesh({.inlet = inlet, .exit = exit, .length = l, .inlet_zone = zone}), Points::left_radau);
  const auto solve = [=](const State<double>& state) {
    Meter meter{.iterations_left = 1000, .end = Clock::now() + std::chrono::seconds(time_limit_s)};
    return newton(*equations, state, floor, {.iterations = 60, .step = step}, meter);
  };
  NewtonRun own;
  for (const double factor : {1.0, 2.0, 0.5, 4.0}) {
    own = solve(hertz_start(*equations, exit, factor * film));
    if (!own.solved) own = solve(martin_start(*equations, exit, factor * film));
    if (own.solved) break;
  }
  const double flux = own.solved ? own.state.flux : 0;
  return {"reference's Newton, floor 1e-2", flux > 0, Tolerance::iteration(2 * step, amplification) + rounding(flux),
          [=](const Start& start) {
            State<double> state{.P = equations->node_coordinates(start.exit).unaryExpr(start.P).matrix(),
                                .exit = start.exit};
            const auto last = state.P.size() - 1;
            state.P[last] = 0;
            auto at = equations->evaluate(state, floor);
            state.P *= pi / 2 / at.load_integral / equations->stretching(start.exit);
            at = equations->evaluate(state, floor);
            state.offset = start.film - at.H.minCoeff();
            state.flux = start.film;
            const auto run = solve(state);
            if (!(flux > 0) || !run.solved) return Outcome{};
            return Outcome{true, run.state.P.allFinite() && std::isfinite(run.state.flux),
                           worse(std::abs(run.state.flux / flux - 1), largest_difference(run.at.H, own.at.H))};
          }};
}

Level of_fast(const Problem& problem) {
  const Request request{.tolerance = 1e-4, .time_limit_s = time_limit_s};
  const Solution cold = fast::Mapped().solve(problem, request);
  const Ended truth = ended(cold);
  // Relative to the sum of the stated errors.
  return {"fast, warm start", truth.status == StopReason::converged && truth.has_films(),
          Tolerance::required(1, "difference over the sum of the stated errors"), [=](const Start& start) {
            Solution neighbour = cold;
            Fields& fields = neighbour.fields;
            fields.X = inlet + (start.exit - inlet) * (cold.fields.X - cold.fields.X[0]) /
                                   (cold.fields.X[cold.fields.X.size() - 1] - cold.fields.X[0]);
            fields.P = fields.X.unaryExpr(start.P);
            fields.H = start.film + fields.X.square() / 2;
            fields.offset = start.film;
            fast::Workspace workspace;
            const Ended end = ended(fast::Mapped().solve(problem, request, workspace, neighbour));
            if (end.status != StopReason::converged) return Outcome{};
            return Outcome{true, end.finite, over_stated_errors(end, truth)};
          }};
}

}  // namespace

std::vector<StartRow> run_starts(const Scope& scope) {
  std::vector<BoxContact> contacts =
      cut_contacts({{{1, 0}, false}, {{5, 5}, true}, {{20, 10}, true}, {{10, 5}, false}, {{50, 10}, true}});
  if (scope.quick) contacts.resize(2);
  const int starts = scope.quick ? 8 : 100;
  using Maker = Level (*)(const Problem&);
  const Maker makers[] = {of_reference_uniform, of_fast_uniform, of_reference, of_fast};
  std::vector<StartRow> rows(contacts.size() * std::size(makers) * std::size(families));
  scope.show(fmt::format("{} x {} starts", rows.size(), starts));
  in_threads(rows.size(), scope.threads, [&](std::size_t index) {
    const auto family_at = index % std::size(families), maker_at = index / std::size(families) % std::size(makers);
    const BoxContact& contact = contacts[index / std::size(families) / std::size(makers)];
    const Problem problem = contact.problem();
    const Stopwatch watch;
    const Level level = makers[maker_at](problem);
    StartRow& row = rows[index];
    row = {
        .level = level.name, .contact = contact.name(), .family = families[family_at], .own_solved = level.own_solved};
    row.own_late = !level.own_solved && watch.seconds() >= time_limit_s;
    if (level.own_solved) row.tolerance = level.tolerance;
    Draw draw(seed + static_cast<unsigned>(family_at));  // the same starts for every level
    for (int i = 0; i < starts; ++i) {
      const Outcome outcome =
          level.attempt(drawn(draw, row.family, expected_film({problem.groups.M, problem.groups.L})));
      ++row.starts;
      if (!outcome.solved) continue;
      ++row.converged;
      row.dishonest += outcome.finite ? 0 : 1;
      row.worst = worse(row.worst, outcome.difference);
    }
  });
  return rows;
}

Part judge_starts(const std::vector<StartRow>& rows) {
  Part part{
      .id = "b", .name = "starts", .question = "Do random admissible pressures and offsets end in the same solution?"};
  part.settings = {{"seed", seed}, {"intervals", intervals}, {"inlet", inlet}};
  part.table.columns = columns_of("level | contact | family | starts | converged | largest difference | tolerance");
  Tally tally;
  long starts = 0, converged = 0;
  double worst = 0;
  for (const StartRow& row : rows) {
    part.table.rows.push_back(
        {row.level, row.contact, row.family, row.starts, row.converged, row.worst, row.tolerance});
    const std::string where = fmt::format("{}, {}, {}", row.level, row.contact, row.family);
    starts += row.starts;
    converged += row.converged;
    tally.require(row.dishonest == 0, where + ": numbers that are not finite in what is called solved");
    // All contacts lie in the box and are resolved, so a solver has to converge from its own start.
    tally.add(holds_in_time(row.own_solved, row.own_late), where + ": not solved from the solver's own start");
    if (row.starts == 0 || row.converged == 0 || !row.tolerance || !std::isfinite(row.tolerance->value())) {
      tally.add(Verdict::inconclusive, where + (row.starts == 0      ? ": nothing ran"
                                                : row.converged == 0 ? ": not one start converged"
                                                                     : ": no finite tolerance"));
    } else {
      tally.add(row.worst, 0, *row.tolerance, where + ", difference from the own start's film");
      worst = worse(worst, row.worst / row.tolerance->value());
    }
    if (row.tolerance && row.level.ends_with("Newton")) keep_larger(part.tolerance, *row.tolerance);
  }
  tally.close(part);
  part.summary = fmt::format(
      "{} of {} random starts converge, to the same solution (at most {} of the tolerance); the others fail honestly",
      converged, starts, plain(worst, 2));
  return part;
}

}  // namespace ehd::verification::stress
