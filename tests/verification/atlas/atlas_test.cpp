// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "io/json.hpp"
#include "io/output_file.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/process.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string text_of(double value, double error) {
  const auto known = known_digits(value, error);
  return known ? known->text : "none";
}

/// A value of each quantity that tells the problem and the quantity apart; the error is `relative` of it.
Solution made_solution(const Problem& problem, double relative) {
  Solution solution;
  solution.record.status = StopReason::converged;
  solution.record.cost.nodes = 320;
  solution.record.cost.wall_s = 0.25;
  const double base = 0.1 * problem.groups.M + 0.001 * problem.groups.L + 0.01 * M_E;
  double factor = 1;
  for (const Quantity quantity : all_quantities) {
    factor *= 1.1;
    Reading reading{.value = base * factor, .error = relative};
    if (quantity == Quantity::film_offset) reading = {.value = -base / M_PI, .error = relative / 7};  // absolute
    if (quantity == Quantity::pressure_spike) reading.place = 0.9 + base / 1e6;
    if (quantity == Quantity::pressure_spike && problem.groups.L == 0) continue;
    solution.observables[quantity] = reading;
  }
  GridRecord grid;
  grid.observed = solution.observables;
  solution.record.grids = {grid, grid};
  return solution;
}

/// Solves nothing; counts, and throws at the solve number `fails_at`. Solves of the version are not counted.
struct Fake {
  std::atomic<int> solves = 0, fails_at = 0;
  std::atomic<double> relative = 3e-11;

  [[nodiscard]] RegisteredSolver solver() {
    RegisteredSolver fake = *find_solver("reference");
    fake.name = "fake";
    fake.solve = [this](const Problem& problem, const Request& request) {
      const bool of_an_atlas = problem.groups.M != 0.7 && problem.groups.M != 7 && problem.groups.M != 15;
      if (of_an_atlas && ++solves == fails_at) throw std::runtime_error("interrupted");
      return made_solution(problem,
                           of_an_atlas ? std::max<double>(relative, request.tolerance.tightest() / 1e9) : 1e-9);
    };
    return fake;
  }
};

std::vector<AtlasPoint> few_points() {
  return {{AtlasLaws::isoviscous, 0.2, 0, Flooded{}}, {AtlasLaws::isoviscous, 50, 0, TruncatedAt{-4}},
          {AtlasLaws::barus, 2, 2.5, Flooded{}},      {AtlasLaws::barus, 20, 5, TruncatedAt{-4}},
          {AtlasLaws::roelands, 20, 10, Flooded{}},   {AtlasLaws::roelands, 1000, 30, TruncatedAt{-4}}};
}

AtlasRequest request_in(const test::Folder& folder) {
  return {.folder = folder.path() / "atlas", .points = few_points(), .only = {}, .threads = 2};
}

AtlasRecord record_of(const AtlasPoint& point) {
  Fake fake;
  return solve_point(point, fake.solver(), point.usual_tolerance(), 30);
}

void replace_in(const std::filesystem::path& file, const std::string& before, const std::string& now) {
  std::string text = test::read(file);
  const auto at = text.find(before);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, before << " is not in " << file);
  std::ofstream(file, std::ios::binary) << text.replace(at, before.size(), now);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(atlas_atlas)

// -- digits -----------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_digit_is_printed_where_the_error_is_below_half_of_its_unit) {
  const struct {
    double value, error;
    const char* text;
  } rows[] = {
      {0.0741427, 2e-6, "0.07414"},
      {0.0741427, 4.9e-6, "0.07414"},
      {0.0741427, 5e-6, "0.0741"},  // not below half a unit
      {1.25, 0.004, "1.25"},
      {9.9996, 4e-5, "9.9996"},
      {9.9996, 0.00049, "10.000"},
      {9.9996, 0.004, "10.00"},
      {9.9996, 0.3, "10"},
      {0.99996, 0.0004, "1.000"},
      {9.9996e-4, 4e-9, "9.9996e-4"},
      {9.9996e-4, 4e-8, "1.0000e-3"},
      {9.6e-4, 4e-5, "1.0e-3"},
      {9.6e-5, 4e-6, "1.0e-4"},
      {1.5141e-7, 1e-10, "1.51e-7"},
      {0.001, 1e-6, "0.00100"},
      {999999.7, 0.4, "1000000"},
      {1234567, 40, "1.2346e6"},
      {99999, 4000, "1.0e5"},
      {-0.50346337, 1e-5, "-0.5035"},
      {-9.6e-4, 4e-5, "-1.0e-3"},
      {0.00012, 1e-12, "1.2000000e-4"},
      {1.0 / 3, 1e-30, "0.333333333333333"},  // 15 digits are what a double holds
      {1e300, 1e290, "1.000000000e300"},
      {1e-300, 1e-310, "1.000000000e-300"},
      // not one digit
      {9.6e-4, 6e-4, "none"},
      {0.7, 0.3, "none"},  // and not 1
      {4.0, 5.0, "none"},
      {0.4, 0.4, "none"},
      {1.0, 100.0, "none"},
      {0.0, 1e-9, "none"},
      {1.0, 0.0, "none"},
      {1.0, -1e-3, "none"},
      {1.0, infinite, "none"},
      {1.0, std::nan(""), "none"},
      {infinite, 1.0, "none"},
      {std::nan(""), 1e-9, "none"},
  };
  for (const auto& row : rows)
    BOOST_TEST(text_of(row.value, row.error) == row.text,
               row.value << " +- " << row.error << ": " << text_of(row.value, row.error));
}

