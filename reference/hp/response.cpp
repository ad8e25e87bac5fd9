// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/text.hpp"
#include "reference/hp/discretiser.hpp"
#include "reference/hp/harmonic.hpp"

namespace ehd::reference::hp {

namespace {

using Clock = std::chrono::steady_clock;

/// The steady state is solved to the first part of the tolerance. Where slow motion is then not known well enough, it
/// is solved to the second part.
constexpr double steady_parts[] = {1e-2, 1e-4};
/// It is never solved to less than this.
constexpr double finest_steady = 1e-13;
/// No second steady state is solved to less than this. There Newton's method fails before the descent is deep enough:
/// at (5, 14) and (100, 14), Barus, asked for 1e-8, the second steady state was no better and took twice the time.
constexpr double finest_again = 1e-11;
/// What the steady meshes resolve, as in high_order.cpp.
constexpr double pressure_resolution = 1e-3, flux_resolution = 1e-2;
/// Error over difference of the two discretisations; error_report.cpp says where the number comes from.
constexpr double safety = 5;
/// Error over the move from the last floor of the fluidity to floor 0, which no third floor confirms.
constexpr double floor_safety_of_response = 2;
/// The error that one element may make in the film's amplitude, over the tolerance, in each attempt. The indicator is
/// 10 to 1e4 times larger than the true error.
constexpr double allowed_parts[] = {100, 1, 0.01};
/// A refinement that leaves more than this part of the error is the last one: something else than the mesh limits it.
constexpr double hopeless = 0.7;
/// A mesh with more intervals is not refined further: one frequency on it costs seconds.
constexpr int most_intervals = 2000;
constexpr int most_refinements = 20;
constexpr double shortest_element = 4e-15;  // in xi, as in HomotopyLimits
constexpr NewtonLimits refined_newton{.iterations = 20, .step = 1e-9};

/// A number as both discretisations have it.
struct Twice {
  Complex first, second;
};

Complex kappa_of(const Harmonic& harmonic, double Omega) { return -1.0 / harmonic.offset(harmonic.of_load(Omega)); }

std::optional<DiscretisedTwice> discretised_twice(Discretiser& discretiser, const std::vector<Resolved>& floors,
                                                  double working) {
  const Resolution resolution{.film = std::max(working, discretiser.expected_rounding()),
                              .spike = pressure_resolution,
                              .defect = flux_resolution};
  return discretiser.discretised_twice(floors, fine_scheme, resolution, working);
}

std::optional<DiscretisedTwice> from_the_top(Discretiser& discretiser, double working) {
  const auto top = discretiser.start();
  if (!top) return std::nullopt;
  return discretised_twice(discretiser, discretiser.coarse_descent(*top, working), working);
}

class ResponseSolve {
 public:
  ResponseSolve(const Problem& problem, const ResponseRequest& request)
      : problem_(problem), request_(request), meter_(meter_of(request.max_iterations, request.time_limit_s, begin_)) {}

  [[nodiscard]] Response solve();

 private:
  struct Judged {
    Complex value;
    double error = std::numeric_limits<double>::infinity();
    StopReason status = StopReason::diverged;
  };

  /// The steady state on its meshes as they are now.
  struct Steady {
    std::vector<Harmonic> both;  ///< the two discretisations
    /// The first one at the next floor that is at least three times its last; absent where the last is 0.
    std::optional<Harmonic> higher_floor = {};
    std::vector<Resolved> floors;  ///< of the first one
    double rounding = 0;
  };

  /// The steady state to this error, from the floors of the one before; false where none is found.
  [[nodiscard]] bool find_steady(double working);
  /// Slow motion about the steady state; of two steady states, by the one that gives smaller errors. Empty where no
  /// steady state is found.
  void fill(Cost& cost) const;
  [[nodiscard]] std::optional<SlowStiffness> find_slow();
  /// Refines all meshes until `excess` is at most 1 everywhere; false where they cannot.
  template <class Excess>
  [[nodiscard]] bool refine(const Excess& excess);
  [[nodiscard]] Judged judged(const Twice& values, double floor_error) const;
  template <class Value>
  [[nodiscard]] double floor_error(const Value& value) const;
  template <class Value, class Excess>
  [[nodiscard]] Judged certified(const Value& value, const Excess& excess);
  [[nodiscard]] Stiffness stiffness(double Omega);
  [[nodiscard]] Judged wavy_film(const Waviness& waviness);
  [[nodiscard]] SlowStiffness slow();

