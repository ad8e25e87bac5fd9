// SPDX-License-Identifier: GPL-3.0-or-later
// The page from made results, and the command around it.
#include "verification/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <tuple>

#include "bearing/law_table.hpp"
#include "io/json.hpp"
#include "tests/check.hpp"
#include "tests/process.hpp"
#include "tests/verification/report/made_results.hpp"
#include "tests/verification/report/markup.hpp"

using namespace ehd;
using namespace ehd::verification;
using test::count_of;
using test::unbalanced;

namespace {

std::string made_page(const std::function<void(report::Documents&)>& change = {}) {
  report::Documents documents{
      .results = test::made_results(), .bench = test::made_bench(), .stress = test::made_stress()};
  if (change) change(documents);
  return report::report_html(documents);
}

std::vector<report::Verified> first_table(const std::function<void(report::Documents&)>& change = {}) {
  report::Documents documents{
      .results = test::made_results(), .bench = test::made_bench(), .stress = test::made_stress()};
  if (change) change(documents);
  return report::everything_verified({documents.results, "results.json"}, {documents.bench, "bench.json"},
                                     {documents.stress, "stress.json"});
}

/// The line whose first cell has the words.
report::Verified line_of(const std::vector<report::Verified>& lines, const std::string& words) {
  std::vector<report::Verified> found;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(found),
               [&](const report::Verified& line) { return line.what.find(words) != std::string::npos; });
  BOOST_REQUIRE_EQUAL(found.size(), 1u);
  return found.front();
}

