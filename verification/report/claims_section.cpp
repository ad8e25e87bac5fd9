// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder, every claim with its numbers, and which claims support which statement.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

/// Where a claim stands in the table of all claims.
std::string claim_anchor(const std::string& id) { return "claim-" + slug(id); }

/// A claim's id, with possible line breaks after its slashes.
std::string identifier(const std::string& id) {
  std::string result = "<code>";
  for (const char c : escaped(id)) result += c == '/' ? std::string("/<wbr>") : std::string(1, c);
  return result + "</code>";
}

/// The same as a link to the claim.
std::string claim_link(const std::string& id) {
  return fmt::format("<a href=\"#{}\">{}</a>", claim_anchor(id), identifier(id));
}

std::string where(const View& claim) {
  std::string text = claim.text("case");
  if (!text.empty() && claim.has("version")) text += "@" + claim.cell("version");
  if (const auto solver = claim.text("solver"); !solver.empty()) text += (text.empty() ? "" : ", ") + solver;
  return text;
}

std::string tolerance_text(const View& claim) {
  const View tolerance = claim["tolerance"];
  const std::string basis = tolerance.text("basis"), reason = tolerance.text("reason");
  std::string text = tolerance.cell("value", 3);
  if (!basis.empty()) text += fmt::format(" ({}{})", basis, reason.empty() || reason == basis ? "" : ": " + reason);
  return text;
}

std::string numbers_of(const View& claim) {
  std::string text;
  if (claim.has("measured")) text += "measured " + claim.cell("measured", 10);
  if (claim.has("expected")) text += (text.empty() ? "" : ", ") + std::string("expected ") + claim.cell("expected", 10);
  if (claim.has("error")) text += (text.empty() ? "" : "; ") + std::string("error ") + claim.cell("error", 3);
  if (claim.number("uncertainty").value_or(0) > 0) text += " \u00b1 " + claim.cell("uncertainty", 2);
  return fmt::format("{}{}tolerance {}", text, text.empty() ? "" : "; ", tolerance_text(claim));
}

void add_claim_in_full(Page& page, const View& claim) {
  const std::string verdict = claim.text("verdict");
  std::string block = fmt::format("<div class=\"claim {}\"><p><b>{}</b>: {}</p>", slug(verdict), escaped(verdict),
                                  escaped(claim.text("statement")));
  block += fmt::format("<p>{}, rung {}", identifier(claim.text("id")), escaped(claim.cell("rung")));
  if (const auto of = where(claim); !of.empty()) block += ", " + escaped(of);
  block += "</p><p>" + escaped(numbers_of(claim)) + "</p>";
  if (const auto note = claim.text("note"); !note.empty()) block += "<p>" + escaped(note) + "</p>";
  if (const auto reason = claim.text("accepted"); !reason.empty())
    block += "<p>accepted as inconclusive: " + escaped(reason) + "</p>";
  page.add(block + "</div>\n");
}

