// SPDX-License-Identifier: GPL-3.0-or-later
// (c) The same discrete equations solved in double, in long double and with 34 digits: they differ by rounding alone.
// - reference: the collocation on the solver's last mesh, a template over the scalar (reference/hp).
// - reference.uniform and fast.uniform: equal cells. Their code is written in double, so their equations (README.md of
//   reference/) are written again here for any scalar; only the laws are shared. Both solvers have one truth.
// In the longer scalars chord steps with an LU in double are enough, because the residual decides the solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/lu_factors.hpp"
#include "contact/text.hpp"
#include "reference/equations.hpp"
#include "reference/hp/collocation.ipp"
#include "verification/quad.hpp"
#include "verification/stress/parts.hpp"
#include "verification/studies/solver_lists.hpp"
#include "workflow/parallel.hpp"

namespace ehd::verification::stress {

namespace {

using namespace reference::hp;
using Eigen::Index;

/// As in Discretiser::rounding_of of reference/hp/discretiser.cpp, by which that solver states its errors: ten
/// operations on terms of size 1 + X^2/2.
constexpr double operations = 10;
/// What the solvers on equal cells iterate to, relative to the film at the exit; a film errs by at most 0.24 of that
/// (fast/judgement.hpp).
constexpr double iterated_to_dense = 1e-12, iterated_to_fft = 1e-11;
constexpr double inlet = usual_cut;
constexpr int most_chord_steps = 40;
constexpr double time_limit_s = 60;  ///< of the solve in double

template <class Scalar>
double eps_of() {
  return static_cast<double>(std::numeric_limits<Scalar>::epsilon());
}

template <class To, class From>
VectorOf<To> converted(const VectorOf<From>& from) {
  VectorOf<To> to(from.size());
  for (Index i = 0; i < from.size(); ++i) to[i] = static_cast<To>(from[i]);
  return to;
}

/// A Jacobian in double, its rows scaled, and its factors: one instantiation for all scalars.
class Factors {
 public:
  Factors(const MatrixOf<double>& jacobian, VectorOf<double> rows)
      : rows_(std::move(rows)), lu_(rows_.asDiagonal() * jacobian) {}
  [[nodiscard]] VectorOf<double> step(const VectorOf<double>& residual) const {
    return lu_.solve(-rows_.cwiseProduct(residual));
  }

 private:
  VectorOf<double> rows_;
  LuFactors lu_;
};

struct ChordRun {
  double contraction = 0;
  bool solved = false;
};

/// Chord steps until one is below `rounding`, relative to `unit`. residual() is that of the present state;
/// take(size, step) adds size x step to it and returns the largest change of the unknowns that are no pressures, over
/// size.
template <class Scalar, class Residual, class Take>
ChordRun chord_steps(const Factors& factors, double rounding, double unit, Residual residual, Take take) {
  using std::abs;
  ChordRun run;
  double before = 0;
  for (int k = 0; k < most_chord_steps && !run.solved; ++k) {
    const VectorOf<Scalar> r = residual();
    // Divided by its largest entry: a residual of 1e-30 has to reach the factors with its digits.
    const Scalar size = r.cwiseAbs().maxCoeff();
    if (size == Scalar(0)) break;
    const VectorOf<double> step = factors.step(converted<double, Scalar>(VectorOf<Scalar>(r / size)));
    const double moved = static_cast<double>(size) * take(size, step) / unit;
    run.solved = moved <= rounding;
    if (before > 0 && !run.solved) run.contraction = std::max(run.contraction, moved / before);
    before = moved;
  }
  return run;
}

// -- equal cells ------------------------------------------------------------------------------------------------

/// Unknowns P_1 … P_(n-1), H_0, X*. Terms as in reference/README.md, section 1, k = 0.
template <class Scalar>
class UniformEquations {
 public:
  UniformEquations(const Problem& problem, int intervals) : problem_(problem), n_(intervals), weights_(intervals + 1) {
    using std::abs;
    using std::log;
    // Int hat(t) ln|k - t| dt = G(k+1) - 2 G(k) + G(k-1), G = u^2 ln|u|/2 - 3u^2/4. Terms of size n^2 ln n cancel: 34
    // digits are enough.
    const auto G = [](int k) {
      const Quad u(k);
      return k == 0 ? Quad(0) : Quad(u * u * (log(abs(u)) / 2 - Quad(3) / 4));
    };
    for (int k = 0; k <= n_; ++k) weights_[k] = static_cast<Scalar>(Quad(G(k + 1) - 2 * G(k) + G(k - 1)));
  }

  struct State {
    ArrayOf<Scalar> P;
    Scalar offset{0}, exit{0};
  };

