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
  table.caption = "Everything on this page";
  table.columns = {"what", "to how many digits", "by which truth", "at which cost", "what is not verified"};
  for (const Verified& one : verified) {
    std::string open;
    if (!one.wrong.empty())
      open = "<b class=\"fail\">" + std::to_string(one.wrong.size()) + " not as it should be: see above</b>";
    for (const std::string& text : one.open) open += (open.empty() ? "" : "; ") + text;
    table.rows.push_back({{one.what, ""}, {one.digits, ""}, {one.truth, ""}, {one.cost, ""}, {open, ""}});
  }
  page.add(table);
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
  std::string verdict = claims.empty()  ? "<b>No claim was judged.</b> "
                        : !all_stand    ? "<b>Not every claim stands.</b> "
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
  page.paragraph(verdict, all_stand && wrong.empty() ? "verdict pass" : "verdict fail");
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
