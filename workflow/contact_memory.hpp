// SPDX-License-Identifier: GPL-3.0-or-later
// The raceway contacts and film curves that a run of bearings has used, and how many of them it solved.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <variant>

#include "bearing/build_curve.hpp"
#include "bearing/film_curve.hpp"
#include "bearing/response_curve.hpp"
#include "bearing/solved_contacts.hpp"
#include "contact/conditions.hpp"
#include "contact/solver.hpp"
#include "workflow/bearing_contact.hpp"
#include "workflow/bearing_response.hpp"
#include "workflow/contact_cache.hpp"

namespace ehd {

/// The raceways of a run. Raceways that agree in radius, length, modulus, speed and lubricant share contacts and
/// curves, whichever law or case asks. The ContactCache holds the solutions; this class holds the curves, and the loads
/// that this run has asked for. Not for several threads at once: each thread has its own memory, over one cache.
class ContactMemory {
 public:
  /// With a cache of its own. The solver gets its fallback here (bearing_contact.hpp).
  explicit ContactMemory(ContactSolver solver, Request request = bearing_contact_request());
  /// With a cache that others use too, of a solver with fallback.
  explicit ContactMemory(std::shared_ptr<ContactCache> cache, Request request = bearing_contact_request());
  /// From now on responses come from this solver, with this request. Before, they come from bearing_responder().
  void respond_by(ContactResponder responder, ResponseRequest request = bearing_response_request());

  /// The contact at a raceway. Its function counts solves and recalls here, so it must not outlive this memory.
  [[nodiscard]] bearing::SolvableContact of(const bearing::RacewayContact& contact, const Lubricant& lubricant);
  /// The raceway's curve, built once for all laws, clearances and cases that need the same.
  [[nodiscard]] const std::variant<bearing::FilmCurve, bearing::SolveFailure>& curve(
      const bearing::RacewayContact& contact, const Lubricant& lubricant, const bearing::CurveRequest& request);
  /// The responses of the raceway's contacts over the force, built once for all that need the same. From the fifth set
  /// of forces to read on, the curve goes through all loads, which is then as cheap.
  [[nodiscard]] const std::variant<bearing::ResponseCurve, bearing::SolveFailure>& response_curve(
      const bearing::RacewayContact& contact, const Lubricant& lubricant, const bearing::ResponseCurveRequest& request);
  /// Responses that this run solved.
  [[nodiscard]] long responses() const { return responses_; }
  /// Contacts that this run asked for the first time. Another run may have solved them in a shared cache.
  [[nodiscard]] long solves() const { return solves_; }
  /// Contacts that this run asked for again; a curve used again counts all its points.
  [[nodiscard]] long recalls() const { return recalls_; }

 private:
  using Key = std::tuple<bearing::RacewayContact, ViscosityLaw, DensityLaw, std::optional<double>,
                         std::optional<double>, double>;
  struct Raceway {
    std::set<double> loads_N_per_m;
    std::map<bearing::CurveRequest, std::variant<bearing::FilmCurve, bearing::SolveFailure>> curves;
    std::map<bearing::ResponseCurveRequest, std::variant<bearing::ResponseCurve, bearing::SolveFailure>> responses;
  };
  [[nodiscard]] static Key key_of(const bearing::RacewayContact& contact, const Lubricant& lubricant);

  std::shared_ptr<ContactCache> cache_;
  Request request_;
  std::map<Key, Raceway> raceways_;
  ContactResponder responder_ = bearing_responder();
  ResponseRequest response_request_ = bearing_response_request();
  long solves_ = 0, recalls_ = 0, responses_ = 0;
};

}  // namespace ehd
