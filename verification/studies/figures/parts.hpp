// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of figures, a file each: pieces of work that run side by side, and a last step that collects their results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "workflow/case.hpp"

namespace ehd::verification {

struct FigurePiece {
  std::string name;
  std::function<void()> run;  ///< writes to a place of its own
};

struct FigurePart {
  std::string name;  ///< of its first key
  std::vector<FigurePiece> work = {};
  std::function<void(Json& figures)> finish = [](Json&) {};  ///< after all work; adds no key where there is nothing
};

/// "cases": pressure and film by the certified and the default solver at 1e-4, for every lubricated contact in the list
/// that does not wait for its parameters. `quick`: none with M above 60.
[[nodiscard]] FigurePart profile_part(const std::vector<Case>& cases, bool quick);
/// "convergence": `manufactured` solutions, and `grids` against the certified digits of cases.
[[nodiscard]] FigurePart convergence_part(bool manufactured, bool grids, bool quick);
/// "maps": the atlas in `folder` (nothing where there is none), with the default solver at 1e-4 at each flooded point.
/// `quick`: at a few of them.
[[nodiscard]] FigurePart map_part(const std::filesystem::path& folder, bool quick);
/// "bearing", "force_law", and with three clearances of one bearing "statements" and "statement_study".
[[nodiscard]] FigurePart bearing_part(const std::vector<Case>& cases);
/// "dynamics": the first case in small motion. `quick`: nothing, since the responses take half a minute.
[[nodiscard]] FigurePart dynamics_part(const std::vector<Case>& cases, bool quick);

}  // namespace ehd::verification
