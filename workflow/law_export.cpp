// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/law_export.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "bearing/dynamics.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/known_oil.hpp"

namespace ehd {

namespace {

/// The table begins at this part of the lightest contact force of the balance: rollers of a rotor unload further.
constexpr double below_the_balance = 0.5;

/// The raceway's contacts in slow motion.
struct SlowMotion {
  std::function<bearing::ContactMotion(double force_N)> at = {};  ///< empty where there are no responses
  std::string why_not = {};
};

SlowMotion slow_motion(const bearing::CurveLaw& law, const Lubricant& lubricant, ContactMemory& memory) {
  const bearing::FilmCurve& curve = law.curve();
  const auto& made = memory.response_curve(curve.contact(), lubricant,
                                           {.lightest_N = curve.lightest_N(), .heaviest_N = curve.heaviest_N()});
  if (const auto* failure = std::get_if<bearing::SolveFailure>(&made)) return {.why_not = failure->why};
  const auto* response = &std::get<bearing::ResponseCurve>(made);
  return {.at = [response, datum_m = law.datum_m()](double force_N) {
    return contact_motion(response->contact(), force_N, datum_m, 0, response->slow(force_N));
  }};
}

bearing::DampingOverForce damping_of(const SlowMotion& motion) {
  if (!motion.at) return {};
  return [&motion](double force_N) { return *motion.at(force_N).damping_N_s_per_m; };
}

/// The law's own errors, the largest at the knots of its table.
void state_errors(LawExport& made, const bearing::FilmCurve& curve, const SlowMotion& motion) {
  const bearing::CurveErrors& errors = curve.errors();
  double film_part = 0;
  for (std::size_t k = 0; k < made.table.force_N.values.size(); ++k) {
    const double force_N = made.table.force_N.values[k], stiffness = made.table.force_N.slopes[k];
    film_part = std::max(film_part, curve.film_part(force_N));
    double stiffness_error = bearing::force_error_by_datum * curve.compliance_error(force_N);
    if (motion.at) {
      const bearing::ContactMotion slow = motion.at(force_N);
      const double apart = std::abs(stiffness - slow.stiffness_N_per_m);  // the same number, found in another way
      stiffness_error = std::min(stiffness_error, (apart + slow.stiffness_error) / stiffness);
      made.damping_error =
          std::max(made.damping_error.value_or(0), slow.damping_error / std::abs(*slow.damping_N_s_per_m));
    }
    made.stiffness_error = std::max(made.stiffness_error, stiffness_error);
  }
  made.force_error = bearing::force_error_by_datum *
                     (std::max(errors.interpolation_force, errors.joint_force) + errors.solver_offset_film * film_part);
  made.film_error = std::max(errors.interpolation, errors.joint) + errors.solver_minimum_film;
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
  const SlowMotion motion = slow_motion(law, stated, memory);
  made.table = bearing::tabulate(law, made.lightest_N, made.heaviest_N, request.knots, damping_of(motion));
  state_errors(made, law.curve(), motion);
  made.no_damping = motion.why_not;
  made.status = result.status;
  made.why = result.why;
  return made;
}

}  // namespace ehd
