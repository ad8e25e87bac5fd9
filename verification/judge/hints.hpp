// SPDX-License-Identifier: GPL-3.0-or-later
// What a wrong number looks like: the usual mistakes of unit and of name. A hint changes no score; it says where to
// look.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/profile.hpp"
#include "verification/judge/profile_gates.hpp"
#include "verification/judge/score.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

/// A number beside its certified one, both in Hertz units.
struct Compared {
  SubmittedNumber number;
  double value = 0;
  Certified certified;
  [[nodiscard]] double error() const { return relative_error(value, certified.value); }
};

/// Hints for the films of one case that are off by more than 2 %: another scaling than the one named, um for m, two
/// films swapped, the mean speed for the sum in a solve or in the unit of a Moes film. Several where the films cannot
/// tell these mistakes apart. Only for the speed of a solve is anything solved, and only where `may_solve`.
[[nodiscard]] std::vector<std::string> hints_for(const Case& contact_case, const CaseScales& scales,
                                                 const std::vector<Compared>& numbers, bool may_solve);

/// Whether some number is so far off that a hint is looked for.
[[nodiscard]] bool needs_hint(const std::vector<Compared>& numbers);

/// A film.minimum in Hertz units that a profile has to agree with.
struct FilmMinimum {
  double value = 0;
  bool submitted = true;  ///< false: nothing was submitted, and it is the certified one
};

/// Hints for the profile of a lubricated contact beside its gates: H in Moes' or Kostreva's scaling, with which the
/// film equation would pass; or a smallest H that differs from film.minimum by more than the film equation's tolerance
/// (2 % at least for the certified one) and twice what half of the nodes would change.
[[nodiscard]] std::vector<std::string> profile_hints(const SubmittedProfile& profile, const std::vector<Gate>& gates,
                                                     const CaseScales& scales, std::optional<FilmMinimum> film_minimum,
                                                     double stated_error);

/// A hint for a pressure that fits the certified one with X turned round. The gates cannot see that: elasticity is
/// symmetric. `error`: the distance (relative L2) of P as it stands.
[[nodiscard]] std::optional<std::string> mirror_hint(const SubmittedProfile& profile, const Profile& certified,
                                                     double error);

}  // namespace ehd::judging
