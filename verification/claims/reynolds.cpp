// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 4: the Reynolds equation of every scheme on gaps that do not deform. The scheme is evaluated at P = 0, where
// nothing deflects, and sources give the film any shape. The lubricant is isoviscous, so that the flux is linear in P.
// The pressure then follows face by face from the scheme's own wedge and mobility. Truths by quadrature.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/lu_factors.hpp"
#include "contact/text.hpp"
#include "reference/hp/collocation.hpp"
#include "verification/claims/films_of_pressure.hpp"
#include "verification/claims/schemes.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/exact/martin.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/studies/box.hpp"
#include "verification/studies/fits.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

namespace hp = reference::hp;
using namespace schemes;
using std::numbers::pi;

/// A gap over [inlet, exit], and whether the exit is free (P = P' = 0) or a given end where P = 0.
struct Gap {
  std::string name, sentence;
  std::function<double(double)> film;
  double exit = 0;
  bool free_exit = false;
  double jump = nothing;  ///< where the film jumps
};

/// Pressure, flux and exit by quadrature of dP/dX = lambda (H - q)/H^3.
struct Truth {
  double flux = 0, exit = 0;
  std::function<double(double)> slope;  ///< dP/dX
  double jump = nothing;

  [[nodiscard]] double between(double from, double to) const {
    if (from < jump && jump < to) return exact::integral(slope, from, jump) + exact::integral(slope, jump, to);
    return exact::integral(slope, from, to);
  }
};

Truth truth_of(const Gap& gap, double lambda) {
  const auto film = gap.film;
  Truth truth{.flux = 0, .exit = gap.exit, .slope = {}, .jump = gap.jump};
  // Int H^-2 and Int H^-3 from the inlet. Both integrands are positive: their quadrature cancels nothing.
  const auto moment = [&](int power, double to) {
    const Truth part{
        .flux = 0, .exit = to, .slope = [=](double X) { return std::pow(film(X), -power); }, .jump = gap.jump};
    return part.between(inlet, to);
  };
  if (gap.free_exit) {
    truth.exit = exact::root([&](double X) { return moment(2, X) - film(X) * moment(3, X); }, 0.01, gap.exit);
    truth.flux = film(truth.exit);
  } else {
    truth.flux = moment(2, gap.exit) / moment(3, gap.exit);
  }
  truth.slope = [film, lambda, q = truth.flux](double X) {
    const double H = film(X);
    return lambda * (H - q) / (H * H * H);
  };
  return truth;
}

/// P at the nodes for the flux q, from P = 0 at the inlet.
Array marched(const Scheme& scheme, double q) {
  const Eigen::Index n = scheme.wedge.size();
  Array P = Array::Zero(n + 1);
  for (Eigen::Index i = 0; i < n; ++i)
    P[i + 1] = P[i] + (scheme.X[i + 1] - scheme.X[i]) * (scheme.wedge[i] - q) / scheme.mobility[i];
  return P;
}

struct Solved {
  Scheme scheme;
  Array P;
  double flux = nothing, exit = nothing;
};

Solved solved(Kind kind, const Gap& gap, int intervals) {
  const Problem problem = rigid_problem(gap.film);
  Solved result;
  result.exit = gap.exit;
  if (gap.free_exit) {
    const auto end = [&](double exit) {
      const Scheme at = at_rest(kind, problem, intervals, exit);
      return at.X.size() == 0 ? nothing : marched(at, at.H[intervals])[intervals];
    };
    result.exit = exact::root(end, 0.01, gap.exit);
    if (!std::isfinite(result.exit)) return result;
  }
  result.scheme = at_rest(kind, problem, intervals, result.exit);
  if (result.scheme.X.size() == 0) return result;
  if (gap.free_exit) {
    result.flux = result.scheme.H[intervals];
  } else {  // P_n(q) is linear in q
    const double at_0 = marched(result.scheme, 0)[intervals], at_1 = marched(result.scheme, 1)[intervals];
    result.flux = at_0 / (at_0 - at_1);
  }
  result.P = marched(result.scheme, result.flux);
  return result;
}

/// Largest error of the nodal pressure over the largest pressure.
double pressure_error(const Solved& at, const Truth& truth) {
  if (at.P.size() == 0) return nothing;
  double worst = 0, largest = 0, P = 0;
  for (Eigen::Index i = 1; i < at.P.size(); ++i) {
    P += truth.between(at.scheme.X[i - 1], at.scheme.X[i]);
    if (std::isnan(P)) return nothing;
    const double expected = at.scheme.X[i] > truth.exit && at.exit != truth.exit ? 0 : P;
    worst = worse(worst, std::abs(at.P[i] - expected));
    largest = std::max(largest, std::abs(P));
  }
  return worst / largest;
}

