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
  /// Where P is shown up to a limit only: column P_unresolved, as `ehd solve --profile` has it. No entries: nowhere.
  ArrayOf<bool> cut = {};
};

/// A CSV with the columns X, P, H (further ones are left out), 16 to 100000 rows. Throws CaseError: X that does not
/// increase, a number that is not finite, a missing column.
[[nodiscard]] SubmittedProfile read_profile(const std::filesystem::path& file);

/// Some row says that P is cut, and shows the largest P of the profile.
[[nodiscard]] bool is_cut(const SubmittedProfile& profile);

inline constexpr const char* film_equation = "film equation";  ///< the name of that gate

struct Gate {
  std::string name;        ///< "load balance"
  std::string quadrature;  ///< how the error was computed; where there is nothing to judge: "no pressure to judge"
  bool judged = true;      ///< false: there is nothing to judge. Then the error stands as 1, the whole of it
  double error = 0;
  double uncertainty = 0;  ///< of the quadrature: what half of the nodes would change
  verification::Tolerance tolerance;
  verification::Verdict verdict;
};

/// Load balance, film equation and P >= 0. The quadratures are of second order where the pressure is smooth. A scheme
/// of first order or higher may have another quadrature; what halving the grid changes bounds the difference. The
/// tolerance is twice that change plus the stated error, which counts as 1e-3 where it is smaller or absent, and as 0.1
/// where it is larger. Inconclusive: a tolerance above 0.1, for a profile that is too coarse to pass; and a failure
/// that a cut explains. A cut row shows the largest P of the profile; other rows are not cut, whatever they say. Cut
/// rows may hold load that is missing, but they cannot take away load that is too much. With the missing load in them,
/// the film equation has to hold outside of them. The film equation is judged relative to the film; in a dry contact,
/// which has none, in Hertz units.
[[nodiscard]] std::vector<Gate> gates_of(const SubmittedProfile& submitted, double stated_error, bool dry = false);

}  // namespace ehd::judging
