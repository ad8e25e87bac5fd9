// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/harmonic.hpp"

#include <cmath>
#include <random>

#include "fast/mapped_ways.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using namespace ehd::fast;
using verification::Tolerance;

namespace {

/// A solved grid.
struct Solved {
  Solved(const Problem& problem, int n)
      : problem_(problem), request{.tolerance = {}, .nodes = n}, run(begin_mapped(problem_, request, workspace)) {
    BOOST_REQUIRE(best_climb(run, request, Care::full).complete);
  }
  [[nodiscard]] Harmonic harmonic() {
    return {run.setting, workspace.now().nodes, run.state, workspace.grids, run.counters};
  }
  /// Of one motion at i Omega to a residual of 1e-8.
  [[nodiscard]] long krylov_steps(double Omega) {
    Harmonic equations = harmonic();
    const long before = run.counters.krylov;
    EHD_CHECK(equations.of_load(Complex(0, Omega), 1e-8).residual, Tolerance::required(1e-8, "the residual asked for"));
    return run.counters.krylov - before;
  }

  Problem problem_;
  Request request;
  Workspace workspace;
  Run run;
};

/// Int_(X_f)^X* rho H dX of every face and, first, of X_a, on the nodes of a state.
Array masses(Solved& solved, const State& state) {
  Discretisation at;
  State moved = state;
  const int n = static_cast<int>(state.P.size()) - 1;
  BOOST_REQUIRE(at.evaluate(solved.run.setting, moved, solved.workspace.grids.of(n), solved.run.counters));
  const Array mass = at.nodes.density.value * at.nodes.H * at.nodes.grid->slope * at.nodes.length / n;
  Array sums(n + 1);
  double sum = mass[n] / 2;
  for (int i = n; i > 0; --i) {
    sums[i] = sum;
    sum += mass[i - 1] / (i > 1 ? 1 : 2);
  }
  sums[0] = sum;
  return sums;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(harmonic)

// By the definition: dN/dT - rho_n H_n dX*/dT + (rho H)_f dX_f/dT.
BOOST_AUTO_TEST_CASE(the_squeeze_is_the_derivative_of_the_oil_between_a_face_and_the_exit) {
  constexpr int n = 128;
  Solved solved(roelands_problem(7, 6, TruncatedAt{-3.7}), n);
  const NodeFields& nodes = solved.workspace.now().nodes;
  const State& state = solved.run.state;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Step step{.P = Array::Zero(n + 1), .offset = 0.3, .exit = -0.4};
  for (int i = 1; i < n; ++i) step.P[i] = state.P[i] * uniform(random);
  constexpr double width = 1e-5;
  const auto moved = [&](double by) {
    State there = state;
    there.P += by * step.P;
    there.offset += by * step.offset;
    there.exit += by * step.exit;
    return masses(solved, there);
  };
  const Array oil = (moved(width) - moved(-width)) / (2 * width);
  const Array mass = nodes.density.value * nodes.H, &place = nodes.grid->place;

  Harmonic equations = solved.harmonic();
  const Array at_rest = equations.product(0.0, step).flux;
  const Array Q = at_rest - equations.product(1.0, step).flux;
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    const double face = (place[i] + place[i + 1]) / 2 * (mass[i] + mass[i + 1]) / 2;
    worst = std::max(worst, std::abs(Q[i] - (oil[i + 1] + (face - mass[n]) * step.exit)));
  }
  EHD_CHECK(worst / Q.abs().maxCoeff(), Tolerance::asymptotic(1e-8, "width squared, and rounding over the width"));
}

BOOST_AUTO_TEST_CASE(the_preconditioner_sees_the_squeeze) {
  long steps = 0;
  for (const int n : {256, 1024}) {
    Solved solved(roelands_problem(20, 10, TruncatedAt{-4}), n);
    for (const double Omega : {0.0, 2.0, 32.0, 128.0}) steps = std::max(steps, solved.krylov_steps(Omega));
  }
  EHD_CHECK(static_cast<double>(steps),
            Tolerance::calibrated(14, "9 were seen; a cycle without the squeeze took 34 and more at Omega = 32"));
}

// chi(s) of a real rate: its slope at 0 is that of the slow load.
BOOST_AUTO_TEST_CASE(a_slow_load_is_the_first_term_in_the_rate) {
  Solved solved(roelands_problem(5, 5, Flooded{}), 256);
  Harmonic equations = solved.harmonic();
  const auto u_0 = equations.of_load(0.0, 1e-10);
  const auto u_1 = equations.of_slow_load(u_0, 1e-10);
  constexpr double rate = 1e-3;
  const double ahead = equations.of_load(rate, 1e-12).u.offset, behind = equations.of_load(-rate, 1e-12).u.offset;
  EHD_CHECK(error(u_1.u.offset, (ahead - behind) / (2 * rate)),
            Tolerance::asymptotic(1e-5, "rate squared, and the residual over the rate"));
  EHD_CHECK(error(u_0.u.offset, (ahead + behind) / 2), Tolerance::asymptotic(1e-5, "rate squared"));
}

// Along the whole contact X = 0 of the film moves with a very long wave.
BOOST_AUTO_TEST_CASE(a_long_wave_lifts_the_body_and_leaves_the_film) {
  Solved solved(roelands_problem(5, 5, TruncatedAt{-4}), 256);
  Harmonic equations = solved.harmonic();
  const Waviness wave{.wavelength = 1e4, .slip = 1};
  auto motion = equations.of_waviness(wave, 1e-10);
  const auto film = equations.central_film(wave, motion);
  BOOST_REQUIRE(film.has_value());
  EHD_CHECK(std::abs(1.0 + *film), Tolerance::asymptotic(1e-4, "what is left falls with the wave number: 6e-6 here"));
}

BOOST_AUTO_TEST_SUITE_END()
