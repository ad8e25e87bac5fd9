// SPDX-License-Identifier: GPL-3.0-or-later
// The harmonic response of one raceway's contacts over the contact force: kappa of contact/response.hpp, in Hertz
// units.
#pragma once

#include <compare>
#include <functional>
#include <variant>
#include <vector>

#include "bearing/continued_spline.hpp"
#include "bearing/geometry.hpp"
#include "bearing/monotone_spline.hpp"
#include "bearing/solved_contacts.hpp"
#include "contact/response.hpp"

namespace ehd::bearing {

/// In this room kappa = stiffness + i Omega damping has the datum x_0 = l: 1/kappa is that of contact/response.hpp,
/// whose datum is b, plus ln(l/b)/pi. With the datum b the compliance nearly vanishes at M = 0.8, where a film begins
/// to be elastic; with l it falls smoothly with the load.
using ehd::Kappa;

/// The response of one solved contact.
struct SolvedResponse {
  Kappa slow;                  ///< Omega -> 0: kappa_0 and kappa_1
  std::vector<Kappa> at = {};  ///< at the frequencies that were asked for; unknown_at() where there is no answer
};

/// kappa at a frequency that no solver resolves: that of slow motion, with infinite errors.
[[nodiscard]] Kappa unknown_at(const Kappa& slow);
[[nodiscard]] bool is_known(const Kappa& kappa);
using ResponseResult = std::variant<SolvedResponse, SolveFailure>;

/// The contact at a raceway, and the function that solves its response at a load [N/m] and at frequencies [rad/s].
struct RespondingContact {
  RacewayContact contact;
  std::function<ResponseResult(double load_N_per_m, const std::vector<double>& omegas)> solve;

  /// The response at a force [N].
  [[nodiscard]] ResponseResult at(double force_N, const std::vector<double>& omegas) const {
    return solve(force_N / contact.length_m, omegas);
  }
};

/// Omega = omega b/u_m at a contact force [N], omega in rad/s.
[[nodiscard]] double Omega_of(const RacewayContact& contact, double force_N, double omega);

/// s, the smallest size that errors of the lag are compared with: a tenth to all of the lag of heavy contacts.
[[nodiscard]] double lag_scale(double M);

/// Relative errors of a curve: of the stiffness to |kappa|, of the damping to ResponseCurve::damping_scale.
struct ReadingErrors {
  double stiffness = 0, damping = 0;              ///< between the points
  double stiffness_below = 0, damping_below = 0;  ///< below the lightest point
};

/// Each frequency has its own: a high one is known less well, and the others are not.
struct ResponseErrors {
  ReadingErrors slow;
  std::vector<ReadingErrors> at = {};  ///< at the frequencies of the curve; empty: none has an error
};

/// kappa over the contact force.
/// - Slow motion: kappa_0 as a ContinuedSpline. The lag kappa_1/kappa_0^2 falls over decades and nearly vanishes at
///   M = 0.8; it may have either sign. So the spline goes through asinh(lag/s), s of lag_scale.
/// - At each frequency of the curve: the departure Re kappa/kappa_0 - 1, and Im kappa/Omega over damping_scale.
/// - Below the lightest point kappa_0 and the lag go over to those of a rigid cylinder (martin.hpp). A rigid cylinder
///   has no departures. Those of the contact fall there like Omega^2 ~ f.
class ResponseCurve {
 public:
  struct Point {
    double force_N = 0;
    SolvedResponse response;
  };

  /// At least three points, forces increasing, kappa_0 positive, kappa_1 of the lightest positive; `at` of each point
  /// as long as `omegas`. Throws std::invalid_argument.
  ResponseCurve(RacewayContact contact, std::vector<double> omegas, const std::vector<Point>& points,
                ResponseErrors errors = {});

  [[nodiscard]] Kappa slow(double force_N) const;
  /// At the frequency `omegas()[k]`.
  [[nodiscard]] Kappa at(double force_N, std::size_t k) const;
  [[nodiscard]] const std::vector<double>& omegas() const { return omegas_; }
  [[nodiscard]] const RacewayContact& contact() const { return contact_; }
  [[nodiscard]] const std::vector<double>& forces_N() const { return forces_N_; }
  [[nodiscard]] const ResponseErrors& errors() const { return errors_; }
  /// What errors of the damping are compared with: sqrt(lag^2 + s^2) kappa_0^2, which is about the damping, or s
  /// kappa_0^2 where the damping is smaller.
  [[nodiscard]] double damping_scale(double force_N) const;

 private:
  /// Errors that the solver states, the largest of all points, relative.
  struct SolverErrors {
    double stiffness = 0, damping = 0;
    void meet(const SolverErrors& other);
  };
  /// Splines of one frequency: Re kappa/kappa_0 - 1, and Im kappa/Omega over damping_scale.
  struct Frequency {
    MonotoneSpline departure, damping;
    SolverErrors solver;
  };
  [[nodiscard]] double inside(const MonotoneSpline& spline, double force_N) const;
  [[nodiscard]] double lag_inside(double force_N) const;  ///< of slow motion, from the lightest point on
  [[nodiscard]] double slow_lag(double force_N) const;
  [[nodiscard]] double slow_damping(double force_N) const;
  [[nodiscard]] SolverErrors relative_errors(double force_N, double Omega, const Kappa& kappa) const;
  [[nodiscard]] Kappa with_errors(double force_N, double omega, Kappa kappa, const SolverErrors& solver,
                                  const ReadingErrors& reading) const;

  RacewayContact contact_;
  std::vector<double> omegas_, forces_N_;
  ContinuedSpline kappa_0_;
  MonotoneSpline slow_lag_;
  std::vector<Frequency> frequencies_;
  SolverErrors slow_solver_;
  ResponseErrors errors_;
};

/// How a curve is made.
struct ResponseCurveRequest {
  double lightest_N = 0, heaviest_N = 0;
  std::vector<double> omegas = {};  ///< rad/s, at which the motion is not slow
  /// Where the curve will be read [N], if that is known: see build_response_curve. Forces below the lightest one and
  /// above the heaviest one are left out.
  std::vector<double> read_at_N = {};
  double bound = 1.6e-2;       ///< allowed disagreement at an extra solve in each gap; an eighth of it is stated
  double widest_gap = 3.5;     ///< ratio of neighbouring forces before gaps are split
  double smallest_gap = 1.04;  ///< a gap below this ratio is not split
  int most_points = 80;

  friend auto operator<=>(const ResponseCurveRequest&, const ResponseCurveRequest&) = default;
};

/// A curve through all loads. The first points are equal steps in ln f from the lightest to the heaviest force. An
/// extra solve judges each gap and becomes a point. Where it disagrees by more than the bound, the gap is split there.
/// One contact of half the lightest force gives the error below the lightest point; the error is infinite where that
/// contact has no solution. A failure of any other solve is a SolveFailure. So is a kappa_0 that is not positive, or
/// such a kappa_1 at the lightest force.
///
/// Where one contact has no answer at a frequency, that frequency is unknown on the whole curve, and no other contact
/// is asked for it. Where there are frequencies, the heaviest contact is solved first, because its Omega is the
/// highest.
///
/// With few forces in read_at_N, the points are these, the lightest force and two forces above it. Besides them only
/// the contact at half the lightest force is solved. The errors between the points are then unknown and stated as 0:
/// read such a curve at its points and below the lightest one only.
[[nodiscard]] std::variant<ResponseCurve, SolveFailure> build_response_curve(const RespondingContact& contacts,
                                                                             const ResponseCurveRequest& request);

}  // namespace ehd::bearing
