// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solution.hpp"

namespace ehd {

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::converged: return "converged";
    case StopReason::tolerance_not_met: return "tolerance-not-met";
    case StopReason::under_resolved: return "under-resolved";
    case StopReason::limit_reached: return "limit-reached";
    case StopReason::diverged: return "diverged";
  }
  return "";
}

}  // namespace ehd