  [[nodiscard]] ArrayOf<Scalar> film(const State& state) const {
    using std::log;
    const Scalar h = (state.exit - Scalar(inlet)) / Scalar(n_), log_h = log(h), sum = state.P.sum();
    const Scalar by_pi = Scalar(1) / boost::math::constants::pi<Scalar>();
    ArrayOf<Scalar> H(n_ + 1);
    for (int i = 0; i <= n_; ++i) {
      Scalar product(0);
      for (int j = 1; j < n_; ++j) product += weights_[std::abs(i - j)] * state.P[j];
      const Scalar X = state.exit - h * Scalar(n_ - i);
      H[i] = state.offset + X * X / Scalar(2) - by_pi * h * (product + log_h * sum);
    }
    return H;
  }

  /// eps P' - f + rho_n H_n on the faces, 2/pi Int P - 1.
  [[nodiscard]] VectorOf<Scalar> residual(const State& state) const {
    using std::exp;
    const Scalar h = (state.exit - Scalar(inlet)) / Scalar(n_), two(2), lambda(problem_.groups.lambda);
    const ArrayOf<Scalar> H = film(state);
    const auto viscosity = evaluate(problem_.viscosity, state.P), density = evaluate(problem_.density, state.P);
    const ArrayOf<Scalar> f = density.value * H;
    VectorOf<Scalar> r(n_ + 1);
    for (int i = 0; i < n_; ++i) {
      const Scalar H_face = (H[i] + H[i + 1]) / two, rho = (density.value[i] + density.value[i + 1]) / two;
      const Scalar mobility =
          rho * H_face * H_face * H_face * fluidity(viscosity.value[i], viscosity.value[i + 1]) / lambda;
      const Scalar wedge = i == 0 ? (f[0] + f[1]) / two : f[i] + (f[i + 1] - f[i - 1]) / Scalar(4);
      r[i] = mobility * (state.P[i + 1] - state.P[i]) / h - wedge + f[n_];
    }
    r[n_] = two / boost::math::constants::pi<Scalar>() * h * state.P.sum() - Scalar(1);
    return r;
  }

 private:
  /// (e^-a - e^-b)/(b - a), a series where that cancels.
  [[nodiscard]] static Scalar fluidity(const Scalar& a, const Scalar& b) {
    using std::abs;
    using std::exp;
    const Scalar d = b - a;
    if (abs(d) > Scalar(0.5)) return (exp(-a) - exp(-b)) / d;
    Scalar term(1), sum(1);  // Sum (-d)^k/(k+1)!
    for (int k = 1; k < 40; ++k) {
      term *= -d / Scalar(k + 1);
      sum += term;
    }
    return exp(-a) * sum;
  }

