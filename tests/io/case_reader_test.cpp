// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "contact/nondimensional.hpp"
#include "io/bibliography.hpp"
#include "io/find_case.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "workflow/case.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

/// A contact; its lines are numbered from 1, as in messages.
const std::vector<std::string> contact_lines{
    /*  1 */ "id = \"mine\"",
    /*  2 */ "version = 3",
    /*  3 */ "title = \"Spülöl, a comment may be UTF-8 too\"  # ja: ä",
    /*  4 */ "source = \"own\"",
    /*  5 */ "[moes]",
    /*  6 */ "M = 21.5",
    /*  7 */ "L = 9",
    /*  8 */ "[lubricant]",
    /*  9 */ "viscosity = \"roelands\"",
    /* 10 */ "density = \"dowson-higginson-1977\"",
    /* 11 */ "alpha_per_Pa = 2.3e-8",
    /* 12 */ "z = 0.67",
    /* 13 */ "p0_Pa = 1.97e8",
    /* 14 */ "[domain]",
    /* 15 */ "inlet = -4.5",
    /* 16 */ "[[expect]]",
    /* 17 */ "quantity = \"film.minimum\"",
    /* 18 */ "value = \"0.0741\"",
    /* 19 */ "scaling = \"hertz\"",
    /* 20 */ "uncertainty = 1e-8",
    /* 21 */ "kind = \"computed\"",
};

const std::vector<std::string> si_lines{
    /*  1 */ "id = \"mine\"",
    /*  2 */ "version = 1",
    /*  3 */ "title = \"SI\"",
    /*  4 */ "source = \"own\"",
    /*  5 */ "[conditions]",
    /*  6 */ "load_N_per_m = 1.1e5",
    /*  7 */ "reduced_radius_m = 1.2e-2",
    /*  8 */ "reduced_modulus_Pa = 2.2e11",
    /*  9 */ "speed_sum_m_per_s = 3.0",
    /* 10 */ "viscosity_Pa_s = 0.02",
    /* 11 */ "[lubricant]",
    /* 12 */ "viscosity = \"barus\"",
    /* 13 */ "density = \"incompressible\"",
    /* 14 */ "alpha_per_Pa = 2.0e-8",
    /* 15 */ "[domain]",
    /* 16 */ "inlet = \"flooded\"",
};

const std::vector<std::string> bearing_lines{
    /*  1 */ "id = \"mine\"",
    /*  2 */ "version = 1",
    /*  3 */ "title = \"a bearing\"",
    /*  4 */ "source = \"own\"",
    /*  5 */ "[bearing]",
    /*  6 */ "rollers = 21",
    /*  7 */ "pitch_diameter_m = 0.053",
    /*  8 */ "roller_diameter_m = 0.005",
    /*  9 */ "length_m = 0.121",
    /* 10 */ "clearance_m = 2.5e-6",
    /* 11 */ "rotating = \"outer\"",
    /* 12 */ "density_kg_per_m3 = 7850.0",
    /* 13 */ "[operation]",
    /* 14 */ "speed_rpm = 5000.0",
    /* 15 */ "radial_load_N = 50.0e3",
    /* 16 */ "[material]",
    /* 17 */ "modulus_Pa = 2.06e11",
    /* 18 */ "poisson = 0.3",
    /* 19 */ "[lubricant]",
    /* 20 */ "viscosity = \"roelands\"",
    /* 21 */ "density = \"dowson-higginson\"",
    /* 22 */ "viscosity_Pa_s = 0.02",
    /* 23 */ "alpha_per_Pa = 2.0e-8",
    /* 24 */ "[datum]",
    /* 25 */ "law = \"x0\"",
    /* 26 */ "x0_m = 0.02",
    /* 27 */ "[fit]",
    /* 28 */ "load_N = [2000.0, 12000]",
    /* 29 */ "points = 7",
    /* 30 */ "[[expect]]",
    /* 31 */ "quantity = \"roller.3.inner.force\"",
    /* 32 */ "law = \"ehd-linear\"",
    /* 33 */ "status = \"waiting\"",
};