std::vector<Gap> gaps_for(double jump) {
  constexpr double lowest = 0.32, step = 0.21;
  const auto parabola = [](double X) { return lowest + X * X / 2; };
  return {{"martin", "Martin's contact, with a free exit", parabola, 1.5, true},
          {"sommerfeld", "a parabolic gap with P = 0 at both ends", parabola, 1.9, false},
          {"slider", "an inclined slider", [](double X) { return lowest + 0.17 * (1 - X); }, 0.9, false},
          {"rayleigh-step", "Rayleigh's step", [=](double X) { return X <= jump ? lowest + step : lowest; }, 0.9, false,
           jump}};
}

Findings judge_scheme(const Named& scheme) {
  Findings found;
  const RegisteredSolver& solver = *find_solver(scheme.solver);
  const double lambda = rigid_problem({}).groups.lambda;
  // The step lies on the node in the middle of every grid. The film of the face beside it errs by a part of the jump,
  // over one cell: first order.
  const double middle = at_rest(scheme.kind, rigid_problem([](double) { return 1.0; }), 64, 0.9).X[32];
  for (const Gap& gap : gaps_for(middle)) {
    const Truth truth = truth_of(gap, lambda);
    const double declared = std::isnan(gap.jump) ? solver.description.formal_order : 1;
    std::vector<double> x, pressure, flux, exit;
    for (const int intervals : {64, 96, 144, 216}) {
      const Solved at = solved(scheme.kind, gap, intervals);
      x.push_back(-std::log(intervals));
      pressure.push_back(std::log(pressure_error(at, truth)));
      flux.push_back(std::log(std::abs(at.flux / truth.flux - 1)));
      exit.push_back(std::log(std::abs(at.exit / truth.exit - 1)));
    }
    const auto add = [&](const std::string& what, const std::vector<double>& y) {
      found.claims.push_back(order_claim(
          {.id = fmt::format("reynolds/{}/{}/{}", solver.name, gap.name, what),
           .rung = 4,
           .statement = fmt::format("{} reaches the {} of {} with its order", solver.name, what, gap.sentence),
           .solver = solver.name},
          slope(x, y), declared,
          Tolerance::calibrated(0.2, "fitted orders of one face after another, over four grids, are read to a fifth"),
          fmt::format("64 to 216 cells, error {} on the last", scientific(std::exp(y.back()), 2))));
    };
    add("pressure", pressure);
    if (gap.free_exit) add("exit", exit);
    if (std::isnan(gap.jump)) add("flux", flux);
  }
  return found;
}

/// On a gap that does not deform, the reduced pressure q = (1 - e^(-a P))/a of Barus' law is the isoviscous pressure.
/// With the logarithmic mean of the fluidity this also holds for the discrete equation, to rounding.
Findings judge_reduced_pressure(const Named& scheme) {
  constexpr int intervals = 96;
  constexpr double largest = 0.9;  // of a q
  constexpr double lifted = 1e3;   // so that the film stays positive under any pressure
  const Gap gap = gaps_for(0).front();
  const Solved rigid = solved(scheme.kind, gap, intervals);
  double worst = nothing;
  if (rigid.P.size() == intervals + 1) {
    const double a = largest / rigid.P.maxCoeff();
    Array P = -(1 - a * rigid.P).log() / a;
    P[intervals] = 0;
    Problem problem = problem_at({any_M, 1}, false, TruncatedAt{inlet});
    problem.viscosity = Barus{.alpha = a};
    const Array& X = rigid.scheme.X;
    // The scheme evaluates these films at its nodes only.
    const auto evaluate = [&](const Array& film, double offset) {
      problem.sources = sources_for([&X, film](double place) {
        Eigen::Index nearest = 0;
        (X - place).abs().minCoeff(&nearest);
        return film[nearest];
      });
      return evaluated(scheme.kind, problem, rigid.exit, P, offset);
    };
    const Array film = X.unaryExpr(gap.film);
    const Scheme bent = evaluate(film, lifted);
    if (bent.X.size() == intervals + 1) {
      const Array deflection = lifted + film - bent.H;
      const Scheme straight = evaluate(film + deflection, 0);
      if (straight.X.size() == intervals + 1) worst = straight.residual.abs().maxCoeff() / rigid.flux;
    }
  }
  const std::string solver = scheme.solver;
  // The lifted film has an error of 1e3 eps, a q = 0.9 that of P times ten, and dP/dX that of P times n.
  return {{claim({.id = "reynolds/" + solver + "/barus",
                  .rung = 4,
                  .statement = solver + " keeps the reduced pressure of Barus' law on a gap that does not deform",
                  .solver = solver},
                 worst, 0, Tolerance::round_off(10 * (lifted + 10 * intervals)), "flux error over the flux, 96 cells")},
          {}};
}