  Problem problem_;
  int n_;
  VectorOf<Scalar> weights_;
};

template <class Scalar>
struct UniformSolved : ChordRun {
  ArrayOf<Scalar> H, P;
};

/// From the solution in double, until a step is below ten roundings of the film.
template <class Scalar>
UniformSolved<Scalar> uniform_in(const Problem& problem, const Fields& fields) {
  const auto n = static_cast<int>(fields.X.size()) - 1;
  const reference::Equations in_double(problem, reference::uniform_grid(inlet, n));
  const reference::State start{.P = fields.P, .offset = fields.offset, .exit = fields.X[n]};
  const Factors factors(in_double.jacobian(start, in_double.evaluate(start)), VectorOf<double>::Ones(n + 1));
  const UniformEquations<Scalar> equations(problem, n);
  typename UniformEquations<Scalar>::State state{.P = converted<Scalar, double>(fields.P.matrix()).array(),
                                                 .offset = Scalar(start.offset),
                                                 .exit = Scalar(start.exit)};
  const double rounding = operations * eps_of<Scalar>() * (1 + inlet * inlet / 2);
  const ChordRun run = chord_steps<Scalar>(
      factors, rounding, 1, [&] { return equations.residual(state); },
      [&](const Scalar& size, const VectorOf<double>& step) {
        for (int i = 1; i < n; ++i) state.P[i] += size * Scalar(step[i - 1]);
        state.offset += size * Scalar(step[n - 1]);
        state.exit += size * Scalar(step[n]);
        return step.tail(2).cwiseAbs().maxCoeff();
      });
  return {run, equations.film(state), state.P};
}

/// Relative difference of the films at the node where the truth is smallest and at the node next to X = 0; the largest
/// difference of the pressures over their maximum.
template <class One>
void compare(const One& H, const ArrayOf<Quad>& P_truth, const ArrayOf<Quad>& truth, const Array& X, const One& P,
             PrecisionRow& row) {
  using std::abs;
  Index smallest = 0, centre = 0;
  for (Index i = 0; i < truth.size(); ++i) {
    if (truth[i] < truth[smallest]) smallest = i;
    if (std::abs(X[i]) < std::abs(X[centre])) centre = i;
  }
  const auto relative = [&](Index i) { return static_cast<double>(Quad(abs(Quad(Quad(H[i]) - truth[i])) / truth[i])); };
  row.minimum = relative(smallest);
  row.central = relative(centre);
  Quad largest(0), differ(0);
  for (Index i = 0; i < truth.size(); ++i) {
    largest = std::max(largest, P_truth[i]);
    differ = std::max(differ, Quad(abs(Quad(Quad(P[i]) - P_truth[i]))));
  }
  row.pressure = static_cast<double>(Quad(differ / largest));
}

PrecisionRow in_long_double(PrecisionRow row) {
  row.arithmetic = "long double";
  row.tolerance = Tolerance::calibrated(operations * row.condition * eps_of<long double>(),
                                        "10 operations x condition x eps of long double");
  return row;
}

std::vector<PrecisionRow> rows_on_equal_cells(const Problem& problem, const std::string& contact, int intervals) {
  std::vector<PrecisionRow> rows;
  for (const RegisteredSolver* solver : second_order_solvers()) {
    if (!on_equal_cells(*solver)) continue;
    const Solution solution =
        solver->solve(problem, {.tolerance = {}, .nodes = intervals, .time_limit_s = time_limit_s});
    PrecisionRow row{.contact = contact, .arithmetic = "double", .equations = solver->name, .unknowns = intervals + 1};
    row.minimum = row.central = std::nan("");
    if (solution.record.status == StopReason::converged) {
      const Fields& fields = solution.fields;
      const auto truth = uniform_in<Quad>(problem, fields);
      row.contraction = truth.contraction;
      row.condition = (1 + inlet * inlet / 2) / fields.H.minCoeff();
      row.tolerance = Tolerance::round_off(operations, row.condition) +
                      Tolerance::iteration(solver->dense() ? iterated_to_dense : iterated_to_fft);
      if (truth.solved) compare(fields.H, truth.P, truth.H, fields.X, fields.P, row);
      if (solver->dense() && truth.solved) {
        PrecisionRow longer = in_long_double(row);
        longer.equations = "the same equations";
        const auto middle = uniform_in<long double>(problem, fields);
        longer.minimum = longer.central = std::nan("");
        if (middle.solved) compare(middle.H, truth.P, truth.H, fields.X, middle.P, longer);
        rows.push_back(longer);
      }
    }
    rows.push_back(row);
  }
  return rows;
}

// -- collocation ------------------------------------------------------------------------------------------------

/// The mesh of a solution of `reference`, from its nodes: xi = X - X*, unstretched.
Mesh mesh_of(const Fields& fields) {
  Mesh mesh{.inlet = fields.X[0], .breakpoints = {}, .degrees = {}};
  const double exit = fields.X[fields.X.size() - 1];
  for (std::size_t e = 0; e < fields.elements.size(); ++e) {
    mesh.breakpoints.push_back(fields.X[fields.elements[e]] - exit);
    if (e > 0) mesh.degrees.push_back(static_cast<int>(fields.elements[e] - fields.elements[e - 1]));
  }
  mesh.breakpoints.back() = 0;
  return mesh;
}

template <class Scalar>
struct Solved : ChordRun {
  reference::hp::State<Scalar> state;
};

template <class Scalar>
Solved<Scalar> collocation_in(const Problem& problem, const Mesh& mesh, const reference::hp::State<double>& start) {
  const Collocation<double> in_double(problem, mesh, Points::left_radau);
  const Collocation<Scalar> equations(problem, mesh, Points::left_radau);
  const int n = equations.intervals();
  const auto at = in_double.evaluate(start, 0);
  const Factors factors(in_double.jacobian(start, at), at.scale.cwiseInverse());
  reference::hp::State<Scalar> state{.P = converted<Scalar, double>(start.P),
                                     .offset = Scalar(start.offset),
                                     .flux = Scalar(start.flux),
                                     .exit = Scalar(start.exit)};
  const double rounding = operations * 1.5 / start.flux * eps_of<Scalar>();
  const ChordRun run = chord_steps<Scalar>(
      factors, rounding, start.flux, [&] { return equations.evaluate(state, Scalar(0)).residual; },
      [&](const Scalar& size, const VectorOf<double>& step) {
        for (int i = 0; i < n; ++i) state.P[i] += size * Scalar(step[i]);
        state.offset += size * Scalar(step[n]);
        state.flux += size * Scalar(step[n + 1]);
        state.exit += size * Scalar(step[n + 2]);
        return step.tail(3).cwiseAbs().maxCoeff();
      });
  return {run, std::move(state)};
}

template <class Scalar>
ArrayOf<Scalar> films_at_nodes(const Problem& problem, const Mesh& mesh, const reference::hp::State<Scalar>& state) {
  const Collocation<Scalar> equations(problem, mesh, Points::left_radau);
  const auto places = equations.node_places();
  return equations.film(state, places, equations.kernel_rows(places));
}

std::vector<PrecisionRow> rows_on_elements(const Problem& problem, const std::string& contact, double asked) {
  PrecisionRow row{.contact = contact, .arithmetic = "double", .equations = "reference, its mesh"};
  row.minimum = row.central = std::nan("");
  const Solution solution = certified_solver().solve(problem, {.tolerance = asked, .time_limit_s = time_limit_s});
  if (solution.record.status != StopReason::converged) return {row};
  const Fields& fields = solution.fields;
  const auto last = fields.X.size() - 1;
  const Mesh mesh = mesh_of(fields);
  row.unknowns = last + 3;
  // The mesh is rebuilt from the nodes, and its breakpoints may differ in the last digit. So double is solved again
  // too.
  const reference::hp::State<double> given{.P = fields.P.matrix(),
                                           .offset = fields.offset,
                                           .flux = fields.density[last] * fields.H[last],
                                           .exit = fields.X[last]};
  const auto here = collocation_in<double>(problem, mesh, given);
  const auto middle = collocation_in<long double>(problem, mesh, given);
  const auto truth = collocation_in<Quad>(problem, mesh, given);
  row.contraction = truth.contraction;
  row.condition = 1.5 / given.flux;
  row.tolerance = Tolerance::round_off(operations, row.condition);
  PrecisionRow longer = in_long_double(row);
  if (here.solved && middle.solved && truth.solved) {
    const ArrayOf<Quad> H = films_at_nodes(problem, mesh, truth.state), P = truth.state.P.array();
    compare(films_at_nodes(problem, mesh, here.state), P, H, fields.X, Array(here.state.P.array()), row);
    compare(films_at_nodes(problem, mesh, middle.state), P, H, fields.X, ArrayOf<long double>(middle.state.P.array()),
            longer);
  }
  return {longer, row};
}

}  // namespace

std::vector<PrecisionRow> run_precision(const Scope& scope) {
  std::vector<BoxContact> contacts =
      cut_contacts({{{5, 5}, true}, {{20, 10}, true}, {{1, 0}, false}, {{10, 5}, false}, {{100, 10}, true}});
  if (scope.quick) contacts.resize(1);
  const int intervals = scope.quick ? 64 : 256;
  std::vector<std::vector<PrecisionRow>> found(2 * contacts.size());
  scope.show(fmt::format("{} systems with 34 digits", found.size()));
  in_threads(found.size(), scope.threads, [&](std::size_t i) {
    const Problem problem = contacts[i / 2].problem();
    const std::string contact = contacts[i / 2].name();
    found[i] = i % 2 == 0 ? rows_on_equal_cells(problem, contact, intervals)
                          : rows_on_elements(problem, contact, scope.quick ? 1e-4 : 1e-8);
  });
  std::vector<PrecisionRow> rows;
  for (const auto& some : found) rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

Part judge_precision(const std::vector<PrecisionRow>& rows) {
  Part part{.id = "c",
            .name = "precision",
            .question = "What does double precision do to the solution of the same discrete equations?"};
  part.settings = {{"operations", operations}, {"inlet", inlet}, {"digits", 34}};
  part.table.columns = columns_of(
      "contact | equations | arithmetic | unknowns | condition | H_min off | H_cen off | P off | bound | contraction");
  Tally tally;
  double worst = 0, largest = 0;
  for (const PrecisionRow& row : rows) {
    const std::string where = fmt::format("{}, {}, {}", row.contact, row.equations, row.arithmetic);
    part.table.rows.push_back({row.contact, row.equations, row.arithmetic, row.unknowns, row.condition, row.minimum,
                               row.central, row.pressure, row.tolerance, row.contraction});
    if (!row.tolerance) {
      tally.add(Verdict::inconclusive, where + ": not solved");
      continue;
    }
    for (const double error : {row.minimum, row.central}) {
      tally.add(error, 0, *row.tolerance, where + ", a film from 34 digits");
      worst = std::max(worst, error / row.tolerance->value());
      if (row.arithmetic == "double") largest = std::max(largest, error);
    }
    if (row.arithmetic == "double") keep_larger(part.tolerance, *row.tolerance);
  }
  tally.close(part);
  part.summary = fmt::format("films in double are at most {} from those of 34 digits, every row within {} of its bound",
                             plain(largest, 2), plain(worst, 2));
  return part;
}

}  // namespace ehd::verification::stress