std::string joined(const std::vector<std::string>& lines, const std::string& line_end = "\n") {
  std::string text;
  for (const auto& line : lines) text += line + line_end;
  return text;
}

/// The base with one line replaced (line feeds in the replacement count as lines).
std::string with_line(const std::vector<std::string>& base, std::size_t line, const std::string& replacement) {
  std::vector<std::string> lines = base;
  lines.at(line - 1) = replacement;
  return joined(lines);
}

/// A line of a case, and the wrong line that replaces it.
struct BadLine {
  std::size_t replaced;
  std::string replacement;
  int line;                 ///< that the message must name
  std::string_view phrase;  ///< that the message must hold
};

std::string message_of(const std::filesystem::path& file) {
  try {
    (void)read_case(file);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

/// Every row is refused in one line, which names the file, the line and the key, and says what is allowed.
void check_refused(const std::vector<std::string>& base, const std::vector<BadLine>& rows) {
  BOOST_REQUIRE(!rows.empty());
  const test::Folder folder;
  for (const BadLine& row : rows) {
    const auto file = folder.write("mine.toml", with_line(base, row.replaced, row.replacement));
    const std::string message = message_of(file);
    const std::string place = fmt::format("{}:{}: ", file.string(), row.line);
    const auto says = [&](std::string_view phrase) { return message.find(phrase) != std::string::npos; };
    BOOST_TEST_CONTEXT("line " << row.replaced << " replaced by: " << row.replacement.substr(0, 80)) {
      BOOST_CHECK_MESSAGE(message.starts_with(place), "expected " << place << ", got: " << message);
      BOOST_CHECK_MESSAGE(says(row.phrase), "expected \"" << row.phrase << "\" in: " << message);
      BOOST_CHECK_MESSAGE(message.find_first_of("\n\r") == std::string::npos, "more than one line: " << message);
      BOOST_CHECK_MESSAGE(
          says("allowed") || says("required") || says("needs it") || says("roelands needs") || says("barus needs"),
          "the message does not say what is allowed: " << message);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_reader)

BOOST_AUTO_TEST_CASE(a_contact_is_read_with_every_value_in_its_place) {
  const test::Folder folder;
  const Case read = read_case(folder.write("mine.toml", joined(contact_lines)));
  BOOST_TEST(read.id == "mine");
  BOOST_TEST(read.version == 3);
  const auto& contact = std::get<ContactCase>(read.body);
  BOOST_TEST(!contact.dry());
  BOOST_TEST(std::get<MoesGroups>(contact.statement).M == 21.5);
  BOOST_TEST(std::get<MoesGroups>(contact.statement).L == 9);
  BOOST_CHECK(contact.lubricant->viscosity == ViscosityLaw::roelands);
  BOOST_CHECK(contact.lubricant->density == DensityLaw::dowson_higginson_1977);
  BOOST_TEST(contact.lubricant->alpha_per_Pa.value() == 2.3e-8);
  BOOST_TEST(contact.lubricant->z.value() == 0.67);
  BOOST_TEST(contact.lubricant->p0_Pa == 1.97e8);
  BOOST_TEST(std::get<TruncatedAt>(*contact.inlet).x == -4.5);
  BOOST_REQUIRE(read.expectations.size() == 1);
  const Expectation& expectation = read.expectations.front();
  BOOST_TEST(expectation.value == 0.0741);
  BOOST_TEST(expectation.digits == "0.0741");
  BOOST_TEST(expectation.uncertainty == 1e-8);
  BOOST_CHECK(expectation.kind == ExpectationKind::computed);
  BOOST_TEST(read.places.at("lubricant.z").line == 12);
}

BOOST_AUTO_TEST_CASE(a_bearing_is_read_with_every_value_in_its_place) {
  const test::Folder folder;
  const Case read = read_case(folder.write("mine.toml", joined(bearing_lines)));
  const auto& bearing = std::get<BearingCase>(read.body);
  BOOST_TEST(bearing.geometry.rollers == 21);
  BOOST_TEST(bearing.geometry.pitch_diameter_m == 0.053);
  BOOST_TEST(bearing.geometry.roller_diameter_m == 0.005);
  BOOST_TEST(bearing.geometry.length_m == 0.121);
  BOOST_TEST(bearing.geometry.clearance_m == 2.5e-6);
  BOOST_TEST(bearing.geometry.density_kg_per_m3 == 7850);
  BOOST_TEST(bearing.operation.inner_speed_rpm == 0);
  BOOST_TEST(bearing.operation.outer_speed_rpm == 5000);
  BOOST_TEST(bearing.operation.radial_load_N == 50e3);
  BOOST_TEST(bearing.modulus_Pa == 2.06e11);
  BOOST_TEST(bearing.poisson == 0.3);
  BOOST_TEST(bearing.lubricant->viscosity_Pa_s == 0.02);
  BOOST_TEST(std::get<LengthDatum>(bearing.datum).x0_m == 0.02);
  BOOST_TEST(bearing.fit.load_N->first == 2000);
  BOOST_TEST(bearing.fit.load_N->second == 12000);
  BOOST_TEST(bearing.fit.points == 7);
  BOOST_TEST(read.expectations.at(0).waiting);
  BOOST_TEST(read.expectations.at(0).law == "ehd-linear");
}

BOOST_AUTO_TEST_CASE(a_dry_contact_needs_neither_speed_nor_viscosity) {
  const test::Folder folder;
  const std::vector<std::string> dry(si_lines.begin(), si_lines.begin() + 8);
  const Case read = read_case(folder.write("mine.toml", joined(dry)));
  const auto& contact = std::get<ContactCase>(read.body);
  BOOST_TEST(contact.dry());
  BOOST_TEST(!std::get<Conditions>(contact.statement).speed_sum_m_per_s.has_value());
}

BOOST_AUTO_TEST_CASE(line_ends_of_another_system_and_a_byte_order_mark_are_read) {
  const test::Folder folder;
  const Case read = read_case(folder.write("mine.toml", "\xEF\xBB\xBF" + joined(contact_lines, "\r\n")));
  BOOST_TEST(read.places.at("lubricant.z").line == 12);
}

BOOST_AUTO_TEST_CASE(the_default_uncertainty_is_half_of_the_last_digit) {
  const test::Folder folder;
  const Case read = read_case(folder.write("mine.toml", with_line(contact_lines, 20, "")));
  EHD_CHECK(error(read.expectations.at(0).uncertainty, 0.00005 / 0.0741), Tolerance::round_off(10));
}

BOOST_AUTO_TEST_CASE(a_wrong_heading_is_refused) {
  const std::vector<BadLine> rows{
      {1, "id = \"other\"", 1, "differs from the file's name; allowed is \"mine\""},
      {1, "", 1, "id: is missing"},
      {1, "id = 7", 1, "is an integer; allowed is a text"},
      {1, "id = \"\"", 1, "is empty"},
      {2, "version = 1.5", 2, "version = 1.5: is a number; allowed is an integer"},
      {2, "version = 0", 2, "is out of range"},
      {2, "version = 9223372036854775807", 2, "is out of range"},
      {2, "version = 99999999999999999999", 2, "is too large for an integer"},
      {3, "title = \"two\\nlines\"", 3, "is not one line"},
      {3, "titel = \"x\"", 3, "titel = \"x\": is unknown; did you mean title? allowed is"},
      {4, "source = true", 4, "is a boolean"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(duplicates_and_what_is_no_toml_are_refused) {
  const std::vector<BadLine> rows{
      {7, "L = 9\nM = 3", 8, "duplicate"},
      {14, "[moes]", 14, "duplicate"},
      {7, "L = ", 7, "L =: has no value; allowed is a number, 0, or 1e-12 to 100, for example 10.0"},
      {7, "L", 7, "allowed is TOML"},
      {5, "[moes", 5, "allowed is TOML"},
      {5, "[ = moes]", 5, "[ = moes]: is no table; allowed is [name] or [[name]]"},
      {16, " [[", 16, "is no table"},
      {9, "viscosity = \"roelands", 9, "not closed"},
      {7, "L = 9 z = 3", 7, "allowed is TOML"},
      {7, "L = 9,5", 7, "L = 9,5: has a comma in a number; allowed is a point, 9.5"},
      {7, "L = 9,5e-1", 7, "L = 9,5e-1: has a comma in a number; allowed is a point, 9.5e-1"},
      {7, "L = nine", 7, "L = nine: is a text; allowed is a number, 0, or 1e-12 to 100, for example 10.0"},
      {7, "L = \"9 mm\"", 7, "has a unit, which belongs to the key's name; allowed is a number, 0, or 1e-12 to 100"},
      {7, "L = [9,5", 8, "allowed is TOML"},
      {7, "L = 9 mm  # wide", 7, "L = 9 mm: has a unit; allowed is the number alone, in the unit that the key names"},
      {7, "L = 1e-3m", 7, "has a unit; allowed is the number alone"},
      {7, "L = 1D1", 7, "L = 1D1: is no number in TOML; allowed is a number, 0, or 1e-12 to 100, for example 10.0"},
      {7, "L = .5", 7, "L = .5: is no number in TOML; allowed is a number, 0, or 1e-12 to 100, for example 10.0"},
      {7, "L = 05", 7, "L = 05: is no number in TOML"},
      {7, "L = 1 000", 7, "L = 1 000: is no number in TOML"},
      {7, "L = 1;", 7, "L = 1;: is no number in TOML"},
      {7, "L = 5\nL = 6", 8, "L = 6: is a duplicate"},
      {7, "L = 0x", 7, "L = 0x: is no hexadecimal, octal or binary number; allowed is a decimal number"},
      {7, "L = 0b2", 7, "L = 0b2: is no hexadecimal, octal or binary number"},
      {7, "L = -0x1", 7, "L = -0x1: is no hexadecimal, octal or binary number"},
      {7, "L = 0o8 # eight", 7, "L = 0o8: is no hexadecimal, octal or binary number"},
      {9, "viscosity = barus", 9, "is a text without quotation marks; allowed is \"barus\""},
      {9, "viscosity = inner", 9, "is a text without quotation marks; allowed is \"inner\""},
      {9, "viscosity = barus law", 9, "allowed is TOML"},
      {9, "[viscosity = nan", 9, "allowed is TOML"},
      {9, "\"viscosity\" ity\" = -inf", 9, "allowed is TOML"},
      {7, "Ä = 9", 7, "'Ä' outside a string or comment; allowed is ASCII"},
      {7, "L = 9\u00A0", 7, "outside a string or comment"},
      {7, "L = ９", 7, "outside a string or comment"},
      {3, "title = \"\xFF\"", 3, "\\xFF, which is not UTF-8"},
      {7, "L = 9 # \xC3", 7, "not UTF-8"},
      {7, "L = 9 # \x01", 7, "control character"},
      {7, std::string("L = [") + std::string(1500, '['), 7, "allowed is TOML"},
      {7, "L = 9 #" + std::string(3000, 'x'), 7, "more than 2000 bytes"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(a_wrong_id_on_standard_input_is_refused_with_its_line) {
  const auto said = [](const std::string& id) -> std::string {
    try {
      (void)read_case(fmt::format("version = 1\nid = \"{}\"\ntitle = \"t\"\nsource = \"own\"\n[moes]\nM = 5\nL = 3\n"
                                  "[lubricant]\nviscosity = \"barus\"\ndensity = \"incompressible\"\n[domain]\n"
                                  "inlet = -4\n",
                                  id),
                      "standard input");
    } catch (const CaseError& wrong) {
      return wrong.what();
    }
    return "";
  };
  BOOST_TEST(said("x y").starts_with("standard input:2: id = \"x y\": is no id; allowed is letters, digits"));
  BOOST_TEST(said("x.y") == "");
}

BOOST_AUTO_TEST_CASE(a_number_outside_its_range_is_refused) {
  const std::vector<BadLine> rows{
      {6, "M = -1.0", 6, "M = -1.0: is negative; allowed is 0.001 to 1e6"},
      {6, "M = 0", 6, "is zero"},
      {6, "M = nan", 6, "M = nan: is not finite"},
      {6, "M = -inf", 6, "is not finite"},
      {6, "M = 1e308", 6, "M = 1e308: is out of range"},
      {6, "M = 5e-324", 6, "is out of range"},
      {6, "M = 1e400", 6, "M = 1e400: is too large or too small for a number; allowed is a number, 0.001 to 1e6"},
      {7, "L = 1e-400", 7, "L = 1e-400: is too large or too small for a number; allowed is a number, 0, or 1e-12"},
      {7, "L_2 = 1e-400", 7, "L_2 = 1e-400: is too large or too small for a number; allowed is 0, or a size of"},
      {6, "M = 1e400 # heavy", 6, "M = 1e400: is too large or too small for a number"},
      {6, "M = 99999999999999999999 # heavy", 6, "M = 99999999999999999999: is too large for an integer"},
      {6, "M = 9223372036854775808", 6, "is too large for an integer; allowed is a number, 0.001 to 1e6, for example"},
      {6, "M_2 = 9223372036854775808", 6,
       "allowed is a size of up to 9223372036854775807, or a number with a decimal point"},
      {6, "M = 9223372036854775807", 6, "is out of range"},
      {6, "M = 0xEEEEEEEEEEEEEEEEE", 6, "is too large for an integer"},
      {6, "M = \"20\"", 6, "is a text; allowed is a number"},
      {6, "M = [20.0]", 6, "is an array; allowed is a number"},
      {6, "M = 1979-05-27", 6, "is a date or time"},
      {6, "", 5, "[moes] M: is missing"},
      {6, "M = 21.5\nW = 1.0", 7, "W = 1.0: is unknown in [moes]; allowed is M, L"},
      {7, "L = 100.1", 7, "is out of range; allowed is 0, or"},
      {7, "L = 5e-324", 7, "is out of range"},
      {11, "alpha_per_Pa = -2e-8", 11, "is negative"},
      {11, "alpha_per_Pa = 1e308", 11, "is out of range"},
      {12, "z = 5e-324", 12, "is out of range"},
      {12, "", 8,
       "[lubricant] z: is missing; roelands needs it where eta_0 is unknown; allowed is a number, 0.001 to 10"},
      {11, "", 8, "[lubricant] alpha_per_Pa: is missing"},
      {13, "p0_Pa = inf", 13, "is not finite"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(a_wrong_law_or_domain_is_refused) {
  const std::vector<BadLine> rows{
      {9, "viscosity = \"Barus\"", 9,
       "is unknown; did you mean \"barus\"? allowed is \"isoviscous\", \"barus\", \"roelands\""},
      {9, "viscosity = \"isoviscous\"", 9, "isoviscous contradicts L > 0"},
      {9, "", 8, "[lubricant] viscosity: is missing"},
      {10, "", 8, "[lubricant] density: is missing"},
      {10, "density = 1.2", 10, "is a number; allowed is a text"},
      {8, "[lubricant]\nviscosity_Pa_s = 0.1", 9, "is unknown in the [lubricant] of a contact"},
      {14, "[domein]", 14, "[domein]: is unknown"},
      {15, "", 14, "[domain] inlet: is missing"},
      {15, "inlet = -1.0", 15, "inside or behind the contact"},
      {15, "inlet = 4", 15, "inside or behind the contact"},
      {15, "inlet = -1e308", 15, "is out of range"},
      {15, "inlet = \"dry\"", 15, "is unknown; allowed is \"flooded\""},
      {15, "inlet = true", 15, "is a boolean"},
      {14, "x = 1\n[domain]", 14, "is unknown"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_stated_twice_or_not_at_all_is_refused) {
  const std::vector<BadLine> rows{
      {8, "[hertz]\nlambda = 1.0\nalpha_p_H = 2.0\n[lubricant]", 8, "states the problem again, beside [moes]"},
      {8, "[hertz]\n[conditions]\n[lubricant]", 8, "states the problem again"},
      {5, "[material]", 6, "M = 21.5: is unknown in [material]"},
      {14, "[operation]\n[domain]", 14, "does not belong to a contact case"},
      {14, "[[domain]]", 14, "is an array; allowed is a table, [domain]"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(a_wrong_expectation_is_refused) {
  const std::vector<BadLine> rows{
      {16, "[expect]", 16, "is a table; allowed is [[expect]]"},
      {17, "quantity = \"film.maximum\"", 17, "is unknown in a contact case"},
      {17, "quantity = \"roller.1.inner.force\"", 17, "is unknown in a contact case"},
      {17, "quantity = \"displacement\"", 17, "is unknown in a contact case"},
      {17, "", 16, "[[expect]] quantity: is missing"},
      {18, "value = 0.0741", 18, "is a number; allowed is a text"},
      {18, "value = \"0,0741\"", 18, "is not a decimal number"},
      {18, "value = \"nan\"", 18, "is not a decimal number"},
      {18, "value = \"0e400\"", 18, "has a last digit that is out of range"},
      {18, "value = \"0e308\"", 18, "has a last digit that is out of range"},
      {18, "value = 0.07", 18, "value = 0.07: is a number; allowed is a text like \"0.07414\""},
      {18, "value = \"1e308\"", 18, "is out of range"},
      {18, "value = \"5e-324\"", 18, "is out of range"},
      {18, "value = \"1e999\"", 18, "is out of range"},
      {18, "", 16, "[[expect]] value: is missing"},
      {18, "value = \"0.0741\"\nstatus = \"waiting\"", 19, "stands beside a value"},
      {18, "status = \"done\"", 18, "is unknown; allowed is \"waiting\""},
      {19, "scaling = \"inch\"", 19, "is unknown"},
      {19, "scaling = \"SI\"", 19, "needs SI scales"},
      {20, "uncertainty = -1e-8", 20, "is negative"},
      {20, "uncertainty = nan", 20, "is not finite"},
      {21, "kind = \"guess\"", 21, "is unknown; allowed is \"exact\""},
      {21, "", 16, "[[expect]] kind: is missing"},
      {21, "kind = \"computed\"\nlaw = \"hertz\"", 22, "belongs to a bearing case"},
  };
  check_refused(contact_lines, rows);
}

BOOST_AUTO_TEST_CASE(wrong_conditions_in_SI_are_refused) {
  const std::vector<BadLine> rows{
      {6, "load_N_per_m = 0.0", 6, "is zero"},
      {6, "load_N_per_m = -5", 6, "is negative"},
      {6, "load_N_per_m = 1e308", 6, "is out of range"},
      {6, "load_N_per_m = 5e-324", 6, "is out of range"},
      {6, "load_N_per_m = 1e11", 5, "M = "},
      {7, "reduced_radius_m = -0.01", 7, "is negative"},
      {8, "reduced_modulus_Pa = 1e308", 8, "is out of range"},
      {9, "speed_sum_m_per_s = 0.0", 9, "is zero"},
      {9, "", 5, "[conditions] speed_sum_m_per_s: is missing"},
      {10, "viscosity_Pa_s = 5e-324", 10, "is out of range"},
      {14, "", 11, "[lubricant] alpha_per_Pa: is missing"},
      {15, "[[expect]]", 16, "inlet = \"flooded\": is unknown in [[expect]]"},
  };
  check_refused(si_lines, rows);
}

BOOST_AUTO_TEST_CASE(a_wrong_bearing_is_refused) {
  const std::vector<BadLine> rows{
      {6, "rollers = 2", 6, "is out of range; allowed is an integer, 3 to 400"},
      {6, "rollers = 21.0", 6, "is a number; allowed is an integer"},
      {6, "rollers = 1e19", 6, "is out of range; allowed is an integer, 3 to 400"},
      {6, "rollers = 9223372036854775808", 6, "is too large for an integer; allowed is an integer, 3 to 400"},
      {8, "roller_diameter_m = 0.053", 8, "is not smaller than the pitch circle"},
      {9, "", 5, "[bearing] length_m: is missing"},
      {10, "clearance_m = 1e308", 10, "is out of range"},
      {11, "rotating = \"both\"", 11, "is unknown; allowed is \"inner\", \"outer\""},
      {11, "", 5, "[bearing] rotating: is missing"},
      {14, "speed_rpm = 5000.0\ninner_speed_rpm = 1.0", 14, "contradicts the speeds of both rings"},
      {14, "", 13, "[operation] speed_rpm: is missing"},
      {15, "radial_load_N = -5", 15, "allowed is 0, or 1e-9 to 1e12"},
      {18, "poisson = 0.51", 18, "is out of range"},
      {16, "[materials]", 16, "[materials]: is unknown"},
      {22, "", 19, "[lubricant] viscosity_Pa_s: is missing"},
      {23, "", 19, "[lubricant] alpha_per_Pa: is missing"},
      {25, "law = \"hertz\"", 25, "is unknown; allowed is \"palmgren\""},
      {26, "", 24, "[datum] x0_m: is missing"},
      {28, "load_N = [12000.0, 2000.0]", 28, "is not increasing"},
      {28, "load_N = [1000.0, 1000.0000000001]", 28, "spans less than 1 %; allowed is"},
      {28, "load_N = [2000.0]", 28, "holds 1 values"},
      {28, "load_N = [2000.0, \"x\"]", 28, "is a text; allowed is a number"},
      {28, "load_N = 2000.0", 28, "is a number; allowed is [low, high]"},
      {29, "points = 2", 29, "is out of range"},
      {31, "quantity = \"film.minimum\"", 31, "is unknown in a bearing case"},
      {31, "quantity = \"roller.22.inner.force\"", 31, "names a roller that does not exist; allowed is 1 to 21"},
      {31, "quantity = \"roller.0.inner.force\"", 31, "is unknown in a bearing case"},
      {31, "quantity = \"roller.3.inner.film\"", 31, "is unknown in a bearing case"},
      {31, "quantity = \"roller.3.inner\"", 31, "is unknown in a bearing case"},
      {32, "", 30, "[[expect]] law: is missing"},
      {32, "law = \"palmgren\"", 32, "is unknown; allowed is \"hertz\""},
      {33, "value = \"8.0\"\nscaling = \"moes\"\nkind = \"exact\"", 34, "does not exist in a bearing case"},
      {5, "[domain]\ninlet = -4.0\n[bearing]", 5, "does not belong to a bearing case"},
  };
  check_refused(bearing_lines, rows);
}

BOOST_AUTO_TEST_CASE(what_is_no_case_file_is_refused_without_a_line) {
  const test::Folder folder;
  const std::vector<std::pair<std::filesystem::path, std::string>> rows{
      {folder.path(), "is a directory"},
      {folder.path() / "absent.toml", "there is no such file"},
      {folder.write("empty.toml", ""), "is empty"},
      {folder.write("blank.toml", " \r\n\t\n"), "is empty"},
      {folder.write("binary.toml", std::string_view("\x7F"
                                                    "ELF\0\1\2",
                                                    7)),
       "is binary"},
      {folder.write("png.toml", std::string_view("\x89PNG\r\n\x1A\n\0\0", 10)), "is binary"},
      {folder.write("gzip.toml", std::string_view("\x1F\x8B\x08\0", 4)), "is binary"},
      {folder.write("large-binary.toml", std::string(70000, '\0')), "is larger than 64 KiB"},
      {folder.write("zero.toml", std::string_view("id = \"a\"\0", 9)), "is binary"},
      {folder.write("large.toml", std::string(70000, '\n')), "is larger than 64 KiB"},
      {"/dev/null", "is not a regular file"},
  };
  std::size_t ran = 0;
  for (const auto& [file, phrase] : rows) {
    const std::string message = message_of(file);
    BOOST_TEST(message.starts_with(file.string() + ":"));
    BOOST_CHECK_MESSAGE(message.find(phrase) != std::string::npos, phrase << " is not in: " << message);
    ++ran;
  }
  BOOST_TEST(ran == rows.size());
}

BOOST_AUTO_TEST_CASE(a_file_cut_anywhere_is_read_or_refused_in_one_line) {
  const test::Folder folder;
  std::size_t refused = 0, accepted = 0;
  for (const auto* lines : {&contact_lines, &bearing_lines}) {
    const std::string whole = joined(*lines);
    for (std::size_t length = 0; length < whole.size(); length += 3) {
      const auto file = folder.write("mine.toml", std::string_view(whole).substr(0, length));
      const std::string message = message_of(file);
      (message.empty() ? accepted : refused) += 1;
      if (message.empty()) continue;
      BOOST_CHECK(message.starts_with(file.string() + ":"));
      BOOST_CHECK(message.find('\n') == std::string::npos);
    }
  }
  BOOST_TEST(refused > 200u);
  BOOST_TEST(accepted > 0u);  // cut after the last table that is needed
}

BOOST_AUTO_TEST_CASE(a_file_with_any_byte_damaged_is_read_or_refused_in_one_line) {
  const test::Folder folder;
  const std::string whole = joined(bearing_lines);
  std::size_t ran = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int flip : {0x01, 0x20, 0x80}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ static_cast<unsigned>(flip));
      const std::string message = message_of(folder.write("mine.toml", damaged));
      BOOST_CHECK(message.find('\n') == std::string::npos);
      ++ran;
    }
  }
  BOOST_TEST(ran == 3 * whole.size());
}

BOOST_AUTO_TEST_CASE(a_benchmark_case_is_found_by_its_id_and_an_unknown_one_is_refused) {
  BOOST_TEST(find_case("own-moes-20-10").filename() == "own-moes-20-10.toml");
  BOOST_CHECK_EXCEPTION((void)find_case("no-such-case"), CaseError, [](const CaseError& error) {
    return std::string(error.what()).find("there is no such case") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(every_benchmark_case_is_read_and_its_source_is_in_the_bibliography) {
  const auto cases = all_cases();
  const auto bibliography = read_bibliography(cases_folder() / "references.bib");
  BOOST_TEST(cases.size() >= 40u);
  for (const Case& any : cases) {
    BOOST_CHECK_MESSAGE(bibliography.count(bibliography_key(any.source)), any.id << ": " << any.source);
  }
}

BOOST_AUTO_TEST_CASE(kostrevas_nine_problems_and_the_table_of_computed_films_are_there) {
  std::set<std::string> ids;
  for (const Case& any : all_cases()) ids.insert(any.id);
  const auto kostreva =
      std::count_if(ids.begin(), ids.end(), [](const auto& id) { return id.starts_with("kostreva"); });
  BOOST_TEST(kostreva == 9);
  for (const char* id : {"own-moes-5-5", "own-moes-20-10-flooded", "own-moes-1000-20", "own-barus-3-4-flooded",
                         "martin-limit", "dry-steel", "steel-roller", "harris-209", "harris-209-41um", "iso-6-rollers",
                         "iso-20-rollers", "na4908", "na4908-2.5um", "na4908-10um", "na4908-18mm"})
    BOOST_CHECK_MESSAGE(ids.count(id), id);
}

BOOST_AUTO_TEST_CASE(the_same_contact_in_si_and_in_groups_is_the_same_problem) {
  const auto problem = [](const char* id) {
    const Case any = read_case(find_case(id));
    const auto& contact = std::get<ContactCase>(any.body);
    return nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem;
  };
  const Problem si = problem("own-steel-20-10"), groups = problem("own-moes-20-10-flooded");
  constexpr double operations = 20;
  EHD_CHECK(error(si.groups.M, groups.groups.M), Tolerance::round_off(operations));
  EHD_CHECK(error(si.groups.L, groups.groups.L), Tolerance::round_off(operations));
  EHD_CHECK(error(std::get<Roelands>(si.viscosity).p0, std::get<Roelands>(groups.viscosity).p0),
            Tolerance::round_off(operations));
  EHD_CHECK(error(std::get<DowsonHigginson>(si.density).c, std::get<DowsonHigginson>(groups.density).c),
            Tolerance::round_off(operations));
}

BOOST_AUTO_TEST_SUITE_END()
