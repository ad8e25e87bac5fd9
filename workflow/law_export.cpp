// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/law_export.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/dynamics.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/known_oil.hpp"

namespace ehd {

namespace {

/// The table begins at this part of the lightest contact force of the balance: rollers of a rotor unload further.
constexpr double below_the_balance = 0.5;

/// Damping of slow motion from the responses of the raceway's contacts.
struct Damping {
  bearing::DampingOverForce over_force = {};
  std::optional<double> error = {};
  std::string why_not = {};
};

Damping damping_of(const bearing::CurveLaw& law, const Lubricant& lubricant, double lightest_N, ContactMemory& memory) {
  const bearing::FilmCurve& curve = law.curve();
  const auto& made = memory.response_curve(curve.contact(), lubricant,
                                           {.lightest_N = curve.lightest_N(), .heaviest_N = curve.heaviest_N()});
  if (const auto* failure = std::get_if<bearing::SolveFailure>(&made)) return {.why_not = failure->why};
  const auto* response = &std::get<bearing::ResponseCurve>(made);
  const auto motion = [response, datum_m = law.datum_m()](double force_N) {
    return contact_motion(response->contact(), force_N, datum_m, 0, response->slow(force_N));
  };
  double error = 0;
  for (const double force_N : {lightest_N, curve.lightest_N(), curve.heaviest_N()}) {
    const bearing::ContactMotion at = motion(force_N);
    error = std::max(error, at.damping_error / std::abs(*at.damping_N_s_per_m));
  }
  return {.over_force = [motion](double force_N) { return *motion(force_N).damping_N_s_per_m; }, .error = error};
}

}  // namespace

LawExport export_law(const Case& bearing_case, const LawExportRequest& request, ContactMemory& memory) {
  const auto results = run_bearing(bearing_case, {.laws = {bearing::Law::ehd}, .explicitly = true}, memory);
  const BearingResult& result = results.at(0);
  if (result.rollers.empty()) throw LawFailure(result.why);
  const auto& body = std::get<BearingCase>(bearing_case.body);
  const bearing::LawPair laws = *laws_of(body, result);
  const auto& law = std::get<bearing::CurveLaw>(request.raceway == bearing::Raceway::inner ? laws.inner : laws.outer);
  LawExport made{.case_id = bearing_case.id,
                 .version = bearing_case.version,
                 .title = bearing_case.title,
                 .raceway = request.raceway,
                 .contact = law.curve().contact(),
                 .datum_m = law.datum_m()};
  made.balance_lightest_N = std::numeric_limits<double>::infinity();
  for (const RollerRow& roller : result.rollers) {
    made.balance_lightest_N = std::min(made.balance_lightest_N, roller.at(request.raceway).force_N);
    made.balance_heaviest_N = std::max(made.balance_heaviest_N, roller.at(request.raceway).force_N);
  }
  made.lightest_N = below_the_balance * made.balance_lightest_N;
  made.heaviest_N = law.curve().heaviest_N();
  const Lubricant& stated = body.lubricant->lubricant;
  made.lubricant = with_alpha_and_z(stated, made.contact.at(made.heaviest_N));
  const Damping damping = damping_of(law, stated, made.lightest_N, memory);
  made.table = bearing::tabulate(law, made.lightest_N, made.heaviest_N, request.knots, damping.over_force);
  const bearing::CurveErrors& errors = law.curve().errors();
  made.force_error = bearing::force_error_by_datum *
                     (std::max(errors.interpolation_force, errors.joint_force) + errors.solver_offset_film);
  made.film_error = std::max(errors.interpolation, errors.joint) + errors.solver_minimum_film;
  made.damping_error = damping.error;
  made.no_damping = damping.why_not;
  made.status = result.status;
  made.why = result.why;
  return made;
}

}  // namespace ehd
