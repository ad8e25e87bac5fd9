// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/homotopy.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "contact/observables.hpp"
#include "reference/hp/steep_layer.hpp"

namespace ehd::reference::hp {

namespace {

/// Solves and adaptations of one mesh at one floor.
constexpr int most_passes = 40;
/// Elements are merged up to this pass.
constexpr int last_merging_pass = 1;
/// Two elements are merged whose lengths differ by no more than this ratio, whose excess is below the second number,
/// and whose common polynomial has a tail below the third, each over its allowed value.
constexpr double largest_merged_ratio = 4.5, merged_excess = 0.05, merged_tail = 0.1;
/// Below this floor nothing changes: it is less than the rounding of 1/eta anywhere that matters.
constexpr double lowest_floor = 1e-18;
/// The factor by which the floor falls: at first, at most, and where the descent gives up.
constexpr double first_factor = 10, largest_factor = 1e6, smallest_factor = 1.2;
/// Each step that succeeds multiplies the factor by this, as long as no step has failed.
constexpr double factor_growth = 10;
/// A step that fails takes the square root of the factor. Each step that succeeds after it raises the factor to this
/// power. A failure costs as much as four successes, so that the factor must grow slowly.
constexpr double power_after_a_failure = 1.25;
/// The path of the steep layer goes through its last three places, or its last two. Each step that fails changes from
/// one to the other. With two places the power is that of Barus oil.
constexpr std::ptrdiff_t most_followed = 3, fewest_followed = 2;
/// Rounding of a balance in units of the machine's epsilon and of its terms.
constexpr double rounding_units = 10;

/// |a_p| + |a_(p-1)| of the polynomial through nodal values.
double tail_of(const ReferenceElement<double>& shape, const VectorOf<double>& nodes) {
  const VectorOf<double> a = shape.to_legendre.bottomRows(2) * nodes;
  return a.cwiseAbs().sum();
}

/// Relative change of the film near the element by the last coefficients of the pressure: (r/pi) |a_k m_k|/H, m_k about
/// 2/p^2. The factor 2/pi is left out.
double film_error_of_tail(double tail, double half_length, int degree, double film) {
  return half_length * tail / (degree * degree * film);
}

/// Rounding of the balance, which no mesh can lower: H is a difference of terms of size 1 + X^2/2, and P' is a
/// difference of pressures over a length.
double rounding_of_balance(const Evaluation<double>& at, Eigen::Index row, double half) {
  const double X = at.X[row],
               through_film = std::abs(3 * at.mobility[row] * at.slope[row] / at.H[row] - at.density.value[row]);
  return rounding_units * std::numeric_limits<double>::epsilon() *
         ((1 + X * X / 2) * through_film + at.mobility[row] * std::abs(at.P[row]) / half);
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
    const double unbalanced = std::max(0.0, std::abs(at.balance[right]) - rounding_of_balance(at, right, half));
    const double defect = unbalanced / (film + at.H[right]);
    // A defect of the flux over half a length is an error of int e^(-alpha P) dP, compared with 1/alpha.
    const double inlet_error = half * unbalanced * problem.groups.lambda / std::pow(at.H[right], 3) * alpha;
    excess[static_cast<std::size_t>(e)] =
        std::max({film_error_of_tail(tail, half, shape.degree, film) / resolution.film, inlet_error / resolution.film,
                  tail / resolution.spike, defect / resolution.defect});
  }
  return excess;
}

namespace {

/// The solution on the elements e and e + 1 as one polynomial on both, at the nodes of `shape`.
VectorOf<double> on_one_element(const Collocation<double>& equations, const NewtonRun& run,
                                const ReferenceElement<double>& shape, int e) {
  const auto& breakpoints = equations.mesh().breakpoints;
  const auto at = static_cast<std::size_t>(e);
  const double left = breakpoints[at], middle = breakpoints[at + 1], right = breakpoints[at + 2];
  VectorOf<double> nodes(shape.degree + 1);
  for (int j = 0; j <= shape.degree; ++j) {
    const double x = 0.5 * (right - left) * (1 + shape.nodes[j]);  // from left
    const bool first = x <= middle - left;
    const double half = first ? (middle - left) / 2 : (right - middle) / 2;
    const double t = (first ? x : x - (middle - left)) / half - 1;
    nodes[j] = equations.interpolate(run.state.P, first ? e : e + 1, std::clamp(t, -1.0, 1.0));
  }
  return nodes;
}

/// The elements e and e + 1 can be merged: of like length and degree, far below what is allowed, and one polynomial
/// represents the pressure on both.
bool one_polynomial_does(const Collocation<double>& equations, const NewtonRun& run, const std::vector<double>& excess,
                         const Resolution& resolution, int e) {
  const Mesh& mesh = equations.mesh();
  const auto at = static_cast<std::size_t>(e);
  const double left = mesh.breakpoints[at], middle = mesh.breakpoints[at + 1], right = mesh.breakpoints[at + 2];
  const double ratio = (middle - left) / (right - middle);
  if (ratio > largest_merged_ratio || ratio < 1 / largest_merged_ratio) return false;
  if (excess[at] > merged_excess || excess[at + 1] > merged_excess) return false;
  const auto& shape = equations.reference(e);
  if (shape.degree != mesh.degrees[at + 1]) return false;
  const double s = equations.stretching(run.state.exit);
  const double tail = tail_of(shape, on_one_element(equations, run, shape, e));
  return tail < merged_tail * resolution.spike &&
         film_error_of_tail(tail, (right - left) / 2 * s, shape.degree, run.state.flux) < merged_tail * resolution.film;
}

}  // namespace

std::optional<Resolved> resolved(const Problem& problem, const Resolved& from, const Resolution& resolution,
                                 const HomotopyLimits& limits, Meter& meter) {
  const double floor = from.floor;
  auto equations = from.equations;
  State<double> start = from.run.state;
  std::optional<Resolved> unmerged;  // the last state before neighbours were merged
  bool may_merge = true;
  for (int pass = 0; pass < most_passes; ++pass) {
    NewtonRun run = newton(*equations, start, floor, limits.newton, meter);
    if (!run.solved) {
      if (!unmerged) return std::nullopt;
      // The merged mesh is too coarse for Newton's method: back to the one before, where only splits follow.
      may_merge = false;
      equations = unmerged->equations;
      run = unmerged->run;
      unmerged.reset();
    }
    const auto excess = excess_of(*equations, run, problem, resolution);
    const double worst = *std::max_element(excess.begin(), excess.end());
    const auto& mesh = equations->mesh();
    const auto mergeable = [&](int e) {  // later passes do not merge: a merge could undo a split, without end
      return may_merge && pass <= last_merging_pass && one_polynomial_does(*equations, run, excess, resolution, e);
    };
    Mesh next = adapted(mesh, excess, mergeable, limits.shortest_element);
    const bool same = next.breakpoints == mesh.breakpoints;
    const bool enough = worst <= 1 || same || next.intervals() > limits.largest_intervals;
    if (enough) return Resolved{.equations = equations, .run = std::move(run), .floor = floor, .excess = worst};
    auto fresh = std::make_shared<const Collocation<double>>(problem, std::move(next), equations->points());
    if (pass <= last_merging_pass && may_merge)
      unmerged = Resolved{.equations = equations, .run = run, .floor = floor, .excess = worst};
    else
      unmerged.reset();
    start = transferred(*equations, run.state, *fresh);
    equations = std::move(fresh);
  }
  return std::nullopt;
}

namespace {

/// Where the search at the next floor begins: the last solution, on a mesh that follows the steep layer where it can.
Resolved lowered(const Problem& problem, const Resolved& last, const std::optional<LayerPath>& path, double factor,
                 double shortest) {
  const double floor = last.floor / factor < lowest_floor ? 0 : last.floor / factor;
  if (floor > 0 && path) {
    if (auto start = followed(problem, last, *path, floor, shortest)) return std::move(*start);
  }
  Resolved start = last;
  start.floor = floor;
  return start;
}

/// The layer at `top` and at up to two of the floors above it, floors falling.
std::vector<SteepPlace> places_down_to(const Resolved& top, const std::vector<Resolved>& above) {
  std::vector<SteepPlace> places{steep_place(top)};
  for (auto at = above.rbegin(); at != above.rend() && places.size() < 3; ++at)
    if (at->floor > places.front().floor) places.insert(places.begin(), steep_place(*at));
  return places;
}

bool films_are_settled(const Problem& problem, const std::vector<Resolved>& floors, double settled) {
  return floor_gap(floors) < settled && !is_at_centre(places_apart(floors)) &&
         !(central_gap(problem, floors) > settled);
}

}  // namespace

std::vector<Resolved> descent(const Problem& problem, const Resolved& top, const Resolution& resolution,
                              const HomotopyLimits& limits, Meter& meter, const std::vector<Resolved>& above) {
  std::vector<Resolved> floors{top};
  std::vector<SteepPlace> places = places_down_to(top, above);
  double factor = first_factor;
  bool has_failed = false;
  std::ptrdiff_t followed = most_followed;
  while (floors.back().floor > 0 && !meter.spent()) {
    const auto path = path_of({places.end() - std::min(followed, std::ssize(places)), places.end()});
    const Resolved start = lowered(problem, floors.back(), path, factor, limits.shortest_element);
    if (auto solved = resolved(problem, start, resolution, limits, meter)) {
      floors.push_back(std::move(*solved));
      places.push_back(steep_place(floors.back()));
      factor = std::min(has_failed ? std::pow(factor, power_after_a_failure) : factor_growth * factor, largest_factor);
      continue;
    }
    has_failed = true;
    followed = followed == most_followed ? fewest_followed : most_followed;
    factor = std::sqrt(factor);
    if (factor < smallest_factor || films_are_settled(problem, floors, limits.settled)) break;
  }
  return floors;
}

std::vector<std::size_t> floors_apart(const std::vector<Resolved>& floors) {
  std::vector<std::size_t> found{floors.size() - 1};
  for (std::size_t i = floors.size(); i-- > 0;)
    if (floors[i].floor > 0 && floors[i].floor >= floor_ratio * floors[found.back()].floor) found.push_back(i);
  return found;
}

namespace {

/// Relative change of a value that is left between the last floor and floor 0, if it is linear in a small floor.
double gap_of(const std::vector<Resolved>& floors, const std::function<double(const Resolved&)>& value) {
  const Resolved& last = floors.back();
  if (last.floor == 0) return 0;
  const auto apart = floors_apart(floors);
  if (apart.size() < 2) return std::numeric_limits<double>::infinity();
  const Resolved& before = floors[apart[1]];
  return std::abs(value(last) / value(before) - 1) * last.floor / (before.floor - last.floor);
}

}  // namespace

double floor_gap(const std::vector<Resolved>& floors) {
  return gap_of(floors, [](const Resolved& solved) { return solved.run.state.flux; });
}

double central_gap(const Problem& problem, const std::vector<Resolved>& floors) {
  return gap_of(floors, [&](const Resolved& solved) {
    const auto central = observed::film_central(fields_of(problem, solved));
    return central ? central->value : std::numeric_limits<double>::quiet_NaN();
  });
}

Fields fields_of(const Problem& problem, const Resolved& resolved) {
  const auto& equations = *resolved.equations;
  const auto& state = resolved.run.state;
  const auto places = equations.node_places();
  Fields fields;
  fields.X = equations.node_coordinates(state.exit);
  fields.P = state.P.array();
  fields.H = equations.film(state, places, equations.kernel_rows(places));
  fields.density = evaluate(problem.density, fields.P).value;
  fields.log_viscosity = evaluate(problem.viscosity, fields.P).value;
  fields.flux = state.flux - resolved.run.at.balance.head(equations.intervals());
  fields.offset = state.offset;
  for (int e = 0; e < equations.mesh().elements(); ++e) fields.elements.push_back(equations.first_node(e));
  fields.elements.push_back(equations.intervals());
  if (std::holds_alternative<Flooded>(problem.inlet)) {
    const double x = -equations.mesh().inlet, A = fields.H[0] - x * x / 2;
    fields.load_beyond_inlet = resolved.run.at.tail_load;
    // Int H P' dX with P' = lambda (H - C)/H^3, H = X^2/2 + A.
    fields.work_beyond_inlet = problem.groups.lambda * (2 / x - 4 * (A + state.flux) / (3 * x * x * x));
  }
  return fields;
}

Resolved moved_to(const Problem& problem, const Resolved& from, Mesh mesh, Points points) {
  Resolved to{.equations = std::make_shared<const Collocation<double>>(problem, std::move(mesh), points),
              .run = {},
              .floor = from.floor};
  to.run.state = transferred(*from.equations, from.run.state, *to.equations);
  return to;
}

}  // namespace ehd::reference::hp
