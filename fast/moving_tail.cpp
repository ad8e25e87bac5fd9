// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/moving_tail.hpp"

#include <cmath>
#include <numbers>

namespace ehd::fast {

using std::numbers::pi;

namespace {

/// The integrals of a waviness decay like e^(-kxu) (1 + u)^-6 along x (1 + iu): this is 6.
constexpr double powers_of_gap = 6;

}  // namespace

MovingTail::MovingTail(double far, double gap_excess, double moment, double flux, double lambda, double slope)
    : far_(far), gap_excess_(gap_excess), moment_(moment), flux_(flux), lambda_(lambda) {
  using PointsByDrive = Eigen::Array<double, points, 4>;
  const TailRule& rule = tail_rule();
  x_ = far / rule.t.array();
  dx_ = far / rule.t.array().square();
  const Points ln = (x_ / far).log(), inverse = 1 / x_ - 1 / far;
  const Points gap = x_.square() / 2 + gap_excess - ln / 2 - moment / pi * inverse;
  const Points steady = lambda * (1 - flux / gap) / gap.square() * dx_;
  const auto stiffening = [&](auto reduced) { return (1 - slope * reduced).inverse().eval(); };  // dP/dQ
  by_reduced_ = stiffening((rule.up_to * steady.matrix()).array());
  by_reduced_at_edge_ = 1 / (1 - slope * rule.w.dot(steady.matrix()));

  PointsByDrive film = PointsByDrive::Zero(), squeezed = PointsByDrive::Zero();  // H_1, Int H_1 dx'
  film.col(0).setOnes();
  film.col(1) = -ln / pi;
  film.col(2) = -inverse / pi;
  squeezed.col(0) = x_ - far;
  squeezed.col(1) = -(x_ * ln - x_ + far) / pi;
  squeezed.col(2) = -(ln - (x_ - far) / far) / pi;
  PointsByDrive flux_at_rest = PointsByDrive::Zero();
  flux_at_rest.col(3).setOnes();
  const Points by_flux = -lambda / gap.cube() * dx_;
  const Points by_film = lambda * (3 * flux / gap - 2) / gap.cube() * dx_;

  const auto integrated = [&](const PointsByDrive& integrand) {
    const Eigen::Matrix<double, points, 4> reduced = rule.up_to * integrand.matrix();
    const Eigen::Matrix<double, 1, 4> at_edge = rule.w.transpose() * integrand.matrix();
    return answers(reduced, at_edge);
  };
  at_rest_ = integrated(film.colwise() * by_film + flux_at_rest.colwise() * by_flux);
  by_rate_ = integrated(squeezed.colwise() * by_flux);
}

template <class Scalar, int columns>
Eigen::Matrix<Scalar, 7, columns> MovingTail::answers(const Eigen::Matrix<Scalar, points, columns>& reduced,
                                                      const Eigen::Matrix<Scalar, 1, columns>& reduced_at_edge) const {
  Eigen::Matrix<Scalar, 7, columns> found;
  const auto of = [](const auto& real) { return real.template cast<Scalar>().eval(); };
  const Eigen::Array<Scalar, points, columns> pressure = reduced.array().colwise() * of(by_reduced_);
  const Eigen::Array<Scalar, points, columns> share = pressure.colwise() * of(tail_rule().w.array() * dx_);
  found.row(0) = share.colwise().sum();
  found.row(1) = by_reduced_at_edge_ * reduced_at_edge;
  // -(1/pi) ln(x + X) = -(1/pi) [ln x + X/x - X^2/(2 x^2) + …]
  found.row(2) = -(share.colwise() * of(x_.log())).colwise().sum() / pi;
  Points power = Points::Ones();
  for (int k = 1; k <= 4; ++k) {
    power /= -x_;
    found.row(2 + k) = (share.colwise() * of(power)).colwise().sum() / (k * pi);
  }
  return found;
}

/// Q_1(x) = lambda Int_x^inf g(x') e^(ikx') dx' with g = (3 C/H - 2 - S)/H^3, which is smooth. Along x (1 + iu) the
/// wave decays, so that few points are enough: u = a v/(1 - v) follows both decays, e^(-kxu) and that of g.
MovingTail::Answer<std::complex<double>> MovingTail::answer(const Waviness& waviness) const {
  using Complex = std::complex<double>;
  using ComplexPoints = Eigen::Array<Complex, points, 1>;
  const double k = waviness.wavenumber();
  const Points v = tail_rule().t.array(), dv = tail_rule().w.array();
  const auto reduced = [&](double from) {
    const double a = 1 / (1 + k * from / powers_of_gap);
    const Points u = a * v / (1 - v), du = a * dv / (1 - v).square();
    const ComplexPoints x = from * (1 + Complex(0, 1) * u.cast<Complex>());
    const ComplexPoints gap =
        x.square() / 2 + gap_excess_ - (x / far_).log() / 2 - moment_ / pi * (x.inverse() - 1 / far_);
    const ComplexPoints g = (3 * flux_ / gap - 2 - waviness.slip) / gap.cube();
    return lambda_ * std::polar(from, k * from) * Complex(0, 1) * (g * ((-k * from * u).exp() * du)).sum();
  };
  Eigen::Matrix<Complex, points, 1> inside;
  for (int j = 0; j < points; ++j) inside[j] = reduced(x_[j]);
  return answers<Complex, 1>(inside, Eigen::Matrix<Complex, 1, 1>(reduced(far_)));
}

}  // namespace ehd::fast
