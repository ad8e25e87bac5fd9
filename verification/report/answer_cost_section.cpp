// SPDX-License-Identifier: GPL-3.0-or-later
// The results of `ehd bench`, continued: what each answer costs, in ms and in c.
#include <cmath>
#include <optional>
#include <string>

#include "verification/report/report.hpp"

namespace ehd::report {

void add_answer_cost(Page& page, const View& bench) {
  page.heading("Cost of an answer");
  const auto costs = bench.list("cost");
  if (costs.empty()) {
    page.absent("The cost of each answer is", "ehd bench --part cost --output DIR");
    return;
  }
  Table table;
  table.caption =
      "Processor time of one answer, of later solves in a process that runs; <i>c</i> is timed beside each row";
  table.columns = {"asked",     "of",          "answers",          "not converged", "contact solves",
                   "mean [ms]", "median [ms]", "95 % within [ms]", "slowest [ms]",  "mean [<i>c</i>]"};
  for (const View& one : costs) {
    const auto mean = one.number("mean_s"), c = one.number("c_s"), failed = one.number("not_converged");
    const std::string why = one.text("reason"), of = one.text("of") + (why.empty() ? "" : ": " + why);
    table.rows.push_back({{escaped(one.text("asked")), ""},
                          {escaped(of), ""},
                          integer_cell(one.number("number")),
                          {integer_cell(failed).html, failed.value_or(0) > 0 ? "number fail" : "number"},
                          integer_cell(one.number("contact_solves")),
                          milliseconds_cell(mean),
                          milliseconds_cell(one.number("median_s")),
                          milliseconds_cell(one.number("of_95_percent_s")),
                          milliseconds_cell(one.number("slowest_s")),
                          integer_cell(mean && c && *c > 0 ? std::optional(std::round(*mean / *c)) : std::nullopt)});
  }
  page.add(table);
}

}  // namespace ehd::report
