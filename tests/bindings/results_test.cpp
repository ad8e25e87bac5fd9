// SPDX-License-Identifier: GPL-3.0-or-later
// A result through the C interface is that of the program.
#include <stdlib.h>  // setenv

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <locale>
#include <map>
#include <sstream>
#include <string>

#include "tests/bindings/held.hpp"
#include "tests/check.hpp"
#include "tests/process.hpp"

using namespace ehd::c::test;
using ehd::error;
using ehd::verification::Tolerance;
using ehd::verification::test::ehd_run;
using ehd::verification::test::Folder;

namespace {

nlohmann::ordered_json program_json(const std::string& arguments) {
  const Folder folder;
  return nlohmann::ordered_json::parse(ehd_run(folder, arguments + " --json -").out);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(results)

BOOST_AUTO_TEST_CASE(the_json_is_that_of_the_program) {
  for (const char* solver : {"fast", "reference.uniform"}) {
    const Held one = solve(case_text("own-moes-20-10"), solver, 1e-2);
    BOOST_TEST(one.code == EHD_OK);
    const auto expected = program_json(std::string("solve own-moes-20-10 --tolerance 1e-2 --solver ") + solver);
    BOOST_TEST(without_times(one.json()).dump() == without_times(expected).dump());
  }
  const Held stated = solve_moes(20, 10);
  BOOST_TEST(without_times(stated.json()).dump() == without_times(program_json("solve --M 20 --L 10")).dump());
  const Held with_oil =
      solve_moes(20, 10, "viscosity = \"roelands\"\ndensity = \"dowson-higginson\"\nalpha_per_Pa = 2.2e-8\nz = 0.68\n");
  const auto expected = program_json(
      "solve --M 20 --L 10 --viscosity roelands --density dowson-higginson --alpha-per-Pa 2.2e-8 --z 0.68");
  BOOST_TEST(without_times(with_oil.json()).dump() == without_times(expected).dump());
}

BOOST_AUTO_TEST_CASE(the_json_of_a_bearing_is_that_of_the_program_without_its_error_budget) {
  for (const char* law : {"hertz", "ehd"}) {
    const Held one = bearing(case_text("na4908"), law);
    BOOST_TEST(one.code == EHD_OK);
    auto expected = program_json(std::string("bearing na4908 --law ") + law);
    expected.erase("error_budget");
    BOOST_TEST(without_times(one.json()).dump() == without_times(expected).dump());
  }
}

namespace {

/// The decimal sign of streams, as a host program may set it.
struct WithComma : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

/// Numbers with a comma, in streams and in the functions of C, while it lives. For those a German locale is made in
/// the folder; `in_C` is false where this machine cannot make one.
class CommaLocale {
 public:
  explicit CommaLocale(const Folder& folder) : before_(std::locale::global({std::locale(), new WithComma})) {
    const std::string name = "de_DE.UTF-8", made = (folder.path() / name).string();
    if (std::system(fmt::format("localedef -i de_DE -f UTF-8 '{}' > '{}.log' 2>&1", made, made).c_str()) != 0) return;
    ::setenv("LOCPATH", folder.path().c_str(), 1);
    in_C = std::setlocale(LC_ALL, name.c_str()) != nullptr;
  }
  ~CommaLocale() {
    std::setlocale(LC_ALL, "C");
    std::locale::global(before_);
    ::unsetenv("LOCPATH");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  bool in_C = false;

 private:
  std::locale before_;
};

/// What the library says of a contact, of a bearing, and of a wrong number.
std::string all_said() {
  const Held contact = solve(case_text("steel-roller")), balanced = bearing(case_text("na4908"), "ehd-linear");
  BOOST_TEST(contact.code == EHD_OK);
  BOOST_TEST(balanced.code == EHD_OK);
  BOOST_TEST(solve_moes(20.5, 1234.5).code == EHD_BAD_INPUT);
  return without_times(contact.json()).dump() + without_times(balanced.json()).dump() + ehd_last_error() +
         fmt::format(" {} {}", contact.get("film.minimum.m"), balanced.get("displacement_m"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_keep_their_point_where_the_host_writes_commas) {
  const std::string before = all_said();
  const Folder folder;
  const CommaLocale comma(folder);
  std::ostringstream written;
  written << 1234.5;
  BOOST_REQUIRE(written.str() == "1.234,5");
  if (comma.in_C) {
    char text[8] = {};
    BOOST_REQUIRE(std::snprintf(text, sizeof text, "%.1f", 1.5) == 3);
    BOOST_REQUIRE(std::string(text) == "1,5");
  } else {
    BOOST_TEST_MESSAGE("no German locale: the functions of C keep their point");
  }
  BOOST_TEST(all_said() == before);
}

BOOST_AUTO_TEST_CASE(numbers_are_found_by_their_path) {
  const Held one = solve(case_text("own-moes-20-10"));
  const auto json = one.json();
  BOOST_TEST(one.get("film.minimum.hertz") == json["film"]["minimum"]["hertz"].get<double>());
  BOOST_TEST(one.get("version") == 1);
  BOOST_TEST(one.get("fields.pressure_resolved") == 0);
  const Held balanced = bearing(case_text("na4908"), "hertz");
  BOOST_TEST(balanced.get("rollers.0.inner.force_N") ==
             balanced.json()["rollers"][0]["inner"]["force_N"].get<double>());
  double untouched = 7;
  for (const char* path : {"", ".", "film", "film.", "film.minimum.hertz.x", "film.least", "status", "rollers.0",
                           "notes.0", "notes.99999999999999999999", "notes.-1", "notes.1x"}) {
    BOOST_TEST(ehd_get(one.result.get(), path, &untouched) == EHD_BAD_INPUT, path);
    BOOST_TEST(std::string(ehd_last_error()).find("path = ") != std::string::npos);
  }
  BOOST_TEST(untouched == 7);
}

// The library reads some numbers without making the JSON.
BOOST_AUTO_TEST_CASE(every_number_of_the_json_is_found_also_before_the_json_is_made) {
  const auto paths = solve(case_text("steel-roller")).json().flatten();
  const Held one = solve(case_text("steel-roller"));
  std::map<std::string, double> early;
  for (const auto& [pointer, value] : paths.items()) {
    std::string path = pointer.substr(1);
    std::replace(path.begin(), path.end(), '/', '.');
    if (value.is_number()) early[path] = one.get(path.c_str());
  }
  BOOST_TEST(early.size() > 50);
  std::size_t found = 0;
  const auto numbers = one.json().flatten();
  for (const auto& [pointer, value] : numbers.items()) {
    std::string path = pointer.substr(1);
    std::replace(path.begin(), path.end(), '/', '.');
    if (!value.is_number()) continue;
    BOOST_TEST(early.at(path) == value.get<double>(), path);
    ++found;
  }
  BOOST_TEST(found == early.size());
}

BOOST_AUTO_TEST_CASE(fields_are_the_columns_of_the_profile) {
  const Held one = solve(case_text("steel-roller"));
  const Folder folder;
  const auto file = folder.path() / "profile.csv";
  BOOST_TEST(ehd_run(folder, "solve steel-roller --profile '" + file.string() + "'").exit_code == 0);
  std::istringstream csv(ehd::verification::test::read(file));
  std::string header, row;
  std::getline(csv, header);
  std::istringstream names(header);
  std::vector<std::vector<double>> columns;
  for (std::string name; std::getline(names, name, ',');)
    columns.push_back(one.field(name.substr(0, name.find(' ')).c_str()));
  BOOST_TEST(columns.size() >= 8);
  std::size_t rows = 0;
  for (; std::getline(csv, row); ++rows) {
    std::istringstream cells(row);
    for (const auto& column : columns) {
      std::string cell;
      std::getline(cells, cell, ',');
      BOOST_REQUIRE(rows < column.size());
      // The file has 15 digits; reading them and the quotient round once each.
      if (cell.empty())
        BOOST_TEST(std::isnan(column[rows]));
      else
        EHD_CHECK(error(std::stod(cell), column[rows]),
                  Tolerance::published_digits("1.00000000000000") + Tolerance::round_off(2));
    }
  }
  for (const auto& column : columns) BOOST_TEST(column.size() == rows);
}

BOOST_AUTO_TEST_CASE(a_short_buffer_is_filled_and_no_more) {
  const Held one = solve_moes(20, 10);
  const std::vector<double> all = one.field("P");
  BOOST_REQUIRE(all.size() > 4);
  std::vector<double> some(4, -1);
  BOOST_TEST(ehd_field(one.result.get(), "P", some.data(), 3) == all.size());
  for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(some[i] == all[i]);
  BOOST_TEST(some[3] == -1);
}

BOOST_AUTO_TEST_CASE(a_dry_contact_has_fields_and_no_film) {
  const Held dry = solve(case_text("dry-steel"));
  BOOST_TEST(dry.code == EHD_OK);
  BOOST_TEST(dry.field("P").size() == dry.field("X").size());
  BOOST_TEST(dry.field("P").size() > 100);
  BOOST_TEST(dry.field("eta").empty());
  BOOST_TEST(std::isnan(dry.get("film.minimum.hertz")));
}

BOOST_AUTO_TEST_CASE(what_did_not_converge_comes_with_its_result) {
  const Held missed = solve(case_text("own-moes-20-10"), "fast", 1e-15);
  BOOST_TEST(missed.code == EHD_NOT_MET);
  BOOST_REQUIRE(missed.result);
  BOOST_TEST(missed.json()["status"] == "tolerance-not-met");
  BOOST_TEST(missed.get("film.minimum.hertz") > 0);
  BOOST_TEST(std::string(ehd_last_error()).starts_with("ehd: own-moes-20-10: tolerance-not-met: "));
}

BOOST_AUTO_TEST_CASE(the_law_of_a_bearing_meets_its_rollers) {
  for (const char* law : {"hertz", "ehd-linear", "ehd"}) {
    const Held one = bearing(case_text("na4908"), law);
    for (const char* raceway : {"inner", "outer"}) {
      const std::string contact = std::string("rollers.0.") + raceway;
      const double approach_m = one.get((contact + ".displacement_m").c_str());
      const double step_m = 1e-6 * approach_m;
      const double at_m[] = {approach_m, approach_m + step_m, approach_m - step_m};
      double force_N[3], stiffness[3];
      BOOST_TEST(ehd_law(one.result.get(), raceway, 3, at_m, force_N, stiffness) == EHD_OK);
      const double carried_N = one.get((contact + ".force_N").c_str());
      BOOST_TEST_CONTEXT(law << " " << raceway) {
        EHD_CHECK(error(force_N[0], carried_N), Tolerance::iteration(1e-9));
        // A central difference: error step^2, and the rounding of forces over the step.
        EHD_CHECK(error((force_N[1] - force_N[2]) / (2 * step_m), stiffness[0]),
                  Tolerance::discretisation(1e-12, 10) + Tolerance::round_off(100, 1e6));
      }
    }
  }
  const Held iso = bearing(case_text("na4908"), "ehd");
  const double far_m = 1e-3;
  double force_N = 0, stiffness = 0;
  BOOST_TEST(ehd_law(iso.result.get(), "inner", 1, &far_m, &force_N, &stiffness) == EHD_NOT_MET);
  BOOST_TEST(std::string(ehd_last_error()).find("above") != std::string::npos);
  BOOST_TEST(force_N > 0);
}

BOOST_AUTO_TEST_SUITE_END()
