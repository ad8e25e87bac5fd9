// SPDX-License-Identifier: GPL-3.0-or-later
// From a contact case to its result: case -> plan -> problem -> solver -> result. Here alone a case meets a solver.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/film_formulas.hpp"
#include "contact/nondimensional.hpp"
#include "contact/solution.hpp"
#include "workflow/case.hpp"
#include "workflow/contact_plan.hpp"
#include "workflow/plan.hpp"
#include "workflow/registry.hpp"

namespace ehd {

struct ContactRun {
  std::string case_id = {};  ///< empty for a contact stated on the command line
  int version = 0;
  std::string solver = {};  ///< empty where none ran (dry)
  Plan plan = {};
  std::optional<Groups> groups = {};  ///< absent for a dry contact
  std::optional<Scales> scales = {};  ///< absent where the statement fixes no pressure in Pa
  Solution solution = {};
  /// pressure.maximum and pressure.spike, where their heights are known and nobody wanted them. A profile or a figure
  /// asks whether they are known (shown_pressure.hpp).
  Observables peaks = {};
  std::vector<FilmFormula> formulas = {};
  std::vector<std::string> notes = {};
  std::optional<GradedOil> oil = {};  ///< where the case states its grade

  [[nodiscard]] StopReason status() const { return solution.record.status; }
  /// One Hertz unit of film in Moes units; absent for a dry contact.
  [[nodiscard]] std::optional<double> moes_per_hertz_film() const;
  /// One Hertz unit of film in metres; absent where the statement fixes no metres.
  [[nodiscard]] std::optional<double> m_per_hertz_film() const;
  /// One Hertz unit of a quantity in SI; absent where the statement leaves the scale open, and for SIScale::none.
  [[nodiscard]] std::optional<double> SI_per_hertz(SIScale scale) const;
  /// G = alpha E', absent where either is unknown (Scales has 0 where alpha is).
  [[nodiscard]] std::optional<double> known_G() const;
};

/// Plans and runs one contact; quantities outside `wanted` are neither computed nor returned, and only tolerances that
/// serve a wanted quantity hold (request_for in contact_plan.hpp). status() says how the solver ended. Throws
/// StatementError where the statement makes no problem (a case from read_case always makes one).
[[nodiscard]] ContactRun run_contact(const ContactCase& contact, const RegisteredSolver& solver, const Request& request,
                                     const Wanted& wanted = want_everything());

/// The same for a case with a contact in it, with its id and version.
[[nodiscard]] ContactRun run_contact(const Case& contact_case, const RegisteredSolver& solver, const Request& request,
                                     const Wanted& wanted = want_everything());

/// For a user who chose quantities: a note names each that the contact does not have, and a converged run in which a
/// chosen pressure is not known well enough ends as tolerance_not_met.
void require_chosen(const Wanted& chosen, ContactRun& run);

/// One observed number in the scaling of an expectation, for comparing the two.
struct Measured {
  double value = 0;
  std::optional<double> error = {};  ///< estimated by the solver, relative to |value|
};

/// Absent where the quantity was not observed, or where its scaling needs a scale that the statement leaves open.
[[nodiscard]] std::optional<Measured> measure(const ContactRun& run, const Expectation& expectation);

}  // namespace ehd
