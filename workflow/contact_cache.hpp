// SPDX-License-Identifier: GPL-3.0-or-later
// The solved contacts of raceways, remembered.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <variant>

#include "bearing/build_curve.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/solved_contacts.hpp"
#include "contact/conditions.hpp"
#include "contact/solver.hpp"

namespace ehd {

using ContactSolver = std::function<Solution(const Problem&, const Request&)>;

/// The solved contacts of every raceway seen so far. A contact that agrees in radius, length, modulus, speed and
/// lubricant is solved once, whichever law or case asks.
class ContactMemory {
 public:
  explicit ContactMemory(ContactSolver solver, Request request = bearing_request());

  [[nodiscard]] bearing::SolvedContacts& of(const bearing::RacewayContact& contact, const Lubricant& lubricant);
  /// The raceway's curve, built once for all laws, clearances and cases that need the same.
  [[nodiscard]] const std::variant<bearing::FilmCurve, bearing::SolveFailure>& curve(
      const bearing::RacewayContact& contact, const Lubricant& lubricant, const bearing::CurveRequest& request);
  [[nodiscard]] long solves() const;   ///< calls of the solver
  [[nodiscard]] long recalls() const;  ///< contacts taken from memory

  /// Film tolerance 1e-4: an offset film to that accuracy moves a contact force by a few parts in 1e5.
  [[nodiscard]] static Request bearing_request();

 private:
  using Key = std::tuple<bearing::RacewayContact, ViscosityLaw, DensityLaw, std::optional<double>,
                         std::optional<double>, double>;
  ContactSolver solver_;
  Request request_;
  struct Raceway {
    std::unique_ptr<bearing::SolvedContacts> contacts;
    std::map<bearing::CurveRequest, std::variant<bearing::FilmCurve, bearing::SolveFailure>> curves;
  };
  [[nodiscard]] Raceway& raceway(const bearing::RacewayContact& contact, const Lubricant& lubricant);
  std::map<Key, Raceway> raceways_;
  long curve_recalls_ = 0;
};

}  // namespace ehd
