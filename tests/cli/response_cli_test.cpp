// SPDX-License-Identifier: GPL-3.0-or-later
// ehd response: its JSON, its SI, and what it refuses.
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

namespace {

/// The rows of a CSV without quoted cells, by the names of the columns.
std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream parts(line + ",");
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells_of(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    BOOST_REQUIRE(cells.size() == names.size());
    for (std::size_t k = 0; k < cells.size(); ++k) (k == 0 ? rows.emplace_back() : rows.back())[names[k]] = cells[k];
  }
  return rows;
}

using namespace ehd;
using namespace ehd::verification;
using nlohmann::json;
using std::numbers::pi;

constexpr double modulus_Pa = 2.31e11, radius_m = 0.011, load_N_per_m = 9.1e4, speed_sum_m_per_s = 3.3;

std::string contact_in_SI(const test::Folder& folder) {
  return folder
      .write("si.toml",
             "id = \"si\"\nversion = 1\ntitle = \"in SI\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 9.1e4\n"
             "reduced_radius_m = 0.011\nreduced_modulus_Pa = 2.31e11\nspeed_sum_m_per_s = 3.3\nviscosity_Pa_s = "
             "0.02\n[lubricant]\n"
             "viscosity = \"barus\"\ndensity = \"incompressible\"\nalpha_per_Pa = 1.3e-8\n"
             "[domain]\ninlet = -4.0\n")
      .string();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(response_cli)

BOOST_AUTO_TEST_CASE(stiffness_and_waviness_are_in_the_json) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder,
                                   "response own-moes-5-5 --solver reference --omega 1 --omega 0 --wavelength 2 --slip "
                                   "0.5 --tolerance 1e-6 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["case"] == "own-moes-5-5");
  BOOST_TEST(result["solver"] == "reference");
  BOOST_TEST(result["status"] == "converged");
  BOOST_REQUIRE(result["response"].size() == 2U);
  BOOST_TEST(result["response"][0]["omega"] == 1.0);
  BOOST_TEST(result["response"][0]["kappa"]["imag"] > 0.1);
  EHD_CHECK(result["response"][0]["kappa"]["error"], Tolerance::required(1e-6, "--tolerance 1e-6"));
  BOOST_TEST(!result["response"][0].contains("stiffness_N_per_m2"));  // the case states groups
  EHD_CHECK(error(result["response"][1]["kappa"]["real"], result["slow"]["kappa_0"]["value"]),
            Tolerance::round_off(1e4));
  BOOST_REQUIRE(result["waviness"].size() == 1U);
  BOOST_TEST(result["waviness"][0]["slip"] == 0.5);
  BOOST_TEST(result["waviness"][0]["amplitude_ratio"] > 0.1);
  BOOST_TEST(result["waviness"][0]["amplitude_ratio"] < 1);
}

BOOST_AUTO_TEST_CASE(fast_answers_where_no_solver_is_named) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "response own-moes-5-5 --omega 1 --wavelength 2 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["solver"] == "fast");
  BOOST_TEST(result["status"] == "converged");
  const auto asked = Tolerance::required(1e-4, "the tolerance that ehd response has without --tolerance");
  EHD_CHECK(result["response"][0]["kappa"]["error"], asked);
  EHD_CHECK(result["waviness"][0]["error"], asked);
  EHD_CHECK(result["slow"]["kappa_1"]["error"], asked);
}

