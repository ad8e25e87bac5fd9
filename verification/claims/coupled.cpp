// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 5: the coupled equations against a solution that is known. No solver takes source terms, so that none can be
// manufactured, and the row says so. What stands in its place: the solvers against each other over the whole box
// (6), on one and the same discrete problem (7) and over grids (8), and the limits that are known (9).
#include "verification/claims/topics.hpp"

namespace ehd::verification {

std::vector<Topic> coupled_topics() {
  return {{.name = "manufactured solutions",
           .rungs = {5},
           .judge = [] {
             return Findings{.claims = {},
                             .skipped = {{{.id = "coupled/manufactured",
                                           .rung = 5,
                                           .statement = "the solvers reach a manufactured solution of the coupled "
                                                        "equations at their declared order"},
                                          "no solver takes the source terms that a manufactured solution needs; rungs "
                                          "7, 8 and 9 judge the coupled equations"}}};
           }}};
}

}  // namespace ehd::verification