/// The page without the heads that the cells of a folding table repeat.
std::string without_columns(const std::string& page) {
  static const std::regex column(" data-column=\"[^\"]*\"");
  return std::regex_replace(page, column, "");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(report_report)

BOOST_AUTO_TEST_CASE(a_balance_has_its_number_of_loaded_rollers) {
  const std::string row =
      "made-tight</th><td class=\"name\">hertz</td><td class=\"converged\">converged</td>"
      "<td class=\"number\">5</td><td class=\"number\">9</td><td class=\"number\">7</td>";
  BOOST_TEST(without_columns(made_page()).find(row) != std::string::npos);  // 5 um, 9 kN, 7 rollers
}

BOOST_AUTO_TEST_CASE(a_study_of_two_grids_stands_in_the_table_alone) {
  const std::string figure = "id=\"fig-convergence-fast-uniform-made-20-10-intervals\"";
  const auto page = [&](std::size_t grids) {
    return made_page([&](report::Documents& documents) {
      for (auto& study : documents.results["figures"]["convergence"]) {
        auto& points = study["points"];
        while (points.size() > grids) points.erase(points.size() - 1);
      }
    });
  };
  BOOST_TEST(page(3).find(figure) != std::string::npos);
  BOOST_TEST(page(2).find(figure) == std::string::npos);
  BOOST_TEST(page(2).find("0 figures: errors over the size of the grid") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_long_run_is_said_in_minutes) {
  const std::string page =
      made_page([](report::Documents& documents) { documents.results["summary"]["wall_s"] = 1100.0; });
  BOOST_TEST(page.find("; 18 min") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(every_part_of_the_results_has_its_figures) {
  const std::string page = made_page();
  BOOST_TEST(unbalanced(page) == "");
  for (const char* id : {"fig-margins",
                         "fig-case-made-20-10",
                         "fig-case-made-light",
                         "fig-convergence-fast-uniform-made-20-10-intervals",
                         "fig-work-made-20-10-film-minimum",
                         "fig-work-made-20-10-pressure",
                         "fig-ratio-reference-fast-film-central",
                         "fig-scaling-wall-s",
                         "fig-response-cost",
                         "fig-film-minimum-roelands",
                         "fig-film-central-barus",
                         "fig-formula-made-formula-film-minimum-barus",
                         "fig-inlet-minimum-roelands",
                         "fig-fast-newton-iterations-barus",
                         "fig-fast-deviation-central-roelands",
                         "fig-force-made-tight",
                         "fig-force-made-wide",
                         "fig-displacement-made-tight",
                         "fig-clearance-made-tight-ehd",
                         "fig-polar-made-loose",
                         "fig-motion-around-made-tight",
                         "fig-motion-ring-made-tight",
                         "fig-motion-clearance-made-tight",
                         "fig-motion-speed-made-tight",
                         "fig-law-made-tight-inner"})
    BOOST_TEST(count_of(page, "id=\"" + std::string(id) + "\"") == 1u, id << " is not there once");
  BOOST_TEST(count_of(page, "no data") == 0u);
  BOOST_TEST(count_of(page, "class=\"absent\">") == 4u);  // the case of each of the four claims, none of a missing part
}

BOOST_AUTO_TEST_CASE(the_page_needs_no_network) {
  const std::string page = made_page();
  BOOST_TEST(count_of(page, "http") == 0u);
  BOOST_TEST(count_of(page, " src=") == 0u);
  BOOST_TEST(count_of(page, "@import") == 0u);
}

BOOST_AUTO_TEST_CASE(text_of_the_results_is_text_on_the_page) {
  const std::string page = made_page();
  BOOST_TEST(count_of(page, "<script>alert") == 0u);
  BOOST_TEST(count_of(page, report::escaped(test::hostile_text)) >= 3u);  // a note in full, in the table, a title
  for (const char* where :
       {"/claims/0/id", "/claims/2/note", "/claims/0/case", "/rungs/3/name", "/figures/cases/0/id",
        "/figures/cases/0/solvers/0/solver", "/figures/convergence/0/solver", "/figures/convergence/0/quantity",
        "/figures/bearing/0/id", "/figures/bearing/0/laws/0/law", "/figures/statements/0/numbers",
        "/figures/force_law/0/raceway", "/provenance/commit", "/provenance/libraries/Eigen", "/traceability/0/text",
        "/figures/maps/source", "/figures/maps/points/0/formulas/0/name", "/summary/selection", "/topics/0/name"}) {
    const std::string hostile = made_page(
        [&](report::Documents& documents) { documents.results[Json::json_pointer(where)] = test::hostile_text; });
    BOOST_TEST(count_of(hostile, "<script>alert") == 0u, where);
    BOOST_TEST(unbalanced(hostile) == "", where);
  }
  for (const char* where :
       {"/parts/0/id", "/parts/0/name", "/parts/0/rows/0/2", "/parts/0/columns/0/unit", "/parts/0/tolerance/reason"}) {
    const std::string hostile = made_page(
        [&](report::Documents& documents) { documents.stress[Json::json_pointer(where)] = test::hostile_text; });
    BOOST_TEST(count_of(hostile, "<script>alert") == 0u, where);
    BOOST_TEST(unbalanced(hostile) == "", where);
  }
  for (const char* where :
       {"/work_precision/truths/0/case", "/work_precision/truths/0/solver", "/work_precision/solvers/0",
        "/work_precision/rows/0/solver", "/work_precision/coverage/0/solver", "/scaling/0/solver", "/batch/0/solver",
        "/response/frequencies/0/solver", "/response/bearings/0/bearing"}) {
    const std::string hostile = made_page(
        [&](report::Documents& documents) { documents.bench[Json::json_pointer(where)] = test::hostile_text; });
    BOOST_TEST(count_of(hostile, "<script>alert") == 0u, where);
    BOOST_TEST(unbalanced(hostile) == "", where);
  }
}

BOOST_AUTO_TEST_CASE(what_is_absent_is_a_line_with_the_command_that_makes_it) {
  const std::string bare = made_page([](report::Documents& documents) {
    documents.results = {
        {"schema", 2}, {"claims", Json::array()}, {"summary", Json::object()}, {"provenance", Json::object()}};
    documents.bench = documents.stress = nullptr;
  });
  BOOST_TEST(unbalanced(bare) == "");
  for (const char* command : {"ehd verify --output DIR", "ehd bench --output DIR", "ehd stress --output DIR"})
    BOOST_TEST(count_of(bare, command) >= 1u, command);
  BOOST_TEST(count_of(bare, "<svg") == 0u);
  for (const char* key :
       {"cases", "convergence", "maps", "bearing", "dynamics", "statements", "statement_study", "force_law"}) {
    const std::string page = made_page([&](report::Documents& documents) { documents.results["figures"].erase(key); });
    BOOST_TEST(count_of(page, "ehd verify --output DIR") == 1u, key);
  }
}

BOOST_AUTO_TEST_CASE(long_tables_are_closed_until_the_reader_opens_them) {
  const std::string page = made_page();
  for (const char* words : {"Where the formulas hold, of all points", "<th scope=\"col\">letter</th>"}) {
    const std::size_t at = page.find(words);
    BOOST_REQUIRE(at != std::string::npos);
    const std::size_t opened = page.rfind("<details", at), closed = page.rfind("</details>", at);
    BOOST_TEST((opened != std::string::npos && (closed == std::string::npos || closed < opened)), words);
  }
  BOOST_TEST(count_of(page, "2 statements with their numbers: 1 hold as computed, 1 not") == 1u);
  // The first table leads to the statements themselves, and so opens them.
  BOOST_TEST(count_of(page, "<details id=\"statements\">") == 1u);
  BOOST_TEST(line_of(first_table(), "statements").what.find("href=\"#statements\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_verdict_is_that_of_the_claims_whatever_the_summary_says) {
  BOOST_TEST(count_of(made_page(), "Not every claim stands.") == 1u);
  BOOST_TEST(count_of(made_page(), "class=\"claim fail\"") == 1u);
  BOOST_TEST(count_of(made_page(), "class=\"claim inconclusive\"") == 1u);
  const auto page_of = [](const char* third, const char* fourth, bool accepted, const Json& success) {
    return made_page([&](report::Documents& documents) {
      documents.results["claims"][2]["verdict"] = third;
      documents.results["claims"][3]["verdict"] = fourth;
      if (accepted) documents.results["claims"][3]["accepted"] = "nobody knows";
      documents.results["summary"]["success"] = success;
      documents.results["summary"]["fail"] = 77;
    });
  };
  int rows = 0;
  for (const Json& success : {Json(true), Json(false), Json(nullptr)}) {
    for (const auto& [third, fourth, accepted, good] : {std::tuple{"pass", "pass", false, true},
                                                        {"pass", "inconclusive", true, true},
                                                        {"pass", "inconclusive", false, false},
                                                        {"fail", "pass", false, false},
                                                        {"pass", "fail", true, false}}) {
      const std::string page = page_of(third, fourth, accepted, success);
      BOOST_TEST(count_of(page, "<b>Every claim stands.") == (good ? 1u : 0u));
      BOOST_TEST(count_of(page, "<b>Not every claim stands.") == (good ? 0u : 1u));
      BOOST_TEST(count_of(page, "77 fail") == 0u);
      ++rows;
    }
  }
  BOOST_TEST(rows == 15);
  const std::string empty =
      made_page([](report::Documents& documents) { documents.results["claims"] = Json::array(); });
  BOOST_TEST(count_of(empty, "No claim was judged.") == 1u);
  BOOST_TEST(count_of(empty, "Every claim stands.") == 0u);
}

// The headline is about the page: claims alone cannot make it good.
BOOST_AUTO_TEST_CASE(the_headline_covers_everything_that_is_judged_on_the_page) {
  const auto page_of = [](const char* part, int missed) {
    return made_page([&](report::Documents& documents) {
      for (Json& claim : documents.results["claims"]) claim["verdict"] = "pass";
      documents.stress["parts"][0]["verdict"] = part;
      documents.bench["work_precision"]["coverage"][0]["missed"] = missed;
    });
  };
  const std::string good = page_of("pass", 0);
  BOOST_TEST(count_of(good, "<b>Every claim stands.</b>") == 1u);
  BOOST_TEST(count_of(good, " The one part of the <a href=\"#stress\">stress</a> passes.") == 1u);
  BOOST_TEST(count_of(good, "class=\"verdict pass\"") == 1u);
  for (const auto& [part, missed, said] : {std::tuple{"fail", 0, "stress (a) box</a>: fail"},
                                           {"inconclusive", 0, "stress (a) box</a>: inconclusive"},
                                           {"pass", 3, "3 stated errors of fast do not cover"}}) {
    const std::string page = page_of(part, missed);
    BOOST_TEST(count_of(page, "<b>Every claim stands.</b>") == 0u, said);
    BOOST_TEST(count_of(page, "class=\"verdict fail\"") == 1u, said);
    BOOST_TEST(count_of(page, said) == 1u, said);
  }
}

// By a signal or by --time-limit-total: what is missing may be what would have failed.
BOOST_AUTO_TEST_CASE(a_run_that_was_stopped_is_no_full_pass) {
  const auto page_of = [](const Json& summary) {
    return made_page([&](report::Documents& documents) {
      for (Json& claim : documents.results["claims"]) claim["verdict"] = "pass";
      documents.results["summary"].update(summary);
      documents.bench["settings"]["left_out"] = {"batch", "<box>"};
    });
  };
  const std::string whole = page_of(Json::object()), late = page_of({{"not_run", 3}}),
                    drawn = page_of({{"stopped", true}});
  BOOST_TEST(count_of(whole, "class=\"verdict pass\"") == 1u);
  for (const std::string& page : {late, drawn}) {
    BOOST_TEST(count_of(page, "<b>The run was stopped; what was judged until then stands.</b>") == 1u);
    BOOST_TEST(count_of(page, "class=\"verdict fail\"") == 1u);
    BOOST_TEST(count_of(page, "Every claim stands") == 0u);
  }
  BOOST_TEST(count_of(late, "</a>: 3 topics were not run to the end.") == 1u);
  BOOST_TEST(count_of(whole, "the run was stopped; left out: batch, &lt;box&gt;") == 1u);
}

// Beyond what both solvers state, or with the number of threads: neither is a claim, both are on the page.
BOOST_AUTO_TEST_CASE(the_headline_covers_cases_and_batches) {
  const auto page_of = [](double found, bool same) {
    return made_page([&](report::Documents& documents) {
      for (Json& claim : documents.results["claims"]) claim["verdict"] = "pass";
      documents.results["figures"]["cases"][0]["difference"]["film_minimum"] = found;
      documents.bench["batch"][0]["same_results"] = same;
    });
  };
  BOOST_TEST(count_of(page_of(-1e-5, true), "class=\"verdict pass\"") == 1u);  // stated: 2e-5
  const std::string beyond = page_of(-3e-5, true), threads = page_of(-1e-5, false);
  BOOST_TEST(count_of(beyond, "class=\"verdict fail\"") == 1u);
  BOOST_TEST(count_of(beyond, "in 1 the films differ by more than both solvers state") == 1u);
  BOOST_TEST(count_of(beyond, "class=\"number fail\">3\u2009\u00b7\u200910<sup>\u22125</sup>") == 1u);
  BOOST_TEST(count_of(threads, "class=\"verdict fail\"") == 1u);
  BOOST_TEST(count_of(threads, "results depend on the number of threads") == 1u);
}

BOOST_AUTO_TEST_CASE(the_first_table_has_a_line_a_part_and_says_what_is_absent) {
  const auto absent = [](const report::Verified& line) {
    return line.open.size() == 1 && line.open.front() == "not in this folder";
  };
  const auto all = first_table();
  BOOST_TEST(std::none_of(all.begin(), all.end(), absent));
  const auto bare = first_table([](report::Documents& documents) {
    documents.results.erase("figures");
    documents.bench = documents.stress = nullptr;
  });
  BOOST_REQUIRE_EQUAL(bare.size(), all.size());
  constexpr std::ptrdiff_t always = 2;  // claims, provenance
  BOOST_TEST(std::count_if(bare.begin(), bare.end(), absent) == static_cast<std::ptrdiff_t>(all.size()) - always);

  const auto changed = first_table([](report::Documents& documents) {
    documents.results["figures"]["cases"][0]["difference"]["film_central"] = -1e-7;
    documents.results["figures"]["cases"][0]["solvers"][0]["film"]["central"]["error"] = 9e-7;
    documents.results["figures"]["cases"][1]["solvers"][1]["status"] = "tolerance-not-met";
    documents.bench["work_precision"]["cpu_share"] = 0.4;
  });
  const report::Verified cases = line_of(changed, "#contacts");
  BOOST_TEST(cases.digits == "6 digits");
  BOOST_REQUIRE_EQUAL(cases.open.size(), 2u);
  BOOST_TEST(cases.open.front() == "1 case without two converged solves");
  BOOST_TEST(line_of(changed, "of the benchmark").open.back() == "the times: other processes took 60 % of the core");
  BOOST_TEST(line_of(changed, "in small motion").digits ==
             "stiffness: 3 digits at worst, 4 at best; damping: 2 digits");
}

BOOST_AUTO_TEST_CASE(the_first_table_has_the_time_of_each_part_of_the_figures) {
  const auto cost = [](const std::string& part, const std::function<void(report::Documents&)>& change = {}) {
    return line_of(first_table(change), part).cost;
  };
  BOOST_TEST(cost("grid studies") == "3 min in one thread");
  BOOST_TEST(cost("under 3 laws") == "12 s in one thread");
  BOOST_TEST(cost("in small motion") == "33 s in one thread");
  for (const report::Verified& line : first_table()) BOOST_TEST(line.cost != "not recorded", line.what);
  const auto earlier = [](report::Documents& documents) { documents.results["figures"].erase("times"); };
  BOOST_TEST(cost("in small motion", earlier) == "not recorded");
}

// A section without a line in the first table would look verified.
BOOST_AUTO_TEST_CASE(the_first_table_leads_to_every_section) {
  const std::string page = made_page();
  const std::size_t table = page.find("<table class=\"overview"), end = page.find("</table>", table);
  BOOST_REQUIRE(table != std::string::npos);
  const std::string lines = page.substr(table, end - table);
  std::size_t sections = 0;
  for (std::size_t at = 0; (at = page.find("<section id=\"", at)) != std::string::npos; ++sections) {
    at += std::string("<section id=\"").size();
    const std::string id = page.substr(at, page.find('"', at) - at);
    if (id != "summary") BOOST_TEST(count_of(lines, "<a href=\"#" + id + "\">") >= 1u, id);
  }
  BOOST_TEST(sections == 9u);
}

// Two solvers that agree to seven digits prove no more digits than the truth itself has.
BOOST_AUTO_TEST_CASE(digits_count_the_error_of_the_truth) {
  const auto digits = [](double stated) {
    return line_of(first_table([&](report::Documents& documents) {
                     Json& one = documents.results["figures"]["cases"][0];
                     one["difference"]["film_minimum"] = 1e-7;
                     one["solvers"][0]["film"]["minimum"]["error"] = stated;
                   }),
                   "#contacts")
        .digits;
  };
  BOOST_TEST(digits(0) == "7 digits");
  BOOST_TEST(digits(4.5e-5) == "4.3 digits");
  BOOST_TEST(digits(1.1e-4) == "3.9 digits");  // rounded down
  const auto benchmark = [](double achieved, double truth) {
    return line_of(first_table([&](report::Documents& documents) {
                     Json& row = documents.bench["work_precision"]["rows"][0];
                     documents.bench["work_precision"]["rows"] = Json::array({row});
                     for (const char* film : {"film.minimum", "film.central"})
                       documents.bench["work_precision"]["rows"][0][film] = {{"achieved", achieved},
                                                                             {"truth_error", truth}};
                   }),
                   "of the benchmark")
        .digits;
  };
  BOOST_TEST(benchmark(1e-15, 1e-12).starts_with("11.9 digits, as they were asked for"));
  BOOST_TEST(benchmark(1e-3, 1e-12).find("all 4 stated errors that could be judged cover the true one") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_first_table_says_what_a_short_run_and_other_commits_leave_open) {
  const auto open = [](const std::string& part, const std::function<void(report::Documents&)>& change) {
    const std::vector<std::string> said = line_of(first_table(change), part).open;
    return std::accumulate(said.begin(), said.end(), std::string(),
                           [](const std::string& all, const std::string& one) { return all + one + "; "; });
  };
  const std::string quick = "--quick";
  BOOST_TEST(count_of(open("of the benchmark", {}), quick) == 0u);
  BOOST_TEST(count_of(open("of the stress", {}), quick) == 0u);
  BOOST_TEST(count_of(open("of the benchmark",
                           [](report::Documents& documents) { documents.bench["settings"]["quick"] = true; }),
                      quick) == 1u);
  BOOST_TEST(
      count_of(open("of the stress",
                    [](report::Documents& documents) { documents.stress["parts"][0]["settings"]["quick"] = true; }),
               quick) == 1u);
  const std::string other = "bench.json: of another commit than results.json";
  BOOST_TEST(count_of(open("Provenance", {}), other) == 0u);
  BOOST_TEST(count_of(open("Provenance",
                           [](report::Documents& documents) { documents.bench["provenance"]["commit"] = "f00"; }),
                      other) == 1u);
  BOOST_TEST(count_of(open("over M and L", {}), "where it was not run") == 0u);
  BOOST_TEST(count_of(open("over M and L",
                           [](report::Documents& documents) {
                             for (const std::size_t i : {0u, 1u, 2u})
                               documents.results["figures"]["maps"]["points"][i].erase("fast");
                           }),
                      "at 3 points, where it was not run") == 1u);
}

// A line that is fitted is off by its distance from the full relation; the datum is a choice.
BOOST_AUTO_TEST_CASE(a_balance_has_the_errors_of_its_budget_and_the_first_table_has_the_worst) {
  const auto line = [](const Json& results) {
    return line_of(report::everything_verified({results, "results.json"}, {}, {}), "under 3 laws");
  };
  Json results = test::made_results();
  BOOST_TEST(line(results).digits == "<code>ehd-linear</code>: 1.3 digits; <code>ehd</code>: 3.2");
  BOOST_TEST(line(results).open.front() == "no error is stated of <code>hertz</code>");
  const std::string page = without_columns(made_page());
  BOOST_TEST(count_of(page, "<td class=\"number\">5.0(3)</td><td class=\"number\">9.00(2)</td>") == 1u);  // 0.201 um
  BOOST_TEST(count_of(page, "<td class=\"number\">5.000(3)</td>") == 1u);
  BOOST_TEST(count_of(page, "<td class=\"number\">0.4000(4)</td>") == 1u);
  results["figures"]["bearing"][0]["laws"][1].erase("errors");  // the fit's distance is not known
  BOOST_TEST(line(results).digits == "<code>ehd</code>: 3.2 digits");
}

// Panels that stand beside each other to be compared.
BOOST_AUTO_TEST_CASE(bearings_of_one_family_share_their_scales) {
  const std::string page = made_page();
  const auto picture = [&](const std::string& id) {
    const std::size_t begin = page.find("id=\"" + id + "\"");
    BOOST_REQUIRE(begin != std::string::npos);
    return page.substr(begin, page.find("</svg>", begin) - begin);
  };
  const auto circles = [&](const std::string& id) {
    std::vector<std::string> labels;
    const std::string svg = picture(id), word = "class=\"small halo\">";
    for (std::size_t at = 0; (at = svg.find(word, at)) != std::string::npos; ++at)
      labels.push_back(svg.substr(at + word.size(), svg.find('<', at) - at - word.size()));
    return labels;
  };
  const auto range = [&](const std::string& id) {
    const std::string svg = picture(id), word = "data-y-range=\"";
    const std::size_t at = svg.find(word) + word.size();
    return svg.substr(at, svg.find('"', at) - at);
  };
  BOOST_TEST(!circles("fig-polar-made-tight").empty());
  for (const std::string other : {"made-loose", "made-wide"}) {
    BOOST_TEST(circles("fig-polar-" + other) == circles("fig-polar-made-tight"), boost::test_tools::per_element());
    BOOST_TEST(range("fig-force-" + other) == range("fig-force-made-tight"));
  }
  for (const std::string law : {"ehd-linear", "ehd"})
    BOOST_TEST(range("fig-clearance-made-tight-" + law) == range("fig-clearance-made-tight-hertz"));
}

BOOST_AUTO_TEST_CASE(an_answer_has_its_cost_in_ms_and_in_c) {
  const std::string page = without_columns(made_page());
  BOOST_TEST(count_of(page,
                      "<th scope=\"row\">both films to <span class=\"whole\">1e-3</span></th><td>box</td><td "
                      "class=\"number\">24</td>"
                      "<td class=\"number\">0</td><td class=\"number\">24</td><td class=\"number\">6</td>") == 1u);
  BOOST_TEST(count_of(page, "<td class=\"number\">1200</td></tr>") == 1u);  // 6 ms over 5 us
  const std::string without = made_page([](report::Documents& documents) { documents.bench.erase("cost"); });
  BOOST_TEST(count_of(without, "ehd bench --part cost --output DIR") == 1u);
}

BOOST_AUTO_TEST_CASE(small_numbers_of_the_stress_are_powers_of_ten) {
  const std::string page =
      made_page([](report::Documents& documents) { documents.stress["parts"][0]["rows"][0][1] = 6.5947e-14; });
  BOOST_TEST(count_of(page, ">6.5947\u2009\u00b7\u200910<sup>\u221214</sup></td>") == 1u);
  BOOST_TEST(count_of(page, ">tolerance-not-met</td>") >= 1u);  // a word stays a word
}

// Nine names in two lines of a phone: a long title has a short name in the index.
BOOST_AUTO_TEST_CASE(the_index_is_short) {
  const std::string page = made_page();
  const std::size_t begin = page.find("<nav"), end = page.find("</nav>");
  static const std::regex link("<a href=\"#[^\"]*\">([^<]*)</a>");
  const std::string index = page.substr(begin, end - begin);
  std::size_t names = 0;
  for (std::sregex_iterator at(index.begin(), index.end(), link), last; at != last; ++at, ++names) {
    const std::string name = (*at)[1];
    BOOST_TEST((name.size() <= 12 && name.find(' ') == std::string::npos), name);
  }
  BOOST_TEST(names == 9u);
}

BOOST_AUTO_TEST_CASE(a_study_says_which_order_is_declared) {
  BOOST_TEST(count_of(made_page(),
                      "<b>fast.uniform, made-20-10</b>: relative error over intervals; declared order: 2 for "
                      "film.minimum, extrapolated, 2 for film.central, 2 for film.minimum, each grid.") == 1u);
}

BOOST_AUTO_TEST_CASE(a_figure_of_single_marks_is_left_to_its_table) {
  const auto figures = [](std::size_t rows) {
    return count_of(made_page([&](report::Documents& documents) {
                      Json& all = documents.bench["response"]["frequencies"];
                      while (all.size() > rows) all.erase(all.size() - 1);
                    }),
                    "id=\"fig-response-cost\"");
  };
  BOOST_TEST(figures(2) == 1u);
  BOOST_TEST(figures(1) == 0u);
}

BOOST_AUTO_TEST_CASE(no_legend_has_one_name_twice) {
  const std::string page = made_page();
  BOOST_TEST(count_of(page, "film.minimum, extrapolated: fitted 1.9<") == 1u);
  BOOST_TEST(count_of(page, "film.minimum, each grid: fitted 2<") == 1u);
  std::size_t panels = 0;
  for (std::size_t at = 0; (at = page.find("<svg class=\"plot\"", at)) != std::string::npos; ++at) {
    const std::string svg = page.substr(at, page.find("</svg>", at) - at);
    std::set<std::string> names;
    for (std::size_t key = 0; (key = svg.find("<g class=\"key ", key)) != std::string::npos; ++key) {
      const std::size_t text = svg.find("<text", key), end = svg.find("</text>", text);
      const std::size_t begin = svg.find('>', text);
      BOOST_TEST(names.insert(svg.substr(begin, end - begin)).second, svg.substr(begin, end - begin));
    }
    ++panels;
  }
  BOOST_TEST(panels > 40u);
}

BOOST_AUTO_TEST_CASE(two_points_are_no_law) {
  const std::string page = made_page();
  const auto figure_of = [&](const std::string& id) {
    const std::size_t begin = page.find("id=\"fig-convergence-reference-" + id);
    return page.substr(begin, page.find("</svg>", begin) - begin);
  };
  BOOST_TEST(count_of(figure_of("made-five"), "a digit every 10<") == 1u);
  BOOST_TEST(count_of(figure_of("made-five"), "class=\"line\"") == 2u);  // the curve and its key
  BOOST_TEST(count_of(page, "id=\"fig-convergence-reference-made-two") == 0u);
  BOOST_TEST(count_of(page, ">no rate<") == 1u);
}

BOOST_AUTO_TEST_CASE(maps_have_no_empty_rows_and_columns) {
  const std::string page = made_page();
  const std::size_t begin = page.find("id=\"fig-film-minimum-barus\""), end = page.find("</svg>", begin);
  BOOST_REQUIRE(begin != std::string::npos);
  const std::string map = page.substr(begin, end - begin);
  BOOST_TEST(count_of(map, "class=\"cell\"") >= 20u);
  BOOST_TEST(count_of(map, "not known") == 0u);
  BOOST_TEST(count_of(map, "M = 5000") == 0u);
  const std::size_t inlet = page.find("id=\"fig-inlet-minimum-barus\"");
  BOOST_TEST(count_of(page.substr(inlet, page.find("</svg>", inlet) - inlet), "not known") == 0u);  // from M = 2 on
}

// Times stand in ms, and in c where the benchmark has measured c in the same run.
BOOST_AUTO_TEST_CASE(work_and_precision_has_two_yardsticks) {
  const auto figure = [](const std::string& page) {
    const std::size_t begin = page.find("id=\"fig-work-made-20-10-film-minimum\"");
    return page.substr(begin, page.find("</svg>", begin) - begin);
  };
  const std::string with = figure(made_page());
  BOOST_TEST(count_of(with, "data-y=\"time [ms]\"") == 1u);
  BOOST_TEST(count_of(with, "data-right=\"time [c]\"") == 1u);
  const auto low = [&](const std::string& name) {
    const std::string word = "data-" + name + "-range=\"";
    return std::stod(with.substr(with.find(word) + word.size()));
  };
  constexpr double c_ms = 5e-3;
  EHD_CHECK(error(low("y") / low("right"), c_ms), Tolerance::required(1e-6, "ends are written to ten digits"));
  const std::string without =
      figure(made_page([](report::Documents& documents) { documents.bench["work_precision"].erase("c_s"); }));
  BOOST_TEST(count_of(without, "data-right") == 0u);
}

// A dome of height 1 with a spike of 6: the dome keeps most of the figure, and a label has the spike's height.
BOOST_AUTO_TEST_CASE(a_tall_spike_does_not_flatten_the_dome) {
  const auto panel = [](double spike) {
    std::vector<double> X, P, H;
    for (int i = 0; i <= 400; ++i) {
      const double x = -2 + 3.5 * i / 400;
      X.push_back(x);
      P.push_back(std::sqrt(std::max(0.0, 1 - x * x)) + (spike - 0.5) * std::exp(-std::pow((x - 0.8525) / 0.01, 2)));
      H.push_back(0.1);
    }
    return report::contact_figure("fig", "made", {{"fast", X, P, H}}).panels.front();
  };
  BOOST_TEST(!panel(1.2).y.high.has_value());
  BOOST_TEST(panel(1.2).rules.empty());
  BOOST_REQUIRE(panel(6).y.high.has_value());
  BOOST_TEST(*panel(6).y.high <= 1.5);
  BOOST_TEST(*panel(6).y.high >= 1.1);
  BOOST_REQUIRE_EQUAL(panel(6).rules.size(), 1u);
  BOOST_TEST(panel(6).rules.front().label.starts_with("spike to 6"));
}

// A spike is drawn as the grid has it, although its height is not known: the figure says so, and leaves room above it.
BOOST_AUTO_TEST_CASE(a_spike_of_unknown_height_is_marked) {
  const auto figure = [](std::optional<report::Point> vague, std::optional<double> cut, double dome) {
    report::ContactCurves curves{.name = "fast", .X = {}, .P = {}, .H = {}, .P_cut = cut, .vague_spike = vague};
    constexpr int nodes = 801;
    for (int i = 0; i < nodes; ++i) {
      const double x = -2 + 3.2 * i / (nodes - 1);
      curves.X.push_back(x);
      curves.P.push_back(dome * std::sqrt(std::max(0.0, 1 - x * x)) + 0.4 * std::exp(-std::pow((x - 0.9) / 0.005, 2)));
      curves.H.push_back(0.1);
    }
    return report::contact_figure("fig", "made", {curves});
  };
  const auto said = [](const report::Figure& one) {
    return count_of(report::draw(one, report::Place::file), ">spike: height not known<");
  };
  const report::Figure marked = figure(report::Point{0.9, 0.83}, {}, 1);
  BOOST_TEST(said(figure({}, {}, 1)) == 0u);
  BOOST_TEST(said(marked) == 1u);
  BOOST_REQUIRE(marked.panels.front().y.high.has_value());
  BOOST_TEST(*marked.panels.front().y.high >= 1.2);
  BOOST_TEST(count_of(report::draw(marked, report::Place::file), "unresolved") == 0u);
  // The rule of a curve that is cut says the same.
  BOOST_TEST(said(figure(report::Point{0.9, 0.83}, 0.83, 1)) == 0u);
  // A spike far above the dome: its drawn height is not stated as if it were known.
  for (const report::Figure& tall : {figure(report::Point{0.9, 0.44}, {}, 0.1), figure({}, 0.44, 0.1)}) {
    BOOST_TEST(count_of(report::draw(tall, report::Place::file), ">spike to") == 0u);
    BOOST_TEST(said(tall) == 1u);
  }
}

// Invariant: laws of the table look different, and a law that this program does not know has a look too.
BOOST_AUTO_TEST_CASE(every_law_has_a_look_of_its_own) {
  std::set<std::tuple<int, int, int>> looks;
  const auto key = [](const std::string& law) {
    const report::Look look = report::look_of_law(law);
    return std::tuple(static_cast<int>(look.line), static_cast<int>(look.marker), look.colour);
  };
  for (const bearing::LawRow& row : bearing::law_rows()) looks.insert(key(std::string(row.name)));
  BOOST_TEST(looks.size() == bearing::law_rows().size());
  BOOST_TEST((key("of-tomorrow") == key("of-tomorrow")));
  BOOST_TEST((key("of-tomorrow") != key("of-yesterday")));
}

// A spike of unknown height is cut by who writes the data; the figure says so.
BOOST_AUTO_TEST_CASE(a_cut_pressure_is_called_unresolved) {
  const auto figure = [](std::optional<double> cut) {
    return report::contact_figure("fig", "made", {{"fast", {-1, 0, 0.9, 1}, {0, 1, 1.5, 0}, {1, 0.1, 0.1, 0.1}, cut}});
  };
  BOOST_TEST(figure({}).panels.front().rules.empty());
  BOOST_REQUIRE_EQUAL(figure(1.5).panels.front().rules.size(), 1u);
  BOOST_TEST(figure(1.5).panels.front().rules.front().y == 1.5);
  BOOST_TEST(count_of(report::draw(figure(1.5), report::Place::file), "unresolved") > 0u);
}

// The oil ends at the exit, next to the spike: the frame does not.
BOOST_AUTO_TEST_CASE(the_frame_keeps_off_the_spike_at_the_exit) {
  const auto figure = report::contact_figure(
      "fig", "made", {{"fast", {-2, -1, 0, 0.99, 1}, {0, 0.1, 1, 0.8, 0}, {1, 1, 0.1, 0.1, 0.1}}});
  BOOST_TEST(figure.panels.front().x.high.value() >= 1.05);
}

// A browser would break a line behind the hyphen of 1e-5.
BOOST_AUTO_TEST_CASE(a_number_with_an_exponent_is_not_broken) {
  const std::string page = made_page([](report::Documents& documents) {
    documents.results["claims"][0]["note"] = "4.2e-5, 8.6(4)e-12 and 3e5; made-2 e-7; under 1e-";
  });
  for (const char* whole : {"<span class=\"whole\">4.2e-5</span>, <span class=\"whole\">8.6(4)e-12</span> and 3e5; "
                            "made-2 e-7; under 1e-",
                            ".whole{white-space:nowrap}"})
    BOOST_TEST(page.find(whole) != std::string::npos, whole);
  for (std::size_t at = 0; (at = page.find("<svg", at)) != std::string::npos; ++at)
    BOOST_TEST(page.substr(at, page.find("</svg>", at) - at).find("class=\"whole\"") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(results_that_nobody_can_place_are_refused_with_their_path) {
  const struct {
    const char* where;
    Json value;
    std::string said;
  } edits[] = {
      {"/claims/1/verdict", "passed", "results.json: claims[1]: verdict: \"passed\" is no verdict; required is pass,"},
      {"/claims/1/verdict", "", "results.json: claims[1]: verdict: \"\" is no verdict"},
      {"/claims/1/verdict", "pa\nss", "claims[1]: verdict: \"pa\\nss\" is no verdict"},
      {"/claims/1/verdict", nullptr, "results.json: claims[1]: verdict: is missing"},
      {"/claims/1/verdict", true, "results.json: claims[1]: verdict: is a boolean"},
      {"/claims/0/rung", 12, "results.json: claims[0]: rung: 12 is no rung; required is an integer from 0 to 11"},
      {"/claims/0/rung", -1, "results.json: claims[0]: rung: -1 is no rung"},
      {"/claims/0/rung", 3.5, "results.json: claims[0]: rung: 3.5 is no rung"},
      {"/claims/0/rung", nullptr, "results.json: claims[0]: rung: is missing"},
      {"/skipped/0/rung", 99, "results.json: skipped[0]: rung: 99 is no rung"},
      {"/rungs/2/rung", 1e300, "results.json: rungs[2]: rung: 1e300 is no rung"},
      {"/claims", nullptr, "results.json: claims: is missing"},
      {"/summary", nullptr, "results.json: summary: is missing"},
      {"/summary", 1, "results.json: summary: is a number; required is an object"},
      {"/provenance", nullptr, "results.json: provenance: is missing"},
      {"/provenance", Json::array(), "results.json: provenance: is a list; required is an object"},
  };
  for (const auto& edit : edits) {
    BOOST_TEST_CONTEXT(edit.said) {
      try {
        (void)made_page(
            [&](report::Documents& documents) { documents.results[Json::json_pointer(edit.where)] = edit.value; });
        BOOST_ERROR("nothing was thrown");
      } catch (const report::ReportError& error) {
        BOOST_TEST(std::string(error.what()).find(edit.said) != std::string::npos, error.what());
      }
    }
  }
  BOOST_CHECK_THROW(
      (void)made_page([](report::Documents& documents) { documents.stress["parts"][0]["verdict"] = "maybe"; }),
      report::ReportError);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_missing_or_strange_leave_a_gap) {
  for (const char* where :
       {"/figures/cases/0/solvers/0/P/3", "/figures/cases/0/M", "/figures/convergence/0/points/1/error",
        "/figures/maps/points/3/film_minimum_moes", "/figures/bearing/0/laws/0/rollers/2/inner/force_N",
        "/figures/force_law/0/force_N/1", "/rungs/7/worst_margin"}) {
    for (const Json& value : {Json(nullptr), Json(0), Json(-1e300), Json(1e300), Json(-1.7e308)}) {
      const std::string page =
          made_page([&](report::Documents& documents) { documents.results[Json::json_pointer(where)] = value; });
      BOOST_TEST(unbalanced(page) == "", where);
      BOOST_TEST(count_of(page, ",nan") + count_of(page, "\"nan") + count_of(page, " nan") == 0u, where);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_value_of_the_wrong_type_is_named) {
  try {
    (void)made_page(
        [](report::Documents& documents) { documents.results["figures"]["cases"][1]["solvers"][0]["X"] = "many"; });
    BOOST_ERROR("nothing was thrown");
  } catch (const report::ReportError& error) {
    BOOST_TEST(std::string(error.what()) ==
               "results.json: figures: cases[1]: solvers[0]: X: is a string; required is a list");
  }
}

BOOST_AUTO_TEST_CASE(the_command_writes_the_page_and_refuses_in_one_line) {
  const test::Folder folder;
  const auto page = folder.path() / "report.html";
  const auto run = [&] { return test::ehd_run(folder, "report " + folder.path().string()); };
  const auto refused = [&](const char* what) {
    const auto ended = run();
    BOOST_TEST(ended.exit_code == 2, what);
    BOOST_TEST(ended.error_lines() == 1, what);
    BOOST_TEST(ended.out == "", what);
    BOOST_TEST(!std::filesystem::exists(page), what);
    return ended.err;
  };
  BOOST_TEST(refused("no results.json").find("ehd verify --output") != std::string::npos);
  for (const char* text :
       {"", "{", "[]", "{}", "{\"schema\": 1}", "{\"schema\": \"2\"}", "{\"schema\": 2, \"claims\": 5}",
        "{\"schema\": 2}",
        R"({"schema": 2, "claims": [{"verdict": "maybe", "rung": 1}], "summary": {}, "provenance": {}})",
        R"({"schema": 2, "claims": [{"verdict": "pass", "rung": 12}], "summary": {}, "provenance": {}})"}) {
    (void)folder.write("results.json", text);
    BOOST_TEST(refused(text).find("results.json") != std::string::npos);
  }
  (void)folder.write("results.json", json_text(test::made_results()));
  (void)folder.write("bench.json", "{\"schema\": 99}");
  BOOST_TEST(refused("bench.json of another schema").find("bench.json") != std::string::npos);
  (void)folder.write("bench.json", json_text(test::made_bench()));
  std::filesystem::create_directory(page);  // cannot be written, whoever runs the test
  const auto blocked = run();
  BOOST_TEST(blocked.exit_code == 2);
  BOOST_TEST(blocked.error_lines() == 1);
  std::filesystem::remove(page);
  const auto written = run();
  BOOST_TEST(written.exit_code == 0);
  BOOST_TEST(written.err == "");
  BOOST_TEST(test::read(page).starts_with("<!DOCTYPE html>"));
  BOOST_TEST(test::ehd_run(folder, "report " + (folder.path() / "none").string()).exit_code == 2);
  BOOST_TEST(test::ehd_run(folder, "report").exit_code == 2);
}

BOOST_AUTO_TEST_CASE(a_picture_has_the_units_of_its_case) {
  const test::Folder folder;
  const auto drawn = [&](const std::string& arguments) {
    const auto plot = folder.path() / "plot.svg";
    BOOST_TEST(test::ehd_run(folder, arguments + " --plot " + plot.string()).exit_code == 0, arguments);
    return test::read(plot);
  };
  const std::string si = drawn("solve steel-roller --tolerance 1e-2"), groups = drawn("solve own-moes-5-5");
  BOOST_TEST(count_of(si, "[MPa]") == 1u);
  BOOST_TEST(count_of(si, "[\u00b5m]") == 2u);
  BOOST_TEST(count_of(groups, "[MPa]") == 0u);
  // The table omits the spike, and the figure says why; at 1e-6 the height is known.
  for (const std::string& coarse : {si, groups, drawn("solve own-moes-20-10")})
    BOOST_TEST(count_of(coarse, ">spike: height not known<") == 1u);
  BOOST_TEST(count_of(drawn("solve own-moes-20-10 --tolerance 1e-6"), "not known") == 0u);
  const std::string one = drawn("bearing na4908 --law hertz"), two = drawn("bearing na4908 na4908-10um --law hertz");
  BOOST_TEST(count_of(one, "id=\"polar\"") == 1u);
  BOOST_TEST(count_of(two, "id=\"polar-0\"") + count_of(two, "id=\"polar-1\"") == 2u);
  BOOST_TEST(count_of(two, "<svg ") == 5u);  // side by side
  for (const char* title :
       {">na4908-10um</text>", ">na4908-10um: contact force</text>", ">na4908-10um: displacement</text>"})
    BOOST_TEST(count_of(two, title) == 1u, title);
  const std::string four = drawn("bearing na4908 na4908-2.5um na4908-10um harris-209 --law hertz");
  BOOST_TEST(count_of(four, "id=\"polar") == 0u);
  BOOST_TEST(count_of(four, "<svg ") == 5u);
}

BOOST_AUTO_TEST_CASE(solve_and_bearing_draw_a_picture_whole_or_not_at_all) {
  const test::Folder folder;
  const auto plot = folder.path() / "plot.svg";
  for (const std::string arguments :
       {"solve own-moes-5-5 --tolerance 1e-2", "solve dry-steel", "bearing na4908 na4908-10um --law hertz"}) {
    const auto ended = test::ehd_run(folder, arguments + " --plot " + plot.string());
    BOOST_TEST(ended.exit_code == 0, arguments);
    const std::string svg = test::read(plot);
    BOOST_TEST(svg.starts_with("<?xml"), arguments);
    BOOST_TEST(unbalanced(svg) == "", arguments);
    BOOST_TEST(count_of(svg, "no data") == 0u, arguments);
    BOOST_TEST(count_of(svg, "class=\"line\"") >= 2u, arguments);
    std::filesystem::remove(plot);
    // Refused before anything is computed: an impossible path, the same file twice.
    for (const std::string& more : {" --plot " + (folder.path() / "none" / "plot.svg").string() + " --json -",
                                    fmt::format(" --plot {} --json {}", plot.string(), plot.string())}) {
      const auto refused = test::ehd_run(folder, arguments + more);
      BOOST_TEST(refused.exit_code == 2, arguments + more);
      BOOST_TEST(refused.error_lines() == 1, arguments + more);
      BOOST_TEST(refused.out == "", arguments + more);
    }
    BOOST_TEST(!std::filesystem::exists(plot), arguments);
    const auto streamed = test::ehd_run(folder, arguments + " --plot -");
    BOOST_TEST(streamed.exit_code == 2, arguments);
    BOOST_TEST(streamed.error_lines() == 1, arguments);
    BOOST_TEST(streamed.out == "", arguments);
    BOOST_TEST(streamed.err.find("--plot = -: is no file; allowed is a file's name") != std::string::npos,
               streamed.err);
    BOOST_TEST(!std::filesystem::exists("-"), arguments);
  }
}

BOOST_AUTO_TEST_SUITE_END()