BOOST_AUTO_TEST_CASE(a_contact_in_SI_has_hertz_and_a_datum_in_series) {
  const test::Folder folder;
  constexpr double datum_m = 0.02, frequency_Hz = 3000;
  const auto ended = test::ehd_run(
      folder, "response " + contact_in_SI(folder) + " --frequency 3000 --x0-m 0.02 --tolerance 1e-6 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json at = json::parse(ended.out)["response"][0];
  const double b = std::sqrt(8 * load_N_per_m * radius_m / (pi * modulus_Pa));
  EHD_CHECK(error(at["omega"], 2 * pi * frequency_Hz * b / (speed_sum_m_per_s / 2)), Tolerance::round_off(64));
  EHD_CHECK(error(at["frequency_Hz"], frequency_Hz), Tolerance::round_off(64));
  const std::complex<double> kappa(at["kappa"]["real"], at["kappa"]["imag"]);
  const std::complex<double> series =
      1.0 / (4.0 / (modulus_Pa * kappa) + 4 / (pi * modulus_Pa) * std::log(datum_m / b));
  EHD_CHECK(error(at["stiffness_N_per_m2"], series.real()), Tolerance::round_off(64));
  EHD_CHECK(error(at["damping_N_s_per_m2"], series.imag() / (2 * pi * frequency_Hz)), Tolerance::round_off(1e3));
  BOOST_TEST(at["stiffness_error"] > 0.0);
  BOOST_TEST(at["damping_error"] > 0.0);
  EHD_CHECK(at["damping_error"].get<double>(), Tolerance::required(1e-4, "a lag to 1e-4 where kappa is known to 1e-6"));
}

// Such a datum makes the stiffness in series negative, which is no property of the contact.
BOOST_AUTO_TEST_CASE(a_datum_inside_the_contact_is_noted_and_a_datum_outside_is_not) {
  const test::Folder folder;
  const std::string command = "response " + contact_in_SI(folder) + " --x0-m ";
  const std::string words = "lies inside the contact";
  const auto inside = test::ehd_run(folder, command + "1e-7"), outside = test::ehd_run(folder, command + "0.02");
  BOOST_TEST(inside.exit_code == 0);
  BOOST_TEST(inside.out.find(words) != std::string::npos);
  BOOST_TEST(outside.out.find(words) == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_csv_has_the_numbers_of_the_json_and_leaves_out_what_is_not_known) {
  const test::Folder folder;
  const std::string command = "response " + contact_in_SI(folder) + " --omega 0 --frequency 3000 --omega 1e9";
  const std::string csv = (folder.path() / "a.csv").string();
  const auto ended = test::ehd_run(folder, command + " --json - --csv " + csv);
  BOOST_TEST(ended.exit_code == 1);  // nobody resolves the last one
  const json rows = json::parse(ended.out)["response"];
  const auto lines = csv_rows(test::read(csv));
  BOOST_REQUIRE(lines.size() == 3u);
  BOOST_REQUIRE(rows.size() == 3u);
  int empty = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto same = [&](const char* column, const json& object, const std::string& key) {
      const std::string& cell = lines[k].at(column);
      BOOST_TEST(cell.empty() != object.contains(key), column);
      if (cell.empty())
        ++empty;
      else
        BOOST_TEST(std::stod(cell) == object[key].get<double>(), column);
    };
    const json kappa = rows[k].value("kappa", json::object());
    same("omega", rows[k], "omega");
    same("frequency_Hz", rows[k], "frequency_Hz");
    same("kappa_real", kappa, "real");
    same("kappa_imag", kappa, "imag");
    same("kappa_error", kappa, "error");
    same("stiffness_N_per_m2", rows[k], "stiffness_N_per_m2");
    same("damping_N_s_per_m2", rows[k], "damping_N_s_per_m2");
    BOOST_TEST(lines[k].at("status") == rows[k]["status"].get<std::string>());
  }
  BOOST_TEST(empty == 5);
}

// A line a wave, behind those of the frequencies; without frequencies there are the columns of waves alone.
BOOST_AUTO_TEST_CASE(the_csv_has_the_waves_too) {
  const test::Folder folder;
  const std::string csv = (folder.path() / "a.csv").string();
  for (const bool both : {false, true}) {
    const auto ended = test::ehd_run(folder, fmt::format("response own-moes-5-5 {}--wavelength 2 --wavelength 3 --slip "
                                                         "0.5 --json - --csv {}",
                                                         both ? "--omega 1 " : "", csv));
    BOOST_REQUIRE(ended.exit_code == 0);
    const json waves = json::parse(ended.out)["waviness"];
    const auto lines = csv_rows(test::read(csv));
    BOOST_REQUIRE(lines.size() == (both ? 3u : 2u));
    BOOST_TEST(lines[0].contains("omega") == both);
    if (both) {
      BOOST_TEST(lines[0].at("wavelength") == "");
      BOOST_TEST(lines[0].at("kappa_real") != "");
    }
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const auto& line = lines[lines.size() - waves.size() + k];
      for (const auto& [column, key] : {std::pair{"wavelength", "wavelength"},
                                        {"slip", "slip"},
                                        {"amplitude_ratio", "amplitude_ratio"},
                                        {"phase_deg", "phase_deg"},
                                        {"amplitude_error", "error"}})
        BOOST_TEST(std::stod(line.at(column)) == waves[k][key].get<double>(), column);
      BOOST_TEST(line.at("status") == "converged");
      if (both) BOOST_TEST(line.at("kappa_real") == "");
    }
  }
}

