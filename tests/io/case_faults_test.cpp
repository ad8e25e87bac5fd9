// SPDX-License-Identifier: GPL-3.0-or-later
// Unknown and missing keys are named all at once.
#include "io/case_faults.hpp"

#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/case_tree.hpp"
#include "io/read_contact.hpp"
#include "tests/check.hpp"
#include "workflow/case.hpp"

using namespace ehd;

namespace {

/// All lines of the refusal, without the file's name.
std::vector<std::string> refusal(const std::string& text) {
  std::vector<std::string> lines;
  try {
    (void)read_case(text, "mine.toml");
  } catch (const CaseError& wrong) {
    lines.emplace_back(wrong.what());
    lines.insert(lines.end(), wrong.more().begin(), wrong.more().end());
  }
  for (std::string& line : lines) line.erase(0, std::string("mine.toml:").size());
  return lines;
}

void check_lines(const std::string& text, const std::vector<std::string>& beginnings) {
  const auto lines = refusal(text);
  BOOST_REQUIRE_EQUAL(lines.size(), beginnings.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    BOOST_CHECK_MESSAGE(lines[i].starts_with(beginnings[i]), "expected " << beginnings[i] << ", got: " << lines[i]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_faults)

BOOST_AUTO_TEST_CASE(every_missing_key_of_a_contact_has_its_line) {
  check_lines("[conditions]\nload_N_per_m = 1e5\n[lubricant]\nviscosity = \"barus\"\n",
              {"1: id: is missing; required is", "1: version: is missing", "1: title: is missing",
               "1: source: is missing", "1: [conditions] reduced_radius_m: is missing",
               "1: [conditions] reduced_modulus_Pa: is missing", "1: [conditions] speed_sum_m_per_s: is missing",
               "1: [conditions] viscosity_Pa_s: is missing", "3: [lubricant] density: is missing",
               "1: [domain]: is missing; required is [lubricant] with [domain], or neither for a dry contact",
               "1: [domain] inlet: is missing"});
  check_lines("id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 20\nL = 10\n",
              {"1: [lubricant]: is missing", "1: [lubricant] viscosity: is missing",
               "1: [lubricant] density: is missing", "1: [domain]: is missing", "1: [domain] inlet: is missing"});
}

BOOST_AUTO_TEST_CASE(a_missing_problem_has_its_line_among_the_others) {
  check_lines("id = \"mine\"\nversion = 1\ntitel = \"t\"\n[lubricant]\nz = 0.7\n",
              {"3: titel = \"t\": is unknown; did you mean title?",
               "1: the problem is missing; required is exactly one of these: [moes] with", "1: source: is missing",
               "4: [lubricant] viscosity: is missing", "4: [lubricant] density: is missing"});
  check_lines("id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n", {"1: the problem is missing"});
}

BOOST_AUTO_TEST_CASE(every_missing_key_of_a_bearing_has_its_line_also_in_a_missing_table) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[bearing]\nrollers = 9\n"
      "roller_diameter_m = 0.01\nlength_m = 0.01\nclearance_m = 0\nrotating = \"inner\"\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n",
      {"5: [bearing] pitch_diameter_m: is missing", "5: [bearing] density_kg_per_m3: is missing",
       "1: [operation] speed_rpm: is missing", "1: [operation] radial_load_N: is missing",
       "1: [material] modulus_Pa: is missing", "1: [material] poisson: is missing",
       "11: [lubricant] viscosity_Pa_s: is missing"});
}

BOOST_AUTO_TEST_CASE(unknown_keys_come_first_with_the_nearest_key_which_then_does_not_count_as_missing) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitel = \"t\"\nsource = \"own\"\n[moes]\nM = 20\nLL = 10\n"
      "[lubrikant]\n[domain]\ninlet = -4\nspeed_rpm = 3\nnonsense = 4\n",
      {"3: titel = \"t\": is unknown; did you mean title? allowed is id, version, title, source",
       "7: LL = 10: is unknown in [moes]; allowed is M, L",
       "8: [lubrikant]: is unknown; did you mean [lubricant]? allowed is",
       "11: speed_rpm = 3: is unknown in [domain]; did you mean speed_rpm in [operation]? allowed is inlet",
       "12: nonsense = 4: is unknown in [domain]; allowed is inlet", "5: [moes] L: is missing",
       "8: [lubricant] viscosity: is missing", "8: [lubricant] density: is missing"});
}

