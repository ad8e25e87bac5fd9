// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/csv.hpp"

#include <cmath>

#include "contact/text.hpp"

namespace ehd::verification {

std::string csv_number(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? plain(*value, digits) : "";
}

std::string status_cell(const std::optional<StopReason>& status) {
  return status ? std::string(to_string(*status)) : "not-run";
}

std::string dash(const std::optional<double>& value, int digits) { return value ? plain(*value, digits) : "-"; }

}  // namespace ehd::verification
