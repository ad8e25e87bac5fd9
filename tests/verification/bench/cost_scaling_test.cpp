// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/cost_scaling.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "io/json.hpp"
#include "io/tables.hpp"
#include "tests/check.hpp"
#include "tests/sanitizer.hpp"

using namespace ehd;
using namespace ehd::verification;

namespace {

constexpr double bytes_per_interval = 60000;  // so much that a run-time library's own pages do not count

/// Takes n^1.5 of a time unit, and holds memory in proportion.
RegisteredSolver proportional() {
  RegisteredSolver solver = *find_solver("fast");
  solver.name = "proportional";
  solver.memory_bytes = [](double n) { return bytes_per_interval * n; };
  solver.solve = [](const Problem&, const Request& request) {
    const int n = *request.nodes;
    Solution solution;
    const std::vector<char> block(static_cast<std::size_t>(bytes_per_interval * n), 'x');
    solution.record.status = block[block.size() / 2] == 'x' ? StopReason::converged : StopReason::diverged;
    solution.record.cost.nodes = n;
    solution.record.cost.wall_s = 1e-6 * std::pow(n, 1.5);
    solution.record.cost.work_units = 12;
    solution.record.cost.stage_s = {{"film", 0.3e-6 * std::pow(n, 1.5)}, {"band", 1e-9}};
    return solution;
  };
  return solver;
}

ScalingRequest request_for(const RegisteredSolver& solver, int most) {
  ScalingRequest request;
  request.solvers = {{&solver, most}};
  request.contacts = {{5, 5}};
  request.repetition = {.least = 2, .least_s = 0, .most = 2};
  return request;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bench_cost_scaling)

BOOST_AUTO_TEST_CASE(time_and_exponent_are_those_of_the_solver) {
  const RegisteredSolver solver = proportional();
  const auto rows = run_scaling(request_for(solver, 2048));
  BOOST_REQUIRE(rows.size() == 4u);
  for (const ScalingRow& row : rows) {
    BOOST_CHECK((row.status == StopReason::converged));
    constexpr double operations = 10;
    EHD_CHECK(error(row.median_s().value(), 1e-6 * std::pow(row.nodes, 1.5)), Tolerance::round_off(operations));
    EHD_CHECK(error(row.per_unit().value(), *row.median_s() / (12 * row.convolution_s)),
              Tolerance::round_off(operations));
    EHD_CHECK(error(row.ns_per_n_log_n().value(), 1e3 * std::sqrt(row.nodes) / std::log2(row.nodes)),
              Tolerance::round_off(operations));
    BOOST_TEST(row.wall_s.size() == 2u);
    BOOST_TEST(row.stage_s.size() == 2u);
  }
  constexpr double sums = 1e3;
  EHD_CHECK(error(fitted_exponent(rows, "proportional", {5, 5}, 256).value(), 1.5), Tolerance::round_off(sums));
  BOOST_TEST(!fitted_exponent(rows, "proportional", {5, 5}, 1024));  // two points are no fit
  BOOST_TEST(!fitted_exponent(rows, "proportional", {20, 10}, 256));
}

BOOST_AUTO_TEST_CASE(memory_is_that_of_the_solver, *testing::needs_measurable_memory()) {
  const RegisteredSolver solver = proportional();
  const auto rows = run_scaling(request_for(solver, 2048));
  BOOST_REQUIRE(rows.size() == 4u);
  for (const ScalingRow& row : rows) {
    EHD_CHECK(error(row.peak_bytes, bytes_per_interval * row.nodes),
              Tolerance::calibrated(0.15, "up to 1 MB of the run-time library beside blocks of 15 to 120 MB"));
  }
}

BOOST_AUTO_TEST_CASE(a_convolution_takes_longer_on_more_intervals) {
  const Repetition repetition{.least = 5, .least_s = 0.01};
  const double few = convolution_s(1 << 8, repetition), many = convolution_s(1 << 16, repetition);
  BOOST_TEST(few > 0);
  // 256 times the points; a shared machine may blur that by ten, not by a hundred.
  BOOST_TEST(many > 20 * few);
  BOOST_CHECK_THROW((void)convolution_s(0, repetition), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_child_that_dies_is_a_row_that_says_so) {
  RegisteredSolver solver = proportional();
  solver.solve = [](const Problem&, const Request&) -> Solution { throw std::runtime_error("no memory left"); };
  const auto rows = run_scaling(request_for(solver, 512));
  BOOST_REQUIRE(rows.size() == 2u);
  for (const ScalingRow& row : rows) {
    BOOST_TEST(!row.status);
    BOOST_TEST(row.reason == "not measured: no memory left");
    BOOST_TEST(!row.median_s());
  }
  BOOST_TEST(human_table(rows).find("no memory left") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(sizes_beyond_memory_or_time_are_not_tried) {
  RegisteredSolver solver = proportional();
  solver.memory_bytes = [](double n) { return n > 300 ? 1e18 : 0; };
  BOOST_TEST(run_scaling(request_for(solver, 512))[1].reason == "not run: it would not fit into memory");
  solver.memory_bytes = [](double) { return 0.0; };
  solver.solve = [](const Problem&, const Request&) {
    Solution solution;
    solution.record.status = StopReason::limit_reached;
    return solution;
  };
  const auto late = run_scaling(request_for(solver, 1024));
  BOOST_CHECK((late[0].status == StopReason::limit_reached));
  BOOST_TEST(!late[1].status);
  BOOST_TEST(!late[2].status);
}

BOOST_AUTO_TEST_CASE(the_csv_has_a_column_for_each_stage) {
  const RegisteredSolver solver = proportional();
  const auto rows = run_scaling(request_for(solver, 512));
  std::istringstream csv(scaling_csv(rows));
  std::string line;
  std::getline(csv, line);
  BOOST_TEST(line.ends_with(",film_s,band_s"), line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  int lines = 0;
  for (; std::getline(csv, line); ++lines) BOOST_TEST(std::count(line.begin(), line.end(), ',') == columns);
  BOOST_TEST(lines == 2);
  const Json json = to_json(rows);
  BOOST_TEST(json[1]["nodes"] == 512);
  BOOST_TEST(json[0]["stage_s"]["film"].get<double>() > 0);
  const std::string table = human_table(rows);  // in percent
  BOOST_TEST(table.find("intervals  film ") != std::string::npos, table);
  BOOST_TEST(table.find("256          30  ") != std::string::npos, table);
}

BOOST_AUTO_TEST_CASE(uniform_grids_go_furthest_and_dense_solvers_not_at_all) {
  std::vector<const RegisteredSolver*> all;
  for (const auto& solver : solvers()) all.push_back(&solver);
  for (const auto& range : usual_scaling(all, false).solvers) {
    BOOST_TEST(range.solver->uses_fft);
    if (range.solver->name == "fast.uniform") BOOST_TEST(range.most == 1 << 20);
  }
  BOOST_TEST(usual_scaling(all, false).contacts.size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
