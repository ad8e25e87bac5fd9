// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/profile_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "contact/stated_error.hpp"
#include "workflow/shown_pressure.hpp"

namespace ehd {

namespace {

/// A spike that the grid does not resolve bends the film up to so far away [b]: contact/stated_error.hpp.
constexpr double reach_of_spike = 0.03;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Where the pressure is not shown as it is.
ArrayOf<bool> cut_nodes(const ContactRun& run) {
  const auto cut = pressure_cut(run);
  const Array& P = run.solution.fields.P;
  return cut ? ArrayOf<bool>(!(P <= *cut)) : ArrayOf<bool>(ArrayOf<bool>::Constant(P.size(), false));
}

Array shown_pressure(const ContactRun& run) {
  const auto cut = pressure_cut(run);
  const Array& P = run.solution.fields.P;
  return cut ? Array(cut_nodes(run).select(*cut, P)) : P;
}

bool is_lubricated(const Fields& fields) {
  return fields.density.size() == fields.X.size() && fields.log_viscosity.size() == fields.X.size();
}

std::optional<Array> relative_density(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  if (!is_lubricated(fields)) return std::nullopt;
  return cut_nodes(run).select(no_number, fields.density);
}

std::optional<Array> relative_viscosity(const ContactRun& run) {
  const Fields& fields = run.solution.fields;
  if (!is_lubricated(fields)) return std::nullopt;
  const Array eta = fields.log_viscosity.unaryExpr([](double log) { return std::exp(log); });
  return (cut_nodes(run) || !eta.isFinite()).select(no_number, eta);
}

std::optional<Array> in_SI(const ContactRun& run, SIScale scale, const Array& values) {
  const bool known = run.SI_per_hertz(SIScale::length) && run.SI_per_hertz(SIScale::film);
  return known ? std::optional<Array>(values * *run.SI_per_hertz(scale)) : std::nullopt;
}

/// The error of a whole field at the nodes; NaN beside a spike of unknown height, where it is not known.
std::optional<Array> at_nodes(const std::optional<double>& error, const ContactRun& run) {
  const Array& X = run.solution.fields.X;
  if (!error || X.size() == 0) return std::nullopt;
  const Array errors = Array::Constant(X.size(), *error);
  const auto spike = vague_spike(run);
  if (!spike) return errors;
  return ((X - *spike->place).abs() <= reach_of_spike).select(no_number, errors);
}

std::optional<Array> film_errors(const ContactRun& run) { return at_nodes(field_error(run.solution), run); }

std::optional<Array> pressure_errors(const ContactRun& run) { return at_nodes(pressure_error(run.solution), run); }

std::optional<Array> is_unresolved(const ContactRun& run) {
  if (pressure_known(run) || run.solution.fields.P.size() == 0) return std::nullopt;
  return cut_nodes(run).cast<double>();
}

static_assert(shown_of_unresolved == 1.5);  // the row of P_unresolved names it
constexpr std::array<ProfileRow, most_profile_columns> columns_of_profile{{
    {"X", "x/b", [](const ContactRun& run) { return std::optional(run.solution.fields.X); }},
    {"P", "p/p_H", [](const ContactRun& run) { return std::optional(shown_pressure(run)); }},
    {"H", "h R/b^2", [](const ContactRun& run) { return std::optional(run.solution.fields.H); }},
    {"rho", "rho/rho_0", relative_density},
    {"eta", "eta/eta_0", relative_viscosity},
    {"x_m", "m", [](const ContactRun& run) { return in_SI(run, SIScale::length, run.solution.fields.X); }},
    {"p_Pa", "Pa", [](const ContactRun& run) { return in_SI(run, SIScale::pressure, shown_pressure(run)); }},
    {"h_m", "m", [](const ContactRun& run) { return in_SI(run, SIScale::film, run.solution.fields.H); }},
    {"H_error", "relative", film_errors},
    {"P_unresolved", "maximum not known; 1: cut at 1.5", is_unresolved},
    {"P_error", "relative in L2", pressure_errors},
}};

}  // namespace

std::span<const ProfileRow, most_profile_columns> profile_rows() { return columns_of_profile; }

std::vector<ProfileColumn> profile_of(const ContactRun& run) {
  std::vector<ProfileColumn> columns;
  for (const ProfileRow& row : columns_of_profile)
    if (auto values = row.values(run)) columns.push_back({row.name, row.unit, *std::move(values)});
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
