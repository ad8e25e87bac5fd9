// SPDX-License-Identifier: GPL-3.0-or-later
// The top of the page: a sentence about everything that is judged, and the table of what was verified.
#include <fmt/format.h>

#include <algorithm>

#include "io/duration.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

/// What, to how many digits, by which truth, at which cost, and what is not verified.
void add_overview(Page& page, const std::vector<Verified>& verified) {
  Table table;
  table.css = "overview";
  table.caption = "Everything on this page, a line a part";
  table.columns = {"what", "to how many digits", "by which truth", "at which cost", "what is not verified"};
  for (const Verified& one : verified) {
    std::string open;
    if (!one.wrong.empty())
      open = fmt::format("<b class=\"fail\">{} not as it should be: see above</b>", one.wrong.size());
    for (const std::string& text : one.open) open += (open.empty() ? "" : "; ") + text;
    table.rows.push_back({{one.what, ""}, {one.digits, ""}, {one.truth, ""}, {one.cost, ""}, {open, ""}});
  }
  page.add(table);
  page.paragraph(
      "Digits are decimal digits of a relative error, rounded down: 4 digits are an error of 10<sup>\u22124</sup>. The "
      "error is the difference from the truth named beside it, plus the error that this truth states of itself. \"At "
      "worst\" is the run with the fewest digits of that line, \"at best\" the one with the most. What is judged "
      "passes or fails as a claim or as a part of the stress; what is only shown stands in the last column.");
  page.paragraph(
      "Not verified anywhere on this page: that the equations describe an experiment. They know smooth, infinitely "
      "long "
      "contacts of linear elastic bodies with one temperature and a Newtonian lubricant.");
}

/// Everything that is judged on the page in one sentence. Counted from the claims themselves, not read from the
/// summary.
void add_headline(Page& page, const View& results, const std::vector<std::string>& wrong, std::size_t stress_parts) {
  const auto claims = results.list("claims");
  const View summary = results["summary"];
  const bool all_stand = !claims.empty() && std::all_of(claims.begin(), claims.end(), stands);
  const auto count = [&](const char* kind) {
    return std::to_string(
        std::count_if(claims.begin(), claims.end(), [&](const View& claim) { return claim.text("verdict") == kind; }));
  };
  const bool stopped = summary.flag("stopped").value_or(false) || summary.number("not_run").value_or(0) > 0;
  std::string verdict = claims.empty()  ? "<b>No claim was judged.</b> "
                        : !all_stand    ? "<b>Not every claim stands.</b> "
                        : stopped       ? "<b>The run was stopped; what was judged until then stands.</b> "
                        : wrong.empty() ? "<b>Every claim stands.</b> "
                                        : "<b>Every claim stands, but not everything on this page does.</b> ";
  verdict += fmt::format("{} pass, {} fail, {} inconclusive, {} skipped", count("pass"), count("fail"),
                         count("inconclusive"), results.list("skipped").size());
  if (summary.has("wall_s")) verdict += "; " + duration(*summary.number("wall_s"));
  if (summary.has("threads")) verdict += " on " + escaped(summary.cell("threads")) + " threads";
  if (summary.flag("quick").value_or(false)) verdict += "; the quick suite: slow topics are skipped";
  if (const auto selection = summary.text("selection"); !selection.empty())
    verdict += "; only <code>" + escaped(selection) + "</code>";
  verdict += ".";
  const char* const link = "of the <a href=\"#stress\">stress</a>";
  if (stress_parts > 0 && wrong.empty())
    verdict += stress_parts == 1 ? fmt::format(" The one part {} passes.", link)
                                 : fmt::format(" All {} parts {} pass.", stress_parts, link);
  for (const std::string& one : wrong) verdict += " " + one + ".";
  page.paragraph(verdict, all_stand && !stopped && wrong.empty() ? "verdict pass" : "verdict fail");
}

}  // namespace

void add_summary(Page& page, const View& results, const View& bench, const View& stress) {
  page.section("summary", "Summary");
  const auto verified = everything_verified(results, bench, stress);
  std::vector<std::string> wrong;
  for (const Verified& one : verified) wrong.insert(wrong.end(), one.wrong.begin(), one.wrong.end());
  add_headline(page, results, wrong, stress.list("parts").size());
  add_overview(page, verified);
}

}  // namespace ehd::report
