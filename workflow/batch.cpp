// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/batch.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "workflow/parallel.hpp"

namespace ehd {

namespace {

// Bits, not values: -0 is not 0 here, and a NaN equals itself.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

bool same(const Array& a, const Array& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return same(x, y); });
}

bool same(const Observables& a, const Observables& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.first == other.first && same(one.second.value, other.second.value) &&
           same(one.second.place, other.second.place) && same(one.second.error, other.second.error);
  });
}

bool same(const Fields& a, const Fields& b) {
  return same(a.X, b.X) && same(a.P, b.P) && same(a.H, b.H) && same(a.density, b.density) &&
         same(a.log_viscosity, b.log_viscosity) && same(a.flux, b.flux) && same(a.offset, b.offset) &&
         a.elements == b.elements && same(a.weights, b.weights) && same(a.load_beyond_inlet, b.load_beyond_inlet) &&
         same(a.work_beyond_inlet, b.work_beyond_inlet);
}

bool same(const ErrorBudget& a, const ErrorBudget& b) {
  return same(a.discretisation, b.discretisation) && same(a.iteration, b.iteration) && same(a.truncation, b.truncation);
}

bool same(const GridRecord& a, const GridRecord& b) {
  return a.nodes == b.nodes && a.newton_iterations == b.newton_iterations && same(a.residual, b.residual) &&
         same(a.inlet_cells, b.inlet_cells) && same(a.observed, b.observed);
}

bool same_counts(const Cost& a, const Cost& b) {
  return same(a.work_units, b.work_units) && a.convolutions == b.convolutions &&
         a.newton_iterations == b.newton_iterations && a.krylov_iterations == b.krylov_iterations &&
         a.nodes == b.nodes && a.levels == b.levels && a.viscosity_points == b.viscosity_points &&
         a.density_points == b.density_points && a.fft_plans == b.fft_plans;
}

}  // namespace

std::vector<Solution> solve_all(const RegisteredSolver& solver, const std::vector<Problem>& problems,
                                const Request& request, unsigned threads) {
  std::vector<Solution> solutions(problems.size());
  in_threads(problems.size(), threads, [&](std::size_t i) { solutions[i] = solver.solve(problems[i], request); });
  return solutions;
}

bool identical(const Solution& one, const Solution& other) {
  const SolveRecord &a = one.record, &b = other.record;
  return same(one.fields, other.fields) && same(one.observables, other.observables) && a.status == b.status &&
         a.reason == b.reason && a.notes == b.notes && same(a.film_minimum, b.film_minimum) &&
         same(a.film_central, b.film_central) && same_counts(a.cost, b.cost) &&
         std::equal(a.grids.begin(), a.grids.end(), b.grids.begin(), b.grids.end(),
                    [](const GridRecord& x, const GridRecord& y) { return same(x, y); });
}

}  // namespace ehd