BOOST_AUTO_TEST_CASE(the_uncertainty_covers_the_error_and_the_rounding_of_the_text) {
  std::size_t printed = 0;
  for (int k = 0; k < 20000; ++k) {
    // Values and errors over many decades, none of them at a round place.
    const double value = (k % 2 ? -1 : 1) * std::pow(10.0, std::fmod(k * 0.6180339887, 14.0) - 7);
    const double error = std::abs(value) * std::pow(10.0, -std::fmod(k * 0.4142135623, 16.0));
    const auto known = known_digits(value, error);
    if (!known) {
      BOOST_REQUIRE(error >= 0.05 * std::abs(value));
      continue;
    }
    ++printed;
    const double text = std::stod(known->text), relative = std::stod(known->relative),
                 absolute = std::stod(known->absolute);
    const double truth_may_be_off = error + std::abs(text - value);
    constexpr double slack = 1 - 1e-8;  // what is 1.2 to nine digits is printed as 1.2
    BOOST_REQUIRE_MESSAGE(absolute >= slack * truth_may_be_off, known->text << " from " << value << " +- " << error);
    BOOST_REQUIRE(relative * std::abs(text) >= slack * truth_may_be_off);
    BOOST_REQUIRE_MESSAGE(absolute <= 1.11 * truth_may_be_off, known->absolute << " for " << truth_may_be_off);
    BOOST_REQUIRE(relative <= 1);
    const double half_unit = relative_half_unit(known->text) * std::abs(text);
    constexpr double rounding = 1e-6;  // of half_unit itself
    BOOST_REQUIRE_MESSAGE(error <= half_unit * (1 + rounding), known->text << " from " << value << " +- " << error);
    BOOST_REQUIRE_MESSAGE(error >= 0.0999 * half_unit || count_digits(known->text) >= 15,
                          known->text << " keeps back a digit: " << value << " +- " << error);
  }
  BOOST_TEST(printed > 15000u);
}

BOOST_AUTO_TEST_CASE(significant_digits_are_counted) {
  const struct {
    const char* text;
    int digits;
  } rows[] = {{"", 0},      {"0", 0},         {"0.0741", 3}, {"-0.5035", 4}, {"1.000", 4},
              {"10.00", 4}, {"1.0000e-3", 5}, {"1e10", 1},   {"-", 0},       {"1.2345E22", 5}};
  for (const auto& row : rows) BOOST_TEST(count_digits(row.text) == row.digits, row.text);
}

// -- points -----------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(the_points_are_those_that_were_asked_for) {
  const auto points = atlas_points();
  BOOST_TEST(points.size() == 351u);
  std::set<std::string> ids;
  std::set<double> M, L;
  for (const AtlasPoint& point : points) {
    ids.insert(point.id());
    M.insert(point.M);
    L.insert(point.L);
    BOOST_TEST((point.L == 0) == (point.laws == AtlasLaws::isoviscous));
    if (const auto* cut = std::get_if<TruncatedAt>(&point.inlet)) {
      BOOST_TEST(cut->x == -4);
      BOOST_TEST(point.M >= 2);
    }
    BOOST_TEST(point.usual_tolerance() <= (point.laws == AtlasLaws::barus ? 4e-7 : 4e-10));  // for 6 and 9 digits
  }
  BOOST_TEST(ids.size() == points.size());
  BOOST_TEST(*M.begin() == 0.05);
  BOOST_TEST(*M.rbegin() == 5000);
  BOOST_TEST(*L.begin() == 0);
  BOOST_TEST(*L.rbegin() == 30);
  for (const AtlasLaws laws : {AtlasLaws::barus, AtlasLaws::roelands}) {
    const auto count = [&](bool flooded) {
      return std::count_if(points.begin(), points.end(), [&](const AtlasPoint& point) {
        return point.laws == laws && std::holds_alternative<Flooded>(point.inlet) == flooded;
      });
    };
    BOOST_TEST(count(true) == 96);
    BOOST_TEST(count(false) == 66);
  }
  for (const char* id :
       {"atlas-roelands-m20-l10-flooded", "atlas-barus-m2-l2.5-cut4", "atlas-isoviscous-m0.05-l0-flooded"})
    BOOST_TEST(ids.contains(id), id);
}

