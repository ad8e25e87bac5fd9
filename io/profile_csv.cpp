// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/profile_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd {

std::string profile_csv(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  const auto nodes = fields.X.size();
  const bool lubricated = fields.density.size() == nodes && fields.log_viscosity.size() == nodes;
  const auto length = run.scales ? run.scales->half_width_m : std::nullopt;
  const auto film = run.m_per_hertz_film();
  const bool metres = length && film;
  const std::optional<double> film_error = field_error(run.solution), cut = pressure_cut(run.solution);

  std::string csv = "X [x/b],P [p/p_H],H [h R/b^2]";
  if (lubricated) csv += ",rho [rho/rho_0],eta [eta/eta_0]";
  if (metres) csv += ",x_m [m],p_Pa [Pa],h_m [m]";
  if (film_error) csv += ",H_error [relative]";
  if (cut) csv += ",P_unresolved [1: cut at " + plain(*cut) + "]";
  csv += "\n";
  const auto cell = [&](double value, bool first = false) {
    if (!first) csv += ',';
    if (std::isfinite(value)) csv += fmt::format("{:.15g}", value);
  };
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const bool is_cut = cut && !(fields.P[i] <= *cut);
    const double P = is_cut ? *cut : fields.P[i];
    cell(fields.X[i], true);
    cell(P);
    cell(fields.H[i]);
    if (lubricated) {
      cell(is_cut ? std::nan("") : fields.density[i]);
      cell(is_cut ? std::nan("") : std::exp(fields.log_viscosity[i]));
    }
    if (metres) {
      cell(fields.X[i] * *length);
      cell(P * run.scales->hertz_pressure_Pa);
      cell(fields.H[i] * *film);
    }
    if (film_error) cell(*film_error);
    if (cut) cell(is_cut ? 1 : 0);
    csv += "\n";
  }
  return csv;
}

}  // namespace ehd
