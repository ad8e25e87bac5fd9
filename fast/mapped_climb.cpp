// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/mapped_climb.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/observables.hpp"
#include "fast/judgement.hpp"
#include "fast/mapped.hpp"
#include "fast/prolongation.hpp"

namespace ehd::fast {

namespace {

/// A given number of intervals is halved down to this or more, for the extrapolation.
constexpr int fewest_halved = 64;
/// Iteration also stops where a step's estimate of the film error on each grid is below this share of the tolerance.
/// Extrapolation multiplies these errors by 45/21 at most.
constexpr double film_share = 1.0 / 60, extrapolation_gain = 45.0 / 21;
/// The residual must be below a tenth of the tolerance as well, because a single step's contraction says little about
/// the films. Of 150 contacts the most that iteration left in a film is .024 of a tolerance of 1e-5 and .46 of 1e-6;
/// with the tolerance itself in place of its tenth .12 and 3.6.
constexpr double residual_part = 10;
/// Request::iteration_share is a share of the next grid's error, which is expected to be a 40th of the error known so
/// far. Errors fall by 8 or more from grid to grid, and stated errors are some times the true ones. With a fifth in
/// place of the 40th, the iteration moved H_cen of (20, 10) on 1024 intervals by 30 % of its error. On the first two
/// grids the known error is taken to be known_at_first.
constexpr double next_part = 40, known_at_first = 1e-4;

/// A map made with the least care may miss the place of a narrow spike. So from this number of intervals on the climb
/// ends where the error of H_cen falls by less than `good_fall` from one grid to the next: better maps from that
/// solution cost less than finer grids. H_cen alone to 1e-6 at (5000, 15), (2000, 15) and (1000, 15) took 22, 14 and 10
/// ms, now 9, 7 and 7.
constexpr int judged_with_least_care = 2048;
constexpr double good_fall = 4;

class Climber {
 public:
  Climber(Run& run, const Request& request) : run_(run), request_(request) {}

  MappedClimb operator()(const Recipe& recipe, const Solution* from, Care care) {
    const std::optional<Known> known = start(run_, recipe, from, care);
    if (!known) return std::move(climb_);
    climb_.fit = map_fit(recipe, care);
    double film = known->film;
    const int fineness = recipe.fineness;
    const GridPlan plan =
        request_.nodes ? GridPlan::down_from(*request_.nodes, [&](int n) { return n >= 2 * fineness * fewest_halved; })
                       : GridPlan::doubling(fineness * first_mapped_nodes, Mapped::largest_nodes);
    for (std::optional<int> n = plan.first; n && !met(climb_, request_); n = plan.after(*n)) {
      const Target wanted = target();
      const long newton_before = run_.counters.newton;
      if (run_.state.P.size() != *n + 1) run_.state = first_iterate_on(*n, *known);
      const Attempt attempt = solve_on(run_, film, wanted);
      if (!attempt.succeeded) return std::move(climb_);
      film = film_now(run_);
      prolongation_.note(run_.state);
      const double error_before = climb_.film_central.total();
      note(*n, attempt.newton, newton_before, wanted);
      const bool judged = care == Care::least && !request_.nodes && *n >= judged_with_least_care;
      if (judged && climb_.film_central.total() * good_fall > error_before) break;
    }
    climb_.complete = true;
    return std::move(climb_);
  }

 private:
  /// Newton's target on the next grid.
  [[nodiscard]] Target target() const {
    const auto within = [](double relative) {
      return Target{.residual = relative * iteration_share,
                    .film_error = relative * film_share,
                    .film_residual = relative / residual_part,
                    .flux_variation = relative};
    };
    if (is_cut_near_the_contact(run_.problem)) return {.residual = round_off_residual};
    if (!request_.nodes) return within(request_.tolerance.tightest());
    if (!request_.iteration_share) return everywhere(run_.residual_on_given_grids);
    const double known = climb_.grids.size() > 1
                             ? std::min(climb_.film_minimum.discretisation, climb_.film_central.discretisation)
                             : known_at_first;
    return within(*request_.iteration_share * known / next_part);
  }

  /// The first iterate comes from the last grid. On the first grid, and where the map was made from a solution on as
  /// fine a grid, it comes from that solution, which is nearer. At 40 contacts, 512 intervals, it saves a tenth of all
  /// Newton steps.
  [[nodiscard]] State first_iterate_on(int n, const Known& known) {
    if (climb_.grids.empty() || known.X.size() > n) return on_present_map(run_, known, run_.state.tail, n);
    return prolongation_.onto(n, run_.workspace.grids, run_.setting.inlet);
  }

  /// The solution of a grid, with what is known of its errors.
  void note(int n, const NewtonResult& newton, long newton_before, const Target& target) {
    if (!climb_.grids.empty()) climb_.beside = {pressure_alone(climb_.fields)};
    climb_.fields = fields_of(run_);
    climb_.states.push_back(run_.state);
    const Array& X = climb_.fields.X;
    GridRecord grid{.nodes = n,
                    .newton_iterations = static_cast<int>(run_.counters.newton - newton_before),
                    .residual = newton.residual,
                    .observed = observe(climb_.fields, run_.observed)};
    const Lengths l = lengths_from_film(grid.observed.at(Quantity::film_minimum).value);
    const auto edge = std::lower_bound(X.begin(), X.end(), -l.scale) - X.begin();
    const auto right = std::clamp<Eigen::Index>(edge, 1, n);
    grid.inlet_cells = l.inlet / (X[right] - X[right - 1]);
    climb_.grids.push_back(std::move(grid));
    const double left_in_films = std::max(newton.film_error, target.film_error) * extrapolation_gain;
    const double left =
        request_.nodes ? newton.residual : std::min(std::max(newton.residual, target.residual), left_in_films);
    climb_.left.push_back(left);
    climb_.film_minimum = film_budget(climb_, Quantity::film_minimum, run_);
    climb_.film_central = film_budget(climb_, Quantity::film_central, run_);
  }

  Run& run_;
  const Request& request_;
  Prolongation prolongation_;
  MappedClimb climb_;
};

}  // namespace

MappedClimb climb_mapped(Run& run, const Request& request, const Recipe& recipe, const Solution* from, Care care) {
  return Climber(run, request)(recipe, from, care);
}

bool met(const MappedClimb& climb, const Request& request) {
  return !request.nodes && !climb.grids.empty() && request.tolerance.met_by(climb.film_minimum, climb.film_central);
}

}  // namespace ehd::fast