BOOST_AUTO_TEST_CASE(points_above_4_GPa_are_marked_as_numerical_tests) {
  // p_H = L sqrt(M/2pi)/alpha: 0.811 GPa at (20, 10), 4.04 GPa at (500, 10)
  const AtlasPoint light{AtlasLaws::barus, 20, 10, Flooded{}}, heavy{AtlasLaws::roelands, 500, 10, Flooded{}},
      rigid{AtlasLaws::isoviscous, 5000, 0, Flooded{}};
  EHD_CHECK(error(light.hertz_pressure_Pa(), 10 * std::sqrt(20 / (2 * M_PI)) / 2.2e-8), Tolerance::round_off(8));
  BOOST_TEST(!light.numerical_test());
  BOOST_TEST(light.title().find("numerical test") == std::string::npos);
  BOOST_TEST(heavy.numerical_test() == (heavy.hertz_pressure_Pa() > 4e9));
  BOOST_TEST(heavy.numerical_test());
  BOOST_TEST(heavy.title().find("(a numerical test: p_H = 4.1 GPa)") != std::string::npos, heavy.title());
  BOOST_TEST(!rigid.numerical_test());
  const auto row = atlas_row(heavy, record_of(heavy));
  const auto column = [](const std::string& name) {
    const auto& names = atlas_columns();
    const auto at = std::find(names.begin(), names.end(), name);
    BOOST_REQUIRE(at != names.end());
    return static_cast<std::size_t>(at - names.begin());
  };
  BOOST_TEST(row[column("numerical_test")] == "yes");
  BOOST_TEST(row[column("p_H_GPa")] == "4.055");
  const auto of_rigid = atlas_row(rigid, record_of(rigid));
  BOOST_TEST(of_rigid[column("p_H_GPa")] == "");  // M alone fixes no pressure
  BOOST_TEST(of_rigid[column("P_spike")] == "");
  BOOST_TEST(of_rigid[column("X_spike")] == "");
}

