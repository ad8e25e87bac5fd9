// SPDX-License-Identifier: GPL-3.0-or-later
// The result of one contact as JSON: the object that `ehd solve --json` writes.
#pragma once

#include <optional>
#include <string_view>

#include "io/json.hpp"
#include "workflow/contact_run.hpp"

namespace ehd {

/// The result object of `ehd solve`. Numbers are finite; a quantity that is unknown or was not requested is absent.
[[nodiscard]] Json to_json(const ContactRun& run);
/// One entry of that object alone, {"hertz": ...} for "film.minimum". Empty where no observed quantity has it.
[[nodiscard]] std::optional<Json> observable_json(const ContactRun& run, std::string_view entry);
[[nodiscard]] Json to_json(const Plan& plan);
/// Groups and scales, as far as they are known.
[[nodiscard]] Json groups_json(const std::optional<Groups>& known, const std::optional<Scales>& scales);
/// The oil by its grade: what was stated, and eta_0, density and alpha that followed.
[[nodiscard]] Json to_json(const GradedOil& oil);

/// The oil's laws, with the constants that they use.
[[nodiscard]] Json to_json(const Lubricant& lubricant);

/// The status of a result, read back. Empty for any other word.
[[nodiscard]] std::optional<StopReason> stop_reason_from(std::string_view text);

}  // namespace ehd
