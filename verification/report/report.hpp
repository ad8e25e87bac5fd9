// SPDX-License-Identifier: GPL-3.0-or-later
// `ehd report`: results -> one self-contained HTML page. A pure function of the JSON files: nothing is solved here, and
// what they lack is a line that names the command that makes it.
#pragma once

#include <string>

#include "verification/report/document.hpp"
#include "verification/report/page.hpp"

namespace ehd::report {

/// Throws ReportError where a value has the wrong type, where results.json lacks claims, summary or provenance, and
/// where a verdict or a rung is none.
[[nodiscard]] std::string report_html(const Documents& documents);

/// A claim passes, or is inconclusive and listed with a reason: what lets the suite succeed.
[[nodiscard]] bool stands(const View& claim);

// The sections, in this order.
void add_summary(Page& page, const View& results);
void add_contacts(Page& page, const View& results);
void add_convergence(Page& page, const View& results);
void add_work_precision(Page& page, const View& bench);
void add_maps(Page& page, const View& results);
void add_stress(Page& page, const View& stress);
void add_bearing(Page& page, const View& results);
void add_origin(Page& page, const View& results, const View& bench, const View& stress);

// The figures that `--plot` draws too.

/// A contact's pressure and film over X, one or more solvers.
struct ContactCurves {
  std::string name;  ///< plain: the solver
  std::vector<double> X, P, H;
};
/// Curves over the region where something happens; `difference` panels are the caller's.
[[nodiscard]] Figure contact_figure(const std::string& id, const std::string& title,
                                    const std::vector<ContactCurves>& curves);

/// A bearing's rollers under one law.
struct BearingCurves {
  std::string law;  ///< plain
  std::vector<double> azimuth_deg;
  std::vector<double> force_N, displacement_m;  ///< inner contacts
};
enum class OverAzimuth { force, displacement };
/// One panel: f_i or delta_i of each law over psi, from 0 to 180 degrees.
[[nodiscard]] Panel azimuth_panel(OverAzimuth quantity, const std::string& title_markup,
                                  const std::vector<BearingCurves>& laws);

/// A law's line, marker and colour: the same in every figure.
struct Look {
  Line line = Line::solid;
  Marker marker = Marker::circle;
  int colour = 1;
};
[[nodiscard]] Look look_of_law(const std::string& law);
[[nodiscard]] Look look_of_solver(const std::string& solver);

}  // namespace ehd::report
