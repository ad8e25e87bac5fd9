// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/moved_nodes.hpp"

#include <cmath>
#include <complex>

#include "fast/harmonic_grids.hpp"
#include "tests/check.hpp"
#include "tests/fast/problems.hpp"

using namespace ehd;
using fast::Care;
using fast::Harmonic;
using fast::HarmonicGrids;
using verification::Tolerance;

BOOST_AUTO_TEST_SUITE(moved_nodes)

namespace {

constexpr double linear_residual = 1e-10;
const Request on_four_grids{.tolerance = {}, .nodes = 512};

/// H_01 of a unit load at rest, and the first term of its lag.
struct Offsets {
  double rest = 0, lag = 0;
};

/// Null: nodes stay.
Offsets offsets_of(Harmonic& harmonic, const fast::MovedNodes* moved) {
  const auto rest = harmonic.of_load(0.0, linear_residual, moved);
  return {.rest = rest.u.offset, .lag = harmonic.of_slow_load(rest, linear_residual, moved).u.offset};
}
Offsets with_fixed_nodes(Harmonic& harmonic) { return offsets_of(harmonic, nullptr); }
Offsets with_moved_nodes(HarmonicGrids& grids, std::size_t k) { return offsets_of(grids[k], &grids.moved(k)); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_shift_makes_the_sum_smallest) {
  const Array u{{1.0, 2.0, -6.0, 0.5}}, w{{0.0, 0.0, 3.0, 0.0}};
  BOOST_TEST(fast::shift_with_spike(u, w) == 2.0);
  const Eigen::ArrayXcd turned = std::complex<double>(0, 1) * w.cast<std::complex<double>>();
  const auto m = fast::shift_with_spike<std::complex<double>>(u.cast<std::complex<double>>(), turned);
  EHD_CHECK(std::abs(m - std::complex<double>(0, -2)), Tolerance::round_off(4));
}

// kappa_0 and the lag of the certified solver, stated to 1e-9 (ehd response, M = 10, L = 21).
BOOST_AUTO_TEST_CASE(beside_a_narrow_spike_derivatives_converge_as_h2_only_with_nodes_that_follow_it) {
  constexpr double kappa_0 = 4.0963496, lag = 0.076954122;
  const Problem problem = roelands_problem(10, 21, Flooded{});
  fast::Workspace workspace;
  HarmonicGrids grids(problem, on_four_grids, linear_residual, Care::full, workspace);
  BOOST_REQUIRE(grids.climb());
  BOOST_REQUIRE_EQUAL(grids.size(), 4);  // 64, 128, 256, 512
  Offsets before;
  double fixed = 0;  // the largest error of the lag on the last two grids
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const Offsets found = with_moved_nodes(grids, k);
    const Offsets error{.rest = -1 / found.rest / kappa_0 - 1, .lag = found.lag / lag - 1};
    if (k > 1) {
      fixed = std::max(fixed, std::abs(with_fixed_nodes(grids[k]).lag / lag - 1));
      BOOST_TEST_CONTEXT("intervals " << grids[k].intervals()) {
        EHD_CHECK(std::abs(std::log2(std::abs(before.rest / error.rest)) - 2), Tolerance::asymptotic(0.1, "h^2"));
        EHD_CHECK(std::abs(std::log2(std::abs(before.lag / error.lag)) - 2), Tolerance::asymptotic(0.1, "h^2"));
      }
    }
    before = error;
  }
  BOOST_TEST(fixed > 5 * std::abs(before.lag));  // else the test shows nothing
}

// The answer to moved nodes must be known well enough. Where 0.9 of its drive is left, the order of the lag is 2.9
// here.
BOOST_AUTO_TEST_CASE(beside_a_spike_narrower_than_a_cell_moves_fall_by_four) {
  const Problem problem = roelands_problem(200, 20, Flooded{});
  fast::Workspace workspace;
  HarmonicGrids grids(problem, {.tolerance = {}, .nodes = 4096}, linear_residual, Care::full, workspace);
  BOOST_REQUIRE(grids.climb());
  BOOST_REQUIRE_EQUAL(grids.size(), 7);  // 64 to 4096
  Offsets found[3];
  for (std::size_t k = 0; k < 3; ++k) found[k] = with_moved_nodes(grids, grids.size() - 3 + k);
  const auto order = [&](double Offsets::*of) {
    return std::log2((found[1].*of - found[0].*of) / (found[2].*of - found[1].*of));
  };
  EHD_CHECK(std::abs(order(&Offsets::rest) - 2), Tolerance::asymptotic(0.1, "h^2"));
  EHD_CHECK(std::abs(order(&Offsets::lag) - 2), Tolerance::asymptotic(0.1, "h^2"));
}

// Exact derivatives do not depend on how the nodes move. Where the spike is wide, discrete ones do by h^2.
BOOST_AUTO_TEST_CASE(where_the_spike_is_wide_moved_nodes_change_a_number_by_h2) {
  for (const bool flooded : {false, true}) {
    BOOST_TEST_CONTEXT((flooded ? "flooded" : "cut")) {
      const Problem problem = roelands_problem(5, 5, flooded ? Inlet{Flooded{}} : Inlet{TruncatedAt{-4}});
      fast::Workspace workspace;
      HarmonicGrids grids(problem, {.tolerance = {}, .nodes = 2048}, linear_residual, Care::full, workspace);
      BOOST_REQUIRE(grids.climb());
      BOOST_REQUIRE_EQUAL(grids.size(), 6);  // 64 to 2048
      Offsets before;
      for (const std::size_t k : {4u, 5u}) {
        const Offsets moved = with_moved_nodes(grids, k), fixed = with_fixed_nodes(grids[k]);
        const Offsets change{.rest = moved.rest / fixed.rest - 1, .lag = moved.lag / fixed.lag - 1};
        if (k > 4) {
          const auto of_a_change = Tolerance::asymptotic(0.1, "h^2");
          EHD_CHECK(std::abs(std::log2(before.rest / change.rest) - 2), of_a_change);
          EHD_CHECK(std::abs(std::log2(before.lag / change.lag) - 2), of_a_change);
        }
        before = change;
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