BOOST_AUTO_TEST_CASE(the_keys_of_a_mistyped_table_are_checked_too) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[beering]\nrollers = 9\nlenght_m = 0.01\n"
      "[operation]\nspeed_rpm = 100\n[material]\nmodulus_Pa = 2e11\npoison = 0.3\n",
      {"5: [beering]: is unknown; did you mean [bearing]? allowed is",
       "7: lenght_m = 0.01: is unknown in [bearing]; did you mean length_m? allowed is",
       "12: poison = 0.3: is unknown in [material]; did you mean poisson? allowed is",
       "5: [bearing] pitch_diameter_m: is missing", "5: [bearing] roller_diameter_m: is missing",
       "5: [bearing] clearance_m: is missing", "5: [bearing] rotating: is missing",
       "5: [bearing] density_kg_per_m3: is missing", "8: [operation] radial_load_N: is missing"});
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 5\nL = 0\n[moess]\nL = 9\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n[domain]\ninlet = -4\n",
      {"8: [moess]: is unknown; did you mean [moes]? allowed is"});
}

BOOST_AUTO_TEST_CASE(a_contact_does_not_hear_of_the_keys_that_only_a_bearing_has) {
  const std::string heading = "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n",
                    oil = "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\nnonsense = 1\n";
  const auto names_eta_0 = [&](const std::string& problem) {
    return refusal(heading + oil + problem).at(0).find("viscosity_Pa_s") != std::string::npos;
  };
  BOOST_TEST(!names_eta_0("[domain]\ninlet = -4\n[moes]\nM = 20\nL = 10\n"));
  BOOST_TEST(names_eta_0("[bearing]\nrollers = 9\n"));
}

BOOST_AUTO_TEST_CASE(a_case_without_its_problem_says_which_keys_each_of_them_needs) {
  const std::string heading = "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n";
  check_lines(heading.substr(heading.find('\n') + 1) + "nonsense = 2\n[lubricant]\nviscosity = \"barus\"\n",
              {"4: nonsense = 2: is unknown",
               "1: the problem is missing; required is exactly one of these: [moes] with M, L, [domain] with inlet; or "
               "[conditions] with load_N_per_m, reduced_radius_m, reduced_modulus_Pa, speed_sum_m_per_s, "
               "viscosity_Pa_s, [domain] with inlet; or [hertz] with lambda, alpha_p_H, [domain] with inlet; or "
               "[bearing] with rollers, pitch_diameter_m, roller_diameter_m, length_m, clearance_m, rotating, "
               "density_kg_per_m3, [operation] with speed_rpm, radial_load_N, [material] with modulus_Pa, poisson",
               "1: id: is missing", "5: [lubricant] density: is missing"});
  const auto alone = refusal(heading);
  BOOST_REQUIRE_EQUAL(alone.size(), 1U);
  BOOST_TEST(alone[0].find("[moes] with M, L, [lubricant] with viscosity, density, [domain] with inlet; or "
                           "[conditions] with load_N_per_m, reduced_radius_m, reduced_modulus_Pa; or") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(tables_of_a_bearing_alone_mean_a_bearing_whose_keys_are_missing) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[operation]\nspeed_rpm = 100\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n",
      {"1: the problem is missing; required is [bearing]", "1: [bearing] rollers: is missing",
       "1: [bearing] pitch_diameter_m: is missing", "1: [bearing] roller_diameter_m: is missing",
       "1: [bearing] length_m: is missing", "1: [bearing] clearance_m: is missing", "1: [bearing] rotating: is missing",
       "1: [bearing] density_kg_per_m3: is missing", "5: [operation] radial_load_N: is missing",
       "1: [material] modulus_Pa: is missing", "1: [material] poisson: is missing",
       "7: [lubricant] viscosity_Pa_s: is missing"});
}

