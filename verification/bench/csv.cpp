// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/csv.hpp"

#include "contact/text.hpp"

namespace ehd::verification {

std::string status_cell(const std::optional<StopReason>& status) {
  return status ? std::string(to_string(*status)) : "not-run";
}

std::string dash(const std::optional<double>& value, int digits) { return value ? plain(*value, digits) : "-"; }

}  // namespace ehd::verification