// -- case files -------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_case_file_is_read_back_with_the_same_problem_and_numbers) {
  const test::Folder folder;
  for (const AtlasPoint& point : few_points()) {
    BOOST_TEST_CONTEXT(point.id()) {
      const AtlasRecord record = record_of(point);
      const Case read = read_case(folder.write(point.id() + ".toml", case_text_of(point, record, 3)));
      BOOST_TEST(read.id == point.id());
      BOOST_TEST(read.version == 3);
      BOOST_TEST(read.title == point.title());
      const auto& contact = std::get<ContactCase>(read.body);
      const auto &moes = std::get<MoesGroups>(contact.statement),
                 wanted = std::get<MoesGroups>(point.contact().statement);
      BOOST_TEST(moes.M == wanted.M);
      BOOST_TEST(moes.L == wanted.L);
      const auto* cut = std::get_if<TruncatedAt>(&point.inlet);
      BOOST_TEST(std::holds_alternative<Flooded>(*contact.inlet) == !cut);
      if (cut) BOOST_TEST(std::get<TruncatedAt>(*contact.inlet).x == cut->x);
      const Lubricant &lubricant = *contact.lubricant, expected = *point.contact().lubricant;
      BOOST_TEST((lubricant.viscosity == expected.viscosity && lubricant.density == expected.density));
      BOOST_TEST((lubricant.alpha_per_Pa == expected.alpha_per_Pa && lubricant.z == expected.z));
      if (point.laws == AtlasLaws::roelands) BOOST_TEST(lubricant.p0_Pa == 1.96e8);
      BOOST_TEST(read.expectations.size() == (point.L == 0 ? 6u : 7u));
      for (const Expectation& one : read.expectations) {
        BOOST_TEST((one.scaling == Scaling::hertz && one.kind == ExpectationKind::computed && !one.waiting));
        const Reading truth =
            made_solution(
                {.groups = {.M = point.M, .L = point.L}, .viscosity = {}, .density = {}, .inlet = point.inlet}, 3e-11)
                .observables.at(*quantity_from(one.quantity));
        EHD_CHECK(error(one.value, truth.value),
                  Tolerance::calibrated(one.uncertainty, "the uncertainty stated covers error and rounding"));
        if (one.quantity == "film.offset") continue;  // its error is absolute
        BOOST_TEST(one.uncertainty >= 3e-11);
        BOOST_TEST(one.uncertainty <=
                   12 * 3e-11);  // rounding is less than ten times the error, and two digits are shown
        BOOST_TEST(count_digits(one.digits) >= 9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_point_without_digits_waits_for_them) {
  const test::Folder folder;
  const AtlasPoint point = few_points().back();
  Fake vague;
  vague.relative = 2 * atlas_worst_error;
  const AtlasRecord record = solve_point(point, vague.solver(), 1e-10, 30);
  BOOST_TEST(!record.has_digits());
  BOOST_TEST(vague.solves == 3);  // 1e-10, 1e-7, 1e-4
  const Case read = read_case(folder.write(point.id() + ".toml", case_text_of(point, record)));
  BOOST_REQUIRE(read.expectations.size() == 2u);
  for (const auto& one : read.expectations) BOOST_TEST(one.waiting);
  const auto row = atlas_row(point, record);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string& name = atlas_columns()[i];
    const bool of_a_value =
        name.starts_with("H_") || name.starts_with("X_") || name.starts_with("P_") || name.starts_with("rolling");
    if (of_a_value) BOOST_TEST(row[i] == "", name);
  }
}

BOOST_AUTO_TEST_CASE(both_films_must_be_known) {
  const AtlasPoint point = few_points()[4];
  for (const Quantity vague : {Quantity::film_minimum, Quantity::film_central}) {
    RegisteredSolver solver = *find_solver("reference");
    solver.solve = [&](const Problem& problem, const Request&) {
      Solution solution = made_solution(problem, 1e-11);
      solution.observables.at(vague).error = 1e-2;
      (vague == Quantity::film_minimum ? solution.record.film_minimum
                                       : solution.record.film_central) = {.discretisation = 1e-2};
      return solution;
    };
    BOOST_TEST_CONTEXT(to_string(vague)) { BOOST_TEST(!solve_point(point, solver, 1e-10, 30).has_digits()); }
  }
}

// -- one point --------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_looser_tolerance_follows_only_where_nothing_is_known) {
  const AtlasPoint point = few_points()[2];
  std::vector<double> asked;
  StopReason first = StopReason::diverged;
  RegisteredSolver solver = *find_solver("reference");
  solver.solve = [&](const Problem& problem, const Request& request) {
    asked.push_back(request.tolerance.tightest());
    if (request.tolerance.tightest() >= 1e-4) return made_solution(problem, 1e-5);
    Solution none;
    none.record.status = first;
    none.record.reason = "no film";
    return none;
  };
  AtlasRecord record = solve_point(point, solver, 1e-10, 30);
  BOOST_TEST(asked == (std::vector<double>{1e-10, 1e-10 * 1000, 1e-4}), boost::test_tools::per_element());
  BOOST_TEST(record.has_digits());
  BOOST_TEST((record.status == StopReason::tolerance_not_met));  // digits beside "diverged" would contradict it
  BOOST_TEST(record.reason == "no film");
  BOOST_TEST(record.tolerance == 1e-10);

  asked.clear();
  first = StopReason::limit_reached;
  record = solve_point(point, solver, 1e-10, 30);
  BOOST_TEST(asked == (std::vector<double>{1e-10, 1e-4}), boost::test_tools::per_element());
  BOOST_TEST((record.status == StopReason::limit_reached));

  Fake good;
  BOOST_TEST(solve_point(point, good.solver(), 1e-10, 30).has_digits());
  BOOST_TEST(good.solves == 1);
}

BOOST_AUTO_TEST_CASE(the_error_of_the_offset_is_absolute_and_of_the_others_relative) {
  const AtlasPoint point = few_points()[5];  // H_0 = -32 here: the two differ
  const AtlasRecord record = record_of(point);
  const auto &offset = record.readings.at("H_0"), &minimum = record.readings.at("H_min");
  BOOST_TEST(offset.error == 3e-11 / 7);
  EHD_CHECK(error(minimum.error, 3e-11 * minimum.value), Tolerance::round_off(2));
  std::map<std::string, double> row;
  const auto cells = atlas_row(point, record);
  for (std::size_t i = 0; i < cells.size(); ++i) row[atlas_columns()[i]] = std::strtod(cells[i].c_str(), nullptr);
  BOOST_TEST(row["H_0_error"] >= offset.error);
  BOOST_TEST(row["H_0_error"] <= 12 * offset.error);
  BOOST_TEST(row["H_min_error"] >= 3e-11);
  BOOST_TEST(row["H_min_error"] <= 12 * 3e-11);
  BOOST_TEST(row["X_spike_error"] >= record.readings.at("X_spike").error);
}

BOOST_AUTO_TEST_CASE(a_quantity_without_an_error_has_no_digits) {
  RegisteredSolver solver = *find_solver("reference");
  solver.solve = [](const Problem& problem, const Request&) {
    Solution solution = made_solution(problem, 3e-11);
    solution.observables[Quantity::rolling_force].error.reset();
    solution.observables[Quantity::pressure_exit].error = std::nan("");
    solution.record.grids.back().observed.erase(Quantity::pressure_spike);
    return solution;
  };
  const auto readings = solve_point(few_points()[4], solver, 1e-10, 30).readings;
  BOOST_TEST(readings.contains("H_min"));
  BOOST_TEST(!readings.contains("rolling_force"));
  BOOST_TEST(!readings.contains("X_exit"));
  BOOST_TEST(readings.contains("P_spike"));
  BOOST_TEST(!readings.contains("X_spike"));  // only one discretisation has seen it
}

BOOST_AUTO_TEST_CASE(a_record_is_read_back_and_a_damaged_one_is_none) {
  AtlasRecord record = record_of(few_points()[4]);
  record.solver = "fake 0123";
  record.reason = "a \"quoted\" reason\n";
  record.status = StopReason::tolerance_not_met;
  const std::string json = json_of(record);
  const auto read = record_from(json);
  BOOST_REQUIRE(read.has_value());
  BOOST_TEST(json_of(*read) == json);
  BOOST_TEST(read->reason == record.reason);
  BOOST_TEST(read->readings.at("H_0").value == record.readings.at("H_0").value);  // to the last bit
  BOOST_TEST(read->readings.at("H_0").error == record.readings.at("H_0").error);
  const auto with = [&](const std::string& before, const std::string& now) {
    std::string text = json;
    return text.replace(text.find(before), before.size(), now);
  };
  for (const std::string& damaged :
       {std::string(), std::string("{}"), std::string("[1, 2]"), json.substr(0, json.size() / 2),
        with("tolerance-not-met", "perfect"), with("\"nodes\"", "\"knots\""), with("\"schema\": 1", "\"schema\": 2"),
        with("\"tolerance\": ", "\"tolerance\": null, \"was\": "), std::string(100, '\0')})
    BOOST_TEST(!record_from(damaged).has_value(), damaged);
}

// -- the run ----------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_run_writes_a_table_and_cases_that_agree) {
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 6);
  BOOST_TEST(result.left_over.empty());
  const AtlasTable table = read_atlas_table(request.folder / "atlas.csv");
  BOOST_REQUIRE(table.rows.size() == 6u);
  for (std::size_t i = 0; i < 6; ++i) BOOST_TEST(table.rows[i].at("id") == request.points[i].id());
  BOOST_TEST(atlas_files(request.folder).size() == 6u);
  BOOST_TEST(atlas_disagreements(request.folder).empty());
  BOOST_TEST(test::read(request.folder / "digits.txt") == digits_text(table));
  BOOST_TEST(digits_text(table).find("1000") != std::string::npos);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(request.folder))
    BOOST_TEST(entry.path().string().find(".partial") == std::string::npos);
  const std::string summary = human_summary(result);
  for (const char* text : {"6 points, 6 solved now", "6 with 9 digits or more", "0 without", "1 are numerical tests"})
    BOOST_TEST(summary.find(text) != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(an_interrupted_run_goes_on_with_what_is_missing) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  request.threads = 1;
  fake.fails_at = 4;
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), std::runtime_error);
  BOOST_TEST(!std::filesystem::exists(request.folder / "atlas.csv"));
  fake.fails_at = 0;
  fake.solves = 0;
  std::size_t reused = 0, calls = 0;
  request.progress = [&](std::size_t done, std::size_t all, const AtlasRecord&, bool old) {
    BOOST_TEST(done == ++calls);
    BOOST_TEST(all == 6u);
    reused += old ? 1 : 0;
  };
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 3);
  BOOST_TEST(reused == 3u);
  BOOST_TEST(calls == 6u);
  BOOST_TEST(atlas_disagreements(request.folder).empty());

  // Once more: nothing to solve, and nothing is written.
  const std::string csv = test::read(request.folder / "atlas.csv");
  const auto written = std::filesystem::last_write_time(request.folder / "atlas.csv");
  (void)run_atlas(request_in(folder), fake.solver());
  BOOST_TEST(fake.solves == 3);
  BOOST_TEST(test::read(request.folder / "atlas.csv") == csv);
  BOOST_TEST((std::filesystem::last_write_time(request.folder / "atlas.csv") == written));
}

