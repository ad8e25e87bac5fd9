// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder: how many claims pass and by which margin; provenance of the numbers, and how to cite them.
#include <algorithm>
#include <cmath>
#include <map>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

/// A claim's id, with possible line breaks after its slashes.
std::string identifier(const std::string& id) {
  std::string result = "<code>";
  for (const char c : escaped(id)) result += c == '/' ? std::string("/<wbr>") : std::string(1, c);
  return result + "</code>";
}

std::string percent(const std::optional<double>& share) {
  return share && std::isfinite(*share) ? markup_to_html(number_markup(100 * *share, 3)) + "\u2009%" : "";
}

std::string seconds(const std::optional<double>& value) { return value ? plain(*value, 3) + " s" : ""; }

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
  if (!basis.empty()) text += " (" + basis + (reason.empty() || reason == basis ? "" : ": " + reason) + ")";
  return text;
}

std::string numbers_of(const View& claim) {
  std::string text;
  if (claim.has("measured")) text += "measured " + claim.cell("measured", 10);
  if (claim.has("expected")) text += (text.empty() ? "" : ", ") + std::string("expected ") + claim.cell("expected", 10);
  if (claim.has("error")) text += (text.empty() ? "" : "; ") + std::string("error ") + claim.cell("error", 3);
  if (claim.number("uncertainty").value_or(0) > 0) text += " \u00b1 " + claim.cell("uncertainty", 2);
  return text + (text.empty() ? "" : "; ") + "tolerance " + tolerance_text(claim);
}

