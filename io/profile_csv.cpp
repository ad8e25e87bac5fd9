// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/profile_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "contact/stated_error.hpp"
#include "contact/text.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd {

namespace {

/// A spike that the grid does not resolve bends the film up to so far away [b]: contact/stated_error.hpp.
constexpr double reach_of_spike = 0.03;

/// The relative error of H at the nodes; NaN beside a spike of unknown height, where it is not known.
Array film_errors(const Solution& solution, double error) {
  const Array& X = solution.fields.X;
  const Array errors = Array::Constant(X.size(), error);
  const auto spike = vague_spike(solution);
  if (!spike) return errors;
  return ((X - *spike->place).abs() <= reach_of_spike).select(std::nan(""), errors);
}

}  // namespace

std::vector<ProfileColumn> profile_of(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  const auto nodes = fields.X.size();
  const bool lubricated = fields.density.size() == nodes && fields.log_viscosity.size() == nodes;
  const auto length = run.scales ? run.scales->half_width_m : std::nullopt;
  const auto film = run.m_per_hertz_film();
  const std::optional<double> film_error = field_error(run.solution), cut = pressure_cut(run.solution);
  const double missing = std::nan("");
  using Flags = ArrayOf<bool>;
  const Flags is_cut = cut ? Flags(!(fields.P <= *cut)) : Flags(Flags::Constant(nodes, false));
  const Array P = cut ? Array(is_cut.select(*cut, fields.P)) : fields.P;

  std::vector<ProfileColumn> columns{{"X", "x/b", fields.X}, {"P", "p/p_H", P}, {"H", "h R/b^2", fields.H}};
  if (lubricated) {
    const Array eta = fields.log_viscosity.unaryExpr([](double log) { return std::exp(log); });
    columns.push_back({"rho", "rho/rho_0", is_cut.select(missing, fields.density)});
    columns.push_back({"eta", "eta/eta_0", (is_cut || !eta.isFinite()).select(missing, eta)});
  }
  if (length && film) {
    columns.push_back({"x_m", "m", fields.X * *length});
    columns.push_back({"p_Pa", "Pa", P * run.scales->hertz_pressure_Pa});
    columns.push_back({"h_m", "m", fields.H * *film});
  }
  if (film_error) columns.push_back({"H_error", "relative", film_errors(run.solution, *film_error)});
  if (cut) columns.push_back({"P_unresolved", "1: cut at " + plain(*cut), is_cut.select(1.0, Array::Zero(nodes))});
  return columns;
}

std::string profile_csv(const ContactRun& run) {
  const std::vector<ProfileColumn> columns = profile_of(run);
  std::string csv;
  for (const ProfileColumn& column : columns)
    csv += fmt::format("{}{} [{}]", csv.empty() ? "" : ",", column.name, column.unit);
  csv += "\n";
  for (Eigen::Index i = 0; i < columns.front().values.size(); ++i) {
    for (const ProfileColumn& column : columns) {
      if (&column != &columns.front()) csv += ',';
      if (std::isfinite(column.values[i])) csv += fmt::format("{:.15g}", column.values[i]);
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace ehd