  const Problem& problem_;
  const ResponseRequest& request_;
  Clock::time_point begin_ = Clock::now();
  Meter meter_;
  Steady steady_;
};

bool ResponseSolve::find_steady(double working) {
  Discretiser discretiser(problem_, meter_);
  const auto found = steady_.floors.empty() ? from_the_top(discretiser, working)
                                            : discretised_twice(discretiser, steady_.floors, working);
  meter_ = discretiser.meter();
  if (!found) return false;
  const auto& [first, second] = *found;
  steady_ = {.both = {Harmonic(problem_, first.last()), Harmonic(problem_, second.last())},
             .floors = first.floors,
             .rounding = discretiser.rounding_of(first.last().run.state.flux)};
  if (const auto apart = floors_apart(first.floors); first.last().floor > 0 && apart.size() > 1)
    steady_.higher_floor.emplace(problem_, first.floors[apart[1]]);
  return true;
}

template <class Excess>
bool ResponseSolve::refine(const Excess& excess) {
  std::vector<Harmonic*> all{&steady_.both.front(), &steady_.both.back()};
  if (steady_.higher_floor) all.push_back(&*steady_.higher_floor);
  for (Harmonic* const one : all) {
    Harmonic& harmonic = *one;
    for (int pass = 0;; ++pass) {
      const std::vector<double> found = excess(harmonic);
      if (*std::max_element(found.begin(), found.end()) <= 1) break;
      const Resolved& steady = harmonic.steady();
      Mesh mesh = adapted(
          steady.equations->mesh(), found, [](int) { return false; }, shortest_element);
      const bool same = mesh.breakpoints == steady.equations->mesh().breakpoints;
      if (same || pass == most_refinements || mesh.intervals() > most_intervals || meter_.spent()) return false;
      Resolved finer = moved_to(problem_, steady, std::move(mesh), steady.equations->points());
      finer.run = newton(*finer.equations, finer.run.state, finer.floor, refined_newton, meter_);
      if (!finer.run.solved) return false;
      harmonic = Harmonic(problem_, std::move(finer));
    }
  }
  return true;
}

/// The move to floor 0 of a number that is linear in a small floor.
template <class Value>
double ResponseSolve::floor_error(const Value& value) const {
  const Harmonic& harmonic = steady_.both.front();
  const double floor = harmonic.steady().floor;
  if (floor == 0) return 0;
  if (!steady_.higher_floor) return std::numeric_limits<double>::infinity();
  const double part = floor / (steady_.higher_floor->steady().floor - floor);
  return floor_safety_of_response * part * std::abs(value(*steady_.higher_floor) - value(harmonic));
}

ResponseSolve::Judged ResponseSolve::judged(const Twice& values, double floor_error) const {
  Judged found{.value = values.first};
  const double size = std::abs(values.first);
  found.error = (safety * std::abs(values.first - values.second) + floor_error) / size + steady_.rounding;
  found.status = found.error <= request_.tolerance ? StopReason::converged
                 : meter_.spent()                  ? StopReason::limit_reached
                 : std::isfinite(size)             ? StopReason::tolerance_not_met
                                                   : StopReason::diverged;
  return found;
}

/// value(harmonic) within the tolerance, if meshes can be made for it. excess(harmonic, allowed) says where the meshes
/// must be finer.
template <class Value, class Excess>
ResponseSolve::Judged ResponseSolve::certified(const Value& value, const Excess& excess) {
  Judged best;
  for (const double part : allowed_parts) {
    const double allowed = part * request_.tolerance;
    const bool resolved = refine([&](const Harmonic& harmonic) { return excess(harmonic, allowed); });
    const Judged found = judged({value(steady_.both.front()), value(steady_.both.back())}, floor_error(value));
    const double before = best.error;
    if (found.error < best.error || best.status == StopReason::diverged) best = found;
    if (found.status == StopReason::converged || !resolved || found.error > hopeless * before) break;
  }
  return best;
}

Stiffness ResponseSolve::stiffness(double Omega) {
  const Judged kappa = certified([&](const Harmonic& harmonic) { return kappa_of(harmonic, Omega); },
                                 [&](const Harmonic& harmonic, double allowed) {
                                   const ComplexVector& u = harmonic.of_load(Omega);
                                   return harmonic.excess(u, Omega, allowed, std::abs(harmonic.offset(u)));
                                 });
  Stiffness found{.Omega = Omega, .kappa = kappa.value, .error = kappa.error, .status = kappa.status};
  if (Omega == 0) return found;
  const auto lag = [&](const Harmonic& harmonic) { return Complex(-(1.0 / kappa_of(harmonic, Omega)).imag() / Omega); };
  const Judged judged_lag = judged({lag(steady_.both.front()), lag(steady_.both.back())}, floor_error(lag));
  // Rounding is that of kappa, all of it in the imaginary part.
  found.lag_error = judged_lag.error + steady_.rounding * std::abs(kappa.value / kappa.value.imag());
  return found;
}

ResponseSolve::Judged ResponseSolve::wavy_film(const Waviness& waviness) {
  const double Omega = waviness.Omega();
  const auto film = [&](const Harmonic& harmonic, const ComplexVector& u) {
    const auto deflection = harmonic.central_film(u, Omega);
    return deflection ? 1.0 + *deflection : Complex(std::numeric_limits<double>::quiet_NaN());
  };
  return certified([&](const Harmonic& harmonic) { return film(harmonic, harmonic.of_waviness(waviness)); },
                   [&](const Harmonic& harmonic, double allowed) {
                     const ComplexVector& u = harmonic.of_waviness(waviness);
                     return harmonic.excess(u, Omega, allowed, std::abs(film(harmonic, u)), &waviness);
                   });
}

SlowStiffness ResponseSolve::slow() {
  const auto of = [](const Harmonic& harmonic) {  // kappa = -1/(u_0 + i Omega u_1)
    const SlowMotion& u = harmonic.of_slow_load();
    const double u_0 = harmonic.offset(u.u_0), u_1 = harmonic.offset(u.u_1);
    return std::pair(-1 / u_0, u_1 / (u_0 * u_0));
  };
  const auto kappa_0 = [&](const Harmonic& harmonic) { return Complex(of(harmonic).first); };
  const auto kappa_1 = [&](const Harmonic& harmonic) { return Complex(of(harmonic).second); };
  const auto lag = [&](const Harmonic& harmonic) {
    const auto [stiffness, damping] = of(harmonic);
    return Complex(damping / (stiffness * stiffness));
  };
  const auto of_both = [&](const auto& value) {
    return judged({value(steady_.both.front()), value(steady_.both.back())}, floor_error(value));
  };
  const Judged damping = certified(kappa_1, [](const Harmonic& harmonic, double allowed) {
    const SlowMotion& terms = harmonic.of_slow_load();
    const ComplexVector u = terms.u_0 + Complex(0, 1) * terms.u_1;  // both terms, as if Omega = 1
    return harmonic.excess(u, 1, allowed, std::abs(harmonic.offset(u)));
  });
  const Judged stiff = of_both(kappa_0), lagging = of_both(lag);
  return {.kappa_0 = stiff.value.real(),
          .kappa_1 = damping.value.real(),
          .error_0 = stiff.error,
          .error_1 = damping.error,
          .lag = lagging.value.real(),
          .lag_error = lagging.error};
}

std::optional<SlowStiffness> ResponseSolve::find_slow() {
  std::optional<SlowStiffness> best;
  double least = std::numeric_limits<double>::infinity();
  Steady steady;
  for (const double part : steady_parts) {
    if (best && part * request_.tolerance < finest_again) break;
    if (!find_steady(std::max(part * request_.tolerance, finest_steady))) break;
    const SlowStiffness found = slow();
    const double error = std::max(found.error_0, found.error_1);
    if (best && !(error < least)) {
      steady_ = std::move(steady);
      break;
    }
    best = found, least = error;
    if (error <= request_.tolerance || steady_.both.front().steady().floor == 0) break;
    steady = steady_;
  }
  return best;
}

void ResponseSolve::fill(Cost& cost) const {
  if (!steady_.both.empty()) cost.nodes = steady_.both.front().intervals();
  cost.newton_iterations = meter_.iterations;
  cost.convolutions = meter_.kernel_products;
  cost.wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
}

Response ResponseSolve::solve() {
  Response found;
  for (const double Omega : request_.frequencies) found.frequencies.push_back({.Omega = Omega});
  for (const Waviness& waviness : request_.waviness) found.waviness.push_back({.waviness = waviness});
  found.slow = find_slow();
  if (!found.slow) {
    answer_nothing(found, request_, meter_.spent() ? StopReason::limit_reached : StopReason::diverged,
                   "the steady state was not found");
    fill(found.cost);
    return found;
  }
  // Low frequencies first: each takes the meshes over from the one before.
  std::vector<std::size_t> order(found.frequencies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return request_.frequencies[a] < request_.frequencies[b]; });
  std::size_t done = 0;
  request_.tell(done);
  for (const std::size_t k : order) {
    found.frequencies[k] = stiffness(request_.frequencies[k]);
    request_.tell(++done);
  }
  const auto certified = [&](double Omega) {
    const auto value = [&](const Harmonic& harmonic) { return kappa_of(harmonic, Omega); };
    const Judged kappa = judged({value(steady_.both.front()), value(steady_.both.back())}, floor_error(value));
    return kappa.status == StopReason::converged;
  };
  const auto spent = [&] { return meter_.spent(); };
  if (request_.seeks_highest) find_highest_certified(found, request_.tolerance, certified, spent);
  for (auto& at : found.waviness) {
    const Judged film = wavy_film(at.waviness);
    at.film = film.value, at.error = film.error, at.status = film.status;
    request_.tell(++done);
  }
  conclude(found, request_.tolerance, meter_.spent(), "the two discretisations differ by more than the tolerance");
  if (const double floor = steady_.both.front().steady().floor; floor > 0)
    found.notes.push_back("the fluidity's floor could not be lowered below " + plain(floor, 2) +
                          ": values are those of this floor, and their errors include the move to floor 0");
  fill(found.cost);
  return found;
}

}  // namespace

Response response(const Problem& problem, const ResponseRequest& request) {
  return ResponseSolve(problem, request).solve();
}

}  // namespace ehd::reference::hp
