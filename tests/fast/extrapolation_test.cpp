// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/extrapolation.hpp"

#include <cmath>
#include <random>

#include "tests/check.hpp"

using namespace ehd;
using fast::limit_of;
using fast::MapFit;
using verification::Tolerance;

namespace {

/// L + a h^2 + b h^3 + c h^4 at h = 1/4, 1/8, …
std::vector<double> sequence(std::size_t grids, double L, double a, double b, double c) {
  std::vector<double> values;
  double h = 0.5;
  for (std::size_t k = 0; k < grids; ++k) {
    h /= 2;
    values.push_back(L + h * h * (a + h * (b + h * c)));
  }
  return values;
}

/// Of grids that begin with 64 intervals.
double smallest_error(const std::vector<double>& minimum, const std::vector<double>& central, MapFit fit, double L) {
  return fast::smallest_film_error(minimum, central, fit, L, 64 << (minimum.size() - 1));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(extrapolation)

BOOST_AUTO_TEST_CASE(a_single_grid_says_nothing_about_its_error) {
  const auto limit = limit_of({0.37});
  BOOST_CHECK_EQUAL(limit.value, 0.37);
  BOOST_CHECK(std::isinf(limit.error) && limit.error > 0);
}

BOOST_AUTO_TEST_CASE(two_grids_give_the_limit_of_second_order_errors_and_their_whole_difference_as_bar) {
  const double L = 0.83;
  const auto f = sequence(2, L, -0.7, 0, 0);
  const auto limit = limit_of(f);
  EHD_CHECK(error(limit.value, L), Tolerance::round_off(4));
  EHD_CHECK(error(limit.error, std::abs(f[1] - f[0])), Tolerance::round_off(1));
}

BOOST_AUTO_TEST_CASE(values_of_grids_that_are_no_halves_are_moved_to_the_halves) {
  const auto value = [](double n) { return 0.83 - 0.7 / (n * n); };
  const std::vector<int> odd = {66, 131, 261, 521}, even = {64, 128, 256, 512};
  std::vector<double> plain, halves;
  for (const int n : odd) plain.push_back(value(n));
  for (const int n : even) halves.push_back(value(n));
  const auto moved = fast::on_exact_halves(plain, odd);
  BOOST_CHECK_EQUAL(moved.back(), plain.back());
  for (std::size_t k = 0; k < odd.size(); ++k)
    EHD_CHECK(error(moved[k], value(odd.back() / std::pow(2, odd.size() - 1 - k))), Tolerance::round_off(4));
  const auto same = fast::on_exact_halves(halves, even);
  BOOST_CHECK_EQUAL_COLLECTIONS(same.begin(), same.end(), halves.begin(), halves.end());
  BOOST_CHECK_EQUAL(fast::on_exact_halves({0.83}, {97}).front(), 0.83);
}

BOOST_AUTO_TEST_CASE(the_central_film_is_judged_by_its_own_moves_and_by_the_smallest_film_near_the_spike) {
  constexpr double central = 0.3, minimum = 0.2;  // M about 5
  const auto smooth = sequence(5, central, 0.1, 0.05, 0.02), still = sequence(5, minimum, 0, 0, 0);
  const auto true_error = std::abs(limit_of(smooth).value / central - 1);
  const double alone = fast::central_film_error(smooth, still, MapFit::settled, 5);
  BOOST_TEST(true_error <= alone);
  BOOST_TEST(alone < 300 * true_error);
  // A film of its own that jumps, and a smallest film that jumps.
  auto jumps = smooth, minimum_jumps = still;
  constexpr double jump = 1e-3;
  jumps.back() += jump;
  minimum_jumps.back() += jump;
  for (const double L : {5.0, 20.0}) {
    BOOST_TEST(fast::central_film_error(jumps, still, MapFit::settled, L) > jump / 10);
    const double tied = fast::central_film_error(smooth, minimum_jumps, MapFit::settled, L);
    BOOST_TEST(tied > (L < 15 ? 0.01 : 0.1) * jump / minimum);
    // The same smallest film beside a thin central one, whose spike is far from X = 0, says less.
    auto thin = smooth, thin_minimum = minimum_jumps;
    for (double& value : thin) value /= 1e3;
    for (double& value : thin_minimum) value /= 1e3;
    BOOST_TEST(fast::central_film_error(thin, thin_minimum, MapFit::settled, L) < tied);
  }
  // Three grids: a share of the larger move of R, most of it where a first map may not see the spike.
  const std::vector<double> three{0.31, 0.302, 0.3005}, three_minimum{0.21, 0.202, 0.2005};
  const double move = (4 * 0.2005 - 5 * 0.202 + 0.21) / 3 / 0.2005;
  const double allowed[] = {fast::central_film_error(three, three_minimum, MapFit::first, 5) / move,
                            fast::central_film_error(three, three_minimum, MapFit::again, 9) / move,
                            fast::central_film_error(three, three_minimum, MapFit::first, 20) / move};
  EHD_CHECK(error(allowed[0], 0.15), Tolerance::round_off(64, 100));
  EHD_CHECK(error(allowed[1], 0.15), Tolerance::round_off(64, 100));
  EHD_CHECK(error(allowed[2], 0.8), Tolerance::round_off(64, 100));
  // On a second map beyond L = 15, where R moves more than the films.
  const std::vector<double> jumping{0.3, 0.31, 0.305}, jumping_minimum{0.2, 0.21, 0.205};
  const double jump_of_R = (4 * 0.21 - 0.2 - (4 * 0.205 - 0.21)) / 3 / 0.205;
  EHD_CHECK(error(fast::central_film_error(jumping, jumping_minimum, MapFit::again, 20), 0.25 * jump_of_R),
            Tolerance::round_off(64, 100));
  // Beside a narrow spike at least a share of the last move of either film, where R stands still.
  const std::vector<double> standing{0.3105, 0.3025, 0.3005}, standing_minimum{0.21, 0.202, 0.2};
  for (const double L : {11.0, 20.0})
    EHD_CHECK(error(fast::central_film_error(standing, standing_minimum, MapFit::again, L), 0.25 * 0.01),
              Tolerance::round_off(64, 1000));
  // Beyond L = 15 of more grids too, on a map that is not settled: at (147, 27.8) four missed by 6 stated errors.
  const std::vector<double> four_standing{0.3425, 0.3105, 0.3025, 0.3005}, four_minimum{0.242, 0.21, 0.202, 0.2};
  for (const MapFit fit : {MapFit::first, MapFit::again})
    EHD_CHECK(error(fast::central_film_error(four_standing, four_minimum, fit, 20), 0.1 * 0.01),
              Tolerance::round_off(64, 1000));
  for (const auto& [fit, L] : {std::pair(MapFit::again, 15.0), std::pair(MapFit::settled, 20.0)})
    EHD_CHECK(fast::central_film_error(four_standing, four_minimum, fit, L), Tolerance::round_off(64, 10));
}

BOOST_AUTO_TEST_CASE(the_smallest_film_is_covered_where_a_regular_sequence_promises_a_wrong_limit) {
  // H_min on 64, 128, ... intervals, Roelands, flooded, and the limit from the high-order reference. From grid to grid
  // the moves fall by 6 to 9, as those of a smooth solution do; but the limit that they promise is wrong. Both are of
  // the scheme before carried_density.hpp. No contact up to L = 20 was seen to give such a sequence since. So the
  // first, of L = 17.747, is judged as one beyond; what `fast` states at both contacts is a claim (stated_errors.cpp).
  struct Film {
    std::vector<double> grids;
    double truth, truth_error, L;
  };
  const Film films[] = {{{8.271574179072769e-4, 8.391649535282579e-4, 8.405372863036614e-4, 8.407013195828179e-4,
                          8.407141397563982e-4, 8.407136124182169e-4},  // M = 1494.27
                         8.407204660253132e-4,
                         1.7e-8,
                         21},
                        {{5.840960367982637e-3, 5.897833488698727e-3, 5.903812314980468e-3, 5.904284401691627e-3,
                          5.904270828608804e-3},  // M = 346.248
                         5.904323873308104e-3,
                         8.7e-8,
                         27.4164}};
  for (const auto& [grids, truth, truth_error, L] : films) {
    const auto limit = limit_of(grids);
    const double off = std::abs(limit.value / truth - 1);
    EHD_CHECK(off + truth_error, Tolerance::discretisation(smallest_error(grids, {}, fast::MapFit::settled, L), 1));
    BOOST_TEST(limit.error < off * truth);  // else the sequence shows nothing
  }
}

BOOST_AUTO_TEST_CASE(the_error_of_the_smallest_film_follows_its_moves_and_the_map) {
  constexpr double mild = 5, stiff = 25;
  // Three grids: a share of the last move of R, more of it on a first map.
  const std::vector<double> three{0.2, 0.21, 0.205};
  const double move = std::abs((4 * 0.205 - 0.21) / 3 - (4 * 0.21 - 0.2) / 3) / 0.205;
  EHD_CHECK(error(smallest_error(three, {}, MapFit::settled, mild), 0.25 * move), Tolerance::round_off(64));
  for (const double L : {12.0, 20.0})
    EHD_CHECK(error(smallest_error(three, {}, MapFit::settled, L), 0.4 * move), Tolerance::round_off(64));
  EHD_CHECK(error(smallest_error(three, {}, MapFit::settled, stiff), 0.5 * move), Tolerance::round_off(64));
  EHD_CHECK(error(smallest_error(three, {}, MapFit::again, mild), 0.5 * move), Tolerance::round_off(64));
  EHD_CHECK(error(smallest_error(three, {}, MapFit::first, stiff), 1.6 * move), Tolerance::round_off(64, 100));
  // Beside a narrow spike the last move of either film counts too, where R stands still.
  const std::vector<double> standing{0.2105, 0.2025, 0.2005}, central{0.31, 0.304, 0.3};
  EHD_CHECK(error(smallest_error(standing, {}, MapFit::first, 12), 0.55 * 0.002 / 0.2005),
            Tolerance::round_off(64, 1000));
  EHD_CHECK(error(smallest_error(standing, central, MapFit::first, 12), 0.55 * 0.004 / 0.3),
            Tolerance::round_off(64, 1000));
  for (const double L : {12.0, stiff})
    EHD_CHECK(error(smallest_error(standing, central, MapFit::settled, L), 0.25 * 0.004 / 0.3),
              Tolerance::round_off(64, 1000));
  // Beyond L = 15 of more grids too: at (4982, 23.5) four missed by 3.8 stated errors.
  const std::vector<double> four_standing{0.2425, 0.2105, 0.2025, 0.2005}, four_central{0.31, 0.304, 0.3, 0.299};
  for (const int finest : {512, 2048})
    EHD_CHECK(error(fast::smallest_film_error(four_standing, four_central, MapFit::again, stiff, finest),
                    0.75 * 0.002 / 0.2005),
              Tolerance::round_off(64, 1000));
  for (const auto& [fit, L] : {std::pair(MapFit::again, 15.0), std::pair(MapFit::settled, stiff)})
    EHD_CHECK(smallest_error(four_standing, four_central, fit, L), Tolerance::round_off(64, 10));
  // More grids: the error covers a smooth sequence, and a jump of the last grid.
  const auto smooth = sequence(6, 0.2, 0.1, 0.05, 0.02);
  const double true_error = std::abs(limit_of(smooth).value / 0.2 - 1);
  constexpr double jump = 1e-4;
  auto jumps = smooth;
  jumps.back() += jump;
  for (const double L : {mild, stiff}) {
    const double settled = smallest_error(smooth, {}, MapFit::settled, L);
    BOOST_TEST(true_error <= settled);
    BOOST_TEST(settled < smallest_error(smooth, {}, MapFit::again, L));
    BOOST_TEST(smallest_error(jumps, {}, MapFit::settled, L) > jump / 0.2 / 2);
  }
  BOOST_TEST(smallest_error(smooth, {}, MapFit::settled, mild) < smallest_error(smooth, {}, MapFit::settled, stiff));
}

// The last move is 0 here, and says nothing of an error that falls as h.
BOOST_AUTO_TEST_CASE(the_smallest_film_of_a_compressible_oil_is_at_least_as_wrong_as_its_older_moves_say) {
  const auto R = [](const std::vector<double>& f, std::size_t k) { return (4 * f[k] - f[k - 1]) / 3; };
  const auto S = [&](const std::vector<double>& f, std::size_t k) { return (8 * R(f, k) - R(f, k - 1)) / 7; };
  for (const double kink : {1e-4, -3e-4}) {
    for (const std::size_t at : {2U, 3U}) {
      std::vector<double> six(6, 0.2);
      for (std::size_t k = 0; k <= at; ++k) six[k] += kink;
      const double before = std::abs(S(six, 4) - S(six, 3)) / 0.2, first = std::abs(S(six, 3) - S(six, 2)) / 0.2;
      BOOST_TEST(std::max(before, first) > 0);
      EHD_CHECK(error(fast::compressible_film_error(six, 4096), std::max(before, first / 2)),
                Tolerance::round_off(64, 1000));
      BOOST_TEST(fast::compressible_film_error(six, 2048) == 0);
      six.erase(six.begin());
      BOOST_TEST(fast::compressible_film_error(six, 4096) == 0);
    }
  }
}

// Moves that are no eighths of each other, as coarse grids have them. On 1000 intervals they may tell of a spike.
BOOST_AUTO_TEST_CASE(irregular_moves_of_the_smallest_film_count_less_up_to_512_intervals) {
  const std::vector<double> four{0.2, 0.21, 0.207, 0.2065};
  const auto R = [&](std::size_t k) { return (4 * four[k] - four[k - 1]) / 3; };
  const double move = std::abs(R(3) - R(2)) / four[3],
               S_move = std::abs(8 * (R(3) - R(2)) - (R(2) - R(1))) / 7 / four[3];
  const auto on = [&](double L, int finest) { return fast::smallest_film_error(four, {}, MapFit::settled, L, finest); };
  EHD_CHECK(error(on(5, 512), std::max(0.3 * S_move, 0.1 * move)), Tolerance::round_off(64, 100));
  BOOST_TEST(on(12, 512) == on(5, 512));
  BOOST_TEST(on(12, 1024) == on(5, 1024));
  for (const double L : {12.1, 20.0}) {
    EHD_CHECK(error(on(L, 512), std::max(0.4 * S_move, 0.15 * move)), Tolerance::round_off(64, 100));
    BOOST_TEST(on(L, 1024) == on(20, 1024));
  }
  BOOST_TEST(on(12, 2048) == on(20, 2048));
  for (const double L : {5.0, 20.0}) BOOST_TEST(on(L, 512) < on(L, 513));
  BOOST_TEST(on(20.1, 512) == on(20.1, 513));
}

// With a thirtieth of a regular move, 30 of 1,226 central films beyond L = 15 missed, by up to 5.6.
BOOST_AUTO_TEST_CASE(the_central_film_states_a_tenth_of_a_regular_move_beyond_L_15_and_more_of_an_irregular_one) {
  const auto last_moves = [](const std::vector<double>& f) {
    const auto R = [&](std::size_t k) { return (4 * f[k] - f[k - 1]) / 3; };
    return std::pair(std::abs(R(3) - R(2)) / f[3], std::abs(8 * (R(3) - R(2)) - (R(2) - R(1))) / 7 / f[3]);
  };
  const std::vector<double> regular = sequence(4, 0.02, 0.01, 0.001, 0), irregular{0.2, 0.21, 0.207, 0.2065};
  EHD_CHECK(error(fast::central_film_error(regular, regular, MapFit::settled, 20), 0.1 * last_moves(regular).first),
            Tolerance::round_off(64, 1000));
  const auto [R_move, S_move] = last_moves(irregular);
  EHD_CHECK(error(fast::central_film_error(irregular, irregular, MapFit::settled, 20), std::max(S_move, 0.3 * R_move)),
            Tolerance::round_off(64, 100));
  // A tie to the smallest film: a twentieth of its move, or all of it for thick films.
  const std::vector<double> still{0.1, 0.1, 0.1, 0.1};
  EHD_CHECK(error(fast::central_film_error(still, irregular, MapFit::settled, 20), 0.1 * S_move),
            Tolerance::round_off(64, 100));
  const std::vector<double> thin{0.01, 0.01, 0.01, 0.01};
  EHD_CHECK(error(fast::central_film_error(thin, irregular, MapFit::settled, 20), 0.05 * S_move),
            Tolerance::round_off(64, 100));
}

// S may stand still by chance: at (38, 14.2) the central film was 4.9 stated errors off with a seventieth of the move.
BOOST_AUTO_TEST_CASE(a_share_of_the_regular_last_move_of_the_central_film_is_stated) {
  const std::vector<double> f = sequence(4, 0.02, 0.01, 0.001, 0);
  const double move = std::abs((4 * f[3] - f[2]) / 3 - (4 * f[2] - f[1]) / 3) / f[3];
  for (const auto& [L, share] : {std::pair(8.0, 0.03), std::pair(8.1, 0.06), std::pair(15.0, 0.06)})
    EHD_CHECK(error(fast::central_film_error(f, f, MapFit::settled, L), share * move), Tolerance::round_off(64, 1000));
}

BOOST_AUTO_TEST_CASE(the_central_film_states_the_whole_move_of_S_where_its_moves_are_irregular) {
  const std::vector<double> f{0.2, 0.21, 0.207, 0.2065};
  const auto R = [&](std::size_t k) { return (4 * f[k] - f[k - 1]) / 3; };
  const double S_move = std::abs(8 * (R(3) - R(2)) - (R(2) - R(1))) / 7 / f[3];
  for (const double L : {5.0, 12.0, 20.0})
    EHD_CHECK(error(fast::central_film_error(f, f, MapFit::settled, L), S_move), Tolerance::round_off(64, 100));
}

BOOST_AUTO_TEST_CASE(from_three_grids_on_second_and_third_order_errors_are_gone) {
  int rows = 0;
  for (std::size_t grids = 3; grids <= 8; ++grids) {
    for (const auto& [a, b] : {std::pair{0.9, 0.4}, {0.9, -0.4}, {-0.3, 1.1}, {0.7, 0.0}}) {
      BOOST_TEST_CONTEXT(grids << " grids, a = " << a << ", b = " << b) {
        constexpr double L = 0.83;
        const auto limit = limit_of(sequence(grids, L, a, b, 0));
        EHD_CHECK(std::abs(limit.value - L), Tolerance::round_off(8));
        // The reported error covers the true one, and is smaller than the error of the finest grid.
        const double finest = std::abs(sequence(grids, L, a, b, 0).back() - L);
        EHD_CHECK(std::abs(limit.value - L), Tolerance::discretisation(limit.error + 1e-15, 1));
        if (b != 0) BOOST_CHECK_GT(limit.error, 0);
        if (grids >= 5)
          EHD_CHECK(limit.error, Tolerance::required(finest, "a bar shorter than the finest grid's error"));
        ++rows;
      }
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 24);
}

BOOST_AUTO_TEST_CASE(fourth_order_errors_are_covered_from_three_grids_on) {
  // With two grids a h^2 and b h^3 of opposite signs may cancel in the only difference there is (.3 in 100 of these
  // draws); for that, `shared` holds one film against the other.
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int rows = 0;
  double worst = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double second = uniform(random), a = 0.7 * second + std::copysign(0.3, second), b = uniform(random),
                 c = uniform(random);
    for (std::size_t grids = 3; grids <= 8; ++grids) {
      constexpr double L = 1.7;
      const auto limit = limit_of(sequence(grids, L, a, b, c));
      worst = std::max(worst, std::abs(limit.value - L) / limit.error);
      ++rows;
    }
  }
  EHD_CHECK(worst, Tolerance::required(1, "error over bar"));
  BOOST_REQUIRE_EQUAL(rows, 12000);
}

BOOST_AUTO_TEST_CASE(values_that_jump_about_keep_a_bar_as_long_as_their_jumps) {
  int rows = 0;
  for (std::size_t grids = 2; grids <= 8; ++grids) {
    BOOST_TEST_CONTEXT(grids << " grids") {
      constexpr double L = 0.61, jump = 2e-4;
      std::vector<double> f;
      for (std::size_t k = 0; k < grids; ++k) f.push_back(L + (k % 2 ? jump : -jump));
      const auto limit = limit_of(f);
      BOOST_CHECK_GE(limit.error, 2 * jump * (1 - 1e-9));
      EHD_CHECK(std::abs(limit.value - L), Tolerance::discretisation(limit.error, 1));
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 7);
}

BOOST_AUTO_TEST_CASE(a_small_last_move_by_chance_is_not_believed) {
  // f_m is such that R_m = R_(m-1): the last move of the extrapolated values vanishes, those before it do not.
  int rows = 0;
  for (std::size_t grids = 3; grids <= 7; ++grids) {
    BOOST_TEST_CONTEXT(grids << " grids") {
      constexpr double L = 0.83;
      auto f = sequence(grids, L, 0.9, 0.8, 0);
      const std::size_t m = grids - 1;
      const double before = (4 * f[m - 1] - f[m - 2]) / 3;
      f[m] = (3 * before + f[m - 1]) / 4;
      const auto limit = limit_of(f);
      if (grids == 3) {  // no earlier move: the error is a share of the plain values' move
        EHD_CHECK(std::abs(f[m] - f[m - 1]) / 20, Tolerance::discretisation(limit.error, 1 + 1e-12));
      } else {
        EHD_CHECK(std::abs(limit.value - L), Tolerance::discretisation(limit.error, 1));
        // 1.5 times a sixth of the move before.
        const double earlier = std::abs(before - (4 * f[m - 2] - f[m - 3]) / 3);
        EHD_CHECK(earlier / 4, Tolerance::discretisation(limit.error, 1 + 1e-12));
      }
      ++rows;
    }
  }
  BOOST_REQUIRE_EQUAL(rows, 5);
}

BOOST_AUTO_TEST_CASE(one_ratio_near_eight_by_chance_is_not_enough) {
  // r_3/r_4 = 8 with four grids, and r_4/r_5 = 8 after an irregular r_3/r_4 with five: the bar stays at |r_m| and above
  // a sixth of the moves before.
  const auto from_moves = [](const std::vector<double>& moves) {
    std::vector<double> f{1.0, 1.02};
    double R = (4 * f[1] - f[0]) / 3;
    for (const double move : moves) {
      R += move;
      f.push_back((3 * R + f.back()) / 4);
    }
    return limit_of(f);
  };
  BOOST_CHECK_GE(from_moves({8e-4, 1e-4}).error, 1e-4 * (1 - 1e-9));
  BOOST_CHECK_GE(from_moves({9e-3, 8e-4, 1e-4}).error, 1.5e-4 * (1 - 1e-9));
  EHD_CHECK(from_moves({6.4e-3, 8e-4, 1e-4}).error, Tolerance::required(0.25e-4 * (1 + 1e-9), "|r_m|/4 where regular"));
}

BOOST_AUTO_TEST_SUITE_END()