BOOST_AUTO_TEST_CASE(tables_that_are_too_many_come_with_what_is_missing) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 5\n[hertz]\n[conditions]\n"
      "[domain]\n[operation]\n",
      {"7: [hertz]: states the problem again, beside [moes]; allowed is exactly one of",
       "8: [conditions]: states the problem again, beside [moes]; allowed is exactly one of", "5: [moes] L: is missing",
       "1: [lubricant]: is missing", "1: [lubricant] viscosity: is missing", "1: [lubricant] density: is missing",
       "9: [domain] inlet: is missing"});
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 5\nL = 0\n[operation]\n[fit]\n"
      "[lubricant]\nviscosity = \"barus\"\n[domain]\ninlet = -4\n",
      {"8: [operation]: does not belong to a contact case; allowed is lubricant, domain, expect",
       "9: [fit]: does not belong to a contact case", "10: [lubricant] density: is missing"});
}

BOOST_AUTO_TEST_CASE(what_the_command_line_gave_is_refused_by_its_option) {
  const std::string text =
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 5\nL = 3\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n[domain]\ninlet = -4\n";
  const auto said = [&](const std::string& key, const TomlValue& value, const std::string& option) -> std::string {
    try {
      (void)read_case(text, "mine.toml", {{.key = key, .value = value, .option = option}});
    } catch (const CaseError& wrong) {
      return wrong.what();
    }
    return "";
  };
  BOOST_TEST(said("moes.M", -1.0, "--set moes.M=-1").starts_with("ehd: --set moes.M=-1: is negative; allowed is"));
  BOOST_TEST(said("moes.K", 1.0, "--set moes.K=1").starts_with("ehd: --set moes.K=1: is unknown in [moes]"));
  BOOST_TEST(said("hertz.lambda", 1.0, "--set hertz.lambda=1")
                 .starts_with("ehd: --set hertz.lambda=1: states the problem again, beside [moes]; allowed is"));
  BOOST_TEST(said("fit.points", 5.0, "--set fit.points=5")
                 .starts_with("ehd: --set fit.points=5: does not belong to a contact case; allowed is"));
  // Where the eta_0 of a bearing stands, a contact has none.
  BOOST_TEST(said("lubricant.density_kg", 1.0, "--set lubricant.density_kg=1").find("viscosity_Pa_s") ==
             std::string::npos);
  BOOST_TEST(said("moes.M", -1.0, "").starts_with("mine.toml: M = -1.0: is negative"));
}

BOOST_AUTO_TEST_CASE(the_nearest_key_is_one_of_the_table_or_of_those_that_the_case_has_to_have) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[bearing]\nrollers = 9\n"
      "pitch_diameter_m = 0.06\nroller_dia_m = 0.01\nlength_m = 0.01\nclearance_m = 0\nrotating = \"inner\"\n"
      "density_kg_per_m3 = 7850\nspeed = 3000\nload_N = 5000\nlaw = \"palmgren\"\n"
      "[material]\nmodulus_Pa = 2.06e11\npoisson = 0.3\n",
      {"8: roller_dia_m = 0.01: is unknown in [bearing]; did you mean roller_diameter_m (diameter of a roller, smaller "
       "than the pitch circle)? allowed is",
       "13: speed = 3000: is unknown in [bearing]; did you mean speed_rpm in [operation] (speed of the ring that "
       "turns)? allowed is",
       "14: load_N = 5000: is unknown in [bearing]; did you mean radial_load_N in [operation] (radial load F_r)? "
       "allowed is",
       "15: law = \"palmgren\": is unknown in [bearing]; did you mean law in [datum]? allowed is"});
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_m = 1e5\n"
      "reduced_radius_m = 0.01\nreduced_modulus_Pa = 2.2e11\nspeed_m_per_s = 3\n",
      {"6: load_N_m = 1e5: is unknown in [conditions]; did you mean load_N_per_m (load per length of the contact)? "
       "allowed is",
       "9: speed_m_per_s = 3: is unknown in [conditions]; did you mean speed_sum_m_per_s (u_s = u_1 + u_2, the sum of "
       "the surface speeds, not the mean)? allowed is"});
}

