// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/manufactured_study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <memory>

#include "contact/stated_error.hpp"
#include "verification/claim.hpp"

namespace ehd::verification {

using exact::Manufactured;
namespace hp = reference::hp;

ManufacturedErrors errors_of_solver(const RegisteredSolver& solver, const Manufactured& truth, int intervals) {
  Problem problem = truth.problem();
  problem.wanted = {Quantity::film_offset};
  const Solution solution =
      solver.solve(problem, {.tolerance = {}, .nodes = intervals, .max_iterations = most_manufactured_iterations});
  const Fields& at = solution.fields;
  // A coarse grid of a study of the order may be called under-resolved.
  if (!solved_on_its_grid(solution) || at.X.size() != intervals + 1) return {};
  const Manufactured::Choice& chosen = truth.choice();
  ManufacturedErrors errors{.pressure = 0,
                            .offset = std::abs(at.offset - chosen.offset),
                            .flux = std::abs(at.density[intervals] * at.H[intervals] +
                                             truth.balance_source(at.X[intervals]).first - chosen.flux),
                            .exit = std::abs(at.X[intervals] - chosen.exit)};
  for (int i = 0; i <= intervals; ++i) {
    const double P = at.X[i] < chosen.exit ? truth.pressure(at.X[i]).value : 0;
    errors.pressure = worse(errors.pressure, std::abs(at.P[i] - P));
  }
  return errors;
}

std::optional<hp::Resolved> collocation_of(const Manufactured& truth, int elements, int degree) {
  const Problem problem = truth.problem();
  const Manufactured::Choice& chosen = truth.choice();
  const double length = chosen.exit - chosen.inlet;
  hp::Mesh mesh{.inlet = chosen.inlet,
                .breakpoints = {},
                .degrees = std::vector<int>(static_cast<std::size_t>(elements), degree)};
  for (int e = elements; e >= 0; --e) mesh.breakpoints.push_back(-length * e / elements);
  const auto made = std::make_shared<const hp::Collocation<double>>(problem, mesh, hp::Points::left_radau);
  const hp::Collocation<double>& equations = *made;

  hp::State<double> start{.P = VectorOf<double>::Zero(equations.intervals() + 1),
                          .offset = chosen.offset,
                          .flux = chosen.flux,
                          .exit = chosen.exit};
  const auto places = equations.node_places();
  for (Eigen::Index i = 1; i + 1 < start.P.size(); ++i)
    start.P[i] = truth.pressure(chosen.exit + equations.xi(places[static_cast<std::size_t>(i)])).value;
  hp::Meter meter{.iterations_left = 100, .end = std::chrono::steady_clock::now() + std::chrono::seconds(60)};
  hp::NewtonRun run = hp::newton(equations, start, 0, {.iterations = 8}, meter);
  if (run.iterations == 0) return std::nullopt;  // the start interpolates the truth: its own error is no result
  return hp::Resolved{.equations = made, .run = std::move(run)};
}

ManufacturedErrors errors_of_collocation(const Manufactured& truth, int elements, int degree) {
  const auto solved = collocation_of(truth, elements, degree);
  if (!solved) return {};
  const auto& [equations, run, floor, excess] = *solved;
  const Manufactured::Choice& chosen = truth.choice();
  ManufacturedErrors errors{.pressure = 0,
                            .offset = std::abs(run.state.offset - chosen.offset),
                            .flux = std::abs(run.state.flux - chosen.flux),
                            .exit = std::abs(run.state.exit - chosen.exit)};
  for (int e = 0; e < elements; ++e) {
    for (int k = 0; k <= 20; ++k) {
      const double t = k / 10.0 - 1;
      const double X = run.state.exit + equations->stretching(run.state.exit) * equations->xi({e, 1 + t, 1 - t});
      errors.pressure =
          worse(errors.pressure, std::abs(equations->interpolate(run.state.P, e, t) - truth.pressure(X).value));
    }
  }
  // Newton's method does not always notice that the residual has reached rounding. So the residual itself decides: it
  // has to be at rounding, or far below the error that is measured.
  constexpr double rounding_floor = 1e-11, far_below = 1e-3;
  if (!(run.residual <= std::max(rounding_floor, far_below * errors.pressure))) return {};
  return errors;
}

double bernstein_factor(const Manufactured& truth, int elements) {
  const double half = (truth.choice().exit - truth.choice().inlet) / elements / 2;
  double ellipse = std::numeric_limits<double>::infinity();
  for (int e = 0; e < elements; ++e) {
    const std::complex<double> z = (truth.pole() - (truth.choice().inlet + (2 * e + 1) * half)) / half,
                               root = std::sqrt(z * z - 1.0);
    ellipse = std::min(ellipse, std::max(std::abs(z + root), std::abs(z - root)));
  }
  return ellipse;
}

}  // namespace ehd::verification
