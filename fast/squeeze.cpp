// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/squeeze.hpp"

#include "fast/node_fields.hpp"

namespace ehd::fast {

void Squeeze::linearise(const NodeFields& nodes) {
  const int n = nodes.n;
  const Array& place = nodes.grid->place;
  Array weight = nodes.length / n * nodes.grid->slope;
  weight[0] /= 2;
  weight[n] /= 2;
  by_pressure = weight * nodes.density.slope * nodes.H;
  by_film = weight * nodes.density.value;
  by_exit.resize(n);
  const Array mass = nodes.density.value * nodes.H;
  double sum = 0;  // of w rho H/l
  for (int i = n - 1; i >= 0; --i) {
    sum += weight[i + 1] / nodes.length * mass[i + 1];
    by_exit[i] = sum + (place[i] + place[i + 1]) / 2 * (mass[i] + mass[i + 1]) / 2 - mass[n];
  }
  inflow_by_exit = sum + weight[0] / nodes.length * mass[0] - mass[n];
}

template <class Scalar>
void Squeeze::subtract(Scalar rate, const StepOf<Scalar>& step, ChangeOf<Scalar>& change) const {
  const Eigen::Index n = by_exit.size();
  const Scalar* const dP = step.P.data();
  const Scalar* const dH = change.film.data();
  Scalar* const flux = change.flux.data();
  Scalar sum(0);
  for (Eigen::Index i = n - 1; i >= 0; --i) {
    sum += by_pressure[i + 1] * dP[i + 1] + by_film[i + 1] * dH[i + 1];
    flux[i] -= times(rate, sum + by_exit[i] * step.exit);
  }
}

template <class Scalar>
Scalar Squeeze::inflow(const StepOf<Scalar>& step, const ArrayOf<Scalar>& film) const {
  return (by_pressure * step.P + by_film * film).sum() + inflow_by_exit * step.exit;
}

template void Squeeze::subtract(double, const Step&, ChangeOf<double>&) const;
template void Squeeze::subtract(Complex, const StepOf<Complex>&, ChangeOf<Complex>&) const;
template double Squeeze::inflow(const Step&, const Array&) const;
template Complex Squeeze::inflow(const StepOf<Complex>&, const ArrayOf<Complex>&) const;

}  // namespace ehd::fast
