// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of a submitted profile: does it meet the equations of the line contact, whatever its films are? They are passed
// or failed, and rank nobody.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "contact/array.hpp"
#include "verification/tolerance.hpp"

namespace ehd::judging {

/// Nodes in Hertz units: X = x/b increases, P = p/p_H, H = h R/b^2.
struct SubmittedProfile {
  Array X, P, H;
  bool cut = false;  ///< somewhere P is shown up to a limit only: column P_unresolved, as `ehd solve --profile` has it
};

/// A CSV with the columns X, P, H (further ones are left out), 16 to 100000 rows. Throws CaseError: X that does not
/// increase, a number that is not finite, a missing column.
[[nodiscard]] SubmittedProfile read_profile(const std::filesystem::path& file);

struct Gate {
  std::string name;        ///< "load balance"
  std::string quadrature;  ///< how it was computed
  double error = 0;
  double uncertainty = 0;  ///< of the quadrature: what half of the nodes would change
  verification::Tolerance tolerance;
  verification::Verdict verdict;
};

/// Load balance, film equation and P >= 0. The quadratures are of second order where the pressure is smooth. A scheme
/// of first order or higher may have another quadrature; what halving the grid changes bounds the difference. The
/// tolerance is twice that change plus the stated error, which counts as 1e-3 where it is smaller or absent.
/// Inconclusive: a profile with a tolerance above 0.1, which is too coarse to pass, and one that is cut, which says too
/// little to fail. The film equation is judged relative to the film; in a dry contact, which has none, in Hertz units.
[[nodiscard]] std::vector<Gate> gates_of(const SubmittedProfile& profile, double stated_error, bool dry = false);

}  // namespace ehd::judging
