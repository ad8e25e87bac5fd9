// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/motion_study.hpp"

#include <complex>

#include "fast/harmonic.hpp"
#include "fast/mapped_ways.hpp"
#include "reference/hp/harmonic.hpp"
#include "verification/claim.hpp"
#include "verification/studies/manufactured_study.hpp"

namespace ehd::verification {

using exact::ManufacturedMotion;
using Amplitude = std::complex<double>;

MotionErrors motion_errors_of_fast(const ManufacturedMotion& truth, int intervals) {
  constexpr double residual = 1e-11;
  const Problem problem = truth.steady().problem();
  const Request request{.tolerance = {}, .nodes = intervals, .max_iterations = most_manufactured_iterations};
  fast::Workspace workspace;
  fast::Run run = fast::begin_mapped(problem, request, workspace);
  const fast::MappedClimb climb = fast::best_climb(run, request, fast::Care::full);
  if (climb.states.empty() || climb.grids.back().nodes != intervals) return {};
  fast::State state = climb.states.back();
  fast::Discretisation at;
  if (!at.evaluate(run.setting, state, workspace.grids.of(intervals), run.counters)) return {};
  fast::Harmonic harmonic(run.setting, at.nodes, state, workspace.grids, run.counters);

  const Array X = at.nodes.places(run.setting.inlet), &place = at.nodes.grid->place;
  ArrayOf<Amplitude> feature(intervals + 1), flux(intervals);
  for (int i = 0; i <= intervals; ++i) feature[i] = truth.feature(X[i]);
  const Amplitude at_exit = truth.balance_source(X[intervals]);
  for (int i = 0; i < intervals; ++i)
    flux[i] = at_exit - truth.balance_source(run.setting.inlet + at.nodes.length * (place[i] + place[i + 1]) / 2);
  const auto motion = harmonic.of_sources(Amplitude(0, truth.choice().Omega),
                                          {.feature = feature, .flux = flux, .load = truth.load()}, residual);
  if (!(motion.residual <= 10 * residual)) return {};
  MotionErrors errors{.pressure = 0,
                      .offset = std::abs(motion.u.offset - truth.choice().offset),
                      .exit = std::abs(motion.u.exit - truth.exit())};
  for (int i = 0; i < intervals; ++i)
    errors.pressure = worse(errors.pressure, std::abs(motion.u.P[i] - truth.moving_pressure(X[i], place[i])));
  return errors;
}

MotionErrors motion_errors_of_collocation(const ManufacturedMotion& truth, int elements, int degree) {
  namespace hp = reference::hp;
  const auto steady = collocation_of(truth.steady(), elements, degree);
  if (!steady) return {};
  const hp::Harmonic harmonic(truth.steady().problem(), *steady);
  const auto& equations = *steady->equations;
  const auto& rows = steady->run.at.X;
  const int n = equations.intervals(), exit_row = equations.row_of_right_end(elements - 1);
  ArrayOf<Amplitude> feature(rows.size());
  for (Eigen::Index r = 0; r < rows.size(); ++r) feature[r] = truth.feature(rows[r]);
  hp::ComplexVector balance(n + 1);
  for (int i = 0; i < n; ++i) balance[i] = truth.balance_source(rows[i]);
  balance[n] = truth.balance_source(rows[exit_row]);
  const hp::ComplexVector u =
      harmonic.of_sources(truth.choice().Omega, {.feature = feature, .balance = balance, .load = truth.load()});
  MotionErrors errors{.pressure = 0,
                      .offset = std::abs(harmonic.offset(u) - truth.choice().offset),
                      .exit = std::abs(u[n + 2] - truth.exit())};
  VectorOf<double> real = VectorOf<double>::Zero(n + 1), imaginary = real;
  real.head(n) = u.head(n).real();
  imaginary.head(n) = u.head(n).imag();
  const double exit = steady->run.state.exit;
  for (int e = 0; e < elements; ++e) {
    for (int k = 0; k <= 20; ++k) {
      const double t = k / 10.0 - 1;
      const hp::Place<double> place{e, 1 + t, 1 - t};
      const double X = exit + equations.stretching(exit) * equations.xi(place);
      const Amplitude P(equations.interpolate(real, e, t), equations.interpolate(imaginary, e, t));
      errors.pressure =
          worse(errors.pressure, std::abs(P - truth.moving_pressure(X, equations.coordinate_by_exit(place))));
    }
  }
  return errors;
}

}  // namespace ehd::verification