// Groups alone fix no Hz and no N/m^2: the table has no such columns.
BOOST_AUTO_TEST_CASE(the_table_of_a_case_by_its_groups_has_no_columns_in_SI) {
  const test::Folder folder;
  const auto by_groups = test::ehd_run(folder, "response own-moes-5-5 --omega 1"),
             in_SI = test::ehd_run(folder, "response " + contact_in_SI(folder) + " --omega 1");
  BOOST_TEST(by_groups.out.find("Re kappa") != std::string::npos, by_groups.out);
  for (const char* head : {" Hz ", " N/m^2", " N s/m^2"}) {
    BOOST_TEST(by_groups.out.find(head) == std::string::npos, head);
    BOOST_TEST(in_SI.out.find(head) != std::string::npos, head);
  }
}

// An imaginary part that is zero has no sign.
BOOST_AUTO_TEST_CASE(zero_has_no_sign) {
  const test::Folder folder;
  for (const char* solver : {"fast", "reference"}) {
    const auto ended =
        test::ehd_run(folder, fmt::format("response own-moes-5-5 --solver {} --tolerance 1e-4 --json -", solver));
    BOOST_REQUIRE(ended.exit_code == 0);
    BOOST_TEST(ended.out.find("\"imag\": 0.0") != std::string::npos, solver);
    BOOST_TEST(ended.out.find("-0.0,") == std::string::npos, solver);
  }
}

