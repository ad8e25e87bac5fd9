// SPDX-License-Identifier: GPL-3.0-or-later
// `ehd report`: results -> one self-contained HTML page, a pure function of the JSON files. Nothing is solved here. A
// line names each absent part and the command that makes it.
#pragma once

#include <string>

#include "verification/report/document.hpp"
#include "verification/report/page.hpp"

namespace ehd::report {

/// Throws ReportError where a value has the wrong type, where results.json lacks claims, summary or provenance, and
/// where a verdict or a rung is unknown.
[[nodiscard]] std::string report_html(const Documents& documents);

/// The claim passes, or it is inconclusive and accepted with a reason.
[[nodiscard]] bool stands(const View& claim);

/// Digits that a relative error leaves: 4 for 1e-4; none where there is no error or nothing is known. At most 16, those
/// of a double.
[[nodiscard]] std::optional<double> digits_of(const std::optional<double>& relative_error);
/// To a tenth, rounded down: 4.29 digits are "4.2".
[[nodiscard]] std::string digits_text(double digits);
/// What is certain of both films of a case (relative): the larger difference between the two solvers, plus the error
/// that the first of them, the truth, states.
[[nodiscard]] std::optional<double> certain_error(const View& contact_case);

/// A line of the first table: what was verified, and what of it was not.
struct Verified {
  std::string what = {};                           ///< HTML; with a link to its section
  std::string digits = {}, truth = {}, cost = {};  ///< HTML
  std::vector<std::string> open = {};              ///< HTML; not verified, or left out
  std::vector<std::string> wrong = {};             ///< HTML; what does not stand: the headline has it too
};
/// Everything on the page: a line for each section, and for each part of a section that is verified on its own.
[[nodiscard]] std::vector<Verified> everything_verified(const View& results, const View& bench, const View& stress);

// The sections, in this order.
void add_summary(Page& page, const View& results, const View& bench, const View& stress);
void add_claims(Page& page, const View& results);
void add_contacts(Page& page, const View& results);
void add_convergence(Page& page, const View& results);
void add_work_precision(Page& page, const View& bench);
/// Parts of it: what an answer costs; scaling, many contacts at once; the cost of motion.
void add_answer_cost(Page& page, const View& bench);
void add_scaling(Page& page, const View& bench);
void add_response_cost(Page& page, const View& bench);
void add_maps(Page& page, const View& results);
void add_stress(Page& page, const View& stress);
void add_bearing(Page& page, const View& results);
/// A part of the bearing's section: figures.dynamics.
void add_dynamics(Page& page, const std::vector<View>& bearings);
void add_origin(Page& page, const View& results, const View& bench, const View& stress);

// The figures that `--plot` draws too.

/// A contact's pressure and film over X, one or more solvers.
struct ContactCurves {
  std::string name;  ///< plain: the solver
  std::vector<double> X, P, H;
  std::optional<double> P_cut = {};       ///< P ends here: the spike is higher, by an unknown amount
  std::optional<Point> vague_spike = {};  ///< top of a spike in (X, P), drawn although its height is not known
};
/// One panel: P and H over the contact, the inlet zone and the exit.
[[nodiscard]] Figure contact_figure(const std::string& id, const std::string& title,
                                    const std::vector<ContactCurves>& curves);

/// Pressure and film in the contact, and on a third of its width at both sides, as a picture for a line of text.
[[nodiscard]] std::string contact_spark(const ContactCurves& curves);

/// A bearing's rollers under one law.
struct BearingCurves {
  std::string law;  ///< plain
  std::vector<double> azimuth_deg;
  std::vector<double> force_N, displacement_m;  ///< inner contacts
};
enum class OverAzimuth { force, displacement };
/// One panel: f_i or delta_i of each law over psi, from 0 to 180 degrees; from -180 where one half is no mirror image
/// of the other.
[[nodiscard]] Panel azimuth_panel(OverAzimuth quantity, const std::string& title_markup,
                                  const std::vector<BearingCurves>& laws);

/// A curve's line, marker and colour.
struct Look {
  Line line = Line::solid;
  Marker marker = Marker::circle;
  int colour = 1;
};
/// A contact force law looks the same in every figure: as its place in bearing/law_table.hpp has it.
[[nodiscard]] Look look_of_law(const std::string& law);
/// So does a solver: bench.json gives each its number, from 1.
[[nodiscard]] Look look_of_solver(const View& bench, const std::string& solver);
/// The k-th of other curves, from 0. Twelve looks, then the first again.
[[nodiscard]] Look look_of_curve(std::size_t k);

}  // namespace ehd::report
