// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of a sequence of grids of one map, each with twice the intervals of the one before, and its error. Where
// the factors come from, and how often a stated error was too small: docs/fast-errors.md.
#pragma once

#include <vector>

namespace ehd::fast {

struct Limit {
  double value = 0;
  double error = 0;  ///< absolute; infinite for a single grid
};

/// An odd number of intervals has no half. So the coarser grids of a given N may have a little more than N/2, N/4, …
/// intervals. This moves their values to exactly N/2, N/4, …, with the second-order error between neighbouring grids:
///   f(N_e) = f_k + c (1/N_e^2 - 1/N_k^2),  c = (f_k - f_(k+1))/(1/N_k^2 - 1/N_(k+1)^2).
/// Without this 4/N of the error that the extrapolation removes was left. `values`, `intervals`: coarse to fine, as
/// many of both; the finest grid's value stays, and so does each where N_k is N_e.
[[nodiscard]] std::vector<double> on_exact_halves(std::vector<double> values, const std::vector<int>& intervals);

/// `values`: coarse to fine, f_1 .. f_m, m >= 1. Errors of the mapped scheme fall as h^2 and then h^3:
///   R_k = (4 f_k - f_(k-1))/3,  S_k = (8 R_k - R_(k-1))/7,  r_k = R_k - R_(k-1),  s_k = S_k - S_(k-1).
/// The value is f_1, R_2, then S_m. Its error:
///   m = 2: |f_2 - f_1|;  m = 3: max(1.6 |r_3|, |f_3 - f_2|/3)
///   m >= 4, the last ratio (from m = 5 the last two) r_(k-1)/r_k between 6 and 11 (8 for smooth solutions):
///     max(2 |s_m|, |r_m|/4), m = 4: |r_m|
///   else max(1.5 |r_m|, 1.5 |r_(m-1)|/6, .. over four moves, |s_m|): a spike passes through the grids.
/// The films have rules of their own from three grids on.
[[nodiscard]] Limit limit_of(const std::vector<double>& values);

/// Up to this L films converge regularly. Then the central film is as good on the map of the first solution as on
/// later ones, and its error falls regularly from grid to grid.
constexpr double mild_L = 15;

/// How well the map of a sequence fits: made from the first solution, made again, or made again until it is settled.
enum class MapFit { first, again, settled };

/// Relative error of the central film's limit, from three grids on. `central`, `minimum`: both films on the grids,
/// coarse to fine, in Hertz units. R, S, r, s as above, and r', s' those of the smallest film, all relative:
///   m = 3:  a max(|r_3|, |r'_3|), a = 0.15 for mild contacts, else 0.25, and 0.8 on a first map; beyond L = 10 at
///           least 0.25 times the last move of either film
///   m >= 4: max(b |s_m|, c |r_m|, d |s'_m|), d = max(d_0, d_1 min(1, H_cen)); beyond L = 15 on a map that is not
///           settled at least 0.1 times the last move of either film
///                                             b, c regular   b, c else   d_0   d_1
///   L <= 8                                    0.5, 0.03      1, 0.1      0.01  0.3
///   mild                                      0.5, 0.06      1, 0.15     0.01  0.3
///   else                                      1, 0.1         1, 0.3      0.05  1
/// Regular: r_(m-1)/r_m is between 6 and 11. A spike moves the smallest film more than the central one; how much of it
/// the central film feels falls with the film, since the spike moves away from X = 0.
[[nodiscard]] double central_film_error(const std::vector<double>& central, const std::vector<double>& minimum,
                                        MapFit fit, double L);

/// Relative error of the smallest film's limit, from three grids on; the last has `finest` intervals. R, S, r, s as
/// above, all relative:
///   m = 3:  max(a |r_3|, a' D), D the last move of either film
///   m >= 4: max(b |s_m|, c |r_m|, d |r_(m-1)|, e |s_(m-1)|); beyond L = 15 on other maps at least 0.75 D
///                            a, a'        intervals    b, c, d regular    b, c, d else      e
///   settled map, L <= 8      0.25, 0      up to 512    0.4, 0.04, 0.003   0.3, 0.1, 0.02    0.05
///                                         up to 1024   0.4, 0.1, 0.003    0.5, 0.9, 0.17    0.05
///                                         more         0.6, 0.16, 0.008   0.5, 0.9, 0.17    0.1
///   settled map, L <= 12     0.4, 0.25    up to 1024   as up to L <= 8, the rest as up to L <= 20
///   settled map, L <= 20     0.4, 0.25    up to 512    0.5, 0.15, 0.01    0.4, 0.15, 0.03   0.3
///                                         more         0.8, 0.3, 0.01     1, 1.5, 0.3       0.3
///   settled map, else        0.5, 0.25    any          1, 0.5, 0.01       1.5, 2, 0.4       1
///   other maps, L <= 8       0.5, 0       any          1.5, 2, 0.35       1.5, 2, 0.35      0.5
///   other maps, L <= 15      1, 0.55      any          1.5, 2, 0.35       1.5, 2, 0.35      0.5
///   other maps, else         1.6, 0.55    any          1.5, 2, 0.35       1.5, 2, 0.35      0.5
/// Regular as above. A spike that the coarse grids do not see makes a regular sequence to a wrong limit: hence e.
[[nodiscard]] double smallest_film_error(const std::vector<double>& minimum, const std::vector<double>& central,
                                         MapFit fit, double L, int finest);

/// Least relative error of a compressible oil's smallest film. Beside a narrow spike its error falls only as h, and its
/// size depends on where between the nodes the pressure falls (carried_density.hpp). So the last move may be small by
/// chance, and the two before it count with twice what the halvings since then leave: max(|s_(m-1)|, |s_(m-2)|/2). 0
/// with fewer than six grids, and where the last has fewer than 4000 intervals: there other errors are larger.
[[nodiscard]] double compressible_film_error(const std::vector<double>& minimum, int finest);

/// A single move may be small by chance: each error is at least this share of the largest relative error of the films.
[[nodiscard]] constexpr double shared(std::size_t grids) { return grids > 3 ? 0.1 : 0.8; }

}  // namespace ehd::fast
