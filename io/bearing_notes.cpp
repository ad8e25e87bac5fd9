// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bearing_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "contact/text.hpp"
#include "workflow/bearing_fit.hpp"
#include "workflow/bearing_plan.hpp"

namespace ehd {

namespace {

std::string source_of(const note::Datum& datum) {
  switch (datum.from) {
    case note::Datum::From::stated: return "x_0 given";
    case note::Datum::From::lundberg: return "lundberg, x_0 = l";
    case note::Datum::From::palmgren:
      return fmt::format("palmgren, the hertz law met at a contact force of {} N", plain(datum.met_at_N));
    case note::Datum::From::without_a_force:
      return "x_0 = l, since the dry rollers carry no force at which palmgren's law could be met";
  }
  return "";
}

/// "low to high", or the one where both read the same.
std::string range_text(const std::string& low, const std::string& high) {
  return low == high ? low : fmt::format("{} to {}", low, high);
}

/// "11 instead of 13"; "11 as without it" where both read the same.
std::string compared(const std::string& with, const std::string& without) {
  return with == without ? with + " as without it" : fmt::format("{} instead of {}", with, without);
}

/// A visit: a new note does not compile until it has words.
struct Words {
  const BearingResult& result;

  std::string operator()(const note::Datum& datum) const {
    return fmt::format("datum: {}; x_0 = {} (inner), {} (outer)", source_of(datum), millimetre(result.datum_m->inner),
                       millimetre(result.datum_m->outer));
  }
  std::string operator()(const note::UnreadDatum& unread) const {
    return fmt::format("datum.{} has no effect: the datum's law is {}, and only {} reads it", unread.key, unread.law,
                       unread.belongs_to);
  }
  std::string operator()(const note::PoorLine& poor) const {
    const bearing::LinearFit& fit = result.fit->at(poor.raceway);
    if (fit.misfit() <= bearing::largest_misfit) return poor_in_use(poor.raceway, fit);
    // The line misses points of its fit and contacts of the bearing. The larger of both misses is said.
    const bool worse_in_use = fit.in_use && fit.in_use->misfit() > fit.misfit();
    const double residual_N = worse_in_use ? fit.in_use->residual_N : fit.residual_N,
                 misfit = worse_in_use ? fit.in_use->misfit() : fit.misfit();
    return fmt::format(
        "the line does not describe its {} contacts: it misses them by up to {} N, {} of the heaviest force; K = {} "
        "+- {} N/m. Take the law ehd",
        to_string(poor.raceway), plain(residual_N, 3), percent(misfit, 2), plain(fit.K_N_per_m, 2),
        plain(fit.K_deviation_N_per_m, 2));
  }
  static std::string poor_in_use(bearing::Raceway raceway, const bearing::LinearFit& fit) {
    const bearing::LineInUse& use = *fit.in_use;
    const std::string loads = range_text(plain(use.lightest_N, 4), plain(use.heaviest_N, 4)) + " N";
    const std::string fitted =
        fmt::format("fitted from {} to {} N", plain(fit.points.front().force_N), plain(fit.points.back().force_N));
    if (std::isnan(use.residual_N))
      return fmt::format(
          "the line may not describe its {} contacts: they carry {}, it is {}, and no contact outside is solved. Take "
          "the law ehd",
          to_string(raceway), loads, fitted);
    return fmt::format(
        "the line does not describe its {} contacts: they carry {}, where it misses them by up to {} N, {} of the "
        "heaviest force; it is {}. Take the law ehd",
        to_string(raceway), loads, plain(use.residual_N, 3), percent(use.misfit(), 3), fitted);
  }
  std::string operator()(const note::LateralForce& lateral) const {
    return fmt::format(
        "radial form: the cage position is not symmetric to the load, and the ring, which moves along the load only, "
        "needs a lateral force of {} N",
        plain(lateral.force_N, 4));
  }
  std::string operator()(const note::RaisedFit& fit) const {
    return fmt::format(
        "fit raised to M = {} at the {} raceway: from {} N, where {} times the largest dry force would be {} N",
        plain(lightest_fit_M), to_string(fit.raceway), plain(fit.from_N, 4), plain(default_fit_from),
        plain(fit.unraised_N, 3));
  }
  std::string operator()(const note::OutsideFit& outside) const {
    const auto& points = result.fit->at(outside.raceway).points;
    return fmt::format("fit used outside its range: {} {} contacts carry {} N, fitted from {} to {} N",
                       outside.contacts, to_string(outside.raceway),
                       range_text(plain(outside.lightest_N, 4), plain(outside.heaviest_N, 4)),
                       plain(points.front().force_N), plain(points.back().force_N));
  }
  std::string operator()(const note::Curve& note) const {
    const bearing::FilmCurve& curve = result.curve->at(note.raceway);
    const bearing::CurveErrors& errors = curve.errors();
    return fmt::format(
        "{} curve: {} solved contacts from {} to {} N, relative errors of film and force: interpolation {}, {}; rigid "
        "limit below {}, {}; solver's own {} ({}); {} contacts lie below it",
        to_string(note.raceway), curve.forces_N().size(), plain(curve.lightest_N(), 4), plain(curve.heaviest_N(), 4),
        error_text(errors.interpolation), error_text(errors.interpolation_force), error_text(errors.joint),
        error_text(errors.joint_force), error_text(errors.solver_offset_film), errors.lightest_because,
        note.contacts_below);
  }
  std::string operator()(const note::Oil& oil) const { return oil.remark; }
  std::string operator()(const note::CutVariant& note) const {
    const VariantResult& cut = result.variants.front();
    return fmt::format(
        "variant {}: loaded rollers {}, force of roller 1 {}{}{}", cut.name,
        compared(std::to_string(loaded_rollers(cut.rollers)), std::to_string(loaded_rollers(result.rollers))),
        compared(plain(cut.rollers[0].inner.force_N) + " N", plain(result.rollers[0].inner.force_N) + " N"),
        note.on_jump ? "; the outermost sit on the jump of the law at delta = 0" : "",
        note.radial ? "; balanced in the radial form, since in the plane rollers stand on that jump" : "");
  }
  std::string operator()(const note::NoVariant& none) const {
    return fmt::format("variant {}: no balance, {}", bearing_stage::variant, none.why);
  }
  std::string operator()(const note::NoFilms& none) const { return "no films: " + none.why; }
  std::string operator()(const note::LineAlone& alone) const {
    return std::string("stiffness and torque: how far the line is off is not known") +
           (alone.ehd_failed ? ", because the law ehd has no balance" : " without the law ehd in the same run");
  }
  std::string operator()(const note::NoBudget& none) const {
    return "no error budget, and so no errors in brackets: " + none.why;
  }
  std::string operator()(const note::Dynamics& motion) const {
    if (!motion.damped)
      return fmt::format("dynamics: the law {} has no film that moves, so that its damping is unknown, not zero",
                         to_string(result.law));
    return "dynamics: small motion about the balance; left out are the turning and gyroscopic motion of rollers, the "
           "cage, and the passage of rollers through the load zone";
  }
  std::string operator()(const note::Torque&) const {
    return "rolling torque: of the isothermal films alone; oil that heats in the inlet lowers it. Sliding, cage, seals "
           "and churning are not in it. Compression of the oil costs no work";
  }
  std::string operator()(const note::Unusual& unusual) const { return sentence_of(unusual); }
  std::string operator()(const note::ThinFilm& thin) const {
    return fmt::format(
        "lambda ratio {} is below 1: the film is thinner than the roughness, but the surfaces are computed as smooth",
        plain(thin.lambda_ratio, 3));
  }
};

/// Whether a note is about how a law was made, and changes nothing in how its balance is read.
bool is_detail(const BearingNote& note) {
  return std::holds_alternative<note::Curve>(note) || std::holds_alternative<note::RaisedFit>(note) ||
         std::holds_alternative<note::OutsideFit>(note) || std::holds_alternative<note::CutVariant>(note) ||
         std::holds_alternative<note::NoVariant>(note);
}

bool is_warning(const BearingNote& note) {
  const auto* unusual = std::get_if<note::Unusual>(&note);
  return std::holds_alternative<note::PoorLine>(note) || (unusual && unusual->range->impossible);
}

template <class Wanted>
std::vector<std::string> texts_of(const BearingResult& result, const Wanted& wanted) {
  std::vector<std::string> texts;
  for (const BearingNote& note : result.notes)
    if (wanted(note)) texts.push_back(std::visit(Words{result}, note));
  return texts;
}

std::vector<std::string> with_reason(std::vector<std::string> texts, const BearingResult& result) {
  if (!result.rollers.empty() && !result.why.empty()) texts.push_back(result.why);
  return texts;
}

}  // namespace

std::string error_text(double error) { return std::isfinite(error) ? plain(error, 2) : "not known"; }

std::vector<std::string> notes_of(const BearingResult& result) {
  return with_reason(texts_of(result, [](const BearingNote&) { return true; }), result);
}

std::vector<std::string> warnings_of(const BearingResult& result) { return texts_of(result, is_warning); }

std::vector<std::string> remarks_of(const BearingResult& result, bool details) {
  const auto wanted = [&](const BearingNote& note) { return !is_warning(note) && (details || !is_detail(note)); };
  return with_reason(texts_of(result, wanted), result);
}

}  // namespace ehd
