// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 6: what every mesh of elements promises, whatever was done to it.
#include "reference/hp/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/check.hpp"
#include "tests/reference/hp/meshes.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

std::vector<double> lengths(const Mesh& mesh) {
  std::vector<double> out;
  for (std::size_t e = 0; e + 1 < mesh.breakpoints.size(); ++e)
    out.push_back(mesh.breakpoints[e + 1] - mesh.breakpoints[e]);
  return out;
}

/// The largest ratio of neighbouring lengths, from element `first` on.
double largest_ratio(const Mesh& mesh, std::size_t first) {
  const auto length = lengths(mesh);
  double ratio = 1;
  for (std::size_t e = first; e + 1 < length.size(); ++e)
    ratio = std::max({ratio, length[e] / length[e + 1], length[e + 1] / length[e]});
  return ratio;
}

/// Holds for every mesh.
void check_mesh(const Mesh& mesh) {
  BOOST_REQUIRE(mesh.elements() > 0);
  BOOST_REQUIRE_EQUAL(mesh.breakpoints.size(), mesh.degrees.size() + 1);
  BOOST_TEST(mesh.breakpoints.back() == 0);
  BOOST_TEST(mesh.extent() == -mesh.breakpoints.front());
  for (const double length : lengths(mesh)) BOOST_TEST(length > 0);
  for (const int degree : mesh.degrees) BOOST_TEST(degree > 0);
}

bool never(int) { return false; }
bool always(int) { return true; }

