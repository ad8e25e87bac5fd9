// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a caller hands over is answered by a return value and one line.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <thread>

#include "tests/bindings/held.hpp"

using namespace ehd::c::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

/// Refused with one line that holds the phrase, without a result.
void check_refused(const Held& one, const std::string& phrase) {
  const std::string line = ehd_last_error();
  BOOST_TEST_CONTEXT(phrase) {
    BOOST_TEST(one.code == EHD_BAD_INPUT);
    BOOST_TEST(!one.result);
    BOOST_CHECK_MESSAGE(line.find(phrase) != std::string::npos, "is not in: " << line);
    BOOST_CHECK_MESSAGE(line.find('\n') == std::string::npos, "more than a line: " << line);
  }
}

void check_refused(int code, const std::string& phrase) {
  check_refused(Held{.code = code, .result = nullptr}, phrase);
}

/// One contact, and room for its films.
struct OneFilm {
  double M = 20, L = 10, minimum = 7, minimum_error = 7, central = 7, central_error = 7;
  int status = 7;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(bad_input)

BOOST_AUTO_TEST_CASE(a_null_pointer_is_bad_input) {
  const std::string contact = case_text("own-moes-20-10"), roller = case_text("na4908");
  ehd_result* result = nullptr;
  check_refused(ehd_solve(nullptr, "fast", 1e-3, &result), "case_toml = NULL");
  check_refused(ehd_solve(contact.c_str(), nullptr, 1e-3, &result), "solver = NULL");
  check_refused(ehd_solve(contact.c_str(), "fast", 1e-3, nullptr), "result = NULL");
  check_refused(ehd_solve_moes(20, 10, nullptr, nullptr, 1e-3, &result), "solver = NULL");
  check_refused(ehd_solve_moes(20, 10, nullptr, "fast", 1e-3, nullptr), "result = NULL");
  check_refused(ehd_bearing(nullptr, "hertz", &result), "case_toml = NULL");
  check_refused(ehd_bearing(roller.c_str(), nullptr, &result), "law = NULL");
  check_refused(ehd_bearing(roller.c_str(), "hertz", nullptr), "result = NULL");

  const Held one = bearing(roller, "hertz");
  double number = 0;
  check_refused(ehd_get(nullptr, "version", &number), "result = NULL");
  check_refused(ehd_get(one.result.get(), nullptr, &number), "path = NULL");
  check_refused(ehd_get(one.result.get(), "version", nullptr), "value = NULL");
  BOOST_TEST(ehd_field(nullptr, "X", &number, 1) == 0U);
  BOOST_TEST(ehd_field(one.result.get(), nullptr, &number, 1) == 0U);
  const Held contact_result = solve(contact);
  BOOST_TEST(ehd_field(contact_result.result.get(), "X", nullptr, 1) == 0U);
  BOOST_TEST(ehd_json(nullptr) == nullptr);
  ehd_free(nullptr);
  ehd_set_progress(nullptr, nullptr);

  check_refused(ehd_law(nullptr, "inner", 1, &number, &number, &number), "bearing = NULL");
  check_refused(ehd_law(one.result.get(), nullptr, 1, &number, &number, &number), "raceway = NULL");
  check_refused(ehd_law(one.result.get(), "inner", 1, nullptr, &number, &number), "approach_m = NULL");
  check_refused(ehd_law(one.result.get(), "inner", 1, &number, nullptr, &number), "force_N = NULL");
  check_refused(ehd_law(one.result.get(), "inner", 1, &number, &number, nullptr), "stiffness_N_per_m = NULL");
}

BOOST_AUTO_TEST_CASE(every_array_of_films_is_needed) {
  OneFilm f;
  const auto films = [&](int left_out) {
    const auto array = [&](double& of, int k) { return k == left_out ? nullptr : &of; };
    return ehd_films(1, array(f.M, 0), array(f.L, 1), nullptr, 1e-2, 1, array(f.minimum, 2), array(f.minimum_error, 3),
                     array(f.central, 4), array(f.central_error, 5), left_out == 6 ? nullptr : &f.status);
  };
  for (int k = 0; k < 7; ++k) check_refused(films(k), " = NULL");
  BOOST_TEST(films(-1) == EHD_OK);
}

BOOST_AUTO_TEST_CASE(sizes_and_numbers_out_of_range_are_bad_input) {
  OneFilm f;
  const auto films = [&](std::size_t n, double tolerance, int threads) {
    return ehd_films(n, &f.M, &f.L, nullptr, tolerance, threads, &f.minimum, &f.minimum_error, &f.central,
                     &f.central_error, &f.status);
  };
  check_refused(films(0, 1e-2, 1), "n = 0");
  check_refused(films(1, 1e-2, -1), "threads = -1");
  check_refused(films(1, 1e-2, 2000), "threads = 2000");
  check_refused(films(1, not_a_number, 1), "tolerance = nan");
  f.M = -1;
  check_refused(films(1, 1e-2, 1), "M = -1: is out of range");
  f.M = not_a_number;
  check_refused(films(1, 1e-2, 1), "M = nan: is not finite");
  const double M[] = {20, 20}, L[] = {0, 10};  // L = 0 needs no viscosity law, the second contact does
  double film[2];
  int status[2];
  check_refused(ehd_films(2, M, L, "viscosity = \"isoviscous\"\ndensity = \"incompressible\"\n", 1e-2, 1, film, film,
                          film, film, status),
                "contact 1: ");
  BOOST_TEST(f.minimum == 7);
  BOOST_TEST(f.status == 7);

  for (const double tolerance : {0.0, -1e-3, 1.5, infinity, not_a_number})
    check_refused(solve_moes(20, 10, nullptr, "fast", tolerance), "tolerance = ");
  check_refused(solve_moes(2e6, 10), "M = 2e6: is out of range; allowed is a number, 0.001 to 1e6");
  check_refused(solve_moes(20, -1), "L = -1: is out of range");
  check_refused(solve_moes(20, infinity), "L = inf: is not finite");
  const Held one = bearing(case_text("na4908"), "hertz");
  double number = 1e-6;
  check_refused(ehd_law(one.result.get(), "inner", 0, &number, &number, &number), "n = 0");
  check_refused(ehd_law(one.result.get(), "middle", 1, &number, &number, &number), "raceway = middle");
  number = not_a_number;
  check_refused(ehd_law(one.result.get(), "inner", 1, &number, &number, &number), "approach_m[0] = nan");
}

BOOST_AUTO_TEST_CASE(unknown_names_are_bad_input) {
  check_refused(solve_moes(20, 10, nullptr, "fst"),
                "solver = fst: is unknown; did you mean fast? allowed is reference, ");
  check_refused(solve_moes(20, 10, nullptr, std::string(100000, 'x').c_str()), "is unknown");
  check_refused(solve_moes(20, 10, nullptr, "two\nlines"), "is unknown");
  check_refused(bearing(case_text("na4908"), "magic"), "law = magic: is unknown; allowed is hertz, ");
  check_refused(bearing(case_text("na4908"), "ehdlinear"), "law = ehdlinear: is unknown; did you mean ehd-linear? ");
  check_refused(bearing(case_text("own-moes-20-10"), "hertz"), "ehd_solve");
  check_refused(solve(case_text("na4908")), "ehd_bearing");
  const Held contact = solve_moes(20, 10);
  double number = 1e-6;
  check_refused(ehd_law(contact.result.get(), "inner", 1, &number, &number, &number), "result of a contact");
  BOOST_TEST(ehd_field(contact.result.get(), "Q", &number, 1) == 0U);
  BOOST_TEST(std::string(ehd_last_error()).find("name = Q: is unknown; allowed is X, P, H") != std::string::npos);
  BOOST_TEST(ehd_field(contact.result.get(), "H_eror", &number, 1) == 0U);
  BOOST_TEST(std::string(ehd_last_error()).find("did you mean H_error?") != std::string::npos);
  // Groups without a length have no metres.
  BOOST_TEST(ehd_field(contact.result.get(), "x_m", &number, 1) == 0U);
  BOOST_TEST(std::string(ehd_last_error()).find("allowed is X, P, H, rho, eta, H_error") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(bad_case_text_names_its_line) {
  const std::string good = case_text("own-moes-20-10");
  std::string bad = good;
  bad.replace(bad.find("M = 20"), 6, "M = -2");
  check_refused(solve(bad), ": M = -2");
  BOOST_TEST(std::string(ehd_last_error()).starts_with("own-moes-20-10.toml:"));
  check_refused(solve(""), "case: is empty; allowed is the text of a case file (TOML)");
  BOOST_TEST(std::string(ehd_last_error()).find("id of a benchmark case") == std::string::npos);
  check_refused(solve("own-moes-20-10"), "case = own-moes-20-10: is a name; allowed is the text of a case file");
  check_refused(bearing("/etc/na4908.toml", "hertz"), "is a name; allowed is the text of a case file");
  check_refused(solve("\x01"), "control character");
  check_refused(solve("\xff"), "UTF-8");
  check_refused(solve(std::string(100000, '#')), "is larger than");
  check_refused(solve("id = 1\n[conditions]\n"), "case:1: version: is missing");
  std::string misspelt = good;
  misspelt.replace(misspelt.find("title"), 5, "titel").replace(misspelt.find("inlet ="), 5, "inlte");
  check_refused(solve(misspelt), "titel = ");
  BOOST_TEST(std::string(ehd_last_error()).ends_with(" (and 1 more)"));
  const std::string id = "\"own-moes-20-10\"";
  std::string numbered = good, wrong = good;
  numbered.replace(numbered.find(id), id.size(), "1");
  check_refused(solve(numbered), ": id = 1: ");
  wrong.replace(wrong.find(id), id.size(), "\"a/b c\"");
  check_refused(solve(wrong), "is no id");
  std::string renamed = good;  // there is no file that the id could differ from
  renamed.replace(renamed.find("own-moes-20-10"), 14, "whatever");
  BOOST_TEST(solve(renamed).code == EHD_OK);
}

BOOST_AUTO_TEST_CASE(a_bad_lubricant_names_its_line) {
  const std::string barus = "viscosity = \"barus\"\n";
  check_refused(solve_moes(20, 10, ""), "viscosity");
  check_refused(solve_moes(20, 10, (barus + "density = \"iron\"\n").c_str()), "lubricant:3: density = \"iron\"");
  check_refused(solve_moes(20, 10, (barus + "density = \"incompressible\"\nzz = 0.68\n").c_str()),
                "lubricant:4: zz = 0.68: is unknown");
  check_refused(solve_moes(20, 10, (barus + "density = \"incompressible\"\n[moes]\nM = 3\n").c_str()),
                "lubricant:4: [moes]: does not belong here");
  check_refused(solve_moes(20, 10, (barus + "density = \"incompressible\"\n[[expect]]\n").c_str()), "lubricant:4");
  check_refused(solve_moes(20, 10, "viscosity = \"isoviscous\"\ndensity = \"incompressible\"\n"), "isoviscous");
  check_refused(solve_moes(20, 10, "viscosity = \"roelands\"\ndensity = \"incompressible\"\nz = 0.68\n"),
                "alpha_per_Pa");
}

BOOST_AUTO_TEST_CASE(the_last_error_is_there_until_the_next_one) {
  const char* const line = ehd_last_error();
  check_refused(solve(""), "case: is empty; allowed is the text of a case file (TOML)");
  BOOST_TEST(std::string(ehd_last_error()).find("id of a benchmark case") == std::string::npos);
  BOOST_TEST(solve_moes(20, 10).code == EHD_OK);
  BOOST_TEST(std::string(line).starts_with("case: is empty"));
  check_refused(solve_moes(-20, 10), "M = -20");
  BOOST_TEST(std::string(line).starts_with("ehd: M = -20"));
  std::jthread([] { BOOST_TEST(std::string(ehd_last_error()) == ""); }).join();
}

BOOST_AUTO_TEST_CASE(the_version_names_commit_and_libraries) {
  const std::string version = ehd_version();
  for (const char* part : {"0.", " (", "FFTW 3.", "Eigen 3.", ")"})
    BOOST_CHECK_MESSAGE(version.find(part) != std::string::npos, part << " is not in " << version);
}

BOOST_AUTO_TEST_SUITE_END()