BOOST_AUTO_TEST_CASE(the_damping_at_rest_is_in_SI_with_its_error) {
  const test::Folder folder;
  const std::string command = "response " + contact_in_SI(folder);
  const auto ended = test::ehd_run(folder, command + " --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json result = json::parse(ended.out), slow = result["slow"], at = result["response"][0];
  const double b = std::sqrt(8 * load_N_per_m * radius_m / (pi * modulus_Pa)), kappa_1 = slow["kappa_1"]["value"];
  EHD_CHECK(error(slow["damping_N_s_per_m2"], modulus_Pa / 4 * kappa_1 * b / (speed_sum_m_per_s / 2)),
            Tolerance::round_off(64));
  EHD_CHECK(error(slow["damping_error"], slow["kappa_1"]["error"]), Tolerance::round_off(64));
  EHD_CHECK(error(slow["stiffness_error"], slow["kappa_0"]["error"]), Tolerance::round_off(64));
  BOOST_TEST(at["omega"] == 0.0);
  BOOST_TEST(at["damping_N_s_per_m2"] == slow["damping_N_s_per_m2"]);
  for (const char* group : {"M", "L", "lambda", "alpha_p_H", "hertz_pressure_Pa", "half_width_m", "W", "U_mean", "G"})
    BOOST_TEST(result["groups"].contains(group), group);
  EHD_CHECK(error(result["groups"]["half_width_m"], b), Tolerance::round_off(64));
  BOOST_TEST(test::ehd_run(folder, command).out.find(" N s/m^2\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_oil_by_its_grade_is_named) {
  const test::Folder folder;
  const auto file = folder.write(
      "oil.toml",
      "id = \"oil\"\nversion = 1\ntitle = \"by grade\"\nsource = \"own\"\n[conditions]\nload_N_per_m = 9.1e4\n"
      "reduced_radius_m = 0.011\nreduced_modulus_Pa = 2.31e11\nspeed_sum_m_per_s = 3.3\n[lubricant]\n"
      "viscosity = \"barus\"\ndensity = \"incompressible\"\niso_vg = 68\ntemperature_C = 60.0\n"
      "[domain]\ninlet = -4.0\n");
  const auto ended = test::ehd_run(folder, "response " + file.string() + " --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json oil = json::parse(ended.out)["lubricant"];
  BOOST_TEST(oil["iso_vg"] == 68.0);
  BOOST_TEST(oil["viscosity_Pa_s"] > 0.0);
}

BOOST_AUTO_TEST_CASE(a_frequency_in_hertz_units_has_its_damping_with_an_error) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "response own-moes-5-5 --omega 0.5 --json -");
  BOOST_REQUIRE(ended.exit_code == 0);
  const json at = json::parse(ended.out)["response"][0];
  EHD_CHECK(error(at["damping"]["value"], at["kappa"]["imag"].get<double>() / 0.5), Tolerance::round_off(64));
  BOOST_TEST(at["damping"]["error"] > 0.0);
  EHD_CHECK(at["damping"]["error"].get<double>(),
            Tolerance::required(1e-2, "kappa to 1e-4, whose imaginary part is a tenth"));
}

BOOST_AUTO_TEST_CASE(a_frequency_that_is_not_known_exits_with_1_and_names_the_highest) {
  const test::Folder folder;
  const auto ended = test::ehd_run(folder, "response own-moes-5-5-flooded --omega 1000 --json -");
  BOOST_TEST(ended.exit_code == 1);
  BOOST_TEST(ended.err.find("tolerance-not-met") != std::string::npos);
  BOOST_TEST(ended.err.find("certified up to Omega = ") != std::string::npos);
  const json result = json::parse(ended.out);
  BOOST_TEST(result["status"] == "tolerance-not-met");
  BOOST_TEST(result["highest_certified_omega"] > 1.0);
  BOOST_TEST(result["highest_certified_omega"] < 1000.0);
}

BOOST_AUTO_TEST_CASE(what_has_no_response_is_refused_in_one_line) {
  const test::Folder folder;
  const std::pair<const char*, const char*> rows[] = {
      {"response", "CASE"},
      {"response own-moes-5-5 --omega -1", "--omega = -1: is out of range; allowed is"},
      {"response own-moes-5-5 --omega nan", "--omega = nan"},
      {"response own-moes-5-5 --wavelength 0", "--wavelength = 0: is out of range"},
      {"response own-moes-5-5 --wavelength 0.001", "--wavelength = 0.001: is out of range; allowed is"},
      {"response own-moes-5-5 --wavelength 1 --slip 3", "--slip = 3: is out of range"},
      {"response own-moes-5-5 --slip 0.5", "--slip = 0.5: belongs to a waviness; allowed with --wavelength"},
      {"response own-moes-5-5 --tolerance 1", "--tolerance = 1: is out of range"},
      {"response own-moes-5-5 --frequency 100", "states no speed in m/s"},
      {"response own-moes-5-5 --solver fast.uniform",
       "--solver = fast.uniform: has no response; allowed is reference, fast"},
      {"response dry-steel", "dry contact"},
      {"response na4908", "is no contact"},
  };
  for (const auto& [arguments, message] : rows) test::check_refused(folder, arguments, message);
}

BOOST_AUTO_TEST_SUITE_END()
