// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/bearing_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "bearing/force_law.hpp"
#include "bearing/geometry.hpp"
#include "bearing/plane.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd {

using bearing::FilmCurve;

namespace {

/// The thinnest film of a balance, with its contact.
struct Thinnest {
  double film_m = 0, force_N = 0;
  bool inner = true;
};
std::optional<Thinnest> thinnest_film(const BearingResult& result) {
  std::optional<Thinnest> thinnest;
  for (const RollerRow& row : result.rollers)
    for (const ContactRow* at : {&row.inner, &row.outer})
      if (at->film_minimum_m && (!thinnest || *at->film_minimum_m < thinnest->film_m))
        thinnest = Thinnest{*at->film_minimum_m, at->force_N, at == &row.inner};
  return thinnest;
}

/// A balance linearised with the rollers' exact stiffnesses: how errors of the contacts' approaches change it.
class Linearised {
 public:
  Linearised(const BearingResult& result, const bearing::ForceLaw& inner, const bearing::ForceLaw& outer)
      : result_(result) {
    bearing::Symmetric2 ring;
    std::vector<double> azimuths_deg;
    for (const RollerRow& row : result.rollers) {
      azimuths_deg.push_back(row.azimuth_deg);
      const double psi = row.azimuth_deg * std::numbers::pi / 180;
      const bool across = result.form != bearing::Form::radial;
      Roller roller{.direction = {std::cos(psi), across ? std::sin(psi) : 0}};
      if (row.inner.force_N > 0 && row.outer.force_N > 0)
        roller.stiffness =
            1 / (bearing::compliance(inner, row.inner.force_N) + bearing::compliance(outer, row.outer.force_N));
      ring.add(roller.stiffness, roller.direction);
      rollers_.push_back(roller);
    }
    symmetric_ = bearing::symmetric_to_load(azimuths_deg);
    const bearing::Symmetric2 inverse = bearing::pseudo_inverse(ring);  // few loaded rollers leave y free
    for (Roller& roller : rollers_) roller.moves_ring = roller.stiffness * (inverse * roller.direction);
  }

