// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_citation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "io/case_reader.hpp"
#include "io/find_case.hpp"

using namespace ehd;

namespace {

/// What LaTeX would refuse or misread in a text: a special character without its backslash, where a formula between $
/// and $ may have ^ and _. Empty where there is nothing of it.
std::string misread_by_latex(std::string_view text) {
  bool in_formula = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;  // and what it protects
    } else if (text[i] == '$') {
      in_formula = !in_formula;
    } else if (std::string_view(in_formula ? "%&#~" : "%&#~^_").find(text[i]) != std::string_view::npos) {
      return std::string(text.substr(i - std::min<std::size_t>(i, 20), 40));
    }
  }
  return in_formula ? "a $ without its other" : "";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_citation)

BOOST_AUTO_TEST_CASE(latex_reads_every_entry_of_the_bibliography) {
  const auto bibliography = read_bibliography(cases_folder() / "references.bib");
  BOOST_TEST(bibliography.size() >= 25u);
  for (const auto& [key, entry] : bibliography)
    BOOST_CHECK_MESSAGE(misread_by_latex(entry.text).empty(), key << ": " << misread_by_latex(entry.text));
  const std::string sources = bibtex_of_sources(bibliography);
  BOOST_TEST(sources.find("$c_L = 35948\\, l^{8/9}$") != std::string::npos);  // the text of the file, unchanged
}

// The list gets shorter as somebody reads the sources, and never longer.
BOOST_AUTO_TEST_CASE(sources_have_a_title_and_a_year_but_those_that_nobody_here_has_read) {
  const std::set<std::string> no_title{"blok", "ertelgrubin"},
      no_year{"blok", "ertelgrubin", "harris", "nske728g", "own", "tsuhanonatocavalca"};
  for (const auto& [key, entry] : read_bibliography(cases_folder() / "references.bib")) {
    BOOST_CHECK_MESSAGE(entry.fields.contains("title") != no_title.contains(key), key);
    BOOST_CHECK_MESSAGE(entry.fields.contains("year") != no_year.contains(key), key);
  }
}

BOOST_AUTO_TEST_CASE(latex_reads_the_entry_of_every_case) {
  const auto bibliography = read_bibliography(cases_folder() / "references.bib");
  const auto cases = all_cases();
  BOOST_TEST(cases.size() >= 40u);
  for (const Case& any : cases) {
    const std::string entries = bibtex_of_cases({any}, bibliography);
    BOOST_CHECK_MESSAGE(misread_by_latex(entries).empty(), any.id << ": " << misread_by_latex(entries));
  }
}

BOOST_AUTO_TEST_CASE(the_words_of_a_case_are_protected) {
  Case any;
  any.id = "mine";
  any.version = 1;
  any.title = "50 % of c_L & #1, {x^2} ~ \\y for 3 $";
  any.source = "own";
  const std::string entries = bibtex_of_cases({any}, {});
  BOOST_TEST(entries.find("50 \\% of c\\_L \\& \\#1, \\{x\\textasciicircum{}2\\} \\textasciitilde{} "
                          "\\textbackslash{}y for 3 \\$") != std::string::npos,
             entries);
  BOOST_TEST(misread_by_latex(entries).empty(), misread_by_latex(entries));
}

BOOST_AUTO_TEST_CASE(only_files_in_the_folder_of_the_cases_are_benchmark_cases) {
  Case any;
  any.id = "own-moes-20-10";
  for (const auto& [file, expected] :
       {std::pair(cases_folder() / "own-moes-20-10.toml", true), std::pair(cases_folder() / "atlas" / "any.toml", true),
        std::pair(cases_folder() / ".." / "examples" / "cylinder-on-plate.toml", false),
        std::pair(std::filesystem::path("own-moes-20-10.toml"), false),
        std::pair(std::filesystem::path("/nowhere/own-moes-20-10.toml"), false)}) {
    any.file = file;
    BOOST_CHECK_MESSAGE(is_benchmark_case(any) == expected, file);
  }
}

BOOST_AUTO_TEST_CASE(the_citation_of_a_fit_states_no_uncertainty) {
  const std::string fit = bibtex_of_cases({read_case(find_case("herrebrugh1968-100-0"))}, {});
  BOOST_TEST(fit.find("film.couette = 1.0434 (moes, fit);") != std::string::npos, fit);
  BOOST_TEST(fit.find("relative uncertainty") == std::string::npos, fit);
  const std::string solved = bibtex_of_cases({read_case(find_case("own-moes-20-10"))}, {});
  BOOST_TEST(solved.find("computed, relative uncertainty ") != std::string::npos, solved);
}

BOOST_AUTO_TEST_CASE(a_bearing_case_has_its_inputs_by_the_keys_of_its_file) {
  const auto inputs_of = [](const std::string& id) {
    return cases_json({read_case(find_case(id))})["cases"][0].value("inputs", Json());
  };
  BOOST_TEST(inputs_of("own-moes-20-10").is_null());
  const Json dry = inputs_of("harris-209"), oiled = inputs_of("na4908");
  BOOST_TEST(!dry.contains("lubricant"));
  BOOST_TEST(dry["bearing"]["rollers"] == 14);
  BOOST_TEST(dry["operation"]["outer_speed_rpm"] == 0.0);
  BOOST_TEST(oiled["bearing"]["pitch_diameter_m"] == 0.053);
  BOOST_TEST(oiled["operation"]["inner_speed_rpm"] == 5000.0);
  BOOST_TEST(oiled["lubricant"]["viscosity_Pa_s"] == 0.02);
  BOOST_TEST(oiled["lubricant"]["viscosity"] == "roelands");
  BOOST_TEST(oiled["datum"]["law"] == "palmgren");
  BOOST_TEST(oiled["fit"]["load_N"][1] == 12000.0);
}

BOOST_AUTO_TEST_CASE(the_problem_of_a_dry_contact_has_no_equation_of_a_film) {
  const auto equations_of = [](const char* id) {
    const Json json = cases_json({read_case(find_case(id))});
    return json["cases"][0]["problem"]["equations"].dump();
  };
  const std::string dry = equations_of("dry-steel"), lubricated = equations_of("own-moes-20-10");
  for (const char* part : {"lambda", "dP/dX", "inlet", "exit", "rho"}) {
    BOOST_CHECK_MESSAGE(dry.find(part) == std::string::npos, part << " is in " << dry);
    BOOST_CHECK_MESSAGE(lubricated.find(part) != std::string::npos, part << " is not in " << lubricated);
  }
  for (const char* part : {"ln|X - S|", "Int P dX = pi/2", "P H = 0"})
    BOOST_CHECK_MESSAGE(dry.find(part) != std::string::npos, part << " is not in " << dry);
}

BOOST_AUTO_TEST_CASE(what_latex_would_misread_is_found) {
  for (const char* wrong : {"c_L = 35948 l^(8/9)", "U^0.7", "50 %", "a & b", "#1", "$x", "$50 %$", "$x$ and y_1"})
    BOOST_CHECK_MESSAGE(!misread_by_latex(wrong).empty(), wrong);
  for (const char* right : {"$c_L = 35948\\, l^{8/9}$", "c\\_L", "50 \\%", "\\$3", "$a$ or $b_1$"})
    BOOST_CHECK_MESSAGE(misread_by_latex(right).empty(), right);
}

BOOST_AUTO_TEST_SUITE_END()
