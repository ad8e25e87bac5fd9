// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of a sequence of grids of one map, each with twice the intervals of the one before.
#pragma once

#include <vector>

namespace ehd::fast {

struct Limit {
  double value = 0;
  double error = 0;  ///< absolute; infinite for a single grid
};

/// `values`: coarse to fine, f_1 .. f_m, m >= 1. Errors of the mapped scheme fall as h^2 and then h^3:
///   R_k = (4 f_k - f_(k-1))/3,  S_k = (8 R_k - R_(k-1))/7,  r_k = R_k - R_(k-1).
/// The value is f_1, R_2, then S_m. Its error:
///   m = 2: |f_2 - f_1|;  m = 3: max(1.6 |r_3|, |f_3 - f_2|/3)
///   m >= 4, the last ratio (from m = 5 the last two) r_(k-1)/r_k between 6 and 11 (8 for smooth solutions):
///     max(2 |S_m - S_(m-1)|, |r_m|/4), m = 4: |r_m|
///   else max(1.5 |r_m|, 1.5 |r_(m-1)|/6, .. over four moves, |S_m - S_(m-1)|): a spike passes through the grids.
/// `spike`: a pressure spike moves the quantity. From m = 4 on it then counts as irregular, with 2 for 1.5: grids that
/// do not see the spike agree in a regular way on a wrong limit. Calibrated on 464 problems (16 M of 0.05..5000, 8 L of
/// 0..30, Roelands compressible and Barus, cut and flooded), grids of 64 to 8192, truth from the reference: with what
/// `shared` adds it covers 98.5 % .. 100 % of the errors of the smallest film and 99.5 % of the central film's, at a
/// median of 5 to 400 times the true one. `spike` was calibrated on 64 problems (29 of M = 0.05..5000, L = 0..30, 35 of
/// M = 20..5000, L = 8..30, drawn at random), all grids of 8 solves each to tolerances of 1e-2..1e-5 and on 8192
/// intervals: of 1789 stated errors of the smallest film 1789 hold, at a median of 24 times the true one; without
/// `spike` 1773 of 1780, at 18 times. On 36 other problems of the second kind 1038 of 1039 hold. The nodes that
/// tolerances need grow by 0 % at 1e-3 and 27 % at 1e-4.
[[nodiscard]] Limit limit_of(const std::vector<double>& values, bool spike = false);

/// Up to this L the central film is as good on the map of the first solution as on later ones, and its error falls
/// regularly from grid to grid.
constexpr double mild_for_central_film = 15;

/// Relative error of the central film's limit, from three grids on. `central`, `minimum`: both films on the grids,
/// coarse to fine, in Hertz units; `mild`: L is at most mild_for_central_film. R, S, r as above, s = S_m - S_(m-1), and
/// r', s' those of the smallest film, all relative:
///   m = 3:  0.15 max(|r_3|, |r'_3|)
///   m >= 4: max(b |s|, c |r_m|, d |s'|), d = max(d_0, d_1 min(1, H_cen))
///                                             b, c regular   b, c else   d_0   d_1
///   mild                                      0.25, 0.015    0.5, 0.4    0.01  0.3
///   else                                      0.5, 0.03      1, 3        0.03  2
/// Regular: r_(m-1)/r_m is between 6 and 11. A spike moves the smallest film more than the central one; how much of it
/// the central film feels falls with the film, since the spike moves away from X = 0.
/// Calibrated on 1280 problems (a third each of M = 0.2..5, L = 15..30; M = 0.5..1000, L = 0..20; M = 0.05..5000,
/// L = 0..30; Roelands with random constants, Barus; flooded and cut), climbing to tolerances of 1e-4..1e-7, truth from
/// the reference: 99.8 % of the stated errors hold for mild contacts and 99.3 % for the others, at a median of 20 to 35
/// times the true ones; of three grids up to 160 times, since 0.04 left (500, 15), Barus, flooded, 1.5 errors off.
[[nodiscard]] double central_film_error(const std::vector<double>& central, const std::vector<double>& minimum,
                                        bool mild);

/// A single move may be small by chance: each error is at least this share of the largest relative error of the films.
[[nodiscard]] constexpr double shared(std::size_t grids) { return grids > 3 ? 0.1 : 0.8; }

}  // namespace ehd::fast