  /// `error_m`: bound of the approach's error at a contact, from (force, inner raceway).
  [[nodiscard]] BudgetRow bound(const std::function<double(double, bool)>& error_m) const {
    std::vector<double> off_m;
    for (std::size_t j = 0; j < rollers_.size(); ++j) {
      const RollerRow& row = result_.rollers[j];
      const bool carries = rollers_[j].stiffness > 0;
      off_m.push_back(carries ? error_m(row.inner.force_N, true) + error_m(row.outer.force_N, false) : 0);
    }
    BudgetRow row;
    row.bound = true;
    const std::size_t top = most_loaded(result_);
    for (std::size_t i = 0; i < rollers_.size(); ++i) {
      row.displacement_m += std::abs(rollers_[i].moves_ring.x) * off_m[i];
      if (!symmetric_) row.displacement_lateral_m += std::abs(rollers_[i].moves_ring.y) * off_m[i];
      double size_N = 0;  // Sum |df_i/dg_j| g_j
      for (std::size_t j = 0; j < rollers_.size(); ++j) {
        const double gives = dot(rollers_[i].direction, rollers_[j].moves_ring) - (i == j ? 1 : 0);
        size_N += std::abs(rollers_[i].stiffness * gives) * off_m[j];
      }
      if (i == top) row.largest_force_N = size_N;
      row.any_force_N = std::isfinite(size_N) ? std::max(row.any_force_N, size_N) : infinity;
    }
    return row;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Roller {
    bearing::Vector2 direction = {};   ///< n; in the radial form its part across the load is 0
    double stiffness = 0;              ///< k [N/m]; 0 where the roller is unloaded
    bearing::Vector2 moves_ring = {};  ///< du/dg of this roller's approach
  };
  const BearingResult& result_;
  std::vector<Roller> rollers_;
  bool symmetric_ = true;  ///< to the load
};

/// How far solver errors at the fitted contacts move the result.
BudgetRow bound_of_line(const BearingCase& body, const BearingResult& line) {
  const auto laws = laws_of(body, line);
  if (!laws) return {};
  return Linearised(line, laws->inner, laws->outer).bound([&](double f, bool at_inner) {
    return (at_inner ? line.fit->inner : line.fit->outer).approach_error_m(f);
  });
}

}  // namespace

void BudgetRow::meet(const BudgetRow& other) {
  displacement_m = std::max(displacement_m, other.displacement_m);
  displacement_lateral_m = std::max(displacement_lateral_m, other.displacement_lateral_m);
  largest_force_N = std::max(largest_force_N, other.largest_force_N);
  any_force_N = std::max(any_force_N, other.any_force_N);
}

BudgetRow difference(const BearingResult& other, const BearingResult& result) {
  BudgetRow row;
  row.displacement_m = std::abs(other.displacement_m - result.displacement_m);
  row.displacement_lateral_m = std::abs(other.displacement_lateral_m - result.displacement_lateral_m);
  const std::size_t top = most_loaded(result);
  for (std::size_t j = 0; j < other.rollers.size() && j < result.rollers.size(); ++j) {
    const double change = std::abs(other.rollers[j].inner.force_N - result.rollers[j].inner.force_N);
    row.any_force_N = std::max(row.any_force_N, change);
    if (j == top) row.largest_force_N = change;
  }
  const auto film = thinnest_film(result), other_film = thinnest_film(other);
  if (film && other_film) row.smallest_film = std::abs(other_film->film_m / film->film_m - 1);
  return row;
}

std::vector<BudgetRow> numerical_budget(const BearingCase& body, const BearingResult& result,
                                        const BearingResult& full) {
  if (!needs_film(result.law) || result.rollers.empty() || !result.curve || !result.datum_m) return {};
  const bool fitted = result.law == bearing::Law::ehd_linear;
  if ((fitted && !result.fit) || full.rollers.empty() || !full.curve) return {};
  const auto laws = laws_of(body, full);
  if (!laws) return {};
  std::vector<BudgetRow> rows;
  const auto add = [&rows](BudgetRow row, std::string source, std::string of) {
    row.source = std::move(source);
    row.of = std::move(of);
    rows.push_back(std::move(row));
  };

  if (fitted) add(difference(full, result), "fit", "ehd-linear against ehd");

  // Bounds of the full relation's errors. Films are those of the law's own balance.
  const std::string whose = fitted ? ", law ehd" : "";
  const auto thinnest = thinnest_film(result);
  const Linearised linear(full, laws->inner, laws->outer);
  const auto curve_of = [&](bool at_inner) -> const FilmCurve& {
    return at_inner ? full.curve->inner : full.curve->outer;
  };
  BudgetRow between = linear.bound([&](double f, bool at_inner) {
    const FilmCurve& curve = curve_of(at_inner);
    return f >= curve.lightest_N() ? curve.errors().interpolation_force * curve.rise_m(f) : 0;
  });
  BudgetRow below = linear.bound([&](double f, bool at_inner) {
    const FilmCurve& curve = curve_of(at_inner);
    return f < curve.lightest_N() ? curve.errors().joint_force * curve.rise_m(f) : 0;
  });
  BudgetRow solver = linear.bound([&](double f, bool at_inner) {
    const FilmCurve& curve = curve_of(at_inner);
    return curve.errors().solver_offset_film * curve.offset_film(f).value;
  });
  if (fitted) solver.meet(bound_of_line(body, result));
  if (thinnest) {
    const FilmCurve& curve = curve_of(thinnest->inner);
    (thinnest->force_N >= curve.lightest_N() ? between : below).smallest_film =
        thinnest->force_N >= curve.lightest_N() ? curve.errors().interpolation : curve.errors().joint;
    solver.smallest_film = curve.errors().solver_minimum_film;
  }
  add(std::move(between), "interpolation", "extra solves at every contact" + whose);
  add(std::move(below), "rigid limit", "below the lightest solve" + whose);
  add(std::move(solver), "contact solver",
      fitted ? "its stated errors, ehd and the fit" : "its stated errors, every contact");
  return rows;
}

std::optional<BearingErrors> sum_of(const std::vector<BudgetRow>& rows) {
  if (rows.empty()) return std::nullopt;
  BearingErrors sum;
  for (const BudgetRow& row : rows) {
    sum.displacement_m += row.displacement_m;
    sum.displacement_lateral_m += row.displacement_lateral_m;
    sum.largest_force_N += row.largest_force_N;
    sum.any_force_N += row.any_force_N;
    if (row.smallest_film) sum.smallest_film = sum.smallest_film.value_or(0) + *row.smallest_film;
  }
  const double all = sum.displacement_m + sum.displacement_lateral_m + sum.largest_force_N + sum.any_force_N +
                     sum.smallest_film.value_or(0);
  return std::isfinite(all) ? std::optional(sum) : std::nullopt;
}

}  // namespace ehd
