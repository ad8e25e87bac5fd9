// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/node_fields.hpp"

#include <cmath>
#include <numbers>

#include "fast/counters.hpp"

namespace ehd::fast {

using std::numbers::pi;

bool NodeFields::evaluate_film(const Setting& setting, State& state, Grid& on) {
  n = on.n;
  grid = &on;
  length = state.exit - setting.inlet;
  Array& P = state.P;
  P[n] = 0;
  P[0] = setting.with_tail ? state.tail.pressure : 0;
  deflection = product;
  integral = product_integral;
  if (setting.with_tail) {  // the first node's own half of a cell
    deflection += P[0] * on.first_column();
    integral += P[0] * on.first_weight;
  }
  deflection = length * (deflection + std::log(length) * integral);
  H.resize(n + 1);
  const double x0 = setting.inlet, inverse_pi = 1 / pi;
  const double* const place = on.place.data();
  if (setting.with_tail) {
    const double* const t = state.tail.deflection;
    std::copy_n(t, tail_deflection.size(), tail_deflection.begin());
    for (int i = 0; i <= n; ++i) {
      const double X = x0 + length * place[i];
      H[i] = state.offset + X * X / 2 - inverse_pi * deflection[i] +
             (t[0] + X * (t[1] + X * (t[2] + X * (t[3] + X * t[4]))));
    }
  } else {
    for (int i = 0; i <= n; ++i) {
      const double X = x0 + length * place[i];
      H[i] = state.offset + X * X / 2 - inverse_pi * deflection[i];
    }
  }
  if (setting.sources) {
    for (int i = 0; i <= n; ++i) H[i] += setting.sources->film(x0 + length * place[i]).first;
  }
  return H.minCoeff() > 0 && H.allFinite();
}

void NodeFields::evaluate_laws(const Setting& setting, const Array& P, Counters& counters) {
  ehd::evaluate(setting.viscosity, P, log_viscosity);
  ehd::evaluate(setting.density, P, density);
  if (is_trivial(setting.viscosity)) {
    fluidity.setOnes(n + 1);
  } else {
    fluidity = (-log_viscosity.value).exp();
    counters.viscosity_points += n + 1;
  }
  if (!is_trivial(setting.density)) counters.density_points += n + 1;
}

void NodeFields::inject(const NodeFields& fine, const Array& fine_pressure, Array& pressure, Grid& on) {
  n = on.n;
  grid = &on;
  length = fine.length;
  integral = fine.integral;
  tail_deflection = fine.tail_deflection;
  const bool nested = fine.n % 2 == 0;
  const auto take = [&](const Array& from, Array& to) {
    to.resize(n + 1);
    if (nested) {
      to = from(Eigen::seqN(0, n + 1, 2));
    } else {
      const double ratio = static_cast<double>(fine.n) / n;
      for (int i = 0; i <= n; ++i) {
        const int left = std::min(static_cast<int>(i * ratio), fine.n - 1);
        const double share = i * ratio - left;
        to[i] = (1 - share) * from[left] + share * from[left + 1];
      }
    }
  };
  take(fine_pressure, pressure);
  take(fine.H, H);
  take(fine.deflection, deflection);
  take(fine.log_viscosity.value, log_viscosity.value);
  take(fine.log_viscosity.slope, log_viscosity.slope);
  take(fine.density.value, density.value);
  take(fine.density.slope, density.slope);
  take(fine.fluidity, fluidity);
}

}  // namespace ehd::fast
