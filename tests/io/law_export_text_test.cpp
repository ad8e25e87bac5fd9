// SPDX-License-Identifier: GPL-3.0-or-later
// The four forms of a law's table, each read back by means of its own and held against the table's own evaluator.
#include "io/law_export_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/check.hpp"
#include "tests/files.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// A table that nobody solved: ln f, ln h and c are smooth functions of the approach.
LawExport made_law(bool damped) {
  LawExport law{.case_id = "made-bearing.1",
                .version = 3,
                .title = "Made */ #error /* by a stranger,=1+1, bearing.clearance_m = 5e-06",
                .raceway = bearing::Raceway::outer,
                .contact = {.length_m = 0.07,
                            .reduced_radius_m = 2.7e-3,
                            .reduced_modulus_Pa = 2.3e11,
                            .speed_sum_m_per_s = 9.5,
                            .viscosity_Pa_s = 0.021}};
  law.datum_m = 0.0123;
  law.table.errors = {.force = 1e-4, .stiffness = 2e-3, .film = 3e-5};
  if (damped) law.table.damping_N_s_per_m.emplace(), law.table.errors.damping = 5e-3;
  if (!damped) law.no_damping = "nobody asked";
  for (int k = 0; k < 9; ++k) {
    const double s = k / 8.0, d = -2e-6 + 5e-6 * s * (1 + s) / 2, f = 40 * std::exp(5 * s + 0.3 * s * s);
    law.table.approach_m.push_back(d);
    law.table.force_N.values.push_back(f);
    law.table.force_N.slopes.push_back(f * (1.1e6 + 4e5 * s));
    law.table.film_minimum_m.values.push_back(8e-7 * std::exp(-s));
    law.table.film_minimum_m.slopes.push_back(-0.2 - 0.1 * s);
    if (!damped) continue;
    law.table.damping_N_s_per_m->values.push_back(2000 * std::cos(4 * s));
    law.table.damping_N_s_per_m->slopes.push_back(-1e9 * s);
  }
  return law;
}

std::vector<double> approaches(const LawExport& law) {
  const double low = law.table.approach_m.front(), high = law.table.approach_m.back();
  std::vector<double> all{low, high, law.table.approach_m[4], low - 1e-9, high + 1e-9, testing::not_a_number};
  for (int i = 0; i < 200; ++i) all.push_back(low + std::fmod(0.618 * i, 1) * (high - low));
  return all;
}

/// Exponentials of up to 10, cubics of a dozen operations.
Tolerance rounding_of_a_cubic() { return Tolerance::round_off(100, 20); }

/// One line for each approach: status, force, stiffness, film, damping. The numbers count if the status is 0.
void check_lines(const std::string& text, const LawExport& law) {
  std::istringstream out(text);
  for (const double approach : approaches(law)) {
    std::string status, force, stiffness, film, damping;
    BOOST_REQUIRE(out >> status >> force >> stiffness >> film >> damping);
    const auto truth = law.table.at(approach);
    BOOST_TEST((status == "0") == truth.has_value());
    if (!truth) continue;
    EHD_CHECK(error(std::stod(force), truth->force_N), rounding_of_a_cubic());
    EHD_CHECK(error(std::stod(stiffness), truth->stiffness_N_per_m), rounding_of_a_cubic());
    EHD_CHECK(error(std::stod(film), truth->film_minimum_m), rounding_of_a_cubic());
    if (truth->damping_N_s_per_m)
      EHD_CHECK(std::abs(std::stod(damping) - *truth->damping_N_s_per_m) / 2000, rounding_of_a_cubic());
    else
      BOOST_TEST(std::isnan(std::stod(damping)));
  }
}

