// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/homotopy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace ehd::reference::hp {

namespace {

/// |a_p| + |a_(p-1)| of the polynomial through nodal values.
double tail_of(const ReferenceElement<double>& shape, const VectorOf<double>& nodes) {
  const VectorOf<double> a = shape.to_legendre.bottomRows(2) * nodes;
  return a.cwiseAbs().sum();
}

/// What the last coefficients of the pressure do to the film nearby: (r/pi) |a_k m_k|, m_k about 2/p^2.
double film_error_of_tail(double tail, double half_length, int degree, double film) {
  return half_length * tail / (degree * degree * film);
}

}  // namespace

std::vector<double> excess_of(const Collocation<double>& equations, const NewtonRun& run, const Problem& problem,
                              const Resolution& resolution) {
  const Mesh& mesh = equations.mesh();
  const auto& at = run.at;
  const double s = equations.stretching(run.state.exit), film = run.state.flux;
  const double alpha = std::max(1.0, ambient_slope(problem.viscosity));
  std::vector<double> excess(static_cast<std::size_t>(mesh.elements()));
  for (int e = 0; e < mesh.elements(); ++e) {
    const auto& shape = equations.reference(e);
    const double half = equations.half_length(e) * s;
    const double tail = tail_of(shape, run.state.P.segment(equations.first_node(e), shape.degree + 1));
    const Eigen::Index right = equations.row_of_right_end(e);
    const double defect = std::abs(at.balance[right]) / (film + at.H[right]);
    // A defect of the flux over half a length is an error of int e^(-alpha P) dP, compared with 1/alpha.
    const double inlet_error =
        half * std::abs(at.balance[right]) * problem.groups.lambda / std::pow(at.H[right], 3) * alpha;
    excess[static_cast<std::size_t>(e)] =
        std::max({film_error_of_tail(tail, half, shape.degree, film) / resolution.film, inlet_error / resolution.film,
                  tail / resolution.spike, defect / resolution.defect});
  }
  return excess;
}

std::optional<Resolved> resolved_at(const Problem& problem, const Resolved& from, double floor,
                                    const Resolution& resolution, const NewtonLimits& newton_limits,
                                    const HomotopyLimits& limits, Meter& meter) {
  static const bool trace = std::getenv("HP_TRACE");
  constexpr int most_passes = 40;
  auto equations = from.equations;
  State<double> start = from.run.state;
  double last_excess = 1e300;
  for (int pass = 0; pass < most_passes; ++pass) {
    NewtonRun run = newton(*equations, start, floor, newton_limits, meter);
    if (!run.solved) {
      if (trace) std::printf("   floor %.2e pass %d n %d newton failed, its %d res %.2e\n", floor, pass, equations->intervals(), run.iterations, run.residual);
      return std::nullopt;
    }
    const auto excess = excess_of(*equations, run, problem, resolution);
    const double worst = *std::max_element(excess.begin(), excess.end());
    if (trace) std::printf("   floor %.2e pass %d n %d its %d res %.1e worst %.2e C %.12g H0 %.12g X* %.12g err %.1e\n", floor, pass, equations->intervals(), run.iterations, run.residual, worst, run.state.flux, run.state.offset, run.state.exit, run.iteration_error);
    const auto& mesh = equations->mesh();
    const double s = equations->stretching(run.state.exit);
    const auto mergeable = [&](int e) {
      const auto at = static_cast<std::size_t>(e);
      const double left = mesh.breakpoints[at], middle = mesh.breakpoints[at + 1], right = mesh.breakpoints[at + 2];
      const double ratio = (middle - left) / (right - middle);
      if (pass > 1 || ratio > 4.5 || ratio < 1 / 4.5) return false;  // later a merge could undo a split, for ever
      if (excess[at] > 0.05 || excess[at + 1] > 0.05) return false;
      const auto& shape = equations->reference(e);
      if (shape.degree != mesh.degrees[at + 1]) return false;
      VectorOf<double> nodes(shape.degree + 1);
      for (int j = 0; j <= shape.degree; ++j) {
        const double x = 0.5 * (right - left) * (1 + shape.nodes[j]);  // from left
        const bool first = x <= middle - left;
        const double half = first ? (middle - left) / 2 : (right - middle) / 2;
        const double t = (first ? x : x - (middle - left)) / half - 1;
        nodes[j] = equations->interpolate(run.state.P, first ? e : e + 1, std::clamp(t, -1.0, 1.0));
      }
      const double tail = tail_of(shape, nodes);
      return tail < 0.1 * resolution.spike &&
             film_error_of_tail(tail, (right - left) / 2 * s, shape.degree, run.state.flux) < 0.1 * resolution.film;
    };
    Mesh next = adapted(mesh, excess, mergeable, limits.shortest_element);
    const bool same = next.breakpoints == mesh.breakpoints;
    const bool enough = worst <= 1 || same || next.intervals() > limits.largest_intervals;
    last_excess = worst;
    if (enough) return Resolved{.equations = equations, .run = std::move(run), .floor = floor, .excess = worst};
    auto fresh = std::make_shared<const Collocation<double>>(problem, std::move(next), equations->points());
    start = transferred(*equations, run.state, *fresh);
    equations = std::move(fresh);
  }
  (void)last_excess;
  return std::nullopt;
}

}  // namespace ehd::reference::hp