void add_claim_in_full(Page& page, const View& claim) {
  const std::string verdict = claim.text("verdict");
  std::string block = "<div class=\"claim " + slug(verdict) + "\"><p><b>" + escaped(verdict) +
                      "</b>: " + escaped(claim.text("statement")) + "</p>";
  block += "<p>" + identifier(claim.text("id")) + ", rung " + escaped(claim.cell("rung"));
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
                .width = 900};
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
  panel.height = 300;
  figure.panels.push_back(std::move(panel));
  page.begin_figures("wide-figure");
  page.figure(std::move(figure),
              "Every claim whose tolerance is a number, one mark each (in seven lanes a rung, so that marks do not "
              "hide each other); "
              "values below 10<sup>\u22124</sup> stand at the left edge, above 4 at the right one. At 1 the tolerance "
              "is just met.");
  page.end_figures();
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
    if (claim != by_id.end()) text = escaped(claim->second.text("statement")) + "<br>" + text;
    table.rows.push_back({{escaped(rung.cell("rung")), ""},
                          words(rung.text("name")),
                          count_cell(rung, "pass", ""),
                          count_cell(rung, "fail", " fail"),
                          count_cell(rung, "inconclusive", " inconclusive"),
                          count_cell(rung, "skipped", ""),
                          {percent(rung.number("worst_margin")), "number"},
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
    page.add("<details><summary>All " + std::to_string(claims.size()) +
             " claims</summary>\n<div class=\"controls\" data-for=\"all-claims\"><label>words <input "
             "type=\"search\"></label>"
             "<label>rung <select data-column=\"1\"><option value=\"\">all</option>" +
             rungs + "</select></label><label>verdict <select data-column=\"2\"><option value=\"\">all</option>" +
             options + "</select></label><output></output></div>\n<div id=\"all-claims\">");
    Table table;
    table.css = "claims";
    table.columns = {"claim", "rung", "verdict", "margin", "statement and numbers"};
    for (const View& claim : claims) {
      std::string text = escaped(claim.text("statement"));
      if (const auto of = where(claim); !of.empty()) text += " <span class=\"absent\">[" + escaped(of) + "]</span>";
      text += "<br>" + escaped(numbers_of(claim));
      if (const auto note = claim.text("note"); !note.empty()) text += "<br>" + escaped(note);
      const std::string verdict = claim.text("verdict");
      table.rows.push_back({{identifier(claim.text("id")), ""},
                            {escaped(claim.cell("rung")), ""},
                            verdict_cell(verdict),
                            {percent(claim.number("margin")), "number"},
                            {text, "wide"}});
    }
    page.add(table);
    page.add("</div></details>\n");
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
  page.add_folded(std::to_string(skipped.size()) + " skipped, with the reason", table);
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
  page.add_folded("The slowest of " + std::to_string(all) + " topics", table);
}

void add_traceability(Page& page, const View& results) {
  page.heading("What is said, and which claims support it");
  const auto rows = results.list("traceability");
  if (rows.empty()) {
    page.absent("The traceability table is", "ehd verify --output DIR");
    return;
  }
  Table table;
  table.columns = {"statement", "part", "claims", "pass", "fail", "inconclusive", "skipped", "for example"};
  for (const View& row : rows) {
    std::string ids;
    for (const View& id : row.list("ids")) ids += (ids.empty() ? "" : "<br>") + identifier(id.text());
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
  page.add(table);
}

void add_provenance(Page& page, const std::string& title, const View& provenance) {
  if (!provenance.exists()) return;
  std::string list = "<dl>";
  const auto row = [&](const char* name, const std::string& value) {
    if (!value.empty()) list += "<dt>" + std::string(name) + "</dt><dd>" + escaped(value) + "</dd>";
  };
  row("version", provenance.cell("version"));
  std::string commit = provenance.text("commit");
  if (const auto dirty = provenance.flag("dirty"); !commit.empty() && dirty)
    commit += *dirty ? ", with changes that are not committed" : ", clean";
  row("commit", commit);
  row("compiler", provenance.text("compiler"));
  row("flags", provenance.text("flags"));
  std::string libraries;
  for (const auto& [name, version] : provenance["libraries"].members())
    libraries += (libraries.empty() ? "" : ", ") + name + " " + version.cell();
  row("libraries", libraries);
  std::string cpu = provenance.text("cpu");
  if (provenance.has("cores")) cpu += (cpu.empty() ? "" : ", ") + provenance.cell("cores") + " cores";
  row("machine", cpu);
  row("date", provenance.text("date"));
  page.heading(title);
  page.add(list + "</dl>\n");
}

}  // namespace

namespace {

/// What the page shows beside claims, and what of it does not stand: parts of the stress, stated errors of the
/// benchmark.
struct Beside {
  std::size_t parts = 0;
  std::vector<std::string> open;  ///< HTML, one entry each

  Beside(const View& bench, const View& stress) {
    for (const View& part : stress.list("parts")) {
      ++parts;
      if (const std::string verdict = part.text("verdict"); verdict != "pass")
        open.push_back("<a href=\"#stress\">stress (" + escaped(part.text("id")) + ") " + escaped(part.text("name")) +
                       "</a>: " + escaped(verdict));
    }
    for (const View& one : bench["work_precision"].list("coverage"))
      if (const double missed = one.number("missed").value_or(0); missed > 0)
        open.push_back("<a href=\"#work-precision\">benchmark</a>: " + plain(missed) + " stated errors of " +
                       escaped(one.text("solver")) + " do not cover the true one (" + escaped(one.text("quantity")) +
                       ")");
  }
};

/// Everything that is judged on the page in one sentence. Counted from the claims themselves, not read from the
/// summary.
void add_headline(Page& page, const View& results, const Beside& beside) {
  const auto claims = results.list("claims");
  const View summary = results["summary"];
  const bool all_stand = !claims.empty() && std::all_of(claims.begin(), claims.end(), stands);
  const auto count = [&](const char* kind) {
    return std::to_string(
        std::count_if(claims.begin(), claims.end(), [&](const View& claim) { return claim.text("verdict") == kind; }));
  };
  std::string verdict = claims.empty()        ? "<b>No claim was judged.</b> "
                        : !all_stand          ? "<b>Not every claim stands.</b> "
                        : beside.open.empty() ? "<b>Every claim stands.</b> "
                                              : "<b>Every claim stands, but not everything on this page does.</b> ";
  verdict += count("pass") + " pass, " + count("fail") + " fail, " + count("inconclusive") + " inconclusive, " +
             std::to_string(results.list("skipped").size()) + " skipped";
  if (summary.has("wall_s")) verdict += "; " + escaped(seconds(summary.number("wall_s")));
  if (summary.has("threads")) verdict += " on " + escaped(summary.cell("threads")) + " threads";
  if (summary.flag("quick").value_or(false)) verdict += "; the quick suite: slow topics are skipped";
  if (const auto selection = summary.text("selection"); !selection.empty())
    verdict += "; only <code>" + escaped(selection) + "</code>";
  verdict += ".";
  if (beside.parts > 0 && beside.open.empty())
    verdict += " All " + std::to_string(beside.parts) + " parts of the <a href=\"#stress\">stress</a> pass.";
  for (const std::string& one : beside.open) verdict += " " + one + ".";
  page.paragraph(verdict, all_stand && beside.open.empty() ? "verdict pass" : "verdict fail");
}

}  // namespace

void add_summary(Page& page, const View& results, const View& bench, const View& stress) {
  page.section("summary", "Summary");
  const auto claims = results.list("claims");
  std::map<std::string, View> by_id;
  for (const View& claim : claims) by_id.emplace(claim.text("id"), claim);

  add_headline(page, results, Beside(bench, stress));
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
  std::vector<View> findings;
  for (const View& claim : claims) {
    if (claim.flag("finding").value_or(false)) findings.push_back(claim);
  }
  if (!findings.empty()) {
    page.heading("Findings: statements of others, with what was computed");
    Table table;
    table.columns = {"statement", "computed"};
    for (const View& one : findings)
      table.rows.push_back({{escaped(one.text("statement")), "wide"}, {escaped(one.text("note")), "wide"}});
    page.add(table);
  }
  add_margins(page, claims);
  add_all_claims(page, results, claims);
  add_topics(page, results.list("topics"));
  add_traceability(page, results);
}

void add_origin(Page& page, const View& results, const View& bench, const View& stress) {
  page.section("origin", "Provenance, how to cite");
  const View provenance = results["provenance"];
  add_provenance(page, "The suite (results.json)", provenance);
  add_provenance(page, "Times (bench.json)", bench["provenance"]);
  add_provenance(page, "Stress (stress.json)", stress["provenance"]);
  page.heading("How to cite");
  const std::string version = provenance.cell("version"), commit = provenance.text("commit"),
                    date = provenance.text("date");
  std::string text = EHD_CITATION_AUTHORS ": " EHD_CITATION_TITLE;
  if (!version.empty()) text += ", version " + version;
  if (!commit.empty())
    text += ", commit " + commit.substr(0, 12) + (provenance.flag("dirty").value_or(false) ? " (with changes)" : "");
  if (date.size() >= 4) text += " (" + date.substr(0, 4) + ")";
  page.add("<pre>" + escaped(text + ".") + "</pre>\n");
  page.paragraph(
      "CITATION.cff has the same for programs; <code>ehd cases --bibtex</code> the source of every benchmark case, to "
      "be cited beside it.");
}

}  // namespace ehd::report