std::string lines_of(const std::vector<double>& values) {
  std::ostringstream text;
  text.precision(17);
  for (const double value : values) text << value << "\n";
  return text.str();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(law_export_text)

BOOST_AUTO_TEST_CASE(the_json_has_the_knots_and_both_kinds_of_errors) {
  const LawExport law = made_law(true);
  const auto json = nlohmann::json::parse(json_text(to_json(law)));
  BOOST_TEST(json["schema"] == "ehd-law-1");
  BOOST_TEST(json["case"] == "made-bearing.1");
  BOOST_TEST(json["version"] == 3);
  BOOST_TEST(json["title"] == law.title);
  BOOST_TEST(json["lubricant"].contains("viscosity"));
  BOOST_TEST(json["raceway"] == "outer");
  BOOST_TEST(json["datum_x0_m"] == 0.0123);
  BOOST_TEST(json["provenance"].contains("version"));
  BOOST_TEST(json["errors"]["table"]["stiffness"] == 2e-3);
  BOOST_TEST(json["errors"]["table"]["damping"] == 5e-3);
  BOOST_TEST(json["knots"]["delta_m"].get<std::vector<double>>() == law.table.approach_m);
  BOOST_TEST(json["knots"]["stiffness_N_per_m"].get<std::vector<double>>() == law.table.force_N.slopes);
  BOOST_TEST(json["knots"]["damping_slope"].get<std::vector<double>>() == law.table.damping_N_s_per_m->slopes);
  const auto undamped = nlohmann::json::parse(json_text(to_json(made_law(false))));
  BOOST_TEST(!undamped["knots"].contains("damping_N_s_per_m"));
  BOOST_TEST(!undamped["errors"]["table"].contains("damping"));
  BOOST_TEST(undamped["no_damping"] == "nobody asked");
  BOOST_TEST(json["status"] == "converged");
  BOOST_TEST(!json.contains("reason"));
}

BOOST_AUTO_TEST_CASE(a_law_that_a_limit_cut_short_says_so_and_what_is_not_known) {
  LawExport law = made_law(true);
  law.status = StopReason::limit_reached;
  law.why = "a contact took too long";
  law.force_error = std::numeric_limits<double>::infinity();
  for (const auto& text : {law_export_csv(law), fmt::format("{}", fmt::join(law_export_words(law), "\n"))}) {
    BOOST_TEST(text.find("Status: limit-reached; a contact took too long") != std::string::npos, text);
    BOOST_TEST(text.find("relative: force not known, stiffness ") != std::string::npos, text);
  }
  const auto json = nlohmann::json::parse(json_text(to_json(law)));
  BOOST_TEST(json["status"] == "limit-reached");
  BOOST_TEST(json["reason"] == "a contact took too long");
  BOOST_TEST(!json["errors"]["law"].contains("force"));
}

BOOST_AUTO_TEST_CASE(the_csv_has_comments_a_header_and_a_line_for_each_knot) {
  const LawExport law = made_law(true);
  std::istringstream text(law_export_csv(law));
  std::string line, comments;
  while (std::getline(text, line) && line.starts_with("#")) comments += line + "\n";
  for (const char* words : {"ehd-law-1", "made-bearing.1", "version 3", "outer raceway", "x_0 = 0.0123",
                            "sum speed 9.5", "Errors of the law", "Errors of the table", "cubic Hermite"})
    BOOST_CHECK_MESSAGE(comments.find(words) != std::string::npos, words << " is not in " << comments);
  BOOST_TEST(comments.find(",=") == std::string::npos);  // a spreadsheet would run this cell of the title
  BOOST_TEST(line == "delta_m,force_N,stiffness_N_per_m,film_minimum_m,film_slope,damping_N_s_per_m,damping_slope");
  for (std::size_t k = 0; k < law.table.approach_m.size(); ++k) {
    BOOST_REQUIRE(std::getline(text, line));
    BOOST_TEST(std::stod(line) == law.table.approach_m[k]);
    BOOST_TEST(std::stod(line.substr(line.rfind(',') + 1)) == law.table.damping_N_s_per_m->slopes[k]);
  }
  BOOST_TEST(!std::getline(text, line));
}

BOOST_AUTO_TEST_CASE(the_c_form_compiles_without_warnings_and_agrees_to_rounding) {
  for (const bool damped : {true, false}) {
    const test::Folder folder;
    const LawExport law = made_law(damped);
    const std::string prefix = law_export_prefix(law);
    BOOST_TEST(prefix == "ehd_made_bearing_1_outer");
    (void)folder.write("law.c", law_export_c(law));
    (void)folder.write("main.c", "#include <stdio.h>\nint " + prefix +
                                     "_law(double, double *, double *, double *, double *);\nextern const double " +
                                     prefix +
                                     "_error[4];\nint main(void)\n{\n  double d;\n  while (scanf(\"%lf\", &d) == 1) {\n"
                                     "    double f = -1, k = -1, h = -1, c = -1;\n    const int status = " +
                                     prefix + "_law(d, &f, &k, &h, &c);\n    if (" + prefix +
                                     "_law(d, 0, 0, 0, 0) != status) return 1;\n"
                                     "    printf(\"%d %.17g %.17g %.17g %.17g\\n\", status, f, k, h, c);\n  }\n"
                                     "  return " +
                                     prefix + "_error[1] == 0.002 ? 0 : 1;\n}\n");
    (void)folder.write("points.txt", lines_of(approaches(law)));
    const std::string at = "cd '" + folder.path().string() + "' && ";
    BOOST_REQUIRE(
        std::system((at + "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror law.c main.c -lm -o law").c_str()) == 0);
    BOOST_REQUIRE(std::system((at + "./law < points.txt > out.txt").c_str()) == 0);
    check_lines(test::read(folder.path() / "out.txt"), law);
  }
}

BOOST_AUTO_TEST_CASE(words_of_a_title_keep_their_letters_in_programs) {
  LawExport law = made_law(true);
  law.title = "A PREFIX of mine";
  for (const std::string& text : {law_export_c(law), law_export_matlab(law)}) {
    BOOST_TEST(text.find(law.title) != std::string::npos);
    BOOST_TEST(text.find("PREFIX_") == std::string::npos);
    BOOST_TEST(text.find(law_export_prefix(law) + "_law(") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(the_matlab_form_agrees_in_octave) {
  if (std::system("command -v octave-cli > /dev/null 2>&1") != 0) {
    BOOST_REQUIRE_MESSAGE(!std::getenv("EHD_REQUIRE_OCTAVE"), "octave-cli is not installed");  // make octave
    BOOST_TEST_MESSAGE("skipped: octave-cli is not installed (apt-get install octave)");
    return;
  }
  for (const bool damped : {true, false}) {
    const test::Folder folder;
    const LawExport law = made_law(damped);
    (void)folder.write(law_export_prefix(law) + "_law.m", law_export_matlab(law));
    (void)folder.write("points.txt", lines_of(approaches(law)));
    (void)folder.write("call_law.m",
                       "d = load('points.txt');\n[f, k, h, c] = " + law_export_prefix(law) +
                           "_law(d);\nprintf('%d %.17g %.17g %.17g %.17g\\n', [isnan(f), f, k, h, c].');\n");
    const std::string at = "cd '" + folder.path().string() + "' && ";
    BOOST_REQUIRE(std::system((at + "octave-cli --norc --silent call_law.m > out.txt").c_str()) == 0);
    check_lines(test::read(folder.path() / "out.txt"), law);
  }
}

BOOST_AUTO_TEST_SUITE_END()
