// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the kernels of fast/, by Google Benchmark. The counter `convolutions` is the time of one call over that of
// one bare FFT convolution on as many intervals, measured right after.
#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>
#include <stdexcept>

#include "fast/convolution.hpp"
#include "fast/discretisation.hpp"
#include "fast/jacobian.hpp"
#include "fast/map.hpp"
#include "fast/multigrid.hpp"
#include "fast/start.hpp"
#include "verification/bench/cost_scaling.hpp"
#include "verification/studies/box.hpp"

namespace {

using namespace ehd;
using namespace ehd::fast;

/// A moderate contact, (20, 10), at the first iterate: every field has its usual size.
struct Iterate {
  explicit Iterate(int intervals) : grid(grids.of(intervals)) {
    const Problem problem = verification::problem_at({20, 10}, true, TruncatedAt{-4});
    setting = {.groups = problem.groups, .viscosity = problem.viscosity, .density = problem.density, .inlet = -4};
    const Lengths lengths = expected_lengths(problem.groups);
    state = first_iterate(setting, likely_shape(lengths.film), lengths.film, grid);
    if (!scheme.evaluate(setting, state, grid, counters)) throw std::logic_error("the first iterate has no film");
    jacobian.linearise(setting, scheme.nodes, state.P, state.exit);
  }
  Grids grids;
  Grid& grid;
  Setting setting;
  State state;
  Counters counters;
  Discretisation scheme;
  Jacobian jacobian;
};

/// CPU time of this thread, which other processes on the machine do not change.
double cpu_s() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  constexpr double nano = 1e-9;
  return static_cast<double>(now.tv_sec) + nano * static_cast<double>(now.tv_nsec);
}

template <class Work>
void timed(benchmark::State& run, const Work& work) {
  const double begin = cpu_s();
  for ([[maybe_unused]] auto again : run) work();
  const double seconds = cpu_s() - begin;
  const auto n = static_cast<int>(run.range(0));
  run.counters["convolutions"] =
      seconds / static_cast<double>(run.iterations()) / verification::convolution_s(n, verification::Repetition{});
}

void convolution(benchmark::State& run) {
  const auto n = static_cast<int>(run.range(0));
  Convolution kernel(n);
  const Array x = Array::LinSpaced(n + 1, -1, 1).square();
  Array y;
  timed(run, [&] { kernel.apply(x, y); });
}

/// A map for the same contact.
MapShape usual_shape() {
  return {.inlet = -4, .exit = 1.07, .scale = 1, .inlet_width = 0.19, .spike = 0.9, .spike_width = 0.1};
}

void mapped_product(benchmark::State& run) {
  Grids grids;
  grids.use(std::make_shared<const Map>(usual_shape()));
  Grid& grid = grids.of(static_cast<int>(run.range(0)));
  const Array P = Array::LinSpaced(grid.n + 1, -1, 1).square();
  Array y;
  double integral = 0;
  timed(run, [&] { grid.product(P, y, integral); });
}

void mapped_nodes(benchmark::State& run) {
  const Map map(usual_shape());
  timed(run, [&] { benchmark::DoNotOptimize(map.nodes(static_cast<int>(run.range(0)))); });
}

void residual(benchmark::State& run) {
  Iterate at(static_cast<int>(run.range(0)));
  timed(run, [&] { benchmark::DoNotOptimize(at.scheme.evaluate(at.setting, at.state, at.grid, at.counters)); });
}

void linearise(benchmark::State& run) {
  Iterate at(static_cast<int>(run.range(0)));
  timed(run, [&] { at.jacobian.linearise(at.setting, at.scheme.nodes, at.state.P, at.state.exit); });
}

void jacobian_product(benchmark::State& run) {
  Iterate at(static_cast<int>(run.range(0)));
  Step step{.P = at.state.P, .offset = 0.1, .exit = 0.1};
  timed(run, [&] { benchmark::DoNotOptimize(at.jacobian.apply(step, at.counters).load); });
}

/// Both kernels work on a fresh copy, and its copying counts: repeated solves of one vector would end in denormals.
Banded diagonal_band(int n) {
  Banded band;
  band.resize(n);
  for (int i = 0; i < n; ++i) band.row(i) = {0.1, -0.4, 0.2, 3, -0.5, 0.3};
  return band;
}

void band_factorise(benchmark::State& run) {
  const Banded band = diagonal_band(static_cast<int>(run.range(0)));
  Banded copy = band;
  timed(run, [&] {
    copy = band;
    benchmark::DoNotOptimize(copy.factorise());
  });
}

void band_solve(benchmark::State& run) {
  const auto n = static_cast<int>(run.range(0));
  Banded band = diagonal_band(n);
  if (!band.factorise()) throw std::logic_error("a diagonally dominant band has no factors");
  const Array right_side = Array::LinSpaced(n, 1, 2);
  Array x = right_side;
  timed(run, [&] {
    x = right_side;
    band.solve(x);
  });
}

void multigrid_prepare(benchmark::State& run) {
  Iterate at(static_cast<int>(run.range(0)));
  Multigrid multigrid;
  timed(run, [&] {
    benchmark::DoNotOptimize(
        multigrid.prepare(at.setting, at.scheme.nodes, at.jacobian, at.state, at.grids, at.counters));
  });
}

void multigrid_cycle(benchmark::State& run) {
  Iterate at(static_cast<int>(run.range(0)));
  Multigrid multigrid;
  if (!multigrid.prepare(at.setting, at.scheme.nodes, at.jacobian, at.state, at.grids, at.counters))
    throw std::logic_error("the coarsest matrix is singular");
  Step step;
  timed(run, [&] { multigrid.cycle(at.scheme.error, step, at.counters); });
}

void sizes(benchmark::internal::Benchmark* kernel) {
  kernel->RangeMultiplier(4)->Range(1 << 8, 1 << 16)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(convolution)->Apply(sizes);
BENCHMARK(mapped_product)->Apply(sizes);
BENCHMARK(mapped_nodes)->Apply(sizes);
BENCHMARK(residual)->Apply(sizes);
BENCHMARK(linearise)->Apply(sizes);
BENCHMARK(jacobian_product)->Apply(sizes);
BENCHMARK(band_factorise)->Apply(sizes);
BENCHMARK(band_solve)->Apply(sizes);
BENCHMARK(multigrid_prepare)->Apply(sizes);
BENCHMARK(multigrid_cycle)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