BOOST_AUTO_TEST_CASE(a_record_holds_until_the_question_or_the_solver_changes) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  const auto solves_of = [&](const AtlasRequest& asked, const RegisteredSolver& solver) {
    fake.solves = 0;
    (void)run_atlas(asked, solver);
    return fake.solves.load();
  };
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  BOOST_TEST(solves_of(request, fake.solver()) == 0);
  request.time_limit_s = 60;
  BOOST_TEST(solves_of(request, fake.solver()) == 0);  // none had run out of time
  request.tolerance = 1e-6;
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  request.tolerance = {};
  request.fresh = true;
  BOOST_TEST(solves_of(request, fake.solver()) == 6);
  request.fresh = false;
  // One damaged record, one that stands in another's place.
  const auto records = request.folder / ".progress";
  std::ofstream(records / (request.points[0].id() + ".json")) << "{";
  std::filesystem::copy_file(records / (request.points[4].id() + ".json"), records / (request.points[5].id() + ".json"),
                             std::filesystem::copy_options::overwrite_existing);
  BOOST_TEST(solves_of(request, fake.solver()) == 2);
  // Another solver: its solves differ in one bit.
  RegisteredSolver other = fake.solver();
  other.solve = [solve = other.solve](const Problem& problem, const Request& asked) {
    Solution solution = solve(problem, asked);
    double& film = solution.observables.at(Quantity::film_minimum).value;
    film = std::nextafter(film, 1e9);
    return solution;
  };
  BOOST_TEST(solves_of(request, other) == 6);
}

