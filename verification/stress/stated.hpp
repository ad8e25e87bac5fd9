// SPDX-License-Identifier: GPL-3.0-or-later
// A stated contact with every number of its statement by name: part (e) moves these numbers, part (g) replaces them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/nondimensional.hpp"
#include "verification/studies/box.hpp"

namespace ehd::verification::stress {

struct Stated {
  Statement statement;
  Lubricant lubricant = {};
  double inlet = usual_cut;  ///< X of the cut

  [[nodiscard]] bool in_SI() const { return std::holds_alternative<Conditions>(statement); }
  [[nodiscard]] Nondimensional made() const { return nondimensionalise(statement, lubricant, TruncatedAt{inlet}); }
};

struct Input {
  std::string name;
  std::function<double&(Stated&)> of;
};
/// Every number of the statement, the inlet, and those of the lubricant that its laws use.
[[nodiscard]] std::vector<Input> inputs_of(const Stated& stated);

/// An ordinary contact in SI: M = 8.8, p_H = 0.59 GPa, and L = 8.5 at alpha = 1.7e-8 1/Pa.
[[nodiscard]] Conditions ordinary_conditions();

}  // namespace ehd::verification::stress
