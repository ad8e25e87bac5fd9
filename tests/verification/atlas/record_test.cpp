// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/atlas/record.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "io/case_reader.hpp"
#include "tests/check.hpp"
#include "tests/files.hpp"
#include "tests/verification/atlas/made_atlas.hpp"

using namespace ehd;
using namespace ehd::verification;

BOOST_AUTO_TEST_SUITE(atlas_record)

using namespace made_atlas;

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
        with("tolerance-not-met", "perfect"), with("\"nodes\"", "\"knots\""), with("\"schema\":1", "\"schema\":2"),
        with("\"tolerance\":", "\"tolerance\":null,\"was\":"), std::string(100, '\0')})
    BOOST_TEST(!record_from(damaged).has_value(), damaged);
}

BOOST_AUTO_TEST_SUITE_END()
