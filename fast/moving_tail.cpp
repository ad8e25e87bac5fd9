// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/moving_tail.hpp"

#include <cmath>
#include <numbers>

#include "fast/tail_rule.hpp"

namespace ehd::fast {

MovingTail::MovingTail(double far, double gap_excess, double moment, double flux, double lambda, double slope) {
  using std::numbers::pi;
  constexpr int points = TailRule::points;
  using Points = Eigen::Array<double, points, 1>;
  using PointsByDrive = Eigen::Array<double, points, 4>;
  const TailRule& rule = tail_rule();
  const Points x = far / rule.t.array(), dx = far / rule.t.array().square();
  const Points ln = (x / far).log(), inverse = 1 / x - 1 / far;
  const Points gap = x.square() / 2 + gap_excess - ln / 2 - moment / pi * inverse;
  const Points steady = lambda * (1 - flux / gap) / gap.square() * dx;
  const auto stiffening = [&](auto reduced) { return (1 - slope * reduced).inverse().eval(); };  // dP/dQ
  const Points by_reduced = stiffening((rule.up_to * steady.matrix()).array());
  const double by_reduced_at_edge = 1 / (1 - slope * rule.w.dot(steady.matrix()));

  PointsByDrive film = PointsByDrive::Zero(), squeezed = PointsByDrive::Zero();  // H_1, Int H_1 dx'
  film.col(0).setOnes();
  film.col(1) = -ln / pi;
  film.col(2) = -inverse / pi;
  squeezed.col(0) = x - far;
  squeezed.col(1) = -(x * ln - x + far) / pi;
  squeezed.col(2) = -(ln - (x - far) / far) / pi;
  PointsByDrive flux_at_rest = PointsByDrive::Zero();
  flux_at_rest.col(3).setOnes();
  const Points by_flux = -lambda / gap.cube() * dx;
  const Points by_film = lambda * (3 * flux / gap - 2) / gap.cube() * dx;

  const auto answers = [&](const PointsByDrive& integrand) {
    Eigen::Matrix<double, 7, 4> found;
    const PointsByDrive pressure = (rule.up_to * integrand.matrix()).array().colwise() * by_reduced;
    const PointsByDrive share = pressure.colwise() * (rule.w.array() * dx);
    found.row(0) = share.colwise().sum();
    found.row(1) = by_reduced_at_edge * (rule.w.transpose() * integrand.matrix());
    // -(1/pi) ln(x + X) = -(1/pi) [ln x + X/x - X^2/(2 x^2) + …]
    found.row(2) = -(share.colwise() * x.log()).colwise().sum() / pi;
    Points power = Points::Ones();
    for (int k = 1; k <= 4; ++k) {
      power /= -x;
      found.row(2 + k) = (share.colwise() * power).colwise().sum() / (k * pi);
    }
    return found;
  };
  at_rest_ = answers(film.colwise() * by_film + flux_at_rest.colwise() * by_flux);
  by_rate_ = answers(squeezed.colwise() * by_flux);
}

}  // namespace ehd::fast