/// Ratio 4 between neighbours, six degrees.
Mesh graded_mesh() {
  return {.inlet = -6.5, .breakpoints = {-5.46, -1.36, -0.34, -0.08, -0.02, 0}, .degrees = {4, 7, 5, 9, 3}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_mesh)

BOOST_AUTO_TEST_CASE(a_seeded_mesh_is_graded_about_inlet_and_exit) {
  int rows = 0;
  for (const double growth : {1.5, 2.0, 3.0})
    for (const double inlet : {-1.7, -4.0, -800.0, -8000.0})
      for (const double zone : {0.9, 0.07, 1e-3, 1e-5})
        for (const double length : {1.0, 1.3}) {
          const double exit = length + 0.45 * zone;
          const Mesh mesh = seeded_mesh(
              {.inlet = inlet, .exit = exit, .length = length, .inlet_zone = zone, .degree = 7, .growth = growth});
          BOOST_TEST_CONTEXT("X_a = " << inlet << ", zone " << zone << ", l = " << length << ", growth " << growth) {
            check_mesh(mesh);
            BOOST_TEST(mesh.inlet == inlet);
            EHD_CHECK(error(mesh.extent(), exit - inlet), Tolerance::round_off(1));
            BOOST_TEST(std::all_of(mesh.degrees.begin(), mesh.degrees.end(), [](int degree) { return degree == 7; }));
            const double rounded = 1 + 1e-9;
            EHD_CHECK(largest_ratio(mesh, 1), Tolerance::required(growth * rounded, "mesh.hpp: neighbours"));
            EHD_CHECK(largest_ratio(mesh, 0),
                      Tolerance::required(std::max(growth, 3.0) * rounded, "mesh.hpp: the first element"));
            const auto length_of = lengths(mesh);
            for (const double place : {-length, exit}) {
              const auto right =
                  std::lower_bound(mesh.breakpoints.begin() + 1, mesh.breakpoints.end() - 1, place - exit);
              const auto e = static_cast<std::size_t>(right - mesh.breakpoints.begin()) - 1;
              EHD_CHECK(length_of[e], Tolerance::required(growth * zone / 2, "mesh.hpp: begin with half the zone"));
            }
            const double shortest = *std::min_element(length_of.begin() + 1, length_of.end());
            EHD_CHECK(zone / 2 / shortest, Tolerance::required(growth * rounded, "nor are they finer"));
            // Sizes are those at the right end of an element, so that going left they grow by 2 - 1/growth (from the
            // exit to the middle, from -l outwards; far out by 1.5) and shrink by 1/growth (towards -l).
            const double away = std::min(std::log(2 - 1 / growth), std::log(1.5));
            const double most =
                8 + (2 * std::log(2 / zone + 2) + std::log(-inlet)) / away + std::log(1 / zone) / std::log(growth);
            EHD_CHECK(mesh.elements(), Tolerance::required(most, "geometric grading"));
          }
          ++rows;
        }
  BOOST_TEST(rows == 96);
}

BOOST_AUTO_TEST_CASE(a_finer_zone_or_a_farther_inlet_adds_elements_and_never_removes_any) {
  int last = 0, rows = 0;
  for (const double zone : {0.5, 0.1, 0.01, 1e-3, 1e-4}) {
    const int elements = seeded_mesh({.inlet = -4, .exit = 1.01, .inlet_zone = zone}).elements();
    BOOST_TEST(elements > last);
    last = elements;
    ++rows;
  }
  last = 0;
  for (const double inlet : {-4.0, -40.0, -400.0, -4000.0}) {
    const int elements = seeded_mesh({.inlet = inlet, .exit = 1.01, .inlet_zone = 0.1}).elements();
    BOOST_TEST(elements > last);
    last = elements;
    ++rows;
  }
  BOOST_TEST(rows == 9);
}

BOOST_AUTO_TEST_CASE(adaption_cuts_what_exceeds_and_nothing_else) {
  const Mesh mesh = graded_mesh();
  const Mesh same = adapted(mesh, {1, 0.2, 1, 0.99, 0}, never, 1e-9);
  BOOST_TEST(same.breakpoints == mesh.breakpoints);
  BOOST_TEST(same.degrees == mesh.degrees);
  BOOST_TEST(same.inlet == mesh.inlet);

  const Mesh halved = adapted(mesh, {1.01, 0.2, 7, 0.5, 1e9}, never, 1e-9);
  check_mesh(halved);
  const std::vector<double> expected = {-5.46, -3.41, -1.36, -0.34, -0.21, -0.08, -0.02, -0.01, 0};
  BOOST_REQUIRE_EQUAL(halved.breakpoints.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EHD_CHECK(error(halved.breakpoints[i], expected[i]), Tolerance::round_off(4));
  BOOST_TEST(halved.degrees == (std::vector<int>{4, 4, 7, 5, 5, 9, 3, 3}));

  const Mesh elsewhere = adapted(mesh, {0, 0, 7, 0, 0}, never, 1e-9, 0.3);
  EHD_CHECK(error(elsewhere.breakpoints.at(3), -0.34 + 0.3 * 0.26), Tolerance::round_off(4));
}

BOOST_AUTO_TEST_CASE(adaption_joins_pairs_once_and_never_with_a_neighbour_that_exceeds) {
  const Mesh mesh = graded_mesh();
  const Mesh joined = adapted(mesh, {0, 0, 0, 0, 0}, always, 1e-9);
  check_mesh(joined);
  BOOST_TEST(joined.breakpoints == (std::vector<double>{-5.46, -0.34, -0.02, 0}));
  BOOST_TEST(joined.degrees == (std::vector<int>{4, 5, 3}));
  // 1 | 2 may join, 2 | 3 not as 3 exceeds, 3 is cut, and 4 has no partner left.
  const Mesh mixed = adapted(mesh, {0, 0, 0, 2, 0}, always, 1e-9);
  BOOST_REQUIRE_EQUAL(mixed.elements(), 5);
  BOOST_TEST(mixed.breakpoints[1] == -0.34);
  BOOST_TEST(mixed.breakpoints[2] == -0.08);
  EHD_CHECK(error(mixed.breakpoints[3], -0.05), Tolerance::round_off(4));
  BOOST_TEST(mixed.breakpoints[4] == -0.02);
  // Asked of the left element of a pair.
  std::vector<int> asked;
  const Mesh asked_for = adapted(
      mesh, {0, 0, 0, 0, 0}, [&](int e) { return asked.push_back(e), e == 1; }, 1e-9);
  BOOST_TEST(asked == (std::vector<int>{0, 1, 3}));
  BOOST_TEST(asked_for.breakpoints == (std::vector<double>{-5.46, -1.36, -0.08, -0.02, 0}));
}

BOOST_AUTO_TEST_CASE(no_cut_makes_an_element_shorter_than_the_shortest) {
  Mesh mesh = graded_mesh();
  const double shortest = 0.03;
  int passes = 0;
  for (;; ++passes) {
    const Mesh next = adapted(mesh, std::vector<double>(mesh.degrees.size(), 2.0), never, shortest);
    check_mesh(next);
    if (next.breakpoints == mesh.breakpoints) break;
    BOOST_REQUIRE(passes < 20);
    mesh = next;
  }
  BOOST_TEST(passes == 7);  // 4.1 -> 0.032, 2^7 times
  const auto length = lengths(mesh);
  // What was short before, 0.02, stays so.
  BOOST_TEST(std::count_if(length.begin(), length.end(), [&](double l) { return l < shortest; }) == 1);
  for (const double l : length) EHD_CHECK(l, Tolerance::required(2 * shortest, "all that may be cut are cut"));
}

BOOST_AUTO_TEST_CASE(a_mesh_has_just_the_elements_that_are_asked_for) {
  const std::vector<double> excess = {1, 300, 2, 5, 0.1};
  int rows = 0;
  for (const int elements : {1, 2, 3, 4, 5, 6, 9, 40}) {
    const Mesh mesh = with_elements(graded_mesh(), excess, elements, 1e-9);
    BOOST_TEST_CONTEXT(elements << " elements") {
      check_mesh(mesh);
      BOOST_TEST(mesh.elements() == elements);
      BOOST_TEST(mesh.extent() == 5.46);
      BOOST_TEST(mesh.inlet == -6.5);
    }
    ++rows;
  }
  BOOST_TEST(rows == 8);
  BOOST_TEST(with_elements(graded_mesh(), excess, 0, 1e-9).elements() == 1);
}

BOOST_AUTO_TEST_CASE(elements_are_cut_where_the_excess_is_largest) {
  // 300 in degree 7 becomes 300/128 = 2.3 twice, below the 5; then these, 5/2^9 … and 2 before 1.
  const std::vector<double> excess = {1, 300, 2, 5, 0.1};
  BOOST_TEST(with_elements(graded_mesh(), excess, 6, 1e-9).degrees == (std::vector<int>{4, 7, 7, 5, 9, 3}));
  BOOST_TEST(with_elements(graded_mesh(), excess, 7, 1e-9).degrees == (std::vector<int>{4, 7, 7, 5, 9, 9, 3}));
  BOOST_TEST(with_elements(graded_mesh(), excess, 9, 1e-9).degrees == (std::vector<int>{4, 7, 7, 7, 7, 5, 9, 9, 3}));
  BOOST_TEST(with_elements(graded_mesh(), excess, 10, 1e-9).degrees ==
             (std::vector<int>{4, 7, 7, 7, 7, 5, 5, 9, 9, 3}));
  // Where nothing may be cut any more, fewer.
  check_mesh(with_elements(graded_mesh(), excess, 1000, 0.5));
  BOOST_TEST(with_elements(graded_mesh(), excess, 1000, 0.5).elements() == 8 + 2 + 3);  // 4.1/8, 1.02/2
}

BOOST_AUTO_TEST_CASE(elements_are_joined_where_it_costs_least) {
  // Equal elements of one degree: the pair of the two smallest goes first.
  const Mesh equal{.inlet = -4, .breakpoints = {-5, -4, -3, -2, -1, 0}, .degrees = {6, 6, 6, 6, 6}};
  const Mesh joined = with_elements(equal, {3, 2, 1e-3, 1e-4, 1}, 4, 1e-9);
  BOOST_TEST(joined.breakpoints == (std::vector<double>{-5, -4, -3, -1, 0}));
  // A long and a short element: the short one's coefficients grow by (length ratio)^degree.
  const Mesh unlike{.inlet = -4, .breakpoints = {-5, -4.99, -3, -1, 0}, .degrees = {6, 6, 6, 6}};
  const Mesh less = with_elements(unlike, {1e-6, 1e-6, 1e-6, 1e-6}, 3, 1e-9);
  BOOST_TEST(less.breakpoints == (std::vector<double>{-5, -4.99, -1, 0}));
}

BOOST_AUTO_TEST_CASE(intervals_are_shared_out_exactly) {
  int rows = 0;
  for (const int intervals : {5, 6, 9, 60, 61, 333, 1024}) {
    const Mesh mesh = with_intervals(graded_mesh(), intervals);
    check_mesh(mesh);
    BOOST_TEST(mesh.intervals() == intervals);
    const auto [least, most] = std::minmax_element(mesh.degrees.begin(), mesh.degrees.end());
    BOOST_TEST(*most - *least <= 1);
    BOOST_TEST(std::is_sorted(mesh.degrees.rbegin(), mesh.degrees.rend()));
    BOOST_TEST(mesh.breakpoints == graded_mesh().breakpoints);
    ++rows;
  }
  BOOST_TEST(rows == 7);
  const Mesh equal = with_degree(graded_mesh(), 11);
  BOOST_TEST(equal.intervals() == 55);
  BOOST_TEST(equal.breakpoints == graded_mesh().breakpoints);
}

BOOST_AUTO_TEST_CASE(a_shifted_mesh_shares_only_its_ends) {
  const Mesh mesh = graded_mesh();
  for (const double part : {0.1, 0.37, 0.9}) {
    const Mesh moved = shifted(mesh, part);
    check_mesh(moved);
    BOOST_TEST(moved.breakpoints.front() == mesh.breakpoints.front());
    BOOST_TEST(moved.degrees == mesh.degrees);
    const auto length = lengths(mesh);
    for (std::size_t i = 1; i + 1 < mesh.breakpoints.size(); ++i) {
      EHD_CHECK(error((moved.breakpoints[i] - mesh.breakpoints[i]) / length[i], part), Tolerance::round_off(4, 6));
      BOOST_TEST(std::count(mesh.breakpoints.begin(), mesh.breakpoints.end(), moved.breakpoints[i]) == 0);
    }
  }
  BOOST_TEST(shifted(mesh, 0).breakpoints == mesh.breakpoints);
}

BOOST_AUTO_TEST_CASE(a_mesh_cut_at_a_new_inlet_keeps_its_stretching_and_what_lies_behind) {
  // The exit has moved since the mesh was made: s = 1.05.
  const Mesh mesh = graded_mesh();
  const double s = 1.05, exit = mesh.inlet + s * mesh.extent();
  struct Row {
    double xi;               ///< where the new inlet is
    std::size_t first_kept;  ///< element of the old mesh that begins with it
  };
  // In the first element, with a half and an eighth of it left; with a twentieth left, which joins the second; just
  // before a breakpoint, at one, and in the last element.
  const std::vector<Row> table = {{-3.41, 0}, {-1.36 - 4.1 / 8, 0}, {-1.36 - 4.1 / 20, 1}, {-1.3601, 1}, {-0.34, 2},
                                  {-0.01, 4}, {-0.001, 4}};
  int rows = 0;
  for (const Row& row : table) {
    const double inlet = exit + s * row.xi;
    const Mesh cut = cut_at(mesh, inlet, exit);
    BOOST_TEST_CONTEXT("inlet at xi = " << row.xi) {
      check_mesh(cut);
      BOOST_TEST(cut.inlet == inlet);
      EHD_CHECK(error(cut.breakpoints.front(), row.xi), Tolerance::round_off(4, 6.5 / -row.xi));
      EHD_CHECK(error((exit - cut.inlet) / cut.extent(), s), Tolerance::round_off(8, 6.5 / -row.xi));
      BOOST_REQUIRE_EQUAL(cut.elements(), mesh.elements() - static_cast<int>(row.first_kept));
      for (std::size_t e = 0; e < cut.degrees.size(); ++e) {
        BOOST_TEST(cut.degrees[e] == mesh.degrees[row.first_kept + e]);
        BOOST_TEST(cut.breakpoints[e + 1] == mesh.breakpoints[row.first_kept + e + 1]);
      }
    }
    ++rows;
  }
  BOOST_TEST(rows == 7);
}

BOOST_AUTO_TEST_SUITE_END()