/// Largest error of collocation on polynomial elements. P' follows from its own film and mobility at its points.
double collocated_error(const Gap& gap, const Truth& truth, int elements, int degree) {
  const double exit = truth.exit, length = exit - inlet;
  hp::Mesh mesh{
      .inlet = inlet, .breakpoints = {}, .degrees = std::vector<int>(static_cast<std::size_t>(elements), degree)};
  for (int e = elements; e >= 0; --e) mesh.breakpoints.push_back(-length * e / elements);
  const hp::Collocation<double> equations(rigid_problem(gap.film), mesh, hp::Points::left_radau);
  const Eigen::Index n = equations.intervals();
  const hp::State<double> rest{.P = VectorOf<double>::Zero(n + 1), .offset = 0, .flux = 0, .exit = exit};
  const auto at = equations.evaluate(rest, 0);
  // dP/dX at the points is linear in P. Unknowns P_0 … P_(n-1) and the flux; the exit is that of the truth.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  for (Eigen::Index j = 0; j < n; ++j) {
    hp::State<double> unit = rest;
    unit.P[j] = 1;
    system.col(j).head(n) = equations.evaluate(unit, 0).slope.head(n).matrix();
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    system.row(i).head(n) *= at.mobility[i];
    system(i, n) = 1;
    right[i] = at.H[i];
  }
  system(n, 0) = 1;
  const Eigen::VectorXd x = LuFactors(std::move(system)).solve(right);
  VectorOf<double> P = VectorOf<double>::Zero(n + 1);
  P.head(n) = x.head(n);
  double worst = std::abs(x[n] / truth.flux - 1), largest = 0, expected = 0, before = inlet;
  for (int e = 0; e < elements; ++e) {
    for (int k = 1; k <= 8; ++k) {
      const double t = k / 4.0 - 1, X = exit + equations.stretching(exit) * equations.xi({e, 1 + t, 1 - t});
      expected += truth.between(before, X);
      before = X;
      const double found = equations.interpolate(P, e, t);
      if (std::isnan(found + expected)) return nothing;
      worst = worse(worst, std::abs(found - expected));
      largest = std::max(largest, std::abs(expected));
    }
  }
  return worst / largest;
}

Findings judge_collocation() {
  Findings found;
  const double lambda = rigid_problem({}).groups.lambda;
  for (const Gap& gap : gaps_for(inlet + (0.9 - inlet) / 2)) {
    if (!std::isnan(gap.jump)) continue;  // a mesh would end an element at the jump: nothing is left for the scheme
    const Truth truth = truth_of(gap, lambda);
    for (const int degree : {2, 3}) {
      std::vector<double> x, y;
      for (const int elements : {48, 72, 108, 162}) {
        x.push_back(-std::log(elements));
        y.push_back(std::log(collocated_error(gap, truth, elements, degree)));
      }
      found.claims.push_back(
          order_claim({.id = fmt::format("reynolds/collocation/{}/degree-{}", gap.name, degree),
                       .rung = 4,
                       .statement = fmt::format("collocation of degree {} reaches the pressure of {} with order {}",
                                                degree, gap.sentence, degree + 1),
                       .solver = certified_solver().name},
                      slope(x, y), degree + 1, order_over_four_grids(),
                      fmt::format("error {} on 162 elements", scientific(std::exp(y.back()), 2))));
    }
  }
  return found;
}

/// The positive half of the antisymmetric pressure on the whole parabola carries 4 eta u_m R/h_0.
Findings judge_half_sommerfeld() {
  // Lengths in sqrt(2 R h_0), P' = 12 (H - q)/H^3 with H = 1 + X^2: q = Int H^-2/Int H^-3 = 4/3, and the load of the
  // half is -Int X P' dX over X < 0, sqrt(2)^2 times that in Martin's units.
  const double load = exact::integral_to_infinity(
      [](double X) {
        const double H = 1 + X * X;
        return X * 12 * (H - 4.0 / 3) / (H * H * H);
      },
      0);
  return {{claim({.id = "exact/half-sommerfeld",
                  .rung = 4,
                  .statement = "the half-Sommerfeld load h_0 w/(eta u_m R) is the quadrature of its pressure"},
                 std::abs(2 * load / exact::half_sommerfeld_load() - 1), 0, Tolerance::discretisation(1e-13, 10))},
          {}};
}

}  // namespace

std::vector<Topic> reynolds_topics() {
  std::vector<Topic> topics;
  const auto add = [&](std::function<Findings()> judge) {
    topics.push_back({.name = "fixed gaps", .rungs = {4}, .judge = std::move(judge)});
  };
  for (const Named& scheme : schemes::all) {
    add([&scheme] { return judge_scheme(scheme); });
    add([&scheme] { return judge_reduced_pressure(scheme); });
    topics.push_back(
        {.name = "films of a given pressure", .rungs = {3}, .judge = [&scheme] { return judge_film(scheme); }});
  }
  add(judge_collocation);
  topics.push_back({.name = "films of a given pressure", .rungs = {3}, .judge = judge_collocation_film});
  add(judge_half_sommerfeld);
  return topics;
}

}  // namespace ehd::verification
