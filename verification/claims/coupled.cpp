// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 5: the coupled equations against a manufactured solution: real deflection, both laws, full film. Second-order
// schemes are asked through their public solve(), from their own starts, for the fields of the grid (fast extrapolates
// films and the like, never fields); the collocation on polynomial elements through
// its Newton's method from the exact state interpolated, since its solver adapts meshes, which fits no order.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "reference/hp/newton.hpp"
#include "verification/claims/fits.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/manufactured.hpp"
#include "verification/registry.hpp"

namespace ehd::verification {

namespace {

using exact::Manufactured;
namespace hp = reference::hp;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Absolute errors in Hertz units: largest over the nodes (collocation: over 21 points an element), and the three
/// numbers that belong to no node.
struct Errors {
  double pressure = nothing, offset = nothing, flux = nothing, exit = nothing;
};
constexpr std::pair<const char*, double Errors::*> quantities[] = {
    {"pressure", &Errors::pressure}, {"offset", &Errors::offset}, {"flux", &Errors::flux}, {"exit", &Errors::exit}};

struct Contact {
  std::string name;
  Manufactured (*make)();
};
const Contact contacts[] = {{"compressible", &Manufactured::compressible}, {"barus", &Manufactured::barus}};

Errors errors_of_solver(const RegisteredSolver& solver, const Manufactured& truth, int intervals) {
  Problem problem = truth.problem();
  problem.wanted = {Quantity::film_offset};
  Request request;
  request.tolerance.reset();
  request.nodes = intervals;
  const Solution solution = solver.solve(problem, request);
  const Fields& at = solution.fields;
  if (solution.record.status != StopReason::converged || at.X.size() != intervals + 1) return {};
  const Manufactured::Choice& chosen = truth.choice();
  Errors errors{.pressure = 0,
                .offset = std::abs(at.offset - chosen.offset),
                .flux = std::abs(at.density[intervals] * at.H[intervals] + truth.balance_source(at.X[intervals]).first -
                                 chosen.flux),
                .exit = std::abs(at.X[intervals] - chosen.exit)};
  for (int i = 0; i <= intervals; ++i) {
    const double P = at.X[i] < chosen.exit ? truth.pressure(at.X[i]).value : 0;
    errors.pressure = worse(errors.pressure, std::abs(at.P[i] - P));
  }
  return errors;
}

Findings judge_solver(const Contact& contact, const std::string& name) {
  const Manufactured truth = contact.make();
  const RegisteredSolver& solver = *find_solver(name);
  constexpr int grids[] = {192, 288, 432, 648};
  std::vector<Errors> errors;
  std::vector<double> x;
  for (const int intervals : grids) {
    errors.push_back(errors_of_solver(solver, truth, intervals));
    x.push_back(-std::log(intervals));
  }
  Findings found;
  for (const auto& [what, member] : quantities) {
    std::vector<double> y;
    for (const Errors& one : errors) y.push_back(std::log(one.*member));
    found.claims.push_back(order_claim(
        {.id = "manufactured/" + contact.name + "/" + name + "/" + what,
         .rung = 5,
         .statement = name + " reaches the manufactured " + what + " (" + contact.name + ") with its declared order",
         .solver = name},
        slope(x, y), solver.description.formal_order,
        Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth"),
        "error " + three_digits(errors.back().*member) + " on " + std::to_string(grids[3]) + " cells"));
  }
  return found;
}

struct Collocated {
  Errors errors;
  double half_length = 0;
};

/// `elements` equal elements from the inlet to the exit.
Collocated collocated(const Manufactured& truth, int elements, int degree) {
  const Problem problem = truth.problem();
  const Manufactured::Choice& chosen = truth.choice();
  const double length = chosen.exit - chosen.inlet;
  hp::Mesh mesh{.inlet = chosen.inlet,
                .breakpoints = {},
                .degrees = std::vector<int>(static_cast<std::size_t>(elements), degree)};
  for (int e = elements; e >= 0; --e) mesh.breakpoints.push_back(-length * e / elements);
  const hp::Collocation<double> equations(problem, mesh, hp::Points::left_radau);

  hp::State<double> start{.P = VectorOf<double>::Zero(equations.intervals() + 1),
                          .offset = chosen.offset,
                          .flux = chosen.flux,
                          .exit = chosen.exit};
  const auto places = equations.node_places();
  for (Eigen::Index i = 1; i + 1 < start.P.size(); ++i)
    start.P[i] = truth.pressure(chosen.exit + equations.xi(places[static_cast<std::size_t>(i)])).value;
  hp::Meter meter{.iterations_left = 100, .end = std::chrono::steady_clock::now() + std::chrono::seconds(60)};
  const hp::NewtonRun run = hp::newton(equations, start, 0, {.iterations = 8}, meter);
  // At the rounding floor the residual goes up and down, and the iteration does not always see that it is there.
  constexpr double rounding_floor = 1e-11;
  if (!(run.residual <= rounding_floor)) return {};

  Collocated result{.errors = {.pressure = 0,
                               .offset = std::abs(run.state.offset - chosen.offset),
                               .flux = std::abs(run.state.flux - chosen.flux),
                               .exit = std::abs(run.state.exit - chosen.exit)},
                    .half_length = length / elements / 2};
  for (int e = 0; e < elements; ++e) {
    for (int k = 0; k <= 20; ++k) {
      const double t = k / 10.0 - 1;
      const double X = run.state.exit + equations.stretching(run.state.exit) * equations.xi({e, 1 + t, 1 - t});
      result.errors.pressure = worse(result.errors.pressure,
                                        std::abs(equations.interpolate(run.state.P, e, t) - truth.pressure(X).value));
    }
  }
  return result;
}

/// In h: continuous piecewise polynomials of degree p that satisfy a first-order equation at the zeros of a polynomial
/// orthogonal to a constant (p >= 2 Radau points) have order p + 1 everywhere (de Boor & Swartz 1973, SIAM
/// J. Numer. Anal. 10, 582). Numbers that are integrals converge faster, and are not judged.
Findings judge_collocation_in_h(const Contact& contact) {
  const Manufactured truth = contact.make();
  Findings found;
  for (const int degree : {2, 3}) {
    std::vector<double> x, y;
    for (const int elements : {48, 72, 108, 162}) {
      x.push_back(-std::log(elements));
      y.push_back(std::log(collocated(truth, elements, degree).errors.pressure));
    }
    found.claims.push_back(order_claim(
        {.id = "manufactured/" + contact.name + "/collocation/degree-" + std::to_string(degree),
         .rung = 5,
         .statement = "collocation of degree " + std::to_string(degree) + " reaches the manufactured pressure (" +
                      contact.name + ") with order " + std::to_string(degree + 1),
         .solver = "reference"},
        slope(x, y), degree + 1, Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth"),
        "error " + three_digits(std::exp(y.back())) + " on 162 elements"));
  }
  return found;
}

/// In p: geometric, by the sum of the half axes of the largest ellipse about an element's ends without the pole, the
/// smallest of all elements (Bernstein).
Findings judge_collocation_in_p(const Contact& contact) {
  const Manufactured truth = contact.make();
  constexpr int elements = 5;
  const double half = (truth.choice().exit - truth.choice().inlet) / elements / 2;
  double ellipse = std::numeric_limits<double>::infinity();
  for (int e = 0; e < elements; ++e) {
    const std::complex<double> z = (truth.pole() - (truth.choice().inlet + (2 * e + 1) * half)) / half,
                               root = std::sqrt(z * z - 1.0);
    ellipse = std::min(ellipse, std::max(std::abs(z + root), std::abs(z - root)));
  }
  std::vector<double> x, y;
  for (int degree = 6; degree <= 18; degree += 2) {
    x.push_back(degree);
    y.push_back(std::log(collocated(truth, elements, degree).errors.pressure));
  }
  Findings found;
  found.claims.push_back(
      order_claim({.id = "manufactured/" + contact.name + "/collocation/spectral",
                   .rung = 5,
                   .statement = "collocation reaches the manufactured pressure (" + contact.name +
                                ") geometrically in the degree, at the rate of its pole",
                   .solver = "reference"},
                  std::exp(-slope(x, y)), ellipse,
                  Tolerance::calibrated(0.1 * ellipse,
                                        "the factor a degree, fitted over seven degrees, is read to a tenth of itself"),
                  "degrees 6 to 18 on 5 elements, error " + three_digits(std::exp(y.back())) + " at 18"));
  return found;
}

}  // namespace

std::vector<Topic> coupled_topics() {
  std::vector<Topic> topics;
  const auto add = [&](std::function<Findings()> judge) {
    topics.push_back({.name = "manufactured solutions", .rungs = {5}, .judge = std::move(judge)});
  };
  for (const Contact& contact : contacts) {
    for (const std::string name : {"reference.uniform", "reference.linear", "fast.uniform", "fast"})
      add([&contact, name] { return judge_solver(contact, name); });
    add([&contact] { return judge_collocation_in_h(contact); });
    add([&contact] { return judge_collocation_in_p(contact); });
  }
  return topics;
}

}  // namespace ehd::verification