BOOST_AUTO_TEST_CASE(a_point_that_ran_out_of_time_is_solved_again_with_more) {
  const test::Folder folder;
  Fake fake;
  RegisteredSolver slow = fake.solver();
  slow.solve = [solve = slow.solve](const Problem& problem, const Request& asked) {
    Solution solution = solve(problem, asked);
    if (problem.groups.M == 1000) solution.record.status = StopReason::limit_reached;
    return solution;
  };
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, slow);
  fake.solves = 0;
  request.time_limit_s = 10;
  (void)run_atlas(request, slow);
  BOOST_TEST(fake.solves == 0);
  request.time_limit_s = 100;
  (void)run_atlas(request, slow);
  BOOST_TEST(fake.solves == 1);
}

BOOST_AUTO_TEST_CASE(only_some_points_leaves_the_rows_and_files_of_the_others) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  const auto csv = request.folder / "atlas.csv";
  const AtlasTable before = read_atlas_table(csv);
  const std::string other_file = test::read(request.folder / (request.points[0].id() + ".toml"));
  fake.relative = 3e-9;
  fake.solves = 0;
  request.only = "roelands";
  request.fresh = true;
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_TEST(fake.solves == 2);
  BOOST_TEST(result.entries.size() == 2u);
  BOOST_TEST(result.left_over.empty());
  const AtlasTable now = read_atlas_table(csv);
  BOOST_REQUIRE(now.rows.size() == 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    BOOST_TEST(now.rows[i].at("id") == before.rows[i].at("id"));
    BOOST_TEST((now.rows[i] == before.rows[i]) == (i < 4));
  }
  BOOST_TEST(test::read(request.folder / (request.points[0].id() + ".toml")) == other_file);
  BOOST_TEST(atlas_disagreements(request.folder).empty());
  // A changed number is a new version.
  BOOST_TEST(read_case(request.folder / (request.points[0].id() + ".toml")).version == 1);
  BOOST_TEST(read_case(request.folder / (request.points[4].id() + ".toml")).version == 2);
  (void)run_atlas(request, fake.solver());
  BOOST_TEST(read_case(request.folder / (request.points[4].id() + ".toml")).version == 2);

  // A table that is none is not overwritten.
  std::ofstream(csv) << "id,M\nmine,3\n";
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), CaseError);
  BOOST_TEST(test::read(csv) == "id,M\nmine,3\n");
}

BOOST_AUTO_TEST_CASE(a_case_without_a_point_is_reported_and_left) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  request.points.pop_back();
  const AtlasResult result = run_atlas(request, fake.solver());
  BOOST_REQUIRE(result.left_over.size() == 1u);
  BOOST_TEST(result.left_over.front() == few_points().back().id() + ".toml");
  BOOST_TEST(atlas_disagreements(request.folder).size() == 1u);
}

