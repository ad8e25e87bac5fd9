// SPDX-License-Identifier: GPL-3.0-or-later
// From a contact case to its linear response: stiffness and damping in SI where the case states them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/nondimensional.hpp"
#include "contact/response.hpp"
#include "workflow/case.hpp"
#include "workflow/registry.hpp"

namespace ehd {

/// What turns numbers of a response into SI; only a contact that is stated in SI has them.
struct ResponseScales {
  double omega_per_Omega = 0;  ///< u_m/b [rad/s]
  double reduced_modulus_Pa = 0;
  double half_width_m = 0;
};

/// k + i omega c, per length of the contact. Errors are absolute, in the same units.
struct DynamicStiffness {
  double stiffness_N_per_m2 = 0, damping_N_s_per_m2 = 0;
  double stiffness_error = 0, damping_error = 0;
};

/// What a user asks for.
struct ResponseQuestion {
  ResponseRequest request = {};
  std::vector<double> frequencies_Hz = {};   ///< appended to the request's; needs a contact in SI
  std::optional<double> datum_m = {};        ///< x_0; b without it
  const RegisteredSolver* solver = nullptr;  ///< one that has a response; the default solver without it
};

struct ResponseRun {
  std::string case_id = {};
  int version = 0;
  std::string solver = {};
  Groups groups = {};
  std::optional<Scales> hertz = {};   ///< absent where the statement fixes no pressure in Pa
  std::optional<GradedOil> oil = {};  ///< where the case states its grade
  std::optional<ResponseScales> scales = {};
  std::optional<double> datum_m = {};
  Response response = {};
  std::vector<std::string> notes = {};

  [[nodiscard]] std::optional<double> frequency_Hz(double Omega) const;
  /// 1/(k + i omega c) = 4/(E' kappa) + (4/(pi E')) ln(x_0/b): the datum is a compliance in series. Absent without SI,
  /// and where there is no number.
  [[nodiscard]] std::optional<DynamicStiffness> dynamic_stiffness(const Stiffness& at) const;
  /// The same for slow motion.
  [[nodiscard]] std::optional<DynamicStiffness> at_rest() const;

 private:
  /// ln(x_0/b)/pi: what the datum adds to 1/kappa.
  [[nodiscard]] double datum_compliance() const;
  [[nodiscard]] DynamicStiffness in_SI(const Kappa& kappa) const;
};

/// The response of a contact with a film. Throws CaseError for a dry contact, and for frequencies in Hz or a
/// datum where the case states no speed in m/s.
[[nodiscard]] ResponseRun run_response(const Case& contact_case, const ResponseQuestion& question);

}  // namespace ehd
