// SPDX-License-Identifier: GPL-3.0-or-later
// One table of bearing quantities: the case reader allows exactly the names that the measurement knows.
#include "workflow/bearing_quantities.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "workflow/bearing_run.hpp"
#include "workflow/case.hpp"

using namespace ehd;

namespace {

/// Three rollers; every number of the result differs from every other.
BearingResult made_result() {
  BearingResult result;
  result.law = bearing::Law::ehd;
  result.displacement_m = 1e-6;
  for (int roller = 1; roller <= 3; ++roller) {
    const auto contact = [&](double tenth) {
      const double size = roller + tenth;
      return ContactRow{.force_N = 1e3 * size, .displacement_m = 1e-5 * size, .film_minimum_m = 1e-7 * size};
    };
    result.rollers.push_back({.azimuth_deg = 120.0 * (roller - 1), .inner = contact(0.1), .outer = contact(0.2)});
  }
  return result;
}

/// A bearing of three rollers that expects one quantity.
std::string case_text(const std::string& quantity) {
  return fmt::format(R"(
id = "mine"
version = 1
title = "a bearing"
source = "own"
[bearing]
rollers = 3
pitch_diameter_m = 0.053
roller_diameter_m = 0.005
length_m = 0.121
clearance_m = 0.0
rotating = "outer"
density_kg_per_m3 = 7850.0
[operation]
speed_rpm = 5000.0
radial_load_N = 5e3
[material]
modulus_Pa = 2.06e11
poisson = 0.3
[lubricant]
viscosity = "barus"
density = "incompressible"
viscosity_Pa_s = 0.02
alpha_per_Pa = 2.0e-8
[[expect]]
quantity = "{}"
law = "ehd"
status = "waiting"
)",
                     quantity);
}

/// The names that the reader says are allowed, with N = `roller`.
std::vector<std::string> names_that_the_reader_allows(int roller) {
  std::string message;
  try {
    (void)read_case(case_text("nonsense"), "mine.toml");
  } catch (const CaseError& error) {
    message = error.what();
  }
  const std::string before = "; allowed is ", explained = " (N from 1)";
  const auto begin = message.rfind(before);
  BOOST_REQUIRE(begin != std::string::npos);
  std::vector<std::string> names;
  std::string rest = message.substr(begin + before.size()) + ", ";
  for (std::size_t comma = rest.find(", "); comma != std::string::npos; comma = rest.find(", ")) {
    std::string name = rest.substr(0, comma);
    rest.erase(0, comma + 2);
    if (const auto at = name.find(explained); at != std::string::npos) name.erase(at);
    if (const auto at = name.find(".N."); at != std::string::npos) name.replace(at + 1, 1, std::to_string(roller));
    names.push_back(name);
  }
  return names;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bearing_quantities)

BOOST_AUTO_TEST_CASE(every_name_that_the_reader_allows_is_read_and_measured) {
  const std::vector<BearingResult> results{made_result()};
  const auto names = names_that_the_reader_allows(2);
  BOOST_TEST(names.size() == 7u);
  for (const std::string& name : names) {
    BOOST_TEST_CONTEXT(name) {
      const Case read = read_case(case_text(name), "mine.toml");
      BOOST_REQUIRE(read.expectations.size() == 1u);
      BOOST_TEST(measure(results, read.expectations.front()).has_value());
    }
  }
}

BOOST_AUTO_TEST_CASE(each_name_measures_its_own_number) {
  const std::vector<BearingResult> results{made_result()};
  const auto measured = [&](const char* quantity) {
    Expectation expectation;
    expectation.quantity = quantity;
    expectation.law = "ehd";
    return measure(results, expectation).value_or(-1);
  };
  const RollerRow& third = results.front().rollers[2];
  BOOST_TEST(measured("displacement") == 1e-6);
  BOOST_TEST(measured("roller.3.inner.force") == third.inner.force_N);
  BOOST_TEST(measured("roller.3.outer.force") == third.outer.force_N);
  BOOST_TEST(measured("roller.3.inner.displacement") == third.inner.displacement_m);
  BOOST_TEST(measured("roller.3.outer.displacement") == third.outer.displacement_m);
  BOOST_TEST(measured("roller.3.inner.film.minimum") == *third.inner.film_minimum_m);
  BOOST_TEST(measured("roller.3.outer.film.minimum") == *third.outer.film_minimum_m);
  BOOST_TEST(measured("roller.4.inner.force") == -1);  // there are three
}

BOOST_AUTO_TEST_CASE(other_names_are_unknown) {
  for (const char* name : {"", "force", "film.minimum", "roller", "roller.", "roller.1", "roller.1.inner",
                           "roller.1.inner.", "roller.0.inner.force", "roller.01.inner.force", "roller.-1.inner.force",
                           "roller.+1.inner.force", "roller.1.middle.force", "roller.1.inner.film",
                           "roller.1.inner.force.", "roller.99999999999.inner.force", "roller.1.inner.displacements"})
    BOOST_TEST(!bearing_quantity_from(name).has_value(), name);
}

BOOST_AUTO_TEST_SUITE_END()