BOOST_AUTO_TEST_CASE(an_edited_file_disagrees) {
  const auto points = few_points();
  const std::string light = points[3].id() + ".toml", heavy = points[4].id() + ".toml";
  const struct {
    std::string file, before, now, said;
  } edits[] = {
      {light, "\nM = 20", "\nM = 21", "id is atlas-barus-m21-l5-cut4, not atlas-barus-m20-l5-cut4"},
      {light, "inlet = -4", "inlet = \"flooded\"", "id is"},
      {heavy, "z = 0.68", "z = 0.67", "has another lubricant"},
      {heavy, "p0_Pa = 1.96e8", "p0_Pa = 1.97e8", "has another lubricant"},
      {heavy, "value = \"2", "value = \"3", "H_min is"},
      {heavy, "uncertainty = ", "uncertainty = 0.1 # ", "the uncertainty of H_min"},
      {heavy, "scaling = \"hertz\"", "scaling = \"moes\"", "is not a computed one in Hertz units"},
      {heavy, "quantity = \"pressure.spike\"", "quantity = \"pressure.maximum\"", "P_spike is absent"},
      {heavy, "title = \"Atlas", "title = \"atlas", "is called"},
      {heavy, "version = 1", "version = one", "toml:3: "},
      {"atlas.csv", "barus,20,5,-4", "barus,20,5,flooded", "inlet is -4, not flooded"},
      {"atlas.csv", "atlas-barus-m20-l5-cut4,barus", "atlas-barus-m20-l5-cut4,roelands", "differs from the table"},
  };
  for (const auto& edit : edits) {
    BOOST_TEST_CONTEXT(edit.file << ": " << edit.before << " -> " << edit.now) {
      const test::Folder folder;
      Fake fake;
      const AtlasRequest request = request_in(folder);
      (void)run_atlas(request, fake.solver());
      replace_in(request.folder / edit.file, edit.before, edit.now);
      const auto found = atlas_disagreements(request.folder);
      BOOST_REQUIRE(found.size() == 1u);
      BOOST_TEST(found.front().find(edit.said) != std::string::npos, found.front());
    }
  }
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  std::filesystem::remove(request.folder / light);
  BOOST_TEST(atlas_disagreements(request.folder).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_table_that_is_none_is_refused_with_its_line) {
  const test::Folder folder;
  std::string header;
  for (const auto& name : atlas_columns()) header += (header.empty() ? "" : ",") + name;
  std::vector<std::string> cells(atlas_columns().size(), "1");
  cells[2] = "twenty";
  std::string row;
  for (const auto& cell : cells) row += (row.empty() ? "" : ",") + cell;
  const std::pair<std::string, std::string> rows[] = {
      {"", "has no header"},
      {"a,b\n", "t.csv:1: a,b: other columns"},
      {"# c\n" + header + "\n1,2,3\n", "t.csv:3: 1,2,3: has 3 cells"},
      {fmt::format("{}\n{}\n", header, row), "t.csv:2: M = twenty: is not a number"},
  };
  for (const auto& [text, said] : rows) {
    const auto file = folder.write("t.csv", text);
    try {
      (void)read_atlas_table(file);
      BOOST_ERROR("not refused: " << text);
    } catch (const CaseError& refused) {
      BOOST_TEST(std::string(refused.what()).find(said) != std::string::npos, refused.what());
    }
  }
  BOOST_CHECK_THROW((void)read_atlas_table(folder.path() / "absent.csv"), CaseError);
}

BOOST_AUTO_TEST_CASE(a_damaged_cell_is_refused_with_its_line_and_column) {
  const test::Folder folder;
  Fake fake;
  const AtlasRequest request = request_in(folder);
  (void)run_atlas(request, fake.solver());
  const auto csv = request.folder / "atlas.csv";
  const AtlasTable table = read_atlas_table(csv);
  BOOST_REQUIRE(!table.rows.empty());
  const struct {
    const char *column, *value, *said;
  } edits[] = {
      {"H_min", "abc", "is not a number; allowed is a positive number"},
      {"id", "-m20-l10", "is no id; allowed is letters, digits, dot, dash and underscore, beginning with a letter"},
      {"H_min", "1e400", "is out of range; allowed is a positive number"},
      {"H_cen", "nan", "is not finite; allowed is a positive number"},
      {"H_cen", "inf", "is not finite; allowed is a positive number"},
      {"H_couette", "0", "is out of range; allowed is a positive number"},
      {"H_min", "-0.1", "is out of range; allowed is a positive number"},
      {"H_min_error", "1e-9x", "is not a number; allowed is a positive number"},
      {"H_min_error", "0", "is out of range; allowed is a positive number"},
      {"H_min_error", "", "is missing; allowed is a number and its uncertainty"},
      {"H_0", "nan", "is not finite; allowed is a number"},
      {"laws", "rolands", "is unknown; allowed is isoviscous, barus, roelands"},
      {"laws", "", "is unknown; allowed is isoviscous, barus, roelands"},
      {"M", "0", "is out of range; allowed is a number from 1e-3"},
      {"M", "nan", "is not finite; allowed is a number from 1e-3"},
      {"M", "", "is missing; allowed is a number from 1e-3"},
      {"L", "-3", "is out of range; allowed is a number from 0 to 100"},
      {"inlet", "4", "is unknown; allowed is flooded"},
      {"inlet", "", "is unknown; allowed is flooded"},
      {"numerical_test", "maybe", "is unknown; allowed is yes, no"},
  };
  for (const auto& edit : edits) {
    BOOST_TEST_CONTEXT(edit.column << " = " << edit.value) {
      std::string text;
      for (const auto& name : atlas_columns()) text += (text.empty() ? "" : ",") + name;
      auto row = table.rows.back();
      BOOST_REQUIRE(!row.at(edit.column).empty());
      row[edit.column] = edit.value;
      text += "\n";
      for (const auto& name : atlas_columns()) text += (name == "id" ? "" : ",") + row.at(name);
      const auto file = folder.write("damaged.csv", text + "\n");
      try {
        (void)read_atlas_table(file);
        BOOST_ERROR("not refused");
      } catch (const CaseError& refused) {
        const std::string says = fmt::format("damaged.csv:2: {} = {}: {}", edit.column, edit.value, edit.said);
        BOOST_TEST(std::string(refused.what()).find(says) != std::string::npos, refused.what());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_the_number_of_threads) {
  std::vector<std::string> csv;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const test::Folder folder;
    Fake fake;
    AtlasRequest request = request_in(folder);
    request.points = atlas_points();
    request.threads = threads;
    (void)run_atlas(request, fake.solver());
    csv.push_back(test::read(request.folder / "atlas.csv") + test::read(request.folder / "digits.txt"));
  }
  BOOST_TEST(csv[0] == csv[1]);
  BOOST_TEST(csv[0] == csv[2]);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written_is_refused_before_anything_is_solved) {
  const test::Folder folder;
  Fake fake;
  AtlasRequest request = request_in(folder);
  request.folder = folder.write("file", "text");
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), OutputError);
  request.folder = folder.path() / "file" / "below";
  BOOST_CHECK_THROW((void)run_atlas(request, fake.solver()), OutputError);
  BOOST_TEST(fake.solves == 0);
  BOOST_TEST(test::read(folder.path() / "file") == "text");
}

// -- the command ------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(wrong_usage_of_the_command_is_one_line_and_exit_code_2) {
  const test::Folder folder;
  const std::string file = folder.write("file", "text").string();
  const std::string damaged = (folder.path() / "damaged").string();
  std::filesystem::create_directory(damaged);
  (void)folder.write("damaged/atlas.csv", "id,M\n");
  const std::vector<std::pair<std::string, std::string>> rows{
      {"--only no-such-point", "--only = no-such-point: is in no id; allowed is a part of an id like atlas-"},
      {"--output ''", "--output = : is empty"},
      {"--output " + file, "file: cannot be made"},
      {"--output " + file + "/below", "cannot be made"},
      {"--only isoviscous-m0.05 --output " + damaged, "atlas.csv:1: id,M: other columns"},
      {"--tolerance 0", "is out of range; allowed is a number, more than 0 to 1"},
      {"--tolerance 1", "--tolerance = 1: is too loose for digits; allowed is a number > 0, up to 0.0001"},
      {"--tolerance abc", "is not a number"},
      {"--threads 0", "--threads = 0: is out of range; allowed is an integer, 1 to"},
      {"--threads -1", "--threads = -1: is out of range"},
      {"--threads two", "is not an integer"},
      {"--time-limit 0", "is out of range"},
      {"--frobnicate", "frobnicate"},
  };
  for (const auto& [arguments, phrase] : rows) {
    const std::string here = arguments.find("--output") == std::string::npos ? " --output " + damaged : "";
    test::check_refused(folder, "atlas " + arguments + here, phrase);
  }
}