BOOST_AUTO_TEST_CASE(a_suggested_key_says_what_it_is_where_the_names_differ_in_more_than_a_slip) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N = 1e5\n"
      "reduced_radius_mm = 0.01\nyoungs_modulus_Pa = 2.1e11\nspeed_mean_m_per_s = 3\n",
      {"6: load_N = 1e5: is unknown in [conditions]; did you mean load_N_per_m (load per length of the contact)?",
       "7: reduced_radius_mm = 0.01: is unknown in [conditions]; did you mean reduced_radius_m? allowed",
       "8: youngs_modulus_Pa = 2.1e11: is unknown in [conditions]; did you mean reduced_modulus_Pa (E', not Young's "
       "modulus: 2/E' = ",
       "9: speed_mean_m_per_s = 3: is unknown in [conditions]; did you mean speed_sum_m_per_s (u_s = u_1 + u_2, the "
       "sum of the surface speeds, not the mean)?"});
}

BOOST_AUTO_TEST_CASE(a_missing_viscosity_may_be_stated_by_the_grade_of_the_oil) {
  const std::string contact =
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1e5\n"
      "reduced_radius_m = 0.01\nreduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 3\n[domain]\ninlet = -4\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n";
  check_lines(contact, {"5: [conditions] viscosity_Pa_s: is missing; required is a number, 1e-12 to 1e9; or the oil's "
                        "grade, iso_vg with temperature_C in [lubricant]"});
  check_lines(contact + "temperature_C = 60\n",
              {"5: [conditions] viscosity_Pa_s: is missing; required is iso_vg in [lubricant], to which temperature_C "
               "belongs; or a number, 1e-12 to 1e9, without temperature_C"});
}

BOOST_AUTO_TEST_CASE(a_viscosity_that_stands_in_the_table_of_bearings_is_said_to_belong_elsewhere) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1e5\n"
      "reduced_radius_m = 0.01\nreduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 3\n[domain]\ninlet = -4\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\nviscosity_Pa_s = 0.02\n",
      {"5: [conditions] viscosity_Pa_s: is missing; required is a number, 1e-12 to 1e9; that in [lubricant] belongs "
       "here, in a contact"});
}

// No key of [notes] is one of [moes], which the name resembles.
BOOST_AUTO_TEST_CASE(an_unknown_table_is_one_line) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1e5\n"
      "reduced_radius_m = 0.01\nreduced_modulus_Pa = 2.2e11\n[notes]\na = 1\n",
      {"9: [notes]: is unknown; did you mean [moes]? allowed is"});
}

// The oil is stated by its grade: no viscosity is missing, but the temperature is.
BOOST_AUTO_TEST_CASE(a_mistyped_grade_counts_as_the_grade) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1e5\n"
      "reduced_radius_m = 0.01\nreduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 3\n[lubricant]\n"
      "viscosity = \"barus\"\ndensity = \"incompressible\"\niso_vgg = 68\n[domain]\ninlet = -4\n",
      {"13: iso_vgg = 68: is unknown in [lubricant]; did you mean iso_vg?",
       "10: [lubricant] temperature_C: is missing"});
}

BOOST_AUTO_TEST_CASE(a_reader_of_tables_alone_refuses_unknown_keys_too) {
  const std::string text = "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\nalfa_per_Pa = 2e-8\n";
  const std::vector<Substitution> stated{{"moes.M", 5.0}, {"moes.L", 5.0}, {"domain.inlet", std::string("flooded")}};
  const auto read = [&](const std::string& of) { return read_contact(CaseTree(of, "lubricant", stated), "moes"); };
  BOOST_CHECK_EXCEPTION((void)read(text), CaseError, [](const CaseError& wrong) {
    return std::string(wrong.what()).find("alfa_per_Pa = 2e-8: is unknown") != std::string::npos;
  });
  BOOST_CHECK_NO_THROW((void)read(text.substr(0, text.find("alfa"))));
}

BOOST_AUTO_TEST_CASE(a_case_without_faults_of_keys_names_every_wrong_value) {
  check_lines(
      "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = -1\nL = -1\n"
      "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n[domain]\ninlet = -4\n",
      {"6: M = -1: is negative", "7: L = -1: is negative"});
}

BOOST_AUTO_TEST_SUITE_END()
