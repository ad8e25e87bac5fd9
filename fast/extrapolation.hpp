// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of a sequence of grids of one map, each with twice the intervals of the one before.
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
/// Calibrated on 464 problems (16 M of 0.05..5000, 8 L of 0..30, Roelands compressible and Barus, cut and flooded),
/// grids of 64 to 8192, truth from the reference. The films have rules of their own from three grids on.
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
/// Calibrated on 1280 problems (a third each of M = 0.2..5, L = 15..30; M = 0.5..1000, L = 0..20; M = 0.05..5000,
/// L = 0..30; Roelands with random constants, Barus; flooded and cut), climbing to tolerances of 1e-4..1e-7, truth from
/// the reference: 99.8 % of the stated errors hold for mild contacts and 99.3 % for the others, at a median of 20 to 35
/// times the true ones. With three grids the median is up to 160 times: a = 0.04 failed at (500, 15), Barus, flooded,
/// where the true error was 1.5 times the stated one. On first maps beyond L = 15, a = 0.15 missed at 80 of 1259 films
/// stated to 1e-3 or better, a = 0.8 at 6 of 1234. The last moves were added later, from 4000 contacts
/// (M = 0.2..5000, L = 8..30, Roelands compressible and Barus, three in four flooded) at seven tolerances of
/// 1e-2..5e-4: beyond L = 15 three grids missed at 98 of 8164 central films without them, at 5 with them.
/// At first they counted from L = 12 on. Between 10 and 12 three grids then missed at 16 of 2255 central films; now
/// they miss at none.
/// The rows of four grids and more came last, after carried_density.hpp. They come from 4,800 contacts (M of
/// 0.05..5000, L of 0..30, both laws, flooded and cut, half on first and half on settled maps); the last grid of a
/// sequence is the truth. Before, all mild contacts had b, c = 0.25, 0.1; 0.5, 0.4, and the others 0.5, 0.15; 1, 1. At
/// 4,500 other mild contacts 27 of 18,241 errors are too small, at most 4.2 times (before: 29 of 20,139, 4.5 times).
/// The median is 27 times the true error (42). 1e-6 takes .83 of the intervals over the whole box, and .98 where M is
/// above 50 and L above 6. Beyond L = 15, at 600 others, 6 of 3,132 are too small, at most 3.0 times (before: 8 of
/// 3,150, 2.0 times), at a median of 38 (54) and on .96 of the intervals. The c of irregular moves seldom decides:
/// there |s_m| is at least 0.28 |r_m|. The 0.1 of the last move came with the second maps of requests for 1e-3 (H_min)
/// and 1e-4 (H_cen): without it 10 errors of 5,500 contacts (L = 0..30) were too small, by up to 6.1. With it one of
/// 4,900 others is, by 1.1.
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
/// Calibrated on 1220 problems drawn as those of the central film and tested on 1197 of another seed, climbing on
/// settled maps to tolerances of 1e-3..1e-6: 4763 of 4769 and 4668 of 4678 stated errors hold, all up to L = 8, at a
/// median of 65, 75, 125 and 190 times the true ones. With a' = 0.5 and the own move alone, three grids missed beyond L
/// = 15 at 69 of 8164 films of the last study above; now at none. The 0.25 of settled maps came last, from 4100
/// contacts (eight boxes of M and L, both laws) at twelve tolerances of 1e-2..1e-4. Without it three grids missed at 56
/// of 337 smallest films asked to 1e-4 or 2e-4 between L = 8 and 15 (Barus, M = 700..2800: 8e-5 stated, 7e-4 off). With
/// it they miss at none, and 60 of the other 281 need one more grid. Four and five grids miss at 22 of 18362 smallest
/// films of this study (Roelands, L > 25), at most by a factor of 1.43. Of 3700 other contacts from the same boxes,
/// 88,000 errors, six of the central film are exceeded, at most by a factor of 1.36, and none of the smallest.
/// The rows up to 512 and 1024 intervals came after that: from 1105 contacts up to L = 15 (M of 0.05..5000, both laws
/// with random constants, flooded and cut), tested on 1522 others at five tolerances of 2.9e-4..1e-6. 21 of 7447 errors
/// are too small, at most 2 times; with the last row everywhere 18 of 7445 were. The median is 8 to 24 times the true
/// error up to L = 8 and 16 to 49 times up to L = 15, at tolerances down to 1e-5; before, 29 to 82 times. At 1e-4 the
/// grids have a quarter fewer intervals.
/// The rows up to L = 12 and L = 20 came with carried_density.hpp: 4200 contacts up to L = 30
/// (boxes and laws as before), six tolerances of 2.9e-4..1e-6. Up to L = 20, 10 of 17,785 errors are too small, at
/// most 1.82 times, and the median is 7 to 30 times the true error down to 1e-5; beyond, 8 of 6,003, at most 1.26
/// times. With the rows for smaller L, 1e-5 takes half to two thirds of the intervals.
/// The 0.75 D came last. Without it 23 of 2,300 errors of four and five grids of 700 contacts (L = 15..30, asked for
/// 5e-3..3e-4) were too small, by up to 3.8. With 0.3 D, up to 1024 intervals, 23 of 4,900 contacts asked for 1e-3 to
/// 4e-4 (H_min) and 1e-4 to 5e-5 (H_cen) missed, by up to 2.4. With 0.75 D none of 4,900 others does.
[[nodiscard]] double smallest_film_error(const std::vector<double>& minimum, const std::vector<double>& central,
                                         MapFit fit, double L, int finest);

/// A single move may be small by chance: each error is at least this share of the largest relative error of the films.
[[nodiscard]] constexpr double shared(std::size_t grids) { return grids > 3 ? 0.1 : 0.8; }

}  // namespace ehd::fast
