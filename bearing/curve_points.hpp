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

  /// What the solver states of the contacts' own errors.
  void put_solver_errors(CurveErrors& errors) const;

  [[nodiscard]] FilmCurve curve(const std::set<double>& forces_N, CurveErrors errors = {}) const;

  /// Of a curve at a solved contact that the curve need not contain.
  [[nodiscard]] Disagreement disagreement(const FilmCurve& curve, double force_N) const;
  /// Of a curve below its lightest point, at any load, from the contact solved at `force_N` there. `with_it` is a curve
  /// through that contact too: it knows the exponent at the joint better. The error of one film may vanish where the
  /// contact was solved, that of the other then does not. So the larger counts for both, and for the force.
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