/// Every claim as a point: how much of its tolerance error and uncertainty use.
void add_margins(Page& page, const std::vector<View>& claims) {
  constexpr double least = 1e-4;  // smaller values stand at the left edge
  struct Kind {
    const char* verdict;
    const char* name;
    Marker marker;
    int colour;
  };
  Figure figure{.id = "fig-margins",
                .title = "How much of each tolerance is used",
                .description =
                    "One mark a claim: error plus uncertainty over tolerance, logarithmic, by rung 0 to 11. Right of 1 "
                    "a claim does not stand.",
                .width = 480};
  Panel panel;
  panel.x = {.label = "(error + uncertainty) / tolerance", .scale = Scale::logarithmic, .low = least, .high = 4};
  panel.y = {.label = "rung", .low = -0.7, .high = 11.7, .step = 1, .downward = true};
  std::map<int, int> at_rung;
  for (const Kind& kind :
       {Kind{"pass", "pass", Marker::circle, 3}, Kind{"inconclusive", "inconclusive", Marker::triangle, 5},
        Kind{"fail", "fail", Marker::cross, 2}}) {
    Series series{.name = kind.name, .line = Line::none, .marker = kind.marker, .colour = kind.colour, .hollow = true};
    for (const View& claim : claims) {
      const auto margin = claim.number("margin"), rung = claim.number("rung");
      if (claim.text("verdict") != kind.verdict || !margin || !rung ||
          !(claim["tolerance"].number("value").value_or(0) > 0))
        continue;
      // Seven lanes a rung in turn, so that marks do not cover each other.
      constexpr int lanes = 7;
      const int lane = at_rung[static_cast<int>(*rung)]++ % lanes - lanes / 2;
      series.x.push_back(std::clamp(1 - *margin, least, 4.0));
      series.y.push_back(*rung + 0.1 * lane);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  if (panel.series.empty()) return;
  panel.height = 400;
  figure.panels.push_back(std::move(panel));
  page.begin_figures("wide-figure");
  page.figure(std::move(figure),
              "Every claim whose tolerance is a number, one mark each (in seven lanes a rung, so that marks do not "
              "hide each other); "
              "values below 10<sup>\u22124</sup> stand at the left edge, above 4 at the right one. At 1 the tolerance "
              "is just met.");
  page.end_figures();
}

/// The claims of a rung with a verdict: a link that shows them.
TableCell verdict_count(const View& rung, const std::string& verdict) {
  TableCell cell{escaped(rung.cell(verdict, 15)), "number"};
  if (!(rung.number(verdict).value_or(0) > 0)) return cell;
  if (verdict != "pass") cell.css += " " + verdict;
  cell.html = fmt::format("<a href=\"#claims\" data-rung=\"{}\" data-verdict=\"{}\">{}</a>", escaped(rung.cell("rung")),
                          verdict, cell.html);
  return cell;
}

/// A number of claims; `css` follows the class where there are any.
TableCell count_cell(const View& row, const std::string& key, const std::string& css) {
  return {escaped(row.cell(key, 15)), "number" + (row.number(key).value_or(0) > 0 ? css : "")};
}

void add_ladder(Page& page, const View& results, const std::map<std::string, View>& by_id) {
  Table table;
  table.caption = "The ladder: each rung assumes the one above it in this table";
  table.columns = {"rung", "what", "pass", "fail", "inconclusive", "skipped", "tightest margin", "its claim"};
  for (const View& rung : results.list("rungs")) {
    const std::string worst = rung.text("worst_claim");
    const auto claim = by_id.find(worst);
    std::string text = worst.empty() ? "" : identifier(worst);
    if (claim != by_id.end()) text = escaped(claim->second.text("statement")) + "<br>" + claim_link(worst);
    table.rows.push_back({{"<span class=\"folded\">rung </span>" + escaped(rung.cell("rung")), ""},
                          words(rung.text("name")),
                          verdict_count(rung, "pass"),
                          verdict_count(rung, "fail"),
                          verdict_count(rung, "inconclusive"),
                          count_cell(rung, "skipped", ""),
                          percent_cell(rung.number("worst_margin")),
                          {text, "wide"}});
  }
  if (table.rows.empty())
    page.absent("The ladder by rung is", "ehd verify --output DIR");
  else
    page.add(table);
}

void add_all_claims(Page& page, const View& results, const std::vector<View>& claims) {
  if (!claims.empty()) {
    std::string options;
    for (const char* verdict : {"pass", "fail", "inconclusive"})
      options += "<option>" + std::string(verdict) + "</option>";
    std::string rungs;
    for (const View& rung : results.list("rungs")) rungs += "<option>" + escaped(rung.cell("rung")) + "</option>";
    page.begin_fold(fmt::format("All {} claims, to filter by words (key /), rung and verdict", claims.size()),
                    "claims");
    page.add(
        fmt::format("<div class=\"controls\" data-for=\"all-claims\"><label>words <input "
                    "type=\"search\"></label><label>rung <select data-column=\"1\"><option "
                    "value=\"\">all</option>{}</select></label><label>verdict <select data-column=\"2\"><option "
                    "value=\"\">all</option>{}</select></label><output></output></div>\n<div id=\"all-claims\">",
                    rungs, options));
    Table table;
    table.css = "claims";
    table.columns = {"claim", "rung", "verdict", "margin", "statement and numbers"};
    for (const View& claim : claims) {
      std::string text = escaped(claim.text("statement"));
      if (const auto of = where(claim); !of.empty()) text += " <span class=\"absent\">[" + escaped(of) + "]</span>";
      text += "<br>" + escaped(numbers_of(claim));
      if (const auto note = claim.text("note"); !note.empty()) text += "<br>" + escaped(note);
      const std::string verdict = claim.text("verdict");
      const std::string id = claim.text("id");
      // A link leads to the first claim of an id.
      table.ids.push_back(page.unique(claim_anchor(id)));
      table.rows.push_back({{fmt::format("<a href=\"#{}\">{}</a>", table.ids.back(), identifier(id)), ""},
                            {escaped(claim.cell("rung")), ""},
                            verdict_cell(verdict),
                            percent_cell(claim.number("margin")),
                            {text, "wide"}});
    }
    page.add(table);
    page.add("</div>\n");
    page.end_fold();
  }
  const auto skipped = results.list("skipped");
  if (skipped.empty()) return;
  Table table;
  table.css = "claims";
  table.columns = {"row", "rung", "statement", "why"};
  for (const View& one : skipped)
    table.rows.push_back({{identifier(one.text("id")), ""},
                          {escaped(one.cell("rung")), ""},
                          words(one.text("statement")),
                          words(one.text("why"))});
  page.add_folded(fmt::format("{} skipped, with the reason", skipped.size()), table);
}

/// The topics that took the suite's time.
void add_topics(Page& page, std::vector<View> topics) {
  if (topics.empty()) return;
  std::stable_sort(topics.begin(), topics.end(), [](const View& a, const View& b) {
    return a.number("wall_s").value_or(0) > b.number("wall_s").value_or(0);
  });
  constexpr std::size_t most = 20;
  const std::size_t all = topics.size();
  topics.resize(std::min(all, most));
  Table table;
  table.columns = {"topic", "time [s]"};
  for (const View& topic : topics)
    table.rows.push_back({words(topic.text("name")), number_cell(topic.number("wall_s"), 3)});
  page.add_folded(fmt::format("The slowest of {} topics", all), table);
}

void add_traceability(Page& page, const View& results, const std::map<std::string, View>& by_id) {
  const auto rows = results.list("traceability");
  if (rows.empty()) {
    page.absent("The traceability table is", "ehd verify --output DIR");
    return;
  }
  Table table;
  table.columns = {"statement", "part", "claims", "pass", "fail", "inconclusive", "skipped", "for example"};
  for (const View& row : rows) {
    std::string ids;
    for (const View& id : row.list("ids"))
      ids += (ids.empty() ? "" : "<br>") + (by_id.contains(id.text()) ? claim_link(id.text()) : identifier(id.text()));
    const TableCell claims = count_cell(row, "claims", "");
    table.rows.push_back({{escaped(row.text("text")), "wide"},
                          words(row.text("part")),
                          {claims.html, row.number("claims").value_or(0) > 0 ? "number" : "number fail"},
                          count_cell(row, "pass", ""),
                          count_cell(row, "fail", " fail"),
                          count_cell(row, "inconclusive", " inconclusive"),
                          count_cell(row, "skipped", ""),
                          {ids, "wide"}});
  }
  page.add_folded(fmt::format("What is said, and which claims support it: {} statements", rows.size()), table);
}

void add_findings(Page& page, const std::vector<View>& claims) {
  Table table;
  table.columns = {"statement", "computed"};
  for (const View& one : claims) {
    if (!one.flag("finding").value_or(false)) continue;
    table.rows.push_back({{escaped(one.text("statement")), "wide"}, {escaped(one.text("note")), "wide"}});
  }
  if (!table.rows.empty()) page.add_folded("Findings: statements of others, with what was computed", table);
}

}  // namespace

void add_claims(Page& page, const View& results) {
  page.section("ladder", "Claims, rung by rung", "Claims");
  const auto claims = results.list("claims");
  std::map<std::string, View> by_id;
  for (const View& claim : claims) by_id.emplace(claim.text("id"), claim);
  page.paragraph(
      "A claim is a sentence with a number and a tolerance that carries its reason. It passes where error + "
      "uncertainty is within the "
      "tolerance, fails where error \u2212 uncertainty is beyond it, and is inconclusive between. The margin is what "
      "is left of the "
      "tolerance: 100\u2009% unused, 0 just met.");
  add_ladder(page, results, by_id);

  std::size_t standing = 0;
  for (const View& claim : claims) standing += claim.text("verdict") == "pass" ? 1 : 0;
  if (standing < claims.size()) {
    page.heading("What does not stand");
    for (const char* kind : {"fail", "inconclusive"}) {
      for (const View& claim : claims) {
        if (claim.text("verdict") == kind) add_claim_in_full(page, claim);
      }
    }
  }
  add_margins(page, claims);
  add_all_claims(page, results, claims);
  add_findings(page, claims);
  add_topics(page, results.list("topics"));
  add_traceability(page, results, by_id);
}

}  // namespace ehd::report
