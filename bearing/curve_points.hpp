// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts that are solved for a film curve, and how far a curve is from them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include "bearing/film_curve.hpp"
#include "bearing/solved_contacts.hpp"

namespace ehd::bearing {

/// How far a curve is from a solved contact, relative.
struct Disagreement {
  double force = 0;                ///< of the contact force at the solved approach
  double offset = 0, minimum = 0;  ///< |ln(curve/solved)| of the films
  double rolling = 0;              ///< and of the rolling force, where both have it

  [[nodiscard]] double film() const { return std::max(offset, minimum); }
};

/// The solved contacts that a curve may be made of. The contacts must outlive them.
class CurvePoints {
 public:
  explicit CurvePoints(const SolvableContact& contacts) : contacts_(contacts) {}

  /// Solves a contact and keeps it, or says why it cannot.
  [[nodiscard]] std::optional<SolveFailure> add(double force_N);
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool has(double force_N) const { return points_.contains(force_N); }

  /// Puts what the solver states of the contacts' own errors.
  void put_solver_errors(CurveErrors& errors) const;

  [[nodiscard]] FilmCurve curve(const std::set<double>& forces_N, CurveErrors errors = {}) const;

  /// How far a curve is from a contact that was solved at this force. The contact need not be one of the curve's
  /// points.
  [[nodiscard]] Disagreement disagreement(const FilmCurve& curve, double force_N) const;
  /// Bounds the curve's error at every load below its lightest point. `force_N`: a contact solved there. `with_it`: a
  /// curve through this contact too, which has a better slope at the joint. One film's error may be zero at this
  /// contact by chance. So the larger error of both films is used for both films and for the force.
  [[nodiscard]] Disagreement continuation(const FilmCurve& curve, const FilmCurve& with_it, double force_N) const;

 private:
  struct Films {
    double offset = 0, minimum = 0;
    std::optional<double> rolling;
  };
  [[nodiscard]] double off_rolling(const FilmCurve& curve, double force_N) const;

  const SolvableContact& contacts_;
  std::map<double, Films> points_;
  double solver_offset_film_ = 0, solver_minimum_film_ = 0, solver_rolling_ = 0;
  std::set<double> missed_N_;
};

}  // namespace ehd::bearing
