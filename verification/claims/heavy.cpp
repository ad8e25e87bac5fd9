// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 6 and 8 beyond the box: loads M up to 1e6, where the film is down to 2e-8 of b^2/R. The default solver ends
// converged up to L = 100; where the certified solver takes seconds, up to L = 2, their films agree.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/solution_memory.hpp"
#include "verification/studies/box.hpp"
#include "workflow/registry.hpp"

namespace ehd::verification {

namespace {

constexpr double heavy_tolerance = 1e-3;
const std::vector<double> heavy_M{2e4, 5e4, 1e5, 3e5, 1e6};
const std::vector<double> heavy_L{0, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100};
constexpr double largest_compared_L = 2;

std::string heavy_id(double M) { return "heavy/" + plain(M); }

std::string contact_name(const BoxContact& contact) {
  return contact.name() + (contact.flooded() ? ", flooded" : ", cut at -4");
}

Findings judge_convergence(double M) {
  std::string unsolved;
  for (const BoxContact& contact : contacts_of({.M = {M}, .L = heavy_L})) {
    const Solution solution =
        remembered(default_solver().name).solve(contact.problem(), {.tolerance = heavy_tolerance});
    if (!converged(solution)) unsolved += fmt::format(" ({}: {})", contact_name(contact), how_it_ended(solution));
  }
  return {.claims = {claim_fact(
              {.id = heavy_id(M) + "/converged",
               .rung = 6,
               .statement = fmt::format(
                   "{} ends converged at 1e-3 for L = 0..100, both law sets, flooded and cut at -4, at M = {}",
                   default_solver().name, plain(M)),
               .solver = default_solver().name},
              unsolved.empty(), "the range of M and L that the case reader accepts",
              unsolved.empty() ? "" : "not at" + unsolved)},
          .skipped = {}};
}

Findings judge_agreement(double M) {
  const std::string &truth = certified_solver().name, &usual = default_solver().name;
  double worst = 0;  // disagreement over the sum of the stated errors
  std::string worst_at;
  for (const BoxContact& contact : contacts_of({.M = {M}, .L = heavy_L, .flooded = {true}})) {
    if (contact.moes.L > largest_compared_L) continue;
    const Solution reference = remembered(truth).solve(contact.problem(), {.tolerance = heavy_tolerance});
    const Solution fast = remembered(usual).solve(contact.problem(), {.tolerance = heavy_tolerance});
    for (const Quantity film : judged_films) {
      const Reading *const a = reading(reference, film), *const b = reading(fast, film);
      const double ratio = std::abs(value_of(b) / value_of(a) - 1) / (error_of(a) + error_of(b));
      if (worst = worse(worst, ratio); worst == ratio || std::isnan(ratio))
        worst_at = fmt::format("{}, {}", to_string(film), contact_name(contact));
    }
  }
  return {
      .claims = {claim({.id = heavy_id(M) + "/agreement",
                        .rung = 8,
                        .statement = fmt::format("the films of both solvers differ by less than the sum of their "
                                                 "stated errors for L = 0..2, flooded, at M = {}",
                                                 plain(M)),
                        .solver = truth + ", " + usual},
                       worst, 0, Tolerance::required(1, "disagreement over the sum of the stated errors"), worst_at)},
      .skipped = {}};
}

}  // namespace

std::vector<Topic> heavy_topics() {
  std::vector<Topic> topics;
  for (const double M : heavy_M) {
    topics.push_back(
        {.name = heavy_id(M), .rungs = {6}, .judge = [M] { return judge_convergence(M); }, .expected_s = 2});
    topics.push_back({.name = heavy_id(M) + ", both solvers",
                      .rungs = {8},
                      .slow = true,
                      .judge = [M] { return judge_agreement(M); },
                      .expected_s = 10});
  }
  return topics;
}

}  // namespace ehd::verification
