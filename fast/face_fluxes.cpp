// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/face_fluxes.hpp"

#include <limits>

#include "fast/log_mean.hpp"
#include "fast/node_fields.hpp"

namespace ehd::fast {

void FaceFluxes::evaluate(const Setting& setting, const NodeFields& nodes, const Array& P) {
  const int n = nodes.n;
  eps.resize(n);
  flux.resize(n);
  const double inverse_lambda = 1 / setting.groups.lambda, inverse_length = 1 / nodes.length;
  const double* const a = nodes.log_viscosity.value.data();
  const double* const u = nodes.fluidity.data();
  const double* const rho = nodes.density.value.data();
  carried.evaluate(setting, nodes, P);
  const double* const rho_w = carried.value.data();
  const double* const gap = nodes.H.data();
  const double* const p = P.data();
  const double* const inverse_spacing = nodes.grid->inverse_spacing.data();
  const double* const k = nodes.grid->bias.data();
  double* const mobility = eps.data();
  double* const through = flux.data();
  for (int i = 0; i < n; ++i) {
    const double m = log_mean(u[i], u[i + 1], a[i + 1] - a[i]) + setting.fluidity_floor;
    const double Hf = (gap[i] + gap[i + 1]) / 2;
    mobility[i] = (rho[i] + rho[i + 1]) / 2 * Hf * Hf * Hf * m * inverse_lambda;
  }
  through[0] =
      (rho_w[0] * gap[0] + rho_w[1] * gap[1]) / 2 - mobility[0] * (p[1] - p[0]) * inverse_spacing[0] * inverse_length;
  for (int i = 1; i < n; ++i) {
    const double here = rho_w[i] * gap[i];
    const double wedge =
        here + ((1 + k[i]) * (rho_w[i + 1] * gap[i + 1] - here) + (1 - k[i]) * (here - rho_w[i - 1] * gap[i - 1])) / 4;
    through[i] = wedge - mobility[i] * (p[i + 1] - p[i]) * inverse_spacing[i] * inverse_length;
  }
}

double FaceFluxes::rounding(const NodeFields& nodes, const Array& P, const Array& oil) const {
  const int n = nodes.n;
  const double inverse_length = 1 / nodes.length;
  const auto poiseuille = eps * P.head(n).max(P.tail(n)) * nodes.grid->inverse_spacing * inverse_length;
  return std::numeric_limits<double>::epsilon() *
         ((poiseuille + (nodes.density.value * nodes.H).head(n)) / oil).maxCoeff();
}

}  // namespace ehd::fast
