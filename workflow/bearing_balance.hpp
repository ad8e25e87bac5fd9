// SPDX-License-Identifier: GPL-3.0-or-later
// The ring in balance on its rollers with given contact force laws, and the rows of the result.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bearing/equilibrium.hpp"
#include "bearing/force_law.hpp"
#include "bearing/geometry.hpp"
#include "bearing/solved_contacts.hpp"
#include "workflow/bearing_result.hpp"
#include "workflow/case.hpp"

namespace ehd {

/// There is no balance with a law; what() says why.
class LawFailure : public std::runtime_error {
 public:
  explicit LawFailure(const std::string& why) : std::runtime_error(why) {}
  explicit LawFailure(const bearing::SolveFailure& contact) : std::runtime_error(contact.why), limit_(contact.limit) {}
  /// A contact that the law needs ran out of iterations or time.
  [[nodiscard]] bool limit() const { return limit_; }

 private:
  bool limit_ = false;
};

/// The case in the types of bearing/, as every step of a run reads it. Refers to `body`.
struct BearingSetup {
  BearingSetup(const BearingCase& body, bearing::Form form, int cage_positions);

  const BearingCase& body;
  bearing::Form form;
  int cage_positions;  ///< BearingRequest::cage_positions
  bearing::BothRaceways<bearing::RacewayContact> contacts;
  bearing::Loading loading;
};

/// The balance at the case's own cage position, then those at the cage's further positions. Throws LawFailure.
[[nodiscard]] std::vector<bearing::Equilibrium> balance_all_positions(const BearingSetup& setup,
                                                                      const bearing::LawPair& laws);

/// The largest inner contact force [N] of the balance with the hertz law. Throws LawFailure.
[[nodiscard]] double largest_dry_force_N(const BearingSetup& setup);

/// Force, displacement and Hertz pressure of every contact.
[[nodiscard]] std::vector<RollerRow> rows_of(const BearingSetup& setup, const bearing::Equilibrium& ring);

/// Writes the ring, its rollers and the turn of the cage into the result of a law.
void fill_balance(BearingResult& result, const BearingSetup& setup, const std::vector<bearing::Equilibrium>& positions);

/// Notes what nondimensionalise remarks about the oil, at the mean load.
void note_oil(BearingResult& result, const BearingSetup& setup);

}  // namespace ehd
