// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of the first table about the bearing: balances, small motion, the paper's statements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "verification/report/bearing_tables.hpp"
#include "verification/report/overview.hpp"

namespace ehd::report {

Verified bearing_verified(const View& figures) {
  const auto bearings = figures.list("bearing");
  if (bearings.empty()) return absent_part("bearing", "Load distributions");
  std::vector<std::pair<std::string, Extent>> laws;
  std::size_t open = 0;
  for (const View& bearing : bearings) {
    for (const View& law : bearing.list("laws")) {
      const std::string name = law.text("law");
      auto known = std::find_if(laws.begin(), laws.end(), [&](const auto& one) { return one.first == name; });
      if (known == laws.end()) known = laws.insert(laws.end(), {name, {}});
      if (!law.text("status").empty() && law.text("status") != "converged") ++open;
      const auto errors = errors_of_balance(law);
      if (const auto displacement = law.number("displacement_m"); errors && displacement && *displacement != 0)
        known->second.add(digits_of(errors->displacement_m / std::abs(*displacement)));
    }
  }
  Verified row{.what = section_link("bearing", how_many(bearings.size(), "bearing", "bearings") + " under " +
                                                   how_many(laws.size(), "law", "laws")) +
                       ": the displacement of the ring",
               .truth = "the error budget of each law; claims of rung 11 judge balance, symmetry and energy",
               .cost = cost_of(figures, "bearing")};
  std::string without;
  for (const auto& [name, digits] : laws) {
    std::string& text = digits.any() ? row.digits : without;
    text += (text.empty() ? "" : digits.any() ? "; " : ", ") + ("<code>" + escaped(name) + "</code>");
    if (digits.any()) text += ": " + digits_in(digits, row.digits.find(':') == std::string::npos);
  }
  if (!without.empty()) row.open.push_back("no error is stated of " + without);
  if (open > 0) row.open.push_back(how_many(open, "balance", "balances") + " not converged");
  row.open.push_back("the datum <i>x</i><sub>0</sub>: a choice, its effect is in the budget");
  if (!figures.list("force_law").empty())
    row.open.push_back("curves of the contact force laws: shown, not judged here");
  return row;
}

Verified statements_verified(const View& figures) {
  const auto statements = figures.list("statements");
  if (statements.empty()) return absent_part("bearing", "The paper's statements");
  const auto false_ones = static_cast<std::size_t>(std::count_if(
      statements.begin(), statements.end(), [](const View& one) { return !one.flag("holds").value_or(true); }));
  Verified row{
      .what = section_link("statements", how_many(statements.size(), "statement", "statements") + " of the paper"),
      .digits = fmt::format("{} hold as computed, {} not", statements.size() - false_ones, false_ones),
      .truth = "the balances of the bearings above",
      .cost = "in the time of these balances"};
  if (const auto choices = figures["statement_study"].list("rows").size(); choices > 0)
    row.open.push_back("which choice the paper made where it leaves one open: " +
                       how_many(choices, "choice is", "choices are") + " compared");
  return row;
}

Verified dynamics_verified(const View& figures) {
  const auto bearings = figures.list("dynamics");
  if (bearings.empty()) return absent_part("bearing", "Bearings in small motion");
  Verified row{.what = section_link("bearing", how_many(bearings.size(), "bearing", "bearings") + " in small motion") +
                       ": the ring over the frequency",
               .truth =
                   "the errors that the computation states; claims of the rungs 6, 8 and 9 judge derivatives, "
                   "causality, small steps in time and limits",
               .cost = cost_of(figures, "dynamics")};
  for (const char* quantity : {"stiffness", "damping"}) {
    Extent digits;
    for (const View& bearing : bearings)
      for (const double error : bearing["ring"].numbers(quantity + std::string("_error"))) digits.add(digits_of(error));
    if (digits.any()) row.digits += (row.digits.empty() ? "" : "; ") + (quantity + (": " + digits_in(digits)));
  }
  if (row.digits.empty()) row.open.push_back("errors of stiffness and damping: not in this folder");
  if (std::any_of(bearings.begin(), bearings.end(), [](const View& one) { return one.has("contacts"); }))
    row.open.push_back("single contacts, and the ring over clearance and speed: shown without an error");
  return row;
}

}  // namespace ehd::report
