// SPDX-License-Identifier: GPL-3.0-or-later
// The notes of a bearing result in words, as JSON and tables have them.
#pragma once

#include <string>
#include <vector>

#include "workflow/bearing_result.hpp"

namespace ehd {

/// A relative error with two digits; "not known" where it is not finite.
[[nodiscard]] std::string error_text(double error);

/// One line a note. The last one says which accuracy was missed, where one was.
[[nodiscard]] std::vector<std::string> notes_of(const BearingResult& result);
/// Those that a reader has to know before any number: that a line does not describe its contacts, that rollers overlap.
[[nodiscard]] std::vector<std::string> warnings_of(const BearingResult& result);
/// The others. Without `details`, notes on how a law was made (curves, range of the fit, variants) are left out.
[[nodiscard]] std::vector<std::string> remarks_of(const BearingResult& result, bool details);

}  // namespace ehd
