// SPDX-License-Identifier: GPL-3.0-or-later
// An oil by its grade in contact and bearing cases.
#include "io/read_oil.hpp"

#include <string>

#include "contact/nondimensional.hpp"
#include "contact/oil_grade.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// A contact in SI; `viscosity` stands in [conditions], `oil` in [lubricant].
std::string contact_text(const std::string& viscosity, const std::string& oil) {
  return "id = \"mine\"\nversion = 1\ntitle = \"t\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 1.1e5\n"
         "reduced_radius_m = 1.2e-2\nreduced_modulus_Pa = 2.2e11\nspeed_sum_m_per_s = 3.0\n" +
         viscosity + "[lubricant]\ndensity = \"dowson-higginson\"\n" + oil + "[domain]\ninlet = \"flooded\"\n";
}

ContactCase contact_with(const std::string& viscosity, const std::string& oil) {
  return std::get<ContactCase>(read_case(contact_text(viscosity, oil), "mine.toml").body);
}

std::string refusal(const std::string& viscosity, const std::string& oil) {
  try {
    (void)contact_with(viscosity, oil);
  } catch (const CaseError& wrong) {
    return wrong.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(read_oil)

BOOST_AUTO_TEST_CASE(a_contact_with_a_grade_is_that_with_the_viscosity_and_alpha_which_follow) {
  const ContactCase graded = contact_with("", "viscosity = \"roelands\"\niso_vg = 68\ntemperature_C = 60\n");
  BOOST_REQUIRE(graded.oil.has_value());
  BOOST_TEST(graded.oil->density_15C_kg_per_m3 == 870);
  BOOST_TEST(graded.oil->viscosity_index.value() == 95);
  BOOST_TEST(graded.oil->estimated_alpha_per_Pa.value() == graded.lubricant->alpha_per_Pa.value());
  // ISO VG 68, index 95, 60 C, worked out apart from the program: 28.37 mm2/s, 841.5 kg/m3, 1.930e-8 1/Pa.
  EHD_CHECK(error(graded.oil->viscosity_mm2_per_s, 28.37), Tolerance::published_digits("28.37"));
  EHD_CHECK(error(graded.oil->density_kg_per_m3, 841.5), Tolerance::published_digits("841.5"));
  EHD_CHECK(error(graded.oil->viscosity_Pa_s, 0.023876), Tolerance::published_digits("0.023876"));
  EHD_CHECK(error(*graded.lubricant->alpha_per_Pa, 1.930e-8), Tolerance::published_digits("1.930e-8"));
  const double eta = std::get<Conditions>(graded.statement).viscosity_Pa_s.value();
  BOOST_TEST(eta == graded.oil->viscosity_Pa_s);
}

BOOST_AUTO_TEST_CASE(an_alpha_or_a_z_that_is_stated_is_not_estimated) {
  const std::string grade = "iso_vg = 46\nviscosity_index = 110\ntemperature_C = 70.5\n";
  const ContactCase alpha = contact_with("", "viscosity = \"barus\"\nalpha_per_Pa = 2.3e-8\n" + grade);
  BOOST_TEST(!alpha.oil->estimated_alpha_per_Pa.has_value());
  BOOST_TEST(alpha.lubricant->alpha_per_Pa.value() == 2.3e-8);
  const ContactCase z = contact_with("", "viscosity = \"roelands\"\nz = 0.64\n" + grade);
  BOOST_TEST(!z.oil->estimated_alpha_per_Pa.has_value());
  BOOST_TEST(!z.lubricant->alpha_per_Pa.has_value());
  const ContactCase none = contact_with("", "viscosity = \"isoviscous\"\n" + grade);
  BOOST_TEST(!none.oil->estimated_alpha_per_Pa.has_value());
  BOOST_TEST(contact_with("", "viscosity = \"barus\"\nz = 0.64\n" + grade).oil->estimated_alpha_per_Pa.has_value());
}

BOOST_AUTO_TEST_CASE(two_viscosities_state_an_oil_as_well) {
  const ContactCase contact = contact_with("",
                                           "viscosity = \"roelands\"\nviscosity_40C_mm2_per_s = 73.3\n"
                                           "viscosity_100C_mm2_per_s = 8.86\ntemperature_C = 40\n"
                                           "density_15C_kg_per_m3 = 880\n");
  EHD_CHECK(error(contact.oil->viscosity_mm2_per_s, 73.3), Tolerance::round_off(64, 40));
  BOOST_TEST(contact.oil->density_kg_per_m3 < 880);
  BOOST_TEST(!contact.oil->iso_vg.has_value());
}

BOOST_AUTO_TEST_CASE(a_bearing_takes_a_grade_in_place_of_its_viscosity) {
  std::string text = test::read(find_case("na4908"));
  const auto line = text.find("viscosity_Pa_s");
  const auto end = text.find('\n', line);
  text.replace(line, end - line, "iso_vg = 32\ntemperature_C = 80");
  const Case read = read_case(text, "na4908.toml");
  const auto& lubricant = *std::get<BearingCase>(read.body).lubricant;
  BOOST_REQUIRE(lubricant.oil.has_value());
  BOOST_TEST(lubricant.viscosity_Pa_s == lubricant.oil->viscosity_Pa_s);
}

// The numbers that the row of iso_vg in the key table names.
BOOST_AUTO_TEST_CASE(grades_below_10_have_a_viscosity_index_only_from_the_one_that_the_key_table_names) {
  for (const double grade : iso_viscosity_grades()) {
    const int from = grade < 5 ? 401 : grade == 5 ? 378 : grade == 7 ? 75 : -100;
    for (int index = -100; index <= 400; ++index)
      BOOST_TEST(viscosity_100C_mm2_per_s(*midpoint_of_grade_mm2_per_s(grade), index).has_value() == (index >= from),
                 "grade " << grade << ", index " << index);
  }
}

BOOST_AUTO_TEST_CASE(contradictions_and_gaps_are_refused) {
  const std::string law = "viscosity = \"roelands\"\n", T = "temperature_C = 60\n";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"iso_vg = 70\n" + T,
       "iso_vg = 70: is none of the allowed numbers; did you mean 68 or 100? allowed is one of 2, 3, 5, 7, 10"},
      {"iso_vg = 45\n" + T, "iso_vg = 45: is none of the allowed numbers; did you mean 32 or 46? allowed is one of 2"},
      {"iso_vg = 1\n" + T, "did you mean 2? allowed"},
      {"iso_vg = 5000\n" + T, "did you mean 3200? allowed"},
      {"iso_vg = -46\n" + T, "iso_vg = -46: is none of the allowed numbers; allowed is one of 2"},
      {"iso_vg = \"VG 68\"\n" + T, "is a text; did you mean 68? allowed is one of 2"},
      {"iso_vg = \"46\"\n" + T, "is a text; did you mean 46? allowed is one of 2"},
      {"iso_vg = \"thick\"\n" + T, "is a text; allowed is one of 2"},
      {"isovg = 46\n" + T, "isovg = 46: is unknown in [lubricant]; did you mean iso_vg?"},
      {"vg = 46\n" + T,
       "vg = 46: is unknown in [lubricant]; did you mean iso_vg (the oil's grade of ISO 3448, which sets eta_0)?"},
      {"iso_vg = 68\n", "[lubricant] temperature_C: is missing"},
      {"iso_vg = 68\ntemperature_C = 200\n", "is out of range; allowed is -50 to 150"},
      {"iso_vg = 3200\nviscosity_index = 0\ntemperature_C = -50\n", "leaves the range of ASTM D341"},
      {"iso_vg = 5\n" + T, "less than 2 mm2/s at 100 C"},
      {"iso_vg = 5\n" + T, "allowed is viscosity_index of at least 378, or viscosity_40C_mm2_per_s with"},
      {"iso_vg = 3\n" + T, "defines no index; allowed is viscosity_40C_mm2_per_s with"},
      {"iso_vg = 68\nviscosity_40C_mm2_per_s = 60\n" + T, "contradicts iso_vg"},
      {"viscosity_40C_mm2_per_s = 60\n" + T, "[lubricant] viscosity_100C_mm2_per_s: is missing"},
      {"viscosity_40C_mm2_per_s = 8\nviscosity_100C_mm2_per_s = 60\n" + T, "is not below the viscosity at 40 C"},
      {"viscosity_40C_mm2_per_s = 60\nviscosity_100C_mm2_per_s = 8\nviscosity_index = 95\n" + T,
       "contradicts the two viscosities"},
      {"viscosity_40C_mm2_per_s = 0.5\nviscosity_100C_mm2_per_s = 0.3\ntemperature_C = 120\ndensity_15C_kg_per_m3 = "
       "800\n",
       "ends above eta_0"},
  };
  for (const auto& [oil, phrase] : rows) {
    const std::string message = refusal("", law + oil);
    BOOST_CHECK_MESSAGE(message.find(phrase) != std::string::npos, "expected " << phrase << ", got: " << message);
  }
  BOOST_TEST(refusal("viscosity_Pa_s = 0.02\n", law + "iso_vg = 68\n" + T).find("contradicts the oil's grade") !=
             std::string::npos);
  BOOST_TEST(refusal("viscosity_Pa_s = 0.02\n", law + "alpha_per_Pa = 2e-8\n" + T).find("belongs to an oil") !=
             std::string::npos);
  const auto file = find_case("own-moes-20-10");
  const auto groups = [&] {
    (void)read_case(test::read(file), file,
                    {{"lubricant.iso_vg", std::int64_t{68}}, {"lubricant.temperature_C", 60.0}});
  };
  BOOST_CHECK_EXCEPTION(groups(), CaseError, [](const CaseError& wrong) {
    return std::string(wrong.what()).find("contradicts [moes]") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