BOOST_AUTO_TEST_CASE(an_interrupted_command_says_what_it_leaves) {
  const test::Folder folder;
  const std::string output = (folder.path() / "atlas").string(), err = (folder.path() / "err.txt").string();
  const std::string command = fmt::format(
      "timeout -s INT 0.8 '{}' atlas --threads 1 --only roelands-m5000-l30 --output '{}' > '{}.out' 2> '{}'",
      EHD_PROGRAM, output, output, err);
  BOOST_TEST(std::system(command.c_str()) != 0);
  BOOST_TEST(test::read(err) ==
             "ehd: atlas: interrupted; the solved points are kept, and the same command goes on from there\n");
  BOOST_TEST(!std::filesystem::exists(output + "/atlas.csv"));
  BOOST_TEST(test::read(output + ".out") == "");
}

BOOST_AUTO_TEST_CASE(a_point_made_by_the_command_is_a_case_by_its_id) {
  const test::Folder folder;
  const std::string cases = folder.path().string(), id = "atlas-isoviscous-m0.2-l0-flooded";
  const std::string output = fmt::format("atlas --only {} --tolerance 1e-6 --output {}/atlas", id, cases);
  const auto made = test::ehd_run(folder, output);
  BOOST_TEST(made.exit_code == 0, made.err);
  BOOST_TEST(made.error_lines() == 1, made.err);
  BOOST_TEST(made.out.find("1 points, 1 solved now") != std::string::npos, made.out);
  const auto again = test::ehd_run(folder, output);
  BOOST_TEST(again.err == "1 of 1 points are known from an earlier run\n");
  BOOST_TEST(again.out.find("1 points, 0 solved now, 1 from records") != std::string::npos, again.out);
  BOOST_REQUIRE(::setenv("EHD_CASES", cases.c_str(), 1) == 0);
  const auto solved = test::ehd_run(folder, "solve " + id + " --tolerance 1e-2 --json -");
  const auto listed = test::ehd_run(folder, "cases --atlas");
  ::unsetenv("EHD_CASES");
  BOOST_TEST(solved.exit_code == 0, solved.err);
  BOOST_TEST(Json::parse(solved.out)["case"] == id);
  BOOST_TEST(listed.exit_code == 0, listed.err);
  BOOST_TEST(listed.out.find(id) != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
